"""The dialog of *Install Engine…*: what would be downloaded, and whether to do it."""

import os

import FreeCADGui

from freecad.gaussiancad.engine.installing import Installer, InstallWatcher, find_base_python
from freecad.gaussiancad.engine.locate import managed_environment
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets

DIALOG_NAME = "GaussianCADInstallEngine"

_LOG_LINES = 5000


class InstallEngineDialog(QtWidgets.QDialog):
    """Nothing is downloaded before the user presses *Download and Install*.

    Args:
        parent: the main window.
    """

    def __init__(self, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(DIALOG_NAME)
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(translate("GaussianCAD", "Install Engine"))
        self.resize(640, 420)
        self._root = managed_environment()
        self.headline = QtWidgets.QLabel(_consent_text().format(folder=self._root))
        self.headline.setObjectName("headline")
        self.headline.setWordWrap(True)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setRange(0, 1)
        self.log = QtWidgets.QPlainTextEdit()
        self.log.setObjectName("log")
        self.log.setReadOnly(True)
        self.log.setMaximumBlockCount(_LOG_LINES)
        self.install_button = QtWidgets.QPushButton(
            translate("GaussianCAD", "Download and Install")
        )
        self.install_button.setObjectName("install")
        self.install_button.clicked.connect(self.begin)
        close = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Close)
        close.addButton(self.install_button, QtWidgets.QDialogButtonBox.ButtonRole.ActionRole)
        close.rejected.connect(self.reject)
        layout = QtWidgets.QVBoxLayout(self)
        for widget in (self.headline, self.bar, self.log, close):
            layout.addWidget(widget)
        self._installer: Installer | None = None

    @classmethod
    def open_now(cls) -> "InstallEngineDialog":
        """Open the dialog over the main window."""
        dialog = cls(FreeCADGui.getMainWindow())
        dialog.open()
        return dialog

    def begin(self) -> None:
        """Install; the user has agreed by pressing the button."""
        if self._installer is not None:
            return
        try:
            base = find_base_python(os.environ)
        except WorkbenchError as error:
            self.headline.setText(error.message)
            return
        self.install_button.setEnabled(False)
        self.bar.setRange(0, 0)
        watcher = InstallWatcher(self._show_step, self.log.appendPlainText, self._show_end)
        self._installer = Installer(base, self._root, watcher)
        self._installer.start()

    def reject(self) -> None:
        """Close, or stop the installation first: then a second press closes."""
        if self._installer is not None:
            self._installer.cancel()
            return
        super().reject()

    def _show_step(self, title: str) -> None:
        self.headline.setText(title)
        self.log.appendPlainText(f"== {title}")

    def _show_end(self, error: str) -> None:
        self._installer = None
        self.bar.setRange(0, 1)
        self.bar.setValue(0 if error else 1)
        self.install_button.setEnabled(bool(error))
        self.headline.setText(error or translate("GaussianCAD", "The engine is installed."))


def _consent_text() -> str:
    return translate(
        "GaussianCAD",
        "GaussianCAD can download the packages of its engine from the Python package index that "
        "pip is set up for: 0.7 GB, or 3.3 GB with PyTorch for NVIDIA cards. Each package is "
        "checked against a hash that comes with this addon. They go into {folder} (up to 7 GB on "
        "disk); FreeCAD's own Python stays as it is. Nothing is sent.",
    )
