"""Sketches of a body on the planes of its origin, at an offset: never on a face, whose number
changes with the shape."""

from collections.abc import Iterator, Sequence
from math import atan2, hypot

import FreeCAD
import Part
import Sketcher

from freecad.gaussiancad.objects.body_model import Condition, Curve, Plane, PlaneSketch, Point
from freecad.gaussiancad.objects.sketch_conditions import constrain, fix, reference

_Z = FreeCAD.Vector(0.0, 0.0, 1.0)

_ON_AXIS = 1e-6
"""mm from an axis within which a point lies on it."""


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
    sketch: FreeCAD.DocumentObject, curves: Sequence[Curve], point: Point, direction: Point
) -> None:
    """Draw the axis of a turning into its sketch, as construction line.

    Where the outline has two points on it, it goes with them when a number moves them; elsewhere it
    is as long as the outline, and fixed.

    Raises:
        ValueError: the direction has no length.
    """
    size = hypot(*direction)
    if size == 0.0:
        raise ValueError("an axis without direction")
    x, y = direction[0] / size, direction[1] / size
    offsets = [((end[0] - point[0], end[1] - point[1]), of) for end, of in _ends(curves)]
    along = [dx * x + dy * y for (dx, dy), _ in offsets]
    on_axis = sorted(
        (place, of)
        for place, ((dx, dy), of) in zip(along, offsets, strict=True)
        if abs(dx * y - dy * x) < _ON_AXIS and of[1] != "centre"
    )
    tied = len(on_axis) > 1 and on_axis[-1][0] - on_axis[0][0] > _ON_AXIS
    span = (on_axis[0][0], on_axis[-1][0]) if tied else _span(along)
    places = (FreeCAD.Vector(point[0] + t * x, point[1] + t * y, 0.0) for t in span)
    number = sketch.addGeometry(Part.LineSegment(*places), True)
    if not tied:
        fix(sketch, [number])
        return
    for spot, (_, of) in ((1, on_axis[0]), (2, on_axis[-1])):
        place = reference(of, curves)
        sketch.addConstraint(Sketcher.Constraint("Coincident", number, spot, *place))


def _ends(curves: Sequence[Curve]) -> Iterator[tuple[Point, tuple[int, str]]]:
    """Points of curves, and how conditions name them."""
    for number, curve in enumerate(curves):
        spots = {"line": ("start", "end"), "circle": ("centre",)}
        for spot in spots.get(curve.kind, ("start", "end", "centre")):
            yield getattr(curve, spot), (number, spot)


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
