"""The report of a reconstruction, opened by a double click on it."""

import json

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.report import parse_report
from freecad.gaussiancad.engine.summary import report_lines, status_text
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.sheet_preview import SheetPreview
from freecad.gaussiancad.qt import QtCore, QtWidgets

DIALOG_NAME = "GaussianCADReport"


class ReportDialog(QtWidgets.QDialog):
    """Status, the sheet with the part's own lines over it, and the figures.

    Args:
        group: the reconstruction.
        parent: the main window.
    """

    def __init__(self, group: FreeCAD.DocumentObject, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(DIALOG_NAME)
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(group.Label)
        self.resize(900, 700)
        report = parse_report(group.ReportJson, json.loads(group.ReportJson))
        headline = QtWidgets.QLabel(status_text(report.status))
        headline.setObjectName("headline")
        headline.setWordWrap(True)
        picture = SheetPreview()
        picture.show_file(getattr(group, "Overlay", "") or group.Sheet)
        expanding = QtWidgets.QSizePolicy.Policy.Expanding
        picture.setSizePolicy(expanding, expanding)
        text = QtWidgets.QPlainTextEdit("\n".join(report_lines(report)))
        text.setObjectName("text")
        text.setReadOnly(True)
        text.setMaximumHeight(200)
        close = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Close)
        close.rejected.connect(self.reject)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(headline)
        layout.addWidget(picture)
        layout.addWidget(QtWidgets.QLabel(translate("GaussianCAD", "Details")))
        layout.addWidget(text)
        layout.addWidget(close)

    @classmethod
    def open_for(cls, group: FreeCAD.DocumentObject) -> "ReportDialog":
        """Open the dialog over the main window."""
        dialog = cls(group, FreeCADGui.getMainWindow())
        dialog.open()
        return dialog
