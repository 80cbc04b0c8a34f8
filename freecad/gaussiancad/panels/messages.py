"""Message boxes that do not block: the event loop goes on, and a test can read and close them."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.qt import QtCore, QtWidgets

BOX_NAME = "GaussianCADMessage"


def show_error(title: str, text: str) -> QtWidgets.QMessageBox:
    """Show an error in a box over the main window, and note it in the report view.

    Args:
        title: what was being done.
        text: what happened, where, what to do.
    """
    FreeCAD.Console.PrintError(f"{title}: {text}\n")
    box = QtWidgets.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName(BOX_NAME)
    box.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    box.setIcon(QtWidgets.QMessageBox.Icon.Critical)
    box.setWindowTitle(title)
    box.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    box.setText(text)
    box.setStandardButtons(QtWidgets.QMessageBox.StandardButton.Ok)
    box.open()
    return box
