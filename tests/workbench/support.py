"""What the tests share: folders, sheets, the fake engine, and runs of it."""

import os
import tempfile
import unittest
from pathlib import Path

import fake_part

from freecad.gaussiancad.engine.locate import Engine, EngineSource
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event
from freecad.gaussiancad.qt import QtCore, QtGui

FAKE_ENGINE = Engine(str(Path(__file__).parent / "fake_engine.py"), EngineSource.VARIABLE)

HARD_NAME = "Zeichnung mit Leerzeichen 零件图"


class FolderCase(unittest.TestCase):
    """A test with a folder of its own whose name is not easy."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory(prefix=f"{HARD_NAME} ")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def behave(self, behaviour: str) -> None:
        """Choose the fake engine's behaviour for this test."""
        self.set_variable("GAUSSIANCAD_FAKE", behaviour)

    def set_variable(self, name: str, value: str | None) -> None:
        """Set an environment variable for this test."""
        before = os.environ.get(name)
        self.addCleanup(_put, name, before)
        _put(name, value)


def _put(name: str, value: str | None) -> None:
    if value is None:
        os.environ.pop(name, None)
    else:
        os.environ[name] = value


def draw_sheet(path: Path) -> Path:
    """Draw the bracket's three views, in third angle."""
    image = QtGui.QImage(*fake_part.SHEET_SIZE, QtGui.QImage.Format.Format_RGB32)
    image.fill(QtGui.QColor(255, 255, 255))
    painter = QtGui.QPainter(image)
    painter.setPen(QtGui.QPen(QtGui.QColor(0, 0, 0), 3))
    front, top, right = (fake_part.BOXES[role] for role in ("front", "top", "right"))
    corners = [(0, 0), (60, 0), (60, 10), (15, 10), (15, 30), (0, 30), (0, 0)]
    points = [QtCore.QPointF(front[0] + 4 * x, front[3] - 4 * z) for x, z in corners]
    painter.drawPolyline(points)
    for box in (top, right):
        painter.drawRect(QtCore.QRectF(box[0], box[1], box[2] - box[0], box[3] - box[1]))
    step_x, step_y = top[0] + 60, right[3] - 40
    painter.drawLine(QtCore.QPointF(step_x, top[1]), QtCore.QPointF(step_x, top[3]))
    painter.drawLine(QtCore.QPointF(right[0], step_y), QtCore.QPointF(right[2], step_y))
    painter.end()
    if not image.save(str(path)):
        raise OSError(f"cannot write {path}")
    return path


def run_fake(arguments: list[str], grace: float = 5.0) -> tuple[RunResult, list[Event], list[str]]:
    """Run the fake engine to its end; return the result, the events and the log."""
    events: list[Event] = []
    log: list[str] = []
    run = EngineRun(FAKE_ENGINE, arguments, Watcher(events.append, log.append), grace)
    run.start()
    return run.wait(), events, log


def alive(pid: int) -> bool:
    """Whether a process has not ended; one that nobody has waited for yet has."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return False
    return state.rsplit(")", 1)[1].split()[0] != "Z"
