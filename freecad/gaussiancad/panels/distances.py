"""The table of a comparison's distances."""

from typing import Any

from freecad.gaussiancad.engine.report import Comparison
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.number_table import NumberTable
from freecad.gaussiancad.qt import QtWidgets

_NOTHING = "–"

_SMALL = 0.01
"""Below it two digits are told."""

_DECIMALS = 9
"""What is smaller is rounding."""


class DistanceTable(QtWidgets.QWidget):
    """Each distance beside its floor: what two samples of the same reference give."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle(translate("GaussianCAD", "Distances"))
        self._rows = _rows()
        self.table = NumberTable(
            "distances",
            (translate("GaussianCAD", "Value"), translate("GaussianCAD", "Floor")),
            [(title, tip) for _, title, tip in self._rows],
        )
        self.engineering = NumberTable(
            "engineering",
            (translate("GaussianCAD", "Result"), translate("GaussianCAD", "Reference")),
            _engineering_titles(),
        )
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
        # Task panels are narrow.
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.engineering)
        layout.addWidget(self.table)
        layout.addWidget(hint)

    def clear(self) -> None:
        """Show no numbers."""
        self.table.clearContents()
        self.engineering.clearContents()

    def show_comparison(self, comparison: Comparison) -> None:
        """Show the numbers."""
        for table, rows in (
            (self.table, distance_rows(comparison)),
            (self.engineering, engineering_rows(comparison.engineering)),
        ):
            table.show_numbers([texts for _, *texts in rows])

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


def distance_rows(comparison: Comparison) -> list[tuple[str, ...]]:
    """Name, value and floor of each of the paper's distances, as texts."""
    return [
        (
            title,
            *(
                _text(stated.get(key), digits=3)
                for stated in (comparison.distances, comparison.floor)
            ),
        )
        for key, title, _ in _rows()
    ]


def engineering_rows(block: dict[str, Any]) -> list[tuple[str, ...]]:
    """Name, number of the result and of the reference, as texts."""
    cells = _engineering_cells(block)
    titles = _engineering_titles()
    return [(title, *texts) for (title, _), texts in zip(titles, cells, strict=True)]


def _engineering_titles() -> list[tuple[str, str]]:
    """Title and explanation of each row in millimetres."""
    return [
        (
            translate("GaussianCAD", "Mean, mm"),
            translate("GaussianCAD", "Mean deviation; negative lies inside the other model"),
        ),
        (
            translate("GaussianCAD", "RMS, mm"),
            translate("GaussianCAD", "Root mean square of the deviation"),
        ),
        (
            translate("GaussianCAD", "Inside, mm"),
            translate("GaussianCAD", "The farthest that it lies inside the other model"),
        ),
        (
            translate("GaussianCAD", "Outside, mm"),
            translate("GaussianCAD", "The farthest that it lies outside the other model"),
        ),
        (
            translate("GaussianCAD", "Agrees, %"),
            translate("GaussianCAD", "Share of the surface within the tolerance"),
        ),
        (
            translate("GaussianCAD", "Volume, %"),
            translate("GaussianCAD", "By how much the result's volume differs"),
        ),
        (
            translate("GaussianCAD", "Area, %"),
            translate("GaussianCAD", "By how much the result's area differs"),
        ),
    ]


def _engineering_cells(block: dict[str, Any]) -> list[tuple[str, ...]]:
    """The numbers of those rows, as far as they were told."""
    sides = [block.get(key) or {} for key in ("result_to_reference", "reference_to_result")]
    keys = ("mean_mm", "rms_mm", "least_mm", "greatest_mm")
    cells = [tuple(_text(side.get(key)) for side in sides) for key in keys]
    cells.append(tuple(_text(side.get("within_tolerance"), 100.0) for side in sides))
    cells += [
        (_text(block.get(f"{name}_difference_share"), 100.0), "") for name in ("volume", "area")
    ]
    return cells


def _text(number: object, factor: float = 1.0, digits: int = 4) -> str:
    if isinstance(number, bool) or not isinstance(number, int | float):
        return _NOTHING
    value = round(factor * number, _DECIMALS) + 0.0
    # Small numbers have many zeros, and the panel is narrow.
    return f"{value:.{digits if abs(value) >= _SMALL else 2}g}"


def _rows() -> list[tuple[str, str, str]]:
    """Key, title and explanation of each row."""
    return [
        (
            "chamfer",
            translate("GaussianCAD", "Chamfer distance"),
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
