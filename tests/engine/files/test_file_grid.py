"""The step to which a file's numbers were rounded, told from designs in round measures."""

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.files.file_grid import WrittenPath, line_ends, rounding_step, with_steps
from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment

POINT = 200.0 / 72.0
"""px"""

MILLIMETRE = 200.0 / 25.4
"""px"""


def slanted(lot: np.random.Generator, count: int) -> np.ndarray:
    """(n, 2, 2) units, lines of any length at any angle, as arrow heads and letters are."""
    starts = lot.uniform(0.0, 800.0, size=(count, 1, 2))
    ways = lot.uniform(0.5, 20.0, size=(count, 1, 2)) * lot.choice([-1.0, 1.0], size=(count, 1, 2))
    return np.concatenate([starts, starts + ways], axis=1)


def boxes(corners: Sequence[tuple[float, float, float, float]]) -> np.ndarray:
    """(n, 2, 2) the sides of boxes (x0, y0, x1, y1)."""
    return np.array(
        [
            side
            for x0, y0, x1, y1 in corners
            for side in (
                ((x0, y0), (x1, y0)),
                ((x1, y0), (x1, y1)),
                ((x1, y1), (x0, y1)),
                ((x0, y1), (x0, y0)),
            )
        ]
    )


def design(lot: np.random.Generator, step: float, count: int) -> np.ndarray:
    """Boxes whose corners are multiples of a step."""
    low = lot.integers(0, 400, size=(count, 2))
    size = lot.integers(1, 90, size=(count, 2))
    return boxes((np.concatenate([low, low + size], axis=1) * step).tolist())


@pytest.mark.parametrize("scale", [POINT, 0.06 * POINT, MILLIMETRE, 1.0])
def test_the_step_is_measured_in_the_file_s_own_numbers(scale: float) -> None:
    lot = np.random.default_rng(0)
    found = []
    for _ in range(40):
        step, begin, off = lot.uniform(0.02, 0.65), lot.uniform(), lot.uniform(0.0, 0.2)
        exact = slanted(lot, 60)
        item = step / scale
        rounded = (np.round(exact / item) + begin) * item
        # Some shapes were put on the sheet as they were.
        kept = np.arange(len(exact)) < off * len(exact)
        rounded[kept] = exact[kept]
        # PDFium tells numbers in single precision.
        stated = rounded.astype(np.float32).astype(float)
        found.append(rounding_step(stated, scale) == pytest.approx(step, rel=2e-3))
    assert np.mean(found) >= 0.9


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_exact_lines_have_no_step(seed: int) -> None:
    assert rounding_step(slanted(np.random.default_rng(seed), 60), POINT) == 0.0


@settings(max_examples=10, deadline=None)
@given(step=st.sampled_from([0.1, 0.5, 1.0, 5.0]), seed=st.integers(0, 2**32 - 1))
def test_a_design_in_round_measures_is_rounded_to_nothing(step: float, seed: int) -> None:
    lot = np.random.default_rng(seed)
    assert rounding_step(design(lot, step, 12), MILLIMETRE) == 0.0
    # Views stand anywhere on the sheet.
    views = [design(lot, step, 6) + lot.uniform(0.0, 50.0, size=2) for _ in range(3)]
    assert rounding_step(np.concatenate(views), MILLIMETRE) == 0.0


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_lengths_tell_a_design_whose_views_stand_on_a_fine_grid(seed: int) -> None:
    """At 7.125 px to the millimetre and 60 px between views all places are multiples of 3/8 px."""
    lot = np.random.default_rng(seed)
    neighbour = (
        np.cumsum(lot.integers(40, 90, size=(3, 2)), axis=0) * 7.125 + 60.0 * np.arange(3)[:, None]
    )
    views = [design(lot, 7.125, 4) + item for item in neighbour]
    assert rounding_step(np.concatenate(views), 1.0) == 0.0
    # Lengths that are no multiples of anything longer were rounded.
    plotted = design(lot, 0.375, 12)
    assert rounding_step(plotted, 1.0) == pytest.approx(0.375)


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_slanted_lines_tell_a_fine_design_from_rounding(seed: int) -> None:
    """Twentieths of a millimetre might be a printer's dots; then arrow heads are on them, too."""
    lot = np.random.default_rng(seed)
    item, heads = design(lot, 0.05, 20), slanted(lot, 30)
    dots = np.round(heads / 0.05) * 0.05
    assert rounding_step(np.concatenate([item, heads]), MILLIMETRE) == 0.0
    step = 0.05 * MILLIMETRE
    assert rounding_step(np.concatenate([item, dots]), MILLIMETRE) == pytest.approx(step)
    # Nothing tells: the wider bound is the one that holds.
    assert rounding_step(item, MILLIMETRE) == pytest.approx(step)


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_lines_along_the_axes_must_lie_on_the_grid_as_well(seed: int) -> None:
    """Letters that were drawn on a grid of their own tell nothing of the part."""
    lot = np.random.default_rng(seed)
    letters = np.round(slanted(lot, 30) / 0.1) * 0.1
    part = boxes(np.sort(lot.uniform(0.0, 800.0, size=(40, 4)), axis=1).tolist())
    assert rounding_step(np.concatenate([letters, part]), POINT) == 0.0


@pytest.mark.parametrize(
    ("box", "step"),
    [
        ((10.12, 20.34, 90.56, 60.07), 0.01),
        ((10.1, 20.3, 90.5, 60.7), 0.1),
        ((10.123456, 20.345678, 90.56789, 60.7), 0.0),
        # An inch and more: nobody prints on such a grid.
        ((100.0, 200.0, 900.0, 600.0), 0.0),
    ],
)
def test_the_last_decimal_tells_where_lines_are_few(
    box: tuple[float, float, float, float], step: float
) -> None:
    assert rounding_step(boxes([box]), POINT) == pytest.approx(step * POINT)


@pytest.mark.parametrize("far", [1e5, 1e6, 1e9, 1e15, 1e300])
def test_a_line_or_a_copy_of_the_drawing_far_off_the_sheet_changes_no_step(far: float) -> None:
    lot = np.random.default_rng(0)
    ends = np.round(slanted(lot, 60), 1)
    if far <= 1e6:
        both = np.concatenate([ends, ends + far])
        assert rounding_step(both, POINT) == pytest.approx(0.1 * POINT, rel=1e-6)
    ends[3, 0] = far
    assert rounding_step(ends, POINT) == pytest.approx(0.1 * POINT, rel=1e-6)


def path(ends: np.ndarray, matrix: np.ndarray, *curves: LineSegment | CircularArc) -> WrittenPath:
    strokes = [VectorStroke(curve, 1.0) for curve in curves]
    return WrittenPath(lambda _: strokes, ends, matrix)


def test_strokes_have_the_step_of_the_lines_at_their_scale() -> None:
    lot = np.random.default_rng(7)
    rounded, exact = np.round(slanted(lot, 60)), slanted(lot, 60)
    dots = np.array([[0.06 * POINT, 0.0, 3.1], [0.0, -0.06 * POINT, 900.0]])
    turned = np.array([[0.0, 0.06 * POINT, 40.7], [0.06 * POINT, 0.0, 11.3]])
    plain = np.array([[POINT, 0.0, 0.0], [0.0, -POINT, 900.0]])
    line, circle = (
        LineSegment((0.0, 0.0), (5.0, 1.0)),
        CircularArc((3.0, 4.0), 2.0, 0.0, 2.0 * np.pi),
    )
    nothing = line_ends([])
    # A circle has no line that tells; those that its scale has do.  Chords around the middle of
    # a shape are exact, and were put where the grid let them.
    chords = slanted(lot, 30)
    found = with_steps(
        [
            path(rounded, dots, line),
            path(nothing, turned, circle),
            path(chords, turned, line),
            path(exact, plain, line, line),
        ]
    )
    steps = [stroke.step for stroke in found]
    assert steps[:3] == pytest.approx([0.06 * POINT] * 3)
    assert steps[3:] == [0.0, 0.0]
    assert [stroke.curve for stroke in found] == [line, circle, line, line, line]


def test_of_many_scales_those_with_most_lines_are_measured_the_rest_by_their_decimals() -> None:
    lot = np.random.default_rng(3)
    line = LineSegment((0.0, 0.0), (5.0, 1.0))
    thirds, tenths = [], []
    for number in range(20):
        matrix = np.array([[1.0 + number, 0.0, 0.0], [0.0, 1.0 + number, 0.0]]) / 20.0
        ends = slanted(lot, 60 if number % 2 else 80)
        thirds.append(path(np.round(ends * 3.0) / 3.0, matrix, line))
        tenths.append(path(np.round(ends, 1), matrix, line))
    exact = np.array([(1.0 + number) / 60.0 for number in range(20)])
    found = np.array([stroke.step for stroke in with_steps(thirds)])
    measured = found > 0.0
    assert measured.sum() == 8 and not measured[1::2].any()
    assert found[measured] == pytest.approx(exact[measured], rel=1e-6)
    found = np.array([stroke.step for stroke in with_steps(tenths)])
    fine = 0.3 * exact >= 0.01
    assert found == pytest.approx(np.where(fine, 0.3 * exact, 0.0), rel=1e-6)
