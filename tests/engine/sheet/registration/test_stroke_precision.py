"""How exactly strokes are known follows from the grid to which their file was rounded."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.registration.stroke_precision import (
    COARSE_PX,
    FROM_PIXELS,
    FROM_VECTORS,
    StrokesSource,
    precision_of,
    tolerance_px,
)

VECTOR, RASTER = StrokesSource.VECTOR, StrokesSource.RASTER


def test_exact_files_are_known_exactly_and_pictures_to_pixels() -> None:
    assert precision_of(VECTOR, 0.0) == FROM_VECTORS
    assert precision_of(RASTER, 0.0) == FROM_PIXELS
    assert (tolerance_px(VECTOR, 0.0), tolerance_px(RASTER, 0.0)) == (0.05, 1.0)


@given(step=st.floats(0.0, 0.7), finer=st.floats(0.0, 1.0))
def test_a_coarser_grid_is_known_no_better(step: float, finer: float) -> None:
    item, better = precision_of(VECTOR, step), precision_of(VECTOR, finer * step)
    for name in ("noise", "level", "ends"):
        assert getattr(item, name) >= getattr(better, name)
    for name in ("apart", "reach", "finest"):
        assert getattr(item.limits, name) >= getattr(better.limits, name)
    assert tolerance_px(VECTOR, step) >= tolerance_px(VECTOR, finer * step)
    assert item.limits.reach <= FROM_PIXELS.limits.reach


@given(step=st.floats(0.02, 0.7))
def test_what_was_rounded_twice_may_be_one_and_two_steps_are_two(step: float) -> None:
    precision = precision_of(VECTOR, step)
    # Two ends of a level line, and one coordinate in two views, lie up to a step apart.
    assert step <= precision.level < 2.0 * step
    assert step <= precision.limits.apart < 2.0 * step
    assert step <= precision.limits.reach
    assert tolerance_px(VECTOR, step) >= step


@pytest.mark.parametrize("step", [COARSE_PX, 0.5, 0.67])
def test_a_grid_as_coarse_as_pixels_is_known_as_a_picture_is(step: float) -> None:
    assert tolerance_px(VECTOR, step) == tolerance_px(RASTER, 0.0)
