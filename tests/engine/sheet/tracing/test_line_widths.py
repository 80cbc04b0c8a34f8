"""What the width of a line tells of its linetype."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run
from gaussiancad_core.sheet.tracing.line_widths import (
    Pens,
    learn_pens,
    run_width,
)

Sketch = Any
"""The class that the fixture gives."""

VISIBLE, HIDDEN = Linetype
RHYTHM = Rhythm(12.0, 6.0)
LEVEL = Line((0.0, 60.0), (1.0, 0.0))
PENS = Pens(2.3, 2.7)


def _runs(length: float, width: float, count: int) -> list[tuple[Run, float]]:
    return [(Run(0.0, length), width + 0.02 * (k % 3 - 1)) for k in range(count)]


def test_two_pens_are_learnt() -> None:
    pens = learn_pens([[run] for run in _runs(100.0, 3.0, 5) + _runs(12.0, 2.0, 9)], RHYTHM)
    assert pens.distinct
    kinds = [pens.kind(width) for width in (1.9, 2.2, 2.5, 2.8, 3.2)]
    assert kinds == [HIDDEN, HIDDEN, None, VISIBLE, VISIBLE]


def test_short_edges_as_long_as_dashes_are_none() -> None:
    edges = [[run] for run in _runs(100.0, 3.0, 5) + _runs(12.0, 3.0, 9)]
    dashed = [(Run(18.0 * k, 18.0 * k + 12.0), 2.0) for k in range(6)]
    assert not learn_pens(edges, RHYTHM).distinct
    pens = learn_pens([*edges, dashed], RHYTHM)
    assert pens.kind(2.0) is HIDDEN
    assert pens.kind(3.0) is VISIBLE


@pytest.mark.parametrize(
    "runs",
    [
        # One pen for both; too few dashes; a sheet whose widths overlap.
        [*_runs(100.0, 3.0, 5), *_runs(12.0, 2.9, 9)],
        [*_runs(100.0, 3.0, 5), *_runs(12.0, 2.0, 3)],
        [*_runs(100.0, 3.0, 4), *_runs(100.0, 1.9, 4), *_runs(12.0, 2.0, 9)],
    ],
)
def test_nothing_is_learnt_where_nothing_tells(runs: list[tuple[Run, float]]) -> None:
    pens = learn_pens([[run] for run in runs], RHYTHM)
    assert not pens.distinct
    assert {pens.kind(width) for width in (0.5, 2.0, 3.0, 9.0)} == {None}


@pytest.mark.parametrize("shares", [(1.0, 1.0), (0.25, 1.0, 0.5), (0.5, 1.0, 0.5), (0.15, 1, 0.85)])
def test_the_palest_ink_counts_where_a_pen_is_told(shares: tuple[float, ...]) -> None:
    """Shares of ink of the rows of pixels that a line lies on, as renderers leave them."""
    grey = np.full((120, 200), 255, np.uint8)
    for row, share in enumerate(shares, start=60):
        grey[row, 20:150] = round(255 * (1.0 - share))
    middle = 60.0 + float(np.dot(np.arange(len(shares)), shares)) / sum(shares)
    line, run = Line((0.0, middle), (1.0, 0.0)), Run(25.0, 145.0)
    width = run_width(clean_sheet(grey), line, run, edges=True)
    assert width == pytest.approx(sum(shares), abs=0.06)
