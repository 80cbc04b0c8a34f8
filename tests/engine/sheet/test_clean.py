"""Ink apart from paper and noise."""

from collections.abc import Callable

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.drawing.sheet import Sheet
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.clean import clean_sheet

Grey = npt.NDArray[np.uint8]


def _paper(height: int = 240, width: int = 320, value: int = 255) -> Grey:
    return np.full((height, width), value, np.uint8)


def _framed(width: int = 3) -> Grey:
    """A rectangle of 240 x 160 px drawn with a line width in px."""
    image = _paper()
    low, high = -(width // 2), width - width // 2
    image[40 + low : 200 + high, 40 + low : 280 + high] = 0
    image[40 + high : 200 + low, 40 + high : 280 + low] = 255
    return image


def _dashed() -> Grey:
    """A frame of 3 px and a line of dashes one px wide."""
    image = _framed()
    for x in range(60, 260, 16):
        image[120, x : x + 10] = 0
    return image


def test_ink_is_what_was_drawn() -> None:
    image = _framed()
    sheet = clean_sheet(image)
    assert np.array_equal(sheet.ink, image == 0)
    assert np.array_equal(sheet.weight, (image == 0).astype(np.float32))
    assert sheet.stroke_width == pytest.approx(3.0, abs=0.25)


@pytest.mark.parametrize("width", [1, 2, 3, 5, 8])
def test_stroke_width(width: int) -> None:
    assert clean_sheet(_framed(width)).stroke_width == pytest.approx(width, abs=0.3)


def test_dashes_of_one_pixel_survive_the_median_filter() -> None:
    image = _dashed()
    assert (cv2.medianBlur(image, 3)[120, 60:260] > 0).all()
    assert np.array_equal(clean_sheet(image).ink, image == 0)


def test_noise_goes_and_dashes_stay_whole() -> None:
    clean = _dashed()
    noisy = clean.copy()
    chance = np.random.default_rng(5).random(clean.shape)
    noisy[chance < 0.01] = 0
    ink = clean_sheet(noisy).ink
    assert ink[clean == 0].all()
    drawn = cv2.dilate((clean == 0).astype(np.uint8), np.ones((9, 9), np.uint8)) > 0
    assert ((noisy == 0) & ~drawn).sum() > 300
    assert (ink & ~drawn).sum() <= 20


def test_no_kernel_no_filter() -> None:
    image = _dashed()
    image[20, 20] = 0
    assert clean_sheet(image, 0).ink[20, 20]
    assert not clean_sheet(image, 3).ink[20, 20]


@pytest.mark.parametrize("style", ["thin", "clean", "scan", "binary"])
def test_ink_covers_every_stroke(
    draw: Callable[..., Sheet], grey: Callable[[Grey], Grey], style: str
) -> None:
    """Half way between the ends of each visible stroke there is ink."""
    sheet = draw("rib-bracket", style)
    found = clean_sheet(grey(sheet.image))
    strokes = [s for view in sheet.views for s in view.strokes if s.linetype.value == "visible"]
    middles = np.array([s.sample(s.length / 2)[1] for s in strokes])
    columns, rows = np.floor(middles).astype(int).T
    assert found.ink[rows, columns].all()
    assert found.weight[rows, columns] == pytest.approx(1.0, abs=0.15)


def test_light_grey_lines_on_grey_paper_are_ink() -> None:
    image = np.where(_framed() == 0, np.uint8(120), np.uint8(200))
    sheet = clean_sheet(image)
    assert np.array_equal(sheet.ink, image == 120)
    assert sheet.weight[40, 160] == pytest.approx(1.0)
    assert sheet.weight[120, 160] == 0.0


def test_uneven_light_is_no_ink() -> None:
    """A scan that darkens by half towards one side."""
    image = _framed()
    shade = np.linspace(1.0, 0.5, image.shape[1])
    assert np.array_equal(clean_sheet((image * shade).astype(np.uint8)).ink, image == 0)


def test_a_blank_sheet() -> None:
    with pytest.raises(NoModelError) as caught:
        clean_sheet(_paper())
    assert caught.value.code == "blank-sheet"


def test_a_photograph() -> None:
    """Texture everywhere is no line drawing."""
    image = np.random.default_rng(1).integers(0, 256, (240, 320)).astype(np.uint8)
    with pytest.raises(NoModelError) as caught:
        clean_sheet(image, 0)
    assert caught.value.code == "not-a-line-drawing"
