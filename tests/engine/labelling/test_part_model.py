"""A drawing as cells and rules."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.cells.arrangement import OUTSIDE
from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.labelling import part_model as reasoning_part
from gaussiancad_core.labelling.counted_work import OVER
from gaussiancad_core.labelling.part_model import PartModel, model_part, with_lone_bodies
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_NAMES = ("l-bracket", "counterbored-block", "filleted-block", "cross-bored-pin")


@pytest.mark.parametrize("name", _NAMES)
def test_no_drawn_line_has_the_outside_on_both_sides(
    name: str, sample_views: Callable[[str], DrawnViews]
) -> None:
    space = model_part(sample_views(name)).space
    for plane in space.planes.values():
        assert plane.regions > 1
        for index, low, high in plane.stretches:
            curve = plane.carriers[index].curve
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
    assert set(part.carriers.planes) == {Axis.Y, Axis.Z}
    assert part.space.planes[Axis.X].regions == 2
    second, third = part.carriers.size[1:]
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


def test_pictures_have_fewer_pieces(
    sample_views: Callable[[str], DrawnViews], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reasoning_part, "_MOST_READ", 20)
    views = sample_views("l-bracket")
    assert len(model_part(views).rules) > 0
    with pytest.raises(LimitError) as caught:
        model_part(replace(views, tolerance=0.1))
    assert caught.value.code == "part-too-complex"


def test_a_part_that_is_not_modelled_in_time_says_so(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    with pytest.raises(LimitError) as caught:
        model_part(sample_views("l-bracket"), deadline=OVER)
    assert caught.value.code == "search-unfinished"


@pytest.fixture
def blunt_cone() -> PartModel:
    """A cone on a plate; one view lacks its outline."""

    def chain(*points: tuple[float, float]) -> list[Segment]:
        return [Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(points)]

    def circle(radius: float) -> Arc:
        return Arc((30.0, 20.0), radius, 0.0, 2.0 * pi, Linetype.VISIBLE)

    plate, side = [(60, 10), (60, 0), (0, 0), (0, 10)], [(0, 0), (40, 0), (40, 40), (0, 40), (0, 0)]
    front = [*chain(*plate, (60, 10)), *chain((12, 10), (20, 40), (40, 40), (48, 10))]
    top = [*chain((0, 0), (60, 0), (60, 40), (0, 40), (0, 0)), circle(18.0), circle(10.0)]
    right = [*chain(*side), *chain((0, 10), (40, 10))]
    strokes = {Role.FRONT: front, Role.TOP: top, Role.RIGHT: right}
    return model_part(exact_views(strokes, (60.0, 40.0, 40.0)))


def test_bodies_of_one_view_change_only_the_rules_that_look_into_them(
    blunt_cone: PartModel,
) -> None:
    asked: list[Sequence[int]] = []
    wider = with_lone_bodies(blunt_cone, lambda but: bool(asked.append(but)))
    assert wider is not None
    assert len(wider.space.bodies) == len(blunt_cone.space.bodies) + 1
    (through,) = asked
    assert 0 < len(through) < len(blunt_cone.rules)
    found = {replace(rule, weight=0.0) for rule in wider.rules}
    for number, rule in enumerate(blunt_cone.rules):
        if number not in through:
            assert replace(rule, weight=0.0) in found


def test_no_bodies_are_added_where_the_other_rules_contradict_each_other(
    blunt_cone: PartModel,
) -> None:
    assert with_lone_bodies(blunt_cone, lambda but: True) is None
    with pytest.raises(LimitError) as caught:
        with_lone_bodies(blunt_cone, lambda but: False, OVER)
    assert caught.value.code == "search-unfinished"


@pytest.mark.parametrize("stretched", [0.9996, 0.9998, 1.0, 1.0002, 1.0004])
def test_where_values_are_rounded_the_unseen_side_is_as_large_as_they_are(stretched: float) -> None:
    x, y, z = 40.012, 6.0 * stretched, 56.989
    lines = (9.0, 20.0, 28.0)
    front = [_upright(at, z) for at in (0.0, *lines, x)] + [_level(at, x) for at in (0.0, z)]
    top = [_upright(at, y) for at in (0.0, *lines, x)] + [_level(at, x) for at in (0.0, 2.0, y)]
    strokes = {Role.FRONT: tuple(front), Role.TOP: tuple(top)}
    part = model_part(DrawnViews(strokes, (x, y, z), 0.04))
    assert part.carriers.nominal
    corners = part.space.planes[Axis.X].corners
    for place, axis in enumerate((Axis.Y, Axis.Z)):
        far = max(corner[place] for corner in corners)
        assert far == max(part.carriers.values[axis])


def _upright(at: float, height: float) -> Segment:
    return Segment((at, 0.0), (at, height), Linetype.VISIBLE)


def _level(at: float, width: float) -> Segment:
    return Segment((0.0, at), (width, at), Linetype.VISIBLE)
