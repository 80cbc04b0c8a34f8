"""Corners, sharp or cut, down to cuts as wide as the pen."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc

Sketch = Any
"""The class that the fixture gives."""

LEFT, TOP, RIGHT, BOTTOM = 40.3, 30.6, 340.2, 250.9


@pytest.mark.parametrize(("off", "width"), [(0.05, 2.0), (0.3, 2.5), (0.62, 3.0), (0.85, 3.7)])
def test_lines_along_the_pixels_lie_where_they_were_drawn(
    sketch: Sketch, off: float, width: float
) -> None:
    drawn = sketch().box(20 + off, 20 + off, 180 - off, 140 - off, width)
    assert drawn.misread(0.06) == []


@pytest.mark.parametrize(
    ("width", "across", "down"),
    [(2.0, 5.0, 5.0), (3.0, 6.0, 6.0), (3.0, 8.0, 8.0), (2.0, 6.0, 10.0), (3.0, 12.0, 7.0)],
)
def test_an_outline_with_one_chamfer(
    sketch: Sketch, width: float, across: float, down: float
) -> None:
    drawn = sketch(380, 290).lines(
        (RIGHT - across, TOP), (LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM), (RIGHT, TOP + down),
        (RIGHT - across, TOP), width=width,
    )  # fmt: skip
    assert drawn.misread(0.6) == []


@pytest.mark.parametrize(
    ("width", "across", "down"),
    [
        (2.0, 3.6, 3.6),
        (3.0, 3.6, 3.6),
        (4.0, 4.8, 4.8),
        (4.0, 6.0, 6.0),
        (3.0, 5.0, 9.0),
        (3.0, 7.0, 7.0),
        (2.6, 8.76, 8.76),
    ],
)
def test_a_chamfered_rod_beside_the_edges_of_its_chamfers(
    sketch: Sketch, width: float, across: float, down: float
) -> None:
    drawn = sketch(380, 290).lines(
        (RIGHT, TOP), (LEFT + across, TOP), (LEFT, TOP + down), (LEFT, BOTTOM - down),
        (LEFT + across, BOTTOM), (RIGHT, BOTTOM), (RIGHT, TOP), width=width,
    )  # fmt: skip
    drawn.line((LEFT + across, TOP), (LEFT + across, BOTTOM), width)
    assert drawn.misread(0.7) == []


@pytest.mark.parametrize(("width", "away"), [(2.0, 3.6), (3.0, 4.2), (4.0, 5.4)])
def test_a_line_beside_a_square_end_is_no_edge_of_a_chamfer(
    sketch: Sketch, width: float, away: float
) -> None:
    drawn = sketch(380, 290).box(LEFT, TOP, RIGHT, BOTTOM, width)
    drawn.line((LEFT + away, TOP), (LEFT + away, BOTTOM), width)
    assert drawn.misread() == []


@pytest.mark.parametrize("style", ["", "scan", "photocopy"])
@pytest.mark.parametrize("width", [2.0, 5.0])
def test_sharp_corners_stay_sharp(sketch: Sketch, width: float, style: str) -> None:
    drawn = sketch(400, 280)
    drawn.lines((70, 60), (330, 90), (280, 230), (110, 200), (70, 60), width=width)
    assert drawn.misread(0.8, style) == []


@pytest.mark.parametrize("cut", [5.0, 8.0, 20.0])
def test_cut_corners_are_no_arcs(sketch: Sketch, cut: float) -> None:
    x0, y0, x1, y1 = 60.3, 50.6, 340.4, 220.2
    drawn = sketch(400, 280).lines(
        (x0 + cut, y0), (x1 - cut, y0), (x1, y0 + cut), (x1, y1 - cut), (x1 - cut, y1),
        (x0 + cut, y1), (x0, y1 - cut), (x0, y0 + cut), (x0 + cut, y0), width=2.0,
    )  # fmt: skip
    assert drawn.misread(0.7) == []


@pytest.mark.parametrize("leg", [10.25, 11.5, 14.0])
def test_a_cut_beside_a_corner_within_an_outline(sketch: Sketch, leg: float) -> None:
    drawn = (
        sketch(260, 180).box(12, 12, 248, 168).line((12, 80), (248, 80)).line((12, 97), (248, 97))
    )
    drawn.line((12.0, 80.0 + leg), (12.0 + leg, 80.0), 2.8)
    assert drawn.misread() == []


@pytest.mark.parametrize("height", [18.0, 26.0])
def test_small_pockets_are_four_edges_and_no_dashed_circles(sketch: Sketch, height: float) -> None:
    drawn = sketch(400, 200).box(20, 20, 380, 180, 2.0)
    for x in (60.0, 110.0, 200.0, 320.0):
        drawn.box(x, 60.0, x + 15, 60.0 + height, 2.0)
    assert drawn.misread() == []


@pytest.mark.parametrize(("apart", "x", "pen"), [(7.4, 160.6, 2.4), (7.8, 160.3, 2.8)])
def test_the_square_end_of_a_slot_is_no_half_circle(
    sketch: Sketch, apart: float, x: float, pen: float
) -> None:
    drawn = sketch(320, 240).box(20, 20, 300, 220, pen).line((20, 120.2), (300, 120.2), pen)
    drawn.lines((20, 120.2 + apart), (x, 120.2 + apart), (x, 120.2), width=pen)
    assert drawn.misread() == []


@pytest.mark.parametrize(("deep", "offset"), [(5.3, 7.1), (5.3, 33.0), (7.1, 24.0), (9.2, 7.1)])
def test_the_flanks_of_a_narrow_groove(sketch: Sketch, deep: float, offset: float) -> None:
    """Between two flanges, and with a shoulder on either side of it."""
    levels = [35.3, 35.3 + offset, 35.3 + offset + deep, 35.3 + offset + 2.0 * deep]
    levels.append(levels[-1] + offset)
    drawn = sketch(200, 180)
    left = list(zip([40.0, 40.0, 40.0 + deep, 40.0, 40.0], levels, strict=True))
    right = [(200.0 - x, y) for x, y in left]
    drawn.lines(*left, width=2.7).lines(*right, width=2.7)
    for one, other in zip(left[1:-1], right[1:-1], strict=True):
        drawn.line(one, other, 2.7)
    drawn.box(30, levels[0] - 18.0, 170, levels[0], 2.7)
    drawn.box(30, levels[-1], 170, levels[-1] + 18.0, 2.7)
    assert drawn.misread() == []


def test_an_undercut_ends_where_nothing_else_does(sketch: Sketch) -> None:
    """Its flank leads from the corner of a shoulder to the next face, along which nothing ends."""
    drawn = sketch(200, 140)
    drawn.lines((56.2, 66.2), (50, 60), (50, 20), (150, 20), (150, 60), (143.8, 66.2), width=2.7)
    drawn.line((50, 60), (150, 60), 2.7).box(30, 66.2, 170, 110, 2.7)
    assert drawn.misread() == []


def test_the_shoulders_of_a_groove(sketch: Sketch) -> None:
    upper = [(40.0, 30.0), (48.6, 30.0), (83.1, 64.5), (117.6, 30.0), (126.2, 30.0)]
    lower = [(x, 160.0 - y) for x, y in upper]
    drawn = sketch(200, 160).lines(*upper).lines(*lower).line(upper[0], lower[0])
    for start, end in zip(upper[1:4], lower[1:4], strict=True):
        drawn.line(start, end)
    drawn.lines((126.2, 15), (170, 15), (170, 145), (126.2, 145), (126.2, 15))
    assert drawn.misread() == []


@pytest.mark.parametrize("foot", [61.6, 63.2, 65.7])
def test_the_foot_of_a_cone_between_two_walls(sketch: Sketch, foot: float) -> None:
    """A shaft's flange, the 45 degrees of its chamfer, and the shaft."""
    high, wall, shaft, step = 20.0, 50.0, 130.0, 12.3
    drawn = sketch(160, 200)
    for y, way in ((0.0, 1.0), (199.0, -1.0)):
        neck, side = y + way * foot, y + way * (foot - step)
        drawn.line((20.0, y + way * high), (wall, y + way * high))
        drawn.lines((wall, neck), (wall + step, side), (shaft, side))
    for x, y in ((20.0, high), (wall, high), (wall + step, foot - step), (shaft, foot - step)):
        drawn.line((x, y), (x, 199.0 - y))
    assert drawn.misread(0.2) == []


@pytest.mark.parametrize(("off", "width"), [(0.2, 2.0), (0.7, 3.0)])
def test_short_slants_between_two_lines_lie_on_their_own_ink(
    sketch: Sketch, off: float, width: float
) -> None:
    drawn = sketch(220, 200).box(20, 20, 200, 180, width)
    drawn.line((70, 20), (70, 180), width).line((84, 20), (84, 180), width)
    drawn.line((70, 60 + off), (84, 74 + off), width)
    assert drawn.line((70, 120 + off), (84, 106 + off), width).misread(0.2) == []


@pytest.mark.parametrize("rightwards", [True, False])
def test_an_edge_on_the_course_of_a_slant_is_upright(sketch: Sketch, rightwards: bool) -> None:
    """A cone's outline, drawn on, runs through the short edge of the shoulder above it."""

    def turned(*corners: tuple[float, float]) -> list[tuple[float, float]]:
        return [(x if rightwards else 340.0 - x, y) for x, y in corners]

    drawn = sketch(340, 290)
    drawn.lines(*turned((20, 137), (303, 137), (303, 160), (297.2, 166)), width=2.5)
    drawn.lines(*turned((20, 160), (303, 160)), width=2.5)
    drawn.lines(*turned((20, 250), (326.5, 250), (305.5, 166), (20, 166)), width=2.5)
    drawn.lines(*turned((20, 137), (20, 250)), width=2.5)
    assert drawn.misread(0.7) == []


@pytest.mark.parametrize(("away", "slope"), [(1.5, 0.6), (3.2, 0.4), (1.5, 1.0)])
def test_a_corner_beside_a_line_is_a_corner(sketch: Sketch, away: float, slope: float) -> None:
    x, run = 60.0 + away, 60.0
    drawn = sketch(240, 200).box(60, 20, 220, 180)
    drawn.lines((x + run, 100 - slope * run), (x, 100), (x + run, 100 + slope * run))
    drawn.line((x + run, 20), (x + run, 180))
    assert drawn.misread(1.1) == []


@pytest.mark.parametrize("degrees", [6.0, 9.0, 20.0])
def test_lines_that_meet_at_a_flat_angle_end_at_their_corner(
    sketch: Sketch, degrees: float
) -> None:
    rise = 120.0 * float(np.tan(np.radians(degrees)))
    drawn = sketch(300, 200)
    drawn.lines((20, 180), (20, 90), (150, 90), (270, 90 + rise), (270, 180), (20, 180))
    assert drawn.misread(0.6 if degrees > 8.0 else 1.2) == []


@pytest.mark.parametrize("apart", [12.0, 20.0, 30.0])
def test_slants_that_end_apart_on_a_line_are_not_joined(sketch: Sketch, apart: float) -> None:
    """They would meet beyond it, and the line is where an arc between them would be."""
    left, right = 200.0 - apart / 2.0, 200.0 + apart / 2.0
    drawn = (
        sketch(400, 280).box(60.3, 50.6, 340.4, 220.2, 2.6).line((60.3, 74.6), (340.4, 74.6), 2.6)
    )
    drawn.line((left - 60.0, 74.6), (left, 50.6), 2.6).line(
        (right, 50.6), (right + 60.0, 74.6), 2.6
    )
    assert drawn.misread(1.0) == []


@pytest.mark.parametrize("off", [0.0, 0.5])
def test_a_line_between_flat_meetings(sketch: Sketch, off: float) -> None:
    """It is followed into a level line at one end and into a steeper one at the other."""
    low, high, corner = (20.0, 120.0 + off), (120.0, 107.5 + off), (220.0, 120.0 + off)
    drawn = sketch(260, 140).lines(low, high, corner, low, width=2.6)
    drawn.lines(low, (20.0, 20.0), (220.0, 20.0), corner, width=2.6)
    drawn.lines((33.0, 70.0 + off), high, (207.0, 70.0 + off), width=2.6)
    drawn.line((20.0, 70.0 + off), (220.0, 70.0 + off), 2.6)
    assert drawn.misread(1.5) == []


def test_a_line_that_an_arrowhead_bends_is_straight(sketch: Sketch) -> None:
    drawn = sketch(200, 120).box(20, 20, 180, 100, 2.0).line((80, 20), (80, 100), 1.5)
    drawn.filled((80.0, 45.0), (69.0, 43.0), (69.0, 47.0)).line((20, 45), (80, 45), 1.5)
    assert not [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]
    assert drawn.misread() == []
