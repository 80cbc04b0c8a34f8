"""Sketches of a body on the planes of its origin, at an offset: never on a face, whose number
changes with the shape."""

from collections.abc import Iterable
from math import atan2, hypot

import FreeCAD
import Part

from freecad.gaussiancad.objects.body_model import Condition, Curve, Plane, PlaneSketch, Point
from freecad.gaussiancad.objects.sketch_conditions import constrain, fix

_Z = FreeCAD.Vector(0.0, 0.0, 1.0)


def add_sketch(
    body: FreeCAD.DocumentObject, name: str, drawn: PlaneSketch
) -> tuple[FreeCAD.DocumentObject, tuple[Condition, ...]]:
    """Add a sketch to a body.

    Args:
        body: receives it.
        name: of the sketch.
        drawn: its plane, curves and conditions.

    Returns:
        The sketch, hidden, and those of the conditions that hold.

    Raises:
        ValueError: a condition is not one that FreeCAD knows.
    """
    sketch = body.newObject("Sketcher::SketchObject", name)
    sketch.Label = name
    attach(body, sketch, drawn.plane)
    sketch.addGeometry([_geometry(curve) for curve in drawn.curves], False)
    kept = constrain(sketch, drawn.curves, drawn.conditions)
    sketch.Visibility = False
    return sketch, kept


def attach(body: FreeCAD.DocumentObject, sketch: FreeCAD.DocumentObject, plane: Plane) -> None:
    """Put a sketch on a plane of the body's origin; an oblique one stands over the XY plane."""
    role = f"{plane.name or 'XY'}_Plane"
    support = next(each for each in body.Origin.OriginFeatures if each.Role == role)
    # FreeCAD 1.0 renamed it.
    name = "AttachmentSupport" if hasattr(sketch, "AttachmentSupport") else "Support"
    setattr(sketch, name, (support, [""]))
    sketch.MapMode = "FlatFace"
    sketch.AttachmentOffset = _offset(plane)


def add_axis(
    sketch: FreeCAD.DocumentObject, curves: Iterable[Curve], point: Point, direction: Point
) -> None:
    """Draw the axis of a turning into its sketch, as long as the outline, as construction line.

    Raises:
        ValueError: the direction has no length.
    """
    size = hypot(*direction)
    if size == 0.0:
        raise ValueError("an axis without direction")
    x, y = direction[0] / size, direction[1] / size
    along = [
        (end[0] - point[0]) * x + (end[1] - point[1]) * y
        for curve in curves
        for end in (curve.start, curve.end, curve.centre)
    ]
    ends = (FreeCAD.Vector(point[0] + t * x, point[1] + t * y, 0.0) for t in _span(along))
    number = sketch.addGeometry(Part.LineSegment(*ends), True)
    fix(sketch, [number])


def _span(values: list[float]) -> tuple[float, float]:
    low, high = min(values), max(values)
    return (low, high) if high > low else (low, low + 1.0)


def _offset(plane: Plane) -> FreeCAD.Placement:
    if plane.name:
        return FreeCAD.Placement(FreeCAD.Vector(0.0, 0.0, plane.offset), FreeCAD.Rotation())
    right, up, normal = (FreeCAD.Vector(*v) for v in (plane.right, plane.up, plane.normal))
    return FreeCAD.Placement(normal * plane.offset, FreeCAD.Rotation(right, up, normal))


def _geometry(curve: Curve) -> object:
    if curve.kind == "line":
        return Part.LineSegment(*(FreeCAD.Vector(*end, 0.0) for end in (curve.start, curve.end)))
    circle = Part.Circle(FreeCAD.Vector(*curve.centre, 0.0), _Z, curve.radius)
    if curve.kind == "circle":
        return circle
    first, last = (
        atan2(end[1] - curve.centre[1], end[0] - curve.centre[0])
        for end in (curve.start, curve.end)
    )
    if not curve.counterclockwise:
        first, last = last, first
    return Part.ArcOfCircle(circle, first, last)
