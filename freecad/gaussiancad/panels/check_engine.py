"""The dialog of *Check Engine…*: where the engine is, and what it says of itself."""

import os

import FreeCADGui

from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.paths import ADDON_ROOT
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

DIALOG_NAME = "GaussianCADCheckEngine"


class CheckEngineDialog(QtWidgets.QDialog):
    """Runs ``gaussiancad doctor`` and shows what it prints.

    Args:
        parent: the main window.
    """

    def __init__(self, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(DIALOG_NAME)
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(translate("GaussianCAD", "Check Engine"))
        self.resize(640, 420)
        self.headline = QtWidgets.QLabel()
        self.headline.setObjectName("headline")
        self.headline.setWordWrap(True)
        selectable = QtCore.Qt.TextInteractionFlag.TextSelectableByMouse
        self.headline.setTextInteractionFlags(selectable)
        self.text = QtWidgets.QPlainTextEdit()
        self.text.setObjectName("text")
        self.text.setReadOnly(True)
        fixed = QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont)
        self.text.setFont(fixed)
        close = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Close)
        install = QtWidgets.QPushButton(translate("GaussianCAD", "Install Engine…"))
        install.setObjectName("install")
        install.clicked.connect(self._install)
        close.addButton(install, QtWidgets.QDialogButtonBox.ButtonRole.ActionRole)
        close.rejected.connect(self.reject)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(self.headline)
        layout.addWidget(self.text)
        layout.addWidget(close)
        self._run: EngineRun | None = None
        self._engine = ""

    @classmethod
    def open_now(cls) -> "CheckEngineDialog":
        """Open the dialog over the main window, and begin."""
        dialog = cls(FreeCADGui.getMainWindow())
        dialog.open()
        dialog.begin()
        return dialog

    def begin(self) -> None:
        """Look for the engine and ask it."""
        places = SearchPlaces.of_this_machine(read_preferences().engine_python, os.environ)
        try:
            engine = find_engine(places)
        except WorkbenchError as error:
            self.headline.setText(error.message)
            self.text.setPlainText(_places_text(places))
            return
        found = translate("GaussianCAD", "Engine: {engine}").format(engine=engine.describe())
        self.headline.setText(found)
        self.text.setPlainText(translate("GaussianCAD", "Asking the engine…"))
        self._engine = found
        self._run = EngineRun(engine, ["doctor"], Watcher(on_finished=self._show))
        self._run.start()

    def done(self, result: int) -> None:
        """Stop asking when the dialog closes."""
        if self._run is not None:
            self._run.cancel()
        super().done(result)

    def _install(self) -> None:
        from freecad.gaussiancad.panels.install_engine import InstallEngineDialog

        self.reject()
        InstallEngineDialog.open_now()

    def _show(self, result: RunResult) -> None:
        self._run = None
        parts = [part for part in (result.output, result.log) if part.strip()]
        if result.state is not RunState.DONE:
            parts.append(result.words)
            parts.append(_repair_text())
        self.headline.setText(f"{_verdict(whole=result.state is RunState.DONE)}\n{self._engine}")
        self.text.setPlainText("\n\n".join(parts))


def _verdict(*, whole: bool) -> str:
    if whole:
        return "\u2714 " + translate("GaussianCAD", "The engine is complete and works.")
    return "\u2716 " + translate("GaussianCAD", "The engine does not work: see below what to do.")


def _places_text(places: SearchPlaces) -> str:
    nothing = translate("GaussianCAD", "not set")
    lines = [
        translate("GaussianCAD", "GaussianCAD looked in these places, in this order:"),
        f"1. GAUSSIANCAD_PYTHON: {places.variable or nothing}",
        "2. "
        + translate("GaussianCAD", "Preferences: {path}").format(path=places.preference or nothing),
        f"3. {places.managed}",
        f"4. {places.checkout}",
        "",
        _repair_text(),
    ]
    return "\n".join(lines)


def _repair_text() -> str:
    text = translate(
        "GaussianCAD",
        "To install the engine, press Install Engine, or run in a terminal: make -C '{folder}' "
        "install",
    )
    return text.format(folder=ADDON_ROOT)
