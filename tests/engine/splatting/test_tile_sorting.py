"""Order by depth, and the lists of the tiles."""

import numpy as np
import numpy.typing as npt
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gaussiancad_core.splatting.tile_sorting import depth_order

# Every float32 but -0.0, which bits tell from 0.0 and comparison does not.
DEPTHS = st.floats(width=32, allow_nan=False).map(lambda depth: depth + 0.0)


@given(arrays(np.float32, st.tuples(st.just(2), st.integers(0, 60)), elements=DEPTHS))
def test_order_is_that_of_a_stable_sort(depths: npt.NDArray[np.float32]) -> None:
    expected = np.argsort(depths, axis=1, kind="stable")
    assert np.array_equal(depth_order(depths), expected)
    assert np.array_equal(depth_order(depths.astype(np.float64)), expected)
