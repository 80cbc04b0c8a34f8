"""A labelled space as a B-Rep.

Faces of all patches are fused, which splits them along their intersections.  Those sub-faces are
kept that have material on one side only; sewn they bound the part.
"""

from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np
from OCP.BOPAlgo import BOPAlgo_Builder
from OCP.BOPTools import BOPTools_AlgoTools3D
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeSolid,
    BRepBuilderAPI_Sewing,
    BRepBuilderAPI_Transform,
)
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.BRepTools import BRepTools
from OCP.gp import gp_Ax3, gp_Cylinder, gp_Dir, gp_Pln, gp_Pnt, gp_Pnt2d, gp_Trsf
from OCP.GProp import GProp_GProps
from OCP.IntTools import IntTools_Context
from OCP.ShapeFix import ShapeFix_Shape
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import APART, ASIDE
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.kernel.brep import ShapeTable, bounding_box, faces_of, subshapes, volume
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.kernel.surface_crossings import normal_at
from gaussiancad_core.labelling.counted_work import NEVER, Counted, Deadline
from gaussiancad_core.model.axes import Vector
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted
from gaussiancad_core.solid.extra_faces import body_faces
from gaussiancad_core.solid.face_patches import NARROW, Patch, PlanePatch, SweptPatch, find_patches
from gaussiancad_core.solid.labelled_cells import LabelledComplex

_VECTORS = np.eye(3)


@dataclass(frozen=True)
class _Fit:
    """How closely faces are taken to be apart, in units.

    Attributes:
        narrow: depth that a difference of labels has at least to become a patch.
        fuzzy: within which faces coincide.
        sewing: within which edges do.
    """

    narrow: float
    fuzzy: float
    sewing: float


_FITS = (
    _Fit(NARROW, 1e-6, 1e-4),
    _Fit(2e-3, 1e-6, 1e-4),
    _Fit(2e-3, 1e-3, 2e-3),
    _Fit(2e-3, 2e-2, 2e-2),
)
"""One after the other, until the faces close: misread lines leave slivers of space beside others,
which have faces of their own, or none."""


@dataclass(frozen=True)
class BuiltSolid:
    """What came of a labelled space.

    Attributes:
        shape: the solid in mm; None if the faces did not close.
        bodies: number of separate pieces of material.
        closed: whether the faces closed; if they did not, it is not known what they would bound.
        largest: the largest of several pieces, in mm.
        open_at: mm, middles of edges that bound one face only, where the faces did not close.
    """

    shape: TopoDS_Shape | None
    bodies: int
    closed: bool = True
    largest: TopoDS_Shape | None = None
    open_at: tuple[Vector, ...] = ()


@dataclass(frozen=True)
class _Sewn:
    """Faces sewn together.

    Attributes:
        solid: the largest one; None if they bound none.
        count: number of outer shells.
        closed: whether the faces close; nothing is bounded where they do not.
        open_at: middles of edges that bound one face only.
    """

    solid: TopoDS_Shape | None = None
    count: int = 0
    closed: bool = True
    open_at: tuple[Vector, ...] = ()


def build_solid(space: LabelledComplex, scale: float, deadline: Deadline = NEVER) -> BuiltSolid:
    """The B-Rep of a labelled space.

    Args:
        space: in units.
        scale: units per mm.
        deadline: after which it is not tried again; faces are counted towards it.
    """
    built = _tried(space, scale, _FITS[0], deadline)
    for fit in _FITS[1:]:
        if built.closed or not deadline.left:
            break
        built = _valid(_tried(space, scale, fit, deadline))
    return built


def _valid(built: BuiltSolid) -> BuiltSolid:
    """What was built, if it is sound: where faces were forced together, what closed may be none
    that OpenCASCADE could draw."""
    shape = built.shape or built.largest
    sound = shape is None or BRepCheck_Analyzer(shape).IsValid()
    return built if sound else BuiltSolid(None, built.bodies, closed=False)


def _tried(space: LabelledComplex, scale: float, fit: _Fit, deadline: Deadline) -> BuiltSolid:
    """What the faces close to; nothing where OpenCASCADE gives up on them."""
    try:
        return _built(space, scale, fit, deadline)
    except KERNEL_FAILURES:
        return BuiltSolid(None, 0, closed=False)


def _built(space: LabelledComplex, scale: float, fit: _Fit, deadline: Deadline) -> BuiltSolid:
    faces = [_face(patch) for patch in find_patches(space, fit.narrow)]
    faces += [face for body in space.space.bodies for face in body_faces(body)]
    if not faces:
        return BuiltSolid(None, 0)
    sides = _Sides(space)
    while True:
        deadline.count(Counted.PATCH, len(faces))
        fused = _fused(faces, fit.fuzzy)
        kept = [face for face in faces_of(fused.Shape()) if sides.is_border(face)]
        sewn = _sewn_best(sides, kept, fit.sewing)
        if sewn.closed and not _is_split_in_vain(kept):
            break
        # Faces that only touch others may have split them where nothing meets.
        bounding = [face for face in faces if _gives_one_of(kept, face, fused)]
        if len(bounding) == len(faces) or not deadline.left:
            places = tuple((x / scale, y / scale, z / scale) for x, y, z in sewn.open_at)
            return BuiltSolid(None, 0, closed=False, open_at=places)
        faces = bounding
    if sewn.solid is None:
        return BuiltSolid(None, sewn.count)
    finished = _scaled(_simplified(sewn.solid), 1.0 / scale)
    if sewn.count == 1:
        return BuiltSolid(finished, 1)
    return BuiltSolid(None, sewn.count, largest=finished)


def _face(patch: Patch) -> TopoDS_Face:
    if isinstance(patch, PlanePatch):
        first, second = IN_PLANE[patch.axis]
        origin = lifted(patch.axis, 0.0, 0.0, patch.value)
        normal = np.cross(_VECTORS[first], _VECTORS[second])
        plane = gp_Pln(_frame(origin, normal, _VECTORS[first]))
        return BRepBuilderAPI_MakeFace(plane, *patch.rectangle).Face()
    return _swept_face(patch)


def _swept_face(patch: SweptPatch) -> TopoDS_Face:
    start, end, near, far = patch.rectangle
    first, second = IN_PLANE[patch.axis]
    depth = _VECTORS[patch.axis.value]
    if isinstance(patch.curve, Circle):
        up = np.cross(_VECTORS[first], _VECTORS[second])
        way = float(np.sign(up @ depth))
        origin = lifted(patch.axis, *patch.curve.centre, 0.0)
        low, high = (near, far) if way > 0.0 else (-far, -near)
        if end - start > FULL_TURN - 1e-6:
            start, end = 0.0, 2.0 * pi
        # A seam within the patch is moved opposite: what crosses it is found less well.
        seam = (start + end) / 2.0 - pi if start < 0.0 else 0.0
        x = cos(seam) * _VECTORS[first] + sin(seam) * _VECTORS[second]
        cylinder = gp_Cylinder(_frame(origin, up, x), patch.curve.radius)
        return BRepBuilderAPI_MakeFace(cylinder, start - seam, end - seam, low, high).Face()
    origin = lifted(patch.axis, *patch.curve.at(start), near)
    along = np.array(lifted(patch.axis, *patch.curve.direction, 0.0))
    normal = np.cross(along, depth)
    plane = gp_Pln(_frame(origin, normal, along))
    across = np.cross(normal, along)
    low, high = (0.0, far - near) if across @ depth > 0.0 else (near - far, 0.0)
    return BRepBuilderAPI_MakeFace(plane, 0.0, end - start, low, high).Face()


def _frame(origin: tuple[float, float, float], normal: np.ndarray, x: np.ndarray) -> gp_Ax3:
    return gp_Ax3(gp_Pnt(*origin), gp_Dir(*map(float, normal)), gp_Dir(*map(float, x)))


def _fused(faces: list[TopoDS_Face], fuzzy: float) -> BOPAlgo_Builder:
    """What splits the faces along their intersections."""
    builder = BOPAlgo_Builder()
    for face in faces:
        builder.AddArgument(face)
    builder.SetRunParallel(False)
    builder.SetFuzzyValue(fuzzy)
    builder.Perform()
    return builder


def _is_split_in_vain(faces: list[TopoDS_Face]) -> bool:
    """Whether a face is bounded by edges that lie within another one and do not divide it.

    Where an outline of intersections misses its own end by a hair it stays open.
    """
    within, bounding = ShapeTable(), ShapeTable()
    for face in faces:
        for edge in subshapes(face, TopAbs_ShapeEnum.TopAbs_EDGE):
            is_inside = edge.Orientation() == TopAbs_Orientation.TopAbs_INTERNAL
            (within if is_inside else bounding).number(edge)
    known = len(bounding.shapes)
    return any(bounding.number(edge) < known for edge in within.shapes)


def _gives_one_of(kept: list[TopoDS_Face], face: TopoDS_Face, fused: BOPAlgo_Builder) -> bool:
    """Whether one of the kept sub-faces is of a face, and no sliver.

    Where surfaces touch, what lies just beside one of them is on the other side of the other one.
    """
    if fused.IsDeleted(face):
        return False
    parts = fused.Modified(face) if fused.HasModified() else ()
    items = list(parts) or [face]
    return any(any(part.IsSame(each) for part in items) and not _is_sliver(each) for each in kept)


def _is_sliver(face: TopoDS_Face, width: float = APART) -> bool:
    """Whether a face is so narrow that its sides cannot be told."""
    inner, around = GProp_GProps(), GProp_GProps()
    BRepGProp.SurfaceProperties_s(face, inner)
    BRepGProp.LinearProperties_s(face, around)
    return inner.Mass() < width / 2.0 * around.Mass()


class _Sides:
    """Tells on which side of a face the material is."""

    def __init__(self, space: LabelledComplex) -> None:
        self._space = space
        self._context = IntTools_Context()

    def is_border(self, face: TopoDS_Face) -> bool:
        """Whether there is material on one side of a face only."""
        material = self.material(face)
        return material is not None and material[0] != material[1]

    def material(self, face: TopoDS_Face) -> tuple[bool, bool] | None:
        """Whether there is material (behind, before) a face; None where it has no inner point."""
        point, parameters = gp_Pnt(), gp_Pnt2d()
        if BOPTools_AlgoTools3D.PointInFace_s(face, point, parameters, self._context) != 0:
            return None
        normal = normal_at(BRepAdaptor_Surface(face), parameters.X(), parameters.Y())
        if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
            normal = -normal
        at = np.array([point.X(), point.Y(), point.Z()])
        behind, before = (
            self._space.is_material(tuple(at + way * ASIDE * normal)) for way in (-1.0, 1.0)
        )
        return behind, before


def _sewn_best(sides: _Sides, faces: list[TopoDS_Face], within: float) -> _Sewn:
    """The same as :func:`_sewn`, without faces narrower than the seams where that is better.

    Both edges of such a face are sewn to both of its neighbours: what is one body falls apart.
    """
    sewn = _sewn(sides, faces, within)
    if sewn.closed and sewn.count <= 1:
        return sewn
    wide = [face for face in faces if not _is_sliver(face, within)]
    if len(wide) == len(faces):
        return sewn
    other = _sewn(sides, wide, within)
    is_better = other.closed and (not sewn.closed or 0 < other.count < sewn.count)
    return other if is_better else sewn


def _sewn(sides: _Sides, faces: list[TopoDS_Face], within: float) -> _Sewn:
    """The solid that faces bound, or where they are open."""
    sewing = BRepBuilderAPI_Sewing(within)
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    shells = subshapes(sewing.SewedShape(), TopAbs_ShapeEnum.TopAbs_SHELL)
    if not shells or sewing.NbFreeEdges() > 0:
        return _Sewn(open_at=_open_at(sewing), closed=False)
    signed = [_outward(sides, shell) for shell in shells]
    outer = [(size, shell) for size, shell in signed if size > 0.0]
    if not outer:
        return _Sewn()
    _, largest = max(outer, key=lambda item: item[0])
    maker = BRepBuilderAPI_MakeSolid(TopoDS.Shell(largest))
    for size, shell in signed:
        if size < 0.0 and (len(outer) == 1 or _lies_within(shell, largest)):
            maker.Add(TopoDS.Shell(shell))
    return _Sewn(maker.Solid(), len(outer))


def _open_at(sewing: BRepBuilderAPI_Sewing) -> tuple[Vector, ...]:
    """Middles of the edges that bound one face only."""
    found = []
    for number in range(1, sewing.NbFreeEdges() + 1):
        curve = BRepAdaptor_Curve(sewing.FreeEdge(number))
        point = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2.0)
        found.append((point.X(), point.Y(), point.Z()))
    return tuple(found)


def _lies_within(one: TopoDS_Shape, other: TopoDS_Shape) -> bool:
    """Whether a shape's box lies in that of another."""
    inner, outer = bounding_box(one), bounding_box(other)
    return bool((inner[0] >= outer[0]).all() and (inner[1] <= outer[1]).all())


def _outward(sides: _Sides, shell: TopoDS_Shape) -> tuple[float, TopoDS_Shape]:
    """The shell with normals that leave the material; its volume is negative around a cavity."""
    for face in faces_of(shell):
        material = sides.material(face)
        if material is not None and material[0] != material[1]:
            if material[1]:
                shell = shell.Reversed()
            break
    return volume(BRepBuilderAPI_MakeSolid(TopoDS.Shell(shell)).Solid()), shell


def _simplified(solid: TopoDS_Shape) -> TopoDS_Shape:
    """The solid with as few faces as it can have, if that leaves it valid."""
    # Borders of patches stay as edges inside of faces that they do not divide.
    BRepTools.RemoveInternals_s(solid)
    for whole_edges in (True, False):
        unify = ShapeUpgrade_UnifySameDomain(solid, whole_edges, True, False)
        unify.Build()
        unified = unify.Shape()
        for candidate in (unified, _mended(unified)):
            if candidate is not None and BRepCheck_Analyzer(candidate).IsValid():
                return _single(candidate)
    return solid


def _mended(shape: TopoDS_Shape) -> TopoDS_Shape | None:
    try:
        fix = ShapeFix_Shape(shape)
        fix.Perform()
        return fix.Shape()
    except KERNEL_FAILURES:
        return None


def _single(shape: TopoDS_Shape) -> TopoDS_Shape:
    solids = subshapes(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    return solids[0] if len(solids) == 1 else shape


def _scaled(shape: TopoDS_Shape, factor: float) -> TopoDS_Shape:
    move = gp_Trsf()
    move.SetScale(gp_Pnt(0.0, 0.0, 0.0), factor)
    return BRepBuilderAPI_Transform(shape, move, True).Shape()
