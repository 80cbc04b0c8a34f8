"""Ink apart from paper and noise."""

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.drawing.drawn_sheet import Sheet
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet

Grey = npt.NDArray[np.uint8]

Sketch = Any
"""The class that the fixture gives."""


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


@pytest.mark.parametrize(("dim", "error"), [(0.4, 0.45), (0.7, 0.15)])
def test_uneven_light_leaves_the_weight_even(
    sketch: Sketch,
    read_view: Callable[..., Any],
    differences: Callable[..., list[str]],
    dim: float,
    error: float,
) -> None:
    """A lamp over one corner: lines keep their place, and nearly their darkness."""
    drawn = sketch(480, 360).box(60, 50, 420, 310)
    y, x = np.mgrid[:360, :480]
    light = dim + (1.0 - dim) * np.exp(-((x - 100) ** 2 + (y - 80) ** 2) / 200.0**2)
    sheet = clean_sheet(np.rint(drawn.grey * light).astype(np.uint8))
    assert sheet.ink[drawn.weight > 0.5].all()
    assert not sheet.ink[drawn.weight == 0.0].any()
    assert np.abs(sheet.weight - drawn.weight).max() < error
    read = read_view(sheet, (58.0, 48.0, 423.0, 313.0)).strokes
    assert differences(drawn.drawn, read, 0.1) == []


def test_a_shadow_and_a_fold_are_no_ink(sketch: Sketch) -> None:
    """The dark border of a copier's lid and a soft crease through the sheet."""
    drawn = sketch(480, 360).box(90, 80, 400, 300)
    x = np.arange(480)
    shade = 1.0 - 0.5 * np.exp(-x / 20.0) - 0.15 * np.exp(-((x - 250) ** 2) / (2 * 25.0**2))
    ink = clean_sheet(np.rint(drawn.grey * shade).astype(np.uint8)).ink
    assert ink[drawn.weight > 0.5].all()
    assert not ink[drawn.weight == 0.0].any()


def test_the_paper_s_noise_has_no_weight(sketch: Sketch) -> None:
    drawn = sketch(480, 360).box(90, 80, 400, 300)
    noise = np.random.default_rng(3).normal(0.0, 3.0, (360, 480))
    grey = np.clip(0.9 * drawn.grey.astype(float) + noise, 0, 255).astype(np.uint8)
    sheet = clean_sheet(grey)
    blank = cv2.dilate((drawn.weight > 0).astype(np.uint8), np.ones((7, 7), np.uint8)) == 0
    assert (sheet.weight[blank] > 0).mean() < 0.002
    assert sheet.weight[blank].max() < 0.15


def test_the_picture_is_the_ink_on_white_paper(sketch: Sketch) -> None:
    drawn = sketch().line((20, 30), (180, 90)).arc((110, 75), 40.0)
    sheet = clean_sheet((0.6 * drawn.grey.astype(float) + 40.0).astype(np.uint8))
    picture = sheet.picture
    assert picture.dtype == np.uint8
    assert picture.shape == drawn.grey.shape
    assert np.array_equal(picture < 128, sheet.weight > 0.5)
    assert (picture[drawn.weight == 0.0] == 255).all()
    assert (picture[drawn.weight == 1.0] < 20).all()


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


def test_a_texture_is_refused_before_it_is_read() -> None:
    """Many pieces of ink without a line: reading them as letters would take minutes."""
    rough = np.random.default_rng(0).normal(size=(1000, 1500)).astype(np.float32)
    smooth = cv2.GaussianBlur(rough, (0, 0), 3.0)
    image = cv2.normalize(smooth, None, 0, 255, cv2.NORM_MINMAX).astype(np.uint8)
    with pytest.raises(NoModelError) as caught:
        upright_sheet(clean_sheet(image))
    assert caught.value.code == "not-a-line-drawing"
