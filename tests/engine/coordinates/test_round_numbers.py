"""Few measures of a part that most likely are round."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.grid_fitting import Roughness
from gaussiancad_core.coordinates.round_numbers import round_numbers
from gaussiancad_core.model.axes import Axis

_ROUGH = Roughness(tolerance=0.1, noise=0.004, millimetre=1.0)
"""Ten pixels a millimetre, which is a unit."""


def _rod(radius: float, flat: float, high: float) -> tuple[np.ndarray, dict, list]:
    """A rod of 100 mm with a flat that ends at a height."""
    numbers = [0.0, flat, 2.0 * radius, 0.0, 2.0 * radius, 0.0, high, 100.0, radius, radius, radius]
    values = {Axis.X: [0, 1, 2], Axis.Y: [3, 4], Axis.Z: [5, 6, 7]}
    return np.array(numbers), values, [(Axis.Z, 8, 9, 10)]


def test_measures_a_fraction_of_a_pixel_beside_round_ones_become_these() -> None:
    numbers, values, circles = _rod(10.006, 14.985, 40.02)
    found = round_numbers(numbers, values, circles, _ROUGH)
    assert found is not None
    meant, _, _ = _rod(10.0, 15.0, 40.0)
    assert found.numbers == pytest.approx(meant, abs=1e-12)
    assert 0.0 < found.moved < 0.02
    assert (found.factors[meant % 100.0 > 0.0] > 1.0).all()
    # What the scale is known by, and where coordinates begin, is no likelier than before.
    assert (found.factors[meant % 100.0 == 0.0] == 1.0).all()


def test_measures_in_inches_stay() -> None:
    assert round_numbers(*_rod(9.525, 14.2875, 40.02), _ROUGH) is None


def test_half_a_pixel_beside_is_another_measure() -> None:
    numbers, values, circles = _rod(10.0, 14.95, 40.0)
    found = round_numbers(numbers, values, circles, _ROUGH)
    assert found is None or found.numbers[1] == 14.95


def test_nothing_is_round_where_the_scale_is_not_known_or_pixels_are_large() -> None:
    rod = _rod(10.006, 14.985, 40.02)
    assert round_numbers(*rod, Roughness(0.1, 0.004)) is None
    assert round_numbers(*rod, Roughness(tolerance=5.0, noise=0.2, millimetre=1.0)) is None


@given(st.floats(3.0, 40.0), st.floats(1.0, 70.0), st.floats(1.0, 99.0))
def test_no_measure_moves_by_more_than_a_quarter_of_a_pixel(
    radius: float, flat: float, high: float
) -> None:
    numbers, values, circles = _rod(radius, flat, high)
    found = round_numbers(numbers, values, circles, _ROUGH)
    if found is not None:
        moved = np.abs(np.array(found.numbers) - numbers)
        assert moved.max() <= 0.25 * _ROUGH.tolerance + 1e-12
        assert (moved[found.factors == 1.0] == 0.0).all()
