"""Fewer triangles for the same surface (quadric error, Garland and Heckbert 1997, in open3d)."""

import numpy as np

from gaussiancad_core.errors import EngineError
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.surface.repair import made_manifold
from gaussiancad_protocol.codes import Code

FACETED_LIMIT = 3_000
"""Triangles of a faceted solid: FreeCAD shows them with ease, and they lie within a thousandth of
the part from the surface that they stand for."""

_TRIES = 6
_SHRINK = 0.8


def decimated(mesh: TriangleMesh, limit: int = FACETED_LIMIT) -> TriangleMesh:
    """A watertight, manifold mesh of at most ``limit`` triangles.

    Where collapsing edges leaves a mesh that touches itself and cannot be parted, a lower number
    is tried.

    Args:
        mesh: watertight, oriented outward, mm.
        limit: most triangles; at least 4 a piece are needed.

    Raises:
        EngineError: ``decimation-failed``, no try gave a closed mesh.
    """
    from gaussiancad_core.kernel.bare_open3d import open3d

    if len(mesh.triangles) <= limit:
        return mesh
    source = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(mesh.vertices.copy()),
        open3d.utility.Vector3iVector(mesh.triangles.astype(np.int32)),
    )
    target = float(limit)
    for _ in range(_TRIES):
        fewer = source.simplify_quadric_decimation(int(target))
        fewer.remove_degenerate_triangles()
        fewer.remove_unreferenced_vertices()
        found = make_mesh(np.asarray(fewer.vertices), np.asarray(fewer.triangles))
        repaired = made_manifold(found) if len(found.triangles) >= 4 else None
        if repaired is not None and len(repaired.triangles) <= limit and repaired.volume > 0.0:
            return repaired
        target *= _SHRINK
    raise EngineError(
        Code.DECIMATION_FAILED,
        "the surface cannot be closed with {limit} triangles: use the STL or a finer preset",
        limit=limit,
    )
