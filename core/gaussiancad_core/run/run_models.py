"""What a run made, and its files: exact solids, mesh, faceted solid, Gaussians, cameras."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from gaussiancad_core.model.cameras import Camera, orthographic_camera, paper_camera
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.report.job import Job
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_protocol.modes import Recipe

if TYPE_CHECKING:
    from gaussiancad_core.solid.exact import ExactResult
    from gaussiancad_core.splatting.gaussian_training import TrainingResult
    from gaussiancad_core.surface.nearness import WeighedSurface

_IMAGE_PX = 1024
"""Side of the orthographic images in the cameras folder."""


@dataclass(frozen=True, eq=False)
class Models:
    """What a run made of a sheet.

    Attributes:
        registered: the views.
        training: the Gaussians.
        surface: their Poisson mesh, and the hull on which they started.
    """

    registered: RegisteredSheet
    training: "TrainingResult"
    surface: "WeighedSurface"


SOLID_FILE = "solid.step"
"""The exact solid in the output folder."""


def alternative_file(number: int) -> str:
    """The file of an alternative in the output folder, counted from 1."""
    return f"alternatives/{number}.step"


def write_solids(result: "ExactResult", folder: Path) -> None:
    """Write the exact solid as :data:`SOLID_FILE`, and others that fit under ``alternatives``.

    Each begins at the origin: where it lies in the views is known to a fraction of a pixel only,
    and what a drawing's numbers fix exactly is distances.

    Raises:
        EngineError: the STEP writer refuses.
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    from gaussiancad_core.kernel.brep import moved_to_origin
    from gaussiancad_core.kernel.brep_files import write_step

    write_step(moved_to_origin(result.shape), folder / SOLID_FILE)
    if result.alternatives:
        (folder / "alternatives").mkdir(exist_ok=True)
    for number, shape in enumerate(result.alternatives, start=1):
        write_step(moved_to_origin(shape), folder / alternative_file(number))


def write_models(models: Models, job: Job, folder: Path, progress: Callable[[float], None]) -> None:
    """Write surface, Gaussians and cameras under their names into a folder.

    The hull goes with them where it is nearer to the drawing than the surface is.

    Args:
        models: of one run.
        job: whose cameras they are, and for whom.
        folder: where the files go; it exists.
        progress: told the fraction done.

    Raises:
        EngineError: the surface cannot be made a faceted solid.
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    from gaussiancad_core.splatting.ply import write_gaussians
    from gaussiancad_core.surface.mesh_files import write_faceted_step, write_ply, write_stl
    from gaussiancad_core.surface.nearness import Nearer

    surface = models.surface
    if surface.nearer is Nearer.HULL:
        write_stl(surface.hull, folder / "hull.stl")
    if surface.mesh is not None:
        write_stl(surface.mesh, folder / "surface.stl")
        write_ply(surface.mesh, folder / "surface.ply")
        progress(0.2)
        write_faceted_step(surface.mesh, folder / "surface.step")
    progress(0.7)
    write_gaussians(models.training.gaussians, folder / "gaussians.ply")
    _write_cameras(folder / "cameras", models, job)


def _write_cameras(folder: Path, models: Models, job: Job) -> None:
    from gaussiancad_core.hull.colmap import as_pinhole, write_cameras
    from gaussiancad_core.hull.nerfstudio import write_transforms
    from gaussiancad_core.splatting.targets import targets_of

    views = models.registered.views
    cameras = _image_cameras(views, job.recipe)
    targets = targets_of(views, cameras)
    gaussians = models.training.gaussians
    colours = np.clip(np.rint(gaussians.colours * 255), 0, 255).astype(np.uint8)
    points = (gaussians.means.astype(np.float64), colours)
    pinholes = tuple(as_pinhole(camera, views.size) for camera in cameras)
    write_cameras(folder, pinholes, targets.colours.numpy(), targets.masks.numpy(), points)
    if job.transforms:
        write_transforms(folder, pinholes, points)


def _image_cameras(views: ViewSet, recipe: Recipe) -> tuple[Camera, ...]:
    """The recipe's cameras at the size of the images for other trainers."""
    if recipe is Recipe.PAPER:
        return tuple(paper_camera(role, views.size) for role in views.roles)
    return tuple(orthographic_camera(role, views.size, _IMAGE_PX) for role in views.roles)
