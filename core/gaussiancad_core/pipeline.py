"""The stages of a run in order, each from dataclass to dataclass.

read -> views -> lines -> masks -> hull -> gaussians -> surface -> check -> write.
"""

import json
from dataclasses import replace

from gaussiancad_core.axes import mutually_orthogonal
from gaussiancad_core.errors import (
    CancelledError,
    EngineError,
    GaussianCadError,
    LimitError,
    NoModelError,
)
from gaussiancad_core.events import Listener, Progress
from gaussiancad_core.job import Job
from gaussiancad_core.meshes import TriangleMesh
from gaussiancad_core.models import Models, write_models
from gaussiancad_core.modes import Device, Recipe, ResultKind, Status
from gaussiancad_core.outputs import RUN_FILES, OutputFolder, os_error
from gaussiancad_core.report import GaussiansReport, Report, SurfaceReport, ViewReport
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet, upright_sheet
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.options import Box, ReadingOptions
from gaussiancad_core.sheet.read import SheetImage, read_sheet
from gaussiancad_core.sheet.reading import (
    ReadView,
    RegisteredSheet,
    find_views,
    read_views,
    register_views,
)
from gaussiancad_core.sheet.scale.find import ScaleSource, find_scale
from gaussiancad_core.verification.agreement import MatchedLines

STAGES = ("read", "views", "lines", "masks", "hull", "gaussians", "surface", "check", "write")

REPORT_FILE = "report.json"

TOLERANCE_PX = 3.0
"""px of the sheet within which a line of the result is the sheet's line.

A surface rounds its edges by about a hundredth of its size, so lines are matched to about the
width of a stroke.
"""

_EXPLAINED = 0.95
"""Share of the lines that has to agree for a view to be called explained."""


def reconstruct(job: Job, listener: Listener) -> Report:
    """Run a job and write its files.

    Returns:
        The report as written; its status is never ``failed``.

    Raises:
        GaussianCadError: the run failed; for :class:`NoModelError` and :class:`LimitError` the
            report is written all the same.
    """
    folder = OutputFolder(job.output, RUN_FILES, REPORT_FILE)
    run = _Run(job, folder, Progress(listener, len(STAGES)))
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
        folder.discard()


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
            for note in image.notes:
                self._warn(note.code, note.message)
            clean = upright_sheet(clean_sheet(image.grey, self.job.reading.median_kernel))
        registered = self._read_sheet(image, clean)
        if self.job.result is ResultKind.SOLID:
            raise NoModelError(
                "exact-solid-unavailable",
                "this version makes no exact solid yet: ask for --result surface or both",
            )
        models = self._make_models(clean, registered)
        with self._stage("write"):
            write_models(models, self.job.recipe, self.folder.staging, self.progress)
        self._finish(Status.APPROXIMATE)
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
        where = f"{name} ({STAGES.index(name) + 1} of {len(STAGES)})"
        return f"in the stage {where}: nothing was written"

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

    def _read_sheet(self, image: SheetImage, clean: CleanSheet) -> RegisteredSheet:
        """Views, lines and masks of a sheet, on shared axes."""
        reading = self.job.reading
        with self._stage("views"):
            given = {role: clean.turn.box_to_upright(box) for role, box in reading.views}
            separated, layout = find_views(clean, given, reading.projection)
            self._tell_marks(separated.marks, clean.turn)
            self._tell_layout(layout, clean.turn)
        with self._stage("lines"):
            drawn = read_views(separated.part, layout, self.progress, reading.finder)
            options = self._scaled(image, clean, drawn)
        with self._stage("masks"):
            if self.job.recipe is Recipe.PAPER:
                options = replace(options, open_holes=False)
            if layout.alternatives and not reading.views:
                registered = self._choose_projection(drawn, layout, options)
            else:
                registered = register_views(drawn, options)
            self._tell_views(registered, clean.turn)
            self._tell_registration(registered)
        return registered

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
    ) -> RegisteredSheet:
        from gaussiancad_core.projection_choice import choose_projection

        choice = choose_projection(drawn, layout.projection, options)
        other = choice.projection.other
        self.report = replace(
            self.report,
            projection=choice.projection,
            projection_source="inferred" if choice.inferred else "default",
            projection_alternatives=() if choice.inferred else (other,),
        )
        if not choice.inferred:
            self._warn(
                "projection-assumed",
                "the lines fit first and third angle alike: third angle was taken; "
                "tell --projection first if the sheet is drawn in first angle",
            )
        return choice.registered

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
            tolerance_px=TOLERANCE_PX,
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

    def _make_models(self, clean: CleanSheet, registered: RegisteredSheet) -> Models:
        """Hull, Gaussians and surface, and how the surface agrees with the sheet."""
        from gaussiancad_core.hull import visual_hull
        from gaussiancad_core.splatting.gaussians import Start, gaussians_on
        from gaussiancad_core.splatting.settings import training_cameras, training_settings
        from gaussiancad_core.splatting.targets import mean_colour, targets_of
        from gaussiancad_core.splatting.training import train
        from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface

        views = registered.views
        settings = training_settings(self.job.recipe, self.job.preset)
        cameras = training_cameras(self.job.recipe, settings, views.roles, views.size)
        with self._stage("hull"):
            hull = visual_hull(views, cameras)
        with self._stage("gaussians"):
            start = gaussians_on(
                hull,
                Start(
                    count=settings.count,
                    thickness=settings.thickness,
                    opacity=settings.opacity,
                    colour=mean_colour(views),
                    seed=self.job.seed,
                ),
            )
            training = train(start, cameras, targets_of(views, cameras), settings, self.progress)
            self.report = replace(
                self.report,
                gaussians=GaussiansReport(
                    len(training.gaussians), training.iterations, float(training.losses[-1])
                ),
            )
        with self._stage("surface"):
            # Only parallel projections leave no material outside of the hull.
            within = hull if self.job.recipe is Recipe.ORTHOGRAPHIC else None
            surface = gaussian_surface(training.gaussians, PoissonSettings(), within)
            self.report = replace(
                self.report,
                surface=SurfaceReport(
                    len(surface.vertices),
                    len(surface.triangles),
                    surface.watertight,
                    float(surface.volume),
                ),
            )
        with self._stage("check"):
            matched = self._check(clean, registered, surface)
        return Models(registered, training, surface, matched)

    def _check(
        self, clean: CleanSheet, registered: RegisteredSheet, surface: TriangleMesh
    ) -> tuple[MatchedLines, ...]:
        """Draw the surface again and match its lines with the sheet's; overlay and preview."""
        from gaussiancad_core.verification.agreement import match_lines
        from gaussiancad_core.verification.overlay import ViewOverlay, draw_overlay
        from gaussiancad_core.verification.preview import png_bytes, render_preview
        from gaussiancad_core.verification.redraw import redraw_mesh

        views = registered.views
        pitch = registered.mm_per_pixel
        matched = []
        for index, view in enumerate(views.views):
            lines = redraw_mesh(surface, view.role, pitch)
            matched.append(match_lines(view.strokes, lines, TOLERANCE_PX * pitch))
            self.progress((index + 1) / (len(views.views) + 1))
        reports = {
            view.role: ViewReport(view.stored_box(clean.turn), match.agreement)
            for view, match in zip(registered.drawn, matched, strict=True)
        }
        self.report = replace(self.report, views=reports).doubted(
            "no-exact-solid",
            "the model is a surface around the space that the outlines leave, "
            "not an exact solid: measure nothing from it that the sheet dimensions",
        )
        unexplained = [
            role.value for role, view in reports.items() if view.agreement.worst < _EXPLAINED
        ]
        if unexplained:
            self.report = self.report.doubted(
                "lines-unexplained",
                f"the surface does not show all lines of the {', '.join(unexplained)} view(s), or "
                "shows others: see overlay.png",
            )
        overlays = [
            ViewOverlay(view, views.size, match)
            for view, match in zip(views.views, matched, strict=True)
        ]
        staging = self.folder.staging
        (staging / "overlay.png").write_bytes(
            png_bytes(draw_overlay(clean.picture, overlays, self.marks))
        )
        colour = self.job.reading.colour
        (staging / "preview.png").write_bytes(png_bytes(render_preview(surface, colour)))
        self.progress.listener.send("preview", path=str((staging / "preview.png").resolve()))
        return tuple(matched)


def _check_device(device: Device) -> None:
    if device is Device.CUDA:
        raise EngineError(
            "cuda-unavailable",
            "this version trains on the CPU only: use --device auto or cpu",
        )
