"""The table of a reconstruction's solutions: a row each, best first."""

from collections.abc import Sequence

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets

_MOST_ROWS = 6
"""Rows that are seen without scrolling."""

_ROW = 24


class SolutionTable(QtWidgets.QTableWidget):
    """Faces, volume and agreement of each solution; the chosen row is the one that is shown.

    Args:
        features: the solutions.
    """

    def __init__(self, features: Sequence[FreeCAD.DocumentObject]) -> None:
        super().__init__(len(features), 3)
        self.setObjectName("solutions")
        self.setHorizontalHeaderLabels(
            [
                translate("GaussianCAD", "Faces"),
                translate("GaussianCAD", "Volume"),
                translate("GaussianCAD", "Lines"),
            ]
        )
        self.horizontalHeaderItem(2).setToolTip(
            translate(
                "GaussianCAD", "Share of the lines, the drawing's and the solid's, that agree"
            )
        )
        view = QtWidgets.QAbstractItemView
        self.setEditTriggers(view.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(view.SelectionBehavior.SelectRows)
        self.setSelectionMode(view.SelectionMode.SingleSelection)
        # Task panels are narrow: the volume needs most of the room.
        mode = QtWidgets.QHeaderView.ResizeMode
        for column, entry in enumerate(
            (mode.ResizeToContents, mode.Stretch, mode.ResizeToContents)
        ):
            self.horizontalHeader().setSectionResizeMode(column, entry)
        self.horizontalHeader().setHighlightSections(False)
        self.verticalHeader().setDefaultSectionSize(_ROW)
        self.setFixedHeight(_ROW * min(len(features), _MOST_ROWS) + 34)
        for row, feature in enumerate(features):
            for column, text in enumerate(_cells(feature)):
                item = QtWidgets.QTableWidgetItem(text)
                item.setTextAlignment(
                    QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter
                )
                self.setItem(row, column, item)

    @property
    def place(self) -> int | None:
        """The chosen row, counted from 0."""
        rows = self.selectionModel().selectedRows()
        return rows[0].row() if rows else None

    def choose(self, place: int) -> None:
        """Choose a row."""
        if self.place != place:
            self.selectRow(place)


def _cells(feature: FreeCAD.DocumentObject) -> tuple[str, str, str]:
    agreement = getattr(feature, "Agreement", None)
    shape = feature.Shape
    return (
        str(len(shape.Faces)),
        f"{shape.Volume:.6g} mm³",
        "–" if agreement is None else f"{agreement:.1%}",
    )
