"""Where two views show an edge that the third lacks, or strokes end in the open, a line may be."""

from itertools import pairwise
from math import pi

import pytest

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.coordinates.carriers import PlaneCarriers, find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.hypotheses.missing_edges import with_missing_edges
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_SIZE = (100.0, 60.0, 50.0)

Point = tuple[float, float]
Stroke = Segment | Arc


def _path(*points: Point, linetype: Linetype = Linetype.VISIBLE) -> tuple[Segment, ...]:
    return tuple(Segment(a, b, linetype) for a, b in pairwise(points))


_STEPPED = _path((0, 0), (100, 0), (100, 20), (40, 20), (40, 50), (0, 50), (0, 0))
_TOP = (*_path((0, 0), (100, 0), (100, 60), (0, 60), (0, 0)), *_path((40, 0), (40, 60)))
_RIGHT = (*_path((0, 0), (60, 0), (60, 50), (0, 50), (0, 0)), *_path((0, 20), (60, 20)))


def _views(
    front: tuple[Stroke, ...], top: tuple[Stroke, ...], right: tuple[Stroke, ...]
) -> DrawnViews:
    return DrawnViews({Role.FRONT: front, Role.TOP: top, Role.RIGHT: right}, _SIZE, 2e-4)


def _plane(views: DrawnViews, normal: Axis) -> PlaneCarriers:
    return with_missing_edges(find_carriers(views)).planes[normal]


def _regions(plane: PlaneCarriers) -> int:
    return Arrangement(plane.carriers, lost=plane.lost).regions


def _without(strokes: tuple[Stroke, ...], *numbers: int) -> tuple[Stroke, ...]:
    return tuple(stroke for number, stroke in enumerate(strokes) if number not in numbers)


@pytest.mark.parametrize("lost", range(6))
def test_an_edge_that_the_other_views_show_divides_the_one_that_lacks_it(lost: int) -> None:
    views = _views(_without(_STEPPED, lost), _TOP, _RIGHT)
    (plane, whole) = (_plane(views, Axis.Y), _plane(_views(_STEPPED, _TOP, _RIGHT), Axis.Y))
    stroke = _STEPPED[lost]
    middle = tuple((a + b) / 2.0 for a, b in zip(stroke.start, stroke.end, strict=True))
    over = [
        plane.carriers[number]
        for number, low, high in plane.lost
        if plane.carriers[number].curve.distance(middle) < 1e-6
        and low < plane.carriers[number].curve.parameter(middle) < high
    ]
    assert over
    assert all(
        carrier.linetype_at(Role.FRONT, 0.0) is None for carrier in over if not carrier.intervals
    )
    assert _regions(plane) >= _regions(whole)


def test_nothing_is_drawn_where_a_line_may_be_lacking() -> None:
    views = _views(_without(_STEPPED, 3), _TOP, _RIGHT)
    rules = model_part(views, lost_lines=True).rules
    on_it = [
        piece.linetype
        for rule in rules
        for piece in rule.pieces
        if piece.role is Role.FRONT and piece.point[0] == 40.0 and 20.0 < piece.point[1] < 50.0
    ]
    assert on_it and set(on_it) == {None}


def test_other_lines_are_not_made_up() -> None:
    stray = Segment((13.0, 7.0), (29.0, 7.0), Linetype.VISIBLE)
    views = _views((*_STEPPED, stray), _TOP, _RIGHT)
    plane = _plane(views, Axis.Y)
    lines = [plane.carriers[number].curve for number, _, _ in plane.lost]
    assert all(isinstance(line, Line) and line.axis is not None for line in lines)
    values = {line.point[line.axis] for line in lines}
    assert values <= {0.0, 20.0, 40.0, 50.0, 100.0}


def test_a_circle_is_where_both_other_views_show_its_sides() -> None:
    def hidden(*points: Point) -> tuple[Segment, ...]:
        return _path(*points, linetype=Linetype.HIDDEN)

    bore = Arc((70.0, 30.0), 10.0, 0.0, FULL_TURN, Linetype.VISIBLE)
    other = Arc((20.0, 30.0), 5.0, 0.0, FULL_TURN, Linetype.VISIBLE)
    front = (*_STEPPED, *hidden((60, 0), (60, 20)), *hidden((80, 0), (80, 20)))
    right = (*_RIGHT, *hidden((20, 0), (20, 20)), *hidden((40, 0), (40, 20)))
    plane = _plane(_views(front, (*_TOP, other), right), Axis.Z)
    circles = [plane.carriers[number].curve for number, _, _ in plane.lost]
    assert Circle((70.0, 30.0), 10.0) in circles
    for drawn in ((*_TOP, other, bore), (*_TOP, other, *_square()), _TOP):
        plane = _plane(_views(front, drawn, right), Axis.Z)
        lost = [plane.carriers[number].curve for number, _, _ in plane.lost]
        assert Circle((70.0, 30.0), 10.0) not in lost


def test_the_side_of_a_bore_is_where_its_circle_reaches_farthest() -> None:
    """At the one that is lacking there is no other line in any view."""
    bore = Arc((70.0, 30.0), 10.0, 0.0, FULL_TURN, Linetype.VISIBLE)
    sides = _path((80, 0), (80, 20), linetype=Linetype.HIDDEN)
    across = (
        *_path((20, 0), (20, 20), linetype=Linetype.HIDDEN),
        *_path((40, 0), (40, 20), linetype=Linetype.HIDDEN),
    )
    plane = _plane(_views((*_STEPPED, *sides), (*_TOP, bore), (*_RIGHT, *across)), Axis.Y)
    assert (60.0, 0.0, 20.0) in _upright(plane)


def _upright(plane: PlaneCarriers) -> list[tuple[float, float, float]]:
    """Where upright lines may be lacking, and from and to where."""
    found = []
    for number, low, high in plane.lost:
        curve = plane.carriers[number].curve
        if isinstance(curve, Line) and curve.axis == 0:
            (x, start), (_, end) = curve.at(low), curve.at(high)
            found.append((round(x, 6), round(start, 6), round(end, 6)))
    return found


def test_the_other_side_of_a_cone_tells_where_a_slanted_line_is() -> None:
    size = (60.0, 60.0, 50.0)
    rims = tuple(Arc((30.0, 30.0), r, 0.0, FULL_TURN, Linetype.VISIBLE) for r in (30.0, 10.0))
    whole = _path((0, 0), (60, 0), (40, 50), (20, 50), (0, 0))
    strokes = {Role.FRONT: whole[:3], Role.TOP: rims, Role.RIGHT: whole}
    plane = _plane(DrawnViews(strokes, size, 1.2e-4), Axis.Y)
    scale = 100.0 / 60.0
    middle = (10.0 * scale, 25.0 * scale)
    slanted = [plane.carriers[n].curve for n, _, _ in plane.lost]
    assert any(c.axis is None and c.distance(middle) < 1e-6 for c in slanted)


def _square() -> tuple[Segment, ...]:
    return _path((60, 20), (80, 20), (80, 40), (60, 40), (60, 20))


def test_the_arc_of_a_rounded_corner_is_where_both_lines_lead_into_it() -> None:
    rounded = _path((90, 60), (0, 60), (0, 0), (100, 0), (100, 50))
    top = (*rounded, *_path((40, 0), (40, 60)))
    plane = _plane(_views(_STEPPED, top, _RIGHT), Axis.Z)
    arcs = [
        (plane.carriers[number].curve, low, high)
        for number, low, high in plane.lost
        if isinstance(plane.carriers[number].curve, Circle)
    ]
    ((circle, low, high),) = arcs
    assert circle.centre == pytest.approx((90.0, 50.0)) and circle.radius == pytest.approx(10.0)
    assert (low, high) == pytest.approx((0.0, pi / 2.0))


def test_two_planes_tell_nothing_of_what_the_third_lacks() -> None:
    views = DrawnViews({Role.FRONT: _without(_STEPPED, 3), Role.TOP: _TOP}, _SIZE, 2e-4)
    carriers = find_carriers(views)
    assert with_missing_edges(carriers) == carriers
