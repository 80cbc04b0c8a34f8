"""The bodies in the documents of a batch, as *To Body* makes them."""

import tempfile
from dataclasses import dataclass
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.batch_report import BodyOutcome
from freecad.gaussiancad.batch_stop import BatchStopped, StopOnSignals
from freecad.gaussiancad.engine.features_job import FeaturesJob
from freecad.gaussiancad.engine.locate import Engine
from freecad.gaussiancad.engine.process import EngineRun
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.bodies import MadeBody
from freecad.gaussiancad.objects.loading import LoadedRun, PartSource
from freecad.gaussiancad.objects.properties import add_properties
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.reconstruction_properties import hidden_property
from freecad.gaussiancad.remodelling import add_found

NO_SOLID = "No body was made: the sheet has no exact solid."

NOT_ADDED = (
    "No body was made: the document is kept as it was; remove it, and --resume makes it again."
)


@dataclass(frozen=True)
class BodyMaker:
    """Makes bodies.

    Attributes:
        engine: finds the features.
        stop: ends that when the batch is stopped.
        grace: s between the steps of stopping.
    """

    engine: Engine
    stop: StopOnSignals
    grace: float

    def add(self, group: FreeCAD.DocumentObject, run: LoadedRun) -> BodyOutcome:
        """Add the body of a reconstruction to its document; without one that stays as it is.

        Args:
            group: the reconstruction.
            run: what was loaded into it.

        Returns:
            What became of it.

        Raises:
            BatchStopped: somebody stopped the batch meanwhile.
            OSError: there is no room for the features.
        """
        if run.part is None or run.part.source is not PartSource.SOLID:
            return BodyOutcome(NO_SOLID)
        try:
            # The engine's own file: the drawing's numbers lie in the same folder.
            made = self._add(find_part(group), Path(run.job.output) / run.part.source.value)
        except WorkbenchError as error:
            says_so = error.code is ErrorCode.NO_BODY
            return BodyOutcome(error.message if says_so else f"No body was made: {error.message}")
        except (BatchStopped, OSError):
            raise
        except Exception as error:  # FreeCAD raises its own types; the solid is there
            return BodyOutcome(f"No body was made: {error}")
        hidden = [each.Name for each in group.Document.Objects if not each.Visibility]
        add_properties(group, [hidden_property(hidden)])
        breaking = tuple(number for each in made for number in each.breaking)
        return BodyOutcome("", breaking, sum(each.trials.untried for each in made))

    def _add(self, part: FreeCAD.DocumentObject, solid: Path) -> tuple[MadeBody, ...]:
        with tempfile.TemporaryDirectory(prefix="gaussiancad-") as folder:
            arguments = FeaturesJob(str(solid), folder).arguments()
            result = self.stop.wait_for(EngineRun(self.engine, arguments, grace=self.grace))
            return add_found(part, result, Path(folder))
