"""Square corners that look like a small arc."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.square_corners import has_square_corner
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes

Sketch = Any
"""The class that the fixture gives."""

PEN = 2.4


def _slot(sketch: Sketch, apart: float, x: float, pen: float) -> Sketch:
    """Two parallel lines that a short one joins at their end, in an outline that one lies on."""
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20), width=pen)
    drawn.line((20, 120.2), (300, 120.2), pen)
    return drawn.lines((20, 120.2 + apart), (x, 120.2 + apart), (x, 120.2), width=pen)


@pytest.mark.parametrize(
    ("apart", "x", "pen"),
    [(7.4, 160.6, 2.4), (7.4, 160.3, 2.0), (7.8, 160.0, 2.0), (7.8, 160.3, 2.8)],
)
def test_the_end_of_a_slot_is_no_half_circle(
    sketch: Sketch, apart: float, x: float, pen: float
) -> None:
    drawn = _slot(sketch, apart, x, pen)
    sheet = clean_sheet(drawn.grey)
    circle = Circle((x - apart / 2 - 0.5, 120.2 + apart / 2 - 0.5), apart / 2)
    half = Piece(-0.5 * np.pi * circle.radius, 0.5 * np.pi * circle.radius, Linetype.HIDDEN, 1.0)
    assert has_square_corner(circle, half, sheet)
    view = find_shapes(sheet, (18.0, 18.0, 302.0, 222.0))
    read = classify_strokes(view, Rhythm(14.0, 8.0))
    assert not any(isinstance(stroke, Arc) for stroke in read)
    upright = [
        stroke
        for stroke in read
        if isinstance(stroke, Segment) and abs(stroke.length - apart) < 1.0
    ]
    assert len(upright) == 1


@pytest.mark.parametrize("radius", [4.0, 6.0])
def test_a_half_circle_has_no_square_corner(sketch: Sketch, radius: float) -> None:
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20), width=PEN)
    drawn.line((20, 120.2), (160, 120.2), PEN)
    drawn.line((20, 120.2 + 2 * radius), (160, 120.2 + 2 * radius), PEN)
    angles = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 60)
    x, y = 160.0 + radius * np.cos(angles), 120.2 + radius + radius * np.sin(angles)
    drawn.lines(*zip(x.tolist(), y.tolist(), strict=True), width=PEN)
    circle = Circle((159.5, 119.7 + radius), radius)
    half = Piece(-0.5 * np.pi * radius, 0.5 * np.pi * radius, Linetype.VISIBLE, 1.0)
    assert not has_square_corner(circle, half, clean_sheet(drawn.grey))
