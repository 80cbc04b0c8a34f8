"""An engine that stays: it keeps the sheets that it read, and answers one request after another."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import cv2
import msgspec
import numpy as np

from gaussiancad_core.errors import GaussianCadError, UsageError
from gaussiancad_core.pictures.png_pictures import png_bytes
from gaussiancad_core.processes.events import Listener, Progress, Silence
from gaussiancad_core.readings.correcting import Ink, corrected
from gaussiancad_core.readings.reading_files import open_corrections
from gaussiancad_core.readings.reading_schema import Box, Point, SheetReading
from gaussiancad_core.readings.views_to_reading import READING_FILE
from gaussiancad_core.recognition.load_sheet import open_sheet, tell_image
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.read_run import SHEET_FILE, STAGES, read_sheet_lines, sheet_ink
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage, read_sheet
from gaussiancad_core.storage.outputs import os_error
from gaussiancad_core.storage.single_file import write_whole
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import ResultKind


class Request(msgspec.Struct, frozen=True, kw_only=True):
    """One line of what is asked; which fields count depends on ``do``.

    Attributes:
        id: that the answer carries.
        do: ``render``, ``thumbnail``, ``read``, ``reread``, ``trace`` or ``solve``.
        sheet, page: of which is spoken.
        output: folder of the files that the answer names.
        most: px that a picture is long at most; None for all.
        reading: a file that is solved instead of what is read.
        corrections: a file.
        result: which models are asked for.
        at, box: a place, and where to look around it, px of the sheet as stored.
    """

    id: int
    do: str
    sheet: str
    page: int = 1
    output: str = ""
    most: int | None = None
    reading: str = ""
    corrections: str = ""
    result: ResultKind = ResultKind.SOLID
    at: Point = (0.0, 0.0)
    box: Box = (0.0, 0.0, 0.0, 0.0)


_MOST_OPEN = 4
"""Sheets that stay open: about 100 MB each."""


@dataclass(frozen=True, eq=False)
class _Kept:
    """A sheet that is open, with what corrections ask of it.

    Attributes:
        job: of the request that opened it.
        stamp: time and size of its file.
        sheet: as opened.
        ink: what corrections ask.
        read: how everything that is on it is read, with no one's corrections.
    """

    job: Job
    stamp: tuple[int, int]
    sheet: OpenedSheet
    ink: Ink
    read: Callable[[], SheetReading]


class RequestHandler:
    """Answers requests; the sheets that were asked for last stay open while their files stay."""

    def __init__(self) -> None:
        self._listener: Listener = Silence()
        self._kept: dict[tuple[Path, int], _Kept] = {}

    def answer(self, request: Request, listener: Listener) -> dict[str, Any]:
        """What is asked.

        Args:
            request: what, of which sheet.
            listener: told how far it is.

        Returns:
            JSON values: ``picture``, ``size`` (px of the sheet as stored) and ``pages``,
            ``reading``, ``refused`` (how many reasons there are why no part follows), ``shape``
            (of a stroke, or null), ``report`` and ``status``, as the request has them.

        Raises:
            GaussianCadError: ``unknown-request``, and as of the commands.
        """
        asked = _REQUESTS.get(request.do)
        if asked is None:
            raise UsageError(Code.UNKNOWN_REQUEST, f"there is no request {request.do!r}")
        self._listener = listener
        try:
            return asked(self, request)
        except OSError as error:
            if isinstance(error, GaussianCadError):
                raise
            raise os_error(Path(request.output), error) from error

    def _render(self, request: Request) -> dict[str, Any]:
        """The sheet's picture, as soon as it is there."""
        sheet = self._opened(request).sheet
        found = self._pictured(request, sheet.image, SHEET_FILE)
        return {**found, "size": sheet.size}

    def _thumbnail(self, request: Request) -> dict[str, Any]:
        """The picture of any page; the sheet that is open stays so."""
        image = read_sheet(Path(request.sheet), request.page)
        return self._pictured(request, image, f"page-{request.page}.png")

    def _pictured(self, request: Request, image: SheetImage, name: str) -> dict[str, Any]:
        grey = image.grey
        factor = 1.0 if request.most is None else min(1.0, request.most / max(grey.shape))
        if factor < 1.0:
            small = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
            grey = np.asarray(small, dtype=np.uint8)
        return {"picture": self._write(request, name, png_bytes(grey)), "pages": image.pages}

    def _do_read(self, request: Request) -> dict[str, Any]:
        """Everything that is on the sheet, with no one's corrections."""
        return self._written(request, self._opened(request).read())

    def _reread(self, request: Request) -> dict[str, Any]:
        """The same with corrections, the views read that they box."""
        kept = self._opened(request)
        corrections = open_corrections(Path(request.corrections))
        found = corrected(kept.read(), corrections.ops, kept.ink).reading
        return self._written(request, kept.ink.fill(found))

    def _trace(self, request: Request) -> dict[str, Any]:
        """The stroke at a place."""
        shape = self._opened(request).ink.trace(request.at, request.box)
        return {"shape": dict(shape) if shape is not None else None}

    def _solve(self, request: Request) -> dict[str, Any]:
        """A run with its report; corrections are those of the request alone."""
        from gaussiancad_core.processes.library_behaviour import silence_opencascade
        from gaussiancad_core.run.pipeline import reconstruct
        from gaussiancad_core.storage.outputs import REPORT_FILE

        silence_opencascade()
        kept = self._opened(request)
        job = replace(
            kept.job,
            output=Path(request.output),
            result=request.result,
            given=Path(request.reading) if request.reading else None,
            corrections=Path(request.corrections) if request.corrections else None,
        )
        job.check()
        report = reconstruct(job, self._listener, kept.sheet)
        path = (job.output / REPORT_FILE).resolve()
        return {"report": str(path), "status": report.status.value}

    def _opened(self, request: Request) -> _Kept:
        job = Job(Path(request.sheet), Path(request.output), page=request.page)
        job.check()
        facts = job.sheet.stat()
        stamp = facts.st_mtime_ns, facts.st_size
        key = job.sheet, job.page
        kept = self._kept.pop(key, None)
        if kept is None or kept.stamp != stamp:
            while len(self._kept) >= _MOST_OPEN:
                del self._kept[next(iter(self._kept))]
            sheet = open_sheet(job, self._notes(job))
            read = cache(partial(self._all_of, job, sheet))
            kept = _Kept(job, stamp, sheet, sheet_ink(job, sheet), read)
        # The last of the dictionary is the one that was asked for last.
        self._kept[key] = kept
        return kept

    def _all_of(self, job: Job, sheet: OpenedSheet) -> SheetReading:
        notes = self._notes(job)
        tell_image(sheet.image, notes)
        return read_sheet_lines(job, sheet, notes)[1]

    def _notes(self, job: Job) -> RunNotes:
        return RunNotes(Report("", job.settings()), Progress(self._listener, len(STAGES)))

    def _written(self, request: Request, reading: SheetReading) -> dict[str, Any]:
        refused = sum(problem.severity == "refused" for problem in reading.problems)
        content = msgspec.json.encode(reading) + b"\n"
        return {"reading": self._write(request, READING_FILE, content), "refused": refused}

    def _write(self, request: Request, name: str, content: bytes) -> str:
        folder = Path(request.output)
        folder.mkdir(parents=True, exist_ok=True)
        write_whole(folder / name, content)
        return str((folder / name).resolve())


_REQUESTS: Mapping[str, Callable[[RequestHandler, Request], dict[str, Any]]] = {
    "render": RequestHandler._render,
    "thumbnail": RequestHandler._thumbnail,
    "read": RequestHandler._do_read,
    "reread": RequestHandler._reread,
    "trace": RequestHandler._trace,
    "solve": RequestHandler._solve,
}
