"""*File > Open* and *Import* of a drawing, and files that are dropped into the window.

With a window the drawing opens in the canvas, where the part appears; without one the engine makes
the solid at once.
"""

import os
import tempfile
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun
from freecad.gaussiancad.engine.protocol import ResultKind
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.preferences import read_preferences


def open(path: str) -> None:  # the name that FreeCAD calls
    """Open a drawing in a document of its own, as :func:`insert`; after an error there is none."""
    name = FreeCAD.newDocument(Path(path).stem).Name
    try:
        insert(path, name)
    except WorkbenchError:
        FreeCAD.closeDocument(name)
        raise


def insert(path: str, name: str) -> None:
    """Open a drawing in a document.

    Args:
        path: of the drawing.
        name: of the document; it is made where there is none.

    Raises:
        WorkbenchError: without a window, that no part follows, or why the engine does not work.
    """
    known = name in FreeCAD.listDocuments()
    document = FreeCAD.getDocument(name) if known else FreeCAD.newDocument(name)
    if not FreeCAD.GuiUp:
        _reconstruct(Path(path), document)
        return
    from freecad.gaussiancad.panels.correct import open_sheet

    FreeCAD.setActiveDocument(document.Name)
    open_sheet(Path(path))


def _reconstruct(sheet: Path, document: FreeCAD.Document) -> None:
    preferences = read_preferences()
    places = SearchPlaces.of_this_machine(preferences.engine_python, os.environ)
    engine = find_engine(places)
    with tempfile.TemporaryDirectory(prefix="gaussiancad-") as folder:
        scratch = Path(folder)
        job = ReconstructJob(str(sheet), str(scratch / "run"), outcome=ResultKind.SOLID)
        run = EngineRun(engine, job.arguments())
        run.start()
        result = run.wait()
        if result.state is not RunState.DONE:
            raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, result.words)
        views = scratch / "views"
        views.mkdir()
        add_reconstruction(document, load_run(job, views, preferences.view_planes))
