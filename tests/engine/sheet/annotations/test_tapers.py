"""Slim arrowheads, and what else widens a line."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.tapers import mark_tapered, tapers
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

WIDTH = 2.5
HEAD = np.array([2.5, 2.5, 2.5, 2.8, 3.2, 3.6, 4.0, 3.8, 2.8, 2.5, 2.5, 2.5, 2.5, 2.5])


def test_a_head_widens_slowly_and_ends_at_once() -> None:
    assert tapers(HEAD, WIDTH) == [6]
    assert tapers(HEAD[::-1], WIDTH) == []


def test_a_head_whose_tip_another_line_hides() -> None:
    assert tapers(np.concatenate([[np.nan] * 3, HEAD[3:]]), WIDTH) == []
    widths = np.concatenate([[np.nan] * 3, np.linspace(3.0, 9.0, 20), np.full(9, WIDTH)])
    assert tapers(widths, WIDTH) == [22]


@pytest.mark.parametrize(
    "widths",
    [
        np.full(30, WIDTH),
        # A blot, as where a line passes by.
        np.array([2.5] * 9 + [2.9, 3.5, 4.0, 3.5, 2.9] + [2.5] * 9),
        # It never ends.
        np.concatenate([HEAD[:7], np.full(20, 4.0)]),
        np.full(30, np.nan),
        # Where a line crosses the width is hardly known.
        np.concatenate([np.full(9, WIDTH), [np.nan] * 3, [4.1], [np.nan] * 3, np.full(9, WIDTH)]),
        # A diagonal ends in a square corner, as those around a chamfered face do.
        np.concatenate([[np.nan] * 3, [4.3, 6.2, 8.2, 10.1], [np.nan] * 2, np.full(35, WIDTH)]),
    ],
)
def test_other_widths_are_no_heads(widths: np.ndarray) -> None:
    assert tapers(widths, WIDTH) == []


def _headed(sketch: Sketch, *tips: tuple[float, float], width: float = WIDTH) -> Sketch:
    """A level line at y = 50 from 20 to 180, with heads at places that point left or right."""
    drawn = sketch().line((20, 50), (180, 50), width)
    rows, columns = np.indices(drawn.weight.shape)
    for tip, way in tips:
        from_tip = way * (tip - columns)
        half = np.where((from_tip >= 0) & (from_tip <= 12), width * from_tip / 12.0, 0.0)
        head = np.clip(half + 0.5 - np.abs(rows - 50), 0.0, 1.0)
        drawn.weight = np.maximum(drawn.weight, np.where(half > 0.0, head, 0.0))
    return drawn


def _marked(drawn: Sketch) -> bool:
    line = InkedShape(Line((0.0, 50.0), (1.0, 0.0)), (InkedRun(Run(20.0, 180.0), WIDTH),))
    kinds: list[list[AnnotationKind | None]] = [[None]]
    mark_tapered([line], kinds, clean_sheet(drawn.grey))
    return kinds == [[AnnotationKind.DIMENSION]]


def test_one_head_at_an_end_tells_a_dimension_line(sketch: Sketch) -> None:
    assert _marked(_headed(sketch, (20, -1)))
    assert _marked(_headed(sketch, (180, 1)))


def test_two_heads_tell_one_anywhere(sketch: Sketch) -> None:
    assert not _marked(_headed(sketch, (90, -1)))
    assert _marked(_headed(sketch, (90, 1), (110, -1)))


def test_slanted_strokes_that_end_on_a_line_are_no_heads(sketch: Sketch) -> None:
    drawn = _headed(sketch)
    for x in (32.0, 60.0, 150.0):
        drawn.line((x, 50), (x + 30, 20), WIDTH)
    assert not _marked(drawn)


def test_an_edge_between_others_is_none(sketch: Sketch) -> None:
    drawn = _headed(sketch).line((20, 20), (20, 90), WIDTH).line((180, 20), (180, 90), WIDTH)
    assert not _marked(drawn.line((100, 20), (100, 90), WIDTH))


@pytest.mark.parametrize("end", [20, 180])
def test_an_edge_that_begins_between_two_others_is_none(sketch: Sketch, end: int) -> None:
    """As at a pyramid's corner: their ink is a head's, but they go on."""
    way = 1 if end == 20 else -1
    drawn = _headed(sketch)
    for rise in (-24, 24):
        drawn.line((end, 50), (end + way * 60, 50 + rise), WIDTH)
    assert not _marked(drawn)
    # With one of them alone it is wider on one side.
    assert not _marked(_headed(sketch).line((end, 50), (end + way * 60, 26), WIDTH))
    # Lines farther away leave a head one.
    headed = _headed(sketch, (end, -way))
    for off in (-14, 14):
        headed.line((20, 50 + off), (180, 50 + off), WIDTH)
    assert _marked(headed)
