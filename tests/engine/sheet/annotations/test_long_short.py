"""Centre lines by their rhythm."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.drawing.inking import long_short_intervals
from gaussiancad_core.sheet.annotations.long_short import is_long_short, long_short_span
from gaussiancad_core.sheet.runs import Run


def _runs(lengths: list[float], gap: float) -> list[Run]:
    """Dashes of some lengths; a negative one is a gap."""
    runs, at = [], 0.0
    for length in lengths:
        if length > 0:
            runs.append(Run(at, at + length))
            at += gap
        at += abs(length)
    return runs


@pytest.mark.parametrize(
    ("lengths", "expected"),
    [
        ([40, 6, 40], True),
        ([40, 6, 40, 6, 40], True),
        ([24, 6, 24, 6, 24, 6, 24], True),
        # Cut off at an end by an edge that it meets.
        ([15, 6, 40, 6, 40], True),
        ([6, 40, 6, 40, 6], True),
        ([40, 6, 40, 6], True),
        # A crossing joined two pieces in the middle.
        ([40, 6, 40, 6, 90, 6, 40, 6, 40], True),
        # Two centre lines, one after the other, joined where they overlap, or with a gap between.
        ([19, 4.5, 19, 28, 18.5, 4, 19], True),
        ([19, 4.5, 19, 19, 4, 19], True),
        # Of other lengths, or at uneven gaps, these are pieces of dashes.
        ([19, 3, 19, 28, 18.5, 7, 19], False),
        ([19, 4.5, -6, 19, 28, 18.5, 4, 19], False),
        # A dashed circle that another one crosses twice.
        ([11, 3.5, 11, 10.5, 10.5, 10.5, 11, 3.5, 11], False),
        ([12, 12, 12, 12], False),
        ([12, 11, 13, 12, 12.5], False),
        # A dashed line whose last dash is short, or its first and its last.
        ([12, 12, 12, 5], False),
        ([5, 12, 12, 12, 5], False),
        # An edge in three pieces, the middle one not much shorter.
        ([60, 40, 60], False),
        # Edges and the dashes of a hidden line between them.
        ([80, 12, 12, 12, 12, 80], False),
        ([100, 12, 12, 12], False),
        ([12, 12, 100, 12, 12], False),
        ([40, 6], False),
        ([40], False),
        ([], False),
    ],
)
def test_long_and_short_in_turn(lengths: list[float], expected: bool) -> None:
    assert is_long_short(_runs(lengths, 5.0)) is expected
    assert is_long_short(_runs(lengths[::-1], 5.0)) is expected


@pytest.mark.parametrize(
    ("lengths", "expected"),
    [
        # The second short dash faded: its own length and one more gap are blank.
        ([18, 4, 18, -9, 18], True),
        ([18, 4, 18, -9, 18, 4, 18, -9, 18], True),
        # One was seen, three were not.
        ([18, -9, 18, 4, 18, -9, 18, -9, 18], False),
        # A hidden line, one of whose dashes fell to pieces.
        ([12, 12, 12, 2, 2, 12, 12, 12, 12, 12, 12], False),
        # All of them did: dashes at wide gaps may as well be hidden lines.
        ([18, -9, 18, -9, 18], False),
        # One short dash by chance, and gaps that none would fill.
        ([18, 4, 18, 18, 18], False),
        ([18, 4, 18, -30, 18, -30, 18], False),
    ],
)
def test_short_dashes_that_faded(lengths: list[float], expected: bool) -> None:
    assert is_long_short(_runs(lengths, 5.0)) is expected
    assert is_long_short(_runs(lengths[::-1], 5.0)) is expected


@given(st.floats(60.0, 2000.0), st.floats(0.8, 4.0))
def test_what_the_engine_draws_is_long_short(length: float, width: float) -> None:
    pieces = [Run(low, high) for low, high in long_short_intervals(length, width)]
    assert is_long_short(pieces)


@given(st.integers(3, 40), st.floats(4.0, 40.0), st.data())
def test_even_dashes_never_are(count: int, dash: float, data: st.DataObject) -> None:
    """A fifth longer or shorter."""
    shares = data.draw(st.lists(st.floats(0.8, 1.2), min_size=count, max_size=count))
    assert not is_long_short(_runs([dash * share for share in shares], dash / 2))


def test_a_dash_that_is_cut_counts_once() -> None:
    cut = [Run(0.0, 24.4), Run(37.2, 43.5), Run(46.0, 62.0), Run(74.8, 83.3)]
    assert long_short_span(cut) == (0, 0)
    centre = [Run(0.0, 30.0), Run(42.0, 47.0), Run(59.0, 66.0), Run(68.5, 89.0), Run(101.0, 106.0)]
    assert long_short_span([*centre, Run(118.0, 148.0)]) == (0, 6)
    assert long_short_span(_runs([40, 6, 40], 5.0)) == (0, 3)
