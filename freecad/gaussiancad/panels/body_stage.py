"""The body that follows a reconstruction: its features are found while the part is there already.

It is an undo step of its own.  Whatever becomes of it, the reconstruction stays as it is.
"""

import os
import tempfile
import traceback
from collections.abc import Callable
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.features_job import FeaturesJob
from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies
from freecad.gaussiancad.objects.bodies_of_parts import is_seen_as_body
from freecad.gaussiancad.objects.feature_file import FEATURES_FILE, read_features
from freecad.gaussiancad.objects.loading import LoadedRun, PartSource
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.solid_parts import part_named, write_solid
from freecad.gaussiancad.objects.solutions import has_choice
from freecad.gaussiancad.panels.follow_up import FollowUp, Success
from freecad.gaussiancad.panels.number_stage import NumberStage
from freecad.gaussiancad.panels.run_view import RunView
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore, QtWidgets


def why_no_body(group: FreeCAD.DocumentObject, run: LoadedRun) -> str:
    """Why a reconstruction does not become a body, a sentence; empty where it can.

    Args:
        group: the reconstruction.
        run: what was loaded into it.
    """
    if run.part is None or run.part.source is not PartSource.SOLID:
        return translate("GaussianCAD", "No body was made: the part is no exact solid.")
    if has_choice(group):
        return translate(
            "GaussianCAD",
            "No body was made: several solids fit the sheet. Choose one, then use To Body.",
        )
    if is_seen_as_body(find_part(group)):
        return translate("GaussianCAD", "The part is the same: its body stays as it is.")
    return ""


class BodyStage(FollowUp):
    """Finds the features of a reconstruction's part, adds the body and tries its numbers.

    Args:
        group: the reconstruction.
        view: shows how far it is.
        before: what the reconstruction has to say.
    """

    def __init__(self, group: FreeCAD.DocumentObject, view: RunView, before: Success) -> None:
        self._document, self._part = group.Document.Name, find_part(group).Name
        self._view, self._before = view, before
        self._folder = tempfile.TemporaryDirectory(
            prefix="gaussiancad-", ignore_cleanup_errors=True
        )
        self._run: EngineRun | None = None
        self._numbers: NumberStage | None = None
        self._gone = False

    def start(self, done: Callable[[Success], None]) -> None:
        """Look for the features."""
        self._done = done
        self._view.show_report(self._before.lines)
        looking = translate("GaussianCAD", "Looking for features")
        self._view.begin_part(f"{self._before.headline} {looking}")
        try:
            preference = read_preferences().engine_python
            engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
            folder = Path(self._folder.name)
            solid = write_solid(part_named(self._document, self._part), folder)
        except (WorkbenchError, OSError) as error:
            self._end_without(str(error))
            return
        arguments = FeaturesJob(str(solid), str(folder)).arguments()
        self._run = EngineRun(engine, arguments, Watcher(_ignore, self._take_log, self._finish))
        self._run.start()

    def cancel(self) -> None:
        """Leave the part without a body, or the body's other numbers untried."""
        if self._numbers is not None:
            self._numbers.cancel()
        elif self._run is not None:
            self._run.cancel()

    def leave(self) -> None:
        """The same, without the panel."""
        self._gone = True
        if self._numbers is not None:
            self._numbers.leave()
        elif self._run is not None:
            self._run.cancel()

    def _take_log(self, line: str) -> None:
        if not self._gone:
            self._view.take_log(line)

    def _finish(self, result: RunResult) -> None:
        if self._gone or result.state is not RunState.DONE:
            self._end_without(_sentence(result))
            return
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.CursorShape.WaitCursor)
        try:
            made = self._add()
        except WorkbenchError as error:
            self._end_without(error.message)
            return
        except Exception as error:  # FreeCAD raises its own types; the part is there
            FreeCAD.Console.PrintLog(traceback.format_exc())
            self._end_without(_no_body(str(error)))
            return
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()
        self._numbers = NumberStage(made, self._view)
        self._numbers.start(self._end)

    def _add(self) -> tuple[MadeBody, ...]:
        features = read_features(Path(self._folder.name) / FEATURES_FILE)
        return add_bodies(part_named(self._document, self._part), features)

    def _end(self, body: Success) -> None:
        self._folder.cleanup()
        self._done(Success(f"{self._before.headline} {body.headline}", body.lines))

    def _end_without(self, reason: str) -> None:
        if not self._gone:
            self._view.take_log(reason)
        self._end(Success(reason))


def _ignore(event: Event) -> None:
    """The stages of the features are not those of the run that the panel shows."""


def _sentence(result: RunResult) -> str:
    if result.state is RunState.CANCELLED:
        return translate("GaussianCAD", "No body was made: it was cancelled.")
    return _no_body(result.words)


def _no_body(reason: str) -> str:
    text = translate("GaussianCAD", "No body was made: {reason}.")
    return text.format(reason=reason.rstrip("."))
