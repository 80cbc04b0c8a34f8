"""Which kind of mesh it is: with sharp edges, or with edges rounded over small triangles."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.meshes import TriangleMesh

_SHORT_SHARE = 0.025
_BEND, _EDGE = np.radians(20.0), np.radians(45.0)


def is_rounded(mesh: TriangleMesh) -> bool:
    """Whether a mesh rounds its edges over several small triangles, as Poisson does.

    Judged by the edges between triangles that bend by more than 20 degrees, by length: tessellated
    solids bend along edges that are long, or sharp (more than 45 degrees); Poisson's are neither.
    Flat faces say nothing: cut to a hull, a Poisson surface has triangles of any size there.
    """
    pairs, edges = mesh.shared_edges
    normals = triangle_normals(mesh, smoothed=False)[pairs]
    angles = np.arccos(np.clip((normals[:, 0] * normals[:, 1]).sum(axis=1), -1.0, 1.0))
    ends = mesh.vertices[edges]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    bent = angles > _BEND
    short = lengths < _SHORT_SHARE * float(np.ptp(mesh.bounds, axis=0).max())
    half = 0.5 * lengths[bent].sum()
    return bool(lengths[bent & short].sum() > half and lengths[angles > _EDGE].sum() <= half)


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
