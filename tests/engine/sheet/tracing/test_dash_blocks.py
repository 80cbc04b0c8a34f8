"""Blocks of two hidden lines' dashes are a row, however square they are."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.dash_blocks import with_dash_blocks
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.twin_lines import with_twins
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = (9.0, 7.0)
BOX = (20.0, 20.0, 400.0, 300.0)
PEN = 3.3


def _plate(sketch: Sketch, middle: float, apart: float) -> Sketch:
    """An outline, two hidden lines that tell the pen, and two beside each other."""
    drawn = sketch(420, 320).lines((20, 20), (400, 20), (400, 300), (20, 300), (20, 20), width=PEN)
    levels = 60.0, 250.0, middle - apart / 2.0, middle + apart / 2.0
    for y in levels:
        drawn.broken((22, y), (398, y), RHYTHM, PEN)
    return drawn


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize(
    ("middle", "apart"), [(150.0, 3.0), (150.0, 3.3), (150.3, 3.5), (150.5, 3.5), (150.3, 3.8)]
)
def test_two_lines_are_laid_through_a_row_of_blocks(
    sketch: Sketch, middle: float, apart: float, upright: bool
) -> None:
    grey = _plate(sketch, middle, apart).grey
    box = (BOX[1], BOX[0], BOX[3], BOX[2]) if upright else BOX
    sheet = clean_sheet(np.ascontiguousarray(grey.T) if upright else grey)
    view = find_shapes(sheet, box)
    rhythm = view_rhythm([view], sheet.stroke_width)
    (view,) = with_twins(with_dash_blocks([view], rhythm), rhythm)
    strokes = classify_strokes(view, rhythm)
    ends = [stroke.sample(1e9)[[0, -1]] for stroke in strokes if stroke.linetype is Linetype.HIDDEN]
    assert len(ends) == 4
    across = 0 if upright else 1
    levels = sorted(float(points[:, across].mean()) - 0.5 for points in ends)
    true = [60.0, middle - apart / 2.0, middle + apart / 2.0, 250.0]
    assert levels == pytest.approx(true, abs=0.15)
    assert max(float(np.ptp(points[:, across])) for points in ends) < 0.05


def test_dashes_of_single_lines_stay_as_they_were_read(sketch: Sketch) -> None:
    """Also where the pen is half as wide as a dash is long."""
    drawn = sketch(420, 320).lines((20, 20), (400, 20), (400, 300), (20, 300), (20, 20), width=PEN)
    for y in (60.0, 150.3, 250.0):
        drawn.broken((22, y), (398, y), (8.0, 5.0), 4.0)
    view = find_shapes(clean_sheet(drawn.grey), BOX)
    rhythm = view_rhythm([view], PEN)
    (same,) = with_dash_blocks([view], rhythm)
    assert [id(shape) for shape in same.shapes] == [id(shape) for shape in view.shapes]
    assert sum(isinstance(shape.geometry, Line) for shape in same.shapes) == 7
