"""A part as an editable body from a script, in ``freecadcmd`` too::

from pathlib import Path
from freecad.gaussiancad.objects.shown_objects import save_shown
from freecad.gaussiancad.remodelling import remodel

(made,) = remodel(document.getObject("Part"))
save_shown(made.body.Document, Path("part.FCStd"))
"""

import os
import tempfile
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.features_job import FeaturesJob
from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies, try_numbers
from freecad.gaussiancad.objects.feature_file import FEATURES_FILE, read_features
from freecad.gaussiancad.objects.solid_parts import write_solid
from freecad.gaussiancad.preferences import read_preferences


def remodel(part: FreeCAD.DocumentObject) -> tuple[MadeBody, ...]:
    """Find the features of a part, and add a body with them beside it, in one undo step.

    Args:
        part: a feature with one solid.

    Returns:
        What was made, one for each solid; the part is hidden.

    Raises:
        WorkbenchError: there is no engine, it finds no features, or they do not make the solid;
            the document is left as it was.
    """
    preference = read_preferences().engine_python
    engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
    with tempfile.TemporaryDirectory(prefix="gaussiancad-") as folder:
        solid = write_solid(part, Path(folder))
        run = EngineRun(engine, FeaturesJob(str(solid), folder).arguments())
        run.start()
        return add_found(part, run.wait(), Path(folder))


def add_found(
    part: FreeCAD.DocumentObject, result: RunResult, folder: Path
) -> tuple[MadeBody, ...]:
    """Add a body of the features that the engine has found on a part, in one undo step, and try
    its numbers.

    Args:
        part: a feature with the solid.
        result: of the engine's run.
        folder: where the engine wrote; it is not needed afterwards.

    Raises:
        WorkbenchError: as of :func:`remodel`.
    """
    if result.state is not RunState.DONE:
        raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, result.words)
    return tuple(map(try_numbers, add_bodies(part, read_features(folder / FEATURES_FILE))))
