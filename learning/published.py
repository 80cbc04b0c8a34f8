"""Published sheets with the truth: to learn from, or to check on.

A folder has for each sheet SOURCE+NAME.img.png (dark ink on light paper, wide lines about three px
wide), SOURCE+NAME.lab.png (classes as in :class:`.Sample`) and, where it is known,
SOURCE+NAME.ext.png (extra as in :class:`.Sample`).  ``LICENCES.json`` beside them maps sources to
licences.
"""

import json
import math
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from gaussiancad_protocol.codes import Code
from learning.sheets.rendering import Rendered
from learning.sheets.spoiling import spoiled
from learning.training_samples import UNKNOWN, Bytes, Sample

LICENCES = "LICENCES.json"

NOT_TOLD = "not told"
"""Licence of a source that the folder does not name."""

_PICTURE, _CLASSES, _EXTRA = ".img.png", ".lab.png", ".ext.png"

_FACTORS = (0.45, 1.45)
"""Factors between which a crop is made smaller or larger."""

_SPOILED = 0.6
"""Share of the crops that look scanned, copied or photographed."""

_STEP = 8
"""px between the pixels of which one becomes a crop's middle."""


@dataclass(frozen=True, eq=False)
class PublishedSheet:
    """A sheet of somebody.

    Attributes:
        source: whose it is.
        name: of the sheet.
        truth: of all of it.
    """

    source: str
    name: str
    truth: Sample


@dataclass(frozen=True)
class Published:
    """The sheets of a folder.

    Attributes:
        sheets: by name.
        licences: of each source.
    """

    sheets: tuple[PublishedSheet, ...] = ()
    licences: tuple[tuple[str, str], ...] = ()

    def counts(self) -> Counter[str]:
        """Sheets of each source."""
        return Counter(sheet.source for sheet in self.sheets)


def published_sheets(folder: Path) -> Published:
    """Read the sheets of a folder.

    Raises:
        UnreadableError: ``file-missing``, ``damaged-image``, ``file-unreadable``.
        UsageError: ``no-sheets``.
    """
    if not folder.is_dir():
        raise UnreadableError(
            Code.FILE_MISSING, "{path} is no folder: check the name of the sheets'", path=folder
        )
    sheets = tuple(_sheet(path) for path in sorted(folder.glob(f"*{_PICTURE}")))
    if not sheets:
        raise UsageError(
            Code.NO_SHEETS,
            "{path} has no sheet with the truth: name a folder of NAME.img.png and NAME.lab.png",
            path=folder,
        )
    stated = _licences(folder / LICENCES)
    sources = sorted({sheet.source for sheet in sheets})
    return Published(sheets, tuple((source, stated.get(source, NOT_TOLD)) for source in sources))


def published_crop(
    sheets: tuple[PublishedSheet, ...], size: int, rng: np.random.Generator
) -> Sample:
    """A crop of one of the sheets, most about the part's lines, at another scale.

    Args:
        sheets: one at least.
        size: px of the crop's sides.
        rng: says which.
    """
    sheet = sheets[rng.integers(len(sheets))].truth
    low, high = map(math.log, _FACTORS)
    factor = math.exp(rng.uniform(low, high))
    window = _window(sheet.classes, math.ceil(size / factor), rng)
    crop = Sample(
        _scaled(sheet.grey[window], factor, size, 255, smooth=True),
        _scaled(sheet.classes[window], factor, size, InkClass.PAPER, smooth=False),
        _scaled(sheet.extra[window], factor, size, 0, smooth=False),
    )
    if rng.random() >= _SPOILED:
        return crop
    return spoiled(Rendered(255 - crop.grey, crop.classes, crop.extra, None), rng)


def _window(classes: Bytes, side: int, rng: np.random.Generator) -> tuple[slice, slice]:
    """Rows and columns of a crop about a pixel of the part; of all where there is less."""
    rows, columns = np.nonzero(np.isin(classes[::_STEP, ::_STEP], PART))
    middle = (classes.shape[0] // 2, classes.shape[1] // 2)
    if len(rows):
        number = rng.integers(len(rows))
        middle = (int(rows[number]) * _STEP, int(columns[number]) * _STEP)
    moved = [int(at + rng.integers(-side // 3, side // 3 + 1)) for at in middle]
    starts = [
        int(np.clip(at - side // 2, 0, max(0, whole - side)))
        for at, whole in zip(moved, classes.shape, strict=True)
    ]
    return slice(starts[0], starts[0] + side), slice(starts[1], starts[1] + side)


def _scaled(values: Bytes, factor: float, size: int, blank: int, smooth: bool) -> Bytes:
    """(size, size) a piece at another scale; blank where there is no more of it."""
    way = cv2.INTER_NEAREST
    if smooth:
        way = cv2.INTER_AREA if factor < 1.0 else cv2.INTER_LINEAR
    sides = [max(1, round(side * factor)) for side in values.shape]
    scaled = cv2.resize(values, (sides[1], sides[0]), interpolation=way)[:size, :size]
    made = np.full((size, size), blank, np.uint8)
    made[: scaled.shape[0], : scaled.shape[1]] = scaled
    return made


def _sheet(path: Path) -> PublishedSheet:
    name = path.name.removesuffix(_PICTURE)
    grey = _read(path)
    classes = _read(path.with_name(name + _CLASSES))
    adjacent_path = path.with_name(name + _EXTRA)
    extra = _read(adjacent_path) if adjacent_path.exists() else np.full_like(classes, UNKNOWN)
    if not grey.shape == classes.shape == extra.shape:
        raise UnreadableError(
            Code.DAMAGED_IMAGE,
            "{path} and the truth beside it differ in size: make them anew",
            path=path,
        )
    return PublishedSheet(name.partition("+")[0], name, Sample(grey, classes, extra))


def _read(path: Path) -> Bytes:
    if not path.exists():
        raise UnreadableError(
            Code.FILE_MISSING, "{path} is missing: a sheet needs the truth beside it", path=path
        )
    values = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    if values is None:
        raise UnreadableError(
            Code.DAMAGED_IMAGE, "{path} is no picture that can be read: make it anew", path=path
        )
    return np.asarray(values, dtype=np.uint8)


def _licences(path: Path) -> dict[str, str]:
    if not path.exists():
        return {}
    try:
        stated = json.loads(path.read_text(encoding="utf-8"))
        return {str(source): str(licence) for source, licence in stated.items()}
    except (OSError, ValueError, AttributeError) as error:
        raise UnreadableError(
            Code.FILE_UNREADABLE,
            "{path} does not map sources to licences ({reason}): correct it",
            path=path,
            reason=error,
        ) from error
