"""Dashes that are all too wide for one line are two lines'."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.twin_lines import with_twins
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = (12.0, 6.0)
BOX = (20.0, 20.0, 300.0, 220.0)


def _plate(sketch: Sketch) -> Sketch:
    """An outline with two hidden lines, which tell the pen."""
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20))
    return drawn.broken((22, 50), (298, 50), RHYTHM).broken((22, 190), (298, 190), RHYTHM)


def _levels(drawn: Sketch) -> list[float]:
    """y of the hidden lines of a sheet, px; centres of pixels at integers."""
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, BOX)
    rhythm = view_rhythm([view], sheet.stroke_width)
    (view,) = with_twins([view], rhythm)
    strokes = classify_strokes(view, rhythm)
    ends = [stroke.sample(1e9)[[0, -1]] for stroke in strokes if stroke.linetype is Linetype.HIDDEN]
    return sorted(float(points[:, 1].mean()) - 0.5 for points in ends if np.ptp(points[:, 0]) > 200)


@pytest.mark.parametrize("apart", [1.2, 1.6, 2.0])
def test_two_lines_whose_dashes_melt(sketch: Sketch, apart: float) -> None:
    drawn = _plate(sketch)
    for y in (120.0 - apart / 2.0, 120.0 + apart / 2.0):
        drawn.broken((22, y), (298, y), RHYTHM)
    found = _levels(drawn)
    true = [50.0, 120.0 - apart / 2.0, 120.0 + apart / 2.0, 190.0]
    assert found == pytest.approx(true, abs=0.2)


@pytest.mark.parametrize("pen", [1.4, 2.0, 2.6, 3.2])
@pytest.mark.parametrize("share", [1.1, 1.3, 1.5, 1.7, 1.9, 2.1, 2.4])
def test_two_lines_with_little_paper_between(sketch: Sketch, pen: float, share: float) -> None:
    """Lines are grown along both, but not where they lie, or along one of them only."""
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20))
    true = [50.0, 70.0, 90.0, 120.0 - share * pen / 2.0, 120.0 + share * pen / 2.0, 190.0]
    for y in true:
        drawn.broken((22, y), (298, y), RHYTHM, pen)
    assert _levels(drawn) == pytest.approx(true, abs=0.25)


@pytest.mark.parametrize("apart", [3.0, 3.2, 3.4])
def test_two_lines_beside_an_edge(sketch: Sketch, apart: float) -> None:
    """It is near one of them, so that only the other one's dashes are measured."""
    drawn = _plate(sketch)
    true = [50.0, 70.0, 90.0, 120.0 - apart / 2.0, 120.0 + apart / 2.0, 190.0]
    for y in true[1:-1]:
        drawn.broken((22, y), (298, y), RHYTHM)
    drawn.line((20.0, true[4] + 8.0), (300.0, true[4] + 8.0))
    assert _levels(drawn) == pytest.approx(true, abs=0.2)


@pytest.mark.parametrize("apart", [2.6, 3.0, 3.4])
def test_of_two_lines_the_longer_one_goes_on(sketch: Sketch, apart: float) -> None:
    drawn = _plate(sketch).broken((22, 70), (298, 70), RHYTHM).broken((22, 90), (298, 90), RHYTHM)
    drawn.broken((22, 120), (298, 120), RHYTHM)
    drawn.broken((22, 120 + apart), (140, 120 + apart), RHYTHM)
    assert _levels(drawn) == pytest.approx([50.0, 70.0, 90.0, 120.0, 190.0], abs=0.3)


def test_one_line_with_a_wider_pen_dash_is_one(sketch: Sketch) -> None:
    """Ink that ran, of some dashes: they are not wider by as much along all of the line."""
    drawn = _plate(sketch).broken((22, 120), (298, 120), RHYTHM)
    for x in (22.0, 94.0, 166.0):
        drawn.line((x, 120.8), (x + 12.0, 120.8), 2.0)
    assert len(_levels(drawn)) == 3


def test_where_pens_differ_no_line_is_two(sketch: Sketch) -> None:
    """Without a width that most dashes have, one wide line says nothing."""
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20))
    for k, width in enumerate((1.4, 2.0, 2.8, 3.6)):
        drawn.broken((22, 50 + 40 * k), (298, 50 + 40 * k), RHYTHM, width)
    assert len(_levels(drawn)) == 4


def test_a_line_that_is_visible_in_its_middle_is_one(sketch: Sketch) -> None:
    """A wide pen where it is visible, a narrow one where it is hidden."""
    drawn = _plate(sketch).broken((22, 120), (298, 120), RHYTHM)
    drawn.line((94, 120.4), (202, 120.4), 3.0)
    assert _visible(drawn) == 5


def _visible(drawn: Sketch) -> int:
    """How many visible lines are read."""
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, BOX)
    rhythm = view_rhythm([view], sheet.stroke_width)
    views = with_twins([view], rhythm)
    strokes = classify_strokes(views[0], rhythm, view_pens(views, rhythm))
    return sum(stroke.linetype is Linetype.VISIBLE for stroke in strokes)
