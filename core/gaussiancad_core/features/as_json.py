"""Features as plain values: ``features.json``."""

from collections.abc import Sequence
from typing import Any

from gaussiancad_core.features.loops import Edge
from gaussiancad_core.features.model import EdgeBreak, Extrusion, Feature, Holes, Sketch, Turning

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


def feature_values(name: str, feature: Feature) -> dict[str, Any]:
    """A feature as plain values."""
    values: dict[str, Any] = {"kind": kind_of(feature), "name": name}
    if isinstance(feature, EdgeBreak):
        return {**values, "size": feature.size, "places": [list(p) for p in feature.places]}
    if isinstance(feature, Holes):
        sink = feature.sink
        return {
            **values,
            "plane": _plane(feature.frame, feature.height),
            "centres": [list(centre) for centre in feature.centres],
            "downward": feature.is_downward,
            "diameter": feature.diameter,
            "depth": feature.depth,
            "tip_degrees": feature.tip,
            "sink": None
            if sink is None
            else {"diameter": sink.diameter, "depth": sink.depth, "degrees": sink.angle},
        }
    values |= {"sketch": _sketch(feature.sketch)}
    if isinstance(feature, Extrusion):
        return {**values, "length": feature.length}
    return {**values, "axis": {"point": feature.point, "direction": feature.direction}}


def _plane(frame: Any, height: float) -> dict[str, Any]:
    return {
        "name": frame.name if frame.name in ("XY", "XZ", "YZ") else None,
        "right": list(frame.right),
        "up": list(frame.up),
        "normal": list(frame.normal),
        "offset": height,
    }


def _sketch(sketch: Sketch) -> dict[str, Any]:
    return {
        "plane": _plane(sketch.frame, sketch.height),
        "geometry": [_edge(edge) for loop in sketch.loops for edge in loop],
    }


def _edge(edge: Edge) -> dict[str, Any]:
    if edge.is_circle:
        return {"kind": "circle", "centre": edge.centre, "radius": edge.radius}
    ends = {"start": edge.start, "end": edge.end}
    if edge.centre is None:
        return {"kind": "line", **ends}
    arc = {"centre": edge.centre, "radius": edge.radius, "counterclockwise": edge.is_ccw}
    return {"kind": "arc", **ends, **arc}
