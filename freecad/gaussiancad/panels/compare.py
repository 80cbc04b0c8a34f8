"""The task panel of *Compare with Reference…*."""

from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.comparison_verdict import comparison_verdict
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparable import comparable_objects
from freecad.gaussiancad.objects.comparison import (
    CompareRequest,
    add_comparison,
    is_comparison,
    load_comparison,
    prepare_comparison,
    request_of,
    update_comparison,
)
from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.panels.comparison_view import ComparisonView
from freecad.gaussiancad.panels.engine_panel import EnginePanel, PanelTexts
from freecad.gaussiancad.panels.follow_up import Success
from freecad.gaussiancad.panels.model_box import ModelBox
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
        features = comparable_objects(document)
        self.result = ModelBox("result", features)
        self.reference = ModelBox("reference", features)
        self.view = ComparisonView()
        self.run_view.log.setFixedHeight(90)
        self.form = [self._models_box(), self.run_view, self.view]
        self.dress()
        self._request: CompareRequest | None = None
        self._shown = ""
        chosen = self._selected(document)
        again = next((each for each in chosen if is_comparison(each)), None)
        if again is None:
            self._choose(chosen, features)
        else:
            self._choose_again(again)

    def prepare(self, scratch: Path) -> list[str]:
        """Write both objects to files."""
        result, reference = self._chosen(self.result), self._chosen(self.reference)
        if result == reference:
            text = translate("GaussianCAD", "Choose two different objects to compare.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        self._request = CompareRequest(result, reference)
        self.view.clear()
        return prepare_comparison(self._request, scratch).arguments()

    def absorb(self, scratch: Path) -> Success:
        """Show the distances; add the coloured mesh to the document in one step."""
        loaded = load_comparison(scratch / "comparison", scratch)
        document = self._document()
        try:
            labels = [each.label for each in (self._request.result, self._request.reference)]
        except ReferenceError:
            text = translate("GaussianCAD", "An object was removed while it was being compared.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text) from None
        group = document.getObject(self._shown) if self._shown else None
        if group is not None and [group.Result, group.Reference] == labels:
            update_comparison(group, loaded, self._request)
        else:
            group = add_comparison(document, loaded, self._request)
        self._shown = group.Name
        self.view.show_group(group)
        bring_into_sight(self.view)
        warnings = [remark.words for remark in loaded.report.warnings]
        lines = self.view.distances.millimetre_lines(loaded.report)
        return Success(comparison_verdict(loaded.report.values), (*warnings, *lines))

    def _leave(self) -> None:
        super()._leave()
        self.view.take_off()

    def set_editable(self, editable: bool) -> None:
        """Let the user choose other objects, or not."""
        self.result.setEnabled(editable)
        self.reference.setEnabled(editable)

    def _document(self) -> FreeCAD.Document:
        if self._document_name not in FreeCAD.listDocuments():
            text = translate("GaussianCAD", "The document was closed. Open it and compare again.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        return FreeCAD.getDocument(self._document_name)

    def _chosen(self, box: ModelBox) -> Source:
        chosen = box.source(self._document())
        if chosen is None:
            text = translate(
                "GaussianCAD",
                "There is nothing to compare. Open a document with a result and a reference: "
                "a part, a body or a mesh each, or choose a file.",
            )
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        return chosen

    def _selected(self, document: FreeCAD.Document) -> list[FreeCAD.DocumentObject]:
        return list(FreeCADGui.Selection.getSelection(document.Name))

    def _choose(
        self, chosen: list[FreeCAD.DocumentObject], features: list[FreeCAD.DocumentObject]
    ) -> None:
        """The first selected object is the result, the second one the reference."""
        names = [feature.Name for feature in features]
        wanted = [item.Name for item in chosen if item.Name in names]
        others = [name for name in names if name not in wanted]
        for box, name in zip((self.result, self.reference), wanted + others, strict=False):
            box.choose(name)

    def _choose_again(self, group: FreeCAD.DocumentObject) -> None:
        """Show a comparison that is there, with what it compares."""
        request = request_of(group)
        if request is not None:
            for box, source in ((self.result, request.result), (self.reference, request.reference)):
                if source.feature is None:
                    box.choose_file(Path(source.path))
                else:
                    box.choose(source.feature.Name)
        self._shown = group.Name
        self.view.show_group(group)

    def _models_box(self) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Models"))
        layout = QtWidgets.QFormLayout(box)
        grow = QtWidgets.QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow
        layout.setFieldGrowthPolicy(grow)
        layout.addRow(translate("GaussianCAD", "Result"), self.result)
        layout.addRow(translate("GaussianCAD", "Reference"), self.reference)
        return box
