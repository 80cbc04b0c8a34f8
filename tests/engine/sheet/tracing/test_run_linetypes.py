"""Runs of ink that are dashes, one, several or parts of two, and those that are edges."""

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run
from gaussiancad_core.sheet.tracing.run_linetypes import classify


def _row(*lengths: float) -> list[Run]:
    """Runs and gaps in turn."""
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    return [Run(a, b) for a, b in zip(ends[::2], ends[1::2], strict=False)]


@pytest.mark.parametrize(
    ("lengths", "hidden"),
    [
        # Dashes of 12 with gaps of 6; one edge ends 9 before the next begins.
        ((12, 6, 12, 6, 21, 6, 12, 6, 12), True),
        ((12, 6, 12, 6, 26, 6, 12, 6, 12), True),
        ((12, 6, 12, 6, 40, 6, 12, 6, 12), False),
        ((12, 6, 12, 1, 24, 1, 12, 6, 12), False),
        ((27, 6, 12, 6, 12), False),
        # A gap that another stroke fills: the dashes beyond are in step.
        ((12, 6, 12, 6, 30, 6, 12, 6, 12), True),
        ((12, 6, 12, 6, 34, 6, 12, 6, 12), False),
    ],
)
def test_dashes_of_two_edges_that_meet_are_hidden(lengths: tuple[float, ...], hidden: bool) -> None:
    runs = _row(*lengths)
    found = classify(runs, Rhythm(12.0, 6.0), [(False, False)] * len(runs))
    assert (len(found) == 1) == hidden
    assert any(piece.linetype is Linetype.VISIBLE for piece in found) != hidden
    assert (found[0].start, found[-1].end) == (0.0, sum(lengths))


def test_a_dashed_circle_may_end_on_its_first_dash() -> None:
    around = 138.0
    runs = [Run(at, at + 12.0) for at in np.arange(4.0, 112.0, 18.0)]
    runs.append(Run(112.0, 136.0))
    found = classify(runs, Rhythm(12.0, 6.0), [(False, False)] * len(runs), around)
    assert {piece.linetype for piece in found} == {Linetype.HIDDEN}


def test_where_a_dashed_circle_closes_its_ends_blur() -> None:
    """Two whole dashes and the ink beyond their ends; the next gap is short, the rhythm out."""
    runs = [Run(24.0 * k, 24.0 * k + 15.5) for k in range(8)] + [Run(192.0, 226.5)]
    found = classify(runs, Rhythm(15.5, 8.5), [(False, False)] * len(runs), 232.0)
    assert {piece.linetype for piece in found} == {Linetype.HIDDEN}


def test_a_lone_piece_of_a_small_circle_stays_as_short_as_it_is() -> None:
    run = Run(2.0, 18.0)
    (found,) = classify([run], Rhythm(19.0, 10.0), [(False, True)], 31.8)
    assert (found.start, found.end) == (2.0, 18.0)


@pytest.mark.parametrize(("touches", "hidden"), [(False, True), (True, False)])
def test_an_edge_ends_at_another_stroke_and_dashes_of_a_tangent_do_not(
    touches: bool, hidden: bool
) -> None:
    """A hidden line begins with a dash where the last one of its rounding ends."""
    runs = _row(23, 6, 12, 6, 12, 6, 12)
    found = classify(runs, Rhythm(12.0, 6.0), [(touches, False)] + [(False, False)] * 3)
    assert (found[0].linetype is Linetype.HIDDEN) == hidden
    assert (found[0].end == 77.0) == hidden


@pytest.mark.parametrize(
    ("first", "around", "hidden"),
    [(25.0, 400.0, True), (29.0, 400.0, False), (25.0, float("inf"), False)],
)
def test_an_arc_begins_with_the_dash_of_its_tangent_and_the_ink_beyond(
    first: float, around: float, hidden: bool
) -> None:
    runs = _row(first, 6, 12, 6, 12, 6, 12)
    found = classify(runs, Rhythm(12.0, 6.0), [(False, False)] * 4, around)
    assert (found[0].linetype is Linetype.HIDDEN) == hidden
