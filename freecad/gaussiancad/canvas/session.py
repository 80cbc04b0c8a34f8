"""One sheet at work: what was read, what a person says, and the part that follows.

The engines stay, and may be those of other sheets, too: one keeps the sheets' ink and reads, one
solves and is ended where what it solves is out of date.  Where a file has several pages, a third
makes their pictures.
"""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

from freecad.gaussiancad.canvas.corrections_preview import corrected
from freecad.gaussiancad.canvas.corrections_storage import (
    CorrectionsStore,
    read_again,
    write_corrections,
)
from freecad.gaussiancad.canvas.engine_server import Answer, Engines, Server
from freecad.gaussiancad.canvas.sheet import Point, Sheet, shape_in, sheet_of
from freecad.gaussiancad.engine.wording import Place, worded
from freecad.gaussiancad.qt import QtCore

_REST_MS = 400
"""Milliseconds without a correction after which the part is made again."""


def _worded(answer: Answer) -> str:
    """Why an answer is none."""
    error = answer.get("error", {})
    return worded(error.get("code", ""), error.get("message", ""), error.get("args"), Place.CANVAS)


class Session(QtCore.QObject):
    """The sheet, without anything that is seen.

    Args:
        path: of the sheet.
        page: of a file with pages.
        engines: that read and solve.
        store: of the corrections.
        parent: its owner.

    Signals:
        pictured: path of the sheet's picture, its size in px as stored, and pages of the file.
        read: the sheet was read, for the first time or again.
        changed: what is to be shown has changed.
        solved: report and folder of a run; the folder is empty where no part follows.
        message: a line for the person.
        working: whether an engine is at work has changed.
        stage: name of what an engine does now.
    """

    pictured = QtCore.Signal(str, object, int)
    read = QtCore.Signal()
    changed = QtCore.Signal()
    solved = QtCore.Signal(object, str)
    message = QtCore.Signal(str)
    working = QtCore.Signal()
    stage = QtCore.Signal(str)

    def __init__(
        self,
        path: Path,
        page: int,
        engines: Engines,
        store: CorrectionsStore,
        parent: QtCore.QObject,
    ) -> None:
        super().__init__(parent)
        self.path, self.page, self.store = path, page, store
        self.live = True
        self._folder = tempfile.TemporaryDirectory(
            prefix="gaussiancad-", ignore_cleanup_errors=True
        )
        self._reader, self._solver = Server(engines.reader, self), Server(engines.solver, self)
        self._clerk = Server(engines.clerk, self)
        for item in (self._reader, self._solver):
            item.changed.connect(self.working)
            item.stage.connect(self.stage)
        self._read: Sheet | None = None
        self._reading = Path()
        self._within: list[dict] = []
        self._shown: list[dict] = []
        self._runs = 0
        self._rest = QtCore.QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(_REST_MS)
        self._rest.timeout.connect(self.solve)

    @property
    def sheet(self) -> Sheet | None:
        """What is to be shown; None while the sheet is read."""
        if self._read is None:
            return None
        return corrected(self._read, self.store.operations[len(self._within) :])

    @property
    def reading(self) -> bool:
        """Whether the sheet is read."""
        return self._reader.busy

    @property
    def solving(self) -> bool:
        """Whether a part is made."""
        return self._solver.busy

    @property
    def reading_file(self) -> Path:
        """What was read, with the views that a person boxed."""
        return self._reading

    def start(self) -> None:
        """Read the sheet; the other engine warms up meanwhile."""
        folder = Path(self._folder.name)
        self._reader.ask("render", self._was_rendered, **self._asked(folder))
        self._read_sheet()
        self._solver.ask("render", lambda _: None, **self._asked(folder / "warm"))

    def correct(self, operations: list[dict]) -> None:
        """Take corrections as one step; nothing is taken before the sheet is read."""
        if self._read is not None and operations:
            self.store.add(operations)
            self.refresh()

    def refresh(self) -> None:
        """Follow what the store has, whoever changed it."""
        if self._read is None or self.store.operations == self._shown:
            return
        self._shown = list(self.store.operations)
        self._solver_stops()
        self.changed.emit()
        if read_again(self._shown) != self._within:
            self._read_sheet()
        elif self.live:
            self._rest.start()

    def solve(self) -> None:
        """Make the part, with what was said; a run that goes on is out of date."""
        self._rest.stop()
        if self._read is None or self._reader.busy:
            return
        self._solver_stops()
        self._runs += 1
        folder = Path(self._folder.name) / f"part-{self._runs}"
        asked = Path(self._folder.name) / f"asked-{self._runs}"
        asked.mkdir()
        reading, corrections = self._handed_over(asked)
        more = {"reading": str(reading)}
        if corrections is not None:
            more["corrections"] = str(corrections)

        def done(answer: Answer) -> None:
            self._was_solved(answer, folder)

        self._solver.ask("solve", done, **self._asked(folder), **more)

    def stop(self) -> None:
        """Break off making the part."""
        self._rest.stop()
        self._solver_stops()

    def _handed_over(self, folder: Path) -> tuple[Path, Path | None]:
        """Write what was read, and what was said of it since, into a folder; no second file where
        nothing was said."""
        reading = folder / "reading.json"
        shutil.copyfile(self._reading, reading)
        rest = self.store.operations[len(self._within) :]
        if not rest or self._read is None:
            return reading, None
        corrections = folder / "corrections.json"
        write_corrections(corrections, self._read.sha256, rest)
        return reading, corrections

    def trace(self, at: Point, done: Callable[[tuple[str, tuple] | None], None]) -> None:
        """Ask for the stroke whose ink lies at a place of a view."""
        view = self.sheet.view_at(at) if self.sheet is not None else None
        if view is None:
            done(None)
            return
        box = [view.box[0] - 4, view.box[1] - 4, view.box[2] + 4, view.box[3] + 4]

        def answered(answer: Answer) -> None:
            done(shape_in(answer.get("shape") or {}))

        folder = Path(self._folder.name)
        self._reader.ask("trace", answered, at=list(at), box=box, **self._asked(folder))

    def thumbnail(self, page: int, most: int, done: Callable[[str], None]) -> None:
        """Ask for the picture of any page, so many px long; the answer is its path, or nothing."""
        asked = {**self._asked(Path(self._folder.name) / "pages"), "page": page, "most": most}
        self._clerk.ask("thumbnail", lambda answer: done(answer.get("picture", "")), **asked)

    def close(self) -> None:
        """Leave the engines and remove what they wrote."""
        self._rest.stop()
        for item in (self._reader, self._solver, self._clerk):
            item.close()
        self._folder.cleanup()

    def _asked(self, folder: Path) -> dict[str, object]:
        return {"sheet": str(self.path), "page": self.page, "output": str(folder)}

    def _solver_stops(self) -> None:
        if self._solver.busy and self._runs:
            self._solver.stop()

    def _read_sheet(self) -> None:
        folder = Path(self._folder.name) / "read"
        within = read_again(self.store.operations)
        if within and self._read is not None:
            path = Path(self._folder.name) / "read.corrections.json"
            write_corrections(path, self._read.sha256, within)
            more, do = {"corrections": str(path)}, "reread"
        else:
            within, more, do = [], {}, "read"

        def done(answer: Answer) -> None:
            self._was_read(answer, within)

        self._reader.ask(do, done, **self._asked(folder), **more)

    def _was_rendered(self, answer: Answer) -> None:
        if "picture" in answer:
            self.pictured.emit(answer["picture"], tuple(answer["size"]), answer["pages"])

    def _was_read(self, answer: Answer, within: list[dict]) -> None:
        if "reading" not in answer:
            self.message.emit(_worded(answer))
            return
        first = self._read is None
        self._reading = Path(answer["reading"])
        self._read = sheet_of(json.loads(self._reading.read_text(encoding="utf-8")))
        self._within = within
        if first:
            self.read.emit()
        self._shown = list(self.store.operations)
        self.changed.emit()
        if read_again(self._shown) != self._within:
            self._read_sheet()
        elif self.live and (self._shown or not answer.get("refused")):
            self.solve()

    def _was_solved(self, answer: Answer, folder: Path) -> None:
        try:
            report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            self.message.emit(_worded(answer))
            return
        self.solved.emit(report, "" if "error" in answer else str(folder))
