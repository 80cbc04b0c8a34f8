"""One maker for each kind of feature of a body."""

from collections.abc import Callable

import FreeCAD
import Part

from freecad.gaussiancad.objects.body_model import (
    Condition,
    EdgeBreak,
    Extrusion,
    Feature,
    Holes,
    Triple,
    Turning,
)
from freecad.gaussiancad.objects.body_sketches import add_axis, add_sketch
from freecad.gaussiancad.objects.body_supports import Earlier, bind_length, bind_offset

_FULL_TURN = 360.0

_TYPES = {
    "pad": "PartDesign::Pad",
    "pocket": "PartDesign::Pocket",
    "revolution": "PartDesign::Revolution",
    "groove": "PartDesign::Groove",
    "hole": "PartDesign::Hole",
    "fillet": "PartDesign::Fillet",
    "chamfer": "PartDesign::Chamfer",
}


def add_feature(
    body: FreeCAD.DocumentObject, feature: Feature, earlier: Earlier
) -> tuple[Condition, ...]:
    """Add a feature to a body, with its sketch, and compute it.

    Args:
        body: receives it; its tip is the feature afterwards.
        feature: what is made.
        earlier: the features that the body has.

    Returns:
        The conditions that hold in its sketch.

    Raises:
        ValueError: it cannot be made; the body may be broken now.
    """
    beneath = body.Tip
    kept = _MAKERS[type(feature)](body, feature, earlier)
    body.Document.recompute()
    made = body.Tip
    if made is beneath or not made.isValid() or made.Shape.isNull():
        raise ValueError(made.getStatusString())
    if beneath is not None:
        beneath.Visibility = False
    return kept


def _new(body: FreeCAD.DocumentObject, feature: Feature) -> FreeCAD.DocumentObject:
    made = body.newObject(_TYPES[feature.kind], feature.name)
    made.Label = feature.name
    if hasattr(made, "Refine"):
        # Faces that go on over two features are one, as they are in the solid.
        made.Refine = True
    return made


def _extrude(
    body: FreeCAD.DocumentObject, feature: Extrusion, earlier: Earlier
) -> tuple[Condition, ...]:
    sketch, kept = add_sketch(body, f"{feature.name}Sketch", feature.sketch)
    bind_offset(sketch, feature.sketch.plane, feature.stands_on, earlier)
    made = _new(body, feature)
    made.Profile = sketch
    made.Length = abs(feature.length)
    bind_length(made, "Length", feature, earlier)
    # FreeCAD's pads go along the normal, its pockets against it.
    made.Reversed = (feature.length < 0.0) == (feature.kind == "pad")
    return kept


def _turn(body: FreeCAD.DocumentObject, feature: Turning, _: Earlier) -> tuple[Condition, ...]:
    sketch, kept = add_sketch(body, f"{feature.name}Sketch", feature.sketch)
    add_axis(sketch, feature.sketch.curves, feature.point, feature.direction)
    made = _new(body, feature)
    made.Profile = sketch
    made.ReferenceAxis = (sketch, ["Axis0"])
    made.Angle = _FULL_TURN
    return kept


def _drill(body: FreeCAD.DocumentObject, feature: Holes, earlier: Earlier) -> tuple[Condition, ...]:
    sketch, kept = add_sketch(body, f"{feature.name}Sketch", feature.sketch)
    bind_offset(sketch, feature.sketch.plane, feature.stands_on, earlier)
    # FreeCAD 0.20 refuses the numbers of a hole whose sketch is not computed.
    body.Document.recompute()
    made = _new(body, feature)
    made.Profile = sketch
    made.Reversed = not feature.downward
    made.Diameter = feature.diameter
    named = next((each for each in kept if each.kind == "diameter" and each.name), None)
    if named is not None:
        # FreeCAD takes a hole's place only from the circle: the number there drives the hole too.
        made.setExpression("Diameter", f"{sketch.Name}.Constraints.{named.name}")
    if feature.depth is None:
        made.DepthType = "ThroughAll"
    else:
        made.DepthType = "Dimension"
        made.Depth = feature.depth
        bind_length(made, "Depth", feature, earlier)
        made.DrillPoint = "Angled" if feature.tip_degrees else "Flat"
        if feature.tip_degrees:
            made.DrillPointAngle = feature.tip_degrees
            made.DrillForDepth = False
    sink = feature.sink
    if sink is not None:
        made.HoleCutType = "Countersink" if sink.degrees else "Counterbore"
        made.HoleCutCustomValues = True
        made.HoleCutDiameter = sink.diameter
        if sink.degrees:
            made.HoleCutCountersinkAngle = sink.degrees
        made.HoleCutDepth = sink.depth
    return kept


def _break_edges(
    body: FreeCAD.DocumentObject, feature: EdgeBreak, _: Earlier
) -> tuple[Condition, ...]:
    beneath = body.Tip
    names = dict.fromkeys(_edge_at(beneath.Shape, place) for place in feature.places)
    made = _new(body, feature)
    made.Base = (beneath, list(names))
    if feature.kind == "fillet":
        made.Radius = feature.size
    else:
        made.Size = feature.size
    return ()


def _edge_at(shape: Part.Shape, place: Triple) -> str:
    """Name of the edge that is nearest to a place; the seam of a face is none."""
    seams = {edge.hashCode() for face in shape.Faces for edge in face.Edges if edge.isSeam(face)}
    point = Part.Vertex(*place)
    distances = [
        (point.distToShape(edge)[0], number)
        for number, edge in enumerate(shape.Edges, start=1)
        if edge.hashCode() not in seams and not edge.Degenerated
    ]
    if not distances:
        raise ValueError("no edge")
    return f"Edge{min(distances)[1]}"


_MAKERS: dict[type, Callable[[FreeCAD.DocumentObject, Feature, Earlier], tuple[Condition, ...]]] = {
    Extrusion: _extrude,
    Turning: _turn,
    Holes: _drill,
    EdgeBreak: _break_edges,
}
