"""A canvas without a screen, on which a sheet is opened."""

from __future__ import annotations

import os
import shutil
import sys
import time
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from freecad.gaussiancad.canvas.engine_server import Engines, Program
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtWidgets

_REST_S = 0.6
"""s after which the canvas has begun to work on what was said."""

_LIMIT_S = 240.0
"""s that the canvas may work on one thing."""

_SIZE = (1400, 1000)
"""px of the window."""


class Canvas:
    """A canvas of a sheet.

    Args:
        sheet: path of the drawing; it is copied.
        folder: for the copy.
        engines: of another canvas that is open; new ones where none are given.

    Attributes:
        read_s: seconds from opening until the sheet was read; None where it was not.
        part_s: seconds from opening to the part; None where there is none.
    """

    def __init__(self, sheet: Path, folder: Path, engines: Engines | None = None) -> None:
        self.application = QtWidgets.QApplication.instance() or QtWidgets.QApplication([])
        folder.mkdir(parents=True, exist_ok=True)
        copy = Path(shutil.copyfile(sheet, folder / sheet.name))
        program = Program((sys.executable, "-m", "gaussiancad_core"))
        self.window = SheetWindow(copy, 1, engines=engines or Engines.of(program))
        self.window.resize(*_SIZE)
        self.window.show()
        self.read_s: float | None = None
        self.part_s: float | None = None
        self.window.session.read.connect(self._take_reading)
        self.window.session.solved.connect(self._take_part)
        self._began = 0.0

    def open(self) -> None:
        """Open the sheet, and wait for its part.

        Raises:
            TimeoutError: the canvas works on one thing for too long.
        """
        self._began = time.monotonic()
        self.window.start()
        self._spin(_REST_S)
        while self.window.busy or self.window.sheet is None:
            if time.monotonic() > self._began + _LIMIT_S:
                raise TimeoutError(f"the canvas was at work for {_LIMIT_S:.0f} s")
            self._spin(0.05)

    def close(self) -> None:
        """End the engines."""
        self.window.close()
        self.application.processEvents()

    def _take_reading(self) -> None:
        if self.read_s is None:
            self.read_s = time.monotonic() - self._began

    def _take_part(self, _report: dict, folder: str) -> None:
        if folder and self.part_s is None:
            self.part_s = time.monotonic() - self._began

    def _spin(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.application.processEvents(QtCore.QEventLoop.ProcessEventsFlag.AllEvents, 10)
            time.sleep(0.005)
