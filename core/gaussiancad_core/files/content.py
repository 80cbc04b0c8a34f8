"""What every format's reader returns, and the limits that all of them keep."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_protocol.codes import Code

MAX_PIXELS = 150_000_000
"""Largest sheet that is read: A0 at 300 dpi has 139 million pixels."""

MOST_WORKED_ON = 24_000_000
"""Pixels that are worked on, within 2 GB of memory: A3 at 350 dpi."""

LONGEST_TEXT = 1000
"""Letters of a text that are read, and lines of a paragraph: more say nothing of a drawing."""

MIN_SIDE = 64
"""Shortest side in px under which three views cannot be told from each other."""

VECTOR_DPI = 200.0
"""Resolution at which PDF, SVG and DXF sheets are drawn, if they are not too large for that."""

CSS_DPI = 96.0
"""Pixels of an inch in CSS, and in pictures of programs that know nothing of paper."""

DEEPEST = 32
"""Blocks in blocks of a DXF file, and forms in forms of a PDF, at most."""

MAX_PAGES = 1000
"""Pages of a file over which it is no drawing."""

MAX_ELEMENTS = 100_000
"""Lines and other elements of a vector page, blocks and reused parts counted as often as shown."""

PAPER_LEVEL = 250
"""From this level on, of 255, a colour is white paper."""

Grey = npt.NDArray[np.uint8]
"""(h, w)"""


@dataclass(frozen=True)
class Note:
    """Something about a file that its reader should know.

    Attributes:
        code: kebab-case, listed among the warnings in the docs.
        message: one sentence: a :class:`.Message` where it has values.
        is_doubt: whether it puts what is made of the sheet in doubt; otherwise it is a warning.
    """

    code: str
    message: str
    is_doubt: bool = False


@dataclass(frozen=True)
class FileContent:
    """A page of a file.

    Attributes:
        grey: (h, w) uint8, as it is drawn on white paper.
        pixels_per_inch: of the paper, or of what is drawn where a DXF draws it in the part's own
            size; where the file says it believably.
        vectors: exact lines and texts, where the file has them.
        notes: what was left out or assumed.
        tint: (h, w) uint8, 0 where ink or paper has no colour, else 1 to 180 by its hue in steps of
            two degrees; None where nothing has.
        pages: of the file.
        brought_together: the one page that shows parts of this one through several windows, as a
            paper layout does; None where no page does, or several.
    """

    grey: Grey
    pixels_per_inch: float | None = None
    vectors: VectorDrawing | None = None
    notes: tuple[Note, ...] = ()
    tint: Grey | None = None
    pages: int = 1
    brought_together: int | None = None


def check_pixels(path: Path, width: float, height: float) -> None:
    """Refuse a sheet that is too large or too small.

    Raises:
        UnreadableError: ``image-too-large``, ``image-too-small``.
    """
    if width * height > MAX_PIXELS:
        raise too_large(path, f"{width:.0f} x {height:.0f}")
    if min(width, height) < MIN_SIDE:
        raise UnreadableError(
            Code.IMAGE_TOO_SMALL,
            "{path} has only {width} x {height} px: export the drawing at 1920 x 1080 px or more",
            path=path,
            width=round(width),
            height=round(height),
        )


def too_large(path: Path, size: str) -> UnreadableError:
    """The error for a sheet of so many pixels."""
    return UnreadableError(
        Code.IMAGE_TOO_LARGE,
        "{path} is too large ({most} million pixels are read, it has {size}): export or scan it at "
        "a lower resolution, vector drawings on smaller paper",
        path=path,
        most=MAX_PIXELS // 1_000_000,
        size=size,
    )


def page_missing(path: Path, count: int, page: int) -> UnreadableError:
    """The error for a page that a file does not have."""
    return UnreadableError(
        Code.PAGE_MISSING,
        "{path} has {count} page(s), there is no page {page}: choose another",
        path=path,
        count=count,
        page=page,
    )


def too_many_pages(path: Path, count: int) -> UnreadableError:
    """The error for a file of more pages than any set of drawings has."""
    return UnreadableError(
        Code.TOO_MANY_PAGES,
        "{path} has {count} pages, at most {most} are read: save the sheet in a file by itself",
        path=path,
        count=count,
        most=MAX_PAGES,
    )


def too_many_elements(path: Path) -> LimitError:
    """The error for a vector page that would take too long."""
    return LimitError(
        Code.TOO_MANY_ELEMENTS,
        "{path} has more than {most:,} lines and other elements: "
        "save only the views, or export it as PNG",
        path=path,
        most=MAX_ELEMENTS,
    )
