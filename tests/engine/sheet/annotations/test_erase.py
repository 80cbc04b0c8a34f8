"""Annotations that meet in the part's ink leave no crumbs there that hide a rounded corner."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.labels.labelled_ink import separate_by_labels
from gaussiancad_core.sheet.labels.labels_network import ink_labels

Sketch = Any
"""The class that the fixture gives."""

LEFT, TOP, RIGHT, BOTTOM = 60.4, 50.2, 340.6, 240.3


@pytest.mark.parametrize(
    ("radius", "wide", "narrow"), [(17.0, 3.0, 1.5), (15.0, 4.0, 1.8), (17.0, 4.0, 1.8)]
)
def test_extension_lines_to_a_rounded_corner_leave_it_round(
    sketch: Sketch, read_view: Callable[..., Any], radius: float, wide: float, narrow: float
) -> None:
    """They run through the sharp corner that the part has not, and end in the arc."""
    drawn = sketch(400, 300)
    x, y = LEFT + radius, BOTTOM - radius
    drawn.lines((LEFT, y), (LEFT, TOP), (RIGHT, TOP), (RIGHT, BOTTOM), (x, BOTTOM), width=wide)
    drawn.arc((x, y), radius, wide, np.pi / 2, np.pi / 2)
    drawn.line((LEFT, BOTTOM - radius / 2), (LEFT, 285.0), narrow)
    drawn.line((RIGHT, BOTTOM + 4.0), (RIGHT, 285.0), narrow)
    drawn.line((20.0, BOTTOM), (LEFT + radius / 2, BOTTOM), narrow)
    drawn.line((20.0, TOP), (LEFT - 4.0, TOP), narrow)
    sheet = clean_sheet(drawn.grey)
    part = separate_by_labels(sheet, ink_labels(sheet.picture)).part
    strokes = read_view(part, (LEFT - 2.0, TOP - 2.0, RIGHT + 2.0, BOTTOM + 2.0)).strokes
    (corner,) = (stroke for stroke in strokes if isinstance(stroke, Arc))
    assert corner.radius == pytest.approx(radius, abs=0.6)
    assert (corner.centre[0] - 0.5, corner.centre[1] - 0.5) == pytest.approx((x, y), abs=0.6)
