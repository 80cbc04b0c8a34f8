"""The canvas in FreeCAD: its engine, its drawing, and the document that receives the part."""

import os
import tempfile
from collections.abc import Sequence
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.canvas.window import Program, SheetWindow
from freecad.gaussiancad.engine.environment import clean_environment
from freecad.gaussiancad.engine.job import MODULE_ARGUMENTS, SHEET_SUFFIXES, Outcome, ReconstructJob
from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.summary import verdict_text
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.reconstruction import replace_reconstruction
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore, QtWidgets


def open_canvas(selected: Sequence[FreeCAD.DocumentObject]) -> SheetWindow | None:
    """Open the canvas.

    Args:
        selected: objects of the document; the drawing of a reconstruction among them is taken.

    Returns:
        The window; None where no drawing was chosen, there is no engine, or the corrections beside
        the drawing are damaged, which is told.
    """
    main = FreeCADGui.getMainWindow()
    path = _sheet_of(selected) or _asked(main)
    if not path:
        return None
    try:
        preference = read_preferences().engine_python
        engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
    except WorkbenchError as error:
        QtWidgets.QMessageBox.warning(main, "GaussianCAD", str(error))
        return None
    program = Program((engine.python, *MODULE_ARGUMENTS), clean_environment(os.environ))
    try:
        window = SheetWindow(Path(path), program=program, parent=main)
    except (ValueError, OSError) as error:
        QtWidgets.QMessageBox.warning(main, "GaussianCAD", str(error))
        return None
    window.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    receiver = _Receiver(window, path)
    window.solved.connect(receiver.take)
    window.show()
    window.start()
    return window


class _Receiver(QtCore.QObject):
    """Puts the part of a canvas into a document, in place of the one before.

    Args:
        window: whose part it is; it owns this object.
        sheet: path of the drawing.
    """

    def __init__(self, window: SheetWindow, sheet: str) -> None:
        super().__init__(window)
        self._window, self._sheet = window, sheet
        active = FreeCAD.ActiveDocument
        self._document = active.Name if active is not None else ""
        self._group = ""

    def take(self, folder: str) -> None:
        """Add what a run left in a folder, in one undo step."""
        job = ReconstructJob(self._sheet, folder, outcome=Outcome.SOLID)
        with tempfile.TemporaryDirectory(prefix="gaussiancad-") as views:
            try:
                run = load_run(job, Path(views))
            except WorkbenchError as error:
                self._window.tell(str(error))
                return
            if self._document not in FreeCAD.listDocuments():
                self._document = FreeCAD.newDocument("Reconstruction").Name
            document = FreeCAD.getDocument(self._document)
            group = replace_reconstruction(document, self._group, run)
        self._group = group.Name
        self._window.tell(verdict_text(run.report))
        _show(document)


def _show(document: FreeCAD.Document) -> None:
    view = FreeCADGui.getDocument(document.Name).ActiveView
    if hasattr(view, "fitAll"):
        view.fitAll()


def _sheet_of(selected: Sequence[FreeCAD.DocumentObject]) -> str:
    for own in selected:
        path = getattr(own, "SheetPath", "")
        if isinstance(path, str) and Path(path).is_file():
            return path
    return ""


def _asked(parent: QtWidgets.QWidget) -> str:
    title = translate("GaussianCAD", "Choose a Drawing")
    drawings = translate("GaussianCAD", "Drawings")
    patterns = " ".join(f"*.{suffix} *.{suffix.upper()}" for suffix in SHEET_SUFFIXES)
    path, _ = QtWidgets.QFileDialog.getOpenFileName(parent, title, "", f"{drawings} ({patterns})")
    return path
