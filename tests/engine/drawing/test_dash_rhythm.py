import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.drawing.dash_rhythm import dash_intervals

lengths = st.floats(0.5, 3000.0)
dashes = st.floats(3.0, 40.0)


@given(lengths, dashes, st.floats(0.2, 1.0))
def test_an_open_stroke_begins_and_ends_with_a_whole_dash(
    length: float, dash: float, share: float
) -> None:
    found = dash_intervals(length, dash, share * dash, closed=False)
    assert found[0][0] == 0.0
    assert found[-1][1] == pytest.approx(length, rel=1e-12)
    drawn = np.array([high - low for low, high in found])
    np.testing.assert_allclose(drawn, drawn[0], rtol=1e-6)
    holes = np.array([low - high for (_, high), (low, _) in itertools.pairwise(found)])
    assert np.all(holes > 0.0)
    if len(found) > 2:
        np.testing.assert_allclose(holes / drawn[0], share, rtol=1e-6)


@given(st.floats(60.0, 3000.0))
def test_the_rhythm_is_stretched_by_a_quarter_at_most(length: float) -> None:
    found = dash_intervals(length, 12.0, 6.0, closed=False)
    assert 12.0 / 1.25 < found[0][1] < 12.0 * 1.25


@pytest.mark.parametrize("length", [10.0, 15.0, 25.0])
def test_a_short_stroke_shows_two_dashes(length: float) -> None:
    found = dash_intervals(length, 12.0, 6.0, closed=False)
    assert len(found) == 2
    assert found[1][0] - found[0][1] >= min(6.0, length / 3.0) * 0.8


def test_a_tiny_stroke_is_one_dash() -> None:
    assert dash_intervals(4.0, 12.0, 6.0, closed=False) == [(0.0, 4.0)]


@given(st.floats(30.0, 3000.0))
def test_a_closed_stroke_has_a_dash_on_each_quarter(length: float) -> None:
    found = dash_intervals(length, 12.0, 6.0, closed=True)
    assert len(found) % 4 == 0
    middles = np.array([(low + high) / 2.0 for low, high in found])
    quarters = np.arange(4) * length / 4.0
    assert np.abs(middles[:, None] - quarters).min(axis=0).max() < 1e-6 * length
    assert sum(high - low for low, high in found) == pytest.approx(length * 12.0 / 18.0)
