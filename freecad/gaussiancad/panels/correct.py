"""The canvas in FreeCAD: a dock beside the 3D view; corrections and part are the document's."""

from collections.abc import Sequence
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.canvas.engine_server import Engines
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.corrected_sheet import (
    CORRECTIONS,
    InDocument,
    offer_solutions,
    open_in,
    take_reading,
    take_solution,
)
from freecad.gaussiancad.objects.reconstruction_features import CHOICE, find_part
from freecad.gaussiancad.panels.body_changes import BodyChanges
from freecad.gaussiancad.panels.chosen_sheet import ask_sheet, sheet_among
from freecad.gaussiancad.panels.engine_program import engine_program
from freecad.gaussiancad.panels.fitted_view import show_all
from freecad.gaussiancad.panels.full_run import full_job
from freecad.gaussiancad.panels.jobs import job_list
from freecad.gaussiancad.panels.solutions import open_solutions
from freecad.gaussiancad.qt import QtCore, QtWidgets

DOCK_NAME = "GaussianCADCanvas"

_ALIKE = 1.3
"""Factor by which a part may grow before the 3D view is fitted to it again."""

_WIDTH = 620
"""px of a dock that is opened."""


def open_canvas(selected: Sequence[FreeCAD.DocumentObject]) -> "CanvasDock | None":
    """Open the canvas on what is selected, or on a file that is asked for.

    Args:
        selected: objects of the document; the drawing of a reconstruction among them is taken, or
            a TechDraw page, or a picture on a plane.

    Returns:
        The dock; None where no drawing was chosen, there is no engine, or the corrections beside
        the drawing are damaged, which is told.
    """
    try:
        chosen = sheet_among(selected)
    except (WorkbenchError, OSError) as error:
        _complain(str(error))
        return None
    if chosen is not None:
        return open_sheet(*chosen)
    path = ask_sheet(FreeCADGui.getMainWindow())
    if path is not None and FreeCAD.ActiveDocument is not None and FreeCAD.ActiveDocument.Objects:
        # Another drawing's part would lie over what is there.
        FreeCAD.newDocument(path.stem)
    return open_sheet(path) if path is not None else None


def open_sheet(path: Path, page: int = 1) -> "CanvasDock | None":
    """Open the canvas on a file, in the active document or a new one; as :func:`open_canvas`."""
    try:
        program = engine_program()
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument(path.stem)
        group = open_in(document, path, page)
    except (WorkbenchError, ValueError, OSError) as error:
        _complain(str(error))
        return None
    main = FreeCADGui.getMainWindow()
    others = open_docks()
    for other in others:
        if other.store.find() is group:
            other.come_back()
            return other
    shared = (item.canvas.engines for item in others if item.canvas.engines.program == program)
    engines = next(shared, None) or Engines.of(program)
    dock = CanvasDock(path, page, engines, InDocument(group, path, page), main)
    main.addDockWidget(QtCore.Qt.DockWidgetArea.RightDockWidgetArea, dock)
    for this_other in others:
        main.tabifyDockWidget(this_other, dock)
    main.resizeDocks([dock], [_WIDTH], QtCore.Qt.Orientation.Horizontal)
    dock.show()
    dock.raise_()
    dock.canvas.start()
    return dock


def open_docks() -> "list[CanvasDock]":
    """The canvases that are open; one that was closed stays a widget for a while."""
    found = FreeCADGui.getMainWindow().findChildren(CanvasDock)
    return [item for item in found if item.is_open]


class CanvasDock(QtWidgets.QDockWidget):
    """The canvas of one drawing.

    Args:
        path: of the drawing.
        page: of a file with pages.
        engines: those of other canvases, where there are any.
        store: of the corrections.
        main: FreeCAD's window.
    """

    def __init__(
        self,
        path: Path,
        page: int,
        engines: Engines,
        store: InDocument,
        main: QtWidgets.QWidget,
    ) -> None:
        # The drawing's name first: of several tabs little more is seen.
        title = translate("GaussianCAD", "{name} \u2013 Correct Sheet")
        super().__init__(title.format(name=path.name), main)
        self.setObjectName(DOCK_NAME)
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        self.store = store
        self.canvas = SheetWindow(path, page, engines=engines, store=store, parent=self)
        self.canvas.setWindowFlags(QtCore.Qt.WindowType.Widget)
        self.setWidget(self.canvas)
        self.canvas.add_action(translate("GaussianCAD", "Mesh and Gaussians"), self.make_all)
        solutions = translate("GaussianCAD", "Choose among Solutions…")
        self.canvas.add_help("ambiguous", solutions, self.choose_solution)
        self._shown_mm, self._folder = 0.0, ""
        session = self.canvas.session
        self.canvas.page_asked.connect(lambda number: open_sheet(path, number))
        session.changed.connect(self._keep_reading)
        session.solved.connect(self._take)
        self.canvas.canvas_view.installEventFilter(self)
        self.changes = BodyChanges(store, self.canvas)
        session.read.connect(self.changes.follow)
        self._observer = _Observer(self)
        FreeCAD.addDocumentObserver(self._observer)

    @property
    def is_open(self) -> bool:
        """Whether it was not closed yet."""
        return self._observer is not None

    def closeEvent(self, event: object) -> None:
        """Leave the engines with the dock; the document keeps what was said."""
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None
        self.changes.close()
        self.canvas.close()
        super().closeEvent(event)

    def eventFilter(self, watched: QtCore.QObject, event: QtCore.QEvent) -> bool:
        """Undo and redo are those of the document whose canvas has the focus."""
        if event.type() == QtCore.QEvent.Type.FocusIn and self.store.find() is not None:
            FreeCAD.setActiveDocument(self.store.document)
        return super().eventFilter(watched, event)

    def make_all(self) -> None:
        """Have mesh and Gaussians made as well, as a job of the list."""
        group, session = self.store.find(), self.canvas.session
        if group is not None and session.sheet is not None:
            job_list().add(full_job(self.store, session.path, session.page))

    def choose_solution(self) -> None:
        """Show all solids that have the drawing's lines, to choose one."""
        group = self.store.find()
        if group is None or not self._folder:
            return
        try:
            offer_solutions(group, Path(self._folder))
        except WorkbenchError as error:
            self.canvas.tell(str(error))
            return
        open_solutions(group)

    def leave(self) -> None:
        """Hide while the document does not have the drawing."""
        if self.is_open and self.store.find() is None:
            self.hide()

    def come_back(self) -> None:
        """Show the drawing that the document has again, with all that was said of it."""
        if self.is_open and self.store.find() is not None:
            self.show()
            self.raise_()
            self.follow()

    def come_forward(self) -> None:
        """Lie over the canvases of other documents."""
        if self.is_open and self.isVisible():
            self.raise_()

    def follow(self) -> None:
        """Show the corrections that the document has now, and make their part."""
        if self.store.find() is not None:
            self.store.copy()
            self.canvas.session.refresh()

    def settle_choice(self) -> None:
        """Ask no more which solid is meant where a person kept one."""
        group = self.store.find()
        if group is not None:
            self.canvas.settle("ambiguous", bool(getattr(group, CHOICE, "")))

    def _keep_reading(self) -> None:
        group = self.store.find()
        if group is not None and not group.Reading:
            take_reading(group, self.canvas.session.reading_file)

    def _take(self, _report: object, folder: str) -> None:
        group = self.store.find()
        if group is None or not folder:
            return
        self._folder = folder
        try:
            take_solution(group, Path(folder))
        except WorkbenchError as error:
            self.canvas.tell(str(error))
            return
        self.settle_choice()
        length = find_part(group).Shape.BoundBox.DiagonalLength
        if not 1.0 / _ALIKE < length / max(self._shown_mm, 1e-9) < _ALIKE:
            self._shown_mm = length
            show_all(group.Document)


class _Observer:
    """Tells a canvas what becomes of its group; FreeCAD calls its methods by their names."""

    def __init__(self, dock: CanvasDock) -> None:
        self._dock = dock

    def slotChangedObject(self, changed: FreeCAD.DocumentObject, name: str) -> None:
        """Corrections were said, taken back or said again."""
        if name == CORRECTIONS and self._is_its(changed):
            QtCore.QTimer.singleShot(0, self._dock.follow)
        elif name == CHOICE and self._is_its(changed):
            QtCore.QTimer.singleShot(0, self._dock.settle_choice)

    def slotRemoveDynamicProperty(self, changed: FreeCAD.DocumentObject, name: str) -> None:
        """Keeping a solution was undone."""
        if name == CHOICE and self._is_its(changed):
            QtCore.QTimer.singleShot(0, self._dock.settle_choice)

    def slotDeletedObject(self, deleted: FreeCAD.DocumentObject) -> None:
        """An object goes; without its group the canvas is of no use, until that comes back."""
        if self._is_its(deleted):
            QtCore.QTimer.singleShot(0, self._dock.leave)

    def slotCreatedObject(self, created: FreeCAD.DocumentObject) -> None:
        """Opening the drawing was taken back, and is done again."""
        if self._is_its(created):
            QtCore.QTimer.singleShot(0, self._dock.come_back)

    def slotActivateDocument(self, document: FreeCAD.Document) -> None:
        """Another document is in front: its canvas is, too."""
        if document.Name == self._dock.store.document:
            QtCore.QTimer.singleShot(0, self._dock.come_forward)

    def slotDeletedDocument(self, document: FreeCAD.Document) -> None:
        """A document goes, and its canvas with it."""
        if document.Name == self._dock.store.document:
            QtCore.QTimer.singleShot(0, self._dock.close)

    def _is_its(self, document_object: FreeCAD.DocumentObject) -> bool:
        store = self._dock.store
        return (
            document_object.Name == store.group and document_object.Document.Name == store.document
        )


def _complain(text: str) -> None:
    QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(), "GaussianCAD", text)
