"""Exact solids and surfaces on disk as meshes, with what their triangles would only come near."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
from OCP.BRepGProp import BRepGProp
from OCP.BRepLib import BRepLib
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.GProp import GProp_GProps
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.comparison.closed_bodies import united
from gaussiancad_core.comparison.model_files import Content, ExactFacts
from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.kernel.brep import (
    bounding_box,
    compound_of,
    faces_of,
    soundness,
    subshapes,
    tessellate,
)
from gaussiancad_core.kernel.brep_files import read_shape, readable
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_protocol.codes import Code

_DEFLECTION_SHARE = 5e-5
"""Largest distance of a tessellation from its exact surface, as a share of the longest edge."""

_DEFLECTION_ANGLE = 0.2

_SEWING_SHARE = 1e-5
"""Gaps between surfaces that are closed, as a share of the longest edge."""

_INTEGRATION_ERROR = 1e-12
"""Asked of OpenCASCADE for free-form faces; its fixed number of points is off by up to 1e-3."""

_ELEMENTARY = (
    GeomAbs_SurfaceType.GeomAbs_Plane,
    GeomAbs_SurfaceType.GeomAbs_Cylinder,
    GeomAbs_SurfaceType.GeomAbs_Cone,
    GeomAbs_SurfaceType.GeomAbs_Sphere,
    GeomAbs_SurfaceType.GeomAbs_Torus,
)


@dataclass(frozen=True, eq=False)
class _Comparable:
    """What of a file is compared.

    Attributes:
        shape: one solid, a compound of several, or surfaces.
        content: which.
        left_out: faces that belong to none of the solids.
    """

    shape: TopoDS_Shape
    content: Content
    left_out: int = 0


def read_exact(path: Path) -> tuple[TriangleMesh, ExactFacts]:
    """Read a STEP or BREP file as triangles.

    Solids that touch or overlap are measured as what they enclose together.  Where there are no
    solids, surfaces are sewn; what is closed then counts as a solid.

    Raises:
        UnreadableError: see :func:`gaussiancad_core.kernel.brep_files.read_shape`; ``not-a-solid``
            where
            there are no surfaces either; ``file-damaged`` where they cannot be measured.
    """
    with readable(path):
        return _read_exact(path)


def _read_exact(path: Path) -> tuple[TriangleMesh, ExactFacts]:
    chosen = _comparable(path)
    shape = chosen.shape
    longest = float(np.ptp(bounding_box(shape), axis=0).max())
    deflection = _DEFLECTION_SHARE * longest
    mesh = _triangles(shape, deflection)
    facts = exact_facts(shape, deflection)
    facts = replace(
        facts,
        valid=facts.valid and chosen.content is not Content.SURFACES,
        content=chosen.content,
        left_out=chosen.left_out,
    )
    solids = subshapes(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    if len(solids) > 1:
        around = united([_triangles(solid, deflection) for solid in solids])
        if around is not None:
            mesh = around
            facts = replace(
                facts, volume_mm3=around.volume, area_mm2=around.area, united=len(solids)
            )
    return mesh, facts


def exact_facts(shape: TopoDS_Shape, deflection: float) -> ExactFacts:
    """Measure a shape whose triangles are at most ``deflection`` mm away from it."""
    sound = soundness(shape)
    kinds = _kinds(shape)
    volume, area = sound.volume_mm3, GProp_GProps()
    if kinds <= set(_ELEMENTARY):
        BRepGProp.SurfaceProperties_s(shape, area)
    else:
        enclosed = GProp_GProps()
        BRepGProp.VolumeProperties_s(shape, enclosed, _INTEGRATION_ERROR)
        BRepGProp.SurfaceProperties_s(shape, area, _INTEGRATION_ERROR)
        volume = float(enclosed.Mass())
    flat = kinds <= {GeomAbs_SurfaceType.GeomAbs_Plane}
    return ExactFacts(
        valid=sound.valid,
        closed=sound.closed,
        faces=sound.faces,
        volume_mm3=abs(volume),
        area_mm2=float(area.Mass()),
        # Where all faces are planes the triangles are the surface itself.
        deflection_mm=0.0 if flat else deflection,
    )


def _triangles(shape: TopoDS_Shape, deflection: float) -> TriangleMesh:
    strict = not _kinds(shape) <= set(_ELEMENTARY)
    return make_mesh(*tessellate(shape, deflection, _DEFLECTION_ANGLE, strict=strict))


def _kinds(shape: TopoDS_Shape) -> set[GeomAbs_SurfaceType]:
    return {BRepAdaptor_Surface(face).GetType() for face in faces_of(shape)}


def _comparable(path: Path) -> _Comparable:
    shape = read_shape(path)
    faces = faces_of(shape)
    if not faces:
        raise UnreadableError(
            Code.NOT_A_SOLID,
            "{path} holds neither solids nor surfaces: export a solid or its faces",
            path=path,
        )
    solids = subshapes(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    if not solids:
        return _sewn(faces, float(np.ptp(bounding_box(shape), axis=0).max()))
    whole = solids[0] if len(solids) == 1 else compound_of(solids)
    return _Comparable(whole, Content.SOLIDS, len(faces) - len(faces_of(whole)))


def _sewn(faces: list[TopoDS_Face], longest: float) -> _Comparable:
    """Faces joined where they meet; solids, if all of them close up."""
    sewing = BRepBuilderAPI_Sewing(_SEWING_SHARE * longest)
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    shape = sewing.SewedShape()
    shells = [TopoDS.Shell(each) for each in subshapes(shape, TopAbs_ShapeEnum.TopAbs_SHELL)]
    closed = sum(len(faces_of(shell)) for shell in shells if BRep_Tool.IsClosed_s(shell))
    if not closed or closed < len(faces_of(shape)):
        return _Comparable(shape, Content.SURFACES)
    solids = []
    for shell in shells:
        solid = BRepBuilderAPI_MakeSolid(shell).Solid()
        BRepLib.OrientClosedSolid_s(solid)
        solids.append(solid)
    return _Comparable(solids[0] if len(solids) == 1 else compound_of(solids), Content.SEWN)
