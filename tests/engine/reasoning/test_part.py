"""A drawing as cells and rules."""

from collections.abc import Callable

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.errors import LimitError
from gaussiancad_core.reasoning.arrangement import OUTSIDE
from gaussiancad_core.reasoning.drawn_views import DrawnViews, exact_views
from gaussiancad_core.reasoning.part import model_part
from gaussiancad_core.views import Linetype, Segment

_NAMES = ("l-bracket", "counterbored-block", "filleted-block", "cross-bored-pin")


@pytest.mark.parametrize("name", _NAMES)
def test_no_drawn_line_has_the_outside_on_both_sides(
    name: str, sample_views: Callable[[str], DrawnViews]
) -> None:
    space = model_part(sample_views(name)).space
    for plane in space.planes.values():
        assert plane.regions > 1
        for index, low, high in plane.stretches:
            curve = plane.supports[index].curve
            for share in (0.1, 0.37, 0.61, 0.9):
                at = low + share * (high - low)
                (a, b), (da, db) = curve.at(at), curve.normal(at)
                sides = {plane.locate(a + way * da, b + way * db) for way in (-1e-4, 1e-4)}
                assert sides != {OUTSIDE}


def test_a_direction_without_a_view_is_the_whole_box(
    sample_solid: Callable[[str], TopoDS_Shape], drawn: Callable[..., DrawnViews]
) -> None:
    views = drawn(sample_solid("l-bracket"), (Role.FRONT, Role.TOP))
    part = model_part(views)
    assert set(part.supports.planes) == {Axis.Y, Axis.Z}
    assert part.space.planes[Axis.X].regions == 2
    second, third = part.supports.size[1:]
    for share in np.linspace(0.01, 0.99, 9):
        assert part.space.planes[Axis.X].locate(share * second, share * third) != OUTSIDE
    assert {rule.role for rule in part.rules} == {Role.FRONT, Role.TOP}


def test_rules_weigh_by_length_and_name_a_view(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    part = model_part(sample_views("l-bracket"))
    assert all(rule.weight > 0.0 for rule in part.rules)
    assert {rule.role for rule in part.rules} == {Role.FRONT, Role.TOP, Role.RIGHT}
    assert {rule.linetype for rule in part.rules} == {None, *Linetype}


def test_too_many_lines_are_told_so_at_once() -> None:
    rng = np.random.default_rng(1)
    rows = rng.uniform(0.0, 100.0, (5000, 4))
    lines = [Segment((a, b), (c, d), Linetype.VISIBLE) for a, b, c, d in rows]
    with pytest.raises(LimitError) as caught:
        model_part(exact_views({Role.FRONT: lines, Role.TOP: lines}, (100.0, 100.0, 100.0)))
    assert caught.value.code == "part-too-complex"
