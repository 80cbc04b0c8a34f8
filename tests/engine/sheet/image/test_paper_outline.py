"""The paper in a picture: told from a table around it, and from drawings that look like one."""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.image.paper_outline import paper_outline

CORNERS = np.array([[120, 90], [1080, 140], [1040, 800], [90, 760]])


def inked(light: int = 230, table: int = 70) -> npt.NDArray[np.uint8]:
    """A sheet with a view on a table."""
    picture = np.full((900, 1200), table, np.uint8)
    cv2.fillConvexPoly(picture, CORNERS, light)
    cv2.rectangle(picture, (300, 250), (700, 600), 30, 4)
    return picture


def test_its_corners_and_what_lies_within() -> None:
    outline = paper_outline(inked())
    assert outline is not None
    assert outline.corners is not None
    apart = np.abs(outline.corners[:, None] - CORNERS).max(axis=2)
    assert (apart.min(axis=0) <= 6.0).all()
    mask = outline.mask((900, 1200))
    assert mask[425, 300] == 255, "the view's line is on the paper"
    assert mask[20, 20] == 0
    assert mask[760, 90] == 0, "the paper's own edge is left out"


def test_a_sheet_that_fills_the_picture_has_none() -> None:
    sheet = np.full((900, 1200), 235, np.uint8)
    cv2.rectangle(sheet, (300, 250), (700, 600), 30, 4)
    assert paper_outline(sheet) is None


def test_a_dark_field_of_the_sheet_is_no_table() -> None:
    sheet = np.full((900, 1200), 235, np.uint8)
    sheet[:, 900:] = 80
    assert paper_outline(sheet) is None


def test_light_lines_on_a_dark_sheet_are_no_paper() -> None:
    sheet = np.full((900, 1200), 20, np.uint8)
    for x in range(200, 1000, 40):
        cv2.line(sheet, (x, 150), (x, 750), 240, 3)
        cv2.line(sheet, (200, x * 3 // 4), (1000, x * 3 // 4), 240, 3)
    assert paper_outline(sheet) is None


def test_paper_hardly_lighter_than_what_is_around_it_is_not_told() -> None:
    assert paper_outline(inked(light=230, table=215)) is None
