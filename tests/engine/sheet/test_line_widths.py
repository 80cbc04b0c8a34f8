"""What the width of a line tells of its linetype."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.line_widths import (
    Pens,
    learn_pens,
    run_width,
    told_by_width,
    widths_along,
)
from gaussiancad_core.sheet.linetypes import classify
from gaussiancad_core.sheet.runs import Rhythm, Run
from gaussiancad_core.views import Linetype

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
    assert pens.told
    kinds = [pens.kind(width) for width in (1.9, 2.2, 2.5, 2.8, 3.2)]
    assert kinds == [HIDDEN, HIDDEN, None, VISIBLE, VISIBLE]


def test_short_edges_as_long_as_dashes_are_none() -> None:
    edges = [[run] for run in _runs(100.0, 3.0, 5) + _runs(12.0, 3.0, 9)]
    dashed = [(Run(18.0 * k, 18.0 * k + 12.0), 2.0) for k in range(6)]
    assert not learn_pens(edges, RHYTHM).told
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
    assert not pens.told
    assert {pens.kind(width) for width in (0.5, 2.0, 3.0, 9.0)} == {None}


@pytest.mark.parametrize("place", [60.5, 81.0, 120.25])
def test_a_run_is_cut_where_the_pen_changes(sketch: Sketch, place: float) -> None:
    drawn = sketch().line((20, 60), (place, 60), 3.0)
    sheet = clean_sheet(drawn.line((place, 60), (150, 60), 2.0).grey)
    told = told_by_width(sheet, LEVEL, [Run(20.0, 150.0)], PENS)
    assert [kind for _, kind in told] == [VISIBLE, HIDDEN]
    first, second = (run for run, _ in told)
    assert (first.start, second.end) == (20.0, 150.0)
    assert first.end == second.start == pytest.approx(place, abs=2.0)


def test_crossings_do_not_cut(sketch: Sketch) -> None:
    drawn = sketch().line((20, 60), (150, 60), 2.0)
    for x in (50, 57, 100):
        drawn.line((x, 20), (x, 100), 3.0)
    sheet = clean_sheet(drawn.grey)
    run = Run(22.0, 147.0)
    assert told_by_width(sheet, LEVEL, [run], PENS) == [(run, HIDDEN)]
    widths = widths_along(sheet, LEVEL, run)
    assert len(widths) == 126
    assert np.nanmedian(widths) == pytest.approx(2.0, abs=0.2)


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


def test_the_last_pixels_do_not_tell_a_long_run(sketch: Sketch) -> None:
    """All but its end merges with what lies beside it."""
    drawn = sketch().line((20, 60), (144, 60), 3.0).line((144, 60), (150, 60), 2.0)
    drawn.line((20, 63), (146, 63), 3.0)
    run = Run(20.0, 150.0)
    assert told_by_width(clean_sheet(drawn.grey), LEVEL, [run], PENS) == [(run, None)]


def test_nothing_is_cut_where_no_pen_is_told_to_change(sketch: Sketch) -> None:
    """Wider by what two slanted lines leave beside it, and in between neither pen's."""
    drawn = sketch().line((20, 60), (150, 60), 2.5).line((50, 60), (80, 130), 2.5)
    sheet = clean_sheet(drawn.line((120, 60), (90, 130), 2.5).line((60, 60), (100, 60), 3.0).grey)
    run = Run(22.0, 147.0)
    assert told_by_width(sheet, LEVEL, [run], PENS) == [(run, VISIBLE)]


def test_the_pen_tells_what_dashes_do_not() -> None:
    """A dash long, between two other strokes: a hidden edge, or a short visible one."""
    touches = [(True, True)]
    for kind in Linetype:
        found = classify([Run(0.0, 12.0)], RHYTHM, touches, told=[kind])
        assert [(piece.linetype, piece.confidence) for piece in found] == [(kind, 0.8)]
    # Wide dashes in a row are two hidden lines side by side.
    row = [Run(18.0 * k, 18.0 * k + 12.0) for k in range(4)]
    found = classify(row, RHYTHM, [(False, False)] * 4, told=[VISIBLE] * 4)
    assert [piece.linetype for piece in found] == [HIDDEN]
    # Wide ink that goes on narrow is visible up to there.
    row = [Run(0.0, 9.0), Run(9.0, 21.0), Run(27.0, 39.0)]
    found = classify(row, RHYTHM, [(True, False)] * 3, told=[VISIBLE, HIDDEN, HIDDEN])
    assert [piece.linetype for piece in found] == [VISIBLE, HIDDEN]
    assert (found[0].end, found[1].start) == (9.0, 9.0)
