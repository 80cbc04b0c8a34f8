"""What a ``features.json`` of the engine says: for each solid what makes it, in order."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.body_model import (
    Condition,
    Curve,
    EdgeBreak,
    Extrusion,
    Feature,
    Holes,
    Number,
    Plane,
    PlaneSketch,
    Point,
    Sink,
    SolidFeatures,
    Support,
    Triple,
    Turning,
)

FEATURES_FILE = "features.json"
"""What the engine leaves in the job's folder."""

SCHEMA = "gaussiancad-features/1"


def read_features(path: Path) -> tuple[SolidFeatures, ...]:
    """The features in a file of the engine, for each solid.

    Raises:
        WorkbenchError: the file cannot be read, or is of another kind.
    """
    try:
        values = json.loads(path.read_text(encoding="utf-8"))
        if values["schema"] != SCHEMA:
            raise ValueError(f"{values['schema']} instead of {SCHEMA}")
        solids = tuple(_solid(solid, path.parent) for solid in values["solids"])
        if not solids:
            raise ValueError("no solids")
    except (OSError, ValueError, TypeError, LookupError, AttributeError) as error:
        text = translate(
            "GaussianCAD", "The engine's file {path} cannot be read ({reason}). Run it again."
        )
        message = text.format(path=path, reason=error)
        raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, message) from error
    return solids


def _solid(values: dict[str, Any], folder: Path) -> SolidFeatures:
    base = values.get("base")
    # Only the name: a file that lies beside this one, whatever it says.
    beneath = None if base is None else folder / Path(base).name
    features = tuple(_READERS[feature["kind"]](feature) for feature in values["features"])
    return SolidFeatures(features, beneath)


def _extrusion(values: dict[str, Any]) -> Extrusion:
    sketch, length = _sketch(values["sketch"]), float(values["length"])
    numbers = _numbers(values, {"length": "Length"})
    supports = _support(values, "stands_on"), _support(values, "ends_at")
    return Extrusion(values["kind"], str(values["name"]), sketch, length, numbers, *supports)


def _turning(values: dict[str, Any]) -> Turning:
    axis = values["axis"]
    return Turning(
        values["kind"],
        str(values["name"]),
        _sketch(values["sketch"]),
        _point(axis["point"]),
        _point(axis["direction"]),
    )


def _holes(values: dict[str, Any]) -> Holes:
    diameter, depth, sink = float(values["diameter"]), values["depth"], values["sink"]
    circles = tuple(
        Curve("circle", centre=_point(centre), radius=diameter / 2.0)
        for centre in values["centres"]
    )
    return Holes(
        values["kind"],
        str(values["name"]),
        PlaneSketch(_plane(values["plane"]), circles, _conditions(values)),
        bool(values["downward"]),
        diameter,
        None if depth is None else float(depth),
        float(values["tip_degrees"]),
        None if sink is None else _sink(sink),
        _numbers(values, {"diameter": "Diameter", "depth": "Depth"})
        + _numbers(sink or {}, {"diameter": "HoleCutDiameter", "depth": "HoleCutDepth"}),
        _support(values, "stands_on"),
        _support(values, "ends_at"),
    )


def _support(values: dict[str, Any], key: str) -> Support | None:
    found = values.get(key)
    if found is None:
        return None
    dimensions = found.get("dimensions")
    if dimensions is not None:
        dimensions = tuple((str(name), int(way)) for name, way in dimensions.items())
    return Support(str(found["feature"]), str(found["side"]), dimensions)


def _sink(values: dict[str, Any]) -> Sink:
    return Sink(float(values["diameter"]), float(values["depth"]), float(values["degrees"]))


def _edge_break(values: dict[str, Any]) -> EdgeBreak:
    places = tuple(_triple(place) for place in values["places"])
    kind, size = values["kind"], float(values["size"])
    numbers = _numbers(values, {"size": "Radius" if kind == "fillet" else "Size"})
    return EdgeBreak(kind, str(values["name"]), size, places, numbers)


def _numbers(values: dict[str, Any], properties: dict[str, str]) -> tuple[Number, ...]:
    """Numbers of a feature that say where they are from; a depth of 0 is none.

    Args:
        values: of the feature, or of what widens a hole.
        properties: FreeCAD's names of the numbers by those in the file.
    """
    sources = values.get("sources") or {}
    return tuple(
        Number(properties[name], abs(float(values[name])), str(source))
        for name, source in sources.items()
        if name in properties and values[name]
    )


def _sketch(values: dict[str, Any]) -> PlaneSketch:
    curves = tuple(_curve(curve) for curve in values["geometry"])
    return PlaneSketch(_plane(values["plane"]), curves, _conditions(values))


def _plane(values: dict[str, Any]) -> Plane:
    directions = (_triple(values[name]) for name in ("right", "up", "normal"))
    return Plane(values["name"] or "", *directions, float(values["offset"]))


def _curve(values: dict[str, Any]) -> Curve:
    kind = values["kind"]
    if kind == "line":
        return Curve(kind, _point(values["start"]), _point(values["end"]))
    centre, radius = _point(values["centre"]), float(values["radius"])
    if kind == "circle":
        return Curve(kind, centre=centre, radius=radius)
    if kind != "arc":
        raise ValueError(f"a curve {kind}")
    ends = _point(values["start"]), _point(values["end"])
    return Curve(kind, *ends, centre, radius, bool(values["counterclockwise"]))


def _conditions(values: dict[str, Any]) -> tuple[Condition, ...]:
    return tuple(_condition(condition) for condition in values.get("constraints") or ())


def _condition(values: dict[str, Any]) -> Condition:
    value = values.get("value")
    return Condition(
        values["kind"],
        tuple((int(number), point or "") for number, point in values["of"]),
        None if value is None else float(value),
        str(values.get("name") or ""),
        str(values.get("source") or ""),
    )


def _point(values: list[float]) -> Point:
    x, y = values
    return float(x), float(y)


def _triple(values: list[float]) -> Triple:
    x, y, z = values
    return float(x), float(y), float(z)


_READERS: dict[str, Callable[[dict[str, Any]], Feature]] = {
    "pad": _extrusion,
    "pocket": _extrusion,
    "revolution": _turning,
    "groove": _turning,
    "hole": _holes,
    "fillet": _edge_break,
    "chamfer": _edge_break,
}
