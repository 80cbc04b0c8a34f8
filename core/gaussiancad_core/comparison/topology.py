"""How often a solid hangs together, is pierced, and is hollow: the Betti numbers of its inside.

A closed surface piece of genus g has V - E + F = 2 - 2 g.  Of a body in space whose boundary are
such pieces, b0 counts the bodies, b1 the tunnels (the sum of the genera) and b2 the cavities.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.mesh_edges import mesh_edges
from gaussiancad_core.model.meshes import TriangleMesh


@dataclass(frozen=True)
class Topology:
    """The shape of a model, whatever its measures.

    Attributes:
        pieces: surface pieces that share no edge.
        open_edges: edges that do not have exactly two triangles.
        bodies, tunnels, cavities: b0, b1 and b2; None where the surface is not closed.
        genus: of all pieces together; equals ``tunnels``.
        euler: V - E + F summed over the pieces; None where the surface is not closed.
    """

    pieces: int
    open_edges: int
    bodies: int | None = None
    tunnels: int | None = None
    cavities: int | None = None
    genus: int | None = None
    euler: int | None = None

    @property
    def betti(self) -> tuple[int, int, int] | None:
        """(b0, b1, b2), or None where the surface is not closed."""
        if self.bodies is None or self.tunnels is None or self.cavities is None:
            return None
        return (self.bodies, self.tunnels, self.cavities)


def topology_of(mesh: TriangleMesh) -> Topology:
    """The topology of a welded mesh."""
    triangles = mesh.triangles
    edges = mesh_edges(triangles)
    labels, pieces = _pieces(edges.of_triangle, len(edges.ends))
    open_edges = int((edges.uses != 2).sum())
    if open_edges or not mesh.watertight:
        return Topology(pieces, open_edges)
    # A vertex in which two pieces touch belongs to each of them.
    of_corner = np.stack([np.repeat(labels, 3), triangles.ravel()], axis=1)
    vertices = np.bincount(np.unique(of_corner, axis=0)[:, 0], minlength=pieces)
    faces = np.bincount(labels, minlength=pieces)
    euler = vertices - faces // 2
    volumes = np.bincount(labels, weights=_cone_volumes(mesh), minlength=pieces)
    tunnels = int((2 - euler).sum() // 2)
    return Topology(
        pieces,
        0,
        bodies=int((volumes > 0.0).sum()),
        tunnels=tunnels,
        cavities=int((volumes < 0.0).sum()),
        genus=tunnels,
        euler=int(euler.sum()),
    )


def _pieces(of_triangle: npt.NDArray[np.int64], edges: int) -> tuple[npt.NDArray[np.int64], int]:
    """The piece of each triangle, from the (m, 3) numbers of its edges; and how many there are."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    count = len(of_triangle)
    rows = np.repeat(np.arange(count), 3)
    columns = count + of_triangle.ravel()
    size = count + edges
    graph = coo_matrix((np.ones(len(rows), dtype=np.int8), (rows, columns)), (size, size))
    # Every edge has a triangle, so that the pieces of the graph are those of the surface.
    pieces, labels = connected_components(graph, directed=False)
    return labels[:count].astype(np.int64), int(pieces)


def _cone_volumes(mesh: TriangleMesh) -> npt.NDArray[np.float64]:
    """(m,) signed volumes between each triangle and the middle of the mesh."""
    centroids = mesh.corners.mean(axis=1) - mesh.vertices.mean(axis=0)
    return (centroids * mesh.area_vectors).sum(axis=1) / 3.0
