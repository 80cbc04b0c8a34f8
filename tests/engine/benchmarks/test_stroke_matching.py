"""The measure of ``python -m benchmarks pictures``, on drawings whose agreement is known."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.judge.stroke_matching import match
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.views import Arc, Linetype, Segment

VISIBLE, HIDDEN = Linetype
DRAWN = [
    Segment((0.0, 0.0), (100.0, 0.0), VISIBLE),
    Segment((100.0, 0.0), (100.0, 60.0), VISIBLE),
    Arc((50.0, 30.0), 20.0, 0.0, 2.0 * np.pi, VISIBLE),
    Segment((20.0, 0.0), (20.0, 60.0), HIDDEN),
]


def test_what_is_read_as_drawn_agrees_in_full() -> None:
    lengths, errors = match(DRAWN, DRAWN, 1.5)
    assert lengths[VISIBLE].drawn == pytest.approx(160.0 + 40.0 * np.pi, rel=1e-3)
    assert lengths[HIDDEN].read == pytest.approx(60.0)
    for kind in Linetype:
        assert (lengths[kind].precision, lengths[kind].recall) == (1.0, 1.0)
    assert errors.max() == 0.0


@pytest.mark.parametrize(("shift", "found"), [(0.3, 1.0), (0.95, 1.0), (1.1, 0.0)])
def test_the_error_is_the_distance_across_the_stroke(shift: float, found: float) -> None:
    line = DRAWN[0]
    moved = line.mapped(Similarity(offset=(0.2, shift)))
    lengths, errors = match([line], [moved], 1.5)
    # Of a shift along the line nothing is seen but at its ends.
    assert lengths[VISIBLE].recall == pytest.approx(found, abs=0.01)
    assert lengths[VISIBLE].precision == pytest.approx(found, abs=0.01)
    np.testing.assert_allclose(errors, shift, atol=1e-12)


def test_lengths_that_are_missing_and_too_much_are_told_apart() -> None:
    line = Segment((0.0, 0.0), (100.0, 0.0), VISIBLE)
    read = Segment((50.0, 0.0), (130.0, 0.0), VISIBLE)
    lengths, _ = match([line], [read], 1.5)
    # An end counts as far as a stroke is within a pixel.
    assert lengths[VISIBLE].recall == pytest.approx(0.51, abs=0.01)
    assert lengths[VISIBLE].precision == pytest.approx(51.0 / 80.0, abs=0.01)


def test_the_wrong_linetype_is_wrong_both_ways() -> None:
    line = Segment((0.0, 0.0), (100.0, 0.0), VISIBLE)
    lengths, _ = match([line], [replace(line, linetype=HIDDEN)], 1.5)
    assert (lengths[VISIBLE].recall, lengths[HIDDEN].precision) == (0.0, 0.0)
    assert (lengths[VISIBLE].precision, lengths[HIDDEN].recall) == (1.0, 1.0)


def test_crossing_strokes_do_not_stand_for_each_other() -> None:
    line = Segment((0.0, 0.0), (100.0, 0.0), VISIBLE)
    across = Segment((50.0, -1.0), (50.0, 1.0), VISIBLE)
    lengths, _ = match([line], [across], 1.5)
    assert (lengths[VISIBLE].recall, lengths[VISIBLE].precision) == (0.0, 0.0)


def test_hidden_lines_under_visible_ones_do_not_count() -> None:
    line = Segment((0.0, 0.0), (100.0, 0.0), VISIBLE)
    under = Segment((0.0, 1.2), (100.0, 1.2), HIDDEN)
    for seen in ([line], [line, under]):
        lengths, _ = match([line, under], seen, 1.5)
        assert (lengths[HIDDEN].recall, lengths[HIDDEN].precision) == (1.0, 1.0)
        assert lengths[HIDDEN].drawn == 0.0
    # But one that was never drawn is wrong.
    lengths, _ = match([line], [line, under], 1.5)
    assert lengths[HIDDEN].precision == 0.0
