"""Runs of ink: dashes on edges, and those that other strokes cover."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import (
    Piece,
    Rhythm,
    Run,
    bridged,
    ink_field,
    labelled_rhythm,
    line_runs,
    with_dashes_led_to,
)

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


def test_the_last_dashes_of_an_arc_are_its_own_where_it_leads_to_them(sketch: Sketch) -> None:
    """They hardly bend; beyond position 0 others follow them, and far away none does."""
    circle = Circle((100.0, 80.0), 60.0)
    period = 17.0 / circle.radius
    drawn = sketch()
    for k in (-7, -6, -5, *range(-2, 6)):
        drawn.arc(circle.centre, circle.radius, 2.3, k * period, 11.0 / circle.radius)
    around = circle.around
    first = Piece(0.0, 28.0, Linetype.HIDDEN, 1.0)
    most = Piece(51.0, 96.0, Linetype.HIDDEN, 1.0)
    far = Piece(around - 119.0, around - 74.0, Linetype.HIDDEN, 1.0)
    last = Piece(around - 34.0, around - 23.0, Linetype.HIDDEN, 1.0)
    pieces = [first, most, far, last]
    field = ink_field(clean_sheet(drawn.grey))
    found = with_dashes_led_to(field, circle, pieces, [most], Rhythm(11.0, 6.0))
    assert found == [first, most, last]


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
    assert labelled_rhythm([runs], 2.0) == (Rhythm(10.0, gap) if gap else None)
