"""The stages of a run in order, each from dataclass to dataclass.

read -> views -> lines -> masks -> solid -> hull -> gaussians -> surface -> check -> write.
"""

from dataclasses import replace
from typing import TYPE_CHECKING

from gaussiancad_core.errors import (
    CancelledError,
    GaussianCadError,
    LimitError,
    NoModelError,
    is_out_of_memory,
    out_of_files,
)
from gaussiancad_core.messages import Message
from gaussiancad_core.processes.events import Listener, Progress, cancellation_behind
from gaussiancad_core.recognition.load_sheet import open_image, tell_image
from gaussiancad_core.recognition.page_choice import naming_pages, page_instead, tell_page
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.report_entries import ViewReport
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.storage.extras import Extra, demand, lacking
from gaussiancad_core.storage.outputs import REPORT_FILE, RUN_FILES, OutputFolder, os_error
from gaussiancad_core.storage.resume_check import finished_report
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Device, Recipe, ResultKind, SolidWay, Status

if TYPE_CHECKING:
    from gaussiancad_core.recognition.views_and_lines import SheetLines
    from gaussiancad_core.run.check_stage import CheckedModel
    from gaussiancad_core.run.exact_stage import ExactModel
    from gaussiancad_core.run.registering_stage import SheetFindings
    from gaussiancad_core.run.run_models import Models

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


def reconstruct(job: Job, listener: Listener, kept: OpenedSheet | None = None) -> Report:
    """Run a job and write its files.

    Args:
        job: what to do.
        listener: told how far it is.
        kept: the job's sheet, where it is open already.

    Returns:
        The report as written; its status is never ``failed``.

    Raises:
        GaussianCadError: the run failed; for :class:`NoModelError` and :class:`LimitError` the
            report is written all the same, and where the run met what nobody foresaw.
    """
    folder = OutputFolder(job.output, RUN_FILES, REPORT_FILE)
    run = _Run(job, folder, Progress(listener, len(stages_of(job.result, job.recipe))))
    try:
        return run.all_stages(kept)
    except (CancelledError, SystemError) as error:
        if (cancelled := cancellation_behind(error)) is None:
            raise
        raise CancelledError(
            cancelled.code, "{cause} {how_far}", cause=cancelled.message, how_far=run.how_far()
        ) from error
    except (NoModelError, LimitError) as error:
        run.write_failure(error)
        raise
    except GaussianCadError:
        raise
    except OSError as error:
        raise os_error(job.output, error) from error
    except Exception as error:
        failure = _failure(error, job)
        run.write_failure(failure)
        raise failure from error
    finally:
        folder.discard(keep_checkpoint=job.resume)


def _failure(error: Exception, job: Job) -> GaussianCadError:
    """What is told of an error that no stage foresaw."""
    if (no_files := out_of_files(error)) is not None:
        return no_files
    if is_out_of_memory(error):
        return LimitError(
            Code.OUT_OF_MEMORY, "the memory does not suffice: use --preset draft or a smaller sheet"
        )
    from gaussiancad_core.storage.crash_reports import unforeseen

    return unforeseen(error, [job.sheet])


class _Run:
    """A run in progress: the job, the staging folder and what is told of it."""

    def __init__(self, job: Job, folder: OutputFolder, progress: Progress) -> None:
        self.job = job
        self.folder = folder
        self.progress = progress
        self.notes = RunNotes(Report("", job.settings()), progress)
        self._turn: Turn | None = None
        self._image: SheetImage | None = None

    def all_stages(self, kept: OpenedSheet | None) -> Report:
        """Read, reconstruct, check and write."""
        _check_device(self.job.device)
        if self.job.result is not ResultKind.SOLID:
            demand(Extra.SURFACE, "a surface")
        try:
            read = self._read(kept)
        except NoModelError as error:
            read = self._read_instead(error)
        if isinstance(read, Report):
            return read
        if self.job.surface_left_out:
            self._tell_surface_left_out()
        # Loading these takes seconds, which no file that cannot be read is worth.
        from gaussiancad_core.run.check_stage import overlay_picture, preview_picture
        from gaussiancad_core.run.registering_stage import registered_lines, tell_symbol

        sheet, lines = read
        turn = sheet.turn
        self._write_reading(lines, sheet)
        found = registered_lines(self.job, lines, turn, self.notes)
        exact = None
        if "solid" in stages_of(self.job.result, self.job.recipe):
            with self.notes.stage("solid"):
                found, exact = self._find_solid(found, sheet)
        reading = exact.reading if exact else found.assumed
        tell_symbol(self.notes, found, reading.projection)
        asked = exact if self.job.result is not ResultKind.SURFACE else None
        solid = asked if asked is not None and asked.result.shape is not None else None
        if solid:
            self._publish(solid, self._status(solid))
        models = self._make_models(reading.registered, exact, solid, sheet)
        with self.notes.stage("check"):
            checked = self._check(reading.registered, models, solid, turn)
            conflict = asked.result.conflict if asked is not None else None
            adjacent = found.marks, found.special
            overlay = overlay_picture(checked, reading.registered, sheet.clean, adjacent, conflict)
            self._write_pictures(overlay, preview_picture(checked, self.job.reading.colour))
        with self.notes.stage("write"):
            if models:
                from gaussiancad_core.run.run_models import write_models

                write_models(models, self.job, self.folder.staging, self.progress)
        self._finish(self._status(solid))
        return self.notes.report

    def _tell_surface_left_out(self) -> None:
        self.notes.warn(
            Code.SURFACE_LEFT_OUT,
            Message(
                'no surface was made, as the extra "{extra}" is not installed: {command}; '
                "--result solid asks for none",
                extra=Extra.SURFACE,
                command=Extra.SURFACE.command,
            ),
        )

    def _read(self, kept: OpenedSheet | None) -> "tuple[OpenedSheet, SheetLines] | Report":
        """The sheet with its views and lines; the report where an earlier run of the job has it.

        Raises:
            NoModelError: the page has no views that belong together.
        """
        with self.notes.stage("read"):
            if kept is not None:
                tell_image(kept.image, self.notes)
            self._image = kept.image if kept is not None else open_image(self.job, self.notes)
            if self.job.resume and (earlier := self._earlier()):
                return earlier
            sheet = kept or OpenedSheet(self._image, self.job.reading.median_kernel)
            self._turn = sheet.turn
        from gaussiancad_core.recognition.views_and_lines import with_unseen
        from gaussiancad_core.run.read_run import sheet_lines

        return sheet, with_unseen(sheet_lines(self.job, sheet, self.notes), self.notes)

    def _read_instead(self, error: NoModelError) -> "tuple[OpenedSheet, SheetLines] | Report":
        """The same of the page that brings together what the first page shows apart.

        Raises:
            NoModelError: there is none, or it has no views either.
        """
        if self._image is None:
            raise error
        job = page_instead(self.job, self._image)
        if job is None:
            raise naming_pages(error, self._image) from error
        self.notes.report = Report("", self.job.settings())
        self.job, self._turn = job, None
        tell_page(self.notes, job.page, self._image)
        try:
            return self._read(None)
        except NoModelError as again:
            raise naming_pages(again, self._image) from again

    def write_failure(self, error: GaussianCadError) -> None:
        """Leave a report of how far the run came and why it ended there."""
        message = error.message
        if self._turn is not None:
            message = message.moved(self._turn.box_to_stored)
        self.notes.doubt(error.code, message)
        self.folder.clear()
        self._finish(Status.APPROXIMATE if self.notes.report.solid else Status.FAILED)

    def how_far(self) -> str:
        """Where the run was when it was stopped, for a message."""
        name = self.progress.current
        if not name:
            return "before its first stage: nothing was written"
        stages = stages_of(self.job.result, self.job.recipe)
        where = f"{name} ({stages.index(name) + 1} of {len(stages)})"
        written = f"only {self._ahead()} written" if self.folder.ahead else "nothing was written"
        if self.job.resume and self.folder.checkpoint.is_file():
            written += ", but for a checkpoint: --resume goes on from it"
        return f"in the stage {where}: {written}"

    def _ahead(self) -> str:
        return "the reading and the solid were" if self.notes.report.solid else "the reading was"

    def _finish(self, status: Status) -> None:
        seconds = dict(self.progress.seconds)
        self.notes.tell(status=status, seconds=seconds, files=self.folder.facts())
        self.notes.report.write(self.folder.staging / REPORT_FILE)
        self.folder.commit()

    def _earlier(self) -> Report | None:
        """The report of a finished run of the same job in the same folder."""
        report = self.notes.report
        path = self.folder.path / REPORT_FILE
        found = finished_report(path, report.settings, report.sheet_sha256)
        return replace(report, status=Status(found["status"])) if found else None

    def _status(self, solid: "ExactModel | None") -> Status:
        """How far the result can be trusted; whatever is in doubt, of the sheet or of the solid,
        is a reason."""
        if solid is None or self.notes.report.reasons:
            return Status.APPROXIMATE
        return solid.result.status

    def _write_reading(self, lines: "SheetLines", sheet: OpenedSheet) -> None:
        from gaussiancad_core.readings.views_to_reading import (
            READING_FILE,
            sheet_reading,
            write_reading,
        )

        reading = sheet_reading(self.notes.report, lines, sheet.turn, sheet.size)
        write_reading(reading, self.folder.staging)
        self.folder.publish()
        self._send("reading", READING_FILE)

    def _find_solid(
        self, found: "SheetFindings", sheet: OpenedSheet
    ) -> "tuple[SheetFindings, ExactModel | None]":
        """The exact solid, or what stands for it, and what it says about the projection."""
        from gaussiancad_core.run.exact_stage import OPEN_ENDED
        from gaussiancad_core.run.ink_stage import compared_with_ink
        from gaussiancad_core.run.registering_stage import tell_projection
        from gaussiancad_core.run.solid_judgement import judged_model
        from gaussiancad_core.run.solid_report import with_solid_facts

        surface_alone = self.job.result is ResultKind.SURFACE
        exact = self._exact(found)
        if exact and (exact.decided or (found.other and not surface_alone)):
            tell_projection(self.notes, exact.reading.projection, inferred=exact.decided)
        if exact is None or surface_alone:
            return found, exact
        found = replace(found, contradicted=exact.contradicted)
        checked = compared_with_ink(exact.result, exact.reading.registered, sheet)
        exact = judged_model(replace(exact, result=checked), sheet)
        for code, message in exact.result.reasons:
            self.notes.doubt(code, message)
        self.notes.report = with_solid_facts(self.notes.report, exact, sheet.turn)
        if self.job.result is ResultKind.SOLID and exact.result.shape is None:
            code, message = exact.result.reasons[0]
            raise (LimitError if code in OPEN_ENDED else NoModelError)(code, message)
        return found, exact

    def _exact(self, found: "SheetFindings") -> "ExactModel | None":
        """The exact solid, looked for in the ways that the job has; one in which the kernel does
        not do what is asked is left out, and told.

        Raises:
            Exception: what the kernel raised, where nothing else was asked for and no way is left.
        """
        from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
        from gaussiancad_core.run.exact_stage import find_exact, find_for_hull

        surface_alone, way = self.job.result is ResultKind.SURFACE, self.job.way
        if way is not SolidWay.ALL:
            self._tell_left_out()
        while way is not SolidWay.NONE:
            try:
                if surface_alone:
                    return find_for_hull(found.assumed, found.other)
                by_symbol = found.symbol is not None
                return find_exact(found.assumed, found.other, by_symbol=by_symbol, way=way)
            except KERNEL_FAILURES:
                way = SolidWay.NONE if surface_alone else way.less
                if way is SolidWay.NONE and self.job.result is ResultKind.SOLID:
                    raise
                self._tell_left_out()
        return None

    def _tell_left_out(self) -> None:
        self.notes.doubt(
            Code.SOLID_WAY_LEFT_OUT,
            "a library broke down in one of the ways in which the solid is looked for: that way "
            "was left out; this is a fault of ours, please report it with the sheet",
        )

    def _publish(self, solid: "ExactModel", status: Status) -> None:
        """Put the solids under their names, and say so: nothing that follows changes them."""
        from gaussiancad_core.report.construction_file import write_construction
        from gaussiancad_core.run.check_stage import solid_report
        from gaussiancad_core.run.model_construction import construction_values
        from gaussiancad_core.run.run_models import SOLID_FILE, write_solids

        self.notes.tell(solid=solid_report(solid))
        write_solids(solid.result, self.folder.staging)
        construction = construction_values(solid)
        if construction is not None:
            write_construction(construction, self.folder.staging)
        self.folder.publish()
        self._send("solid", SOLID_FILE, status=status.value)

    def _send(self, event: str, name: str, **more: str) -> None:
        """Send where a file lies that is final."""
        path = (self.folder.path / name).resolve()
        self.progress.listener.send(event, path=str(path), **more)

    def _make_models(
        self,
        registered: RegisteredSheet,
        exact: "ExactModel | None",
        solid: "ExactModel | None",
        sheet: OpenedSheet,
    ) -> "Models | None":
        """Hull, Gaussians and surface, if they are asked for."""
        if self.job.result is ResultKind.SOLID:
            return None
        # Torch and Open3D are loaded for a surface alone.
        from gaussiancad_core.run.surface_models import SurfaceRun

        run = SurfaceRun(self.job, self.folder, self.progress, self.notes, sheet.clean)
        return run.models(registered, exact, solid, sheet.turn)

    def _check(
        self,
        registered: RegisteredSheet,
        models: "Models | None",
        solid: "ExactModel | None",
        turn: Turn,
    ) -> "CheckedModel":
        """How the lines of the best model agree with the sheet's."""
        from gaussiancad_core.run.check_stage import check_solid, check_surface

        if self.notes.report.projection_alternatives:
            taken = self.notes.report.projection
            self.notes.warn(
                Code.PROJECTION_ASSUMED,
                Message(
                    "the lines fit first and third angle alike: {taken} angle was taken; pass "
                    "--projection {other} if the sheet is drawn in {other} angle",
                    taken=taken,
                    other=taken.other,
                ),
            )
        if solid:
            checked = check_solid(registered, solid)
        else:
            mesh = models.surface.mesh if models is not None else None
            # Without a solid there is a surface.
            assert mesh is not None
            checked = check_surface(registered, mesh, self.progress)
        reports = {
            view.role: ViewReport(
                view.stored_box(turn),
                checked.matched[view.role].agreement,
                "drawn" if view.has_hidden_lines else "none",
            )
            for view in registered.drawn
        }
        tolerance = round(checked.tolerance_px * turn.scale, 3)
        self.notes.tell(views=reports, tolerance_px=tolerance)
        for code, message in checked.reasons:
            self.notes.doubt(code, message)
        return checked

    def _write_pictures(self, overlay: bytes, preview: bytes) -> None:
        """Write the pictures, and say where the second is."""
        (self.folder.staging / "overlay.png").write_bytes(overlay)
        path = self.folder.staging / "preview.png"
        path.write_bytes(preview)
        self.progress.listener.send("preview", path=str(path.resolve()))


def _check_device(device: Device) -> None:
    """Say at once, not after minutes, that a GPU that was asked for cannot be used."""
    if device is Device.CUDA:
        if lacking(Extra.SURFACE):
            demand(Extra.CUDA, "a GPU")
        from gaussiancad_core.splatting.torch_devices import backend_for

        backend_for(device)
