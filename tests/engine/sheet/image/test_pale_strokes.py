"""Strokes in grey and in light colours are as strong as dark ones."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.pale_strokes import with_pale

Sketch = Any
"""The class that the fixture gives."""


@pytest.mark.parametrize(("shade", "width"), [(160, 2.0), (160, 3.0), (125, 4.0), (100, 4.0)])
def test_pale_strokes_are_strokes(sketch: Sketch, shade: int, width: float) -> None:
    """Programs plot hidden lines in grey; beside dark ones they are as pale as they were."""
    dark = sketch().box(20, 20, 180, 140)
    pale = sketch().broken((60.3, 60), (150.3, 60), (10, 5), width)
    pale.broken((60.3, 100), (150.3, 100), (10, 5), width)
    grey = np.rint(255.0 - 255.0 * dark.weight - (255.0 - shade) * pale.weight).astype(np.uint8)
    sheet = clean_sheet(grey)
    expected = np.maximum(dark.weight, 0.75 * pale.weight)
    assert np.abs(sheet.weight - expected).max() < 0.13
    assert sheet.stroke_width == pytest.approx(2.8, abs=0.4)


def test_thin_pale_strokes_are_full_ones(sketch: Sketch) -> None:
    drawn = sketch().box(20, 20, 180, 140)
    pale = sketch().broken((60, 60), (150, 60), (10, 5), 1.0)
    pale.broken((60, 100.4), (150, 100.4), (10, 5), 1.0)
    grey = np.rint(255.0 - 255.0 * drawn.weight - 100.0 * pale.weight).astype(np.uint8)
    weight = clean_sheet(grey).weight
    assert weight[60, 65] == pytest.approx(1.0, abs=0.1)
    assert weight[100, 65] > 0.6


def test_thin_strokes_of_a_dark_grey_are_full_ones(sketch: Sketch) -> None:
    drawn = sketch(300, 160).box(20, 20, 280, 140)
    pale = sketch(300, 160)
    for y in (40.0, 50.0, 60.2, 70.3, 80.4, 90.5, 100.5):
        pale.broken((40, y), (260, y), (10, 5), 1.0)
    grey = np.rint(255.0 - 255.0 * drawn.weight - 165.0 * pale.weight).astype(np.uint8)
    weight = clean_sheet(grey).weight
    assert weight[40, 45] > 0.9
    assert weight[100:102, 45].min() > 0.45


def test_thin_dark_strokes_beside_grey_ones_stay_thin(sketch: Sketch) -> None:
    """Between two rows of pixels they are as pale as grey ones on a row, and have as much ink as
    they should."""
    drawn = sketch(400, 160).box(20, 20, 380, 140)
    grey = np.rint(255.0 - 255.0 * drawn.weight)
    # As renderers have it that smooth nothing but what a stroke covers of a pixel.
    for y in (30, 40, 50, 60):
        for x in range(40, 360, 15):
            grey[y, x : x + 10] = 112.0
    for y in (80, 95, 110, 125):
        grey[y : y + 2, 40:360] = 140.0
    weight = clean_sheet(grey.astype(np.uint8)).weight
    assert weight[80:82, 200].sum() < 1.3
    assert weight[40, 45] > 0.9


def test_thin_strokes_are_not_pale_ones(sketch: Sketch) -> None:
    """A line of one px between two rows of pixels is half as dark as one on a row, and as wide."""
    drawn = sketch().box(20, 20, 180, 140)
    for y in (40.5, 60.25, 80.0, 100.5):
        drawn.line((40, y), (160, y), 1.0)
    weight = clean_sheet(drawn.grey).weight
    assert weight[40:42, 100] == pytest.approx([0.5, 0.5], abs=0.1)
    assert weight[100:102, 100] == pytest.approx([0.5, 0.5], abs=0.1)


def test_what_shows_through_a_scan_stays_pale(sketch: Sketch) -> None:
    dark = sketch().box(20, 20, 180, 140)
    back = sketch().line((50, 80), (150, 80))
    noise = np.random.default_rng(1).normal(0.0, 6.0, dark.weight.shape)
    grey = np.clip(250.0 - 250.0 * dark.weight - 60.0 * back.weight + noise, 0, 255)
    sheet = clean_sheet(np.rint(grey).astype(np.uint8))
    assert sheet.weight[78:83, 60:140].max() < 0.5


def test_two_pale_pens_are_told_apart(sketch: Sketch) -> None:
    """Dimensions in dark grey do not keep hidden lines in light grey from being seen."""
    dark = sketch(240, 200).box(20, 20, 220, 180)
    grey = sketch(240, 200)
    for x in (180, 190, 200):
        grey.line((x, 40), (x, 160), 3.0)
    light = sketch(240, 200).broken((60, 60), (150, 60), (12, 6), 3.0)
    light.broken((60, 100), (150, 100), (12, 6), 3.0)
    shade = 255.0 - 255.0 * dark.weight - 175.0 * grey.weight - 115.0 * light.weight
    weight = clean_sheet(np.rint(shade).astype(np.uint8), 0).weight
    for pale in (grey, light):
        assert weight[pale.weight == 1.0] == pytest.approx(0.75, abs=0.03)
    assert weight[dark.weight == 1.0] == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("rows", [(0.45, 0.45), (0.5, 0.15), (0.32, 0.33)])
def test_pale_strokes_among_thin_dark_ones_are_raised(rows: tuple[float, float]) -> None:
    """Hidden lines in grey, dimensions of one px in black, each of a shade of its own."""
    weight = np.zeros((160, 300), np.float32)
    weight[10:12, 20:280] = weight[150:152, 20:280] = 1.0
    for k, share in enumerate((0.75, 0.8, 0.6, 0.55, 0.5, 0.72, 0.78, 0.76)):
        weight[20 + 8 * k : 22 + 8 * k, 40:260] = [[share], [1.0 - share]]
    dark = weight.copy()
    for start in range(40, 260, 24):
        for y in (100, 110, 120):
            weight[y : y + 2, start : start + 16] = np.array(rows)[:, None]
    found = with_pale(weight, weight > 0.1)
    assert np.array_equal(found[:90], dark[:90])
    for y in (100, 110, 120):
        assert found[y, 44:52] == pytest.approx(0.65, abs=0.03)
        assert found[y : y + 2, 46].sum() == pytest.approx(0.65 * sum(rows) / max(rows), abs=0.03)
