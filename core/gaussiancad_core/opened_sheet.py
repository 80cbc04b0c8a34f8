"""The stage read: a file to its picture, and the ink on it, upright."""

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.job import Job
from gaussiancad_core.run_notes import RunNotes
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet, upright_sheet
from gaussiancad_core.sheet.read import SheetImage, in_unit, read_sheet


@dataclass(frozen=True, eq=False)
class OpenedSheet:
    """A sheet as it was stored and upright.

    Attributes:
        image: as stored.
        clean: upright, its ink told from its paper.
    """

    image: SheetImage
    clean: CleanSheet

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the sheet as stored, px."""
        height, width = self.image.grey.shape
        return round(width * self.image.reduction), round(height * self.image.reduction)

    @property
    def picture(self) -> tuple[npt.NDArray[np.uint8], float]:
        """(h, w) uint8, and px of the sheet as stored per px of it."""
        return self.image.grey, self.image.reduction


def open_image(job: Job, notes: RunNotes) -> SheetImage:
    """The picture of a sheet, and what is told of its file.

    Raises:
        UnreadableError, LimitError: as of :func:`.read_sheet`.
    """
    image = read_sheet(job.sheet, job.page)
    if job.reading.unit is not None:
        image = in_unit(image, job.reading.unit.millimetres)
    tell_image(image, notes)
    return image


def tell_image(image: SheetImage, notes: RunNotes) -> None:
    """Put what is known of a sheet's file into the report."""
    notes.tell(sheet_sha256=image.sha256)
    for note in image.notes:
        (notes.doubt if note.is_doubt else notes.warn)(note.code, note.message)


def with_ink(job: Job, image: SheetImage) -> OpenedSheet:
    """The sheet with its ink.

    Raises:
        NoModelError: there is no ink, or too much of it for a line drawing.
    """
    clean = upright_sheet(clean_sheet(image.grey, job.reading.median_kernel), image.vectors)
    clean = replace(clean, turn=replace(clean.turn, scale=image.reduction))
    return OpenedSheet(image, clean)


def open_sheet(job: Job, notes: RunNotes) -> OpenedSheet:
    """The stage as a whole; errors as of both."""
    with notes.stage("read"):
        return with_ink(job, open_image(job, notes))
