"""Extension lines that go on from edges which pass into roundings leave nothing beside these."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.clean import clean_sheet

Sketch = Any
"""The class that the fixture gives."""


def _plate(sketch: Sketch, radius: float, width: float) -> Sketch:
    """A plate with two rounded upper corners."""
    drawn = sketch(400, 320)
    low, high, top = 80.3, 320.3, 90.6
    drawn.line((low, 280.0), (high, 280.0), width)
    drawn.line((low + radius, top), (high - radius, top), width)
    for x, way in ((low, 1.0), (high, -1.0)):
        drawn.line((x, 280.0), (x, top + radius), width)
        start = np.pi if way > 0.0 else 1.5 * np.pi
        drawn.arc((x + way * radius, top + radius), radius, width, start, 0.5 * np.pi)
    return drawn


@pytest.mark.parametrize(("radius", "width"), [(60.0, 3.0), (110.0, 4.0), (90.0, 2.0)])
def test_nothing_is_left_beside_a_rounding(sketch: Sketch, radius: float, width: float) -> None:
    plain = _plate(sketch, radius, width)
    drawn = _plate(sketch, radius, width)
    for x in (80.3, 320.3):
        drawn.line((x, 280.0), (x, 20.0), 0.5 * width)
    drawn.line((80.3, 30.0), (320.3, 30.0), 0.5 * width)
    separated = separate_annotations(clean_sheet(drawn.grey))
    assert separated.by_weight
    left, wanted = separated.part.weight, plain.weight
    # A few px at either corner, where the two can hardly be told apart.
    assert ((left > 0.5) & (wanted < 0.2)).sum() <= 12
    assert ((left < 0.5) & (wanted > 0.8)).sum() == 0
