"""Dots between the dashes of a centre line, and what is none."""

from typing import Any

import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.short_dashes import with_dots
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Run

Sketch = Any
"""The class that the fixture gives."""

LEVEL = Line((0.0, 59.5), (1.0, 0.0))
DASHES = [Run(20.0, 40.0), Run(54.0, 74.0)]


def _found(drawn: Sketch) -> list[Run]:
    for run in DASHES:
        drawn.line((run.start + 0.5, 60.0), (run.end + 0.5, 60.0), 2.0)
    # Another stroke tells how dark ink is.
    sheet = clean_sheet(drawn.line((20, 120), (180, 120), 3.0).grey)
    return with_dots(sheet.weight, 2.5, LEVEL, DASHES)


@pytest.mark.parametrize("length", [1.0, 2.0, 3.0, 4.0, 5.0])
@pytest.mark.parametrize("off", [-1.5, 0.0, 1.0])
def test_a_dot_in_the_gap_is_a_run(sketch: Sketch, length: float, off: float) -> None:
    middle = 47.5 + off
    drawn = sketch().line((middle - length / 2, 60.0), (middle + length / 2, 60.0), 2.0)
    found = _found(drawn)
    assert [found[0], found[2]] == DASHES
    assert (found[1].start + found[1].end) / 2 == pytest.approx(47.0 + off, abs=0.5)


def test_a_gap_alone_stays_one(sketch: Sketch) -> None:
    assert _found(sketch()) == DASHES


def test_a_line_that_crosses_the_gap_is_no_dot(sketch: Sketch) -> None:
    for end in (64.0, 80.0):
        assert _found(sketch().line((47.5, 120.0 - end), (47.5, end), 2.0)) == DASHES


def test_a_speck_beside_the_middle_is_no_dot(sketch: Sketch) -> None:
    assert _found(sketch().line((43.5, 60.0), (44.0, 60.0), 2.0)) == DASHES


def test_two_dots_are_none(sketch: Sketch) -> None:
    """A phantom line's pair of short dashes says something else."""
    drawn = sketch().line((44.5, 60.0), (45.0, 60.0), 1.0).line((50.0, 60.0), (50.5, 60.0), 1.0)
    assert _found(drawn) == DASHES
