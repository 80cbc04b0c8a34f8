"""Where pieces of lines and circles end."""

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.ink_shapes import Circle, Line
from gaussiancad_core.sheet.tracing.junctions import ended_at_junctions, is_full_circle

RHYTHM = Rhythm(12.0, 6.0)
LEVEL = Line((0.0, 0.0), (1.0, 0.0))


def _upright(x: float) -> Line:
    return Line((x, 0.0), (0.0, 1.0))


def _visible(start: float, end: float) -> Piece:
    return Piece(start, end, Linetype.VISIBLE, 1.0)


def _hidden(start: float, end: float) -> Piece:
    return Piece(start, end, Linetype.HIDDEN, 1.0)


def _of(geometry: Line | Circle, pieces: list) -> list[tuple[float, float, Linetype]]:
    ended = ended_at_junctions(pieces, RHYTHM, 3.0)
    return [(p.start, p.end, p.linetype) for g, p in ended if g == geometry]


@pytest.mark.parametrize("seen", [(-1.5, 101.5), (1.2, 98.4), (0.0, 100.0)])
def test_a_line_ends_at_the_centre_lines_of_those_it_meets(seen: tuple) -> None:
    sides = [(_upright(x), _visible(-50, 50)) for x in (0.0, 100.0)]
    found = _of(LEVEL, [(LEVEL, _visible(*seen)), *sides])
    assert found == [(pytest.approx(0.0), pytest.approx(100.0), Linetype.VISIBLE)]


@pytest.mark.parametrize("degrees", [6.0, 9.0, 20.0])
def test_lines_that_meet_at_a_flat_angle_end_at_their_corner(degrees: float) -> None:
    """Ink and a px beside it are seen as a line's: far beyond a corner that is nearly straight."""
    angle = np.radians(degrees)
    slanted = Line((0.0, 0.0), (float(np.cos(angle)), float(np.sin(angle))))
    beyond = 2.4 / float(np.sin(angle))
    pieces = [(LEVEL, _visible(-beyond, 100.0)), (slanted, _visible(-100.0, beyond))]
    assert _of(LEVEL, pieces)[0][0] == pytest.approx(0.0, abs=1e-6)
    assert _of(slanted, pieces)[0][1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("offset", [1.5, 2.6])
@pytest.mark.parametrize("seen", [3.0, 8.0])
def test_a_hidden_slant_ends_at_the_outline_and_at_no_corner_beyond(
    offset: float, seen: float
) -> None:
    """A bore's chamfer ends a little beside an edge that ends at the outline, too, and is seen to
    end in the gap before it."""
    slant = Line((offset, 0.0), (float(np.sqrt(0.5)), float(np.sqrt(0.5))))
    pieces = [
        (LEVEL, _visible(-100.0, 200.0)),
        (_upright(0.0), _visible(0.0, 150.0)),
        (slant, _hidden(seen, 46.0)),
    ]
    ((start, _, _),) = _of(slant, pieces)
    assert start == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("apart", [10.0, 12.0, 16.0])
def test_lines_that_meet_beyond_a_line_end_on_it(apart: float) -> None:
    """At flat angles all ink of both beyond it is its own."""
    slope = np.radians(18.4)
    left = Line((100.0, 0.0), (float(np.cos(slope)), float(-np.sin(slope))))
    right = Line((100.0 + apart, 0.0), (float(np.cos(slope)), float(np.sin(slope))))
    beyond = 2.5 / float(np.sin(slope)) - 0.5
    pieces = [
        (LEVEL, _visible(0.0, 200.0)),
        (left, _visible(-60.0, beyond)),
        (right, _visible(-beyond, 60.0)),
    ]
    assert _of(left, pieces) == [(-60.0, pytest.approx(0.0, abs=1e-6), Linetype.VISIBLE)]
    assert _of(right, pieces) == [(pytest.approx(0.0, abs=1e-6), 60.0, Linetype.VISIBLE)]


def test_lines_that_are_seen_to_meet_beyond_a_line_do() -> None:
    slope = np.radians(25.0)
    tip = (100.0, -2.0)
    one = Line(tip, (float(np.cos(slope)), float(np.sin(slope))))
    other = Line(tip, (float(np.cos(slope)), float(-np.sin(slope))))
    beyond = 2.5 / float(np.sin(2.0 * slope)) - 0.5
    pieces = [
        (LEVEL, _visible(0.0, 200.0)),
        (one, _visible(-beyond, 60.0)),
        (other, _visible(-60.0, beyond)),
    ]
    assert _of(one, pieces)[0][0] == pytest.approx(0.0, abs=1e-6)
    assert _of(other, pieces)[0][1] == pytest.approx(0.0, abs=1e-6)


def test_a_free_end_stays_where_its_ink_ends() -> None:
    far = [(_upright(200.0), _visible(-50, 50)), (_upright(100.0), _visible(20, 50))]
    assert _of(LEVEL, [(LEVEL, _visible(0, 100)), *far]) == [(0, 100, Linetype.VISIBLE)]


def test_a_dashed_line_reaches_over_its_last_gap() -> None:
    sides = [(_upright(x), _visible(-50, 50)) for x in (0.0, 100.0)]
    found = _of(LEVEL, [(LEVEL, _hidden(6.0, 93.0)), *sides])
    assert found == [(pytest.approx(0.0), pytest.approx(100.0), Linetype.HIDDEN)]


@pytest.mark.parametrize("mirrored", [False, True])
def test_the_first_dash_of_a_hidden_line_is_no_part_of_the_visible_one(mirrored: bool) -> None:
    """The visible line ends at 60, where another crosses; the dash from there reaches 72."""
    pieces = [_visible(0, 72), _hidden(72, 130)]
    expected = [(0, 60, Linetype.VISIBLE), (60, 130, Linetype.HIDDEN)]
    crossing = 60.0
    if mirrored:
        pieces = [_hidden(-130, -72), _visible(-72, 0)]
        expected = [(-130, -60, Linetype.HIDDEN), (-60, 0, Linetype.VISIBLE)]
        crossing = -60.0
    placed = [(LEVEL, piece) for piece in pieces]
    found = _of(LEVEL, [*placed, (_upright(crossing), _visible(-50, 0))])
    assert [(pytest.approx(a), pytest.approx(b), k) for a, b, k in expected] == found


def test_a_visible_line_that_ends_at_a_crossing_keeps_its_end() -> None:
    """Another line crosses a dash earlier, but the visible one ends at the nearer crossing."""
    placed = [(LEVEL, _visible(0, 71)), (LEVEL, _hidden(78, 130))]
    across = [(_upright(x), _visible(-50, 50)) for x in (60.0, 72.0)]
    found = _of(LEVEL, [*placed, *across])
    assert found == [
        (0, pytest.approx(72.0), Linetype.VISIBLE),
        (pytest.approx(72.0), 130, Linetype.HIDDEN),
    ]


def test_pieces_that_end_at_one_crossing_are_one_stroke() -> None:
    """A dash that the crossing line covered is missing between them."""
    placed = [(LEVEL, _hidden(0, 42)), (LEVEL, _hidden(58, 100))]
    found = _of(LEVEL, [*placed, (_upright(50.0), _visible(-50, 50))])
    assert found == [(0, 100, Linetype.HIDDEN)]


def test_an_arc_ends_where_its_tangents_begin() -> None:
    """Ink of a fillet and of its tangents is common over several px."""
    radius = 40.0
    corner = Circle((0.0, 0.0), radius)
    tangents = [
        (Line((radius, 0.0), (0.0, 1.0)), _visible(-100, 5)),
        (Line((0.0, radius), (1.0, 0.0)), _visible(-100, 5)),
    ]
    seen = _visible(-9.0, radius * np.pi / 2 + 9.0)
    found = _of(corner, [(corner, seen), *tangents])
    assert found == [
        (pytest.approx(0.0, abs=1e-6), pytest.approx(radius * np.pi / 2), Linetype.VISIBLE)
    ]
    for line, _ in tangents:
        assert _of(line, [(corner, seen), *tangents])[0][1] == pytest.approx(0.0, abs=1e-6)


def test_a_full_circle_has_no_ends() -> None:
    circle = Circle((0.0, 0.0), 10.0)
    whole = _visible(3.0, 3.0 + 20 * np.pi)
    assert is_full_circle(circle, whole)
    assert not is_full_circle(circle, _visible(0.0, 60.0))
    found = _of(circle, [(circle, whole), (_upright(10.0), _visible(-50, 50))])
    assert found == [(whole.start, whole.end, Linetype.VISIBLE)]


def _ends(circle: Circle, piece: tuple[float, float, Linetype]) -> np.ndarray:
    return circle.points_at(np.array(piece[:2]))


@pytest.mark.parametrize("off", [-1.5, 0.0, 1.2])
def test_arcs_end_where_their_circles_cross(off: float) -> None:
    """Two holes that overlap."""
    one, other = Circle((0.0, 0.0), 30.0), Circle((40.0, 0.0), 30.0)
    angle = float(np.arccos(20.0 / 30.0))
    right = _visible(30.0 * angle + off, 30.0 * (2 * np.pi - angle) - off)
    left = _visible(30.0 * (angle - np.pi) + off, 30.0 * (np.pi - angle) - off)
    pieces = [(one, right), (other, left)]
    meet = np.array([[20.0, np.sqrt(500.0)], [20.0, -np.sqrt(500.0)]])
    (found,) = _of(one, pieces)
    assert _ends(one, found) == pytest.approx(meet)
    (found,) = _of(other, pieces)
    assert _ends(other, found) == pytest.approx(meet[::-1])


@pytest.mark.parametrize("off", [-4.0, 0.0, 1.5])
def test_arcs_that_touch_end_where_they_touch(off: float) -> None:
    """An S of two arcs: their ink is one for some px around the point."""
    one, other = Circle((0.0, 0.0), 40.0), Circle((100.0, 0.0), 60.0)
    upper = _visible(off, 60.0)
    lower = _visible(60.0 * np.pi + off, 60.0 * np.pi + 90.0)
    (found,) = _of(one, [(one, upper), (other, lower)])
    assert _ends(one, found)[0] == pytest.approx((40.0, 0.0), abs=1e-6)
    assert found[1] == pytest.approx(60.0)
    (found,) = _of(other, [(one, upper), (other, lower)])
    assert _ends(other, found)[0] == pytest.approx((40.0, 0.0), abs=1e-6)


@pytest.mark.parametrize("seen", [(92.0, 8.0), (94.0, 6.0), (100.0, 0.0)])
def test_hidden_lines_meet_in_a_corner_where_neither_has_ink(seen: tuple[float, float]) -> None:
    """The gap of one or of both is at their corner, as programs leave it."""
    level, upright = _hidden(0.0, seen[0]), _hidden(seen[1], 50.0)
    corner = _upright(100.0)
    pieces = [(LEVEL, level), (corner, upright)]
    assert _of(LEVEL, pieces)[0][1] == pytest.approx(100.0)
    assert _of(corner, pieces)[0][0] == pytest.approx(0.0)


def test_a_hidden_line_does_not_reach_a_visible_one_that_ends_far_before_it() -> None:
    pieces = [(LEVEL, _hidden(0.0, 92.0)), (_upright(100.0), _visible(8.0, 50.0))]
    assert _of(LEVEL, pieces)[0][1] == pytest.approx(92.0)


def test_single_dashes_are_not_led_to_a_corner() -> None:
    """Two dashes of a circle look like lines; their corner lies outside of it."""
    pieces = [(LEVEL, _hidden(80.0, 92.0)), (_upright(100.0), _hidden(8.0, 20.0))]
    assert _of(LEVEL, pieces)[0][:2] == pytest.approx((80.0, 92.0))
