"""Hidden lines are cut where nothing is drawn between two corners, and nowhere else."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.parted_lines import parted_at_corners

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = Rhythm(8.0, 8.0)
LINE = Line((60.0, 0.0), (0.0, 1.0))
WHOLE = LINE, Piece(30.0, 126.0, Linetype.HIDDEN, 0.9)


def _sheet(sketch: Sketch, grey: float, *dashes: tuple[float, float]) -> CleanSheet:
    """Two level lines, and dashes between them that lie on two columns of pixels."""
    drawn = sketch().line((20, 30), (150, 30)).line((20, 126), (150, 126))
    for start, end in dashes:
        drawn.line((60, start), (60, end), 2.0)
    sheet = clean_sheet(drawn.grey)
    column = np.zeros_like(sheet.weight, dtype=bool)
    column[33:125, 58:63] = True
    return replace(sheet, weight=np.where(column, grey * sheet.weight, sheet.weight))


def _levels(*levels: float) -> list:
    line = Piece(20.0, 150.0, Linetype.VISIBLE, 1.0)
    return [(Line((0.0, y), (1.0, 0.0)), line) for y in levels]


@pytest.mark.parametrize("grey", [1.0, 0.45])
def test_even_dashes_are_one_line(sketch: Sketch, grey: float) -> None:
    dashes = [(38.0 + 16.0 * k, 46.0 + 16.0 * k) for k in range(6)]
    pieces = [WHOLE, *_levels(30.0, 126.0)]
    assert parted_at_corners(pieces, _sheet(sketch, grey, *dashes), RHYTHM) == pieces


@pytest.mark.parametrize("grey", [1.0, 0.45])
def test_a_wide_gap_between_two_strokes_parts_it(sketch: Sketch, grey: float) -> None:
    sheet = _sheet(sketch, grey, (38.0, 46.0), (54.0, 62.0), (86.0, 94.0), (102.0, 110.0))
    parted = parted_at_corners([WHOLE, *_levels(30.0, 62.0, 86.0, 126.0)], sheet, RHYTHM)
    ends = [(p.start, p.end) for g, p in parted if g == LINE]
    assert ends == [pytest.approx((30.0, 62.0), abs=1.0), pytest.approx((86.0, 126.0), abs=1.0)]
    # What meets the line at one side of the gap only is no corner of two.
    assert len(parted_at_corners([WHOLE, *_levels(30.0, 62.0, 126.0)], sheet, RHYTHM)) == 4
