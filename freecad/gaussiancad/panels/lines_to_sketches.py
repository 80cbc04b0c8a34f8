"""The task panel of *Lines to Sketches…*: reads a drawing, and shows how far that is."""

from collections.abc import Callable, Sequence
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.job import PAGED_SUFFIXES
from freecad.gaussiancad.engine.process import RunResult
from freecad.gaussiancad.engine.protocol import Event, EventKind
from freecad.gaussiancad.engine.read_job import READING_FILE, ReadJob
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.cleaned_lines import CleanedSheet, read_cleaned
from freecad.gaussiancad.objects.corrected_sheet import kept_corrections
from freecad.gaussiancad.objects.known_sheets import group_of
from freecad.gaussiancad.objects.sketches import add_cleaned
from freecad.gaussiancad.panels.chosen_sheet import ask_sheet, sheet_among
from freecad.gaussiancad.panels.correct import open_sheet
from freecad.gaussiancad.panels.engine_panel import EnginePanel, PanelTexts
from freecad.gaussiancad.panels.fitted_view import show_all
from freecad.gaussiancad.panels.follow_up import Success
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.qt import QtWidgets

_MOST_PAGES = 9999


def open_sketches(selected: Sequence[FreeCAD.DocumentObject]) -> "SketchesPanel | None":
    """Read the drawing of what is selected, or of a file that is asked for, and add its sketches.

    Args:
        selected: objects of the document; the drawing of a reconstruction among them is taken, or
            a TechDraw page, or a picture on a plane.

    Returns:
        The panel, at work; None where no drawing was chosen, or it cannot be had, which is told.
    """
    try:
        chosen = sheet_among(selected)
    except (WorkbenchError, OSError) as error:
        show_error(_title(), str(error))
        return None
    if chosen is None:
        path = ask_sheet(FreeCADGui.getMainWindow())
        if path is None:
            return None
        chosen = path, 1
    panel = SketchesPanel(*chosen)
    FreeCADGui.Control.showDialog(panel)
    panel.start()
    return panel


class SketchesPanel(EnginePanel):
    """The panel; FreeCAD shows the widgets in ``form``.

    Args:
        sheet: path of the drawing.
        page: of a file with pages.
    """

    def __init__(self, sheet: Path, page: int = 1) -> None:
        super().__init__(
            PanelTexts(
                _title(),
                translate("GaussianCAD", "Make Sketches"),
                translate("GaussianCAD", "Starting the engine"),
                "GaussianCAD_LinesToSketches",
            )
        )
        self._sheet = sheet
        self.page = QtWidgets.QSpinBox()
        self.page.setObjectName("page")
        self.page.setRange(1, _MOST_PAGES)
        self.page.setValue(page)
        self._job: ReadJob | None = None
        self._document_name = ""
        self._lacks_views = False
        self.form = [self._drawing_box(), self.run_view]
        self.dress()

    def prepare(self, scratch: Path) -> list[str]:
        """Turn the drawing into a job; remember the document that is active now."""
        if not self._sheet.is_file():
            text = translate("GaussianCAD", "There is no file {path}. Choose another drawing.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(path=self._sheet))
        document, page = FreeCAD.ActiveDocument, self.page.value()
        self._document_name = document.Name if document is not None else ""
        self._lacks_views = False
        group = None if document is None else group_of(document, self._sheet, page)
        stated = None if group is None else kept_corrections(group, self._sheet, scratch)
        corrections = "" if stated is None else str(stated)
        self._job = ReadJob(str(self._sheet), str(scratch / "read"), page, corrections)
        return self._job.arguments()

    def absorb(self, scratch: Path) -> Success:
        """Add the sketches to the document in one step."""
        try:
            sheet = read_cleaned(scratch / "read" / READING_FILE)
        except WorkbenchError as error:
            self._lacks_views = error.code is ErrorCode.NO_VIEWS
            raise
        document = self._document()
        add_cleaned(document, sheet, self._sheet.stem)
        show_all(document)
        return Success(told_count(sheet), sheet.doubts)

    def take_event(self, event: Event) -> None:
        """Show an event; warnings are in the reading, and told with the sketches."""
        if event.kind is not EventKind.WARNING:
            super().take_event(event)

    def set_editable(self, editable: bool) -> None:
        """Let the user choose another page, or not."""
        self.page.setEnabled(editable)

    def way_out(self, result: RunResult) -> tuple[str, Callable[[], None]] | None:
        """The canvas, where views can be boxed."""
        if result.state is not RunState.DONE or not self._lacks_views:
            return None
        return translate("GaussianCAD", "Correct Sheet…"), self._correct

    def _correct(self) -> None:
        if self._document_name in FreeCAD.listDocuments():
            FreeCAD.setActiveDocument(self._document_name)
        open_sheet(self._sheet, self._job.page)

    def _document(self) -> FreeCAD.Document:
        """The document in which the run began, or a new one if there is none any more."""
        if self._document_name not in FreeCAD.listDocuments():
            self._document_name = FreeCAD.newDocument(self._sheet.stem).Name
        return FreeCAD.getDocument(self._document_name)

    def _drawing_box(self) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Drawing"))
        layout = QtWidgets.QFormLayout(box)
        name = QtWidgets.QLabel(self._sheet.name)
        name.setWordWrap(True)
        name.setToolTip(str(self._sheet))
        layout.addRow(name)
        if self._sheet.suffix.lower() in PAGED_SUFFIXES:
            layout.addRow(translate("GaussianCAD", "Page"), self.page)
        return box


def told_count(sheet: CleanedSheet) -> str:
    """How many sketches there are, of how many lines."""
    text = translate("GaussianCAD", "Sketches: {sketches}, of {lines} lines.")
    stated = text.format(sketches=len(sheet.views), lines=sheet.count)
    if sheet.doubts:
        stated += " " + translate("GaussianCAD", "What is in doubt is below.")
    return stated


def _title() -> str:
    return translate("GaussianCAD", "Lines to Sketches")
