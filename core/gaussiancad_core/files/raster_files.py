"""Raster files: PNG, JPEG, TIFF, BMP and WebP."""

import warnings
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
from PIL import ExifTags, Image, ImageOps, UnidentifiedImageError

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.content import (
    CSS_DPI,
    MAX_PAGES,
    FileContent,
    Grey,
    Note,
    check_pixels,
    page_missing,
    too_large,
    too_many_pages,
)
from gaussiancad_core.files.paper import PICTURE_REACH, enlarged, even_paper, smaller
from gaussiancad_core.messages import Message
from gaussiancad_protocol.codes import Code

_FORMATS = ("PNG", "JPEG", "TIFF", "BMP", "WEBP")

_MIN_DPI, _MAX_DPI = 75.0, 2400.0
"""Resolutions at which drawings are scanned and exported."""

_BAND = 1024
"""Rows that are converted at a time."""

_LEAST_INK = 48
"""Levels of a colour's light that ink takes at least to have a hue, on paper made white."""

_LEAST_SATURATION = 0.35
"""Share by which it takes more of one colour's light than of another's, at least."""

_LEAST_PAPER = 64.0
"""Levels of light that paper has at least: what is darker is none, and its noise no colour."""

_QUARTER_TURNS = (5, 6, 7, 8)
"""EXIF's orientations of pictures that are stored on their side."""

_SQUARE = 0.01
"""Share by which a picture's resolutions across and down may differ: its pixels are square."""

_MOST_UNEQUAL = 2.5
"""Ratio of both at most, as of a fax in its coarse mode: 204 x 98 dpi."""

_MIN_PAPER, _MAX_PAPER = 3.0, 100.0
"""Inches: the longest side of a sheet that is believable."""


def read_raster(path: Path, page: int) -> FileContent:
    """Read an image; EXIF rotation is applied and transparency becomes white paper.

    Args:
        path: the file.
        page: which image of a multi-page TIFF, counted from 1.

    Raises:
        UnreadableError: ``not-an-image``, ``damaged-image``, ``image-too-large``,
            ``image-too-small``, ``page-missing``, ``too-many-pages``.
    """
    try:
        with warnings.catch_warnings():
            # Of large images, and of tags that make no difference.
            warnings.simplefilter("ignore")
            with Image.open(path, formats=_FORMATS) as image:
                check_pixels(path, image.width, image.height)
                _select_page(path, image, page)
                check_pixels(path, image.width, image.height)
                both = _resolutions(image)
                grey, tint = _to_grey(image)
                if both is not None and _is_unequal(*both):
                    return _squared(path, (grey, tint), both, _pages_after(path, page))
                resolution = _paper_resolution(both, max(grey.shape))
                return FileContent(grey, resolution, tint=tint, pages=_pages_after(path, page))
    except UnidentifiedImageError as error:
        raise UnreadableError(
            Code.NOT_AN_IMAGE,
            "{path} is not a PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF file: "
            "export the drawing as one of them",
            path=path,
        ) from error
    except Image.DecompressionBombError as error:
        raise too_large(path, "many more") from error
    except UnreadableError:
        raise
    except (OSError, ValueError, SyntaxError, EOFError, KeyError, TypeError) as error:
        # Pillow's decoders let the errors of their parsers through.
        raise UnreadableError(
            Code.DAMAGED_IMAGE,
            "{path} is damaged ({reason}): export or scan the drawing again",
            path=path,
            reason=error,
        ) from error


def _select_page(path: Path, image: Image.Image, page: int) -> None:
    """Seek to the page; how many there are is only counted if there is no such page."""
    if page > MAX_PAGES and (count := _count_pages(path)) > MAX_PAGES:
        raise too_many_pages(path, count)
    try:
        if page < 1:
            raise EOFError
        if page > 1:
            image.seek(page - 1)
    except EOFError:
        raise page_missing(path, _count_pages(path), page) from None


def _pages_after(path: Path, page: int) -> int:
    """Pages of a file of which one was read; what cannot be counted has no more than that."""
    try:
        return max(page, _count_pages(path))
    except (OSError, ValueError, SyntaxError, EOFError, KeyError, TypeError):
        return page


def _count_pages(path: Path) -> int:
    with Image.open(path, formats=_FORMATS) as image:
        return getattr(image, "n_frames", 1)


def _to_grey(image: Image.Image) -> tuple[Grey, Grey | None]:
    """(h, w) uint8 luminance of an image on white paper, and the tint of what is coloured."""
    image = ImageOps.exif_transpose(image)
    if image.mode.startswith("I") or image.mode == "F":
        return _scaled(np.asarray(image), sixteen_bits=image.mode.startswith("I;16")), None
    if image.mode == "LAB":
        image = image.getchannel(0)
    if image.mode in ("L", "1") and "transparency" not in image.info:
        return np.array(image.convert("L")), None
    image.load()
    grey = np.empty((image.height, image.width), np.uint8)
    tint = np.empty_like(grey)
    small = []
    for top, bottom in _bands(image):
        rgb = _on_paper(image.crop((0, top, image.width, bottom)))
        grey[top:bottom] = np.asarray(rgb.convert("L"))
        small.append(smaller(np.asarray(rgb)))
    paper = np.maximum(even_paper(np.concatenate(small), PICTURE_REACH), _LEAST_PAPER)
    rows = np.cumsum([0, *(len(values) for values in small)])
    for (top, bottom), start, end in zip(_bands(image), rows[:-1], rows[1:], strict=True):
        band = np.asarray(_on_paper(image.crop((0, top, image.width, bottom))))
        light = enlarged(paper[start:end], (image.width, bottom - top))
        tint[top:bottom] = _tint(_on_white(band, light))
    return grey, tint if tint.any() else None


def _bands(image: Image.Image) -> Iterator[tuple[int, int]]:
    """First row, and the one after the last, of the parts in which a picture is converted: a large
    sheet as RGBA takes four bytes a pixel, and as much for each step."""
    for top in range(0, image.height, _BAND):
        yield top, min(top + _BAND, image.height)


def _on_white(rgb: np.ndarray, light: npt.NDArray[np.float32]) -> np.ndarray:
    """(h, w, 3) uint8 a picture as it would be with white paper.

    Args:
        rgb: (h, w, 3) uint8.
        light: (h, w, 3) of its paper.
    """
    return np.minimum(rgb * (np.float32(255.0) / light) + 0.5, 255.0).astype(np.uint8)


def _on_paper(image: Image.Image) -> Image.Image:
    """The image as RGB; transparency becomes white."""
    if "A" in image.getbands() or "transparency" in image.info:
        rgba = image.convert("RGBA")
        paper = Image.new("RGBA", rgba.size, "white")
        image = Image.alpha_composite(paper, rgba)
    return image.convert("RGB")


def _tint(rgb: np.ndarray) -> Grey:
    """(h, w) hue + 1 of what is coloured, 0 elsewhere; by what the ink takes of white light, so
    that the pale border of a stroke has the colour of its core."""
    taken = 255 - rgb
    most, least = taken.max(axis=2), taken.min(axis=2)
    coloured = (most >= _LEAST_INK) & (most - least > _LEAST_SATURATION * most)
    hue = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)[..., 0]
    return np.where(coloured, hue + 1, 0).astype(np.uint8)


def _scaled(values: np.ndarray, sixteen_bits: bool) -> Grey:
    """(h, w) numbers of any depth as grey levels."""
    largest = float(np.nanmax(values))
    if sixteen_bits or largest > 255.0:
        top = max(65535.0, largest)
    else:
        top = 1.0 if largest <= 1.0 else 255.0
    levels = np.nan_to_num(values.astype(np.float32)) * np.float32(255.0 / top)
    return np.clip(np.rint(levels), 0.0, 255.0).astype(np.uint8)


def _resolutions(image: Image.Image) -> tuple[float, float] | None:
    """Pixels per inch across and down of the upright picture, as the file says, where drawings are
    scanned so; before it is loaded."""
    turned = image.getexif().get(ExifTags.Base.Orientation) in _QUARTER_TURNS
    try:
        across, down = (float(value) for value in image.info["dpi"])
    except (KeyError, TypeError, ValueError, ZeroDivisionError):
        return None
    believable = all(_MIN_DPI <= value <= _MAX_DPI for value in (across, down))
    if not believable:
        return None
    return (down, across) if turned else (across, down)


def _paper_resolution(both: tuple[float, float] | None, longest: int) -> float | None:
    """The one resolution of square pixels, unless that is a program's mere default.

    Args:
        both: pixels per inch across and down.
        longest: side of the picture, px.
    """
    if both is None or abs(both[0] - both[1]) > _SQUARE * both[0]:
        return None
    if abs(both[0] - CSS_DPI) < 0.1 or not _MIN_PAPER <= longest / both[0] <= _MAX_PAPER:
        return None
    return sum(both) / 2.0


def _is_unequal(across: float, down: float) -> bool:
    """Whether pixels are as much higher or wider than the other way as those of faxes are."""
    ratio = max(across, down) / min(across, down)
    return 1.0 + _SQUARE < ratio <= _MOST_UNEQUAL


def _squared(
    path: Path, picture: tuple[Grey, Grey | None], both: tuple[float, float], pages: int
) -> FileContent:
    """A picture of unequal resolutions at the higher one in both directions.

    Raises:
        UnreadableError: ``image-too-large``.
    """
    grey, tint = picture
    dpi = max(both)
    height, width = grey.shape
    size = (round(width * dpi / both[0]), round(height * dpi / both[1]))
    check_pixels(path, *size)
    message = Message(
        "{name} has {across} x {down} dpi and was resampled to {dpi} both ways: places are "
        "given in "
        "px of that",
        name=path.name,
        across=round(both[0]),
        down=round(both[1]),
        dpi=round(dpi),
    )
    return FileContent(
        np.asarray(cv2.resize(grey, size, interpolation=cv2.INTER_CUBIC), dtype=np.uint8),
        _paper_resolution((dpi, dpi), max(size)),
        notes=(Note(Code.PIXELS_MADE_SQUARE, message),),
        tint=None
        if tint is None
        else np.asarray(cv2.resize(tint, size, interpolation=cv2.INTER_NEAREST), dtype=np.uint8),
        pages=pages,
    )
