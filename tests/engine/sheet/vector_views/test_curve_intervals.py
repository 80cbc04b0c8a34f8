"""Stretches of lines and circles."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.vector_views.curve_intervals import Span, united, without

AROUND = 100.0
SPANS = st.lists(
    st.tuples(st.integers(0, 99), st.integers(1, 100)).map(
        lambda item: (float(item[0]), float(item[0] + item[1]))
    ),
    max_size=6,
)


def covered(spans: list[Span]) -> set[int]:
    """Numbers of the unit steps of a circle that are covered."""
    return {step % 100 for start, end in spans for step in range(int(start), int(end))}


@given(SPANS)
def test_united_stretches_cover_the_same_and_lie_apart(spans: list[Span]) -> None:
    found = united(spans, AROUND)
    assert covered(found) == covered(spans)
    assert sum(end - start for start, end in found) == len(covered(spans))
    assert all(0.0 <= start < AROUND for start, _ in found)


@given(SPANS, SPANS)
def test_what_is_taken_off_is_gone_and_nothing_else(spans: list[Span], taken: list[Span]) -> None:
    found = without(spans, taken, AROUND)
    assert covered(found) == covered(spans) - covered(taken)
    assert sum(end - start for start, end in found) == len(covered(found))


def test_a_whole_turn_stays_whole_and_gaps_within_the_slack_close() -> None:
    assert united([(30.0, 130.0)], AROUND) == [(0.0, 100.0)]
    assert united([(0.0, 10.0), (10.5, 20.0)], slack=0.5) == [(0.0, 20.0)]
    assert united([(0.0, 10.0), (10.6, 20.0)], slack=0.5) == [(0.0, 10.0), (10.6, 20.0)]
    assert united([(90.0, 110.0), (12.0, 20.0)], AROUND, 2.0) == [(90.0, 120.0)]
    assert without([(0.0, 10.0)], [(1.0, 9.9)], least=0.5) == [(0.0, 1.0)]
    assert united([], np.inf) == []
    assert united([(95.0, 105.0)], AROUND) == [(95.0, 105.0)]
