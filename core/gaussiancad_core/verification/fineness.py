"""Which kind of mesh it is: of flat faces and sharp edges, or of evenly small triangles."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.meshes import TriangleMesh

_FINE_SHARE = 0.025
_BEND, _EDGE = np.radians(20.0), np.radians(45.0)


def is_rounded(mesh: TriangleMesh) -> bool:
    """Whether a mesh is evenly fine and rounds its edges over several triangles, as Poisson does.

    Tessellated solids have large triangles on their flat faces: half of the area lies in triangles
    longer than 2.5 % of the mesh.  Of fine meshes those are sharp that bend by more than 45 degrees
    along most of the length where they bend at all.
    """
    sides = mesh.corners - np.roll(mesh.corners, 1, axis=1)
    longest = np.sqrt(np.einsum("mij,mij->mi", sides, sides).max(axis=1))
    fine = longest < _FINE_SHARE * float(np.ptp(mesh.bounds, axis=0).max())
    if mesh.areas[fine].sum() <= 0.5 * mesh.area:
        return False
    measured = mesh.to_trimesh()
    angles = measured.face_adjacency_angles
    ends = mesh.vertices[measured.face_adjacency_edges]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    return bool(lengths[angles > _EDGE].sum() <= 0.5 * lengths[angles > _BEND].sum())


def triangle_normals(mesh: TriangleMesh, smoothed: bool) -> npt.NDArray[np.float64]:
    """(m, 3) unit normals of the triangles; zero where a triangle has no area.

    Smoothed, each is the mean over all triangles that share a corner with it, by area: what bumps a
    surface in single triangles goes, what bends it over several stays.
    """
    normals = mesh.area_vectors
    if smoothed:
        at_vertex = np.zeros_like(mesh.vertices)
        for corner in range(3):
            np.add.at(at_vertex, mesh.triangles[:, corner], normals)
        normals = _unit(at_vertex)[mesh.triangles].sum(axis=1)
    return _unit(normals)


def _unit(vectors: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)
