"""Lines two or three pixels beside each other are two; wide ones stay one."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.close_lines import with_close_lines
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

BOX = (18.0, 18.0, 182.0, 142.0)
FRAME = [(20.0, 20.0), (180.0, 20.0), (180.0, 140.0), (20.0, 140.0), (20.0, 20.0)]


def _sheet(drawn: Sketch) -> CleanSheet:
    return clean_sheet(drawn.lines(*FRAME).grey)


def _heights(lines: list[Line], sheet: CleanSheet) -> list[float]:
    """Where the level lines between the frame's sides are, in px."""
    middle = sheet.ink.shape[1] / 2
    level = [line for line in lines if abs(line.direction[0]) > 0.999]
    at = [line.at((middle - line.point[0]) / line.direction[0])[1] for line in level]
    return sorted(y for y in at if 30.0 < y < 130.0)


@pytest.mark.parametrize("apart", [3.2, 3.6, 4.0, 5.0])
@pytest.mark.parametrize("phase", [0.0, 9.0])
def test_dashed_lines_beside_each_other_are_two(sketch: Sketch, apart: float, phase: float) -> None:
    lower = 60.3 + apart
    drawn = sketch().broken((20, 60.3), (180, 60.3), (12, 6))
    sheet = _sheet(drawn.broken((20 + phase, lower), (180, lower), (12, 6)))
    melted = Line((100.0, 60.3 + apart / 2), (1.0, 0.0))
    lines, close = with_close_lines(sheet, [melted])
    found = _heights(lines, sheet)
    assert close == set(lines)
    assert found == pytest.approx([60.3, lower], abs=0.35)


@pytest.mark.parametrize("width", [3.0, 4.5, 6.0])
def test_a_wide_line_stays_one(sketch: Sketch, width: float) -> None:
    sheet = _sheet(sketch().line((20, 60.3), (180, 60.3), width))
    only = [Line((100.0, 60.3), (1.0, 0.0))]
    assert with_close_lines(sheet, only) == (only, set())


def test_single_lines_stay_as_they_are(sketch: Sketch) -> None:
    sheet = _sheet(sketch().line((20, 60), (180, 60)).line((20, 75), (180, 80)))
    lines = [Line((100.0, 60.0), (1.0, 0.0)), Line((100.0, 77.5), (0.9995, 0.0312))]
    assert with_close_lines(sheet, lines) == (lines, set())


def _hidden(sheet: CleanSheet) -> list[Segment]:
    shapes = find_shapes(sheet, BOX)
    rhythm = view_rhythm([shapes], sheet.stroke_width)
    strokes = classify_strokes(shapes, rhythm, view_pens([shapes], rhythm))
    assert sum(stroke.linetype is Linetype.VISIBLE for stroke in strokes) == len(FRAME) - 1
    return [stroke for stroke in strokes if stroke.linetype is Linetype.HIDDEN]


def test_both_come_out_as_whole_strokes(sketch: Sketch) -> None:
    drawn = sketch().broken((20, 60), (180, 60), (12, 6)).broken((20, 63.6), (180, 63.6), (12, 6))
    found = _hidden(_sheet(drawn))
    found = sorted(found, key=lambda stroke: stroke.start[1])
    ends = [np.sort([stroke.start, stroke.end], axis=0).ravel() for stroke in found]
    wanted = [[20.5, y, 180.5, y] for y in (60.5, 64.1)]
    assert np.array(ends) == pytest.approx(np.array(wanted), abs=0.4)


def test_dashes_that_fill_each_others_gaps_are_hidden(sketch: Sketch) -> None:
    """They leave no gap; their pen tells."""
    drawn = sketch().broken((20, 60), (180, 60), (12, 6)).broken((29, 60.6), (180, 60.6), (12, 6))
    for y in (40, 90):
        drawn.broken((20, y), (180, y), (12, 6))
    for y in (75, 105, 120):
        drawn.line((20, y), (180, y))
    sheet = _sheet(drawn)
    shapes = find_shapes(sheet, BOX)
    rhythm = view_rhythm([shapes], sheet.stroke_width)
    strokes = classify_strokes(shapes, rhythm, view_pens([shapes], rhythm))
    hidden = sorted(s.start[1] for s in strokes if s.linetype is Linetype.HIDDEN)
    assert hidden == pytest.approx([40.5, 60.8, 90.5], abs=0.3)
    assert len(strokes) == len(FRAME) - 1 + 3 + 3


@pytest.mark.parametrize("rise", [20.0, 30.0])
def test_a_line_across_dashes_at_a_flat_angle_joins_none(sketch: Sketch, rise: float) -> None:
    drawn = sketch().broken((20, 80), (180, 80), (12, 6))
    sheet = _sheet(drawn.line((20, 80 - rise), (180, 80 + rise)))
    shapes = find_shapes(sheet, BOX)
    rhythm = view_rhythm([shapes], sheet.stroke_width)
    strokes = classify_strokes(shapes, rhythm, view_pens([shapes], rhythm))
    hidden = [stroke for stroke in strokes if stroke.linetype is Linetype.HIDDEN]
    assert [stroke.length for stroke in hidden] == [pytest.approx(160.0, abs=1.0)]
    assert len(strokes) == len(FRAME) - 1 + 2
