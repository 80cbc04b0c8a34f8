"""Hidden lines are led on to the next edge where their ink shows behind the one they end at."""

import cv2
import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.tracing.behind_edges import with_ends_behind_edges
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.junctions import Placed
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

RHYTHM = Rhythm(8.0, 5.0)
STROKE = 3.0
LEVEL = Line((0.0, 50.0), (1.0, 0.0))
INNER, OUTER = Line((80.0, 0.0), (0.0, 1.0)), Line((92.0, 0.0), (0.0, 1.0))
EDGES: list[Placed] = [
    (INNER, Piece(10.0, 90.0, Linetype.VISIBLE, 1.0)),
    (OUTER, Piece(10.0, 90.0, Linetype.VISIBLE, 1.0)),
]


def _sheet(*inked: tuple[int, int, int, int]) -> CleanSheet:
    """Two upright edges 3 px wide and rectangles of ink, from x, y up to x, y."""
    weight = np.zeros((100, 140), np.float32)
    for x in (80, 92):
        weight[10:91, x - 1 : x + 2] = 1.0
    for x0, y0, x1, y1 in inked:
        weight[y0 : y1 + 1, x0 : x1 + 1] = 1.0
    return CleanSheet(weight > 0.5, weight, STROKE, 0.0)


def _ended(sheet: CleanSheet, *others: Placed, at: float = 80.0, kind: Linetype) -> float:
    pieces = [(LEVEL, Piece(20.0, at, kind, 1.0)), *EDGES, *others]
    found = with_ends_behind_edges(pieces, sheet, RHYTHM)
    assert found[1:] == pieces[1:]
    line, piece = found[0]
    assert (line, piece.start, piece.linetype) == (LEVEL, 20.0, kind)
    return piece.end


@pytest.mark.parametrize(
    ("inked", "end"),
    [
        # The rest of a dash, or the beginning of one, with paper on both sides.
        ((82, 49, 85, 51), 92.0),
        ((86, 49, 90, 51), 92.0),
        # Nothing, a speck, and what lies beside the line or is a blot.
        ((20, 49, 79, 51), 80.0),
        ((86, 50, 86, 50), 80.0),
        ((82, 52, 90, 56), 80.0),
        ((82, 44, 90, 56), 80.0),
    ],
    ids=["rest", "beginning", "blank", "speck", "beside", "blot"],
)
def test_ink_behind_an_edge(inked: tuple[int, int, int, int], end: float) -> None:
    assert _ended(_sheet(inked), kind=Linetype.HIDDEN) == pytest.approx(end, abs=0.25)


def test_visible_lines_end_where_they_do() -> None:
    assert _ended(_sheet((82, 49, 85, 51)), kind=Linetype.VISIBLE) == 80.0


def test_an_end_at_no_edge_stays() -> None:
    assert _ended(_sheet((82, 49, 85, 51)), at=70.0, kind=Linetype.HIDDEN) == 70.0


def test_the_ink_of_another_hidden_line_is_its_own() -> None:
    other: Placed = (LEVEL, Piece(82.0, 92.0, Linetype.HIDDEN, 1.0))
    assert _ended(_sheet((82, 49, 90, 51)), other, kind=Linetype.HIDDEN) == 80.0


def test_where_another_stroke_lies_along_most_of_it_nothing_is_told() -> None:
    sheet = _sheet((82, 49, 90, 51))
    placed: Placed = (Line((84.0, 52.0), (1.0, 0.0)), Piece(0.0, 40.0, Linetype.VISIBLE, 1.0))
    assert _ended(sheet, placed, kind=Linetype.HIDDEN) == 80.0


def test_an_edge_between_two_others_is_no_dash() -> None:
    """Solid for most of a dash and more, as edges are; shorter, dashes are as well."""
    wide: Placed = (Line((104.0, 0.0), (0.0, 1.0)), Piece(10.0, 90.0, Linetype.VISIBLE, 1.0))
    solid = _sheet((82, 49, 90, 51), (94, 49, 102, 51), (103, 10, 105, 90))
    assert _ended(solid, wide, kind=Linetype.HIDDEN) == 80.0
    assert _ended(solid, wide, at=92.0, kind=Linetype.HIDDEN) == 92.0
    partly = _sheet((94, 49, 98, 51), (103, 10, 105, 90))
    assert _ended(partly, wide, at=92.0, kind=Linetype.HIDDEN) == pytest.approx(104.0, abs=0.25)


def test_several_edges_are_passed_one_after_the_other() -> None:
    third: Placed = (Line((104.0, 0.0), (0.0, 1.0)), Piece(10.0, 90.0, Linetype.VISIBLE, 1.0))
    sheet = _sheet((82, 49, 86, 51), (94, 49, 98, 51), (103, 10, 105, 90))
    assert _ended(sheet, third, kind=Linetype.HIDDEN) == pytest.approx(104.0, abs=0.25)


def test_the_next_edge_may_be_round() -> None:
    """As where a cross bore passes the circle of a chamfer: both of its sides end at the outer one,
    each in its own direction."""
    circles = [Circle((60.0, 60.0), 40.0), Circle((60.0, 60.0), 50.0)]
    weight = np.zeros((140, 140), np.float32)
    for circle in circles:
        cv2.circle(weight, (60, 60), int(circle.radius), 1.0, 3)
    weight[12:17, 56:59] = weight[12:17, 62:65] = 1.0
    sheet = CleanSheet(weight > 0.5, weight, STROKE, 0.0)
    rims: list[Placed] = [
        (circle, Piece(0.0, circle.around, Linetype.VISIBLE, 1.0)) for circle in circles
    ]
    inner, outer = (60.0 - np.sqrt(circle.radius**2 - 9.0) for circle in circles)
    sides: list[Placed] = [
        (Line((57.0, 0.0), (0.0, 1.0)), Piece(inner, 60.0, Linetype.HIDDEN, 1.0)),
        (Line((63.0, 0.0), (0.0, -1.0)), Piece(-60.0, -inner, Linetype.HIDDEN, 1.0)),
    ]
    (_, one), (_, other) = with_ends_behind_edges([*sides, *rims], sheet, RHYTHM)[:2]
    assert (one.start, one.end) == (pytest.approx(outer, abs=0.25), 60.0)
    assert (other.start, other.end) == (-60.0, pytest.approx(-outer, abs=0.25))


@pytest.mark.parametrize("first", [29, 31])
def test_the_bore_of_a_chamfered_ring_is_read_through(first: int) -> None:
    """Of the dashes behind the edge of the chamfer 2 px show at both edges, or 4 at one."""
    weight = np.zeros((160, 240), np.float32)
    for x in (20, 150, 162):
        weight[19:122, x - 1 : x + 2] = 1.0
    for y in (20, 120):
        weight[y - 1 : y + 2, 19:164] = 1.0
    for y in (50, 90):
        for x in range(first, 160, 13):
            weight[y : y + 2, x : min(x + 8, 163)] = 1.0
    view = find_shapes(CleanSheet(weight > 0.5, weight, STROKE, 0.0), (0.0, 0.0, 240.0, 160.0))
    rhythm = view_rhythm([view], STROKE)
    strokes = classify_strokes(view, rhythm, view_pens([view], rhythm))
    hidden = [stroke for stroke in strokes if stroke.linetype is Linetype.HIDDEN]
    ends = sorted((*item.start, *item.end) for item in hidden)
    expected = [(20.5, 51.0, 162.5, 51.0), (20.5, 91.0, 162.5, 91.0)]
    assert np.array(ends) == pytest.approx(np.array(expected), abs=0.3)
