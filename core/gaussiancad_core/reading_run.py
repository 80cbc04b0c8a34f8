"""``gaussiancad read``: a sheet to ``reading.json``, whatever follows from it."""

from dataclasses import replace
from pathlib import Path

import msgspec

from gaussiancad_core.axes import Role
from gaussiancad_core.drawing.files import write_whole
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.events import Listener, Progress, Silence
from gaussiancad_core.job import Job
from gaussiancad_core.opened_sheet import open_sheet
from gaussiancad_core.outputs import os_error
from gaussiancad_core.page_choice import naming_pages
from gaussiancad_core.reading_stage import SheetLines, boxed_views, read_lines, with_unseen
from gaussiancad_core.readings.cleaned_lines import DXF_FILE, SVG_FILE, lines_dxf, lines_svg
from gaussiancad_core.readings.correcting import Ink
from gaussiancad_core.readings.filling import Reread, with_read_views
from gaussiancad_core.readings.partial import partial_lines
from gaussiancad_core.readings.picture import reading_picture
from gaussiancad_core.readings.schema import Problem, SheetReading
from gaussiancad_core.readings.sources import given_reading
from gaussiancad_core.readings.taking import taken_lines
from gaussiancad_core.readings.tracing import tracer
from gaussiancad_core.readings.writing import READING_FILE, refusal, sheet_reading
from gaussiancad_core.registering_stage import registered_lines
from gaussiancad_core.report import Report
from gaussiancad_core.run_notes import RunNotes
from gaussiancad_core.sheet.opened import OpenedSheet
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.reading import ReadView
from gaussiancad_core.verification.preview import png_bytes

PICTURE_FILE = "reading.png"
SHEET_FILE = "sheet.png"

STAGES = ("read", "views", "lines", "masks")


def read_to_file(job: Job, listener: Listener) -> SheetReading:
    """Read a sheet and write ``reading.json``, ``reading.png``, ``sheet.png``, the sheet in grey by
    itself, ``lines.dxf`` and ``lines.svg`` into the job's folder.

    Returns:
        The reading; where no part follows, one of its problems is ``refused``.

    Raises:
        UnreadableError: the sheet cannot be read as a drawing at all.
        UsageError: the folder cannot be written; as of the reading and the corrections that the
            job names.
        LimitError: a limit was reached, or the disk is full.
    """
    notes = RunNotes(Report("", job.settings()), Progress(listener, len(STAGES)))
    sheet = open_sheet(job, notes)
    reading = read_sheet_lines(job, sheet, notes)[1]
    try:
        job.output.mkdir(parents=True, exist_ok=True)
        write_whole(job.output / PICTURE_FILE, reading_picture(reading, *sheet.picture))
        write_whole(job.output / SHEET_FILE, png_bytes(sheet.picture[0]))
        write_whole(job.output / DXF_FILE, lines_dxf(reading))
        write_whole(job.output / SVG_FILE, lines_svg(reading))
        write_whole(job.output / READING_FILE, msgspec.json.encode(reading) + b"\n")
    except OSError as error:
        raise os_error(job.output, error) from error
    listener.send("reading", path=str(Path(job.output / READING_FILE).resolve()))
    return reading


def read_sheet_lines(
    job: Job, sheet: OpenedSheet, notes: RunNotes
) -> tuple[SheetLines, SheetReading]:
    """Views and lines of a sheet as far as they can be read, and what stands in their way."""
    lines, refused = None, []
    try:
        lines = sheet_lines(job, sheet, notes)
        lines = with_unseen(lines, notes)
        registered_lines(job, lines, sheet.turn, notes)
    except NoModelError as error:
        message = naming_pages(error, sheet.image).message
        refused.append(refusal(error.code, message.moved(sheet.turn.box_to_stored)))
    if lines is None:
        lines = partial_lines(job, sheet)
    return lines, _reading(lines, sheet, notes, refused)


def sheet_lines(job: Job, sheet: OpenedSheet, notes: RunNotes) -> SheetLines:
    """Views and lines of a sheet: read, or taken from the files that the job names.

    Raises:
        NoModelError: the sheet has no views that belong together.
        UnreadableError, UsageError: as of :func:`.given_reading` and :func:`.taken_lines`.
    """

    def read() -> SheetReading:
        alone = RunNotes(notes.report, notes.progress)
        return read_sheet_lines(_alone(job), sheet, alone)[1]

    ink = sheet_ink(job, sheet)
    reading = given_reading(job, sheet.image.sha256, read, notes, ink)
    if reading is None:
        return read_lines(job, sheet, notes)
    return taken_lines(job, sheet, reading, notes, reread_in(job, sheet))


def reread_in(job: Job, sheet: OpenedSheet) -> Reread:
    """Reads views in boxes of a sheet."""

    def reread(views: tuple[tuple[Role, Box], ...]) -> tuple[ReadView, ...]:
        alone = RunNotes(Report("", job.settings()), Progress(Silence(), len(STAGES)))
        named = replace(_alone(job), reading=replace(job.reading, views=views))
        return boxed_views(named, sheet, alone)

    return reread


def sheet_ink(job: Job, sheet: OpenedSheet) -> Ink:
    """What corrections ask of a sheet."""
    reread = reread_in(job, sheet)

    def fill(own: SheetReading) -> SheetReading:
        return with_read_views(own, reread, sheet.turn)

    return Ink(fill, tracer(sheet))


def _alone(job: Job) -> Job:
    return replace(job, given=None, corrections=None)


def _reading(
    lines: SheetLines, sheet: OpenedSheet, notes: RunNotes, refused: list[Problem]
) -> SheetReading:
    return sheet_reading(notes.report, lines, sheet.turn, sheet.size, refused)
