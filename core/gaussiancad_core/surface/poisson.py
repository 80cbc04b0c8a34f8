"""Poisson surface of oriented points (Kazhdan and Hoppe 2013, in open3d)."""

from dataclasses import dataclass, field

import numpy as np

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.meshes import TriangleMesh, connected_pieces, joined, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.surface.points import DiscSampling, OrientedPoints, disc_points
from gaussiancad_core.surface.repair import intersection, made_manifold

_CUT_TOLERANCE = 2e-4
"""By how much the cut surface may be simplified, as a share of the longest edge."""


@dataclass(frozen=True)
class PoissonSettings:
    """How the surface is found.

    Attributes:
        depth: of the octree: 2^depth cells along the longest edge and a tenth.
        point_weight: how strongly the surface is held at the points (screening).
        smallest_piece: pieces below this share of the area are left out.
        sampling: of the points.
    """

    depth: int = 8
    point_weight: float = 4.0
    smallest_piece: float = 0.01
    sampling: DiscSampling = field(default_factory=DiscSampling)


DENSE = PoissonSettings(sampling=DiscSampling(per_disc=12))
"""A fifth nearer to the discs' surface, in twice the time (``benchmarks/poisson_settings.py``)."""


def gaussian_surface(
    gaussians: Gaussians, settings: PoissonSettings, within: TriangleMesh | None = None
) -> TriangleMesh:
    """The closed surface on which trained Gaussians lie.

    Args:
        gaussians: mm.
        settings: how fine.
        within: a watertight mesh; what Poisson puts outside of it is cut off.  Outside the hull of
            parallel projections there is no material, so that the hull is a good choice.

    Returns:
        A watertight mesh in mm, oriented outward; the same input gives the same mesh.

    Raises:
        NoModelError: ``no-surface``, the Gaussians bound no body.
    """
    surface = poisson_surface(disc_points(gaussians, settings.sampling), settings)
    if within is None:
        return surface
    longest = float(np.ptp(within.bounds, axis=0).max())
    common = intersection(surface, within, _CUT_TOLERANCE * longest)
    if common is None:
        raise _no_surface()
    return common


def poisson_surface(points: OrientedPoints, settings: PoissonSettings) -> TriangleMesh:
    """The closed surface through oriented points; see :func:`gaussian_surface`."""
    import open3d

    if len(points.points) < 4:
        raise _no_surface()
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points.points))
    cloud.normals = open3d.utility.Vector3dVector(points.normals)
    # More threads add in another order each time: one gives the same mesh every time.
    found, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
        cloud,
        depth=settings.depth,
        scale=1.1,
        linear_fit=False,
        n_threads=1,
        point_weight=settings.point_weight,
    )
    whole = make_mesh(np.asarray(found.vertices), np.asarray(found.triangles))
    pieces = _large_pieces(whole, settings)
    solids = [solid for piece in pieces if (solid := made_manifold(piece)) is not None]
    # The repair parts crumbs from where they touch the body.
    bodies = _large_pieces(joined(solids), settings) if solids else []
    if not bodies:
        raise _no_surface()
    return joined(bodies)


def _large_pieces(mesh: TriangleMesh, settings: PoissonSettings) -> list[TriangleMesh]:
    """The pieces that bound material and are no crumbs, the largest first."""
    pieces = connected_pieces(mesh)
    limit = settings.smallest_piece * pieces[0].area if pieces else 0.0
    return [piece for piece in pieces if piece.area >= limit and piece.volume > 0.0]


def _no_surface() -> NoModelError:
    return NoModelError(
        "no-surface",
        "the Gaussians bound no body: use a finer preset, or check that the views belong together",
    )
