"""The task panel of *Reconstruct from Drawing…*."""

import tempfile
import traceback
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.job import PAGED_SUFFIXES, ReconstructJob, Scale
from freecad.gaussiancad.engine.process import RunResult
from freecad.gaussiancad.engine.protocol import Event, EventKind, Status
from freecad.gaussiancad.engine.summary import report_lines, verdict_text
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.document_sheets import export_sheet, first_sheet_object
from freecad.gaussiancad.objects.early_part import EarlyPart, complete, leave, show_early
from freecad.gaussiancad.objects.known_sheets import group_of, sheet_of
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction_features import part_length
from freecad.gaussiancad.objects.solutions import SolutionSet, has_choice
from freecad.gaussiancad.panels.body_stage import BodyStage, why_no_body
from freecad.gaussiancad.panels.chosen_sheet import ask_sheet
from freecad.gaussiancad.panels.correct import open_canvas, open_sheet
from freecad.gaussiancad.panels.document_source import DocumentSource
from freecad.gaussiancad.panels.engine_panel import EnginePanel, PanelTexts
from freecad.gaussiancad.panels.fitted_view import show_all
from freecad.gaussiancad.panels.follow_up import Success
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.panels.page_pictures import PagePictures
from freecad.gaussiancad.panels.settings_form import SettingsForm
from freecad.gaussiancad.panels.sheet_preview import SheetPreview
from freecad.gaussiancad.panels.solutions import open_solutions
from freecad.gaussiancad.panels.target_document import TargetDocument
from freecad.gaussiancad.panels.thickness_question import ThicknessQuestion
from freecad.gaussiancad.panels.widgets import PathField
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.remembered import remember, starting_choices

_ALIKE = 1.3
"""Factor by which a part may grow before the 3D view is fitted to it again."""

_NO_MODEL = 4
"""The engine's exit code where a drawing was read and no model follows from it."""


def _correct_text() -> str:
    return translate("GaussianCAD", "Correct Sheet…")


class ReconstructPanel(EnginePanel):
    """The panel; FreeCAD shows the widgets in ``form``."""

    def __init__(self) -> None:
        super().__init__(
            PanelTexts(
                translate("GaussianCAD", "Reconstruct from Drawing"),
                translate("GaussianCAD", "Start"),
                translate("GaussianCAD", "Starting the engine"),
                "GaussianCAD_Reconstruct",
            )
        )
        self.sheet = PathField("sheet", self._browse_sheet)
        self.sheet.line.textChanged.connect(self._show_sheet)
        self.preview = SheetPreview(self.sheet.line.setText)
        self._pictures = PagePictures(self._show_page)
        self.settings = SettingsForm(starting_choices(read_preferences()))
        self.settings.page.valueChanged.connect(lambda _: self._show_preview())
        self.source = DocumentSource(self.take_source)
        self.target = TargetDocument()
        self.question = ThicknessQuestion(self.start)
        self.run_view.add_question(self.question)
        self._exports: tempfile.TemporaryDirectory[str] | None = None
        self._scaled_sheet = ""
        self.form = [self._drawing_box(), self.settings, self.run_view]
        self.dress()
        self._job: ReconstructJob | None = None
        self._document_name = ""
        self._shown_mm = 0.0
        self._early: EarlyPart | None = None
        self._source: tuple[str, FreeCAD.DocumentObject] | None = None
        self._holder = ""
        self._body_of: FreeCAD.DocumentObject | None = None
        selected = first_sheet_object(FreeCADGui.Selection.getSelection())
        if selected is not None:
            self.take_source(selected)

    def take_source(self, source: FreeCAD.DocumentObject) -> None:
        """Take the drawing that an object of the document holds; tell the user why not."""
        if self._exports is None:
            self._exports = tempfile.TemporaryDirectory(
                prefix="gaussiancad-", ignore_cleanup_errors=True
            )
        try:
            exported = export_sheet(source, Path(self._exports.name))
        except (WorkbenchError, OSError) as error:
            self._complain(str(error))
            return
        self.sheet.line.setText(str(exported.path))
        self._source, self._holder = (str(exported.path), source), source.Document.Name
        self._suggest_target()
        if exported.mm_per_pixel is not None:
            self.settings.tell_mm_per_pixel(exported.mm_per_pixel)
            self._scaled_sheet = str(exported.path)
        if exported.projection is not None:
            self.settings.tell_projection(exported.projection)

    def take_group(self, group: FreeCAD.DocumentObject) -> None:
        """Take the drawing and the settings of a reconstruction of the document.

        Raises:
            WorkbenchError: neither the drawing nor the document's copy of it is there.
        """
        sheet = sheet_of(group)
        if sheet is None:
            text = translate(
                "GaussianCAD",
                "The drawing of {name} is gone, and the document holds no copy of it. Choose the "
                "drawing in Reconstruct from Drawing.",
            )
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(name=group.Label))
        self.sheet.line.setText(str(sheet))
        job = ReconstructJob.kept(str(sheet), "", texts_of(group, "Settings"))
        self.settings.take_job(job)
        self.question.take(job.thickness)

    def prepare(self, scratch: Path) -> list[str]:
        """Turn the settings into a job; remember the document into which the part goes."""
        sheet = self._checked_sheet()
        chosen = self.settings.output.path
        folder = Path(chosen).expanduser() / Path(sheet).stem if chosen else scratch / "run"
        self._suggest_target()
        self._document_name = self.target.name
        self._early = None
        job = self.settings.job(sheet, str(folder))
        self._job = replace(job, thickness=self.question.thickness)
        document = FreeCAD.getDocument(self._document_name) if self._document_name else None
        known = group_of(document, Path(sheet), self._job.page) if document is not None else None
        self._shown_mm = 0.0 if known is None else part_length(known)
        remember(self.settings.choices, read_preferences())
        return self._job.arguments()

    def absorb(self, scratch: Path) -> Success:
        """Read everything, then add it to the document in one step."""
        views = scratch / "views"
        views.mkdir()
        run = load_run(self._job, views, read_preferences().view_planes)
        group = complete(self._early, self._document(), run)
        if run.overlay is not None:
            self.preview.show_file(str(run.overlay))
        self._show(group)
        self._document_name = group.Document.Name
        self.target.take(self._document_name)
        self._early = None
        if has_choice(group):
            self._offer_choice(group)
        elif run.report.status is not Status.VERIFIED:
            self.run_view.offer(_correct_text(), self._correct)
        verdict, self._body_of = verdict_text(run.report), None
        if self.settings.wants_body:
            reason = why_no_body(group, run)
            verdict = f"{verdict} {reason}".rstrip()
            self._body_of = None if reason else group
        return Success(verdict, tuple(report_lines(run.report)))

    def follow_up(self, success: Success) -> BodyStage | None:
        """Make the body of an exact solid, which is shown already."""
        group, self._body_of = self._body_of, None
        return None if group is None else BodyStage(group, self.run_view, success)

    def set_editable(self, editable: bool) -> None:
        """Let the user change drawing and settings, or not."""
        self.sheet.setEnabled(editable)
        self.settings.setEnabled(editable)
        self.preview.setAcceptDrops(editable)
        self.source.setEnabled(editable)
        self.target.setEnabled(editable)
        self.question.setEnabled(editable)

    def take_event(self, event: Event) -> None:
        """Show an event; a preview replaces the picture of the sheet, a solid becomes the part."""
        super().take_event(event)
        if event.kind is EventKind.PREVIEW:
            self.preview.show_file(event.text("path"))
        elif event.kind is EventKind.SOLID and self._early is None:
            self._show_part(event)

    def give_up(self, reason: str) -> str:
        """Leave the part that was shown, with a note."""
        early, self._early = self._early, None
        if leave(early, reason):
            return translate("GaussianCAD", "The part stays in the document.")
        return ""

    def ask(self, result: RunResult) -> bool:
        """How thick the part is, where the drawing has one view alone and does not tell."""
        return self.question.ask(result)

    def way_out(self, result: RunResult) -> tuple[str, Callable[[], None]] | None:
        """The canvas, where no model follows from the drawing as it was read."""
        return (_correct_text(), self._correct) if result.exit_code == _NO_MODEL else None

    def _correct(self) -> None:
        """Open the canvas on the drawing of the last run, in that run's document."""
        if self._document_name in FreeCAD.listDocuments():
            FreeCAD.setActiveDocument(self._document_name)
        if self._source is not None and self._source[0] == self._job.sheet:
            open_canvas([self._source[1]])
        else:
            open_sheet(Path(self._job.sheet), self._job.page)

    def _show_part(self, event: Event) -> None:
        """Add the part as soon as it is final; the rest follows when the run ends."""
        document = self._document()
        try:
            status = Status(event.text("status"))
            self._early = show_early(document, self._job, Path(event.text("path")), status)
        except Exception:  # the end of the run tells what cannot be read
            FreeCAD.Console.PrintLog(traceback.format_exc())
            return
        self._document_name = document.Name
        self._show(self._early.find())

    def _show(self, group: FreeCAD.DocumentObject) -> None:
        """Fit the 3D view, unless a part of about that size was there already."""
        length = part_length(group)
        if not 1.0 / _ALIKE < length / max(self._shown_mm, 1e-9) < _ALIKE:
            show_all(group.Document)
        self._shown_mm = length

    def _leave(self) -> None:
        super()._leave()
        self._pictures.close()
        if self._exports is not None:
            self._exports.cleanup()

    def _offer_choice(self, group: FreeCAD.DocumentObject) -> None:
        text = translate("GaussianCAD", "Choose among {count} Solutions…")
        count = len(SolutionSet(group))
        document, name = group.Document.Name, group.Name

        def choose() -> None:
            # The user may have undone the run in the meantime, or closed the document.
            known = document in FreeCAD.listDocuments()
            found = FreeCAD.getDocument(document).getObject(name) if known else None
            if found is not None and has_choice(found):
                open_solutions(found)

        self.run_view.offer(text.format(count=count), choose)

    def _document(self) -> FreeCAD.Document:
        """The document in which the run began, or a new one if there is none any more."""
        if self._document_name in FreeCAD.listDocuments():
            return FreeCAD.getDocument(self._document_name)
        return FreeCAD.newDocument(Path(self._job.sheet).stem)

    def _checked_sheet(self) -> str:
        path = self.sheet.path
        if not path:
            text = translate("GaussianCAD", "Choose a drawing first.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text)
        if not Path(path).is_file():
            text = translate("GaussianCAD", "There is no file {path}. Choose another drawing.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(path=path))
        return path

    def _show_sheet(self, path: str) -> None:
        if self._scaled_sheet:
            # The scale was that of another drawing.
            self._scaled_sheet = ""
            self.settings.forget_scale()
        self.settings.forget_projection()
        if not self.running:
            # What is shown is of another drawing.
            self.run_view.forget()
        self.question.take(Scale())
        self._suggest_target()
        self.settings.show_page(path.strip().lower().endswith(PAGED_SUFFIXES))
        self._show_preview()

    def _show_preview(self) -> None:
        """The drawing; what FreeCAD cannot show, as soon as the engine has its picture."""
        path = self.sheet.path
        self._pictures.forget()
        self.preview.show_file(path)
        if not self.preview.has_picture and Path(path).is_file():
            self._pictures.ask(path, self.settings.page.value())

    def _show_page(self, picture: str) -> None:
        if not self._closed and not self.running:
            self.preview.show_file(picture)

    def _suggest_target(self) -> None:
        path = self.sheet.path
        item = self._holder if self._source is not None and self._source[0] == path else ""
        self.target.suggest(path, self.settings.page.value(), item)

    def _browse_sheet(self) -> str:
        return str(ask_sheet(self.form[0], self.sheet.path) or "")

    def _drawing_box(self) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Drawing"))
        layout = QtWidgets.QVBoxLayout(box)
        layout.addWidget(self.sheet)
        layout.addWidget(self.source)
        layout.addWidget(self.preview)
        layout.addWidget(self.target)
        return box


def run_again(group: FreeCAD.DocumentObject) -> None:
    """Open the panel on a reconstruction of the document, and start; tell the user why not."""
    FreeCAD.setActiveDocument(group.Document.Name)
    panel = ReconstructPanel()
    FreeCADGui.Control.showDialog(panel)
    try:
        panel.take_group(group)
    except WorkbenchError as error:
        FreeCADGui.Control.closeDialog()
        show_error(translate("GaussianCAD", "Run Again"), error.message)
        return
    panel.start()
