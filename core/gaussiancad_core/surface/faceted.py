"""A mesh as a faceted solid: what CAD programs open where there is no exact one.

Vertices and edges are shared by construction, so nothing has to be sewn.
"""

import numpy as np
import numpy.typing as npt
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeVertex,
    BRepBuilderAPI_MakeWire,
)
from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopoDS import (
    TopoDS,
    TopoDS_Compound,
    TopoDS_Edge,
    TopoDS_Shape,
    TopoDS_Shell,
    TopoDS_Solid,
    TopoDS_Vertex,
)

from gaussiancad_core.errors import EngineError
from gaussiancad_core.kernel.brep import Soundness, soundness
from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces
from gaussiancad_core.surface.repair import simplified
from gaussiancad_protocol.codes import Code

_FLAT_ANGLE = 1e-5
"""Neighbouring triangles whose normals differ by less, in radians, lie in one plane."""

_NEEDLE = 1e-6
"""mm: a triangle of less height has no plane, and OpenCASCADE may never be done with its face."""

_SAME_VOLUME = 1e-6
"""Largest change of the volume, as a share, that merging faces may bring."""


def faceted_solid(mesh: TriangleMesh) -> TopoDS_Shape:
    """A valid closed solid with one planar face a triangle; coplanar neighbours are merged.

    Args:
        mesh: watertight, oriented outward, mm.  Triangles without area, whose corners lie on one
            line, are left out, and their neighbours joined.

    Returns:
        A solid, or a compound of solids where the mesh has several pieces.

    Raises:
        EngineError: ``faceted-solid-failed``, OpenCASCADE finds the solid wrong, or triangles
            without area cannot be left out.
    """
    mesh = _without_needles(mesh)
    solids = [_solid(piece) for piece in connected_pieces(mesh)]
    shape = solids[0] if len(solids) == 1 else _compound(solids)
    state = soundness(shape)
    if not (state.valid and state.closed):
        raise _failed()
    return _merged(shape, state) if _has_flat_edges(mesh) else shape


def _failed() -> EngineError:
    return EngineError(
        Code.FACETED_SOLID_FAILED,
        "the surface does not become a valid solid: use surface.stl instead",
    )


def _without_needles(mesh: TriangleMesh) -> TriangleMesh:
    """The same surface without triangles that have no plane."""
    if not _has_needles(mesh):
        return mesh
    fewer = simplified(mesh, _NEEDLE)
    if fewer is None or _has_needles(fewer):
        raise _failed()
    return fewer


def _has_needles(mesh: TriangleMesh) -> bool:
    sides = mesh.corners - np.roll(mesh.corners, 1, axis=1)
    longest = np.linalg.norm(sides, axis=2).max(axis=1)
    return bool((2.0 * mesh.areas <= _NEEDLE * longest).any())


def _solid(mesh: TriangleMesh) -> TopoDS_Solid:
    vertices = [
        BRepBuilderAPI_MakeVertex(gp_Pnt(*(float(value) for value in point))).Vertex()
        for point in mesh.vertices
    ]
    edges: dict[tuple[int, int], TopoDS_Edge] = {}
    builder, shell, solid = BRep_Builder(), TopoDS_Shell(), TopoDS_Solid()
    builder.MakeShell(shell)
    lengths = np.linalg.norm(mesh.area_vectors, axis=1, keepdims=True)
    normals = mesh.area_vectors / lengths
    for triangle, normal in zip(mesh.triangles.tolist(), normals, strict=True):
        builder.Add(shell, _face(vertices, edges, triangle, mesh.vertices[triangle[0]], normal))
    shell.Closed(True)
    builder.MakeSolid(solid)
    builder.Add(solid, shell)
    return solid


def _face(
    vertices: list[TopoDS_Vertex],
    edges: dict[tuple[int, int], TopoDS_Edge],
    triangle: list[int],
    point: npt.NDArray[np.float64],
    normal: npt.NDArray[np.float64],
) -> TopoDS_Shape:
    wire = BRepBuilderAPI_MakeWire()
    for start, end in zip(triangle, triangle[1:] + triangle[:1], strict=True):
        shared = edges.get((end, start))
        if shared is None:
            shared = BRepBuilderAPI_MakeEdge(vertices[start], vertices[end]).Edge()
            edges[(start, end)] = shared
            wire.Add(shared)
        else:
            wire.Add(TopoDS.Edge(shared.Reversed()))
    plane = gp_Pln(
        gp_Pnt(*(float(value) for value in point)), gp_Dir(*(float(value) for value in normal))
    )
    return BRepBuilderAPI_MakeFace(plane, wire.Wire(), True).Face()


def _compound(solids: list[TopoDS_Solid]) -> TopoDS_Compound:
    builder, compound = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(compound)
    for solid in solids:
        builder.Add(compound, solid)
    return compound


def _has_flat_edges(mesh: TriangleMesh) -> bool:
    """Whether any two neighbouring triangles lie in one plane."""
    normals = mesh.area_vectors / mesh.areas[:, None]
    pairs, _ = mesh.shared_edges
    sines = np.linalg.norm(np.cross(normals[pairs[:, 0]], normals[pairs[:, 1]]), axis=1)
    return bool((sines < _FLAT_ANGLE).any())


def _merged(shape: TopoDS_Shape, before: Soundness) -> TopoDS_Shape:
    """The shape with coplanar neighbours merged, or as it was where that does harm."""
    unify = ShapeUpgrade_UnifySameDomain(shape, True, True, False)
    unify.SetAngularTolerance(_FLAT_ANGLE)
    unify.Build()
    merged = unify.Shape()
    after = soundness(merged)
    same = abs(after.volume_mm3 - before.volume_mm3) <= _SAME_VOLUME * before.volume_mm3
    sound = after.valid and after.closed and after.solids == before.solids
    return merged if sound and same else shape
