"""Poisson surface of oriented points (Kazhdan and Hoppe 2013, in open3d)."""

from dataclasses import dataclass, field

import numpy as np

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces, joined, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.surface.discs import DiscSampling, creases_of, discs_of
from gaussiancad_core.surface.flatten import Flattening, flattened
from gaussiancad_core.surface.oriented_points import OrientedPoints, disc_points
from gaussiancad_core.surface.repair import UNSEEN, made_manifold, simplified
from gaussiancad_core.surface.sharpen import Sharpening, sharpened
from gaussiancad_protocol.codes import Code

_SCALE = 1.1
"""Edge of the octree, in longest edges of the points' box."""


@dataclass(frozen=True)
class PoissonSettings:
    """How the surface is found.

    Attributes:
        depth: of the octree: 2^depth cells along the longest edge and a tenth.
        point_weight: how strongly the surface is held at the points (screening).
        smallest_piece: pieces below this share of the area are left out.
        sampling: of the points.
        flattening: of plane faces; None leaves them as uneven as Poisson makes them.
        sharpening: of the edges; None leaves them as Poisson rounds them.
    """

    depth: int = 8
    point_weight: float = 4.0
    smallest_piece: float = 0.01
    sampling: DiscSampling = field(default_factory=DiscSampling)
    flattening: Flattening | None = field(default_factory=Flattening)
    sharpening: Sharpening | None = field(default_factory=Sharpening)


DENSE = PoissonSettings(sampling=DiscSampling(per_disc=12))
"""A fifth nearer to the discs' surface, in twice the time."""


def gaussian_surface(gaussians: Gaussians, settings: PoissonSettings) -> TriangleMesh:
    """The closed surface on which trained Gaussians lie.

    Args:
        gaussians: mm.
        settings: how fine.

    Returns:
        A watertight mesh in mm, oriented outward; the same input gives the same mesh.

    Raises:
        NoModelError: ``no-surface``, the Gaussians do not enclose a body.
    """
    discs = discs_of(gaussians, settings.sampling)
    creases = creases_of(discs, settings.sampling)
    points = disc_points(discs, creases, settings.sampling)
    surface = poisson_surface(points, settings)
    cell = _SCALE * float(np.ptp(points.points, axis=0).max()) / 2**settings.depth
    if settings.flattening is not None:
        surface = flattened(surface, discs, cell, settings.sampling, settings.flattening)
    if settings.sharpening is not None:
        reach = settings.sampling.edge_reach * float(discs.sigmas.mean())
        surface = sharpened(surface, creases, cell, reach, settings.sharpening)
    longest = float(np.ptp(surface.bounds, axis=0).max())
    return simplified(surface, UNSEEN * longest) or surface


def poisson_surface(points: OrientedPoints, settings: PoissonSettings) -> TriangleMesh:
    """The closed surface through oriented points; see :func:`gaussian_surface`."""
    from gaussiancad_core.kernel.bare_open3d import open3d

    if len(points.points) < 4:
        raise _no_surface()
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points.points))
    cloud.normals = open3d.utility.Vector3dVector(points.normals)
    # More threads add in another order each time: one gives the same mesh every time.
    found, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
        cloud,
        depth=settings.depth,
        scale=_SCALE,
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
        Code.NO_SURFACE,
        "the Gaussians do not enclose a body: use a finer preset, or check that the views "
        "belong together",
    )
