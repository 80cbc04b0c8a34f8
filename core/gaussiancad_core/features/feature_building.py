"""Features built as an exact solid: the check of what was found."""

from collections.abc import Sequence

import numpy as np
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeWire,
)
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism, BRepPrimAPI_MakeRevol
from OCP.gp import gp_Ax1, gp_Ax2, gp_Circ, gp_Dir, gp_Pnt, gp_Vec
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shape, TopoDS_Wire

from gaussiancad_core.features.feature_model import Extrusion, Sketch, Turning
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.kernel.booleans import fused, unified, without
from gaussiancad_core.kernel.brep import subshapes, volume
from gaussiancad_core.solid.profiles import edge_shape


def body_of(feature: Extrusion | Turning) -> TopoDS_Shape:
    """The body that a feature adds or takes away.

    Raises:
        RuntimeError: the kernel fails.
    """
    return _swept(feature, face_of(feature.sketch))


def _swept(feature: Extrusion | Turning, drawn: TopoDS_Shape) -> TopoDS_Shape:
    frame = feature.sketch.frame
    if isinstance(feature, Extrusion):
        way = gp_Vec(*(feature.length * part for part in frame.normal))
        return BRepPrimAPI_MakePrism(drawn, way).Shape()
    start = _place(feature.sketch, feature.point)
    direction = np.array(feature.direction)
    along = direction[0] * np.array(frame.right) + direction[1] * np.array(frame.up)
    return BRepPrimAPI_MakeRevol(drawn, gp_Ax1(start, gp_Dir(*along.tolist()))).Shape()


def combined(features: Sequence[Extrusion | Turning]) -> TopoDS_Shape:
    """Bodies added and taken away, one after the other.

    Raises:
        RuntimeError: the kernel fails.
    """
    added = [body_of(feature) for feature in features if feature.adds]
    taken = [body_of(feature) for feature in features if not feature.adds]
    body = fused(added)
    return without(body, taken) if taken else body


def in_order_of_making(
    features: Sequence[Extrusion | Turning],
) -> tuple[Extrusion | Turning, ...]:
    """The same features so that each pad touches what is there already: the largest first, pockets
    last.

    Raises:
        RuntimeError: the kernel fails.
    """
    pads = sorted(
        ((feature, body_of(feature)) for feature in features if feature.adds),
        key=lambda entry: -volume(entry[1]),
    )
    ordered, made = [pads[0][0]], pads.pop(0)[1]
    while pads:
        grown = [(k, fused([made, body])) for k, (_, body) in enumerate(pads)]
        touching = (
            (k, shape)
            for k, shape in grown
            if len(subshapes(unified(shape), TopAbs_ShapeEnum.TopAbs_SOLID)) == 1
        )
        number, made = next(touching, grown[0])
        ordered.append(pads.pop(number)[0])
    return (*ordered, *(feature for feature in features if not feature.adds))


def face_of(sketch: Sketch) -> TopoDS_Face:
    """The face that a sketch's outlines bound.

    Raises:
        RuntimeError: the kernel fails.
    """
    outer, *holes = (_wire(sketch, loop) for loop in sketch.loops)
    made = BRepBuilderAPI_MakeFace(outer, True)
    for hole in holes:
        made.Add(hole)
    return made.Face()


def wall_of(feature: Extrusion | Turning, edge: OutlineEdge) -> TopoDS_Shape:
    """The face that an edge of a feature's sketch sweeps.

    Raises:
        RuntimeError: the kernel fails.
    """
    return _swept(feature, _edge(feature.sketch, edge))


def _wire(sketch: Sketch, loop: Loop) -> TopoDS_Wire:
    made = BRepBuilderAPI_MakeWire()
    for edge in loop:
        made.Add(_edge(sketch, edge))
    return made.Wire()


def _edge(sketch: Sketch, edge: OutlineEdge) -> TopoDS_Edge:
    if edge.circle is not None and edge.is_circle:
        return BRepBuilderAPI_MakeEdge(_circle(sketch, edge.circle, edge.is_ccw)).Edge()
    return edge_shape(edge, edge.middle, lambda point: _place(sketch, point))


def _circle(sketch: Sketch, circle: Circle, is_ccw: bool) -> gp_Circ:
    way = 1.0 if is_ccw else -1.0
    normal = gp_Dir(*(way * part for part in sketch.frame.normal))
    axes = gp_Ax2(_place(sketch, circle.centre), normal, gp_Dir(*sketch.frame.right))
    return gp_Circ(axes, circle.radius)


def _place(sketch: Sketch, point: Point) -> gp_Pnt:
    return place(sketch.frame, sketch.height, point)


def place(frame: Frame, height: float, point: Point) -> gp_Pnt:
    """A point of a plane in space, mm."""
    lifted = frame.lift(np.array([point]), height)[0]
    return gp_Pnt(*lifted.tolist())
