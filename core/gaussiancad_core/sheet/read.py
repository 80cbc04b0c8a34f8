"""Read a raster file into one grey image, within bounded memory."""

import hashlib
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageOps, ImageSequence, UnidentifiedImageError

from gaussiancad_core.errors import UnreadableError

MAX_PIXELS = 150_000_000
"""Largest sheet that is read: A0 at 300 dpi has 139 million pixels."""

MIN_SIDE = 64
"""Shortest side in px under which three views cannot be told from each other."""

RASTER_SUFFIXES = frozenset({".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp"})

_FORMATS = ("PNG", "JPEG", "TIFF", "BMP", "WEBP")
_VECTOR_SUFFIXES = frozenset({".pdf", ".svg", ".dxf"})


@dataclass(frozen=True)
class SheetImage:
    """A sheet as it was stored, upright.

    Attributes:
        path: where it was read from.
        grey: (h, w) uint8, dark ink on light paper.
        sha256: of the file's bytes, hexadecimal.
    """

    path: Path
    grey: npt.NDArray[np.uint8]
    sha256: str


def read_sheet(path: Path, page: int = 1) -> SheetImage:
    """Read a sheet from a PNG, JPEG, TIFF, BMP or WebP file.

    EXIF rotation is applied, transparency becomes white paper, and light ink on dark paper is
    inverted.

    Args:
        path: the file.
        page: which image of a multi-page TIFF, counted from 1.

    Raises:
        UnreadableError: the file is missing, empty, not an image, damaged or too large.
    """
    data = _file_bytes(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(path, formats=_FORMATS)
            _check_size(path, image)
            image = _select_page(path, image, page)
            _check_size(path, image)
            grey = _to_grey(image)
    except UnidentifiedImageError as error:
        raise UnreadableError(
            "not-an-image",
            f"{path} is not a PNG, JPEG, TIFF, BMP or WebP image: export the drawing as PNG",
        ) from error
    except Image.DecompressionBombError as error:
        raise _too_large(path, "many more") from error
    except UnreadableError:
        raise
    except (OSError, ValueError, SyntaxError, EOFError) as error:
        raise UnreadableError(
            "damaged-image", f"{path} is damaged ({error}): export or scan the drawing again"
        ) from error
    if np.median(grey) < 128:
        grey = 255 - grey
    return SheetImage(path, grey, hashlib.sha256(data).hexdigest())


def _file_bytes(path: Path) -> bytes:
    suffix = path.suffix.lower()
    if path.is_dir():
        raise UnreadableError("not-a-file", f"{path} is a folder: name a drawing file")
    if not path.exists():
        raise UnreadableError("file-missing", f"{path} does not exist: check the name of the sheet")
    if suffix in _VECTOR_SUFFIXES:
        raise UnreadableError(
            "format-not-supported",
            f"{path}: {suffix[1:].upper()} sheets are not read by this version: export it as PNG",
        )
    try:
        data = path.read_bytes()
    except OSError as error:
        raise UnreadableError(
            "file-unreadable", f"{path} cannot be opened ({error.strerror}): check its permissions"
        ) from error
    if not data:
        raise UnreadableError("empty-file", f"{path} is empty: export the drawing again")
    return data


def _check_size(path: Path, image: Image.Image) -> None:
    if image.width * image.height > MAX_PIXELS:
        raise _too_large(path, f"{image.width} x {image.height}")
    if min(image.width, image.height) < MIN_SIDE:
        raise UnreadableError(
            "image-too-small",
            f"{path} has only {image.width} x {image.height} px: "
            "export the drawing at 1920 x 1080 px or more",
        )


def _too_large(path: Path, size: str) -> UnreadableError:
    return UnreadableError(
        "image-too-large",
        f"{path} is too large ({MAX_PIXELS // 1_000_000} million pixels are read, it has {size}): "
        "export or scan it at a lower resolution",
    )


def _select_page(path: Path, image: Image.Image, page: int) -> Image.Image:
    count = getattr(image, "n_frames", 1)
    if not 1 <= page <= count:
        raise UnreadableError(
            "page-missing", f"{path} has {count} page(s), there is no page {page}: choose another"
        )
    return image if page == 1 else ImageSequence.Iterator(image)[page - 1]


def _to_grey(image: Image.Image) -> npt.NDArray[np.uint8]:
    """(h, w) uint8 luminance of an image on white paper."""
    image = ImageOps.exif_transpose(image)
    if image.mode.startswith("I") or image.mode == "F":
        values = np.asarray(image, dtype=np.float64)
        top = 65535.0 if values.max() > 255 else 255.0
        return np.clip(values * (255.0 / top), 0, 255).astype(np.uint8)
    if "A" in image.getbands() or "transparency" in image.info:
        rgba = image.convert("RGBA")
        paper = Image.new("RGBA", rgba.size, "white")
        image = Image.alpha_composite(paper, rgba)
    return np.array(image.convert("L"))
