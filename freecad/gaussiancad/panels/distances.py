"""The table of a comparison's distances."""

from freecad.gaussiancad.engine.report import Comparison
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets

_NOTHING = "–"


class DistanceTable(QtWidgets.QWidget):
    """Each distance beside its floor: what two samples of the same reference give."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle(translate("GaussianCAD", "Distances"))
        self._rows = _rows()
        self.table = QtWidgets.QTableWidget(len(self._rows), 2)
        self.table.setObjectName("distances")
        self.table.setHorizontalHeaderLabels(
            [translate("GaussianCAD", "Value"), translate("GaussianCAD", "Floor")]
        )
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Stretch)
        for row, (_, title, tip) in enumerate(self._rows):
            header = QtWidgets.QTableWidgetItem(title)
            header.setToolTip(tip)
            self.table.setVerticalHeaderItem(row, header)
        self.table.verticalHeader().setDefaultSectionSize(24)
        self.table.setFixedHeight(24 * len(self._rows) + 34)
        hint = QtWidgets.QLabel(
            translate(
                "GaussianCAD",
                "Values are in units: the longest edge of the reference is 5. The floor is what "
                "two samples of the reference itself give.",
            )
        )
        hint.setWordWrap(True)
        hint.setMinimumHeight(4 * hint.fontMetrics().lineSpacing())
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(self.table)
        layout.addWidget(hint)

    def clear(self) -> None:
        """Show no numbers."""
        self.table.clearContents()

    def show_comparison(self, comparison: Comparison) -> None:
        """Show the numbers."""
        for row, (key, _, _) in enumerate(self._rows):
            numbers = (comparison.distances.get(key), comparison.floor.get(key))
            for column, number in enumerate(numbers):
                item = QtWidgets.QTableWidgetItem(_NOTHING if number is None else f"{number:.3g}")
                item.setTextAlignment(
                    QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter
                )
                self.table.setItem(row, column, item)

    def millimetre_lines(self, comparison: Comparison) -> list[str]:
        """The distances in millimetres of the reference, a line each."""
        unit = comparison.values.get("unit_mm")
        if isinstance(unit, bool) or not isinstance(unit, int | float):
            return []
        text = translate("GaussianCAD", "{distance}: {length} mm")
        return [
            text.format(distance=title, length=f"{comparison.distances[key] * unit:.4g}")
            for key, title, _ in self._rows
            if key in comparison.distances and key != "volume_iou"
        ]


def _rows() -> list[tuple[str, str, str]]:
    """Key, title and explanation of each row."""
    return [
        (
            "chamfer",
            translate("GaussianCAD", "Chamfer"),
            translate("GaussianCAD", "Sum of the mean distances to the nearest point, both ways"),
        ),
        (
            "hausdorff",
            translate("GaussianCAD", "Hausdorff"),
            translate("GaussianCAD", "Largest distance to the nearest point, either way"),
        ),
        (
            "emd",
            translate("GaussianCAD", "Earth mover"),
            translate("GaussianCAD", "Mean distance of points matched one to one"),
        ),
        (
            "point_to_surface",
            translate("GaussianCAD", "To surface"),
            translate("GaussianCAD", "Mean distance of the points to the other surface"),
        ),
        (
            "volume_iou",
            translate("GaussianCAD", "Volume IoU"),
            translate("GaussianCAD", "Common volume over united volume; 1 is perfect"),
        ),
    ]
