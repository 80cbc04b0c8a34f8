"""The task panel of *Compare with Reference…*."""

from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.job import CompareJob
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparable import comparable_objects, export_geometry
from freecad.gaussiancad.objects.comparison import add_comparison, load_comparison
from freecad.gaussiancad.panels.distances import DistanceTable
from freecad.gaussiancad.panels.engine_panel import EnginePanel, PanelTexts, Success
from freecad.gaussiancad.panels.widgets import bring_into_sight
from freecad.gaussiancad.qt import QtWidgets


class ComparePanel(EnginePanel):
    """The panel; FreeCAD shows the widgets in ``form``.

    Args:
        document: whose objects are offered.
    """

    def __init__(self, document: FreeCAD.Document) -> None:
        super().__init__(
            PanelTexts(
                translate("GaussianCAD", "Compare with Reference"),
                translate("GaussianCAD", "Compare"),
                translate("GaussianCAD", "Comparing"),
                "GaussianCAD_Compare",
            )
        )
        self._document_name = document.Name
        self._names = [candidate.Name for candidate in comparable_objects(document)]
        labels = [document.getObject(name).Label for name in self._names]
        self.result = _object_box("result", labels)
        self.reference = _object_box("reference", labels)
        self._choose_selected(document)
        self.distances = DistanceTable()
        self.run_view.log.setFixedHeight(90)
        self.form = [self._models_box(), self.run_view, self.distances]
        self.dress()
        self._compared = ("", "")

    def prepare(self, scratch: Path) -> list[str]:
        """Write both objects to files."""
        result, reference = self._chosen(self.result), self._chosen(self.reference)
        if result.Name == reference.Name:
            text = translate("GaussianCAD", "Choose two different objects to compare.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        self._compared = (result.Name, reference.Name)
        self.distances.clear()
        return CompareJob(
            str(export_geometry(result, scratch, "result")),
            str(export_geometry(reference, scratch, "reference")),
            str(scratch / "comparison"),
        ).arguments()

    def absorb(self, scratch: Path) -> Success:
        """Show the distances; add the coloured mesh to the document in one step."""
        loaded = load_comparison(scratch / "comparison", scratch)
        document = self._document()
        pair = tuple(document.getObject(name) for name in self._compared)
        if None in pair:
            text = translate("GaussianCAD", "An object was removed while it was being compared.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        add_comparison(document, loaded, pair)
        self.distances.show_comparison(loaded.report)
        bring_into_sight(self.distances)
        lines = self.distances.millimetre_lines(loaded.report)
        return Success(translate("GaussianCAD", "Finished"), tuple(lines))

    def set_editable(self, editable: bool) -> None:
        """Let the user choose other objects, or not."""
        self.result.setEnabled(editable)
        self.reference.setEnabled(editable)

    def _document(self) -> FreeCAD.Document:
        if self._document_name not in FreeCAD.listDocuments():
            text = translate("GaussianCAD", "The document was closed. Open it and compare again.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        return FreeCAD.getDocument(self._document_name)

    def _chosen(self, box: QtWidgets.QComboBox) -> FreeCAD.DocumentObject:
        index = box.currentIndex()
        chosen = self._document().getObject(self._names[index]) if index >= 0 else None
        if chosen is None:
            text = translate(
                "GaussianCAD",
                "There is nothing to compare. Open a document with a result and a reference: "
                "a part, a body or a mesh each.",
            )
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        return chosen

    def _choose_selected(self, document: FreeCAD.Document) -> None:
        """The first selected object is the result, the second one the reference."""
        selected = [item.Name for item in FreeCADGui.Selection.getSelection(document.Name)]
        wanted = [name for name in selected if name in self._names]
        others = [name for name in self._names if name not in wanted]
        for box, name in zip((self.result, self.reference), wanted + others, strict=False):
            box.setCurrentIndex(self._names.index(name))

    def _models_box(self) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Models"))
        layout = QtWidgets.QFormLayout(box)
        grow = QtWidgets.QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow
        layout.setFieldGrowthPolicy(grow)
        layout.addRow(translate("GaussianCAD", "Result"), self.result)
        layout.addRow(translate("GaussianCAD", "Reference"), self.reference)
        return box


def _object_box(name: str, labels: list[str]) -> QtWidgets.QComboBox:
    box = QtWidgets.QComboBox()
    box.setObjectName(name)
    policy = QtWidgets.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
    box.setSizeAdjustPolicy(policy)
    box.setMinimumContentsLength(8)
    box.addItems(labels)
    return box
