"""Closed meshes as manifold3d's solids: for Booleans, and where bodies touch or overlap."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

if TYPE_CHECKING:
    import manifold3d

_ROUNDING = 1e-9
"""Share by which volumes and areas of the same surface may differ."""


def manifold_of(mesh: TriangleMesh) -> "manifold3d.Manifold | None":
    """The mesh as a solid for Booleans, or None where it does not bound one.

    Bodies that overlap are united, or what they share would count twice; not beside cavities.
    """
    import manifold3d

    solid = manifold3d.Manifold(
        manifold3d.Mesh64(
            np.ascontiguousarray(mesh.vertices),
            np.ascontiguousarray(mesh.triangles, dtype=np.uint64),
        )
    )
    if solid.status() != manifold3d.Error.NoError or solid.volume() <= 0.0:
        return None
    pieces = solid.decompose()
    if len(pieces) > 1 and all(piece.volume() > 0.0 for piece in pieces):
        return manifold3d.Manifold.batch_boolean(pieces, manifold3d.OpType.Add)
    return solid


def untangled(mesh: TriangleMesh) -> TriangleMesh:
    """A mesh whose pieces touch along edges, with vertices of its own for each piece there.

    An edge with four triangles belongs to two pieces of a closed surface.  Meshes that are open,
    and those that have no such edges, come back as they are.
    """
    if mesh.watertight:
        return mesh
    solid = manifold_of(mesh)
    return mesh if solid is None else _mesh_of(solid)


def united(bodies: Sequence[TriangleMesh]) -> TriangleMesh | None:
    """What bodies that touch or overlap enclose together.

    Args:
        bodies: closed meshes, each of one body, oriented outward.

    Returns:
        The surface around all of them, without what lies between them; None where they lie apart,
        or where one of them bounds nothing.
    """
    import manifold3d

    made = [manifold_of(untangled(body)) for body in bodies]
    solids = [solid for solid in made if solid is not None]
    if len(solids) < len(made):
        return None
    whole = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)
    if whole.status() != manifold3d.Error.NoError:
        return None
    # Nothing is between bodies that lie apart, so that volume and area stay.
    alike = all(
        before - after <= _ROUNDING * before
        for before, after in (
            (sum(solid.volume() for solid in solids), whole.volume()),
            (sum(solid.surface_area() for solid in solids), whole.surface_area()),
        )
    )
    return None if alike else _mesh_of(whole)


def _mesh_of(solid: "manifold3d.Manifold") -> TriangleMesh:
    found = solid.to_mesh64()
    return make_mesh(np.asarray(found.vert_properties)[:, :3], np.asarray(found.tri_verts))
