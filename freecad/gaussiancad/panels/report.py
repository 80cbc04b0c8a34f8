"""The report of a reconstruction, opened by a double click on it."""

import json

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.explaining import explanation_lines
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import parse_report
from freecad.gaussiancad.engine.summary import report_lines, status_text, verdict_text
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.known_sheets import sheet_of
from freecad.gaussiancad.objects.solutions import SolutionSet, has_choice
from freecad.gaussiancad.panels.sheet_preview import SheetPreview
from freecad.gaussiancad.panels.solutions import open_solutions
from freecad.gaussiancad.qt import QtCore, QtWidgets

DIALOG_NAME = "GaussianCADReport"


def _told(group: FreeCAD.DocumentObject) -> tuple[str, list[str], list[str]]:
    """What is known, details, and why; where a run did not come to its end it left no report."""
    text = getattr(group, "ReportJson", "")
    if not text and not hasattr(group, "Status"):
        return translate("GaussianCAD", "No run has ended on this drawing yet."), [], []
    if not text:
        return status_text(Status(group.Status)), [f"• {Reason}" for Reason in group.Reasons], []
    report = parse_report(text, json.loads(text))
    return verdict_text(report), report_lines(report), explanation_lines(report)


class ReportDialog(QtWidgets.QDialog):
    """What is known, the sheet with the part's own lines over it, the figures, and why.

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
        headline_text, lines, why = _told(group)
        headline = QtWidgets.QLabel(headline_text)
        headline.setObjectName("headline")
        headline.setWordWrap(True)
        picture = SheetPreview()
        shown = getattr(group, "Overlay", "") or sheet_of(group)
        if shown:
            picture.show_file(str(shown))
        else:
            text = translate("GaussianCAD", "The drawing is gone, and the document holds no copy")
            picture.setText(text)
        expanding = QtWidgets.QSizePolicy.Policy.Expanding
        picture.setSizePolicy(expanding, expanding)
        tabs = QtWidgets.QTabWidget()
        tabs.setMaximumHeight(240)
        for name, title, item in (
            ("text", translate("GaussianCAD", "Details"), lines),
            ("why", translate("GaussianCAD", "Why"), why),
        ):
            text = QtWidgets.QPlainTextEdit("\n".join(item))
            text.setObjectName(name)
            text.setReadOnly(True)
            tabs.addTab(text, title)
        close = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Close)
        close.rejected.connect(self.reject)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(headline)
        layout.addWidget(picture)
        layout.addWidget(tabs)
        if has_choice(group):
            action = QtWidgets.QDialogButtonBox.ButtonRole.ActionRole
            close.addButton(self._choice_button(group), action)
        layout.addWidget(close)

    def _choice_button(self, group: FreeCAD.DocumentObject) -> QtWidgets.QPushButton:
        text = translate("GaussianCAD", "Choose among {count} Solutions…")
        button = QtWidgets.QPushButton(text.format(count=len(SolutionSet(group))))
        button.setObjectName("choose")
        button.setAutoDefault(False)
        # Another task panel is not closed for it: a run may go on in it.
        button.setEnabled(not FreeCADGui.Control.activeDialog())

        def choose() -> None:
            self.accept()
            QtCore.QTimer.singleShot(0, lambda: open_solutions(group))

        button.clicked.connect(choose)
        return button

    @classmethod
    def open_for(cls, group: FreeCAD.DocumentObject) -> "ReportDialog":
        """Open the dialog over the main window."""
        dialog = cls(group, FreeCADGui.getMainWindow())
        dialog.open()
        return dialog
