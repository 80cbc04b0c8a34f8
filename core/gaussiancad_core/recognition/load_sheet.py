"""The stage read: a file to its picture, and what is told of it."""

from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage, in_unit, read_sheet


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


def open_sheet(job: Job, notes: RunNotes) -> OpenedSheet:
    """The stage as a whole.

    Raises:
        UnreadableError, LimitError: as of :func:`.read_sheet`.
    """
    with notes.stage("read"):
        return OpenedSheet(open_image(job, notes), job.reading.median_kernel)
