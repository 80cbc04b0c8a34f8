"""The places where two models are farthest apart, as a table to click."""

from collections.abc import Callable, Sequence

from freecad.gaussiancad.engine.report import WorstPoint
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets

Place = tuple[float, float, float]


class WorstTable(QtWidgets.QTableWidget):
    """The worst points, the worst first.

    Args:
        on_chosen: is told the place in mm, and the deviation as text.
    """

    def __init__(self, on_chosen: Callable[[Place, str], None]) -> None:
        super().__init__(0, 3)
        self.setObjectName("worst")
        self.setHorizontalHeaderLabels(
            ["mm", translate("GaussianCAD", "Result has"), translate("GaussianCAD", "Place")]
        )
        self.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.SingleSelection)
        for column in (0, 1):
            self.horizontalHeader().setSectionResizeMode(
                column, QtWidgets.QHeaderView.ResizeMode.ResizeToContents
            )
        self.horizontalHeader().setStretchLastSection(True)
        self.verticalHeader().setVisible(False)
        self.verticalHeader().setDefaultSectionSize(24)
        self.setMinimumHeight(170)
        self._on_chosen = on_chosen
        self.itemSelectionChanged.connect(self._choose)

    def show_points(self, points: Sequence[WorstPoint]) -> None:
        """Show others; nothing is chosen then."""
        self.blockSignals(True)
        self.clearSelection()
        self.setRowCount(len(points))
        for row, (point, texts) in enumerate(zip(points, worst_rows(points), strict=True)):
            for column, text in enumerate(texts):
                item = QtWidgets.QTableWidgetItem(text)
                item.setToolTip(f"{_meaning(point)}: {texts[-1]}")
                item.setData(QtCore.Qt.ItemDataRole.UserRole, list(point.place))
                self.setItem(row, column, item)
        self.blockSignals(False)

    def _choose(self) -> None:
        items = self.selectedItems()
        if items:
            place = tuple(items[0].data(QtCore.Qt.ItemDataRole.UserRole))
            self._on_chosen(place, f"{items[0].text()} mm")


def worst_rows(points: Sequence[WorstPoint]) -> list[tuple[str, str, str]]:
    """Surplus of the result in mm, negative where it lacks something, the same in words, and the
    place, as texts."""
    return [
        (
            f"{_surplus(point):+.4g}",
            _amount(point),
            ", ".join(f"{value:.4g}" for value in point.place),
        )
        for point in points
    ]


def _surplus(point: WorstPoint) -> float:
    """mm that the result has too much; a place of the reference that lies outside is lacking."""
    return point.deviation if point.of_result else -point.deviation


def _amount(point: WorstPoint) -> str:
    if _surplus(point) <= 0.0:
        too_little = translate("GaussianCAD", "too little")
        return too_little if point.of_result else translate("GaussianCAD", "nothing")
    return translate("GaussianCAD", "too much")


def _meaning(point: WorstPoint) -> str:
    if _surplus(point) <= 0.0:
        too_little = translate("GaussianCAD", "the result has too little")
        return too_little if point.of_result else translate("GaussianCAD", "material is missing")
    return translate("GaussianCAD", "the result has too much")
