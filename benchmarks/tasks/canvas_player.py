"""Plays gestures on the canvas without a screen: the events that a mouse and keys make.

A recording is a list of steps, each a list that begins with what is done; places are px of the
sheet as stored:

    ["open"]                               the sheet, until its part is made or refused
    ["click", x, y], ["more", x, y]        more: with Shift
    ["drag", x0, y0, x1, y1]
    ["key", "Delete"]                      as Qt names keys
    ["role", "front", x0, y0, x1, y1]      B, a box, and the entry of the menu
    ["length", x0, y0, x1, y1, mm]         M, two clicks, and the number
    ["depth", x, y, mm]                    the depth of a hole at a place, from its menu
    ["plane", "front", x0, y0, x1, y1]     X, and a drag
    ["button", "Close Gaps"]               the first such button in the list; * is any text
    ["wait"]                               until the part is made
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from freecad.gaussiancad.canvas.engine_server import Engines, Program
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

Step = Sequence[str | float]

_REST_S = 0.6
"""s after which the canvas has begun to work on what was said."""

_SIZE = (1400, 1000)
"""px of the window."""


@dataclass(frozen=True)
class Played:
    """What came of a recording.

    Attributes:
        status: of the last run, or ``none``.
        gestures: steps of the hand: clicks, drags, keys, numbers.
        seconds: from opening to the last part.
        operations: that were said.
        solid: path of the part; None where there is none.
    """

    status: str
    gestures: int
    seconds: float
    operations: int
    solid: Path | None


class Player:
    """A canvas and the hand on it.

    Args:
        sheet: path of the drawing; it is copied, and corrections are left beside the copy.
        folder: for the copy.
        page: of a file with pages.
        limit: s that the canvas may work on one thing.
        engines: of another player that is open; new ones where none are given.
    """

    def __init__(
        self,
        sheet: Path,
        folder: Path,
        page: int = 1,
        limit: float = 120.0,
        engines: Engines | None = None,
    ) -> None:
        self.application = QtWidgets.QApplication.instance() or QtWidgets.QApplication([])
        folder.mkdir(parents=True, exist_ok=True)
        copy = Path(shutil.copyfile(sheet, folder / sheet.name))
        program = Program((sys.executable, "-m", "gaussiancad_core"))
        self.window = SheetWindow(copy, page, engines=engines or Engines.of(program))
        self.window.resize(*_SIZE)
        self.window.show()
        self.report: dict = {}
        self.solid: Path | None = None
        self.gestures = 0
        self._limit = limit
        self._solved_at = self._began = time.monotonic()
        self.window.session.solved.connect(self._take)

    def play(self, steps: Sequence[Step]) -> Played:
        """Do all steps, and wait for the part.

        Raises:
            TimeoutError: the canvas works on one thing for too long.
        """
        for name, *values in steps:
            getattr(self, f"_do_{name}")(*values)
        self._do_wait()
        return Played(
            self.report.get("status", "none"),
            self.gestures,
            round(self._solved_at - self._began, 1),
            len(self.window.operations),
            self.solid,
        )

    def close(self) -> None:
        """End the engines."""
        self.window.close()
        self.application.processEvents()

    def rows(self) -> list[str]:
        """Texts of the list, and the buttons beside them."""
        return [
            " ".join([line.text, *(f"[{text}]" for text, _ in line.buttons)])
            for line in self.window.problems.lines
        ]

    def _take(self, report: dict, folder: str) -> None:
        self.report, self._solved_at = report, time.monotonic()
        solid = Path(folder) / "solid.step"
        self.solid = solid if folder and solid.is_file() else None

    def _spin(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.application.processEvents(QtCore.QEventLoop.ProcessEventsFlag.AllEvents, 10)
            time.sleep(0.005)

    def _do_open(self) -> None:
        self.window.start()
        self._do_wait()

    def _do_wait(self) -> None:
        self._spin(_REST_S)
        end = time.monotonic() + self._limit
        while self.window.busy or self.window.sheet is None:
            if time.monotonic() > end:
                raise TimeoutError(f"the canvas was at work for {self._limit:.0f} s")
            self._spin(0.05)
        self._spin(0.1)

    def _do_drag(self, *places: float, keys: Sequence[str] = ()) -> None:
        (x0, y0, x1, y1), kind = places, QtCore.QEvent.Type
        for event, at in (
            (kind.MouseButtonPress, (x0, y0)),
            (kind.MouseMove, (x1, y1)),
            (kind.MouseButtonRelease, (x1, y1)),
        ):
            self._mouse(event, at, keys)
        self.gestures += 1

    def _do_click(self, x: float, y: float) -> None:
        self._do_drag(x, y, x, y)

    def _do_more(self, x: float, y: float) -> None:
        self._do_drag(x, y, x, y, keys=("ShiftModifier",))

    def _do_key(self, name: str) -> None:
        key = getattr(QtCore.Qt.Key, f"Key_{name}")
        none = QtCore.Qt.KeyboardModifier.NoModifier
        for kind in (QtCore.QEvent.Type.KeyPress, QtCore.QEvent.Type.KeyRelease):
            event = QtGui.QKeyEvent(kind, key, none)
            QtWidgets.QApplication.sendEvent(self.window.canvas_view, event)
        self.gestures += 1

    def _do_role(self, role: str, *box: float) -> None:
        asked = self._answered(self.window.canvas_view.asked_role)
        self._do_key("B")
        self._do_drag(*box)
        self.window.say_view(role, asked[0])
        self.gestures += 1
        self._do_key("Escape")
        self._do_wait()

    def _do_length(self, x0: float, y0: float, x1: float, y1: float, length: float) -> None:
        asked = self._answered(self.window.canvas_view.asked_length)
        self._do_key("M")
        self._do_click(x0, y0)
        self._do_click(x1, y1)
        self.window.say_length(asked[0], length)
        self.gestures += 1

    def _do_depth(self, x: float, y: float, depth: float) -> None:
        stroke = self.window.sheet.stroke_at((x, y), 4.0)
        self.window.canvas_view.set_hole_depth(stroke.shape[1][:3], depth)
        self.gestures += 2

    def _do_plane(self, in_view: str, *line: float) -> None:
        asked: list[tuple] = []
        signal = self.window.canvas_view.asked_section
        signal.disconnect()
        signal.connect(lambda *item: asked.append(item))
        self._do_key("X")
        self._do_drag(*line)
        (found, view), *_ = asked
        sections = [section for section in self.window.sheet.sections if section.id != in_view]
        self.window.say_section(sections[0].id, found, view)

    def _do_button(self, text: str) -> None:
        called = next(
            (
                called
                for line in self.window.problems.lines
                for item, called in line.buttons
                if fnmatchcase(item, text)
            ),
            None,
        )
        if called is None:
            raise LookupError(f"there is no button {text}")
        called()
        self.gestures += 1
        self._do_wait()

    def _answered(self, signal: QtCore.SignalInstance) -> list:
        """What a signal asks is answered by the recording, not by a menu."""
        asked: list = []
        take: Callable[[object], None] = asked.append
        signal.disconnect()
        signal.connect(take)
        return asked

    def _mouse(
        self, kind: QtCore.QEvent.Type, place: tuple[float, float], keys: Sequence[str]
    ) -> None:
        canvas_view, qt = self.window.canvas_view, QtCore.Qt
        at = QtCore.QPointF(canvas_view.mapFromScene(*place))
        released = kind is QtCore.QEvent.Type.MouseButtonRelease
        held = qt.MouseButton.NoButton if released else qt.MouseButton.LeftButton
        modifiers = qt.KeyboardModifier.NoModifier
        for key in keys:
            modifiers |= getattr(qt.KeyboardModifier, key)
        view = canvas_view.viewport()
        event = QtGui.QMouseEvent(
            kind, at, view.mapToGlobal(at), qt.MouseButton.LeftButton, held, modifiers
        )
        QtWidgets.QApplication.sendEvent(view, event)


def recordings(path: Path) -> dict[str, list[Step]]:
    """The recordings of a file, by the name of the sheet: ``FOLDER/NAME.SUFFIX``."""
    return json.loads(path.read_text(encoding="utf-8"))
