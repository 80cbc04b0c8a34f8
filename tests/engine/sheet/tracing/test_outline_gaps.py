"""Outlines that faded somewhere are closed, those with a side missing are not."""

from typing import Any

import cv2
import numpy as np
import pytest

from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.registration.view_masks import find_outline

Sketch = Any
"""The class that the fixture gives."""

BOX = (100.0, 80.0, 401.0, 281.0)


def _rectangle(gap: int) -> np.ndarray:
    """A rectangle of lines 3 px wide whose upper side lacks some px."""
    image = np.full((360, 500), 255, np.uint8)
    cv2.rectangle(image, (100, 80), (400, 280), 0, 3)
    if gap:
        image[70:90, 240 : 240 + gap] = 255
    return image


@pytest.mark.parametrize("gap", [0, 2, 5, 9])
def test_a_faded_outline_is_closed(gap: int) -> None:
    outline = find_outline(clean_sheet(_rectangle(gap)), BOX, 2)
    assert outline is not None
    assert outline.mask.sum() / 4 == pytest.approx(300 * 200, rel=0.01)
    assert outline.box == pytest.approx((100.5, 80.5, 400.5, 280.5), abs=0.6)


def test_an_outline_without_a_side_stays_open() -> None:
    assert find_outline(clean_sheet(_rectangle(60)), BOX, 2) is None


@pytest.mark.parametrize("apart", [4.0, 4.5, 5.0, 8.0])
def test_an_edge_close_inside_an_outline_leaves_it_where_it_is(
    sketch: Sketch, apart: float
) -> None:
    """As a narrow chamfer around a shaft; closed gaps must not make one wide line of both."""
    drawn = sketch(300, 300).arc((150, 150), 100, width=2.7).arc((150, 150), 100 - apart, width=2.7)
    outline = find_outline(clean_sheet(drawn.grey), (48.0, 48.0, 253.0, 253.0), 3)
    assert outline is not None
    assert outline.box == pytest.approx((50.5, 50.5, 250.5, 250.5), abs=0.6)


@pytest.mark.parametrize("short", [2.0, 4.0, 6.0])
def test_an_outline_whose_lines_end_short_of_a_corner_is_closed(
    sketch: Sketch, short: float
) -> None:
    """Before the corner a line within the view all but closes what is left of it."""
    drawn = sketch(500, 360).lines((400, 80), (100, 80), (100, 280), (400 - short, 280))
    drawn.line((400, 80), (400, 280 - short)).line((340, 80), (340, 280))
    outline = find_outline(clean_sheet(drawn.grey), BOX, 2)
    assert outline is not None
    assert outline.mask.sum() / 4 == pytest.approx(300 * 200, rel=0.01)
    assert outline.box == pytest.approx((100.5, 80.5, 400.5, 280.5), abs=0.6)


def test_a_thin_profile_is_closed_however_little_of_its_box_it_covers(sketch: Sketch) -> None:
    """As a bent sheet of metal seen from its side."""
    outer = [(100, 80), (400, 80), (400, 280)]
    inner = [(392, 280), (392, 88), (100, 88), (100, 80)]
    drawn = sketch(500, 360).lines(*outer, *inner)
    outline = find_outline(clean_sheet(drawn.grey), BOX, 3)
    assert outline is not None
    assert outline.mask.sum() / 9 == pytest.approx(300 * 8 + 192 * 8, rel=0.05)
    gap = sketch(500, 360).lines(*outer, (370, 280)).lines((340, 88), (100, 88), (100, 80))
    assert find_outline(clean_sheet(gap.grey), BOX, 3) is None
