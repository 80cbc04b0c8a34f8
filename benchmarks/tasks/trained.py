"""Gaussians as a run starts them on a hull, and trained, as a surface."""

from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.splatting.gaussian_training import TrainingResult, train
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.splatting.settings import TrainingSettings
from gaussiancad_core.splatting.targets import mean_colour, targets_of


def started_on(hull: TriangleMesh, views: ViewSet, settings: TrainingSettings) -> Gaussians:
    """Gaussians on a hull, in the mean colour of the views."""
    start = Start(
        settings.count,
        thickness=settings.thickness,
        opacity=settings.opacity,
        colour=mean_colour(views),
    )
    return gaussians_on(hull, start)


def trained_from(
    start: Gaussians, views: ViewSet, cameras: tuple[Camera, ...], settings: TrainingSettings
) -> TrainingResult:
    """The same after training on the views."""
    return train(start, cameras, targets_of(views, cameras), settings, lambda *_: None)
