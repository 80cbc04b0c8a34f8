"""What else can be made of a sheet's views: the models that exact solids are compared with."""

from enum import Enum

from benchmarks.judge.exact_measures import fine_mesh
from benchmarks.methods.sweep_and_cut import swept_solid
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.model.cameras import orthographic_camera
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_protocol.modes import Preset, Recipe

_CAMERA_PX = 600


class Peer(Enum):
    """A model of the same views: the outlines' hull, the solid of swept outlines with the
    through features cut out, and the GaussianCAD paper's mesh."""

    HULL = "hull"
    SWEEP_AND_CUT = "sweep-and-cut"
    PAPER = "paper"


def peer_mesh(peer: Peer, outlines: ViewSet, masks: ViewSet) -> TriangleMesh | None:
    """A model in mm, or None if the views have no such model.

    Args:
        peer: which.
        outlines: views whose masks are their filled outlines.
        masks: the same with their through holes open.
    """
    if peer is Peer.PAPER:
        return _paper(outlines)
    return _swept(masks) if peer is Peer.SWEEP_AND_CUT else _hull(outlines)


def _swept(views: ViewSet) -> TriangleMesh | None:
    solid = swept_solid(views, max(view.mm_per_pixel for view in views.views))
    return fine_mesh(solid) if solid is not None else None


def _hull(views: ViewSet) -> TriangleMesh:
    cameras = tuple(orthographic_camera(role, views.size, _CAMERA_PX) for role in views.roles)
    return visual_hull(views, cameras)


def _paper(views: ViewSet) -> TriangleMesh:
    """Gaussians trained with the paper's cameras, as a surface."""
    from benchmarks.methods.trained import started_on, trained_from
    from gaussiancad_core.splatting.settings import training_cameras, training_settings
    from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface

    settings = training_settings(Recipe.PAPER, Preset.DRAFT)
    cameras = training_cameras(Recipe.PAPER, settings, views.roles, views.size)
    start = started_on(visual_hull(views, cameras), views, settings)
    trained = trained_from(start, views, cameras, settings)
    return gaussian_surface(trained.gaussians, PoissonSettings(), None)
