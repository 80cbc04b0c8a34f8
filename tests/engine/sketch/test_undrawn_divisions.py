"""Steps that lie behind what a view shows, on sheets without hidden lines."""

import pytest
from sketch_checks import GRID, check, drawn

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.modelling import box, cut, cylinder, fuse


@pytest.mark.parametrize("roles", [(Role.FRONT, Role.TOP), (Role.FRONT, Role.TOP, Role.RIGHT)])
def test_a_round_step_behind_a_wider_one_is_round(roles: tuple[Role, ...]) -> None:
    truth = cylinder(Axis.Z, (30, 30), 30, 20, 30)
    for radius, low, high in ((20, 0, 20), (10, 30, 45)):
        truth = fuse(truth, cylinder(Axis.Z, (30, 30), radius, low, high))
    check(sketch(drawn(truth, roles, hidden=False), GRID), truth)


def test_a_straight_step_behind_a_wider_one_is_straight() -> None:
    truth = fuse(box((0, 0, 10), (60, 40, 18)), box((20, 0, 0), (45, 30, 10)))
    found = sketch(drawn(truth, hidden=False), GRID)
    check(found, truth)


def test_what_is_not_as_wide_both_ways_is_not_round() -> None:
    disc = cylinder(Axis.Z, (30, 30), 30, 10, 20)
    truth = fuse(cut(disc, cylinder(Axis.Z, (30, 30), 5, 0, 21)), box((15, 20, 0), (45, 40, 10)))
    truth = cut(truth, cylinder(Axis.Z, (30, 30), 5, -1, 21))
    check(sketch(drawn(truth, hidden=False), GRID), truth)
