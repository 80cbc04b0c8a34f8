"""The list of a batch's sheets that need a person, to step through."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from freecad.gaussiancad.canvas.failed import FailedSheet
from freecad.gaussiancad.canvas.verdict import SIGNS
from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets


class FailedList(QtWidgets.QWidget):
    """The list, with a button for the next sheet that is not done.

    Args:
        sheets: of a report.
        parent: its owner.

    Signals:
        chosen: a :class:`FailedSheet` that a person wants to see.
    """

    chosen = QtCore.Signal(object)

    def __init__(
        self, sheets: tuple[FailedSheet, ...], parent: QtWidgets.QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("failedSheets")
        self._sheets = list(sheets)
        self._headline = QtWidgets.QLabel()
        self._headline.setWordWrap(True)
        self._list = QtWidgets.QListWidget()
        self._list.setObjectName("sheetsOfBatch")
        self._list.setWordWrap(True)
        for sheet in sheets:
            self._list.addItem(_text(sheet))
        self._list.itemActivated.connect(lambda item: self._open(self._list.row(item)))
        self._list.itemClicked.connect(lambda item: self._open(self._list.row(item)))
        self.next_button = QtWidgets.QPushButton(translate("GaussianCAD", "Next Sheet"))
        self.next_button.setObjectName("nextSheet")
        self.next_button.clicked.connect(lambda _=False: self.open_next())
        layout = QtWidgets.QVBoxLayout(self)
        for entry in (self._headline, self._list, self.next_button):
            layout.addWidget(entry)
        self._tell()

    @property
    def sheets(self) -> tuple[FailedSheet, ...]:
        """What is listed, with what has become of it."""
        return tuple(self._sheets)

    def open_next(self) -> None:
        """Ask for the next sheet that is not verified; after the last one comes the first."""
        count = len(self._sheets)
        for step in range(1, count + 1):
            row = (self._list.currentRow() + step) % count
            if self._sheets[row].status != "verified":
                self._list.setCurrentRow(row)
                self._open(row)
                return

    def take(self, sheet: Path, page: int, status: str) -> None:
        """Show what has become of a sheet after a run."""
        for row, this_sheet in enumerate(self._sheets):
            if (this_sheet.sheet, this_sheet.page) == (sheet, page):
                self._sheets[row] = replace(this_sheet, status=status, code="", message="", args={})
                self._list.item(row).setText(_text(self._sheets[row]))
        self._tell()

    def _open(self, row: int) -> None:
        self.chosen.emit(self._sheets[row])

    def _tell(self) -> None:
        rest = sum(sheet.status != "verified" for sheet in self._sheets)
        text = translate("GaussianCAD", "{0} of these {1} sheets are not verified")
        self._headline.setText(text.format(rest, len(self._sheets)))
        self.next_button.setEnabled(rest > 0)


def _text(sheet: FailedSheet) -> str:
    stated = worded(sheet.code, sheet.message, sheet.args) if sheet.message else ""
    return f"{SIGNS.get(sheet.status, '')} {sheet.name}" + (f"\n{stated}" if stated else "")
