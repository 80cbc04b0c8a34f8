"""The stages of a run in order, each from dataclass to dataclass.

read -> views -> lines -> masks -> solid -> hull -> gaussians -> surface -> check -> write.
"""

import json
from dataclasses import replace
from typing import TYPE_CHECKING

from gaussiancad_core.axes import Projection, mutually_orthogonal
from gaussiancad_core.errors import (
    CancelledError,
    GaussianCadError,
    LimitError,
    NoModelError,
)
from gaussiancad_core.events import Listener, Progress
from gaussiancad_core.job import Job
from gaussiancad_core.models import Models, write_models, write_solids
from gaussiancad_core.modes import Device, Recipe, ResultKind, Status
from gaussiancad_core.outputs import RUN_FILES, OutputFolder, os_error
from gaussiancad_core.report import Report, ViewReport
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet, upright_sheet
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.options import Box, Finder, ReadingOptions
from gaussiancad_core.sheet.read import SheetImage, read_sheet
from gaussiancad_core.sheet.reading import (
    ReadView,
    RegisteredSheet,
    find_views,
    read_views,
    register_views,
)
from gaussiancad_core.sheet.scale.find import ScaleSource, find_scale
from gaussiancad_core.sheet.special_views.kinds import SpecialView
from gaussiancad_core.sheet.special_views.telling import tellings
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet

if TYPE_CHECKING:
    from gaussiancad_core.exact_stage import ExactModel, Reading
    from gaussiancad_core.meshes import TriangleMesh
    from gaussiancad_core.reasoning.conflict_lines import Conflict
    from gaussiancad_core.splatting.training import TrainingResult
    from gaussiancad_core.views import ViewSet

STAGES = (
    "read",
    "views",
    "lines",
    "masks",
    "solid",
    "hull",
    "gaussians",
    "surface",
    "check",
    "write",
)

_SURFACE_STAGES = ("hull", "gaussians", "surface")

REPORT_FILE = "report.json"


def stages_of(result: ResultKind, recipe: Recipe = Recipe.ORTHOGRAPHIC) -> tuple[str, ...]:
    """The stages of a run that is asked for some of the models.

    A surface is carved by the depths of the exact solid, but for the paper's.
    """
    paper = ("solid",) if recipe is Recipe.PAPER else ()
    left_out = {
        ResultKind.SOLID: _SURFACE_STAGES,
        ResultKind.SURFACE: paper,
        ResultKind.BOTH: (),
    }[result]
    return tuple(name for name in STAGES if name not in left_out)


def reconstruct(job: Job, listener: Listener) -> Report:
    """Run a job and write its files.

    Returns:
        The report as written; its status is never ``failed``.

    Raises:
        GaussianCadError: the run failed; for :class:`NoModelError` and :class:`LimitError` the
            report is written all the same.
    """
    folder = OutputFolder(job.output, RUN_FILES, REPORT_FILE)
    run = _Run(job, folder, Progress(listener, len(stages_of(job.result, job.recipe))))
    try:
        return run.all_stages()
    except CancelledError as error:
        raise CancelledError(error.code, f"{error.message} {run.how_far()}") from error
    except (NoModelError, LimitError, MemoryError) as error:
        failure = _as_limit(error)
        run.write_failure(failure)
        raise failure from error
    except OSError as error:
        if isinstance(error, GaussianCadError):
            raise
        raise os_error(job.output, error) from error
    finally:
        folder.discard(keep_checkpoint=job.resume)


def _as_limit(error: BaseException) -> GaussianCadError:
    if isinstance(error, GaussianCadError):
        return error
    return LimitError(
        "out-of-memory", "the memory does not suffice: use --preset draft or a smaller sheet"
    )


class _Run:
    """A run in progress: the job, the staging folder and the report as it fills."""

    def __init__(self, job: Job, folder: OutputFolder, progress: Progress) -> None:
        self.job = job
        self.folder = folder
        self.progress = progress
        self.report = Report("", job.settings())
        self.marks: tuple[Mark, ...] = ()
        self.symbol: Projection | None = None
        self.contradicted = False
        self.special: tuple[SpecialView, ...] = ()
        self.conflict: Conflict | None = None

    def all_stages(self) -> Report:
        """Read, reconstruct, check and write."""
        _check_device(self.job.device)
        with self._stage("read"):
            image = read_sheet(self.job.sheet, self.job.page)
            self.report = replace(self.report, sheet_sha256=image.sha256)
            for note in image.notes:
                self._warn(note.code, note.message)
            if self.job.resume and (earlier := self._earlier()):
                return earlier
            clean = upright_sheet(clean_sheet(image.grey, self.job.reading.median_kernel))
        own, other = self._read_sheet(image, clean)
        exact = None
        if "solid" in stages_of(self.job.result, self.job.recipe):
            with self._stage("solid"):
                exact = self._find_solid(own, other, clean.turn)
                own = exact.reading if exact else own
        self._tell_symbol(own.projection)
        asked = exact is not None and self.job.result is not ResultKind.SURFACE
        solid = exact if asked and exact.result.shape is not None else None
        with_surface = self.job.result is not ResultKind.SOLID
        models = self._make_models(own.registered, exact, clean.turn) if with_surface else None
        with self._stage("check"):
            self._check(clean, own.registered, models, solid)
        with self._stage("write"):
            if solid:
                write_solids(solid.result, self.folder.staging)
            if models:
                write_models(models, self.job, self.folder.staging, self.progress)
        # Lines of a section are no edges, and a broken view is no measure: nothing verifies them.
        plain = not any(view.used for view in self.special)
        self._finish(solid.result.status if solid and plain else Status.APPROXIMATE)
        return self.report

    def write_failure(self, error: GaussianCadError) -> None:
        """Leave a report of how far the run came and why it ended there."""
        self.report = self.report.doubted(error.code, error.message)
        for entry in self.folder.staging.iterdir():
            if entry.is_file():
                entry.unlink()
        self._finish(Status.FAILED)

    def how_far(self) -> str:
        """Where the run was when it was stopped, for a message."""
        name = self.progress.current
        if not name:
            return "before its first stage: nothing was written"
        stages = stages_of(self.job.result, self.job.recipe)
        where = f"{name} ({stages.index(name) + 1} of {len(stages)})"
        kept = self.job.resume and self.folder.checkpoint.is_file()
        written = "only a checkpoint was written, --resume goes on from it"
        return f"in the stage {where}: {written if kept else 'nothing was written'}"

    def _stage(self, name: str):  # noqa: ANN202
        self.report = replace(self.report, stage=name)
        return self.progress.stage(name)

    def _finish(self, status: Status) -> None:
        self.report = replace(self.report, status=status, seconds=dict(self.progress.seconds))
        self.report.write(self.folder.staging / REPORT_FILE)
        self.folder.commit()

    def _warn(self, code: str, message: str) -> None:
        self.report = self.report.warned(code, message)
        self.progress.listener.send("warning", code=code, message=message)

    def _earlier(self) -> Report | None:
        """The report of a finished run of the same job in the same folder."""
        try:
            found = json.loads((self.folder.path / REPORT_FILE).read_text(encoding="utf-8"))
            same = (
                found["settings"] == self.report.settings
                and found["engine"]["sheet_sha256"] == self.report.sheet_sha256
                and found["status"] != Status.FAILED.value
            )
        except (OSError, ValueError, KeyError):
            return None
        return replace(self.report, status=Status(found["status"])) if same else None

    def _read_sheet(self, image: SheetImage, clean: CleanSheet) -> "tuple[Reading, Reading | None]":
        """Views, lines and masks of a sheet, on shared axes, under one or two projections."""
        from gaussiancad_core.exact_stage import Reading

        reading = self.job.reading
        with self._stage("views"):
            given = {role: clean.turn.box_to_upright(box) for role, box in reading.views}
            separated, layout = find_views(clean, given, reading.projection)
            self._tell_marks(separated.marks, clean.turn)
            self._tell_layout(layout, clean.turn)
        with self._stage("lines"):
            vectors = _vectors(image, clean) if reading.finder is Finder.RIDGES else None
            drawn = read_views(separated.part, layout, self.progress, reading.finder, vectors)
            options = self._scaled(image, clean, drawn)
        with self._stage("masks"):
            if self.job.recipe is Recipe.PAPER:
                options = replace(options, open_holes=False)
            if layout.alternatives and not reading.views:
                own, other = self._choose_projection(drawn, layout, options)
            else:
                own = Reading(register_views(drawn, options), self.report.projection)
                other = None
            self._tell_views(own.registered, clean.turn)
            self._tell_registration(own.registered)
        return own, other

    def _scaled(
        self, image: SheetImage, clean: CleanSheet, drawn: tuple[ReadView, ...]
    ) -> ReadingOptions:
        """What the user said, with the scale that the sheet tells where they said none."""
        reading = self.job.reading
        if reading.length is not None or reading.mm_per_pixel is not None:
            self.report = replace(self.report, scale_source=ScaleSource.GIVEN.value)
            return reading
        found = find_scale(image, clean, self.marks, drawn)
        self.report = replace(
            self.report, scale_source=found.source.value, dimensions=found.dimensions
        )
        for note in found.notes:
            self._warn(note.code, note.message)
        return replace(reading, mm_per_pixel=found.mm_per_pixel)

    def _choose_projection(
        self, drawn: tuple[ReadView, ...], layout: Layout, options: ReadingOptions
    ) -> "tuple[Reading, Reading | None]":
        """The likelier reading of the views, and the other one where it is possible."""
        from gaussiancad_core.exact_stage import Reading
        from gaussiancad_core.projection_choice import choose_projection

        choice = choose_projection(drawn, layout.projection, options)
        if layout.symbol is not None:
            self.symbol = layout.symbol
            self.contradicted = choice.inferred and choice.projection is not layout.symbol
            choice = choice.told(layout.symbol)
        self._tell_projection(choice.projection, choice.inferred)
        other = Reading(choice.other, choice.projection.other) if choice.other else None
        return Reading(choice.registered, choice.projection), other

    def _tell_symbol(self, taken: Projection) -> None:
        """Say where the projection symbol and the lines do not agree."""
        if self.symbol is None or (taken is self.symbol and not self.contradicted):
            return
        self._warn(
            "symbol-contradicts-lines",
            f"the projection symbol says {self.symbol.value} angle, but the visible and hidden "
            f"lines fit {self.symbol.other.value} angle better: {taken.value} angle was taken; "
            "tell --projection if it is the other",
        )

    def _tell_projection(self, projection: Projection, inferred: bool) -> None:
        self.report = replace(
            self.report,
            projection=projection,
            projection_source="inferred" if inferred else "default",
            projection_alternatives=() if inferred else (projection.other,),
        )

    def _find_solid(
        self, own: "Reading", other: "Reading | None", turn: Turn
    ) -> "ExactModel | None":
        """The exact solid, or what stands for it, and what it says about the projection."""
        from gaussiancad_core.exact_stage import (
            OPEN_ENDED,
            find_exact,
            find_for_hull,
            with_fallback,
        )
        from gaussiancad_core.solid_reports import with_solid_facts

        surface_alone = self.job.result is ResultKind.SURFACE
        exact = find_for_hull(own, other) if surface_alone else find_exact(own, other)
        if exact and exact.decided:
            self._tell_projection(exact.reading.projection, inferred=True)
        if exact is None or surface_alone:
            return exact
        exact = with_fallback(exact)
        for code, message in exact.result.reasons:
            self.report = self.report.doubted(code, message)
        self.conflict = exact.result.conflict
        self.report = with_solid_facts(self.report, exact, turn)
        if self.job.result is ResultKind.SOLID and exact.result.shape is None:
            code, message = exact.result.reasons[0]
            raise (LimitError if code in OPEN_ENDED else NoModelError)(code, message)
        return exact

    def _tell_views(self, registered: RegisteredSheet, turn: Turn) -> None:
        boxes = {view.role: ViewReport(view.stored_box(turn)) for view in registered.drawn}
        self.report = replace(self.report, views=boxes)

    def _tell_marks(self, marks: tuple[Mark, ...], turn: Turn) -> None:
        kinds: dict[str, list[Box]] = {}
        for mark in marks:
            kinds.setdefault(mark.kind.value, []).append(turn.box_to_stored(mark.box))
        self.marks = marks
        self.report = replace(self.report, annotations=kinds)

    def _tell_layout(self, layout: Layout, turn: Turn) -> None:
        self.report = replace(
            self.report,
            projection=layout.projection,
            projection_source=layout.source,
            projection_alternatives=layout.alternatives,
            views={role: ViewReport(turn.box_to_stored(box)) for role, box in layout.boxes.items()},
        )
        special = tuple(replace(view, box=turn.box_to_stored(view.box)) for view in layout.special)
        self.special = layout.special
        self.report = replace(self.report, special_views=special)
        for told in tellings(special):
            if told.doubt:
                self.report = self.report.doubted(told.code, told.message)
            else:
                self._warn(told.code, told.message)
        if layout.left_out:
            boxes = ("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*b) for b in layout.left_out[:5])
            places = "; ".join(boxes)
            self._warn(
                "lines-left-out",
                f"{len(layout.left_out)} group(s) of lines belong to no view and were left out: "
                f"{places} px",
            )

    def _tell_registration(self, registered: RegisteredSheet) -> None:
        self.report = replace(
            self.report,
            scale_mm_per_pixel=registered.mm_per_pixel,
            bounding_box_mm=registered.views.size,
            strokes_source=registered.source.value,
            residuals_px={
                axis.name.lower(): (residual.median, residual.largest)
                for axis, residual in registered.extents.residuals.items()
            },
        )
        if self.report.scale_source == ScaleSource.DEFAULT.value:
            self._warn(
                "scale-assumed",
                "the scale is not known: the longest edge was made 100 mm; "
                "tell --length AXIS=MM or --mm-per-pixel",
            )
        for axis in registered.extents.disagreeing:
            spread = registered.extents.spread[axis]
            residual = registered.extents.residuals[axis]
            self._warn(
                "views-disagree",
                f"the views differ by {spread:.1f} px in the part's extent along {axis.name}, and "
                f"by up to {residual.largest:.1f} px from the coordinates that they share: "
                "their mean was taken",
            )
        if not mutually_orthogonal(registered.views.roles):
            self.report = self.report.doubted(
                "two-views", "only two directions of view: what a third would show is not known"
            )

    def _make_models(
        self, registered: RegisteredSheet, exact: "ExactModel | None", turn: Turn
    ) -> Models:
        """Hull, Gaussians and surface."""
        from gaussiancad_core import surface_stage

        views = registered.views
        with self._stage("hull"):
            hull = surface_stage.make_hull(self.job, views, exact)
            self.report = replace(self.report, hull=surface_stage.hull_report(hull))
        with self._stage("gaussians"):
            training = self._train(hull.mesh, views)
            gaussians = surface_stage.gaussians_report(training, self.job, views)
            residuals = surface_stage.residuals(training, self.job, registered, turn)
            self.report = replace(
                self.report,
                gaussians=replace(gaussians, residuals=residuals),
                device=surface_stage.training_device(self.job),
            )
        with self._stage("surface"):
            surface = surface_stage.make_surface(training, hull.mesh, self.job, views)
            self.report = replace(self.report, surface=surface_stage.surface_report(surface))
        return Models(registered, training, surface.mesh)

    def _train(self, hull: "TriangleMesh", views: "ViewSet") -> "TrainingResult":
        from gaussiancad_core import surface_stage
        from gaussiancad_core.splatting.checkpoints import CheckpointPlace

        if surface_stage.takes_long(self.job):
            self._warn(
                "training-takes-long",
                "so many iterations on images of this size take an hour or more on a processor: "
                "use --preset draft, --scale-down N, or a GPU; with --resume a run that is broken "
                "off goes on",
            )
        place = CheckpointPlace(self.folder.checkpoint, self.folder.staging, resume=self.job.resume)
        training = surface_stage.train_on(hull, self.job, views, self.progress, place)
        if training.passed_over:
            self._warn(
                "checkpoint-ignored",
                "the checkpoint in the output folder belongs to another sheet, other options or "
                "another version: the training began anew",
            )
        return training

    def _check(
        self,
        clean: CleanSheet,
        registered: RegisteredSheet,
        models: Models | None,
        solid: "ExactModel | None",
    ) -> None:
        """How the lines of the best model agree with the sheet's; overlay and preview."""
        from gaussiancad_core.check_stage import (
            check_solid,
            check_surface,
            overlay_picture,
            preview_picture,
        )

        if self.report.projection_alternatives:
            self._warn(
                "projection-assumed",
                "the lines fit first and third angle alike: third angle was taken; "
                "tell --projection first if the sheet is drawn in first angle",
            )
        checked = (
            check_solid(registered, solid)
            if solid
            else check_surface(registered, models, self.progress)
        )
        reports = {
            view.role: ViewReport(view.stored_box(clean.turn), checked.matched[view.role].agreement)
            for view in registered.drawn
        }
        self.report = replace(
            self.report,
            views=reports,
            tolerance_px=checked.tolerance_px,
            solid=checked.solid,
        )
        for code, message in checked.reasons:
            self.report = self.report.doubted(code, message)
        beside = self.marks, self.special
        overlay = overlay_picture(checked, registered, clean, beside, self.conflict)
        (self.folder.staging / "overlay.png").write_bytes(overlay)
        preview = self.folder.staging / "preview.png"
        preview.write_bytes(preview_picture(checked, self.job.reading.colour))
        self.progress.listener.send("preview", path=str(preview.resolve()))


def _vectors(image: SheetImage, clean: CleanSheet) -> VectorSheet | None:
    """The exact lines of a sheet's file, where it has them."""
    return VectorSheet(image.vectors, clean) if image.vectors is not None else None


def _check_device(device: Device) -> None:
    """Say at once, not after minutes, that a GPU that was asked for cannot be used."""
    if device is Device.CUDA:
        from gaussiancad_core.splatting.devices import backend_for

        backend_for(device)
