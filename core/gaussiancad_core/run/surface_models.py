"""A run's hull, Gaussians and surface, one stage after the other."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.messages import Message
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.processes.events import Progress
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.run import surface_stage
from gaussiancad_core.run.run_models import Models
from gaussiancad_core.run.solid_outlines import PlacedInk, with_solid_outlines
from gaussiancad_core.sheet.image.colouring import coloured
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.splatting.checkpoints import CheckpointPlace
from gaussiancad_core.splatting.gaussian_training import TrainingResult
from gaussiancad_core.storage.outputs import OutputFolder
from gaussiancad_core.surface.nearness import weighed
from gaussiancad_protocol.codes import Code

if TYPE_CHECKING:
    from gaussiancad_core.run.exact_stage import ExactModel


@dataclass(frozen=True)
class SurfaceRun:
    """What the stages of the surface need of a run.

    Attributes:
        job: what to do.
        folder: of the run's files.
        progress: told how far it is.
        notes: the report as it fills.
        sheet: with all its ink, upright.
    """

    job: Job
    folder: OutputFolder
    progress: Progress
    notes: RunNotes
    sheet: CleanSheet

    def models(
        self,
        registered: RegisteredSheet,
        exact: "ExactModel | None",
        solid: "ExactModel | None",
        turn: Turn,
    ) -> Models | None:
        """Hull, Gaussians and surface.

        Args:
            registered: the views.
            exact: the exact solid whose depths carve the hull.
            solid: the same, if it is one of the run's results.
            turn: of the sheet.

        Returns:
            None where they are no body, and the solid stands alone.

        Raises:
            NoModelError: they are no body, and there is no solid either.
        """
        try:
            return self._surface_models(registered, exact, solid, turn)
        except NoModelError as error:
            if solid is None:
                raise
            self.notes.warn(
                error.code, f"{error.message}: there is no surface in addition to the solid"
            )
            return None

    def _surface_models(
        self,
        registered: RegisteredSheet,
        exact: "ExactModel | None",
        solid: "ExactModel | None",
        turn: Turn,
    ) -> Models:
        with self.notes.stage("hull"):
            registered = self._with_whole_outlines(registered, exact)
            views = registered.views
            hull = surface_stage.make_hull(self.job, views, exact)
            self.notes.tell(hull=surface_stage.hull_report(hull))
        with self.notes.stage("gaussians"):
            training = self._train(hull.mesh, views)
            gaussians = surface_stage.gaussians_report(training, self.job, views)
            residuals = surface_stage.residuals(training, self.job, registered, turn)
            self.notes.tell(
                gaussians=replace(gaussians, residuals=residuals),
                device=surface_stage.training_device(self.job),
            )
        with self.notes.stage("surface"):
            surface = weighed(self._poisson(training, solid), hull.mesh, views)
            self.notes.tell(surface=surface_stage.surface_report(surface))
        return Models(registered, training, surface)

    def _poisson(self, training: TrainingResult, solid: "ExactModel | None") -> TriangleMesh | None:
        """The mesh of the Gaussians; where there is a solid it may be missing."""
        try:
            return surface_stage.make_surface(training, self.job)
        except NoModelError as error:
            if solid is None:
                raise
            self.notes.warn(error.code, f"{error.message}: hull.stl stands for their mesh")
            return None

    def _with_whole_outlines(
        self, registered: RegisteredSheet, exact: "ExactModel | None"
    ) -> RegisteredSheet:
        """The views in colour, their masks the exact solid's where the ink encloses others."""
        result = exact.result if exact else None
        outlined = with_solid_outlines(
            registered.views, result, PlacedInk(self.sheet, registered.placements)
        )
        if outlined.closed:
            names = " and ".join(role.value for role in outlined.closed)
            self.notes.warn(
                Code.OUTLINE_OF_SOLID,
                Message(
                    "the lines around the {views} view leave gaps: the surface was made with the "
                    "exact solid's outline there",
                    views=names,
                ),
            )
        return replace(registered, views=coloured(outlined.views, self.job.reading.colour))

    def _train(self, hull: TriangleMesh, views: ViewSet) -> TrainingResult:
        if surface_stage.takes_long(self.job):
            self.notes.warn(
                Code.TRAINING_TAKES_LONG,
                "so many iterations on images of this size take an hour or more on a processor: "
                "use --preset draft, --scale-down N, or a GPU; with --resume a run that is broken "
                "off goes on",
            )
        place = CheckpointPlace(self.folder.checkpoint, self.folder.staging, resume=self.job.resume)
        training = surface_stage.train_on(hull, self.job, views, self.progress, place)
        if training.passed_over:
            self.notes.warn(
                Code.CHECKPOINT_IGNORED,
                "the checkpoint in the output folder belongs to another sheet, other options or "
                "another version: the training began anew",
            )
        return training
