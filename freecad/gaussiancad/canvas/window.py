"""The window of one sheet: what is shown when.

What was understood, a person's corrections, and the verdict; by itself (``gaussiancad correct
SHEET``) and in a dock of FreeCAD.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from freecad.gaussiancad.canvas import corrections
from freecad.gaussiancad.canvas.bars import RunBar, ToolBar
from freecad.gaussiancad.canvas.canvas_view import CanvasView
from freecad.gaussiancad.canvas.changes import Change, change_lines
from freecad.gaussiancad.canvas.corrections_storage import CorrectionsFile, CorrectionsStore
from freecad.gaussiancad.canvas.dialogs import Dialogs
from freecad.gaussiancad.canvas.doubts import doubt_lines
from freecad.gaussiancad.canvas.engine_server import Engines, Program
from freecad.gaussiancad.canvas.gaps import problem_marks
from freecad.gaussiancad.canvas.pages import Pages
from freecad.gaussiancad.canvas.row_actions import RowActions
from freecad.gaussiancad.canvas.rows import Line, Rows
from freecad.gaussiancad.canvas.selection_menu import SelectionMenu
from freecad.gaussiancad.canvas.session import Session
from freecad.gaussiancad.canvas.sheet import Box, Number, Point, Sheet
from freecad.gaussiancad.canvas.verdict import SIGNS, marks_of, verdict_line, verdict_lines
from freecad.gaussiancad.engine.wording import stage_name
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


class SheetWindow(QtWidgets.QMainWindow):
    """The window.

    Args:
        path: of the sheet.
        page: of a file with pages.
        engines: shared with other sheets; of its own where none are given.
        store: of the corrections; a file beside the sheet where none is given.
        parent: in FreeCAD the dock.

    Raises:
        ValueError: the corrections beside the sheet are damaged.

    Signals:
        page_asked: another page of the file.
    """

    page_asked = QtCore.Signal(int)

    def __init__(
        self,
        path: Path,
        page: int = 1,
        *,
        engines: Engines | None = None,
        store: CorrectionsStore | None = None,
        parent: QtWidgets.QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.store = store or CorrectionsFile(path, page)
        self.engines = engines or Engines.of(Program())
        self.session = Session(path, page, self.engines, self.store, self)
        self.canvas_view = CanvasView(self)
        self.problems = Rows(self)
        self._report: dict | None = None
        self._settled: set[str] = set()
        self._pictured = False
        self._left_out: list[Line] = []
        self._changes: tuple[Change, ...] = ()
        self._back: Callable[[], None] = _nothing
        self._menu = SelectionMenu(self.canvas_view)
        self._dialogs = Dialogs(self.canvas_view, self.session, self)
        self._actions = RowActions(self.session, self.canvas_view.take_tool, self._dialogs)
        self._listen()
        self.pages = Pages(self.session.thumbnail, lambda: not self.busy, self)
        self.pages.chosen.connect(self.page_asked)
        split = QtWidgets.QSplitter(QtCore.Qt.Orientation.Vertical)
        split.addWidget(self.canvas_view)
        split.addWidget(self.problems)
        split.setStretchFactor(0, 1)
        split.setStretchFactor(1, 0)
        split.setSizes([600, 220])
        middle = QtWidgets.QWidget()
        layout = QtWidgets.QHBoxLayout(middle)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.pages)
        layout.addWidget(split)
        self.setCentralWidget(middle)
        self._tools = ToolBar(self.canvas_view, self.session.correct, self)
        self._runs = RunBar(self.solve, self.stop, self._set_live, self)
        if self.store.has_undo:
            self._runs.add_steps(self.undo, self.redo)
        self.addToolBar(self._tools)
        self.addToolBarBreak()
        self.addToolBar(self._runs)
        self.setWindowTitle(f"{path.name} \u2013 GaussianCAD")
        self.resize(1280, 900)

    @property
    def sheet(self) -> Sheet | None:
        """What is shown; None while the sheet is read."""
        return self.session.sheet

    @property
    def busy(self) -> bool:
        """Whether an engine reads or solves."""
        return self.session.reading or self.session.solving

    @property
    def operations(self) -> list[dict]:
        """What was said."""
        return self.store.operations

    def start(self) -> None:
        """Read the sheet."""
        self.tell(translate("GaussianCAD", "The sheet is being read\u2026"))
        self.session.start()

    def solve(self) -> None:
        """Make the part, with what was said."""
        self.session.solve()

    def stop(self) -> None:
        """Break off making the part; the one of before stays."""
        self.session.stop()

    def undo(self) -> None:
        """Take the last step back."""
        self.store.undo()
        self.session.refresh()

    def redo(self) -> None:
        """Say it again."""
        self.store.redo()
        self.session.refresh()

    def add_action(self, text: str, called: Callable[[], None]) -> None:
        """Put a button for something else at the end of the toolbar."""
        self._runs.add(text, called)

    def add_help(self, code: str, text: str, called: Callable[[], None]) -> None:
        """Put a button for something else beside what a report says under a code."""
        self._actions.add(code, text, called)

    def show_changes(self, changes: tuple[Change, ...], back: Callable[[], None]) -> None:
        """Show numbers that are others in the body, and a button that takes these back."""
        self._changes, self._back = changes, back
        self.canvas_view.take_changes(changes)
        if self.sheet is not None:
            self.canvas_view.show_sheet(self.sheet)
            self._show_rows()

    def tell(self, text: str) -> None:
        """Put a sentence in place of the list."""
        self.problems.show_lines([Line(item) for item in text.splitlines() if item.strip()])

    def say_view(self, role: str, box: Box) -> None:
        """Say that a box of the sheet is a view."""
        self.session.correct(corrections.add_view(self.sheet, role, box))

    def say_length(self, points: tuple[Point, Point], length: float) -> None:
        """Say how far two points of the sheet are apart, mm."""
        self.session.correct(corrections.set_distance(points, length))

    def say_value(self, number: Number, value_mm: float) -> None:
        """Say what a dimension gives, mm."""
        self.session.correct(corrections.set_value(number, value_mm))

    def say_section(self, view: str, line: tuple[Point, ...], in_view: str) -> None:
        """Say that a view shows the section along a line in another view."""
        self.session.correct(corrections.set_section(view, line, in_view))

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        """Leave the engines with the window."""
        self.session.close()
        super().closeEvent(event)

    def _listen(self) -> None:
        canvas_view, session = self.canvas_view, self.session
        canvas_view.corrected.connect(session.correct)
        canvas_view.asked_view.connect(self.say_view)
        canvas_view.asked_trace.connect(self._trace)
        canvas_view.asked_more.connect(self.statusBar().showMessage)
        canvas_view.asked_next.connect(self.problems.show_next)
        canvas_view.asked_part.connect(self.solve)
        self.problems.place_asked.connect(canvas_view.zoom_to)
        session.pictured.connect(self._show_picture)
        session.read.connect(self._was_read)
        session.changed.connect(self._shown)
        session.solved.connect(self._was_solved)
        session.message.connect(self.tell)
        session.working.connect(self._show_work)
        session.stage.connect(self._show_stage)

    def _show_picture(self, path: str, size: object, pages: int) -> None:
        self.canvas_view.show_picture(path, size)
        self.pages.show_pages(pages, self.session.page)
        if not self._pictured:
            self._pictured = True
            self.canvas_view.fit()

    def _was_read(self) -> None:
        """The first time: show the views, and tell of corrections that are not the sheet's."""
        boxes = [view.box for view in self.sheet.views if view.shown]
        if boxes:
            x0, y0, x1, y1 = zip(*boxes, strict=True)
            self.canvas_view.zoom_to((min(x0), min(y0), max(x1), max(y1)))
        belongs = getattr(self.store, "belongs_to", None)
        if belongs is not None and not belongs(self.session.sheet.sha256):
            kept = translate(
                "GaussianCAD",
                "The corrections beside the sheet are of another version of it: they were left "
                "out, and will be kept as a file of their own.",
            )
            self._left_out = [Line(f"{SIGNS['doubt']} {kept}")]

    def _shown(self) -> None:
        """What was read, or said, has changed: the verdict is out of date."""
        self._report = None
        sheet = self.sheet
        self.canvas_view.show_sheet(sheet)
        self.canvas_view.show_marks(problem_marks(sheet))
        self._show_rows()
        self._tools.show_choices(sheet)

    def _was_solved(self, report: dict, _folder: str) -> None:
        self._report = report
        self.canvas_view.show_marks([*marks_of(report), *problem_marks(self.sheet)])
        self._show_rows()

    def _show_rows(self) -> None:
        """What the last run says; until there is one, what is in doubt of what was read."""
        sheet, report, actions = self.sheet, self._report, self._actions
        problems = sheet.problems if sheet is not None else ()
        doubts = doubt_lines(sheet, self.session.correct) if sheet is not None else []
        if report is not None:
            reasons = [
                item for item in report.get("reasons", ()) if item["code"] not in self._settled
            ]
            lines = verdict_lines({**report, "reasons": reasons}, actions.with_report(), doubts)
        else:
            rows = [
                Line(
                    f"{SIGNS[problem.severity]} {problem.message}",
                    problem.box,
                    actions.with_row(problem),
                )
                for problem in problems
            ]
            grave = sum(problem.severity != "warning" for problem in problems)
            lines = [*rows[:grave], *doubts, *rows[grave:]]
        count = len(self.operations)
        if (
            report is None
            and not count
            and any(problem.severity == "refused" for problem in problems)
        ):
            # What was read makes no part, and nothing was said yet: no run will tell it.
            lines.insert(0, verdict_line("failed"))
        lines += self._left_out
        if sheet is not None:
            lines = [*change_lines(sheet, self._changes, self._back), *lines]
        if report is None:
            lines.append(Line(translate("GaussianCAD", "Corrections by hand: {0}").format(count)))
        self.problems.show_lines(lines)

    def _show_work(self) -> None:
        self._runs.show_work(self.session.solving)
        if self.session.reading:
            text = translate("GaussianCAD", "Reading\u2026")
        elif self.session.solving:
            text = translate("GaussianCAD", "Making the part\u2026")
        else:
            text = translate("GaussianCAD", "Ready")
        self.statusBar().showMessage(text)

    def _show_stage(self, name: str) -> None:
        if self.busy:
            self.statusBar().showMessage(f"{stage_name(name)}\u2026")

    def settle(self, code: str, settled: bool) -> None:
        """Leave out what a report says under a code, as a person has answered it, or not."""
        before = set(self._settled)
        (self._settled.add if settled else self._settled.discard)(code)
        if before != self._settled:
            self._show_rows()

    def _trace(self, at: tuple) -> None:
        def done(shape: tuple[str, tuple] | None) -> None:
            if not self.canvas_view.take_trace(shape, at):
                text = translate("GaussianCAD", "There is no line of a view at this place")
                self.statusBar().showMessage(text)

        self.session.trace(at, done)

    def _set_live(self, live: bool) -> None:
        self.session.live = live


def _nothing() -> None:
    """Without a body there is no way back."""
