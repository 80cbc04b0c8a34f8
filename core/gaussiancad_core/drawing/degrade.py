"""What pens, copiers and scanners do to a drawing: from ink to a picture of a sheet.

The lines stay where they are: ink spreads and fades evenly to both sides of a line, so that what a
reader should find is known exactly.  All chance comes from the seed, one stream for each effect,
so that switching one of them on changes none of the others.
"""

from enum import IntEnum

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.sheet_style import SheetStyle

Image = npt.NDArray[np.uint8]
Ink = npt.NDArray[np.float32]


class _Stream(IntEnum):
    """Numbers of the random streams."""

    FADE = 1
    SPECKS = 2
    TONER = 3
    LIGHT = 4
    SALT = 5


def finished(ink: Ink, style: SheetStyle, seed: int) -> Image:
    """The picture of a sheet.

    Args:
        ink: (h, w) share of ink, 0 to 1.
        style: colours and defects.
        seed: of all chance.

    Returns:
        (h, w, 3) uint8 RGB.
    """
    if style.bleed > 0.0:
        ink = _spread(ink, style.bleed)
    if style.fade > 0.0:
        ink = ink * (1.0 - _fading(ink.shape, style.fade, _stream(seed, _Stream.FADE)))
    if style.specks > 0.0:
        ink = _speckled(ink, style.specks, _stream(seed, _Stream.SPECKS))
    if style.blur > 0.0:
        ink = np.asarray(cv2.GaussianBlur(ink, (0, 0), style.blur), dtype=np.float32)
    if style.contrast > 1.0:
        ink = _copied(ink, style.contrast, _stream(seed, _Stream.TONER))
    paper, colour = (np.array(value, dtype=np.float32) for value in (style.paper, style.ink))
    image = paper + ink[..., None] * (colour - paper)
    if style.light > 0.0:
        image *= 1.0 - _unevenness(ink.shape, style.light, _stream(seed, _Stream.LIGHT))[..., None]
    if style.shadow > 0.0:
        image *= 1.0 - _border_shadow(ink.shape, style.shadow)[..., None]
    if style.noise > 0.0:
        noise = np.random.default_rng(seed).standard_normal(ink.shape, dtype=np.float32)
        image += style.noise * noise[..., None]
    if style.salt > 0.0:
        _strew(image, style.salt, _stream(seed, _Stream.SALT))
    return np.clip(np.rint(image), 0.0, 255.0).astype(np.uint8)


def _stream(seed: int, number: _Stream) -> np.random.Generator:
    return np.random.default_rng([seed, int(number)])


def _spread(ink: Ink, reach: float) -> Ink:
    """Ink that has crept ``reach`` px to every side: the most that is found that far away."""
    crept = ink
    for angle in np.arange(16) * (np.pi / 8.0):
        crept = np.maximum(crept, _shifted(ink, reach * np.cos(angle), reach * np.sin(angle)))
    return crept


def _shifted(ink: Ink, right: float, down: float) -> Ink:
    """Ink moved by part of a pixel; linear interpolation keeps borders where they should be."""
    x, y = int(np.floor(right)), int(np.floor(down))
    kernel = np.outer((down - y, y + 1.0 - down), (right - x, x + 1.0 - right))
    # A correlation: the kernel's first entry takes what lies one pixel before.
    between = cv2.filter2D(ink, -1, kernel, anchor=(1, 1), borderType=cv2.BORDER_CONSTANT)
    height, width = ink.shape
    motion = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
    moved = cv2.warpAffine(between, motion, (width, height), flags=cv2.INTER_NEAREST)
    return np.asarray(moved, dtype=np.float32)


def _smooth_field(
    shape: tuple[int, ...], scale: float, random: np.random.Generator
) -> npt.NDArray[np.float32]:
    """(h, w) smooth chance of mean 0 and standard deviation 1, with features ``scale`` px large."""
    height, width = shape
    coarse = (int(np.ceil(height / scale)) + 3, int(np.ceil(width / scale)) + 3)
    grid = random.standard_normal(coarse, dtype=np.float32)
    fine = cv2.resize(grid, None, fx=scale, fy=scale, interpolation=cv2.INTER_CUBIC)
    start = round(scale)
    field = fine[start : start + height, start : start + width]
    return (field - field.mean()) / max(float(field.std()), 1e-6)


def _fading(
    shape: tuple[int, ...], share: float, random: np.random.Generator
) -> npt.NDArray[np.float32]:
    """(h, w) share of the ink that is missing: pale regions, and small holes inside them."""
    regions = _smooth_field(shape, 160.0, random)
    grains = _smooth_field(shape, 2.5, random)
    pale = share * np.clip(0.45 + 0.45 * regions, 0.0, 1.0)
    holes = np.clip((grains - 2.6 + 2.2 * pale) * 1.5, 0.0, 1.0)
    return np.clip(0.8 * pale + holes, 0.0, 0.95)


def _speckled(ink: Ink, density: float, random: np.random.Generator) -> Ink:
    """Dust, a few hairs, and light spots where toner is missing; ``density`` per megapixel."""
    height, width = ink.shape
    count = random.poisson(density * height * width / 1e6)
    ink = ink.copy()
    for _ in range(count):
        at = random.uniform((0.0, 0.0), (width, height))
        radius = min(0.5 * float(random.lognormal(0.0, 0.45)), 2.2)
        kind = random.uniform()
        if kind < 0.04:
            _hair(ink, at, random)
        else:
            light = kind > 0.85
            _spot(ink, at, radius, 0.0 if light else float(random.uniform(0.4, 1.0)))
    return ink


def _spot(ink: Ink, at: npt.NDArray[np.float64], radius: float, level: float) -> None:
    reach = int(np.ceil(radius)) + 1
    x0, y0 = (max(0, int(value) - reach) for value in at)
    area = ink[y0 : int(at[1]) + reach + 1, x0 : int(at[0]) + reach + 1]
    y, x = np.mgrid[y0 : y0 + area.shape[0], x0 : x0 + area.shape[1]] + 0.5
    cover = np.clip(radius + 0.5 - np.hypot(x - at[0], y - at[1]), 0.0, 1.0)
    area += (cover * (level - area)).astype(np.float32)


def _hair(ink: Ink, at: npt.NDArray[np.float64], random: np.random.Generator) -> None:
    """A thin curved fibre a few dozen px long."""
    way, bend = random.uniform(0.0, 2.0 * np.pi), random.normal(0.0, 0.05)
    level = float(random.uniform(0.25, 0.6))
    height, width = ink.shape
    for _ in range(int(random.uniform(12, 40))):
        at = at + np.array([np.cos(way), np.sin(way)])
        way += bend
        if 0.0 <= at[0] < width and 0.0 <= at[1] < height:
            _spot(ink, at, 0.3, max(level, float(ink[int(at[1]), int(at[0])])))


def _copied(ink: Ink, contrast: float, random: np.random.Generator) -> Ink:
    """A copier's tone curve, steep in the middle, and the ragged edge of its toner."""
    grain = random.standard_normal(ink.shape, dtype=np.float32)
    grain = cv2.GaussianBlur(grain, (0, 0), 0.6) * 0.12
    ragged = np.clip(ink + grain * np.sqrt(np.clip(ink, 0.0, 1.0)), 0.0, 1.0)
    curve = 1.0 / (1.0 + np.exp(-4.0 * contrast * (ragged - 0.5)))
    edge = 1.0 / (1.0 + np.exp(2.0 * contrast))
    return ((curve - edge) / (1.0 - 2.0 * edge)).astype(np.float32)


def _unevenness(
    shape: tuple[int, ...], share: float, random: np.random.Generator
) -> npt.NDArray[np.float32]:
    """(h, w) share of the light that is missing, 0 to ``share``: a slope and wide patches."""
    height, width = shape
    way = random.uniform(0.0, 2.0 * np.pi)
    x = np.linspace(-1.0, 1.0, width, dtype=np.float32)[None, :]
    y = np.linspace(-1.0, 1.0, height, dtype=np.float32)[:, None]
    slope = np.cos(way) * x + np.sin(way) * y
    field = slope + 0.35 * _smooth_field(shape, max(height, width) / 4.0, random)
    low, high = float(field.min()), float(field.max())
    return (share * (field - low) / (high - low)).astype(np.float32)


def _border_shadow(shape: tuple[int, ...], width_px: float) -> npt.NDArray[np.float32]:
    """(h, w) darkness, 0 to 0.9, that the copier's lid leaves along the left and upper border."""
    height, width = shape
    x = np.arange(width, dtype=np.float32)[None, :] + 0.5
    y = np.arange(height, dtype=np.float32)[:, None] + 0.5
    from_border = np.minimum(x, y + 0.4 * width_px)
    return 0.9 * np.exp(-2.0 * (from_border / width_px) ** 2)


def _strew(image: npt.NDArray[np.float32], share: float, random: np.random.Generator) -> None:
    """Make single pixels black or white, in place."""
    chance = random.random(image.shape[:2], dtype=np.float32)
    image[chance < 0.5 * share] = 0.0
    image[chance > 1.0 - 0.5 * share] = 255.0
