"""Features as a build123d script: parameters by name at the top, the solid when it is run."""

from collections.abc import Iterator, Sequence
from typing import Any

from gaussiancad_core.features.script_patterns import REPEATING, Repeats

SCRIPT_FILE = "features.py"
"""In the output folder."""

_HEAD = '''"""A part by its features; written by GaussianCAD.

It needs build123d (pip install build123d).  Run it to write {stem}.step; change a number first to
have another part.  Lengths are mm.
"""

from math import cos, hypot, radians, sin, tan

from build123d import *


def plane(origin, right, normal):
    return Plane(origin=origin, x_dir=right, z_dir=normal)


def arc(start, end, centre, is_counterclockwise):
    """The arc around a centre; the radius is that of its start."""
    from math import atan2, pi

    radius = hypot(start[0] - centre[0], start[1] - centre[1])
    first = atan2(start[1] - centre[1], start[0] - centre[0])
    last = atan2(end[1] - centre[1], end[0] - centre[0])
    turn = (last - first) % (2 * pi) if is_counterclockwise else -((first - last) % (2 * pi))
    middle = first + turn / 2
    return ThreePointArc(
        start,
        (centre[0] + radius * cos(middle), centre[1] + radius * sin(middle)),
        end,
    )


def region(outlines):
    """The face between outlines: the first one is around the others."""
    outer, *holes = (make_face(Wire(edges)) for edges in outlines)
    for hole in holes:
        outer -= hole
    return outer


def nearest(part, place):
    return min(part.edges(), key=lambda edge: edge.distance_to(Vector(place)))


def drilled(where, centre, diameter, depth, tip, sink):
    """What a drill takes away that enters a plane against its normal."""
    at = where.location * Location((*centre, 0))
    radius = diameter / 2
    body = at * Location((0, 0, -depth / 2)) * Cylinder(radius, depth)
    if tip:
        length = radius / tan(radians(tip) / 2)
        body += at * Location((0, 0, -depth - length / 2)) * Cone(0, radius, length)
    if sink:
        wide, deep, angle = sink
        if angle:
            length = (wide / 2 - radius) / tan(radians(angle) / 2)
            body += at * Location((0, 0, -length / 2)) * Cone(radius, wide / 2, length)
        else:
            body += at * Location((0, 0, -deep / 2)) * Cylinder(wide / 2, deep)
    return body


{repeating}
THROUGH = {through!r}  # mm, longer than the part

'''


def script_of(solids: Sequence[dict[str, Any]], stem: str = "part") -> str:
    """The script of solids.

    Args:
        solids: as :func:`.as_json.solid_values` has them.
        stem: of the STEP file that it writes.
    """
    parameters: list[str] = []
    body: list[str] = []
    for number, solid in enumerate(solids, 1):
        part = f"part{number}" if len(solids) > 1 else "part"
        if solid["base"] is not None:
            body.append(f"{part} = Part() + import_step({solid['base']!r})")
        else:
            body.append(f"{part} = Part()")
        repeats = Repeats(solid["patterns"], part.upper() + "_" if len(solids) > 1 else "")
        for feature in solid["features"]:
            prefix = f"{part}_{feature['name']}" if len(solids) > 1 else feature["name"]
            writer = _Writer(prefix.upper(), part, repeats)
            body += writer.lines(feature)
            parameters += writer.parameters
        parameters += repeats.parameters
    names = [f"part{k}" for k in range(1, len(solids) + 1)] if len(solids) > 1 else ["part"]
    whole = names[0] if len(names) == 1 else f"Compound([{', '.join(names)}])"
    ends = ["", f"export_step({whole}, {stem + '.step'!r})", ""]
    repeating = REPEATING if any(solid["patterns"] for solid in solids) else ""
    head = _HEAD.format(stem=stem, through=_reach(solids), repeating=repeating)
    return "\n".join([head + "\n".join(parameters), "", *body, *ends])


def _reach(solids: Sequence[dict[str, Any]]) -> float:
    """mm that a hole through any of the solids is long."""
    far = 1.0
    for solid in solids:
        for feature in solid["features"]:
            sketch = feature.get("sketch", feature)
            values = [
                abs(feature.get("length", 0.0)),
                abs(sketch.get("plane", {}).get("offset", 0.0)),
            ]
            for edge in sketch.get("geometry", ()):
                for key in ("start", "end", "centre"):
                    values += [abs(value) for value in edge.get(key, ())]
            far = max(far, *values)
    return round(8.0 * far, 1)


class _Writer:
    """Lines of one feature.

    Args:
        prefix: of its parameters' names.
        part: name of the variable that it changes.
        repeats: patterns that it may be in.
    """

    def __init__(self, prefix: str, part: str, repeats: Repeats) -> None:
        self.parameters: list[str] = []
        self._prefix, self._part, self._repeats = prefix, part, repeats
        self._known: dict[tuple[str, float], str] = {}

    def lines(self, feature: dict[str, Any]) -> list[str]:
        """What makes a feature; nothing where another one that repeats makes it."""
        kind = feature["kind"]
        if self._repeats.is_made_elsewhere(feature):
            return []
        thread = f": {feature['thread']}, which is not cut" if "thread" in feature else ""
        found = ["", f"# {feature['name']}{thread}"]
        if kind in ("fillet", "chamfer"):
            size = self._parameter("SIZE", feature["size"], feature["sources"]["size"])
            edges = ", ".join(f"nearest({self._part}, {tuple(p)!r})" for p in feature["places"])
            return [*found, f"{self._part} = {kind}([{edges}], {size})"]
        if kind == "hole":
            return [*found, *self._holes(feature)]
        name = feature["name"].lower()
        sketch = feature["sketch"]
        found += [f"{name}_plane = {self._plane(sketch['plane'])}", f"{name} = region(["]
        found += [f"    [{', '.join(edges)}]," for edges in self._outlines(sketch)]
        found.append("])")
        if kind in ("pad", "pocket"):
            length = self._parameter("LENGTH", abs(feature["length"]), feature["sources"]["length"])
            way = "" if feature["length"] > 0.0 else "-"
            body = f"extrude({name}_plane.location * {name}, {way}{length})"
        else:
            (x, y), (dx, dy) = feature["axis"]["point"], feature["axis"]["direction"]
            axis = f"Axis(({x!r}, {y!r}, 0), ({dx!r}, {dy!r}, 0))"
            body = f"{name}_plane.location * revolve({name}, {axis})"
        sign = "+=" if kind in ("pad", "revolution") else "-="
        return [*found, *self._repeats.made(feature["name"], None, f"{self._part} {sign}", body)]

    def _holes(self, feature: dict[str, Any]) -> Iterator[str]:
        sources, sink = feature["sources"], feature["sink"]
        diameter = self._parameter("DIAMETER", feature["diameter"], sources["diameter"])
        depth = "THROUGH"
        if feature["depth"] is not None:
            depth = self._parameter("DEPTH", feature["depth"], sources["depth"])
        plane = dict(feature["plane"])
        flip = 1.0
        if not feature["downward"]:
            # A drill goes against the normal of its plane.
            plane["normal"] = [-value for value in plane["normal"]]
            plane["offset"] = -plane["offset"]
            flip = -1.0
        name = feature["name"].lower()
        yield f"{name}_plane = {self._plane(plane)}"
        widening = "None"
        if sink is not None:
            wide = self._parameter("SINK_DIAMETER", sink["diameter"], sink["sources"]["diameter"])
            deep = self._parameter("SINK_DEPTH", sink["depth"], "measured") if sink["depth"] else 0
            widening = f"({wide}, {deep}, {sink['degrees']!r})"
        for number, (x, y) in enumerate(feature["centres"]):
            if self._repeats.is_image(feature["name"], number):
                continue
            centre = self._repeats.centre(feature, number)
            if centre is None:
                # With the normal turned, up runs the other way.
                centre = f"({self._place('X', x)}, {'-' if flip < 0 else ''}{self._place('Y', y)})"
            body = (
                f"drilled({name}_plane, {centre}, {diameter}, {depth}, "
                f"{feature['tip_degrees']!r}, {widening})"
            )
            yield from self._repeats.made(feature["name"], number, f"{self._part} -=", body)

    def _outlines(self, sketch: dict[str, Any]) -> Iterator[list[str]]:
        """Edges of each outline."""
        run: list[str] = []
        start: list[float] | None = None
        for edge in sketch["geometry"]:
            if edge["kind"] == "circle":
                radius = self._parameter("RADIUS", edge["radius"], "")
                yield [
                    f"*Circle({radius}).moved(Location({self._point(edge['centre'], 3)})).edges()"
                ]
                continue
            start = list(edge["start"]) if start is None else start
            run.append(self._edge(edge))
            if list(edge["end"]) == start:
                yield run
                run, start = [], None

    def _edge(self, edge: dict[str, Any]) -> str:
        ends = f"{self._point(edge['start'])}, {self._point(edge['end'])}"
        if edge["kind"] == "line":
            return f"Line({ends})"
        return f"arc({ends}, {self._point(edge['centre'])}, {edge['counterclockwise']!r})"

    def _point(self, point: Sequence[float], count: int = 2) -> str:
        x, y = self._place("X", point[0]), self._place("Y", point[1])
        return f"({x}, {y})" if count == 2 else f"({x}, {y}, 0)"

    def _place(self, axis: str, value: float) -> str:
        """A coordinate: a parameter of its own, but for 0."""
        if abs(value) < 1e-9:
            return "0"
        sign = "-" if value < 0.0 else ""
        return sign + self._parameter(axis, abs(value), "")

    def _parameter(self, stem: str, value: float, source: str) -> str:
        """The name of a number, made once."""
        key = stem, round(value, 6)
        if key not in self._known:
            count = sum(1 for known, _ in self._known if known == stem) + 1
            name = f"{self._prefix}_{stem}{count if stem in ('X', 'Y', 'RADIUS') else ''}"
            self._known[key] = name
            note = "  # on the sheet" if source == "sheet" else ""
            self.parameters.append(f"{name} = {round(value, 9)!r}{note}")
        return self._known[key]

    def _plane(self, plane: dict[str, Any]) -> str:
        origin = tuple(round(plane["offset"] * part, 9) + 0.0 for part in plane["normal"])
        return f"plane({origin!r}, {tuple(plane['right'])!r}, {tuple(plane['normal'])!r})"
