"""What the window tests share: waiting, finding widgets, message boxes, pictures."""

import gc
import os
import time
from collections.abc import Callable
from pathlib import Path

import FreeCAD
import FreeCADGui
from support import FAKE_ENGINE, FolderCase, draw_sheet

from freecad.gaussiancad.panels.messages import BOX_NAME
from freecad.gaussiancad.preferences import GROUP
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets
from freecad.gaussiancad.remembered import LAST

PATIENCE_SECONDS = 60.0


def spin(milliseconds: int) -> None:
    """Let the window live for a while."""
    end = time.monotonic() + milliseconds / 1000.0
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.01)


def widget(kind: type, name: str) -> QtWidgets.QWidget:
    """The widget of that name in the main window."""
    found = FreeCADGui.getMainWindow().findChild(kind, name)
    if found is None:
        raise LookupError(f"no {kind.__name__} {name}")
    return found


def open_windows(name: str) -> list[QtWidgets.QWidget]:
    """The windows of a name that can be seen."""
    # PySide2 wraps every window here, and crashes where Python lets go of one of them meanwhile.
    gc.collect()
    tops = QtWidgets.QApplication.topLevelWidgets()
    return [top for top in tops if top.objectName() == name and top.isVisible()]


class WindowCase(FolderCase):
    """A test in a real window, with the fake engine and the workbench open."""

    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", FAKE_ENGINE.python)
        self.addCleanup(FreeCAD.ParamGet(GROUP).Clear)
        # Those of the tests that are about the body ask for one.
        FreeCAD.ParamGet(LAST).SetBool("Body", False)
        self.sheet = draw_sheet(self.folder / "bracket.png")
        self.window = FreeCADGui.getMainWindow()
        self.addCleanup(self.close_all)
        FreeCADGui.activateWorkbench("GaussianCADWorkbench")
        for dock in self.window.findChildren(QtWidgets.QDockWidget):
            if dock.objectName() == "Report view":
                dock.hide()

    def close_all(self) -> None:
        """Close boxes, panels and documents."""
        for box in self.boxes():
            box.close()
        FreeCADGui.Control.closeDialog()
        spin(100)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        spin(100)

    def show_top(self) -> None:
        """Scroll the task panel to its top."""
        preview = widget(QtWidgets.QLabel, "preview").parentWidget()
        while preview is not None and not isinstance(preview, QtWidgets.QScrollArea):
            preview = preview.parentWidget()
        preview.verticalScrollBar().setValue(0)

    def boxes(self) -> list[QtWidgets.QMessageBox]:
        """The addon's message boxes that are open."""
        return open_windows(BOX_NAME)

    def wait_for(self, condition: Callable[[], object], seconds: float = PATIENCE_SECONDS) -> None:
        """Let the window live until the condition holds."""
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                self.picture("timeout-" + self.id().rsplit(".", 1)[-1])
                self.fail("the window did not come that far")
            spin(20)

    def open_panel(self, command: str) -> None:
        """Press a button of the toolbar."""
        action = next(
            action
            for bar in self.window.findChildren(QtWidgets.QToolBar)
            for action in bar.actions()
            if action.data() == command or command in action.objectName()
        )
        self.wait_for(action.isEnabled)
        action.trigger()
        spin(300)

    def picture(self, name: str) -> Path:
        """Save a picture of the window among the artefacts."""
        spin(300)
        folder = Path(os.environ.get("GAUSSIANCAD_ARTIFACTS", "build/artifacts"))
        folder.mkdir(parents=True, exist_ok=True)
        version = ".".join(FreeCAD.Version()[:2])
        path = folder / f"{name}-{version}.png"
        # The screen, not the window: a window's own picture lacks its 3D view.
        QtWidgets.QApplication.primaryScreen().grabWindow(0).save(str(path))
        return path

    def start(self) -> QtWidgets.QPushButton:
        """Press *Start*; return the button."""
        button = widget(QtWidgets.QPushButton, "start")
        button.click()
        return button

    def open_more(self) -> None:
        """Open *More settings*."""
        widget(QtWidgets.QToolButton, "moreSettings").setChecked(True)
        spin(100)

    def choose_sheet(self, path: Path) -> None:
        """Type the path of the drawing."""
        widget(QtWidgets.QLineEdit, "sheet").setText(str(path))
        spin(100)


def dropped(path: Path) -> QtGui.QDropEvent:
    """What arrives when a file is dropped."""
    data = QtCore.QMimeData()
    data.setUrls([QtCore.QUrl.fromLocalFile(str(path))])
    event = QtGui.QDropEvent(
        QtCore.QPointF(10.0, 10.0),
        QtCore.Qt.DropAction.CopyAction,
        data,
        QtCore.Qt.MouseButton.LeftButton,
        QtCore.Qt.KeyboardModifier.NoModifier,
    )
    event.kept = data  # the event itself does not keep its data alive
    return event
