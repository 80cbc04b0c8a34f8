"""Runs of ink: dashes on edges, and those that other strokes cover."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import (
    Piece,
    Rhythm,
    Run,
    bridged,
    ink_field,
    line_runs,
    told_rhythm,
)
from gaussiancad_core.views import Linetype

Sketch = Any
"""The class that the fixture gives."""


@pytest.mark.parametrize(("share", "closes"), [(0.4, False), (0.6, True)])
def test_one_dash_closes_no_circle(sketch: Sketch, share: float, closes: bool) -> None:
    """All of the circle is ink, but of the rest of it that may be of others."""
    circle = Circle((60.0, 60.0), 7.5)
    field = ink_field(clean_sheet(sketch(120, 120).arc(circle.centre, circle.radius).grey))
    piece = Piece(3.0, 3.0 + share * circle.around, Linetype.HIDDEN, 1.0)
    (found,) = bridged(field, circle, [piece], Rhythm(9.0, 6.0))
    turn = (found.end - found.start) / circle.around
    assert turn == pytest.approx(1.0 if closes else share, abs=1e-9)
    assert np.isclose(found.start, 3.0)


@pytest.mark.parametrize("length", [6, 3])
def test_a_short_wide_dash_that_begins_on_an_edge_is_one(length: int) -> None:
    """Pale dashes, half as wide as they are long, on an edge of five px; less is a blot."""
    grey = np.full((60, 160), 255, np.uint8)
    grey[:, 20:24] = 0
    grey[:, [19, 24]] = 127
    for start, end in [(24, 25 + length), *((at, at + 9) for at in range(29 + length, 150, 13))]:
        grey[28:33, start:end] = np.minimum(grey[28:33, start:end], 140)
        grey[[28, 32], start:end] = np.minimum(grey[[28, 32], start:end], 197)
    field = ink_field(clean_sheet(grey))
    runs = line_runs(field, Line((0.0, 30.0), (1.0, 0.0)), 0.0, 159.0)
    assert (runs[0].start < 29.0) == (length == 6)


@pytest.mark.parametrize("gap", [0.0, 4.0])
def test_runs_that_touch_are_no_dashes(gap: float) -> None:
    """They were cut where the pen changes."""
    runs = [Run(k * (10.0 + gap), k * (10.0 + gap) + 10.0) for k in range(6)]
    assert told_rhythm([runs], 2.0) == (Rhythm(10.0, gap) if gap else None)
