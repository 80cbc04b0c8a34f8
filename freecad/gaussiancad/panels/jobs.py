"""The list of runs that go on by themselves: one works, others wait, each can be cancelled.

It is a dock of FreeCAD's window; closing it, or any panel, ends no run.
"""

import os
import tempfile
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event, EventKind
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore, QtWidgets

DOCK_NAME = "GaussianCADJobs"

_HEIGHT = 140
"""px of the list when it is opened: a few rows."""

_GRACE_SECONDS = 1.0
"""Between the steps of stopping: a job that is cancelled is gone within two of them."""


class JobState(Enum):
    """How far a job is."""

    WAITING = "waiting"
    WORKING = "working"
    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"


@dataclass(frozen=True)
class Job:
    """Something for the engine to do.

    Attributes:
        title: as the list shows it.
        prepare: gets everything ready in a folder of its own and returns the engine's arguments.
        absorb: takes what a finished run left in that folder, and returns a sentence on it.
    """

    title: str
    prepare: Callable[[Path], list[str]]
    absorb: Callable[[Path], str]


class Entry:
    """A job in the list.

    Args:
        job: what is to be done.
        item: its row.
    """

    def __init__(self, job: Job, item: QtWidgets.QTreeWidgetItem) -> None:
        self.job, self.item = job, item
        self.state = JobState.WAITING
        self.run: EngineRun | None = None
        self.scratch: tempfile.TemporaryDirectory[str] | None = None

    @property
    def is_over(self) -> bool:
        """Whether nothing more comes of it."""
        return self.state not in (JobState.WAITING, JobState.WORKING)

    def tell(self, text: str) -> None:
        """Show how far it is."""
        self.item.setText(1, text)
        self.item.setToolTip(1, text)


class JobList(QtWidgets.QDockWidget):
    """The list.

    Args:
        main: FreeCAD's window.
    """

    def __init__(self, main: QtWidgets.QWidget) -> None:
        super().__init__(translate("GaussianCAD", "GaussianCAD Jobs"), main)
        self.setObjectName(DOCK_NAME)
        self._entries: list[Entry] = []
        self._tree = QtWidgets.QTreeWidget()
        self._tree.setColumnCount(3)
        self._tree.setRootIsDecorated(False)
        self._tree.header().setStretchLastSection(False)
        modes = QtWidgets.QHeaderView.ResizeMode
        for column, mode in enumerate(
            (modes.ResizeToContents, modes.Stretch, modes.ResizeToContents)
        ):
            self._tree.header().setSectionResizeMode(column, mode)
        self._tree.setHeaderLabels(
            [translate("GaussianCAD", "Job"), translate("GaussianCAD", "State"), ""]
        )
        clear = QtWidgets.QPushButton(translate("GaussianCAD", "Clear List"))
        clear.clicked.connect(self.clear)
        widget = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(widget)
        layout.addWidget(self._tree)
        layout.addWidget(clear, 0, QtCore.Qt.AlignmentFlag.AlignLeft)
        self.setWidget(widget)

    @property
    def entries(self) -> list[Entry]:
        """The jobs, in the order in which they came."""
        return list(self._entries)

    def add(self, job: Job) -> Entry:
        """Put a job at the end; it starts when those before it are over."""
        item = QtWidgets.QTreeWidgetItem([job.title])
        self._tree.addTopLevelItem(item)
        entry = Entry(job, item)
        entry.tell(translate("GaussianCAD", "Waiting"))
        button = QtWidgets.QToolButton()
        button.setText(translate("GaussianCAD", "Cancel"))
        button.clicked.connect(lambda _=False: self.cancel(entry))
        self._tree.setItemWidget(item, 2, button)
        self._entries.append(entry)
        self._go_on()
        return entry

    def cancel(self, entry: Entry) -> None:
        """Stop a job that works, or take one off that waits."""
        if entry.state is JobState.WAITING:
            self._end(entry, JobState.CANCELLED, translate("GaussianCAD", "Cancelled"))
        elif entry.run is not None:
            entry.tell(translate("GaussianCAD", "Cancelling"))
            entry.run.cancel()

    def clear(self) -> None:
        """Take off what is over."""
        for entry in [each for each in self._entries if each.is_over]:
            self._tree.takeTopLevelItem(self._tree.indexOfTopLevelItem(entry.item))
            self._entries.remove(entry)

    def _go_on(self) -> None:
        if any(entry.state is JobState.WORKING for entry in self._entries):
            return
        entry = next((each for each in self._entries if each.state is JobState.WAITING), None)
        if entry is not None:
            self._start(entry)

    def _start(self, entry: Entry) -> None:
        entry.state = JobState.WORKING
        entry.tell(translate("GaussianCAD", "Starting the engine"))
        entry.scratch = tempfile.TemporaryDirectory(
            prefix="gaussiancad-", ignore_cleanup_errors=True
        )
        try:
            preference = read_preferences().engine_python
            engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
            arguments = entry.job.prepare(Path(entry.scratch.name))
        except (WorkbenchError, OSError) as error:
            self._end(entry, JobState.FAILED, str(error))
            return
        watcher = Watcher(
            on_event=lambda event: self._hear(entry, event),
            on_finished=lambda result: self._finish(entry, result),
        )
        entry.run = EngineRun(engine, arguments, watcher, _GRACE_SECONDS)
        entry.run.start()

    def _hear(self, entry: Entry, event: Event) -> None:
        if event.kind is EventKind.STAGE:
            text = translate("GaussianCAD", "Stage {index} of {count}")
            index, count = event.number("index") or 0, event.number("of") or 0
            entry.tell(text.format(index=int(index), count=int(count)))

    def _finish(self, entry: Entry, result: RunResult) -> None:
        if result.state is RunState.CANCELLED:
            self._end(entry, JobState.CANCELLED, translate("GaussianCAD", "Cancelled"))
            return
        if result.state is not RunState.DONE:
            self._end(entry, JobState.FAILED, result.message)
            return
        try:
            text = entry.job.absorb(Path(entry.scratch.name))
        except WorkbenchError as error:
            self._end(entry, JobState.FAILED, error.message)
        except Exception as error:  # a window must survive what FreeCAD's importers raise
            FreeCAD.Console.PrintLog(traceback.format_exc())
            self._end(entry, JobState.FAILED, str(error))
        else:
            self._end(entry, JobState.DONE, text)

    def _end(self, entry: Entry, state: JobState, text: str) -> None:
        entry.state, entry.run = state, None
        entry.tell(text)
        button = self._tree.itemWidget(entry.item, 2)
        if button is not None:
            button.setEnabled(False)
        if entry.scratch is not None:
            entry.scratch.cleanup()
            entry.scratch = None
        QtCore.QTimer.singleShot(0, self._go_on)


def job_list() -> JobList:
    """The list of FreeCAD's window, shown; it is made with the first job."""
    main = FreeCADGui.getMainWindow()
    found = main.findChild(JobList, DOCK_NAME)
    if found is None:
        found = JobList(main)
        main.addDockWidget(QtCore.Qt.DockWidgetArea.BottomDockWidgetArea, found)
        main.resizeDocks([found], [_HEIGHT], QtCore.Qt.Orientation.Vertical)
    found.show()
    return found
