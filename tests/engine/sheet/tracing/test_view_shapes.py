"""Curves that ink follows in all but what tangents and crossings make of it."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing import view_shapes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes

Sketch = Any
"""The class that the fixture gives."""

WIDTH = 5.0
RADIUS = 55.0


def _corner(sketch: Sketch) -> Sketch:
    """A rounded corner of a plate, left and below, as far as its edges go on straight."""
    drawn = sketch(300, 300).line((40, 20), (40, 260 - RADIUS), WIDTH)
    drawn.line((40 + RADIUS, 260), (280, 260), WIDTH)
    return drawn.arc((40 + RADIUS, 260 - RADIUS), RADIUS, WIDTH, np.pi / 2, np.pi / 2)


def _circles(drawn: Sketch) -> list[Circle]:
    shapes = find_shapes(clean_sheet(drawn.grey), (10.0, 10.0, 290.0, 290.0))
    return [shape.geometry for shape in shapes.shapes if isinstance(shape.geometry, Circle)]


@pytest.mark.parametrize("left", [0.0, 12.0, 18.0])
def test_a_rounding_at_which_lines_were_erased(sketch: Sketch, left: float) -> None:
    """What is left of extension lines that touched it is beside the arc at both of its ends."""
    drawn = _corner(sketch)
    if left:
        drawn.line((40 + RADIUS, 260), (40 + RADIUS - left, 260), WIDTH)
        drawn.line((40, 260 - RADIUS), (40, 260 - RADIUS + left), WIDTH)
    circles = _circles(drawn)
    assert len(circles) == 1
    assert circles[0].radius == pytest.approx(RADIUS, abs=3.5)


def test_a_sharp_corner_is_no_arc(sketch: Sketch) -> None:
    drawn = sketch(300, 300).line((40, 20), (40, 262), WIDTH).line((38, 260), (280, 260), WIDTH)
    assert not _circles(drawn)


@pytest.mark.parametrize("cut", [20.0, 40.0, 60.0])
def test_a_chamfer_is_no_arc(sketch: Sketch, cut: float) -> None:
    drawn = sketch(300, 300).lines(
        (40, 20), (40, 260 - cut), (40 + cut, 260), (280, 260), width=WIDTH
    )
    assert not _circles(drawn)


def test_more_lines_than_any_part_has_are_refused_before_they_are_looked_at(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    picture = np.full((120, 120), 255, np.uint8)
    for at in (20, 50, 80):
        picture[at : at + 3, 10:110] = 0
    sheet = clean_sheet(picture)
    monkeypatch.setattr(view_shapes, "_MOST_LINES", 3)
    assert len(find_shapes(sheet, (0.0, 0.0, 120.0, 120.0)).shapes) == 3
    monkeypatch.setattr(view_shapes, "_MOST_LINES", 2)
    with pytest.raises(NoModelError) as caught:
        find_shapes(sheet, (0.0, 0.0, 120.0, 120.0))
    assert caught.value.code == "part-too-complex"
