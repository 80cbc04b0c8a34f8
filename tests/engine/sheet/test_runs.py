"""Dashes that other strokes cover belong to their curve, where enough of it shows."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle
from gaussiancad_core.sheet.runs import Piece, Rhythm, bridged, ink_field
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
