"""Vertices of a mesh moved to better places; its triangles stay."""

import numpy as np

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.surface.discs import Array

_HALVED = 0.5
_HALVINGS = 3
"""How often a vertex may try to go half as far before it stays where it was."""


def vertex_normals(mesh: TriangleMesh) -> Array:
    """(n, 3) unit vectors, the means of the triangles around by area."""
    normals = np.zeros_like(mesh.vertices)
    for corner in mesh.triangles.T:
        np.add.at(normals, corner, mesh.area_vectors)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return normals / np.where(lengths > 0.0, lengths, 1.0)


def without_folds(mesh: TriangleMesh, moved: Array) -> TriangleMesh:
    """The mesh with moved vertices, but those of triangles that would turn over go less far.

    Args:
        mesh: as it was, mm.
        moved: (n, 3) where its vertices would go, mm.

    Returns:
        The same triangles; none is turned over by more than a right angle.
    """
    moved, rounds = moved.copy(), 0
    # In the end each round takes more vertices back, and none folds among old ones: it ends.
    while True:
        found = TriangleMesh(moved.copy(), mesh.triangles)
        folded = (found.area_vectors * mesh.area_vectors).sum(axis=1) < 0.0
        if not folded.any():
            return found
        back = np.unique(mesh.triangles[folded])
        kept = _HALVED if rounds < _HALVINGS else 0.0
        moved[back] = mesh.vertices[back] + kept * (moved[back] - mesh.vertices[back])
        rounds += 1
