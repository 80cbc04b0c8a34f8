"""Corners beside a line keep off it; what really ends on the line stays there."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.corner_stubs import without_stubs
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.junctions import ended_at_junctions

WIDTH = 3.0
WALL = (Line((0.0, 0.0), (0.0, 1.0)), Piece(-80.0, 80.0, Linetype.VISIBLE, 1.0))


def _between(start: tuple, end: tuple) -> tuple[Line, Piece]:
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    line = Line(start, (float(way[0]) / length, float(way[1]) / length))
    return line, Piece(0.0, length, Linetype.VISIBLE, 1.0)


def _wedge(away: float, slope: float) -> list[tuple[Line, Piece]]:
    """Two strokes with their corner some px beside the wall, drawn on to the wall."""
    reach = away / slope
    run = 40.0 / slope
    return [
        _between((away + 40.0, -run), (0.0, reach)),
        _between((away + 40.0, run), (0.0, -reach)),
    ]


def _ends(placed: list) -> np.ndarray:
    return np.array([geometry.at(piece.end) for geometry, piece in placed])


@pytest.mark.parametrize("slope", [0.4, 0.6, 1.0])
@pytest.mark.parametrize("away", [1.5, 3.2])
def test_a_corner_beside_a_line_is_a_corner(away: float, slope: float) -> None:
    found = without_stubs([WALL, *_wedge(away, slope)], WIDTH)
    assert found[0] == WALL
    assert _ends(found[1:]) == pytest.approx(np.array([[away, 0.0]] * 2), abs=1e-9)


@pytest.mark.parametrize(
    "wedge",
    [
        # Paper would show between the corner and the line; steep stubs show beside its ink.
        _wedge(6.0, 0.6),
        _wedge(3.0, 4.0),
        # On one side of the line both only come closer to each other.
        [_between((60.0, 40.0), (0.0, 10.0)), _between((60.0, 60.0), (0.0, 12.0))],
    ],
)
def test_what_ends_on_a_line_stays_there(wedge: list) -> None:
    assert without_stubs([WALL, *wedge], WIDTH) == [WALL, *wedge]


def test_ends_at_junctions_are_such_corners() -> None:
    """The ink of both seems to reach the wall's middle."""
    seen = [WALL, *_wedge(3.0, 0.6)]
    found = ended_at_junctions(seen, Rhythm(12.0, 6.0), WIDTH)
    slanted = [item for item in found if item[0] != WALL[0]]
    assert _ends(slanted) == pytest.approx(np.array([[3.0, 0.0]] * 2), abs=1e-6)


def test_a_leg_is_no_wall_for_its_own_ends() -> None:
    """A bore's end, its side, and a drill's tip that starts at their corner."""
    floor, side = _between((278.8, 580.7), (330.7, 580.7)), _between((330.5, 546.0), (330.7, 580.7))
    tip = [_between((304.7, 595.6), (330.7, 580.3)), _between((278.8, 580.1), (304.7, 595.6))]
    found = without_stubs([floor, side, *tip], WIDTH)
    lengths = [piece.end - piece.start for _, piece in found]
    assert lengths == pytest.approx([51.9, 34.7, 30.2, 30.2], abs=0.2)
