"""Read a sheet from a file of any kind: a grey image, and exact lines where the file has them."""

import hashlib
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.content import MAX_PIXELS, MIN_SIDE, MOST_WORKED_ON, Note
from gaussiancad_core.files.duplicates import distinct_strokes
from gaussiancad_core.files.file_kinds import detect
from gaussiancad_core.files.file_opening import cannot_open, head_of
from gaussiancad_core.files.isolation import read_isolated
from gaussiancad_core.files.sizing import UNIT_UNKNOWN
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.messages import Message
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_core.sheet.image.working_scale import resampled, working_factor
from gaussiancad_protocol.codes import Code

__all__ = ["MAX_PIXELS", "MIN_SIDE", "SheetImage", "read_sheet"]


@dataclass(frozen=True)
class SheetImage:
    """A sheet upright, pictures at the pixels at which they are read, vector sheets at 200 dpi.

    Attributes:
        path: where it was read from.
        grey: (h, w) uint8, dark ink on light paper.
        sha256: of the file's bytes, hexadecimal.
        pixels_per_inch: of the paper, or of what is drawn where a DXF draws it in the part's own
            size; where the file says it believably.
        vectors: exact lines and texts in px of ``grey``, where the file has them.
        notes: what was left out or assumed.
        reduction: px of the sheet as stored per px of ``grey``.
        tint: (h, w) uint8, hue + 1 of coloured ink, 0 elsewhere; None where there is none.
        pages: of the file.
        brought_together: as of :class:`.FileContent`.
    """

    path: Path
    grey: npt.NDArray[np.uint8]
    sha256: str
    pixels_per_inch: float | None = None
    vectors: VectorDrawing | None = None
    notes: tuple[Note, ...] = ()
    reduction: float = 1.0
    tint: npt.NDArray[np.uint8] | None = None
    pages: int = 1
    brought_together: int | None = None


def read_sheet(path: Path, page: int = 1) -> SheetImage:
    """Read a sheet from a PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF file.

    EXIF rotation is applied, transparency becomes white paper, and light ink on dark paper is
    inverted; a photograph is straightened and its paper cut out
    (:mod:`.photographs`).  Pictures are resampled to the width of lines that
    is read (:mod:`.working_scale`), to :data:`MOST_WORKED_ON` pixels at most;
    where that takes detail off, a note says so.  Nothing outside the file is ever opened.

    Args:
        path: the file; its content tells its kind, its name only where the content does not.
        page: of a TIFF, PDF or DXF file, counted from 1.

    Raises:
        UnreadableError: the file is missing, empty, of no such kind, damaged, encrypted or too
            large, or has no such page.
        LimitError: reading it would take too long.
    """
    kind = detect(head_of(path), path.suffix)
    sha256 = _sha256(path)
    content = read_isolated(kind, path, page)
    grey, tint = content.grey, content.tint
    made = None
    if content.vectors is None:
        # A file with strokes waits for nothing that straightens photographs.
        from gaussiancad_core.sheet.image.photographs import straightened

        made = straightened(grey, tint)
    if made is not None:
        grey, tint = made.grey, made.tint
    elif np.median(grey) < 128:
        # The paper's colour is no pen's.
        grey, tint = 255 - grey, None
    slanted = made is not None and made.slant > 0.0
    image = SheetImage(
        path,
        grey,
        sha256,
        None if slanted else content.pixels_per_inch,
        _without_duplicates(content.vectors),
        content.notes if made is None else (*content.notes, made.note),
        tint=tint,
        pages=content.pages,
        brought_together=content.brought_together,
    )
    return _at_working_scale(image) if content.vectors is None else image


def in_unit(image: SheetImage, unit_mm: float) -> SheetImage:
    """A sheet whose file does not say its unit, once that is known; any other as it is.

    Args:
        image: as read.
        unit_mm: mm to the unit of its lengths.
    """
    drawing = image.vectors
    if drawing is None or drawing.unit_px is None:
        return image
    return replace(
        image,
        pixels_per_inch=drawing.unit_px * MM_PER_INCH / unit_mm,
        vectors=replace(drawing, unit_px=None, unit_mm=None if drawing.has_paper else unit_mm),
        notes=tuple(note for note in image.notes if note.code != UNIT_UNKNOWN),
    )


def _without_duplicates(drawing: VectorDrawing | None) -> VectorDrawing | None:
    if drawing is None:
        return None
    return replace(drawing, strokes=distinct_strokes(drawing.strokes))


def _at_working_scale(image: SheetImage) -> SheetImage:
    """The picture with lines of the width that is read, but of no more pixels than memory suffices
    for: about 60 bytes a pixel are needed."""
    height, width = image.grey.shape
    wanted = working_factor(image.grey)
    most = float(np.sqrt(MOST_WORKED_ON / (height * width)))
    factor = min(wanted, most)
    if factor == 1.0:
        return image
    size = (round(width * factor), round(height * factor))
    # Both directions get the same factor but for a part of a pixel over the whole sheet.
    reduction = width / size[0]
    tint = image.tint
    if tint is not None:
        tint = np.asarray(cv2.resize(tint, size, interpolation=cv2.INTER_NEAREST), dtype=np.uint8)
    notes = image.notes
    if most < min(wanted, 1.0):
        message = Message(
            "the sheet has {width} x {height} px and was read at {read_width} x {read_height}: "
            "measures are known less well; a cut around the views is read as it is",
            width=width,
            height=height,
            read_width=size[0],
            read_height=size[1],
        )
        notes = (*notes, Note(Code.RESOLUTION_LOWERED, message))
    return replace(
        image,
        grey=resampled(image.grey, size),
        pixels_per_inch=image.pixels_per_inch and image.pixels_per_inch / reduction,
        notes=notes,
        reduction=reduction,
        tint=tint,
    )


def _sha256(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise cannot_open(path, error) from error
