"""A window of its own for one sheet: what was understood, corrections, and the part.

``gaussiancad correct SHEET`` opens it.  The engine runs as a process of its own; corrections lie
beside the sheet, where every run takes them.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from freecad.gaussiancad.canvas.board import TOOLS, Board
from freecad.gaussiancad.canvas.history import (
    History,
    corrections_path,
    read_again,
    read_corrections,
    write_corrections,
)
from freecad.gaussiancad.canvas.kinds import KEYS, ROLES, name_of
from freecad.gaussiancad.canvas.sheet import Box, Sheet, corrected, sheet_of
from freecad.gaussiancad.canvas.verdict import MARKS, found_in
from freecad.gaussiancad.engine.verdict import not_started
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


@dataclass(frozen=True)
class Program:
    """How the engine is started.

    Attributes:
        command: program and first arguments.
        environment: variables; None for those of this process.
    """

    command: tuple[str, ...] = (sys.executable, "-m", "gaussiancad_core")
    environment: dict[str, str] | None = None


class SheetWindow(QtWidgets.QMainWindow):
    """The window.

    Args:
        path: of the sheet.
        page: of a PDF file.
        program: the engine.
        parent: in FreeCAD its main window.

    Raises:
        ValueError: the corrections beside the sheet are damaged.

    Signals:
        solved: the folder of a run that made a part.
    """

    solved = QtCore.Signal(str)

    def __init__(
        self,
        path: Path,
        page: int = 1,
        *,
        program: Program | None = None,
        parent: QtWidgets.QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._path, self._page = path, page
        self._program = program or Program()
        self._folder = tempfile.TemporaryDirectory(prefix="gaussiancad-")
        self._history = History(read_corrections(path))
        self._read: Sheet | None = None
        self._within: list[dict] = []
        self._process: QtCore.QProcess | None = None
        self._closed = False
        self.board = Board(self)
        self.board.said.connect(self.say)
        self.board.asked_role.connect(self._ask_role)
        self.board.asked_length.connect(self._ask_length)
        self.board.asked_part.connect(self.solve)
        self.setCentralWidget(self.board)
        self.problems = QtWidgets.QListWidget()
        self.problems.setWordWrap(True)
        self.problems.itemClicked.connect(self._show_place)
        dock = QtWidgets.QDockWidget(translate("GaussianCAD", "Problems"), self)
        dock.setWidget(self.problems)
        self.addDockWidget(QtCore.Qt.DockWidgetArea.RightDockWidgetArea, dock)
        self._add_tools()
        self.setWindowTitle(f"{path.name} \u2013 GaussianCAD")
        self.resize(1280, 800)

    @property
    def sheet(self) -> Sheet | None:
        """What is shown; None while the sheet is read."""
        if self._read is None:
            return None
        return corrected(self._read, self._history.operations[len(self._within) :])

    @property
    def busy(self) -> bool:
        """Whether the engine is at work."""
        return self._process is not None

    @property
    def operations(self) -> list[dict]:
        """What was said."""
        return self._history.operations

    def start(self) -> None:
        """Read the sheet."""
        if self._process is not None:
            return
        # Beside a copy no corrections lie: what the machine read stays apart from what is said,
        # but for views that a person boxed, whose strokes are to be read.
        copy = Path(self._folder.name) / "sheet" / self._path.name
        copy.parent.mkdir(exist_ok=True)
        shutil.copyfile(self._path, copy)
        within = read_again(self._history.operations)
        if within:
            sha256 = hashlib.sha256(copy.read_bytes()).hexdigest()
            write_corrections(copy, sha256, within)
        else:
            corrections_path(copy).unlink(missing_ok=True)
        arguments = ["read", str(copy), "--output", self._folder.name]

        def done(code: int, text: str) -> None:
            self._was_read(code, text, within)

        self._run([*arguments, "--page", str(self._page)], done)

    def solve(self) -> None:
        """Make the part, with what was said."""
        if self._read is None or self._process is not None:
            return
        out = str(Path(self._folder.name) / "part")
        arguments = ["reconstruct", str(self._path), "--output", out, "--result", "solid"]
        self._run([*arguments, "--page", str(self._page)], self._was_solved)

    def say(self, operations: list[dict]) -> None:
        """Take corrections as one step, and keep them beside the sheet.

        Nothing is taken before the sheet is read.
        """
        if self._read is None:
            return
        self._history.say(operations)
        self._kept()

    def undo(self) -> None:
        """Take the last step back."""
        if self._read is not None and self._history.undo():
            self._kept()

    def redo(self) -> None:
        """Say it again."""
        if self._read is not None and self._history.redo():
            self._kept()

    def show_reading(self, reading: dict, picture: Path, within: Sequence[dict] = ()) -> None:
        """Show what was read, with what was said.

        Args:
            reading: of the sheet.
            picture: of it.
            within: the first operations, if the reading has them already.
        """
        first = self._read is None
        self._read, self._within = sheet_of(reading), list(within)
        if first:
            self.board.show_picture(str(picture), self._read.size)
        self._shown()
        if first:
            self.board.fit()
        if read_again(self._history.operations) != self._within:
            self.start()

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        """End the engine with the window."""
        self._closed = True
        if self._process is not None:
            self._process.kill()
            self._process.waitForFinished()
        self._folder.cleanup()
        super().closeEvent(event)

    def _kept(self) -> None:
        write_corrections(self._path, self._read.sha256, self._history.operations)
        self._shown()
        if read_again(self._history.operations) != self._within:
            self.start()

    def _shown(self) -> None:
        sheet = self.sheet
        self.board.show_sheet(sheet)
        self.problems.clear()
        for number, own in enumerate(sheet.problems):
            self._add_row(number, f"{MARKS.get(own.severity, '')} {own.message}", own.box)
        count = len(self._history.operations)
        self.statusBar().showMessage(
            translate("GaussianCAD", "{0} correction(s), beside the sheet").format(count)
        )

    def _run(self, arguments: list[str], done: Callable[[int, str], None]) -> None:
        program, *first = self._program.command
        process = QtCore.QProcess(self)
        if self._program.environment is not None:
            variables = QtCore.QProcessEnvironment()
            for name, value in self._program.environment.items():
                variables.insert(name, value)
            process.setProcessEnvironment(variables)
        process.setProcessChannelMode(QtCore.QProcess.ProcessChannelMode.MergedChannels)
        process.finished.connect(lambda code, _status=None: self._ended(code, done))
        process.errorOccurred.connect(self._failed)
        self._process = process
        self.statusBar().showMessage(translate("GaussianCAD", "The engine is at work\u2026"))
        process.start(program, [*first, *arguments])

    def _failed(self, error: QtCore.QProcess.ProcessError) -> None:
        # A process that ends badly is told by its end; one that never began has none.
        if error == QtCore.QProcess.ProcessError.FailedToStart and self._process is not None:
            process, self._process = self._process, None
            self.statusBar().clearMessage()
            found = not_started(self._program.command[0], process.errorString())
            self.tell(found.message)
            process.deleteLater()

    def _ended(self, code: int, done: Callable[[int, str], None]) -> None:
        process, self._process = self._process, None
        if self._closed:
            return
        text = bytes(process.readAllStandardOutput()).decode("utf-8", "replace")
        process.deleteLater()
        done(code, text)

    def _was_read(self, code: int, text: str, within: list[dict]) -> None:
        folder = Path(self._folder.name)
        if code or not (folder / "reading.json").is_file():
            self.tell(text)
            return
        reading = json.loads((folder / "reading.json").read_text(encoding="utf-8"))
        self.show_reading(reading, folder / "sheet.png", within)

    def _was_solved(self, code: int, text: str) -> None:
        folder = Path(self._folder.name) / "part"
        self.problems.clear()
        try:
            report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            self.tell(text)
            return
        for number, (line, box) in enumerate(found_in(report)):
            self._add_row(number, line, box)
        self.problems.scrollToTop()
        self.statusBar().showMessage(report["status"])
        if not code:
            self.solved.emit(str(folder))

    def tell(self, text: str) -> None:
        """Put lines before all others of the list."""
        for number, line in enumerate(own for own in text.splitlines() if own.strip()):
            self._add_row(number, line.strip(), None)
        self.problems.scrollToTop()

    def _add_row(self, number: int, text: str, box: Box | None) -> None:
        item = QtWidgets.QListWidgetItem(text)
        if box is not None:
            item.setData(QtCore.Qt.ItemDataRole.UserRole, list(box))
            item.setToolTip(translate("GaussianCAD", "Click to see the place"))
        self.problems.insertItem(number, item)

    def _show_place(self, item: QtWidgets.QListWidgetItem) -> None:
        box = item.data(QtCore.Qt.ItemDataRole.UserRole)
        if box:
            self.board.zoom_to(tuple(box))

    def _ask_role(self, box: tuple) -> None:
        menu = QtWidgets.QMenu(self)
        for number, role in enumerate((*ROLES, "ignore"), start=1):
            action = menu.addAction(f"{number} {name_of(role)}")
            action.triggered.connect(lambda _=False, own=role: self.say_view(own, box))
        menu.popup(QtGui.QCursor.pos())

    def say_view(self, role: str, box: tuple) -> None:
        """Say that a box of the sheet is a view."""
        known = corrected(self._read, self._history.operations).views
        name = next((own.id for own in known if own.role == role), role)
        self.say([{"op": "view", "id": name, "role": role, "box": list(box)}])

    def _ask_length(self, points: tuple) -> None:
        title = translate("GaussianCAD", "Scale")
        asked = translate("GaussianCAD", "Length between the two points in mm:")
        length, told = QtWidgets.QInputDialog.getDouble(self, title, asked, 100.0, 0.001, 1e6, 3)
        if told:
            self.say_length(points, length)

    def say_length(self, points: tuple, length: float) -> None:
        """Say how far two points of the sheet are apart, mm."""
        self.say([{"op": "scale", "points": [list(own) for own in points], "length_mm": length}])

    def _add_tools(self) -> None:
        bar = self.addToolBar("GaussianCAD")
        for key, name in TOOLS.items():
            action = bar.addAction(f"{name_of(name)} ({key})")
            action.triggered.connect(lambda _=False, own=name: self.board.take_tool(own))
        bar.addSeparator()
        for key, kind in KEYS.items():
            action = bar.addAction(f"{name_of(kind)} ({key})")
            action.triggered.connect(lambda _=False, own=kind: self.board.give_kind(own))
        bar.addSeparator()
        for text, keys, called in (
            (translate("GaussianCAD", "Undo"), QtGui.QKeySequence.StandardKey.Undo, self.undo),
            (translate("GaussianCAD", "Redo"), QtGui.QKeySequence.StandardKey.Redo, self.redo),
            (translate("GaussianCAD", "Solve"), QtGui.QKeySequence("F5"), self.solve),
        ):
            action = bar.addAction(text)
            action.setShortcut(keys)
            action.triggered.connect(lambda _=False, own=called: own())


def show(path: Path, page: int = 1) -> int:
    """Open the window for a sheet, and wait until it is closed."""
    application = QtWidgets.QApplication.instance() or QtWidgets.QApplication(sys.argv[:1])
    window = SheetWindow(path, page)
    window.show()
    window.start()
    return application.exec()
