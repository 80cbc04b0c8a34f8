"""The hull, the Gaussians that start on it, and their surface, as a job asks for them."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from gaussiancad_core.hull.space_carving import CarvedHull, carved_hull
from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.report_entries import GaussiansReport, HullReport, SurfaceReport
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.splatting.checkpoints import CheckpointPlace
from gaussiancad_core.splatting.gaussian_training import TrainingResult, train
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.residual_report import residual_entries
from gaussiancad_core.splatting.residuals import residuals_of
from gaussiancad_core.splatting.settings import (
    TrainingSettings,
    training_cameras,
    training_settings,
)
from gaussiancad_core.splatting.targets import mean_colour, targets_of
from gaussiancad_core.splatting.torch_devices import backend_for
from gaussiancad_core.surface.nearness import WeighedSurface
from gaussiancad_core.surface.poisson import DENSE, PoissonSettings, gaussian_surface
from gaussiancad_protocol.modes import Preset

_MUCH_WORK = 1e9
"""Pixels times iterations from which on a processor takes many minutes."""


def make_hull(job: Job, views: ViewSet, exact: ExactModel | None) -> CarvedHull:
    """The hull of the views, carved by the depths of an exact solid if there is one.

    Raises:
        NoModelError: ``empty-hull``.
    """
    known = exact.result if exact is not None else None
    return carved_hull(views, _cameras(job, views), known)


def train_on(
    hull: TriangleMesh,
    job: Job,
    views: ViewSet,
    progress: Callable[..., None],
    place: CheckpointPlace | None = None,
) -> TrainingResult:
    """Gaussians that start on a hull, trained against the views."""
    settings = replace(_settings(job), backend=backend_for(job.device), seed=job.seed)
    start = Start(
        count=settings.count,
        thickness=settings.thickness,
        opacity=settings.opacity,
        colour=mean_colour(views),
        seed=job.seed,
    )
    cameras = _cameras(job, views)
    targets = targets_of(views, cameras)
    return train(gaussians_on(hull, start), cameras, targets, settings, progress, place=place)


def residuals(
    training: TrainingResult, job: Job, registered: RegisteredSheet, turn: Turn
) -> dict[str, Any]:
    """Where trained Gaussians and the drawing disagree, as the report has it."""
    views = registered.views
    cameras = _cameras(job, views)
    settings = replace(_settings(job), backend=backend_for(job.device))
    found = residuals_of(training.gaussians, cameras, targets_of(views, cameras), settings)
    return residual_entries(found, cameras, registered, turn)


def takes_long(job: Job) -> bool:
    """Whether a job trains on a processor what was meant for a GPU."""
    settings = _settings(job)
    work = settings.iterations * settings.pixels**2
    return work > _MUCH_WORK and training_device(job) == "cpu"


def make_surface(training: TrainingResult, job: Job) -> TriangleMesh:
    """The Poisson mesh of trained Gaussians.

    Raises:
        NoModelError: ``no-surface``.
    """
    settings = DENSE if job.preset is Preset.FINE else PoissonSettings()
    return gaussian_surface(training.gaussians, settings)


def training_device(job: Job) -> str:
    """Where a job trains: ``cpu`` or ``cuda``."""
    return backend_for(job.device).device


def hull_report(hull: CarvedHull) -> HullReport:
    """What the report says of a hull."""
    source = hull.source.value if hull.source else None
    return HullReport(source, hull.regions, hull.doubted, hull.refused)


def gaussians_report(training: TrainingResult, job: Job, views: ViewSet) -> GaussiansReport:
    """What the report says of trained Gaussians."""
    camera = _cameras(job, views)[0]
    return GaussiansReport(
        count=len(training.gaussians),
        iterations=training.iterations,
        loss=float(training.losses[-1]),
        settled=training.settled,
        image_px=(camera.width, camera.height),
        resumed=training.resumed,
    )


def surface_report(surface: WeighedSurface) -> SurfaceReport | None:
    """What the report says of a surface; None where there is none."""
    mesh = surface.mesh
    if mesh is None:
        return None
    return SurfaceReport(
        len(mesh.vertices),
        len(mesh.triangles),
        mesh.watertight,
        float(mesh.volume),
        nearer=surface.nearer.value,
        outline_difference={
            which.value: round(share, 6) for which, share in surface.differences.items()
        },
    )


def _cameras(job: Job, views: ViewSet) -> tuple[Camera, ...]:
    return training_cameras(job.recipe, _settings(job), views.roles, views.size)


def _settings(job: Job) -> TrainingSettings:
    return training_settings(job.recipe, job.preset, job.scale_down)
