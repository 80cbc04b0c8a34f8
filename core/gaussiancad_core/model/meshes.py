"""Triangle meshes as plain arrays, and the few questions that every package asks of them.

The dataclass holds nothing but numbers, so that it can be compared, stored and passed between
processes; trimesh answers what needs more than arithmetic.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import trimesh


@dataclass(frozen=True, eq=False)
class TriangleMesh:
    """Triangles in model millimetres, counter-clockwise as seen from outside.

    Attributes:
        vertices: (n, 3) float64, mm.
        triangles: (m, 3) int64, indices of vertices.
    """

    vertices: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]

    @cached_property
    def corners(self) -> npt.NDArray[np.float64]:
        """(m, 3, 3) the corner points of each triangle."""
        return self.vertices[self.triangles]

    @cached_property
    def area_vectors(self) -> npt.NDArray[np.float64]:
        """(m, 3) outward vectors as long as the triangles' areas, mm^2."""
        a, b, c = (self.corners[:, k] for k in range(3))
        return np.cross(b - a, c - a) / 2.0

    @property
    def areas(self) -> npt.NDArray[np.float64]:
        """(m,) areas of the triangles, mm^2."""
        return np.linalg.norm(self.area_vectors, axis=1)

    @property
    def area(self) -> float:
        """Area of the whole surface, mm^2."""
        return float(self.areas.sum())

    @property
    def volume(self) -> float:
        """Signed volume in mm^3 (divergence theorem); positive when oriented outward."""
        if not len(self.triangles):
            return 0.0
        # Taken about the middle: far from the origin the terms would cancel badly.
        centroids = self.corners.mean(axis=1) - self.vertices.mean(axis=0)
        return float((centroids * self.area_vectors).sum() / 3.0)

    @property
    def bounds(self) -> npt.NDArray[np.float64]:
        """(2, 3) lowest and highest coordinates, mm."""
        return np.stack([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @property
    def watertight(self) -> bool:
        """Whether every edge has two triangles that run along it in opposite directions."""
        if not len(self.triangles):
            return False
        mesh = self.to_trimesh()
        return bool(mesh.is_watertight and mesh.is_winding_consistent)

    @cached_property
    def shared_edges(self) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """(k, 2) pairs of triangles and (k, 2) vertices of their edge, where just two meet."""
        edges = np.sort(self.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        keys = edges[:, 0] * len(self.vertices) + edges[:, 1]
        order = np.argsort(keys, kind="stable")
        alike = np.diff(keys[order]) == 0
        before, after = np.append(False, alike[:-1]), np.append(alike[1:], False)
        first = np.flatnonzero(alike & ~before & ~after)
        pairs = np.stack([order[first], order[first + 1]], axis=1)
        return pairs // 3, edges[pairs[:, 0]]

    def to_trimesh(self) -> "trimesh.Trimesh":
        """The same mesh for trimesh, vertices and triangles in the same order."""
        import trimesh

        return trimesh.Trimesh(self.vertices, self.triangles, process=False)

    def flipped(self) -> "TriangleMesh":
        """The same triangles, turned inside out."""
        return TriangleMesh(self.vertices, self.triangles[:, ::-1].copy())

    def oriented_outward(self) -> "TriangleMesh":
        """The same mesh, turned inside out if its volume is negative."""
        return self.flipped() if self.volume < 0.0 else self

    def compacted(self) -> "TriangleMesh":
        """The same triangles without the vertices that none of them uses."""
        used, inverse = np.unique(self.triangles, return_inverse=True)
        return TriangleMesh(self.vertices[used], inverse.reshape(self.triangles.shape))


def make_mesh(vertices: npt.ArrayLike, triangles: npt.ArrayLike) -> TriangleMesh:
    """A mesh of anything that converts to (n, 3) coordinates in mm and (m, 3) indices."""
    return TriangleMesh(
        np.ascontiguousarray(vertices, dtype=np.float64).reshape(-1, 3),
        np.ascontiguousarray(triangles, dtype=np.int64).reshape(-1, 3),
    )


def connected_pieces(mesh: TriangleMesh) -> list[TriangleMesh]:
    """The pieces of a mesh that share no vertex, the one of largest area first."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    if not len(mesh.triangles):
        return []
    count = len(mesh.vertices)
    first = mesh.triangles[:, [0, 1]].ravel()
    second = mesh.triangles[:, [1, 2]].ravel()
    graph = coo_matrix((np.ones(len(first), dtype=np.int8), (first, second)), (count, count))
    _, labels = connected_components(graph, directed=False)
    of_triangle = labels[mesh.triangles[:, 0]]
    pieces = [
        TriangleMesh(mesh.vertices, mesh.triangles[of_triangle == label]).compacted()
        for label in np.unique(of_triangle)
    ]
    return sorted(pieces, key=lambda piece: -piece.area)


def joined(pieces: list[TriangleMesh]) -> TriangleMesh:
    """One mesh of several, without welding them."""
    offsets = np.cumsum([0] + [len(piece.vertices) for piece in pieces[:-1]])
    return make_mesh(
        np.concatenate([piece.vertices for piece in pieces]),
        np.concatenate(
            [piece.triangles + offset for piece, offset in zip(pieces, offsets, strict=True)]
        ),
    )
