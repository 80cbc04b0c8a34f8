"""Features as plain values: ``features.json``."""

from collections.abc import Iterable, Sequence
from typing import Any

from gaussiancad_core.features.constraints import Numbers, constraints_of
from gaussiancad_core.features.dimension_names import dimension_names
from gaussiancad_core.features.feature_model import (
    EdgeBreak,
    Extrusion,
    Feature,
    FeatureList,
    Holes,
    Sketch,
    Turning,
)
from gaussiancad_core.features.frames import MAIN_FRAMES, Frame
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.pattern_values import pattern_values
from gaussiancad_core.features.patterns import patterns_of
from gaussiancad_core.features.support_values import with_standing
from gaussiancad_core.features.thread_notes import threads_of
from gaussiancad_core.geometry.outline_edges import OutlineEdge, whole_circle
from gaussiancad_core.geometry.whole_curves import Circle

SCHEMA = "gaussiancad-features/1"

FEATURES_FILE = "features.json"
"""In the output folder."""


def named(features: Sequence[Feature]) -> list[tuple[str, Feature]]:
    """Features with names that tell what they are, each its own."""
    counts: dict[str, int] = {}
    found = []
    for feature in features:
        kind = kind_of(feature).capitalize()
        counts[kind] = counts.get(kind, 0) + 1
        found.append((f"{kind}{counts[kind]}", feature))
    return found


def kind_of(feature: Feature) -> str:
    """What a feature is: ``pad``, ``pocket``, ``revolution``, ``groove``, ``hole``, ``fillet`` or
    ``chamfer``."""
    if isinstance(feature, Extrusion):
        return "pad" if feature.adds else "pocket"
    if isinstance(feature, Turning):
        return "revolution" if feature.adds else "groove"
    if isinstance(feature, Holes):
        return "hole"
    return "fillet" if feature.is_round else "chamfer"


def solid_values(found: FeatureList, numbers: Numbers, base: str | None) -> dict[str, Any]:
    """A solid's features as plain values.

    Args:
        found: its features.
        numbers: of the drawing.
        base: name of the file of the base that they stand over; None of a whole solid.
    """
    features = [feature_values(name, each, numbers) for name, each in named(found.features)]
    for number, thread in threads_of(found.features, numbers.threads).items():
        features[number] |= {"thread": thread.name, "thread_depth": thread.depth}
    features = with_standing(found.features, features)
    names = [feature["name"] for feature in features]
    patterns = pattern_values(patterns_of(found.features), names, numbers)
    return {"whole": found.is_whole, "base": base, "features": features, "patterns": patterns}


def feature_values(name: str, feature: Feature, numbers: Numbers) -> dict[str, Any]:
    """A feature as plain values; each number with where it is from."""
    values: dict[str, Any] = {"kind": kind_of(feature), "name": name}
    if isinstance(feature, EdgeBreak):
        values |= {"size": feature.size, "places": [list(place) for place in feature.places]}
        return {**values, "sources": _sources(values, ("size",), numbers)}
    if isinstance(feature, Holes):
        return _holes(values, feature, numbers)
    values |= {"sketch": _sketch(feature.sketch, numbers)}
    if isinstance(feature, Extrusion):
        values |= {"length": feature.length}
        return {**values, "sources": _sources(values, ("length",), numbers)}
    axis = {"point": list(feature.point), "direction": list(feature.direction)}
    return {**values, "axis": axis, "sources": {}}


def _holes(values: dict[str, Any], holes: Holes, numbers: Numbers) -> dict[str, Any]:
    radius = holes.diameter / 2.0
    circles = [(whole_circle(Circle(centre, radius)),) for centre in holes.centres]
    sink = holes.sink
    values |= {
        "plane": _plane(holes.frame, holes.height),
        "centres": [list(centre) for centre in holes.centres],
        "constraints": _constraints(circles, numbers),
        "downward": holes.is_downward,
        "diameter": holes.diameter,
        "depth": holes.depth,
        "tip_degrees": holes.tip,
        "sink": None,
    }
    if sink is not None:
        widening = {"diameter": sink.diameter, "depth": sink.depth, "degrees": sink.angle}
        sources = _sources(widening, ("diameter", "depth"), numbers)
        values |= {"sink": {**widening, "sources": sources}}
    return {**values, "sources": _sources(values, ("diameter", "depth"), numbers)}


def _sources(values: dict[str, Any], names: Iterable[str], numbers: Numbers) -> dict[str, str]:
    return {
        name: numbers.source_of(values[name]).value for name in names if values[name] is not None
    }


def _plane(frame: Frame, height: float) -> dict[str, Any]:
    return {
        "name": frame.name if frame in MAIN_FRAMES else None,
        "right": list(frame.right),
        "up": list(frame.up),
        "normal": list(frame.normal),
        "offset": height,
    }


def _sketch(sketch: Sketch, numbers: Numbers) -> dict[str, Any]:
    return {
        "plane": _plane(sketch.frame, sketch.height),
        "geometry": [_edge(edge) for loop in sketch.loops for edge in loop],
        "constraints": _constraints(sketch.loops, numbers),
    }


def _constraints(loops: Sequence[Loop], numbers: Numbers) -> list[dict[str, Any]]:
    found = constraints_of(loops, numbers)
    names = dimension_names(found, [edge for loop in loops for edge in loop])
    values = []
    for constraint, name in zip(found, names, strict=True):
        value: dict[str, Any] = {
            "kind": constraint.kind.value,
            "of": [
                [reference.element, None if reference.spot is None else reference.spot.value]
                for reference in constraint.of
            ],
        }
        if constraint.value is not None:
            source = numbers.source_of(constraint.value)
            if constraint.source is not None:
                source = constraint.source
            value |= {"name": name, "value": constraint.value, "source": source.value}
        values.append(value)
    return values


def _edge(edge: OutlineEdge) -> dict[str, Any]:
    ends = {"start": edge.start, "end": edge.end}
    if edge.circle is None:
        return {"kind": "line", **ends}
    circle = {"centre": edge.circle.centre, "radius": edge.circle.radius}
    if edge.is_circle:
        return {"kind": "circle", **circle}
    return {"kind": "arc", **ends, **circle, "counterclockwise": edge.is_ccw}
