"""Chamfers whose lines are too short to be read."""

from dataclasses import replace
from itertools import pairwise
from math import pi

import pytest

from gaussiancad_core.cells.surfaces_of_revolution import LineProfile
from gaussiancad_core.coordinates.carriers import PartCarriers, find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.hypotheses.revolution_candidates import find_bodies
from gaussiancad_core.hypotheses.short_chamfers import with_short_chamfers
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_VISIBLE, _HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
_BOX = (40.0, 40.0, 20.0)
_CENTRE = 15.0
_BORE, _MOUTH = 4.0, 5.0

Stroke = Segment | Arc


def _outline(width: float, height: float) -> list[Stroke]:
    corners = ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0))
    return [Segment(a, b, _VISIBLE) for a, b in pairwise(corners)]


def _bore(rim: float = 19.0) -> list[Stroke]:
    """A bore through the block beside its axis; its chamfer's slanted lines are left out."""
    left, right = _CENTRE - _BORE, _CENTRE + _BORE
    return [
        Segment((left, 0.0), (left, rim), _HIDDEN),
        Segment((right, 0.0), (right, rim), _HIDDEN),
        Segment((left, rim), (right, rim), _HIDDEN),
    ]


def _chamfer() -> list[Stroke]:
    return [
        Segment((_CENTRE + way * _BORE, 19.0), (_CENTRE + way * _MOUTH, 20.0), _HIDDEN)
        for way in (-1.0, 1.0)
    ]


def _block(
    front: list[Stroke], right: list[Stroke], radii: tuple[float, ...] = (_BORE, _MOUTH)
) -> PartCarriers:
    circles = [Arc((_CENTRE, _CENTRE), radius, 0.0, 2.0 * pi, _VISIBLE) for radius in radii]
    strokes = {
        Role.FRONT: (*_outline(40.0, 20.0), *front),
        Role.TOP: (*_outline(40.0, 40.0), *circles),
        Role.RIGHT: (*_outline(40.0, 20.0), *right),
    }
    return find_carriers(DrawnViews(strokes, _BOX, 0.1))


def _cones(carriers: PartCarriers) -> list[LineProfile]:
    return [body.profile for body in find_bodies(with_short_chamfers(carriers))]


@pytest.mark.parametrize("shown", [(True, True), (True, False), (False, True)])
def test_the_chamfer_between_two_circles_is_a_cone(shown: tuple[bool, bool]) -> None:
    front, right = (_bore() if one else [] for one in shown)
    carriers = _block(front, right)
    assert not find_bodies(carriers)
    (cone,) = _cones(carriers)
    units = (cone.low, cone.high, cone.at_low, cone.at_high)
    assert [value / carriers.scale for value in units] == pytest.approx([19.0, 20.0, 4.0, 5.0])


def test_its_lines_may_be_drawn_or_not() -> None:
    found = with_short_chamfers(_block(_bore(), _bore()))
    for axis in (Axis.X, Axis.Y):
        slants = [s for s in found.planes[axis].carriers if s.curve.axis is None]
        intervals = [
            interval for s in slants for this_span in s.intervals.values() for interval in this_span
        ]
        assert [interval.confidence for interval in intervals] == [0.0, 0.0]


def test_a_step_is_no_chamfer() -> None:
    counterbore = [
        Segment((_CENTRE + way * _MOUTH, 19.0), (_CENTRE + way * _MOUTH, 20.0), _HIDDEN)
        for way in (-1.0, 1.0)
    ]
    strokes = [*_bore(), *counterbore]
    assert not _cones(_block(strokes, strokes))


def test_far_circles_would_have_had_their_lines_read() -> None:
    assert not _cones(_block(_bore(), _bore(), radii=(_BORE, 9.0)))
    assert not _cones(_block(_bore(15.0), _bore(15.0)))


def test_lines_that_are_drawn_from_one_circle_elsewhere_are_another_cone() -> None:
    other = Segment((_CENTRE + _BORE, 19.0), (_CENTRE + 8.0, 20.0), _HIDDEN)
    strokes = [*_bore(), other]
    carriers = _block(strokes, strokes)
    assert with_short_chamfers(carriers) == carriers


def test_what_one_view_shows_the_other_one_may_show() -> None:
    carriers = _block(_chamfer(), [])
    assert not find_bodies(carriers)
    (cone,) = _cones(carriers)
    assert cone.at_high / carriers.scale == pytest.approx(_MOUTH)
    assert not _cones(_block(_chamfer()[:1], []))


def test_nothing_is_added_where_all_is_drawn() -> None:
    carriers = _block([*_bore(), *_chamfer()], [*_bore(), *_chamfer()])
    assert with_short_chamfers(carriers) == carriers


def test_chamfers_that_are_drawn_do_not_count_among_those_that_may_be_lost() -> None:
    """Seven countersinks are shown by both views, and told twice; the mouth of a bore is not."""
    size = (130.0, 40.0, 20.0)
    bores = [_CENTRE + 14.0 * number for number in range(8)]
    circles = [
        Arc((x, _CENTRE), radius, 0.0, 2.0 * pi, _VISIBLE)
        for x in bores
        for radius in (_BORE, _MOUTH)
    ]
    sinks = [
        Segment((x + way * _BORE, 19.0), (x + way * _MOUTH, 20.0), _HIDDEN)
        for x in bores[1:]
        for way in (-1.0, 1.0)
    ]
    strokes = {
        Role.FRONT: (*_outline(130.0, 20.0), *_bore(), *sinks),
        Role.TOP: (*_outline(130.0, 40.0), *circles),
        Role.RIGHT: (*_outline(40.0, 20.0), *_bore(), *_chamfer()),
    }
    carriers = find_carriers(DrawnViews(strokes, size, 0.1))
    cones = [body.centre[0] / carriers.scale for body in find_bodies(carriers)]
    completed = find_bodies(with_short_chamfers(carriers))
    assert sorted(cones) == pytest.approx(bores[1:])
    assert sorted(body.centre[0] / carriers.scale for body in completed) == pytest.approx(bores)


def test_exact_lines_are_all_there() -> None:
    carriers = replace(_block(_bore(), _bore()), tolerance=1e-4)
    assert with_short_chamfers(carriers) == carriers


def test_steep_chamfers_are_another_thing() -> None:
    assert not _cones(_block(_bore(18.8), _bore(18.8), radii=(_BORE, 4.5)))
    assert len(_cones(_block(_bore(19.2), _bore(19.2), radii=(_BORE, 4.5)))) == 1


def _undercut(neck: float, shoulder: float) -> list[Stroke]:
    """A pin on a block, from its neck's edge on; the face beside the neck is the block's."""
    left, right = _CENTRE - _BORE, _CENTRE + _BORE
    lines = [((left, neck), (right, neck)), ((left, neck), (left, 20.0))]
    lines += [((right, neck), (right, 20.0)), ((left, 20.0), (right, 20.0))]
    edge = [
        ((_CENTRE - shoulder, 9.0), (_CENTRE + shoulder, 9.0)),
        ((0.0, 0.0), (30.0, 0.0)),
        ((0.0, 0.0), (0.0, 9.0)),
        ((30.0, 0.0), (30.0, 9.0)),
    ]
    return [Segment(start, end, _VISIBLE) for start, end in (*lines, *edge)]


@pytest.mark.parametrize(("shoulder", "cones"), [(15.0, 1), (_BORE, 0)])
def test_the_undercut_between_a_shoulder_and_a_pin_is_a_cone(shoulder: float, cones: int) -> None:
    circles = [Arc((15.0, 15.0), radius, 0.0, 2.0 * pi, _VISIBLE) for radius in (3.0, _BORE)]
    side = _undercut(10.0, shoulder)
    strokes = {Role.FRONT: side, Role.TOP: (*_outline(30.0, 30.0), *circles), Role.RIGHT: side}
    carriers = find_carriers(DrawnViews(strokes, (30.0, 30.0, 20.0), 0.1))
    found = _cones(carriers)
    units = [(cone.low, cone.high, cone.at_low, cone.at_high) for cone in found]
    stated = [9.0, 10.0, 3.0, _BORE]
    assert len(units) == cones
    assert all([v / carriers.scale for v in unit] == pytest.approx(stated) for unit in units)


@pytest.mark.parametrize(("farther", "cones"), [(0.0, 2), (0.3, 2), (0.6, 0)])
def test_the_ground_of_a_groove_is_told_by_its_circle(farther: float, cones: int) -> None:
    """A groove like a V around an axis, seen from below: three circles and the edge of its ground.

    The dashes of its slants run on from those of the edge.
    """
    reach = 4.0 + farther
    ground = [Segment((_CENTRE - reach, 1.0), (_CENTRE + reach, 1.0), _HIDDEN)]
    carriers = _block(ground, ground, radii=(3.0, 4.0, 5.0))
    units = [(cone.low, cone.high, cone.at_low, cone.at_high) for cone in _cones(carriers)]
    stated = sorted([round(v / carriers.scale, 3) for v in unit] for unit in units)
    assert stated == [[0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 5.0, 4.0]][:cones]
