"""The task panel of *Check Against Drawing…*."""

import shutil
import tempfile
from dataclasses import replace
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.check_file import CheckVerdict, read_check
from freecad.gaussiancad.engine.check_job import CHECK_FILE, CHECK_PICTURE, CheckJob
from freecad.gaussiancad.engine.job import PAGED_SUFFIXES, Projection, ReconstructJob
from freecad.gaussiancad.engine.process import RunResult
from freecad.gaussiancad.engine.protocol import Event
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparable import comparable_objects
from freecad.gaussiancad.objects.corrected_sheet import kept_corrections
from freecad.gaussiancad.objects.known_sheets import group_of
from freecad.gaussiancad.objects.model_watch import ModelWatch
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.panels.check_view import CheckView
from freecad.gaussiancad.panels.chosen_sheet import ask_sheet, sheet_among
from freecad.gaussiancad.panels.correct import open_sheet
from freecad.gaussiancad.panels.document_source import DocumentSource
from freecad.gaussiancad.panels.engine_panel import EnginePanel, PanelTexts
from freecad.gaussiancad.panels.follow_up import Success
from freecad.gaussiancad.panels.model_box import ModelBox
from freecad.gaussiancad.panels.setting_boxes import projection_box
from freecad.gaussiancad.panels.widgets import PathField, bring_into_sight
from freecad.gaussiancad.qt import QtWidgets

_MOST_PAGES = 9999

_VERDICTS = (4, 5)
"""The engine's exit codes of models that differ, and of those of which it cannot tell."""

_SIZE_UNKNOWN = ("scale-assumed", "full-scale-assumed")
"""Codes of warnings that ask for a length, which a check does not need."""

_LOG = 60
"""px of the messages: there are few."""


class CheckPanel(EnginePanel):
    """The panel; FreeCAD shows the widgets in ``form``.

    Args:
        document: whose objects are offered.
    """

    def __init__(self, document: FreeCAD.Document) -> None:
        super().__init__(
            PanelTexts(
                translate("GaussianCAD", "Check Against Drawing"),
                translate("GaussianCAD", "Check"),
                translate("GaussianCAD", "Starting the engine"),
                "GaussianCAD_Check",
            )
        )
        self._document_name = document.Name
        objects = comparable_objects(document)
        self.model = ModelBox("model", objects)
        self.sheet = PathField("sheet", self._browse)
        self.sheet.line.textChanged.connect(self._show_sheet)
        self.source = DocumentSource(self._take_source)
        self.page = QtWidgets.QSpinBox()
        self.page.setObjectName("page")
        self.page.setRange(1, _MOST_PAGES)
        self.page.valueChanged.connect(lambda _: self._take_settings())
        self.projection = projection_box(Projection.AUTO)
        self.view = CheckView()
        self.run_view.log.setFixedHeight(_LOG)
        self.form = [self._choice_box(), self.run_view, self.view]
        self.dress()
        self._job: CheckJob | None = None
        self._checked: Source | None = None
        self._watch: ModelWatch | None = None
        self._pictures = tempfile.TemporaryDirectory(
            prefix="gaussiancad-", ignore_cleanup_errors=True
        )
        self._choose(list(FreeCADGui.Selection.getSelection(document.Name)), objects)

    def prepare(self, scratch: Path) -> list[str]:
        """Write the model to a file."""
        sheet, page = self._checked_sheet(), self.page.value()
        document = self._document()
        model = self.model.source(document)
        if model is None:
            text = translate(
                "GaussianCAD",
                "There is nothing to check. Open a document with a part, a body or a mesh, or "
                "choose a file.",
            )
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        self.view.clear()
        self._forget_watch()
        # Watched from here on: the model may be changed while the engine works.
        self._checked, self._watch = model, ModelWatch(model, self._tell_stale)
        known = CheckJob(
            str(sheet), str(model.file(scratch / "model")), str(scratch / "check"), page
        )
        group = group_of(document, sheet, page)
        if group is not None:
            settings = ReconstructJob.kept(str(sheet), "", texts_of(group, "Settings"))
            corrections = kept_corrections(group, sheet, scratch)
            known = replace(
                known,
                scale=settings.scale,
                thickness=settings.thickness,
                corrections="" if corrections is None else str(corrections),
            )
        self._job = replace(known, projection=self.projection.mode)
        return self._job.arguments()

    def take_event(self, event: Event) -> None:
        """Show an event; that the size is not known is told with the outcome."""
        if event.text("code") not in _SIZE_UNKNOWN:
            super().take_event(event)

    def has_outcome(self, result: RunResult) -> bool:
        """A model that differs, or of which nothing can be told, has been checked all the same."""
        return super().has_outcome(result) or (
            result.exit_code in _VERDICTS
            and not result.code
            and Path(self._job.output, CHECK_FILE).is_file()
        )

    def absorb(self, scratch: Path) -> Success:
        """Show what was found; the document stays as it is."""
        output = Path(self._job.output)
        check = read_check(output / CHECK_FILE)
        picture = Path(self._pictures.name) / CHECK_PICTURE
        if (output / CHECK_PICTURE).is_file():
            shutil.copyfile(output / CHECK_PICTURE, picture)
        self.view.show_check(check, picture, self._document(), self._checked)
        if self._watch is not None and self._watch.is_changed:
            self.view.tell_stale()
        self.run_view.start_button.setText(translate("GaussianCAD", "Check Again"))
        bring_into_sight(self.view)
        if check.verdict is CheckVerdict.CANNOT_TELL:
            self.run_view.offer(translate("GaussianCAD", "Correct Sheet…"), self._correct)
        return Success(translate("GaussianCAD", "Finished"))

    def set_editable(self, editable: bool) -> None:
        """Let the user choose another model or drawing, or not."""
        for widget in (self.model, self.sheet, self.source, self.page, self.projection):
            widget.setEnabled(editable)

    def _leave(self) -> None:
        super()._leave()
        self.view.take_off()
        self._forget_watch()
        self._pictures.cleanup()

    def _forget_watch(self) -> None:
        if self._watch is not None:
            self._watch.stop()
            self._watch = None

    def _tell_stale(self) -> None:
        # While the engine works the end of the run tells it.
        if not self._closed and not self.running:
            self.view.tell_stale()

    def _document(self) -> FreeCAD.Document:
        if self._document_name not in FreeCAD.listDocuments():
            text = translate("GaussianCAD", "The document was closed. Open it and check again.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text)
        return FreeCAD.getDocument(self._document_name)

    def _checked_sheet(self) -> Path:
        path = self.sheet.path
        if not path:
            text = translate("GaussianCAD", "Choose a drawing first.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text)
        if not Path(path).is_file():
            text = translate("GaussianCAD", "There is no file {path}. Choose another drawing.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(path=path))
        return Path(path)

    def _choose(
        self, selected: list[FreeCAD.DocumentObject], objects: list[FreeCAD.DocumentObject]
    ) -> None:
        """Take what is selected, or what it belongs to; and the drawing that it was made from."""
        names = [each.Name for each in objects]
        for item in selected:
            part = find_part(item) if hasattr(item, "SheetPath") else item
            holders = () if part is None else (part, *part.InList)
            chosen = next((each for each in holders if each.Name in names), None)
            if chosen is not None:
                self.model.choose(chosen.Name)
                break
        model = self.model.source(self._document())
        known = [] if model is None or model.feature is None else [model.feature]
        self._take_sheet([*selected, *known])

    def _take_source(self, source: FreeCAD.DocumentObject) -> None:
        self._take_sheet([source])

    def _take_sheet(self, objects: list[FreeCAD.DocumentObject]) -> None:
        """Take the drawing of the first object that knows one; tell the user why not."""
        try:
            found = sheet_among(objects)
        except (WorkbenchError, OSError) as error:
            self._complain(str(error))
            return
        if found is not None:
            path, page = found
            self.sheet.line.setText(str(path))
            self.page.setValue(page)

    def _show_sheet(self, path: str) -> None:
        has_pages = path.strip().lower().endswith(PAGED_SUFFIXES)
        for widget in (self.page, self._page_label):
            widget.setVisible(has_pages)
        self.page.setValue(1)
        self.projection.choose(Projection.AUTO)
        self._take_settings()

    def _take_settings(self) -> None:
        """Take what the document knows of the drawing's page."""
        path = self.sheet.path
        document = FreeCAD.listDocuments().get(self._document_name)
        if document is None or not path:
            return
        group = group_of(document, Path(path), self.page.value())
        if group is not None:
            job = ReconstructJob.kept(path, "", texts_of(group, "Settings"))
            self.projection.choose(job.projection)

    def _browse(self) -> str:
        return str(ask_sheet(self.form[0], self.sheet.path) or "")

    def _correct(self) -> None:
        if self._document_name in FreeCAD.listDocuments():
            FreeCAD.setActiveDocument(self._document_name)
        open_sheet(Path(self._job.sheet), self._job.page)

    def _choice_box(self) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Model and drawing"))
        layout = QtWidgets.QFormLayout(box)
        grow = QtWidgets.QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow
        layout.setFieldGrowthPolicy(grow)
        self._page_label = QtWidgets.QLabel(translate("GaussianCAD", "Page"))
        layout.addRow(translate("GaussianCAD", "Model"), self.model)
        layout.addRow(translate("GaussianCAD", "Drawing"), self.sheet)
        layout.addRow("", self.source)
        layout.addRow(self._page_label, self.page)
        layout.addRow(translate("GaussianCAD", "Projection"), self.projection)
        for widget in (self.page, self._page_label):
            widget.hide()
        return box
