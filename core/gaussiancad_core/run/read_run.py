"""``gaussiancad read``: a sheet to ``reading.json``, whatever follows from it."""

from dataclasses import replace
from pathlib import Path

import msgspec

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Role
from gaussiancad_core.pictures.png_pictures import png_bytes
from gaussiancad_core.processes.events import Listener, Progress, Silence
from gaussiancad_core.processes.garbage import uncollected
from gaussiancad_core.readings.boxed_views import Reread, with_read_views
from gaussiancad_core.readings.cleaned_lines import DXF_FILE, SVG_FILE, lines_dxf, lines_svg
from gaussiancad_core.readings.correcting import Ink
from gaussiancad_core.readings.line_sources import given_reading
from gaussiancad_core.readings.partial_reading import partial_lines
from gaussiancad_core.readings.pointed_stroke import tracer
from gaussiancad_core.readings.reading_picture import reading_picture
from gaussiancad_core.readings.reading_schema import Problem, SheetReading
from gaussiancad_core.readings.reading_to_views import taken_lines
from gaussiancad_core.readings.views_to_reading import READING_FILE, refusal, sheet_reading
from gaussiancad_core.recognition.load_sheet import open_sheet
from gaussiancad_core.recognition.page_choice import naming_pages
from gaussiancad_core.recognition.views_and_lines import (
    SheetLines,
    boxed_views,
    read_lines,
    with_unseen,
)
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.registering_stage import registered_lines
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.storage.outputs import os_error
from gaussiancad_core.storage.single_file import write_whole

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
    with uncollected():
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

    def fill(reading: SheetReading) -> SheetReading:
        return with_read_views(reading, reread, sheet.turn)

    return Ink(fill, tracer(sheet))


def _alone(job: Job) -> Job:
    return replace(job, given=None, corrections=None)


def _reading(
    lines: SheetLines, sheet: OpenedSheet, notes: RunNotes, refused: list[Problem]
) -> SheetReading:
    return sheet_reading(notes.report, lines, sheet.turn, sheet.size, refused)
