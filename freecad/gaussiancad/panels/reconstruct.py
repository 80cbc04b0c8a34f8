"""The task panel of *Reconstruct from Drawing…*.

The engine runs in a process of its own; the window stays alive.  The document is touched once, when
the run has succeeded and its files are read.
"""

import os
import tempfile
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.events import Event, EventKind
from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.locate import Engine, SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, RunState, Watcher
from freecad.gaussiancad.engine.report import Report
from freecad.gaussiancad.engine.summary import report_lines, status_text
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.panels.run_view import RunView
from freecad.gaussiancad.panels.settings_form import SettingsForm
from freecad.gaussiancad.panels.sheet_preview import SheetPreview
from freecad.gaussiancad.panels.widgets import PathField, standard_buttons
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtWidgets

SHEET_SUFFIXES = ("png", "jpg", "jpeg", "tif", "tiff", "bmp", "webp", "pdf", "svg", "dxf")

_PAGED_SUFFIXES = (".pdf", ".tif", ".tiff")


class ReconstructPanel:
    """The panel; FreeCAD shows the widgets in ``form``."""

    def __init__(self) -> None:
        self.sheet = PathField("sheet", self._browse_sheet)
        self.sheet.line.textChanged.connect(self._show_sheet)
        self.preview = SheetPreview(self.sheet.line.setText)
        self.settings = SettingsForm(read_preferences())
        self.run_view = RunView(
            translate("GaussianCAD", "Run"),
            translate("GaussianCAD", "Start"),
            self.start,
            self.cancel,
        )
        self.form = [self._drawing_box(), self.settings, self.run_view]
        for widget in self.form:
            widget.setWindowIcon(FreeCADGui.getIcon("GaussianCAD_Reconstruct"))
        self.run_view.destroyed.connect(self._leave)
        self._closed = False
        self._run: EngineRun | None = None
        self._job: ReconstructJob | None = None
        self._temporary: tempfile.TemporaryDirectory[str] | None = None
        self._document_name = ""

    @property
    def running(self) -> bool:
        """Whether the engine works for this panel."""
        return self._run is not None

    def start(self) -> None:
        """Start the engine on the chosen sheet; a user's mistake ends in a message box."""
        if self.running:
            return
        try:
            engine = find_engine(
                SearchPlaces.of_this_machine(read_preferences().engine_python, os.environ)
            )
            self._start(engine, self._checked_sheet())
        except WorkbenchError as error:
            self._complain(error.message)
        except OSError as error:
            self._complain(str(error))
            self._forget_run()

    def cancel(self) -> None:
        """Ask the engine to stop."""
        if self._run is not None:
            self.run_view.say_cancelling()
            self._run.cancel()

    def getStandardButtons(self) -> object:
        """A button that closes."""
        return standard_buttons(QtWidgets.QDialogButtonBox.StandardButton.Close)

    def reject(self) -> bool:
        """Close, or cancel the run first: then a second press closes."""
        if self.running:
            self.cancel()
            return False
        return True

    def isAllowedAlterDocument(self) -> bool:
        """The user may go on working."""
        return True

    def isAllowedAlterView(self) -> bool:
        """The user may look around."""
        return True

    def isAllowedAlterSelection(self) -> bool:
        """The user may select."""
        return True

    def _start(self, engine: Engine, sheet: str) -> None:
        document = FreeCAD.ActiveDocument
        self._document_name = document.Name if document is not None else ""
        self._job = self.settings.job(sheet, self._output_folder(sheet))
        watcher = Watcher(self._take_event, self._take_log, self._finish)
        self._run = EngineRun(engine, self._job.arguments(), watcher)
        self._set_editable(False)
        self.run_view.begin()
        self._run.start()

    def _leave(self) -> None:
        """The panel was closed from outside: stop the engine, and touch no widget any more."""
        self._closed = True
        if self._run is not None:
            self._run.cancel()

    def _take_log(self, line: str) -> None:
        if not self._closed:
            self.run_view.take_log(line)

    def _take_event(self, event: Event) -> None:
        if self._closed:
            return
        self.run_view.take_event(event)
        if event.kind is EventKind.PREVIEW:
            self.preview.show_file(event.text("path"))

    def _finish(self, result: RunResult) -> None:
        if self._closed:
            self._forget_run()
            return
        headline, whole = result.message, False
        try:
            if result.state is RunState.DONE:
                report = self._import()
                whole, headline = True, status_text(report.status)
                self.run_view.show_report(report_lines(report))
            elif result.state is not RunState.CANCELLED:
                headline = translate("GaussianCAD", "Stopped")
                self._complain(result.message)
        except WorkbenchError as error:
            headline = translate("GaussianCAD", "Stopped")
            self._complain(error.message)
        except Exception as error:  # a window must survive what FreeCAD's importers raise
            FreeCAD.Console.PrintLog(traceback.format_exc())
            headline = translate("GaussianCAD", "Stopped")
            text = translate("GaussianCAD", "The result cannot be added to the document: {reason}")
            self._complain(text.format(reason=error))
        finally:
            self.run_view.end(headline, whole)
            self._forget_run()

    def _import(self) -> Report:
        with tempfile.TemporaryDirectory(prefix="gaussiancad-views-") as scratch:
            run = load_run(self._job, Path(scratch))
            document = self._document()
            add_reconstruction(document, run)
        if run.overlay is not None:
            self.preview.show_file(str(run.overlay))
        _show_all(document)
        return run.report

    def _document(self) -> FreeCAD.Document:
        """The document in which the run began, or a new one if there is none any more."""
        if self._document_name in FreeCAD.listDocuments():
            return FreeCAD.getDocument(self._document_name)
        return FreeCAD.newDocument(translate("GaussianCAD", "Reconstruction"))

    def _checked_sheet(self) -> str:
        path = self.sheet.path
        if not path:
            text = translate("GaussianCAD", "Choose a drawing first.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text)
        if not Path(path).is_file():
            text = translate("GaussianCAD", "There is no file {path}. Choose another drawing.")
            raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(path=path))
        return path

    def _output_folder(self, sheet: str) -> str:
        chosen = self.settings.output.path
        if chosen:
            return str(Path(chosen).expanduser() / Path(sheet).stem)
        self._temporary = tempfile.TemporaryDirectory(
            prefix="gaussiancad-", ignore_cleanup_errors=True
        )
        return self._temporary.name

    def _forget_run(self) -> None:
        if self._temporary is not None:
            self._temporary.cleanup()
            self._temporary = None
        self._run = None
        if not self._closed:
            self._set_editable(True)

    def _set_editable(self, editable: bool) -> None:
        self.sheet.setEnabled(editable)
        self.settings.setEnabled(editable)
        self.preview.setAcceptDrops(editable)

    def _complain(self, text: str) -> None:
        show_error(translate("GaussianCAD", "Reconstruct from Drawing"), text)

    def _show_sheet(self, path: str) -> None:
        self.preview.show_file(path.strip())
        self.settings.show_page(path.strip().lower().endswith(_PAGED_SUFFIXES))

    def _browse_sheet(self) -> str:
        title = translate("GaussianCAD", "Choose a Drawing")
        drawings = translate("GaussianCAD", "Drawings")
        patterns = " ".join(f"*.{suffix} *.{suffix.upper()}" for suffix in SHEET_SUFFIXES)
        everything = translate("GaussianCAD", "All files")
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self.form[0], title, self.sheet.path, f"{drawings} ({patterns});;{everything} (*)"
        )
        return path

    def _drawing_box(self) -> QtWidgets.QWidget:
        box = QtWidgets.QWidget()
        box.setWindowTitle(translate("GaussianCAD", "Drawing"))
        layout = QtWidgets.QVBoxLayout(box)
        layout.addWidget(self.sheet)
        layout.addWidget(self.preview)
        return box


def _show_all(document: FreeCAD.Document) -> None:
    """Fit the document's 3D view; a window that shows something else stays as it is."""
    view = FreeCADGui.getDocument(document.Name).ActiveView
    if hasattr(view, "fitAll"):
        view.viewIsometric()
        view.fitAll()
