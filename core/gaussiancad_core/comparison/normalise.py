"""Similarities as 4 x 4 matrices, and the one that puts a model into the protocol's box."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

Matrix = npt.NDArray[np.float64]

BOX = 5.0
"""Longest edge of every model's bounding box while it is compared, in units (GaussianCAD paper)."""


def normalising_matrix(mesh: TriangleMesh, edge: float = BOX) -> Matrix:
    """(4, 4) file coordinates -> units: bounding box centred at the origin, longest edge ``edge``.

    The mesh must have an extent; :func:`.model_files.load_model` sees to it.
    """
    low, high = mesh.bounds
    scale = edge / float((high - low).max())
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = -scale * (low + high) / 2.0
    return matrix


def inverse(matrix: Matrix) -> Matrix:
    """(4, 4) the inverse of a similarity, as exact as its scale allows."""
    scale_squared = float(matrix[:3, 0] @ matrix[:3, 0])
    result = np.eye(4)
    result[:3, :3] = matrix[:3, :3].T / scale_squared
    result[:3, 3] = -result[:3, :3] @ matrix[:3, 3]
    return result


def scale_of(matrix: Matrix) -> float:
    """The uniform scale of a similarity."""
    return float(np.linalg.norm(matrix[:3, 0]))


def moved_points(points: npt.NDArray[np.float64], matrix: Matrix) -> npt.NDArray[np.float64]:
    """(n, 3) points under a (4, 4) matrix."""
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def moved_mesh(mesh: TriangleMesh, matrix: Matrix) -> TriangleMesh:
    """The mesh under a proper similarity; its triangles keep their orientation."""
    return make_mesh(moved_points(mesh.vertices, matrix), mesh.triangles)
