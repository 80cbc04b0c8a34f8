"""The task panel of *Choose among Solutions…*: flip through them, then keep one."""

import json

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.report import parse_report
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.solutions import Difference, Region, SolutionSet
from freecad.gaussiancad.panels.difference_view import DifferenceMark
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.panels.solution_table import SolutionTable
from freecad.gaussiancad.panels.widgets import standard_buttons
from freecad.gaussiancad.qt import QtCore, QtWidgets


class SolutionsPanel:
    """The panel; FreeCAD shows the widget in ``form``.

    Args:
        group: a reconstruction with more than one solution.
    """

    def __init__(self, group: FreeCAD.DocumentObject) -> None:
        self._solutions = SolutionSet(group)
        self._mark = DifferenceMark(group.Document)
        self._place = 0
        self._done = False
        self.previous = _button("previous", translate("GaussianCAD", "Previous"))
        self.next = _button("next", translate("GaussianCAD", "Next"))
        self.previous.clicked.connect(lambda: self.flip(-1))
        self.next.clicked.connect(lambda: self.flip(1))
        self.position = QtWidgets.QLabel()
        self.position.setObjectName("position")
        self.position.setAlignment(QtCore.Qt.AlignmentFlag.AlignCenter)
        features = [self._solutions.feature(place) for place in range(len(self._solutions))]
        self.table = SolutionTable(features)
        self.table.itemSelectionChanged.connect(self._take_row)
        self.details = _text_box("details", 6)
        self.keep_button = _button("keep", translate("GaussianCAD", "Keep This One"))
        self.keep_button.clicked.connect(self.keep)
        self.form = self._box(group)
        self.form.setWindowIcon(FreeCADGui.getIcon("GaussianCAD_Solutions"))
        self.form.destroyed.connect(self._leave)
        self.show(0)

    def flip(self, step: int) -> None:
        """Show the solution that many places on; after the last one comes the first."""
        self.show((self._place + step) % len(self._solutions))

    def show(self, place: int) -> None:
        """Show one solution, and tell what is known of it."""
        if not self._solutions.alive:
            self._complain(
                translate("GaussianCAD", "The solutions are not in the document any more.")
            )
            return
        self._place = place
        self._solutions.show(place)
        text = translate("GaussianCAD", "{number} of {count}")
        self.position.setText(text.format(number=place + 1, count=len(self._solutions)))
        self.table.choose(place)
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.CursorShape.WaitCursor)
        try:
            self._mark.show(self._solutions.difference(place))
            self.details.setPlainText("\n".join(self._detail_lines()))
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()

    def keep(self) -> None:
        """Make the shown solution the result, and close."""
        try:
            self._solutions.keep(self._place)
        except WorkbenchError as error:
            self._complain(error.message)
            return
        self._done = True
        self._mark.clear()
        QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def getStandardButtons(self) -> object:
        """A button that leaves everything as it was."""
        return standard_buttons(QtWidgets.QDialogButtonBox.StandardButton.Cancel)

    def reject(self) -> bool:
        """Leave everything as it was, and close."""
        self._leave()
        return True

    def isAllowedAlterDocument(self) -> bool:
        """Nothing else changes the document meanwhile."""
        return False

    def isAllowedAlterView(self) -> bool:
        """The user may look around."""
        return True

    def isAllowedAlterSelection(self) -> bool:
        """The user may select."""
        return True

    def _leave(self) -> None:
        if not self._done:
            self._done = True
            self._mark.clear()
            self._solutions.restore()

    def _take_row(self) -> None:
        place = self.table.place
        if place is not None and place != self._place:
            self.show(place)

    def _complain(self, text: str) -> None:
        show_error(translate("GaussianCAD", "Choose among Solutions"), text)

    def _detail_lines(self) -> list[str]:
        feature = self._solutions.feature(self._place)
        size = feature.Shape.BoundBox
        text = translate("GaussianCAD", "Size: {x} × {y} × {z} mm")
        lengths = {"x": size.XLength, "y": size.YLength, "z": size.ZLength}
        lines = [text.format(**{axis: f"{length:.6g}" for axis, length in lengths.items()})]
        reading = {
            "first": translate("GaussianCAD", "Read in first angle"),
            "third": translate("GaussianCAD", "Read in third angle"),
        }.get(getattr(feature, "Projection", ""))
        if reading:
            lines.append(reading)
        if self._place:
            return lines + _difference_lines(self._solutions.difference(self._place))
        lines.append(translate("GaussianCAD", "The simplest of them, and the result so far"))
        return lines

    def _box(self, group: FreeCAD.DocumentObject) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Choose among Solutions"))
        text = translate(
            "GaussianCAD",
            "{count} different solids have the lines of this drawing. Keep the one that is meant; "
            "the others are removed.",
        )
        hint = QtWidgets.QLabel(text.format(count=len(self._solutions)))
        hint.setWordWrap(True)
        hint.setMinimumHeight(3 * hint.fontMetrics().lineSpacing())
        flipping = QtWidgets.QHBoxLayout()
        flipping.addWidget(self.previous)
        flipping.addWidget(self.position)
        flipping.addWidget(self.next)
        layout = QtWidgets.QVBoxLayout(box)
        layout.addWidget(hint)
        layout.addLayout(flipping)
        layout.addWidget(self.table)
        layout.addWidget(QtWidgets.QLabel(translate("GaussianCAD", "Shown")))
        layout.addWidget(self.details)
        report = parse_report(group.ReportJson, json.loads(group.ReportJson))
        if report.reasons:
            doubts = _text_box("doubts", 4)
            doubts.setPlainText("\n".join(f"• {reason.words}" for reason in report.reasons))
            layout.addWidget(QtWidgets.QLabel(translate("GaussianCAD", "Why there is doubt")))
            layout.addWidget(doubts)
        layout.addWidget(self.keep_button)
        return box


def open_solutions(group: FreeCAD.DocumentObject) -> None:
    """Open the panel, in place of the one that is open."""
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    FreeCADGui.Control.showDialog(SolutionsPanel(group))


def _difference_lines(difference: Difference) -> list[str]:
    more = translate("GaussianCAD", "Orange: {volume} mm³ more than solution 1, {place}")
    less = translate("GaussianCAD", "Magenta: {volume} mm³ less than solution 1, {place}")
    stated = [(text, region) for text, region in ((more, difference.more), (less, difference.less))]
    return [
        text.format(volume=f"{region.volume:.6g}", place=_place_text(region))
        for text, region in stated
        if region.shape is not None
    ]


def _place_text(region: Region) -> str:
    box = region.shape.BoundBox
    text = translate("GaussianCAD", "within X {x}, Y {y}, Z {z} mm")
    return text.format(
        x=f"{box.XMin:.4g}…{box.XMax:.4g}",
        y=f"{box.YMin:.4g}…{box.YMax:.4g}",
        z=f"{box.ZMin:.4g}…{box.ZMax:.4g}",
    )


def _button(name: str, text: str) -> QtWidgets.QPushButton:
    button = QtWidgets.QPushButton(text)
    button.setObjectName(name)
    # Enter in a task panel must not keep anything.
    button.setAutoDefault(False)
    return button


def _text_box(name: str, lines: int) -> QtWidgets.QPlainTextEdit:
    box = QtWidgets.QPlainTextEdit()
    box.setObjectName(name)
    box.setReadOnly(True)
    box.setFixedHeight(lines * box.fontMetrics().lineSpacing() + 12)
    return box
