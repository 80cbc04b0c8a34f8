"""A few words to model parts with: boxes, cylinders, prisms, revolved profiles, Booleans, fillets.

All lengths are millimetres; every function returns an OpenCASCADE shape.  A plane across an axis
has the two other axes as coordinates, in the order x, y, z: (y, z) across X, (x, z) across Y,
(x, y) across Z.
"""

from collections.abc import Callable, Iterable, Sequence

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepAlgoAPI import (
    BRepAlgoAPI_BooleanOperation,
    BRepAlgoAPI_Cut,
    BRepAlgoAPI_Fuse,
)
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
    BRepPrimAPI_MakeRevol,
    BRepPrimAPI_MakeSphere,
)
from OCP.gp import gp_Ax1, gp_Ax2, gp_Dir, gp_Pnt, gp_Vec
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape

from gaussiancad_core.kernel.brep import edges_of, subshapes
from gaussiancad_core.model.axes import Axis

Point3 = tuple[float, float, float]
Point2 = tuple[float, float]

_UNIT: dict[Axis, Point3] = {
    Axis.X: (1.0, 0.0, 0.0),
    Axis.Y: (0.0, 1.0, 0.0),
    Axis.Z: (0.0, 0.0, 1.0),
}


def _point(axis: Axis, flat: Point2, along: float) -> gp_Pnt:
    coordinates = [float(flat[0]), float(flat[1])]
    coordinates.insert(axis.value, float(along))
    return gp_Pnt(*coordinates)


def box(lower: Point3, upper: Point3) -> TopoDS_Shape:
    """A box between two corners."""
    return BRepPrimAPI_MakeBox(
        gp_Pnt(*(float(value) for value in lower)),
        gp_Pnt(*(float(value) for value in upper)),
    ).Shape()


def cylinder(axis: Axis, centre: Point2, radius: float, start: float, end: float) -> TopoDS_Shape:
    """A cylinder along an axis from ``start`` to ``end``."""
    frame = gp_Ax2(_point(axis, centre, start), gp_Dir(*_UNIT[axis]))
    return BRepPrimAPI_MakeCylinder(frame, float(radius), float(end - start)).Shape()


def leaning_cylinder(
    middle: Point3, direction: Point3, radius: float, length: float
) -> TopoDS_Shape:
    """A cylinder of a length along any direction, around a point in its middle."""
    way = np.array(direction, dtype=float) / np.linalg.norm(direction)
    start = np.array(middle, dtype=float) - 0.5 * length * way
    frame = gp_Ax2(gp_Pnt(*start.tolist()), gp_Dir(*way.tolist()))
    return BRepPrimAPI_MakeCylinder(frame, float(radius), float(length)).Shape()


def cone(
    axis: Axis, centre: Point2, radii: tuple[float, float], start: float, end: float
) -> TopoDS_Shape:
    """A truncated cone along an axis with its radii at ``start`` and ``end``."""
    frame = gp_Ax2(_point(axis, centre, start), gp_Dir(*_UNIT[axis]))
    return BRepPrimAPI_MakeCone(frame, float(radii[0]), float(radii[1]), float(end - start)).Shape()


def sphere(centre: Point3, radius: float) -> TopoDS_Shape:
    """A ball."""
    return BRepPrimAPI_MakeSphere(
        gp_Pnt(*(float(value) for value in centre)), float(radius)
    ).Shape()


def prism(axis: Axis, outline: Sequence[Point2], start: float, end: float) -> TopoDS_Shape:
    """A polygon in the plane across an axis, extruded from ``start`` to ``end``."""
    polygon = BRepBuilderAPI_MakePolygon()
    for flat in outline:
        polygon.Add(_point(axis, flat, start))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face()
    motion = gp_Vec(*(component * float(end - start) for component in _UNIT[axis]))
    return BRepPrimAPI_MakePrism(face, motion).Shape()


def slot(
    axis: Axis, ends: tuple[Point2, Point2], radius: float, start: float, end: float
) -> TopoDS_Shape:
    """Everything within ``radius`` of the line between two points, extruded along an axis."""
    first, last = np.array(ends[0], dtype=float), np.array(ends[1], dtype=float)
    direction = (last - first) / np.hypot(*(last - first))
    side = radius * np.array([-direction[1], direction[0]])
    corners = [first + side, first - side, last - side, last + side]
    bar = prism(axis, [(float(x), float(y)) for x, y in corners], start, end)
    caps = [cylinder(axis, point, radius, start, end) for point in ends]
    return fuse(bar, *caps)


def revolved(outline: Sequence[Point2], axis: Axis, centre: Point2) -> TopoDS_Shape:
    """A closed profile of (along, radius) points turned once around an axis through ``centre``."""
    polygon = BRepBuilderAPI_MakePolygon()
    for along, radius in outline:
        polygon.Add(_point(axis, (centre[0] + radius, centre[1]), along))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face()
    line = gp_Ax1(_point(axis, centre, 0.0), gp_Dir(*_UNIT[axis]))
    return BRepPrimAPI_MakeRevol(face, line).Shape()


def fuse(shape: TopoDS_Shape, *others: TopoDS_Shape) -> TopoDS_Shape:
    """The union; faces and edges that continue each other are made one."""
    return _combined(BRepAlgoAPI_Fuse, shape, others)


def cut(shape: TopoDS_Shape, *others: TopoDS_Shape) -> TopoDS_Shape:
    """What is left of ``shape`` without the others; split faces are made one."""
    return _combined(BRepAlgoAPI_Cut, shape, others)


def _combined(
    operation: type[BRepAlgoAPI_BooleanOperation],
    shape: TopoDS_Shape,
    others: Iterable[TopoDS_Shape],
) -> TopoDS_Shape:
    for other in others:
        shape = operation(shape, other).Shape()
    unifier = ShapeUpgrade_UnifySameDomain(shape, True, True, False)
    unifier.Build()
    return _single_solid(unifier.Shape())


def _single_solid(shape: TopoDS_Shape) -> TopoDS_Shape:
    """The solid itself where a result is a compound of one."""
    solids = subshapes(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    return solids[0] if len(solids) == 1 else shape


def edges_where(shape: TopoDS_Shape, wanted: Callable[[Point3, Point3], bool]) -> list[TopoDS_Edge]:
    """The edges for whose two end points ``wanted`` holds."""
    chosen = []
    for edge in edges_of(shape):
        curve = BRepAdaptor_Curve(edge)
        ends = [
            curve.Value(parameter) for parameter in (curve.FirstParameter(), curve.LastParameter())
        ]
        if wanted(*((point.X(), point.Y(), point.Z()) for point in ends)):
            chosen.append(edge)
    return chosen


def edges_along(shape: TopoDS_Shape, axis: Axis, at: Iterable[Point2]) -> list[TopoDS_Edge]:
    """The edges along an axis that pass through any of the points of the plane across it."""
    points = [np.array(point, dtype=float) for point in at]

    def wanted(start: Point3, end: Point3) -> bool:
        flat_start, flat_end = np.delete(start, axis.value), np.delete(end, axis.value)
        return abs(start[axis.value] - end[axis.value]) > 1e-6 and any(
            np.abs(flat_start - point).max() < 1e-6 and np.abs(flat_end - point).max() < 1e-6
            for point in points
        )

    return edges_where(shape, wanted)


def filleted(shape: TopoDS_Shape, edges: Iterable[TopoDS_Edge], radius: float) -> TopoDS_Shape:
    """The shape with rounded edges."""
    maker = BRepFilletAPI_MakeFillet(shape)
    for edge in edges:
        maker.Add(float(radius), edge)
    return _single_solid(maker.Shape())


def chamfered(shape: TopoDS_Shape, edges: Iterable[TopoDS_Edge], distance: float) -> TopoDS_Shape:
    """The shape with edges cut off at equal distances."""
    maker = BRepFilletAPI_MakeChamfer(shape)
    for edge in edges:
        maker.Add(float(distance), edge)
    return _single_solid(maker.Shape())
