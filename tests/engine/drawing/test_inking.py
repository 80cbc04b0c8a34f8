import itertools
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Rhythm
from gaussiancad_core.drawing.inking import (
    GAP,
    LONG,
    SHORT,
    ink_annotations,
    long_short_intervals,
)
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.model.views import Linetype, Segment

STYLE = SheetStyle(width=200, height=100)
LINE = Segment((20.0, 50.3), (180.0, 50.3), Linetype.VISIBLE)
MARK = Annotation(AnnotationKind.CENTRE_LINE, 1, (LINE,), 2.0)


@given(st.floats(1.0, 2000.0), st.floats(0.5, 6.0))
def test_centre_lines_begin_end_and_cross_in_long_dashes(length: float, width: float) -> None:
    intervals = long_short_intervals(length, width)
    dashes = np.array([high - low for low, high in intervals])
    gaps = np.array([b[0] - a[1] for a, b in itertools.pairwise(intervals)])
    assert (intervals[0][0], intervals[-1][1]) == pytest.approx((0.0, length))
    # Long and short in turn, an odd number of them with a long one in the middle.
    assert len(intervals) % 4 == 1
    assert dashes[::2] / dashes[1] == pytest.approx(LONG / SHORT)
    assert gaps / dashes[1] == pytest.approx(GAP / SHORT)
    low, high = intervals[len(intervals) // 2]
    assert (low + high) / 2.0 == pytest.approx(length / 2.0)


@given(st.floats(200.0, 2000.0), st.floats(0.5, 3.0))
def test_long_lines_keep_the_rhythm_nearly(length: float, width: float) -> None:
    low, high = long_short_intervals(length, width)[0]
    assert (high - low) / width == pytest.approx(LONG, rel=0.4)


def test_a_continuous_line_has_its_width_and_its_ends() -> None:
    ink = ink_annotations((MARK,), STYLE)
    assert ink.sum() == pytest.approx(2.0 * 160.0, rel=1e-4)
    assert ink[:, 100] @ (np.arange(100) + 0.5) / ink[:, 100].sum() == pytest.approx(50.3, abs=1e-3)


def test_a_centre_line_has_the_gaps_of_its_rhythm() -> None:
    ink = ink_annotations((replace(MARK, rhythm=Rhythm.LONG_SHORT),), STYLE)
    length = sum(high - low for low, high in long_short_intervals(160.0, 2.0))
    assert ink.sum() == pytest.approx(2.0 * length, rel=1e-3)
    assert ink[50].min() == 0.0


@given(st.floats(0.0, 6.28), st.floats(-0.5, 0.5))
def test_an_arrowhead_covers_its_area_where_it_is(angle: float, shift: float) -> None:
    way, side = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    tip = np.array([100.0 + shift, 50.0 - shift])
    corners = np.array([tip, tip - 24.0 * way + 8.0 * side, tip - 24.0 * way - 8.0 * side])
    for points in (corners, corners[::-1]):
        arrow = Annotation(
            AnnotationKind.DIMENSION, 1, arrows=(tuple(map(tuple, points.tolist())),)
        )
        ink = ink_annotations((arrow,), STYLE).astype(np.float64)
        assert ink.sum() == pytest.approx(24.0 * 8.0, rel=0.03)
        x, y = np.meshgrid(np.arange(200) + 0.5, np.arange(100) + 0.5)
        centre = np.array([(ink * x).sum(), (ink * y).sum()]) / ink.sum()
        np.testing.assert_allclose(centre, corners.mean(axis=0), atol=0.15)


def test_without_grey_edges_everything_is_ink_or_paper() -> None:
    ink = ink_annotations((MARK,), replace(STYLE, antialiasing=False))
    assert set(np.unique(ink)) == {0.0, 1.0}


def test_arrowheads_beyond_the_sheet_are_cut_off() -> None:
    outside = Annotation(
        AnnotationKind.LEADER, 1, arrows=(((-50.0, 0.0), (-40.0, 4.0), (-40.0, -4.0)),)
    )
    assert ink_annotations((outside,), STYLE).sum() == 0.0
