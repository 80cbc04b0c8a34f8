"""A sheet with a pictorial alone is told as that, and no other sheet is."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.drawn_sheet import part_lines
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.recognition.sheet_views import sheet_views
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from sample_parts import sample


def _refusal(grey: np.ndarray) -> NoModelError:
    image = SheetImage(Path("sheet.png"), grey, "")
    with pytest.raises(NoModelError) as caught:
        sheet_views(OpenedSheet(image))
    return caught.value


def _pictured(part: str) -> np.ndarray:
    """The isometric picture of a part, px, in the middle of a sheet."""
    lines = part_lines(sample(part).build(), (Role.FRONT, Role.TOP), picture=True)
    points = [item.sample(0.25) for item in lines.picture if item.linetype is Linetype.VISIBLE]
    low, high = np.concatenate(points).min(axis=0), np.concatenate(points).max(axis=0)
    scale = 600.0 / float((high - low).max())
    grey = np.full((1100, 1500), 255, np.uint8)
    for point in points:
        places = (point - (low + high) / 2.0) * scale * (1.0, -1.0) + (750.0, 550.0)
        cv2.polylines(grey, [np.rint(places * 8.0).astype(np.int32)], False, 0, 3, cv2.LINE_AA, 3)
    return grey


def test_a_pictorial_alone_is_told_as_that() -> None:
    error = _refusal(_pictured("boss-plate"))
    assert error.code == "pictorial-alone"
    ((x0, y0, x1, y1),) = error.message.boxes
    assert x0 < 750.0 < x1 and y0 < 550.0 < y1


def test_a_single_view_is_no_pictorial() -> None:
    grey = np.full((1100, 1500), 255, np.uint8)
    cv2.rectangle(grey, (300, 300), (700, 900), 0, 3)
    cv2.line(grey, (500, 300), (500, 900), 0, 3)
    layout = sheet_views(OpenedSheet(SheetImage(Path("sheet.png"), grey, ""))).layout
    assert tuple(layout.boxes) == (Role.FRONT,)
