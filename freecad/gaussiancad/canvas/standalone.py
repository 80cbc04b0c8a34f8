"""The window without FreeCAD: one sheet, or those of a batch that need a person."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

from freecad.gaussiancad.canvas.engine_server import Engines, Program
from freecad.gaussiancad.canvas.failed import FailedSheet
from freecad.gaussiancad.canvas.failed_list import FailedList
from freecad.gaussiancad.canvas.translator import load_language
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtWidgets

_STOPPED = 130
"""Exit status of a command that a signal stops."""

_ENDING = ("SIGINT", "SIGTERM", "SIGHUP")
"""Signals that do, as far as the system has them."""

_LISTENING_MS = 200
"""How often Python, which learns of signals between its own steps, gets to run beside Qt."""


class StandaloneWindow(QtWidgets.QMainWindow):
    """A frame around the window of a sheet; another sheet, or page, takes its place.

    Args:
        failed: sheets of a batch, to step through in a list beside; none without a batch.
        program: the engine.
    """

    def __init__(
        self, failed: tuple[FailedSheet, ...] = (), program: Program | None = None
    ) -> None:
        super().__init__()
        self._engines = Engines.of(program or Program())
        self.canvas: SheetWindow | None = None
        self.list = FailedList(failed, self) if failed else None
        if self.list is not None:
            self.list.chosen.connect(lambda item: self.open(item.sheet, item.page))
            dock = QtWidgets.QDockWidget(self)
            dock.setFeatures(QtWidgets.QDockWidget.DockWidgetFeature.NoDockWidgetFeatures)
            dock.setTitleBarWidget(QtWidgets.QWidget())
            dock.setWidget(self.list)
            self.addDockWidget(QtCore.Qt.DockWidgetArea.LeftDockWidgetArea, dock)
        self.resize(1280, 900)

    def open(self, path: Path, page: int = 1) -> None:
        """Show a sheet in place of the one before, with the same engines."""
        try:
            canvas = SheetWindow(path, page, engines=self._engines, parent=self)
        except ValueError as error:
            QtWidgets.QMessageBox.warning(self, "GaussianCAD", str(error))
            return
        if self.canvas is not None:
            self.canvas.close()
        self.canvas = canvas
        canvas.setWindowFlags(QtCore.Qt.WindowType.Widget)
        canvas.page_asked.connect(lambda number: self.open(path, number))
        if self.list is not None:
            show = self.list.take
            canvas.session.solved.connect(lambda report, _: show(path, page, report["status"]))
        self.setCentralWidget(canvas)
        self.setWindowTitle(canvas.windowTitle())
        canvas.start()

    def closeEvent(self, event: object) -> None:
        """End the engines with the window."""
        if self.canvas is not None:
            self.canvas.close()
        super().closeEvent(event)


def show(path: Path, page: int = 1, failed: tuple[FailedSheet, ...] = ()) -> int:
    """Open the window, and wait until it is closed.

    Args:
        path: of the sheet that is shown first.
        page: of a file with pages.
        failed: sheets of a batch to step through.

    Returns:
        The exit status: 130 where a signal closed it.
    """
    application = QtWidgets.QApplication.instance() or QtWidgets.QApplication(sys.argv[:1])
    translator = QtCore.QTranslator(application)
    if load_language(translator, QtCore.QLocale().uiLanguages()):
        application.installTranslator(translator)
    window = StandaloneWindow(failed)
    window.show()
    window.open(path, page)
    listening = QtCore.QTimer()
    listening.timeout.connect(lambda: None)
    listening.start(_LISTENING_MS)
    before = {
        number: signal.signal(number, lambda *_: application.exit(_STOPPED))
        for name in _ENDING
        if (number := getattr(signal, name, None)) is not None
        and signal.getsignal(number) is not signal.SIG_IGN
    }
    try:
        return application.exec()
    finally:
        window.close()
        for number, handler in before.items():
            signal.signal(number, handler)
