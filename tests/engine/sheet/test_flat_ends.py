"""Rounded corners with a short straight piece between them, and half circles without one."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.strokes import classify_strokes
from gaussiancad_core.sheet.view_shapes import find_shapes, view_rhythm
from gaussiancad_core.views import Arc, Segment, Stroke

Sketch = Any
"""The class that the fixture gives."""

_PEN = 2.7
_LEFT, _UPPER, _LOWER = 60.3, 40.4, 150.2


def _read(sketch: Sketch, radius: float, flat: float) -> list[Stroke]:
    """A bar with a rounded end."""
    right = _LEFT + 2.0 * radius + flat
    y = _UPPER + radius
    drawn = sketch(220, 180)
    drawn.lines((_LEFT, y), (_LEFT, _LOWER), (right, _LOWER), (right, y), width=_PEN)
    drawn.arc((_LEFT + radius, y), radius, _PEN, np.pi, np.pi / 2.0)
    drawn.arc((right - radius, y), radius, _PEN, 1.5 * np.pi, np.pi / 2.0)
    if flat:
        drawn.line((_LEFT + radius, _UPPER), (right - radius, _UPPER), _PEN)
    sheet = clean_sheet(drawn.grey)
    shapes = find_shapes(sheet, (_LEFT - 2.0, _UPPER - 2.0, right + 2.0, _LOWER + 2.0))
    return list(classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width)))


@pytest.mark.parametrize("flat", [4.4, 5.2])
@pytest.mark.parametrize("radius", [30.2, 40.9, 48.3])
def test_a_short_flat_between_two_arcs(sketch: Sketch, radius: float, flat: float) -> None:
    found = _read(sketch, radius, flat)
    arcs = [own for own in found if isinstance(own, Arc)]
    assert [own.radius for own in arcs] == [pytest.approx(radius, abs=0.25)] * 2
    lengths = sorted(own.length for own in found if isinstance(own, Segment))
    assert lengths[0] == pytest.approx(flat, abs=0.6)
    assert len(lengths) == 4


@pytest.mark.parametrize("radius", [20.4, 30.2, 40.9])
def test_a_half_circle_has_none(sketch: Sketch, radius: float) -> None:
    found = _read(sketch, radius, 0.0)
    assert len([own for own in found if isinstance(own, Arc)]) == 1
    assert len(found) == 4
