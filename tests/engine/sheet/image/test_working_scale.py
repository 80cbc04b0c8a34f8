"""Pictures at the pixels at which they are read."""

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.sheet.image.working_scale import (
    WORKING_WIDTH,
    pen_width,
    resampled,
    working_factor,
)

_BOXES = (50.0, 50.25, 250.5, 200.0), (350.25, 50.0, 500.75, 200.5), (50.75, 280.5, 250.0, 350.75)
"""They lie differently between the pixels, as lines do."""


def drawing(width: float, thin: float = 1.0, factor: float = 1.0) -> npt.NDArray[np.uint8]:
    """Rectangles in a pen of a width in px, dimension lines in a thin one; drawn finely."""
    fine = 4
    grey = np.full((fine * 400, fine * 600), 255, np.uint8)
    for x0, y0, x1, y1 in _BOXES:
        for pen, off in ((thin, 22), (width, 0)):
            for value, by in ((0, pen / 2), (255, -pen / 2)):
                low = round(fine * (x0 - off - by)), round(fine * (y0 - off - by))
                high = round(fine * (x1 + off + by)) - 1, round(fine * (y1 + by)) - 1
                cv2.rectangle(grey, low, high, value, cv2.FILLED)
    size = (round(600 * factor), round(400 * factor))
    return cv2.resize(grey, size, interpolation=cv2.INTER_AREA)


@pytest.mark.parametrize("width", [1.5, 2.0, 3.0, 4.5, 7.0])
def test_the_width_is_that_of_the_wide_pen(width: float) -> None:
    assert pen_width(drawing(width)) == pytest.approx(width, rel=0.08)


@pytest.mark.parametrize("factor", [0.5, 2.0, 3.0])
def test_a_picture_of_more_pixels_is_read_at_as_many(factor: float) -> None:
    # What is read has one size, however large the picture is.
    small, large = (working_factor(drawing(2.5, factor=item)) * item for item in (1.0, factor))
    assert large == pytest.approx(small, rel=0.08)


def test_lines_of_the_working_width_stay() -> None:
    assert working_factor(drawing(WORKING_WIDTH)) == 1.0


def test_grey_paper_and_its_shadow_change_nothing() -> None:
    grey = drawing(4.0).astype(float)
    light = np.linspace(0.7, 1.0, grey.shape[1])
    assert pen_width((grey * light).astype(np.uint8)) == pytest.approx(4.0, rel=0.1)


def test_blank_paper_and_a_text_tell_nothing() -> None:
    paper = np.full((200, 300), 250, np.uint8)
    assert pen_width(paper) is None
    assert working_factor(paper) == 1.0
    cv2.circle(paper, (100, 100), 4, 0, -1)
    assert working_factor(paper) == 1.0


def test_a_resampled_picture_has_the_size_that_was_asked_for() -> None:
    assert resampled(drawing(2.0), (900, 600)).shape == (600, 900)
    assert resampled(drawing(2.0), (300, 200)).shape == (200, 300)
