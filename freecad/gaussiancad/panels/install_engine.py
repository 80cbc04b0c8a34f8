"""The dialog of *Install Engine…*: what is there, what would be downloaded, and the choice."""

import os
from collections.abc import Callable

import FreeCADGui

from freecad.gaussiancad.engine.base_python import find_base_python
from freecad.gaussiancad.engine.installing import CPU_INDEX, Installer, InstallWatcher
from freecad.gaussiancad.engine.locate import EngineSource, SearchPlaces, find_engine
from freecad.gaussiancad.engine.locks import EngineBuild, suggested_build
from freecad.gaussiancad.engine.managed import Condition, Managed, engine_version, look_at, remove
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.build_choice import BuildChoice, build_name
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore, QtWidgets

DIALOG_NAME = "GaussianCADInstallEngine"

QUESTION_NAME = "GaussianCADRemoveEngine"

_LOG_LINES = 5000

_SMALL, _LARGE = (640, 260), (640, 520)
"""px of the dialog before and while something is done."""


class InstallEngineDialog(QtWidgets.QDialog):
    """Nothing is downloaded before the user presses *Download and Install* or *Repair*.

    Args:
        parent: the main window.
    """

    def __init__(self, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(DIALOG_NAME)
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(translate("GaussianCAD", "Install Engine"))
        self.resize(*_SMALL)
        preference = read_preferences().engine_python
        self._places = SearchPlaces.of_this_machine(preference, os.environ)
        self._root = self._places.managed
        self._managed = look_at(self._root)
        self.headline = _label("headline")
        self.details = _label("details")
        card = suggested_build()
        self.choice = BuildChoice(self._managed.build or card, card is EngineBuild.CUDA)
        self.choice.changed.connect(self._offer)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setRange(0, 1)
        self.log = QtWidgets.QPlainTextEdit()
        self.log.setObjectName("log")
        self.log.setReadOnly(True)
        self.log.setMaximumBlockCount(_LOG_LINES)
        close = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Close)
        texts = (
            ("install", translate("GaussianCAD", "Download and Install"), self.begin),
            ("repair", translate("GaussianCAD", "Repair"), self.repair),
            ("remove", translate("GaussianCAD", "Remove…"), self.ask_to_remove),
        )
        self.install_button, self.repair_button, self.remove_button = (
            _button(close, name, text, action) for name, text, action in texts
        )
        self.repair_button.setToolTip(
            translate("GaussianCAD", "Downloads and installs what is missing or damaged, only that")
        )
        close.rejected.connect(self.reject)
        layout = QtWidgets.QVBoxLayout(self)
        for widget in (self.headline, self.details, self.choice, self.bar):
            layout.addWidget(widget)
        layout.addWidget(self.log, 1)
        layout.addStretch()
        layout.addWidget(close)
        self._show_log(False)
        self._installer: Installer | None = None
        self._tell_condition()

    @classmethod
    def open_now(cls) -> "InstallEngineDialog":
        """Open the dialog over the main window."""
        dialog = cls(FreeCADGui.getMainWindow())
        dialog.open()
        return dialog

    def begin(self) -> None:
        """Install; the user has agreed by pressing the button."""
        self._work(Installer.start)

    def repair(self) -> None:
        """Reinstall what is missing or damaged; the user has agreed by pressing the button."""
        self._work(Installer.repair)

    def ask_to_remove(self) -> None:
        """Remove the engine if the user says so once more."""
        buttons = QtWidgets.QMessageBox.StandardButton
        text = translate(
            "GaussianCAD",
            "Remove the engine in {folder}? {size} on disk become free. Drawings, documents and "
            "this addon stay as they are, and the engine can be installed again.",
        )
        box = QtWidgets.QMessageBox(self)
        box.setObjectName(QUESTION_NAME)
        box.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        box.setIcon(QtWidgets.QMessageBox.Icon.Question)
        box.setWindowTitle(translate("GaussianCAD", "Remove Engine"))
        box.setText(text.format(folder=self._root, size=_size_text(self._managed.size)))
        box.setStandardButtons(buttons.Cancel)
        yes = box.addButton(
            translate("GaussianCAD", "Remove"), QtWidgets.QMessageBox.ButtonRole.DestructiveRole
        )
        yes.setObjectName("removeNow")
        yes.clicked.connect(self._remove)
        box.setDefaultButton(buttons.Cancel)
        box.open()

    def reject(self) -> None:
        """Close, or stop the installation first: then a second press closes."""
        if self._installer is not None:
            self._installer.cancel()
            return
        super().reject()

    def _work(self, action: Callable[[Installer], None]) -> None:
        if self._installer is not None:
            return
        try:
            base = find_base_python(os.environ)
        except WorkbenchError as error:
            self.headline.setText(error.message)
            return
        self.details.clear()
        self._show_log(True)
        self.resize(*_LARGE)
        self.bar.setRange(0, 0)
        watcher = InstallWatcher(self._show_step, self.log.appendPlainText, self._show_end)
        self._installer = Installer(base, self._root, self.choice.build, watcher)
        self._offer()
        action(self._installer)

    def _remove(self) -> None:
        try:
            remove(self._root)
        except WorkbenchError as error:
            self.headline.setText(error.message)
            return
        self._look_again()

    def _show_log(self, shown: bool) -> None:
        for widget in (self.bar, self.log):
            widget.setVisible(shown)

    def _show_step(self, title: str) -> None:
        self.headline.setText(title)
        self.log.appendPlainText(f"== {title}")

    def _show_end(self, error: str) -> None:
        self._installer = None
        self.bar.setRange(0, 1)
        self.bar.setValue(0 if error else 1)
        self._look_again()
        if error:
            self.headline.setText(error)

    def _look_again(self) -> None:
        self._managed = look_at(self._root)
        self._tell_condition()

    def _tell_condition(self) -> None:
        headline, details = _condition_texts(self._managed, self._places)
        self.headline.setText(headline)
        self.details.setText(details)
        self._offer()

    def _offer(self) -> None:
        """Enable what makes sense with what is there."""
        idle, there = self._installer is None, self._managed.condition is not Condition.ABSENT
        whole = self._managed.condition is Condition.COMPLETE
        other = self._managed.build not in (None, self.choice.build)
        self.choice.setEnabled(idle)
        self.install_button.setEnabled(idle and (not whole or other))
        self.repair_button.setEnabled(idle and there and not other)
        self.remove_button.setEnabled(idle and there)


def _condition_texts(managed: Managed, places: SearchPlaces) -> tuple[str, str]:
    """What is there, and what can be done about it."""
    if managed.condition is Condition.COMPLETE:
        headline = "\u2714 " + translate("GaussianCAD", "The engine is complete.")
        text = (
            translate("GaussianCAD", "Version {version} for {build}, {size} on disk in {folder}.")
            if managed.build is EngineBuild.SOLID
            else translate(
                "GaussianCAD",
                "Version {version} with PyTorch for {build}, {size} on disk in {folder}.",
            )
        )
        details = text.format(
            version=engine_version(),
            build=build_name(managed.build),
            size=_size_text(managed.size),
            folder=places.managed,
        )
        return headline, details
    if managed.condition is Condition.INCOMPLETE:
        headline = translate(
            "GaussianCAD",
            "The engine in {folder} is not complete. Repair downloads what is missing or damaged.",
        ).format(folder=places.managed)
        missing = ", ".join(managed.missing)
        text = translate("GaussianCAD", "Missing, or of another version: {names}")
        return headline, text.format(names=missing) if missing else ""
    return _consent_text().format(folder=places.managed, index=CPU_INDEX), _other_engine(places)


def _other_engine(places: SearchPlaces) -> str:
    """Which engine is used already though none was installed here."""
    try:
        engine = find_engine(places)
    except WorkbenchError:
        return ""
    if engine.source is EngineSource.MANAGED:
        return ""
    text = translate("GaussianCAD", "An engine is in use already: {engine}.")
    return text.format(engine=engine.describe())


def _consent_text() -> str:
    return translate(
        "GaussianCAD",
        "GaussianCAD can download the packages of its engine from the Python package index that "
        "pip is set up for, and PyTorch for the processor from {index} where that index lacks it. "
        "Each package is checked against a hash that comes with this addon. They go into {folder}; "
        "FreeCAD's own Python stays as it is. Nothing is sent.",
    )


def _size_text(size: int) -> str:
    if size < 1e9:
        return translate("GaussianCAD", "{count} MB").format(count=f"{size / 1e6:.0f}")
    return translate("GaussianCAD", "{count} GB").format(count=f"{size / 1e9:.1f}")


def _label(name: str) -> QtWidgets.QLabel:
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    return label


def _button(
    box: QtWidgets.QDialogButtonBox, name: str, text: str, action: Callable[[], None]
) -> QtWidgets.QPushButton:
    button = QtWidgets.QPushButton(text)
    button.setObjectName(name)
    button.setAutoDefault(False)
    button.clicked.connect(action)
    box.addButton(button, QtWidgets.QDialogButtonBox.ButtonRole.ActionRole)
    return button
