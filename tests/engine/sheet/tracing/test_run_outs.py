"""Outlines that rise to a corner at the end of a keyway are arcs, and go on beyond it."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.run_outs import with_run_outs
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

VISIBLE, HIDDEN = Linetype
LOW, FOOT, WALL = 60.0, 100.0, 150.0


def _keyway(sketch: Sketch, rise: float, long: float, straight: bool = False) -> Any:  # noqa: ANN401
    """The end of a keyway: the outline rises over so many px to a wall's dashes, and goes on."""
    radius = (long**2 + rise**2) / (2.0 * rise)
    drawn = sketch(200, 140).line((20, LOW), (FOOT, LOW))
    if straight:
        drawn.line((FOOT, LOW), (FOOT + long, LOW - rise))
    else:
        turn = float(np.arcsin(long / radius))
        drawn.arc((FOOT, LOW - radius), radius, 3.0, 0.5 * np.pi - turn, turn)
    drawn.line((FOOT + long, LOW - rise), (WALL, LOW - rise)).line((WALL, 30), (WALL, 120))
    drawn.broken((FOOT + long, LOW - rise), (FOOT + long, 110.0), (10.0, 5.0))
    return drawn


def _pieces(long: float, top: float) -> list[tuple[Line, Piece]]:
    return [
        (Line((0.0, LOW), (1.0, 0.0)), Piece(20.0, FOOT + 0.6 * long, VISIBLE, 1.0)),
        (Line((FOOT + long, 0.0), (0.0, 1.0)), Piece(top, 110.0, HIDDEN, 0.9)),
        (Line((WALL, 0.0), (0.0, 1.0)), Piece(30.0, 120.0, VISIBLE, 1.0)),
    ]


def _sheet(drawn: Any) -> CleanSheet:  # noqa: ANN401
    return clean_sheet(drawn.grey)


@pytest.mark.parametrize(("rise", "long"), [(2.0, 20.0), (3.1, 24.8), (5.0, 25.0), (8.0, 30.0)])
def test_a_rise_is_an_arc_to_the_corner(sketch: Sketch, rise: float, long: float) -> None:
    pieces = _pieces(long, LOW - rise - 1.0)
    found = with_run_outs(pieces, _sheet(_keyway(sketch, rise, long)))
    assert len(found) == 5
    (circle, arc) = next(item for item in found if isinstance(item[0], Circle))
    ends = circle.points_at(np.array([arc.start, arc.end]))
    inner, corner = ends[np.argsort(ends[:, 0])]
    assert inner == pytest.approx([FOOT, LOW], abs=1.6)
    assert corner == pytest.approx([FOOT + long, LOW - rise], abs=0.4)
    line, piece = found[0]
    assert line.at(piece.end) == pytest.approx(tuple(inner), abs=1e-3)
    dashed = next(item for item in found if item[1].linetype is HIDDEN)
    assert dashed[0].at(dashed[1].start) == pytest.approx(tuple(corner), abs=1e-3)
    beyond, rest = found[-1]
    assert beyond.points_at(np.array([rest.start, rest.end])) == pytest.approx(
        np.array([[FOOT + long, LOW - rise], [WALL, LOW - rise]]), abs=0.4
    )


def test_what_was_found_of_the_outline_beyond_is_not_drawn_again(sketch: Sketch) -> None:
    rise, long = 3.0, 24.0
    known = Line((0.0, LOW - rise), (1.0, 0.0)), Piece(FOOT + long + 1.0, WALL, VISIBLE, 1.0)
    found = with_run_outs([*_pieces(long, LOW - rise), known], _sheet(_keyway(sketch, rise, long)))
    assert len(found) == 5
    lines = [item for item, _ in found if isinstance(item, Line)]
    level = [line for line in lines if abs(line.at(0.0)[1] - known[0].at(0.0)[1]) < 0.5]
    assert len(level) == 1


def test_a_chord_gives_way_to_the_arc(sketch: Sketch) -> None:
    rise, long = 3.0, 24.0
    start, end = np.array([FOOT + 8.0, LOW]), np.array([FOOT + long, LOW - rise])
    way = (end - start) / np.hypot(*(end - start))
    chord = (
        Line(tuple(start), tuple(way)),
        Piece(0.0, float(np.hypot(*(end - start))), VISIBLE, 0.8),
    )
    found = with_run_outs([*_pieces(long, LOW - rise), chord], _sheet(_keyway(sketch, rise, long)))
    assert chord not in found
    assert sum(isinstance(item[0], Circle) for item in found) == 1


def test_both_ends_of_a_line_rise(sketch: Sketch) -> None:
    rise, long, far = 3.1, 24.8, 30.0
    radius = (long**2 + rise**2) / (2.0 * rise)
    drawn = _keyway(sketch, rise, long)
    drawn.weight[:, : int(FOOT)] = 0.0
    drawn.line((FOOT - far, LOW), (FOOT, LOW)).line(
        (10, LOW - rise), (FOOT - far - long, LOW - rise)
    )
    turn = float(np.arcsin(long / radius))
    drawn.arc((FOOT - far, LOW - radius), radius, 3.0, 0.5 * np.pi, turn)
    drawn.broken((FOOT - far - long, LOW - rise), (FOOT - far - long, 110.0), (10.0, 5.0))
    pieces = [
        (Line((0.0, LOW - 0.1), (1.0, 0.0)), Piece(FOOT - far - 9.0, FOOT + 9.0, VISIBLE, 1.0)),
        *_pieces(long, LOW - rise)[1:],
        (Line((FOOT - far - long, 0.0), (0.0, 1.0)), Piece(LOW - rise, 110.0, HIDDEN, 0.9)),
    ]
    found = with_run_outs(pieces, _sheet(drawn))
    assert sum(isinstance(item[0], Circle) for item in found) == 2
    low, piece = found[0]
    ends = low.points_at(np.array([piece.start, piece.end]))
    assert ends == pytest.approx(np.array([[FOOT - far, LOW], [FOOT, LOW]]), abs=1.6)
    assert ends[:, 1] == pytest.approx(LOW, abs=0.1)


@pytest.mark.parametrize(("rise", "long", "straight"), [(0.5, 24.0, False), (3.0, 24.0, True)])
def test_steps_and_slants_are_none(
    sketch: Sketch, rise: float, long: float, straight: bool
) -> None:
    pieces = _pieces(long, LOW - rise)
    drawn = _keyway(sketch, rise, long, straight=straight)
    assert with_run_outs(pieces, _sheet(drawn)) == pieces


@pytest.mark.parametrize("rise", [2.2, 3.1, 4.4])
def test_the_keyway_of_a_shaft_is_read(sketch: Sketch, rise: float) -> None:
    long = 25.0
    drawn = _keyway(sketch, rise, long).lines((WALL, 120), (20, 120), (20, LOW))
    drawn.line((WALL, 30), (190, 30)).lines((190, 30), (190, 120), (WALL, 120))
    view = find_shapes(_sheet(drawn), (17.0, 27.0, 193.0, 123.0))
    strokes = classify_strokes(view, view_rhythm([view], 3.0))
    arcs = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    assert len(arcs) == 1
    level = [
        stroke
        for stroke in strokes
        if isinstance(stroke, Segment)
        and abs(stroke.start[1] - stroke.end[1]) < 0.5
        and abs(stroke.start[1] - 0.5 - (LOW - rise)) < 0.5
    ]
    assert len(level) == 1
    assert sorted(x for x, _ in (level[0].start, level[0].end)) == pytest.approx(
        [FOOT + long + 0.5, WALL + 0.5], abs=0.6
    )
