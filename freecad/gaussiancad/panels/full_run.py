"""Mesh and Gaussians of a drawing that was corrected: a job that completes its group."""

from pathlib import Path

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.summary import verdict_text
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.corrected_sheet import InDocument, hand_over
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.reconstruction import update_reconstruction
from freecad.gaussiancad.panels.jobs import Job
from freecad.gaussiancad.preferences import read_preferences


def full_job(store: InDocument, sheet: Path, page: int) -> Job:
    """The job; what was said until it starts counts.

    Args:
        store: knows the group that is completed.
        sheet: path of the drawing.
        page: of a file with pages.
    """
    made: list[ReconstructJob] = []

    def prepare(scratch: Path) -> list[str]:
        reading, corrections = hand_over(_known(store), scratch)
        stated = "" if corrections is None else str(corrections)
        job = ReconstructJob(
            str(sheet), str(scratch / "run"), page=page, reading=str(reading), corrections=stated
        )
        made.append(job)
        return job.arguments()

    def absorb(scratch: Path) -> str:
        views = scratch / "views"
        views.mkdir()
        run = load_run(made[-1], views, read_preferences().view_planes)
        update_reconstruction(_known(store), run)
        return verdict_text(run.report)

    title = translate("GaussianCAD", "Mesh and Gaussians of {0}").format(sheet.name)
    return Job(title, prepare, absorb)


def _known(store: InDocument) -> object:
    group = store.find()
    if group is None:
        text = translate("GaussianCAD", "The drawing is no longer in the document")
        raise WorkbenchError(ErrorCode.SHEET_MISSING, text)
    return group
