"""Meshes made closed and manifold: no border, and no edge or point where they touch themselves."""

from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

if TYPE_CHECKING:
    import manifold3d

_PULL = 0.1
"""How far a point that stands where another stands moves towards its neighbours' middle."""

UNSEEN = 1e-4
"""Share of the longest edge by which simplifying moves a surface: neither eye nor masks see it."""


def made_manifold(mesh: TriangleMesh) -> TriangleMesh | None:
    """The same surface as a 2-manifold, or nothing where that cannot be had.

    Poisson's iso-surface is closed, but at a few edges four triangles may meet.  manifold3d pairs
    them up and doubles the points; the doubles are then pulled apart, so that no program that
    welds points by position (every reader of STL does) joins them again.

    Args:
        mesh: oriented, closed but for holes; edges may have more than two triangles.
    """
    return _from_manifold(_to_manifold(_filled(mesh)))


def simplified(mesh: TriangleMesh, tolerance: float) -> TriangleMesh | None:
    """A closed body with fewer triangles, or nothing where it is none.

    Args:
        mesh: watertight, oriented outward, mm.
        tolerance: mm by which the surface may move.
    """
    return _from_manifold(_to_manifold(mesh).simplify(tolerance))


def _to_manifold(mesh: TriangleMesh) -> "manifold3d.Manifold":
    import manifold3d

    # It takes nothing that is read-only or has columns one after the other: hence copies.
    vertices = np.array(mesh.vertices, dtype=np.float64, order="C")
    triangles = np.array(mesh.triangles, dtype=np.uint64, order="C")
    return manifold3d.Manifold(manifold3d.Mesh64(vertices, triangles))


def _from_manifold(solid: "manifold3d.Manifold") -> TriangleMesh | None:
    import manifold3d

    if solid.status() is not manifold3d.Error.NoError or solid.is_empty():
        return None
    found = solid.to_mesh64()
    mesh = _separated(
        make_mesh(np.asarray(found.vert_properties)[:, :3], np.asarray(found.tri_verts))
    )
    return mesh if mesh.watertight and not _doubles(mesh).any() else None


def _filled(mesh: TriangleMesh) -> TriangleMesh:
    """The mesh with a fan of triangles, about its middle, in each hole."""
    ahead = np.concatenate([mesh.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    count = len(mesh.vertices)
    lonely = ~np.isin(ahead[:, 0] * count + ahead[:, 1], ahead[:, 1] * count + ahead[:, 0])
    if not lonely.any():
        return mesh
    border = ahead[lonely]
    graph = coo_matrix((np.ones(len(border)), (border[:, 0], border[:, 1])), (count, count))
    _, labels = connected_components(graph, directed=False)
    holes, number = np.unique(labels[border[:, 0]], return_inverse=True)
    sums = np.zeros((len(holes), 3))
    np.add.at(sums, number, mesh.vertices[border[:, 0]])
    middles = sums / np.bincount(number)[:, None]
    fans = np.column_stack([border[:, 1], border[:, 0], count + number])
    return make_mesh(
        np.concatenate([mesh.vertices, middles]), np.concatenate([mesh.triangles, fans])
    )


def _doubles(mesh: TriangleMesh) -> np.ndarray:
    """(n,) whether another vertex stands at the same place, in the single precision of STL."""
    places = mesh.vertices.astype(np.float32)
    _, inverse, counts = np.unique(places, axis=0, return_inverse=True, return_counts=True)
    return counts[inverse.ravel()] > 1


def _separated(mesh: TriangleMesh) -> TriangleMesh:
    doubles = _doubles(mesh)
    if not doubles.any():
        return mesh
    sums = np.zeros_like(mesh.vertices)
    counts = np.zeros(len(mesh.vertices))
    for number, other in ((0, 1), (1, 2), (2, 0)):
        np.add.at(sums, mesh.triangles[:, number], mesh.vertices[mesh.triangles[:, other]])
        np.add.at(counts, mesh.triangles[:, number], 1.0)
    moved = mesh.vertices.copy()
    middle = sums[doubles] / counts[doubles, None]
    moved[doubles] += _PULL * (middle - moved[doubles])
    return TriangleMesh(moved, mesh.triangles)
