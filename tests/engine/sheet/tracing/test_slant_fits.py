"""Short lines aslant lie on their own ink, whatever merges at their ends."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.slant_fits import with_fitted_slants
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

VISIBLE = Linetype.VISIBLE


def _walls(left: float, right: float) -> list[tuple[Line, Piece]]:
    return [(Line((x, 0.0), (0.0, 1.0)), Piece(20.0, 120.0, VISIBLE, 1.0)) for x in (left, right)]


@pytest.mark.parametrize("off", [(0.9, -0.4), (-0.7, 0.8), (0.2, 0.2)])
def test_a_line_is_turned_onto_its_ink(sketch: Sketch, off: tuple[float, float]) -> None:
    start, end = np.array([40.3, 60.2]), np.array([53.1, 69.8])
    drawn = sketch().line((40.3, 20), (40.3, 120)).line((53.1, 20), (53.1, 120)).line(start, end)
    way = (end - start) / np.hypot(*(end - start))
    normal = np.array([-way[1], way[0]])
    first, last = start + off[0] * normal, end + off[1] * normal
    turned = (last - first) / np.hypot(*(last - first))
    line = Line(tuple(first), tuple(turned))
    pieces = [
        *_walls(40.3, 53.1),
        (line, Piece(0.0, float(np.hypot(*(last - first))), VISIBLE, 1.0)),
    ]
    fitted = with_fitted_slants(pieces, pieces, clean_sheet(drawn.grey))
    assert fitted[:2] == pieces[:2]
    assert fitted[2][0].distances(np.array([start, end])).max() < 0.12


def test_others_stay_as_they_are(sketch: Sketch) -> None:
    drawn = sketch().line((40, 20), (40, 120)).line((100, 20), (100, 120)).line((40, 40), (100, 90))
    drawn.line((20, 130), (60, 130))
    long = np.hypot(60.0, 50.0)
    pieces = [
        *_walls(40.0, 100.0),
        (Line((40.0, 40.5), (60.0 / long, 50.0 / long)), Piece(0.0, long, VISIBLE, 1.0)),
        (Line((20.0, 130.4), (1.0, 0.0)), Piece(0.0, 20.0, VISIBLE, 1.0)),
        # Where there is no ink of its own nothing tells.
        (Line((60.0, 20.0), (0.8, 0.6)), Piece(0.0, 15.0, VISIBLE, 1.0)),
    ]
    assert with_fitted_slants(pieces, pieces, clean_sheet(drawn.grey)) == pieces


@pytest.mark.parametrize("off", [(0.7, -0.3), (-0.6, 0.6)])
def test_dashes_tell_a_hidden_lines_course(sketch: Sketch, off: tuple[float, float]) -> None:
    # The flank of a bore's tip behind two visible lines.
    start, end = np.array([40.4, 90.7]), np.array([80.4, 50.7])
    drawn = sketch().line((20, 78.2), (140, 78.2)).line((20, 72.9), (140, 72.9))
    drawn.broken(tuple(start), tuple(end), (10.0, 5.5), 2.0).line((80, 50), (120, 90), 2.0)
    way = (end - start) / np.hypot(*(end - start))
    normal = np.array([-way[1], way[0]])
    first, last = start + off[0] * normal, end + off[1] * normal
    long = float(np.hypot(*(last - first)))
    line = Line(tuple(first), tuple((last - first) / long))
    level = [(Line((0.0, y), (1.0, 0.0)), Piece(20.0, 140.0, VISIBLE, 1.0)) for y in (78.2, 72.9)]
    cut = Piece(0.0, 15.0, Linetype.HIDDEN, 0.8), Piece(20.0, long, Linetype.HIDDEN, 0.8)
    pieces = [*level, *((line, item) for item in cut)]
    fitted = with_fitted_slants(pieces, pieces, clean_sheet(drawn.grey))
    assert fitted[:2] == pieces[:2]
    assert [item[1] for item in fitted[2:]] == list(cut)
    assert fitted[2][0] == fitted[3][0]
    assert fitted[2][0].distances(np.array([start, end])).max() < 0.15


@pytest.mark.parametrize("foot", [61.6, 63.2, 65.7])
def test_the_foot_of_a_cone_between_two_walls_is_exact(sketch: Sketch, foot: float) -> None:
    # A shaft's flange, the 45 degrees of its chamfer, and the shaft.
    high, wall, shaft, step = 20.0, 50.0, 130.0, 12.3
    top = foot - step
    drawn = sketch(160, 200)
    for y, way in ((0.0, 1.0), (199.0, -1.0)):
        rim, neck, side = y + way * high, y + way * foot, y + way * top
        drawn.lines((20.0, rim), (wall, rim))
        drawn.lines((wall, neck), (wall + step, side), (shaft, side))
    for x, y in ((20.0, high), (wall, high), (wall + step, top), (shaft, top)):
        drawn.line((x, y), (x, 199.0 - y))
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, (18.0, 18.0, 132.0, 181.0))
    strokes = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    slants = [
        np.array([stroke.start, stroke.end]) - 0.5
        for stroke in strokes
        if isinstance(stroke, Segment)
        and abs(stroke.end[0] - stroke.start[0]) > 5.0 < abs(stroke.end[1] - stroke.start[1])
    ]
    assert len(slants) == 2
    for ends in slants:
        inner, outer = ends[np.argsort(ends[:, 0])]
        assert min(abs(inner[1] - foot), abs(199.0 - inner[1] - foot)) < 0.2
        assert min(abs(outer[1] - top), abs(199.0 - outer[1] - top)) < 0.2
