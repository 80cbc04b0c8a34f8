"""Solids and features at another size, so that the room's tolerances are plain numbers."""

from dataclasses import replace

from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.loops import Edge
from gaussiancad_core.features.model import EdgeBreak, Extrusion, Feature, Holes, Sketch, Turning


def scaled_shape(shape: TopoDS_Shape, factor: float) -> TopoDS_Shape:
    """A shape as many times as large, the origin staying where it is."""
    motion = gp_Trsf()
    motion.SetScale(gp_Pnt(0.0, 0.0, 0.0), factor)
    return BRepBuilderAPI_Transform(shape, motion, True).Shape()


def scaled(feature: Feature, factor: float) -> Feature:
    """A feature as many times as large."""
    if isinstance(feature, Extrusion):
        sketch = _scaled_sketch(feature.sketch, factor)
        return replace(feature, sketch=sketch, length=feature.length * factor)
    if isinstance(feature, Turning):
        x, y = feature.point
        sketch = _scaled_sketch(feature.sketch, factor)
        return replace(feature, sketch=sketch, point=(x * factor, y * factor))
    if isinstance(feature, EdgeBreak):
        places = tuple((x * factor, y * factor, z * factor) for x, y, z in feature.places)
        other = None if feature.other is None else feature.other * factor
        return replace(feature, places=places, size=feature.size * factor, other=other)
    return _scaled_holes(feature, factor)


def _scaled_holes(holes: Holes, factor: float) -> Holes:
    sink = holes.sink
    if sink is not None:
        sink = replace(sink, diameter=sink.diameter * factor, depth=sink.depth * factor)
    return replace(
        holes,
        height=holes.height * factor,
        centres=tuple((x * factor, y * factor) for x, y in holes.centres),
        diameter=holes.diameter * factor,
        depth=None if holes.depth is None else holes.depth * factor,
        sink=sink,
    )


def _scaled_sketch(sketch: Sketch, factor: float) -> Sketch:
    loops = tuple(tuple(_scaled_edge(edge, factor) for edge in loop) for loop in sketch.loops)
    return replace(sketch, height=sketch.height * factor, loops=loops)


def _scaled_edge(edge: Edge, factor: float) -> Edge:
    points = (edge.start, edge.end, edge.centre)
    start, end, centre = (
        None if point is None else (point[0] * factor, point[1] * factor) for point in points
    )
    assert start is not None
    assert end is not None
    radius = None if edge.radius is None else edge.radius * factor
    return Edge(start, end, centre, radius, edge.is_ccw)
