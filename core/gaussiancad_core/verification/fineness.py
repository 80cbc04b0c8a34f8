"""Which kind of mesh it is: of flat faces and sharp edges, or of evenly small triangles."""

import numpy as np

from gaussiancad_core.meshes import TriangleMesh


def is_rounded(mesh: TriangleMesh) -> bool:
    """Whether a mesh is so evenly fine that its edges are rounded, as a Poisson mesh is.

    Tessellated solids have large triangles on their flat faces: half of the area lies in triangles
    longer than 2.5 % of the mesh.
    """
    sides = mesh.corners - np.roll(mesh.corners, 1, axis=1)
    longest = np.sqrt(np.einsum("mij,mij->mi", sides, sides).max(axis=1))
    short = longest < 0.025 * float(np.ptp(mesh.bounds, axis=0).max())
    return bool(mesh.areas[short].sum() > 0.5 * mesh.area)
