"""Pieces of arcs that files write as chords, or as arcs of circles of their own."""

from collections.abc import Sequence
from dataclasses import replace
from math import asin, atan, cos, hypot, pi, sin

import pytest

from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.coordinates.split_arcs import is_piece, with_pieces_of_arcs
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_TOLERANCE = 0.005
_ARC = Arc((50.0, 40.0), 12.0, 0.4, 2.0, Linetype.VISIBLE)
_END = _ARC.start_angle + _ARC.sweep


def _at(angle: float, radius: float = _ARC.radius) -> tuple[float, float]:
    return _ARC.centre[0] + radius * cos(angle), _ARC.centre[1] + radius * sin(angle)


def _chord(low: float, high: float, linetype: Linetype = Linetype.VISIBLE) -> Segment:
    return Segment(_at(low), _at(high), linetype)


def _views(*strokes: DrawnStroke) -> DrawnViews:
    return DrawnViews({Role.FRONT: strokes}, (100.0, 100.0, 100.0), _TOLERANCE)


def _after(*strokes: DrawnStroke) -> Sequence[DrawnStroke]:
    views = with_pieces_of_arcs(_views(*strokes))
    return views.strokes[Role.FRONT]


def _assert_of_arc(piece: DrawnStroke, low: float, high: float) -> None:
    assert isinstance(piece, Arc)
    assert (piece.centre, piece.radius) == (_ARC.centre, _ARC.radius)
    assert (piece.start_angle, piece.sweep) == pytest.approx((low, high - low))


def test_a_chord_from_an_arcs_end_is_of_its_circle() -> None:
    kept, piece = _after(_ARC, _chord(_END, _END + 0.08, Linetype.HIDDEN))
    assert kept == _ARC
    _assert_of_arc(piece, _END, _END + 0.08)
    assert piece.linetype is Linetype.HIDDEN


def test_chords_go_on_from_chords() -> None:
    _, second, first = _after(_ARC, _chord(_END + 0.12, _END + 0.06), _chord(_END, _END + 0.06))
    _assert_of_arc(first, _END, _END + 0.06)
    _assert_of_arc(second, _END + 0.06, _END + 0.12)


def test_a_flat_arc_between_the_parts_of_another_is_of_its_circle() -> None:
    low, high = _at(_END), _at(_END + 0.08)
    middle = (low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0
    off = hypot(middle[0] - 50.0, middle[1] - 40.0)
    # A little more curved, with the same ends.
    half, rise = hypot(high[0] - low[0], high[1] - low[1]) / 2.0, 0.012
    radius = (half * half + rise * rise) / (2.0 * rise)
    share = (off + rise - radius) / off
    centre = 50.0 + share * (middle[0] - 50.0), 40.0 + share * (middle[1] - 40.0)
    sweep = 2.0 * asin(half / radius)
    way = _END + 0.04
    _, piece = _after(_ARC, Arc(centre, radius, way - sweep / 2.0, sweep, Linetype.VISIBLE))
    _assert_of_arc(piece, _END, _END + 0.08)


@pytest.mark.parametrize(
    "stroke",
    [
        Segment(_at(_END), _at(_END + atan(0.08), _ARC.radius / cos(atan(0.08))), Linetype.VISIBLE),
        _chord(_END, _END + 0.2),
        _chord(_END + 0.2, _END + 0.28),
        Arc((50.0, 52.0), 3.0, 0.0, pi / 2.0, Linetype.VISIBLE),
    ],
    ids=["tangent", "flat", "apart", "other arc"],
)
def test_other_strokes_stay(stroke: DrawnStroke) -> None:
    assert _after(_ARC, stroke) == (_ARC, stroke)


def test_what_was_read_stays() -> None:
    views = replace(_views(_ARC, _chord(_END, _END + 0.08)), apart=0.01)
    assert with_pieces_of_arcs(views) == views


def test_flat_arcs_of_one_very_circle_tell_it() -> None:
    one = Arc(_ARC.centre, _ARC.radius, 0.4, 0.03, Linetype.VISIBLE)
    other, neighbour = replace(one, start_angle=0.5), replace(one, start_angle=0.5, radius=12.01)
    exact = _views()
    assert is_piece(one, (one, other), exact)
    assert not is_piece(one, (one,), exact)
    assert not is_piece(one, (one, neighbour), exact)
    assert not is_piece(one, (one, other), replace(exact, apart=0.01))


def test_parts_of_an_arc_carry_what_lies_between_them_flat_as_they_are() -> None:
    parts = [replace(_ARC, start_angle=0.4, sweep=0.05), replace(_ARC, start_angle=0.5, sweep=0.05)]
    *kept, piece = _after(*parts, _chord(0.45, 0.5))
    assert kept == parts
    _assert_of_arc(piece, 0.45, 0.5)


def test_chords_tell_no_planes_and_leave_their_circle_whole() -> None:
    box = [
        Segment(a, b, Linetype.VISIBLE)
        for a, b in (
            ((0.0, 0.0), (100.0, 0.0)),
            ((100.0, 0.0), (100.0, 100.0)),
            ((100.0, 100.0), (0.0, 100.0)),
            ((0.0, 100.0), (0.0, 0.0)),
        )
    ]
    arc = replace(_ARC, start_angle=0.0, sweep=2.0 * pi - 0.08)
    hole = arc, _chord(2.0 * pi - 0.08, 2.0 * pi - 1e-9)
    (plane,) = find_carriers(_views(*box, *hole)).planes.values()
    curves = [carrier.curve for carrier in plane.carriers]
    assert len(curves) == len(box) + 1
    (circle,) = (s for s in plane.carriers if isinstance(s.curve, Circle))
    assert sum(high - low for low, high in circle.drawn()) == pytest.approx(2.0 * pi)
