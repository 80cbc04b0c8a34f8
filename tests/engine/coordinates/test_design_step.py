"""Steps that parts were designed in."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.design_step import NominalStep, designed_scale, nominal_step
from gaussiancad_core.model.projection_planes import UNITS

_PIXEL = UNITS / 900.0
"""Units of a px, of a part that is 900 px long."""

_MM = UNITS / 66.0
"""Units of a millimetre, of a part that is 66 mm long."""


@given(
    steps=st.sets(st.integers(1, 59), min_size=11, max_size=20),
    off=st.sampled_from([0.05, 0.25, 0.5]),
    seed=st.integers(0, 1000),
)
def test_coordinates_on_a_step_become_its_multiples(steps: set[int], off: float, seed: int) -> None:
    """However they were rounded, on parts of 60 steps of 15 px."""
    length = UNITS / 60.0
    aside = np.random.default_rng(seed).uniform(-off, off, len(steps)) * _PIXEL
    found = nominal_step(list(np.array(sorted(steps)) * length + aside), _PIXEL, _MM)
    assert found is not None
    # Steps that are multiples of it fit some sets of coordinates as well.
    assert found.length / length == pytest.approx(round(found.length / length))
    for step, away in zip(sorted(steps), aside, strict=True):
        stated = found.multiple(step * length + away)
        assert stated is None or stated == pytest.approx(step * length)


@given(count=st.integers(1, 25), seed=st.integers(0, 10000), coarse=st.booleans())
def test_random_coordinates_tell_no_step(count: int, seed: int, coarse: bool) -> None:
    numbers = np.random.default_rng(seed).uniform(0.0, UNITS, count)
    assert nominal_step(list(numbers), _PIXEL * (1.0 + coarse), _MM) is None


def test_exact_drawings_are_not_taken_for_rough_ones() -> None:
    """A hole half a pixel off the step is there on purpose where all else is on it."""
    length = UNITS / 60.0
    numbers = [length * k for k in (3, 7, 12, 19, 22, 31, 40, 44, 51, 58)]
    found = nominal_step([*numbers, 26.0 * length + 0.5 * _PIXEL], _PIXEL, _MM)
    assert found is not None and found.length == pytest.approx(length)
    assert found.multiple(26.0 * length + 0.5 * _PIXEL) is None


@pytest.mark.parametrize(
    ("scale", "found"), [(1.0, True), (1.037, False)], ids=["round", "of-no-known-scale"]
)
def test_few_coordinates_tell_a_round_step(scale: float, found: bool) -> None:
    numbers = [number * _MM for number in (6.02, 30.0, 40.02, 48.01, 59.99)]
    step = nominal_step(numbers, _PIXEL, scale * _MM)
    assert (step is not None) == found
    if step is not None:
        assert step.length == pytest.approx(2.0 * _MM)


def test_a_step_tells_what_is_odd_and_how_far_numbers_were_moved() -> None:
    step = NominalStep(10.0, 0.5)
    assert step.moving([20.1, 29.8, 44.0]).moved == pytest.approx(0.2)
    assert step.moving([20.1]).moving([30.3, 7.0]).moving([40.2]).moved == pytest.approx(0.3)
    # 66.7 is 33.3 from the other end of 100; 33.4 is the same coordinate again.
    assert step.odd([0.0, 33.3, 33.4, 40.0, 66.7, 100.0], 100.0) == 1
    assert step.odd([0.0, 33.3, 66.7, 71.0, 100.0], 100.0) == 2
    assert step.odd([33.3, 66.7], 0.0) == 2


def test_a_told_extent_is_what_it_was_told_where_another_one_is_longest() -> None:
    """A cube of 7 mm: one edge was told, another one read a tenth of a pixel too long."""
    read = 7.0 * 1.0002
    scale = UNITS / read
    step = NominalStep(UNITS / 14.0, 0.05)
    found = designed_scale(step, (7.0 * scale, 7.0), scale)
    assert step.length / found == pytest.approx(0.5, abs=1e-12)
    # Where the longest one was told, that is so at once.
    assert designed_scale(step, (UNITS, read), scale) == pytest.approx(scale, abs=1e-12)
    # An extent of no whole steps tells nothing of them.
    assert designed_scale(step, (6.8 * scale, 6.8), scale) == scale
    assert designed_scale(None, (7.0 * scale, 7.0), scale) == scale
