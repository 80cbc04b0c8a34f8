"""The list of a batch's sheets that need a person, in a dock of FreeCAD.

Each opens in a document and a canvas of its own.  What is corrected is written beside the sheet as
well, so that the batch takes it when it is run again.
"""

from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.canvas.failed import FailedSheet, failed_sheets
from freecad.gaussiancad.canvas.failed_list import FailedList
from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.correct import open_sheet
from freecad.gaussiancad.qt import QtCore, QtWidgets

DOCK_NAME = "GaussianCADFailedSheets"

_TITLE = "GaussianCAD"


def ask_report() -> "FailedDock | None":
    """Ask for a batch's report, and list its sheets."""
    main = FreeCADGui.getMainWindow()
    title = translate("GaussianCAD", "Choose the Report of a Batch")
    reports = translate("GaussianCAD", "Reports")
    path, _ = QtWidgets.QFileDialog.getOpenFileName(main, title, "", f"{reports} (report.*)")
    return open_report(Path(path)) if path else None


def open_report(report: Path) -> "FailedDock | None":
    """List the sheets of a report that need a person, and open the first.

    Returns:
        The dock; None where the report cannot be read, or nothing needs a person, which is told.
    """
    main = FreeCADGui.getMainWindow()
    try:
        found = failed_sheets(report)
    except (OSError, ValueError) as error:
        known = isinstance(error, ValueError)
        stated = worded("batch-not-read", str(error)) if known else str(error)
        QtWidgets.QMessageBox.warning(main, _TITLE, stated)
        return None
    if not found:
        text = translate("GaussianCAD", "Every sheet of this batch is verified.")
        QtWidgets.QMessageBox.information(main, _TITLE, text)
        return None
    for item in main.findChildren(QtWidgets.QDockWidget, DOCK_NAME):
        item.close()
    dock = FailedDock(found, main)
    main.addDockWidget(QtCore.Qt.DockWidgetArea.LeftDockWidgetArea, dock)
    dock.show()
    dock.list.open_next()
    return dock


class FailedDock(QtWidgets.QDockWidget):
    """The dock of the list.

    Args:
        sheets: that need a person.
        main: FreeCAD's window.
    """

    def __init__(self, sheets: tuple[FailedSheet, ...], main: QtWidgets.QWidget) -> None:
        super().__init__(translate("GaussianCAD", "Failed Sheets"), main)
        self.setObjectName(DOCK_NAME)
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        self.list = FailedList(sheets, self)
        self.list.chosen.connect(self._open)
        self.setWidget(self.list)
        self._documents: dict[tuple[Path, int], str] = {}

    def _open(self, sheet: FailedSheet) -> None:
        """Open a sheet in the document that it has, or a new one."""
        if not sheet.sheet.is_file():
            text = translate("GaussianCAD", "There is no file {0} any more.").format(sheet.sheet)
            QtWidgets.QMessageBox.warning(self, _TITLE, text)
            return
        key = sheet.sheet, sheet.page
        if self._documents.get(key) in FreeCAD.listDocuments():
            FreeCAD.setActiveDocument(self._documents[key])
            FreeCADGui.setActiveDocument(self._documents[key])
        else:
            self._documents[key] = FreeCAD.newDocument(sheet.name).Name
        dock = open_sheet(sheet.sheet, sheet.page)
        if dock is not None:
            solved = dock.canvas.session.solved
            solved.connect(lambda report, _: self.list.take(*key, report["status"]))
