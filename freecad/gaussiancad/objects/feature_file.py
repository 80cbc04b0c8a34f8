"""What a ``features.json`` of the engine says: for each solid the features that make it, in order.

Lengths are in mm, angles in degrees.  Points of a sketch are (x, y) along the right and the up of
its plane; the length of an extrusion runs along the normal, a negative one against it.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate

FEATURES_FILE = "features.json"
"""What the engine leaves in the job's folder."""

SCHEMA = "gaussiancad-features/1"

ON_SHEET = "sheet"
"""Source of a number that somebody wrote on the drawing."""

Point = tuple[float, float]
Triple = tuple[float, float, float]


@dataclass(frozen=True)
class Plane:
    """Where a sketch lies.

    Attributes:
        name: of the origin plane whose directions these are, ``XY``, ``XZ`` or ``YZ``; empty of an
            oblique one.
        right, up, normal: unit vectors.
        offset: mm along the normal, from the origin.
    """

    name: str
    right: Triple
    up: Triple
    normal: Triple
    offset: float


@dataclass(frozen=True)
class Curve:
    """A line, an arc or a circle of a sketch.

    Attributes:
        kind: ``line``, ``arc`` or ``circle``.
        start, end: of a line or an arc, mm.
        centre, radius: of an arc or a circle, mm.
        counterclockwise: which way an arc runs from its start to its end.
    """

    kind: str
    start: Point = (0.0, 0.0)
    end: Point = (0.0, 0.0)
    centre: Point = (0.0, 0.0)
    radius: float = 0.0
    counterclockwise: bool = True


@dataclass(frozen=True)
class Condition:
    """A constraint of a sketch.

    Attributes:
        kind: such as ``coincident`` or ``distance-x``.
        of: (number of a curve, ``start``, ``end``, ``centre`` or empty for the whole curve); of the
            curve -1 the start is the origin.
        value: mm; None where the kind has none.
        name: of the number, or empty.
        source: ``sheet`` of a number that the drawing tells, ``measured`` of others.
    """

    kind: str
    of: tuple[tuple[int, str], ...]
    value: float | None = None
    name: str = ""
    source: str = ""


@dataclass(frozen=True)
class PlaneSketch:
    """Closed outlines on a plane; without conditions they stay as they are."""

    plane: Plane
    curves: tuple[Curve, ...]
    conditions: tuple[Condition, ...] = ()


@dataclass(frozen=True)
class Extrusion:
    """A pad or a pocket: an outline moved along its plane's normal by a length in mm."""

    kind: str
    name: str
    sketch: PlaneSketch
    length: float


@dataclass(frozen=True)
class Turning:
    """A revolution or a groove: an outline in a full turn about a line of its plane, through the
    point along the direction."""

    kind: str
    name: str
    sketch: PlaneSketch
    point: Point
    direction: Point


@dataclass(frozen=True)
class Sink:
    """What widens a hole at its mouth: a counterbore with a depth in mm, or a countersink with an
    angle in degrees; the other one is 0."""

    diameter: float
    depth: float
    degrees: float


@dataclass(frozen=True)
class Holes:
    """Like holes that begin on one plane.

    Attributes:
        kind, name: of the feature.
        sketch: a circle for each hole.
        downward: whether they are drilled against the plane's normal.
        diameter: mm.
        depth: mm from the plane to the end of the cylinder; None through all.
        tip_degrees: of the drill's point; 0 of a flat end.
        sink: at the mouth, or None.
    """

    kind: str
    name: str
    sketch: PlaneSketch
    downward: bool
    diameter: float
    depth: float | None
    tip_degrees: float
    sink: Sink | None


@dataclass(frozen=True)
class EdgeBreak:
    """A fillet of a radius or a chamfer of a width in mm, on the edges at some places."""

    kind: str
    name: str
    size: float
    places: tuple[Triple, ...]


Feature = Extrusion | Turning | Holes | EdgeBreak


@dataclass(frozen=True)
class SolidFeatures:
    """What makes a solid.

    Attributes:
        features: in the order in which they are made.
        base: STEP file of a solid that the features stand over, or None.
    """

    features: tuple[Feature, ...]
    base: Path | None = None

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """Those of all sketches."""
        sketches = [f.sketch for f in self.features if not isinstance(f, EdgeBreak)]
        return tuple(condition for sketch in sketches for condition in sketch.conditions)


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
    if not features:
        raise ValueError("a solid without features")
    return SolidFeatures(features, beneath)


def _extrusion(values: dict[str, Any]) -> Extrusion:
    sketch = _sketch(values["sketch"])
    return Extrusion(values["kind"], str(values["name"]), sketch, float(values["length"]))


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
    )


def _sink(values: dict[str, Any]) -> Sink:
    return Sink(float(values["diameter"]), float(values["depth"]), float(values["degrees"]))


def _edge_break(values: dict[str, Any]) -> EdgeBreak:
    places = tuple(_triple(place) for place in values["places"])
    return EdgeBreak(values["kind"], str(values["name"]), float(values["size"]), places)


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
