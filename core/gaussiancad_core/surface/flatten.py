"""Plane faces that Poisson reconstruction left uneven, laid onto the planes of their discs.

Where discs leave a gap, most of all beside edges, the surface bulges by more than a cell of the
octree.  The discs around the gap still know the plane: vertices that face as they do are moved onto
it.  As in :mod:`.sharpen` no triangle is made or removed.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.surface.discs import NEIGHBOURS, Discs, DiscSampling, bends_of
from gaussiancad_core.surface.moving import vertex_normals, without_folds

_ALIKE = 0.9995
"""Cosine from which on discs may belong to one plane face."""

_LEVEL = 0.25
"""Cells by which their planes may differ where the vertex is."""

_STEEP = 4.0
"""How much more the distance from a disc's plane counts than that along it, when it is told which
disc a vertex belongs to: steps between parallel faces stay where they are."""


@dataclass(frozen=True)
class Flattening:
    """Which vertices are moved, and how far.

    Attributes:
        farthest: largest distance from the plane, in cells of the octree.
        facing: cosine of a vertex's normal and the plane's from which on it may belong to it.
        bend: degrees; discs among which the surface bends by more are no plane.
    """

    farthest: float = 3.0
    facing: float = 0.6
    bend: float = 3.0


def flattened(
    mesh: TriangleMesh, discs: Discs, cell: float, sampling: DiscSampling, settings: Flattening
) -> TriangleMesh:
    """A mesh with its vertices near plane faces moved onto them.

    Args:
        mesh: of a Poisson reconstruction, oriented outward, mm.
        discs: that it was made of, mm.
        cell: edge of the octree's cells, mm.
        sampling: of the discs.
        settings: which and how far.

    Returns:
        The same triangles; none is turned over by more than a right angle.
    """
    if len(discs) <= sampling.neighbours:
        return mesh
    distances, near = cKDTree(discs.centres).query(mesh.vertices, k=NEIGHBOURS)
    normals = discs.normals[near]
    above = ((mesh.vertices[:, None] - discs.centres[near]) * normals).sum(axis=2)
    fits = np.einsum("nj,nkj->nk", vertex_normals(mesh), normals) > settings.facing
    # The nearest that fits leads, plane or not: a vertex of a bent face stays where it is.
    cost = np.where(fits, distances + _STEEP * np.abs(above), np.inf)
    rows, leader = np.arange(len(near)), np.argmin(cost, axis=1)
    flat = fits & (bends_of(discs, sampling) < settings.bend)[near]
    moved = flat[rows, leader] & (np.abs(above[rows, leader]) < settings.farthest * cell)
    alike = np.einsum("nkj,nj->nk", normals, normals[rows, leader]) > _ALIKE
    alike &= np.abs(above - above[rows, leader][:, None]) < _LEVEL * cell
    # The more discs of the plane, the less it matters where one of them lies.
    weights = np.where(flat & alike, 1.0 / np.maximum(distances, cell) ** 2, 0.0)
    weights /= np.maximum(weights.sum(axis=1), np.finfo(float).tiny)[:, None]
    moves = np.einsum("nk,nk,nkj->nj", weights, above, normals)
    return without_folds(mesh, mesh.vertices - np.where(moved[:, None], moves, 0.0))
