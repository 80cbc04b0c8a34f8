"""Dashes that a slanted line only seems to have."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.tracing.borrowed_dashes import unshared_runs
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run

RHYTHM, WIDTH = Rhythm(10.0, 6.0), 4.0
LEVEL = Line((0.0, 50.0), (1.0, 0.0))
DASHES = [Run(16.0 * k, 16.0 * k + 10.0) for k in range(8)]
SLANTED = Line((69.0, 50.0), (float(np.cos(0.2)), float(np.sin(0.2))))
"""Crosses the middle of the fifth dash."""
OWN = Run(-200.0, -60.0)


def _kept(*runs: Run, line: Line = SLANTED, dashes: list[Run] = DASHES) -> list[Run]:
    lines = [(LEVEL, dashes), (line, list(runs))]
    return unshared_runs(line, runs, lines, RHYTHM, WIDTH)


def test_a_dash_that_is_crossed_far_beyond_the_end_of_a_line_is_not_its_own() -> None:
    crossed = Run(-5.0, 5.0)
    assert _kept(OWN, crossed) == [OWN]
    # So is the corner of the next one, which is just touched.
    assert _kept(OWN, crossed, Run(12.0, 13.5)) == [OWN]
    # The line from which it is taken keeps it.
    lines = [(LEVEL, DASHES), (SLANTED, [OWN, crossed])]
    assert unshared_runs(LEVEL, DASHES, lines, RHYTHM, WIDTH) == DASHES


@pytest.mark.parametrize(
    "runs",
    [
        (Run(-5.0, 5.0),),  # all that there is of the line
        (Run(-200.0, -10.0), Run(-5.0, 5.0)),  # it goes on from what it has
        tuple(Run(16.0 * k - 5.0, 16.0 * k + 5.0) for k in range(-6, 6)),  # a dashed line itself
        (OWN, Run(35.0, 45.0)),  # beside all dashes
        (OWN, Run(-30.0, 40.0)),  # longer than what it crosses
    ],
)
def test_what_a_line_has_itself_stays(runs: tuple[Run, ...]) -> None:
    assert _kept(*runs) == list(runs)


def test_ink_that_no_row_of_dashes_has_stays() -> None:
    runs = [OWN, Run(-5.0, 5.0)]
    assert _kept(*runs, dashes=[Run(-40.0, 120.0)]) == runs
    alone = [Run(64.0, 74.0), *(Run(150.0 + 40.0 * k, 160.0 + 40.0 * k) for k in range(4))]
    assert all(b.start - a.end > RHYTHM.gap for a, b in pairwise(alone))
    assert _kept(*runs, dashes=alone) == runs


@pytest.mark.parametrize("angle", [0.03, 1.2])
def test_lines_that_are_nearly_one_or_clearly_cross_take_nothing(angle: float) -> None:
    line = Line((69.0, 50.0), (float(np.cos(angle)), float(np.sin(angle))))
    runs = [OWN, Run(-5.0, 5.0)]
    assert _kept(*runs, line=line) == runs


def test_circles_keep_their_ink() -> None:
    circle = Circle((50.0, 50.0), 20.0)
    assert unshared_runs(circle, DASHES, [(LEVEL, DASHES)], RHYTHM, WIDTH) == DASHES
