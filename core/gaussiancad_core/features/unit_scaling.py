"""Solids and features at another size, so that the package's tolerances are plain numbers."""

from dataclasses import replace

from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.feature_model import (
    EdgeBreak,
    Extrusion,
    Feature,
    Holes,
    Sketch,
    Turning,
)
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle


def scaled_shape(shape: TopoDS_Shape, factor: float) -> TopoDS_Shape:
    """A shape as many times as large, the origin staying where it is."""
    motion = gp_Trsf()
    motion.SetScale(gp_Pnt(0.0, 0.0, 0.0), factor)
    return BRepBuilderAPI_Transform(shape, motion, True).Shape()


_DIGITS = 8
"""Decimal places of a length: a tenth of what FreeCAD and OpenCASCADE take for one point."""


def scaled(feature: Feature, factor: float) -> Feature:
    """A feature as many times as large, without the last digits that scaling leaves."""
    if isinstance(feature, Extrusion):
        sketch = _scaled_sketch(feature.sketch, factor)
        return replace(feature, sketch=sketch, length=_times(feature.length, factor))
    if isinstance(feature, Turning):
        x, y = feature.point
        sketch = _scaled_sketch(feature.sketch, factor)
        return replace(feature, sketch=sketch, point=_point((x, y), factor))
    if isinstance(feature, EdgeBreak):
        places = tuple((x * factor, y * factor, z * factor) for x, y, z in feature.places)
        return replace(feature, places=places, size=_times(feature.size, factor))
    return _scaled_holes(feature, factor)


def _scaled_holes(holes: Holes, factor: float) -> Holes:
    sink = holes.sink
    if sink is not None:
        sink = replace(
            sink, diameter=_times(sink.diameter, factor), depth=_times(sink.depth, factor)
        )
    return replace(
        holes,
        height=_times(holes.height, factor),
        centres=tuple(_point(centre, factor) for centre in holes.centres),
        diameter=_times(holes.diameter, factor),
        depth=None if holes.depth is None else _times(holes.depth, factor),
        sink=sink,
    )


def _scaled_sketch(sketch: Sketch, factor: float) -> Sketch:
    loops = tuple(tuple(_scaled_edge(edge, factor) for edge in loop) for loop in sketch.loops)
    return replace(sketch, height=_times(sketch.height, factor), loops=loops)


def _scaled_edge(edge: OutlineEdge, factor: float) -> OutlineEdge:
    circle = edge.circle and Circle(
        _point(edge.circle.centre, factor), _times(edge.circle.radius, factor)
    )
    start, end = _point(edge.start, factor), _point(edge.end, factor)
    return replace(edge, start=start, end=end, circle=circle)


def _point(point: Point, factor: float) -> Point:
    return _times(point[0], factor), _times(point[1], factor)


def _times(value: float, factor: float) -> float:
    return round(value * factor, _DIGITS) + 0.0
