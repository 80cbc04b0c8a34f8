"""One view that the user boxes makes no sheet worse that is read without."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError, UsageError
from gaussiancad_core.model.axes import Role
from gaussiancad_core.recognition.sheet_views import SheetViews, sheet_views
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.reading_options import Box

_VIEW = (300, 200, 700, 500)
_APART = (900, 600, 1150, 800)


def _found(boxes: list[tuple[int, ...]], given: dict[Role, Box]) -> SheetViews:
    grey = np.full((900, 1300), 255, np.uint8)
    for x0, y0, x1, y1 in boxes:
        cv2.rectangle(grey, (x0, y0), (x1, y1), 0, 3)
        cv2.circle(grey, ((x0 + x1) // 2, (y0 + y1) // 2), 60, 0, 3)
    image = SheetImage(Path("sheet.png"), grey, "")
    return sheet_views(OpenedSheet(image), given)


def test_the_only_view_may_be_boxed() -> None:
    alone = _found([_VIEW], {})
    boxed = _found([_VIEW], {Role.TOP: (250.0, 150.0, 750.0, 550.0)})
    assert boxed.layout.boxes == {Role.TOP: alone.layout.boxes[Role.FRONT]}


def test_a_box_without_lines_is_no_view() -> None:
    with pytest.raises(UsageError, match="no lines"):
        _found([_VIEW], {Role.FRONT: (900.0, 150.0, 1200.0, 550.0)})


def test_a_box_does_not_hide_that_views_are_apart() -> None:
    with pytest.raises(NoModelError):
        _found([_VIEW, _APART], {Role.FRONT: (250.0, 150.0, 750.0, 550.0)})
