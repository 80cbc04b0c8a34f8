"""Clean sheets come to look exported, scanned, copied, photographed or small.

Pictures are darkness at first, 0 to 255, black: (h, w) float32; brightness later.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from learning.sheets.rendering import Rendered
from learning.training_samples import Sample

Floats = npt.NDArray[np.float32]
Change = Callable[[npt.NDArray, int], npt.NDArray]
"""A picture (h, w) and how to find values between pixels, to the picture changed."""

_EXPORTED = 0.42
"""Share of the sheets that are exports, never on paper."""

_ALIASED = 0.12
"""Share that is, and has few grey levels."""

_BENT, _BENT_ON_PAPER, _SKEWED = 0.05, 0.12, 0.4
"""Shares of the exports and of the papers that are bent, and of the papers that are turned."""

_SKEW_DEG, _STRETCH, _SLANT = 0.8, (0.93, 1.07), 4e-5
"""Standard deviation of turns, factors of stretching, and standard deviation of the perspective's
share of a px."""

_INVERTED = 0.02
"""Share that is light on dark."""

_SMALL = (0.34, 0.8)
"""Factors by which pictures are made smaller and brought back."""


@dataclass(frozen=True, eq=False)
class _Layers:
    """What moves with the paper; :class:`.Rendered` with the ink as floats."""

    ink: Floats
    classes: npt.NDArray[np.uint8]
    extra: npt.NDArray[np.uint8]
    tint: Floats | None


def spoiled(sheet: Rendered, rng: np.random.Generator) -> Sample:
    """A sample of a clean sheet, or of a piece of one.

    Args:
        sheet: clean.
        rng: says how.
    """
    exported = rng.random() < _EXPORTED
    layers = _Layers(sheet.ink.astype(np.float32), sheet.classes, sheet.extra, sheet.tint)
    layers = _moved(layers, rng, exported)
    ink = layers.ink
    if exported and rng.random() < _ALIASED / _EXPORTED * 0.7:
        ink = np.where(ink > rng.uniform(60.0, 160.0), max(ink.max(), 1.0), 0.0)
        ink = ink.astype(np.float32)
    if layers.tint is not None:
        ink = np.maximum(ink, layers.tint)
    if rng.random() < 0.16:
        ink = _fewer_px(ink, rng.uniform(*_SMALL), rng)
    grey = _export(ink, rng) if exported else _paper(ink, rng)
    levels = np.clip(grey, 0.0, 255.0).astype(np.uint8)
    if rng.random() < _INVERTED:
        levels = 255 - levels
    if rng.random() < (0.15 if exported else 0.5):
        quality = [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(25, 95))]
        packed = cv2.imencode(".jpg", levels, quality)[1]
        levels = np.asarray(cv2.imdecode(packed, cv2.IMREAD_GRAYSCALE), dtype=np.uint8)
    return Sample(levels, layers.classes, layers.extra)


def _moved(layers: _Layers, rng: np.random.Generator, exported: bool) -> _Layers:
    """Bent, turned, in perspective, or as it was."""
    share = rng.random()
    if share < (_BENT if exported else _BENT_ON_PAPER):
        return _bent(layers, rng)
    if not exported and share > 1.0 - _SKEWED:
        return _skewed(layers, rng)
    return layers


def _bent(layers: _Layers, rng: np.random.Generator) -> _Layers:
    """Smoothly, by a px or two: as drawn by hand, or on wavy paper."""
    height, width = layers.ink.shape
    knots, amount = int(rng.integers(3, 9)), rng.uniform(0.4, 2.2)
    rows, columns = np.mgrid[0:height, 0:width].astype(np.float32)
    right, down = (
        amount * cv2.resize(item, (width, height), interpolation=cv2.INTER_CUBIC)
        for item in rng.standard_normal((2, knots, knots)).astype(np.float32)
    )

    def bent(picture: npt.NDArray, way: int) -> npt.NDArray:
        return cv2.remap(picture, columns + right, rows + down, way)

    return _each(layers, bent)


def _skewed(layers: _Layers, rng: np.random.Generator) -> _Layers:
    """Turned and stretched a little, at times in perspective."""
    height, width = layers.ink.shape
    middle, stretch = (width / 2, height / 2), rng.uniform(*_STRETCH)
    turn = cv2.getRotationMatrix2D(middle, rng.normal(0.0, _SKEW_DEG), stretch)
    matrix = np.vstack([turn, [0.0, 0.0, 1.0]])
    if rng.random() < 0.375:
        matrix[2, :2] = rng.normal(0.0, _SLANT, 2)

    def skewed(picture: npt.NDArray, way: int) -> npt.NDArray:
        return cv2.warpPerspective(picture, matrix, (width, height), flags=way)

    return _each(layers, skewed)


def _each(layers: _Layers, change: Change) -> _Layers:
    """All layers changed alike: pictures smoothly, maps by their nearest pixels."""
    return replace(
        layers,
        ink=change(layers.ink, cv2.INTER_LINEAR),
        classes=change(layers.classes, cv2.INTER_NEAREST),
        extra=change(layers.extra, cv2.INTER_NEAREST),
        tint=None if layers.tint is None else change(layers.tint, cv2.INTER_LINEAR),
    )


def _fewer_px(ink: Floats, factor: float, rng: np.random.Generator) -> Floats:
    """Made smaller and brought back."""
    small = cv2.resize(ink, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
    way = cv2.INTER_LINEAR if rng.random() < 1 / 3 else cv2.INTER_CUBIC
    return np.clip(cv2.resize(small, ink.shape[::-1], interpolation=way), 0.0, 255.0)


def _export(ink: Floats, rng: np.random.Generator) -> Floats:
    """Brightness of a file that was never on paper."""
    grey = 255.0 - ink
    if rng.random() < 0.25:
        grey = np.asarray(cv2.GaussianBlur(grey, (0, 0), rng.uniform(0.3, 0.7)), dtype=np.float32)
    if rng.random() < 0.12:
        grey = grey + 4.0 * _noise(grey.shape, rng)
    if rng.random() < 0.06:
        grey = grey * rng.uniform(0.8, 1.0) + rng.uniform(0.0, 40.0)
    return grey


def _paper(ink: Floats, rng: np.random.Generator) -> Floats:
    """Brightness of a scan, a copy or a photograph."""
    ink = _printed(ink, rng)
    pale, paper = rng.uniform(0.6, 1.0), rng.uniform(215.0, 255.0)
    grey: npt.NDArray[np.floating] = paper - ink * pale * paper / 255.0
    if rng.random() < 0.6:
        grey = grey + rng.uniform(2.0, 18.0) * _clouds(grey.shape, int(rng.integers(80, 400)), rng)
    if rng.random() < 0.22:
        grey = grey * _light(grey.shape, rng) * rng.uniform(0.7, 1.0)
    grey = grey + rng.choice([2.0, 5.0, 10.0, 20.0]) * _noise(grey.shape, rng)
    if rng.random() < 0.3:
        middle, soft = rng.uniform(120.0, 210.0), rng.uniform(4.0, 40.0)
        grey = 255.0 / (1.0 + np.exp(np.clip((middle - grey) / soft * 4.0, -30.0, 30.0)))
    if rng.random() < 0.25:
        grey = _specked(grey, rng)
    if rng.random() < 0.04:
        # A blueprint's copy: weak ink.
        grey = 255.0 - (255.0 - grey) * rng.uniform(0.5, 0.8)
    return grey.astype(np.float32)


def _printed(ink: Floats, rng: np.random.Generator) -> Floats:
    """Ink as it stands on paper: wider or narrower, with gaps and spots, not quite sharp."""
    share, square = rng.random(), np.ones((2, 2), np.uint8)
    if share < 0.15:
        ink = np.asarray(cv2.erode(ink, square), dtype=np.float32)
    elif share < 0.42:
        ink = np.asarray(cv2.dilate(ink, square), dtype=np.float32)
    if rng.random() < 0.3:
        ink = _fewer_px(ink, rng.uniform(0.55, 0.95), rng)
    if rng.random() < 0.4:
        clouds = _clouds(ink.shape, int(rng.integers(4, 60)), rng)
        faded = np.maximum(0.0, clouds - rng.uniform(0.6, 2.0)) * rng.uniform(0.3, 1.2)
        ink = ink * np.clip(1.0 - faded, 0.0, 1.0)
    if rng.random() < 0.3:
        spots = 1.0 + rng.uniform(0.05, 0.3) * _clouds(ink.shape, 2, rng)
        ink = ink * np.clip(spots, 0.0, 1.5)
    blurred = cv2.GaussianBlur(ink.astype(np.float32), (0, 0), rng.uniform(0.4, 1.25))
    return np.asarray(blurred, dtype=np.float32)


def _light(shape: tuple[int, int], rng: np.random.Generator) -> Floats:
    """(h, w) light of a photograph: less towards one side, at times with a shadow's edge."""
    rows, columns = np.mgrid[0 : shape[0], 0 : shape[1]].astype(np.float32) / max(shape)
    angle = rng.uniform(0.0, 2.0 * np.pi)
    along = columns * np.cos(angle) + rows * np.sin(angle)
    light = 1.0 + rng.uniform(0.1, 0.5) * (along - along.mean())
    if rng.random() < 0.4:
        edge = along - rng.uniform(0.1, 0.9) - 0.05 * np.sin(9.0 * (columns - rows))
        steep = np.clip(edge * rng.uniform(8.0, 90.0), -30.0, 30.0)
        light = light * (1.0 - rng.uniform(0.1, 0.45) / (1.0 + np.exp(-steep)))
    return light.astype(np.float32)


def _specked(grey: Floats, rng: np.random.Generator) -> Floats:
    """With black and white pixels."""
    values, share = rng.random(grey.shape, dtype=np.float32), rng.uniform(0.0003, 0.006)
    grey = np.where(values < share, 255.0, np.where(values > 1.0 - share, 0.0, grey))
    grey = grey.astype(np.float32)
    choice = rng.random()
    if choice < 0.15:
        levels = np.clip(grey, 0.0, 255.0).astype(np.uint8)
        return cv2.medianBlur(levels, 3).astype(np.float32)
    if choice < 0.5:
        return np.asarray(cv2.GaussianBlur(grey, (0, 0), 0.6), dtype=np.float32)
    return grey


def _noise(shape: tuple[int, ...], rng: np.random.Generator) -> Floats:
    return rng.standard_normal(shape, dtype=np.float32)


def _clouds(shape: tuple[int, ...], px: int, rng: np.random.Generator) -> Floats:
    """(h, w) smooth chance of deviation about 1, with spots of so many px."""
    coarse = [max(2, number // int(px) + 2) for number in shape]
    noise = _noise(tuple(coarse), rng)
    smooth = cv2.resize(noise, (shape[1], shape[0]), interpolation=cv2.INTER_CUBIC)
    return np.asarray(smooth, dtype=np.float32)
