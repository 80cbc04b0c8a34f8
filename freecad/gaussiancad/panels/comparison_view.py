"""What a comparison found: distances, histogram, worst points, sections, and files to save.

It shows a group of the document, and reads everything from it.
"""

from pathlib import Path

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparison import comparison_report, request_of
from freecad.gaussiancad.objects.comparison_export import comparison_csv
from freecad.gaussiancad.objects.comparison_properties import range_mm
from freecad.gaussiancad.objects.transaction import transaction
from freecad.gaussiancad.panels.comparison_pdf import write_comparison_pdf
from freecad.gaussiancad.panels.distances import DistanceTable
from freecad.gaussiancad.panels.histogram import HistogramView
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.panels.point_view import PointMark
from freecad.gaussiancad.panels.section_view import REFERENCE, RESULT, SectionMark, mesh_of
from freecad.gaussiancad.panels.sheet_picture import SheetPicture
from freecad.gaussiancad.panels.worst_table import WorstTable
from freecad.gaussiancad.qt import QtCore, QtWidgets

_FINENESS = 2e-3
_SLIDER = 1000

_TABS = 2
"""Those that are always there; the sheet comes after them."""


class ComparisonView(QtWidgets.QWidget):
    """The part of a panel that shows a comparison."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle(translate("GaussianCAD", "Comparison"))
        self._group: FreeCAD.DocumentObject | None = None
        self._mark: PointMark | None = None
        self._section: SectionMark | None = None
        self._models: tuple[object, object] | None = None
        self.tabs = QtWidgets.QTabWidget()
        self.distances = DistanceTable()
        self.histogram = HistogramView()
        self.range = QtWidgets.QDoubleSpinBox()
        self.range.setObjectName("range")
        self.range.setDecimals(4)
        self.range.setRange(1e-4, 1e5)
        self.range.setSuffix(" mm")
        self.range.setKeyboardTracking(False)
        self.range.valueChanged.connect(self._change_range)
        self.worst = WorstTable(self._fly)
        self.axis = QtWidgets.QComboBox()
        self.axis.setObjectName("sectionAxis")
        for text, axis in ((translate("GaussianCAD", "none"), ""), *zip("XYZ", "xyz", strict=True)):
            self.axis.addItem(text, axis)
        self.place = QtWidgets.QSlider(QtCore.Qt.Orientation.Horizontal)
        self.place.setObjectName("sectionPlace")
        self.place.setRange(0, _SLIDER)
        self.place.setValue(_SLIDER // 2)
        self.axis.currentIndexChanged.connect(lambda _: self._cut())
        self.place.valueChanged.connect(lambda _: self._cut())
        self.save = QtWidgets.QPushButton(translate("GaussianCAD", "Save As…"))
        self.save.setObjectName("saveComparison")
        self.save.clicked.connect(self._ask_where)
        self._lay_out()
        self.clear()

    def show_group(self, group: FreeCAD.DocumentObject) -> None:
        """Show a comparison of a document."""
        self.clear()
        report = comparison_report(group)
        if report is None:
            return
        self._group = group
        self._mark, self._section = PointMark(group.Document), SectionMark(group.Document)
        self.setEnabled(True)
        self.distances.show_comparison(report)
        self._set_range(range_mm(group))
        self.histogram.show_histogram(report.histogram, range_mm(group))
        self.worst.show_points(report.worst)
        request = request_of(group)
        sheet = None if request is None else request.result.sheet()
        if sheet is not None:
            self.tabs.addTab(SheetPicture(sheet), translate("GaussianCAD", "Sheet"))

    def clear(self) -> None:
        """Show nothing, and take everything off the 3D view."""
        self.take_off()
        self._group = self._mark = self._section = self._models = None
        self.distances.clear()
        self.histogram.show_histogram(None, 1.0)
        self.worst.show_points(())
        while self.tabs.count() > _TABS:
            self.tabs.widget(_TABS).deleteLater()
            self.tabs.removeTab(_TABS)
        self.axis.blockSignals(True)
        self.axis.setCurrentIndex(0)
        self.axis.blockSignals(False)
        self.setEnabled(False)

    def take_off(self) -> None:
        """Take everything off the 3D view; touches no widget."""
        for mark in (self._mark, self._section):
            if mark is not None:
                mark.clear()

    def save_as(self, path: Path) -> None:
        """Write the comparison; the suffix says as what: CSV, JSON, PDF or HTML.

        Raises:
            OSError: it cannot be written.
        """
        report = comparison_report(self._group)
        if path.suffix.lower() == ".csv":
            # Spreadsheets take the mark at the start for UTF-8.
            path.write_bytes(comparison_csv(report).encode("utf-8-sig"))
        elif path.suffix.lower() == ".json":
            path.write_text(report.text, encoding="utf-8")
        elif path.suffix.lower() == ".pdf":
            write_comparison_pdf(self._group, path)
        else:
            path.write_bytes(Path(self._group.Page).read_bytes())

    def _set_range(self, value: float) -> None:
        self.range.blockSignals(True)
        self.range.setSingleStep(value / 10.0)
        self.range.setValue(value)
        self.range.blockSignals(False)

    def _change_range(self, value: float) -> None:
        if not self._alive():
            return
        document = self._group.Document
        with transaction(document, translate("GaussianCAD", "Range of the Colours")):
            self._group.ColourRange = value
        report = comparison_report(self._group)
        self.histogram.show_histogram(report.histogram, value)

    def _fly(self, place: tuple[float, float, float], text: str) -> None:
        if self._alive():
            self._mark.show(place, text, self._size())

    def _size(self) -> float:
        return max(self._mesh().BoundBox.DiagonalLength, 1e-6)

    def _mesh(self) -> object:
        return next(each.Mesh for each in self._group.Group if hasattr(each, "VertexColors"))

    def _cut(self) -> None:
        if not self._alive():
            return
        axis = self.axis.itemData(self.axis.currentIndex())
        if not axis:
            self._section.clear()
            return
        if self._models is None:
            request = request_of(self._group)
            if request is None:
                return
            fineness = _FINENESS * self._size()
            self._models = (self._mesh(), mesh_of(request.reference, fineness))
        box = self._models[0].BoundBox
        box.add(self._models[1].BoundBox)
        low, high = getattr(box, f"{axis.upper()}Min"), getattr(box, f"{axis.upper()}Max")
        # Not quite to the ends, where faces lie in the plane.
        share = 0.001 + 0.998 * self.place.value() / _SLIDER
        self._section.show(axis, low + share * (high - low), self._models)

    def _alive(self) -> bool:
        """Whether the comparison is still in its document."""
        if self._group is None:
            return False
        try:
            return self._group.Document is not None
        except ReferenceError:
            self._group = None
            return False

    def _ask_where(self) -> None:
        if not self._alive():
            return
        kinds = ["PDF (*.pdf)", translate("GaussianCAD", "Table (*.csv)"), "JSON (*.json)"]
        if getattr(self._group, "Page", ""):
            kinds.insert(0, translate("GaussianCAD", "Page for a browser (*.html)"))
        path, kind = QtWidgets.QFileDialog.getSaveFileName(
            self, translate("GaussianCAD", "Save Comparison"), "comparison", ";;".join(kinds)
        )
        if not path:
            return
        suffix = kind.rsplit("*", 1)[-1].rstrip(")")
        target = Path(path) if Path(path).suffix else Path(path).with_suffix(suffix)
        try:
            self.save_as(target)
        except OSError as error:
            show_error(translate("GaussianCAD", "Save Comparison"), str(error))

    def _lay_out(self) -> None:
        self.tabs.setObjectName("comparisonTabs")
        self.tabs.addTab(self.distances, translate("GaussianCAD", "Measures"))
        self.tabs.addTab(self.worst, translate("GaussianCAD", "Worst points"))
        form = QtWidgets.QFormLayout()
        form.addRow(translate("GaussianCAD", "Colours to ±"), self.range)
        section = QtWidgets.QHBoxLayout()
        section.addWidget(self.axis)
        section.addWidget(self.place)
        form.addRow(translate("GaussianCAD", "Section"), section)
        form.addRow("", _section_key())
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(self.histogram)
        layout.addLayout(form)
        layout.addWidget(self.tabs)
        layout.addWidget(self.save)


def _section_key() -> QtWidgets.QLabel:
    """What the colours of the outlines mean."""
    names = (translate("GaussianCAD", "Result"), translate("GaussianCAD", "Reference"))
    label = QtWidgets.QLabel(
        " &nbsp; ".join(
            f'<span style="color: {_css(colour)}">\N{BLACK SQUARE}</span> {name}'
            for colour, name in zip((RESULT, REFERENCE), names, strict=True)
        )
    )
    label.setObjectName("sectionKey")
    return label


def _css(colour: tuple[float, float, float]) -> str:
    return "#" + "".join(f"{round(255 * channel):02x}" for channel in colour)
