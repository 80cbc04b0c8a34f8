"""A drawing's lines as sketches from a script, in ``freecadcmd`` too; of a file, or of a TechDraw
page of a document::

from freecad.gaussiancad.sketching import sketch_drawing

group = sketch_drawing("part.pdf")
group.Document.saveAs("part.FCStd")
"""

import os
import tempfile
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun
from freecad.gaussiancad.engine.read_job import READING_FILE, ReadJob
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.cleaned_lines import read_cleaned
from freecad.gaussiancad.objects.document_sheets import export_sheet
from freecad.gaussiancad.objects.sketches import add_cleaned
from freecad.gaussiancad.preferences import read_preferences


def sketch_drawing(
    sheet: str | Path | FreeCAD.DocumentObject,
    document: FreeCAD.Document | None = None,
    page: int = 1,
) -> FreeCAD.DocumentObject:
    """Read a drawing, and add a sketch for each of its views, in one undo step.

    Args:
        sheet: path of the drawing; corrections beside it are taken.  A TechDraw page or a picture
            on a plane is written to a file first, with what it says of scale and projection.
        document: receives the sketches; a new one, named after the drawing, where there is none.
        page: of a file with pages.

    Returns:
        The group with the sketches.

    Raises:
        WorkbenchError: there is no engine, the drawing cannot be read, or no view has lines; the
            document is left as it was.
    """
    preference = read_preferences().engine_python
    engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
    with tempfile.TemporaryDirectory(prefix="gaussiancad-") as folder:
        is_file = isinstance(sheet, str | Path)
        path = Path(sheet).absolute() if is_file else export_sheet(sheet, Path(folder)).path
        run = EngineRun(engine, ReadJob(str(path), folder, page).arguments())
        run.start()
        result = run.wait()
        if result.state is not RunState.DONE:
            raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, result.words)
        cleaned = read_cleaned(Path(folder) / READING_FILE)
    return add_cleaned(document or FreeCAD.newDocument(path.stem), cleaned, path.stem)
