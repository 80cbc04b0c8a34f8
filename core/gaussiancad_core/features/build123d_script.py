"""Features as a build123d script: parameters by name at the top, the solid when it is run."""

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gaussiancad_core.features.script_head import HEAD
from gaussiancad_core.features.script_offsets import Terms, edge_place, less, turned, written
from gaussiancad_core.features.script_patterns import REPEATING, Repeats
from gaussiancad_core.features.supported_features import Side

SCRIPT_FILE = "features.py"
"""In the output folder."""

_COUNTED_STEMS = ("X", "Y", "RADIUS")
"""Of parameters that a feature may have several of."""

_COUNTED = tuple(f"_{stem}" for stem in _COUNTED_STEMS)


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
        writers: dict[str, _Writer] = {}
        lines: list[str] = []
        for feature in solid["features"]:
            prefix = f"{part}_{feature['name']}" if len(solids) > 1 else feature["name"]
            writer = _Writer(prefix.upper(), part, writers, repeats)
            lines += writer.lines(feature)
            writers[feature["name"]] = writer
        for writer in writers.values():
            lines = writer.settled(lines)
            parameters += writer.settled(writer.parameters)
        parameters += repeats.parameters
        body += lines
    names = [f"part{k}" for k in range(1, len(solids) + 1)] if len(solids) > 1 else ["part"]
    whole = names[0] if len(names) == 1 else f"Compound([{', '.join(names)}])"
    ends = ["", f"export_step({whole}, {stem + '.step'!r})", ""]
    repeating = REPEATING if any(solid["patterns"] for solid in solids) else ""
    head = HEAD.format(stem=stem, through=_reach(solids), repeating=repeating)
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
        earlier: writers of what was made before, by the features' names.
        repeats: patterns that it may be in.
    """

    def __init__(
        self, prefix: str, part: str, earlier: Mapping[str, "_Writer"], repeats: Repeats
    ) -> None:
        self.parameters: list[str] = []
        self._prefix, self._part, self._earlier = prefix, part, earlier
        self._repeats = repeats
        self._feature: dict[str, Any] = {}
        self._start: Terms = ()
        self._end: Terms = ()
        self._known: dict[tuple[str, float], str] = {}
        self._dimensioned: dict[tuple[str, float], tuple[str, str]] = {}

    def settled(self, lines: Sequence[str]) -> list[str]:
        """Lines in which what there is once has no number; once all were written."""
        known = set(self._known.values())
        single = [
            name[:-1]
            for name in known
            if name[:-1].endswith(_COUNTED) and f"{name[:-1]}2" not in known and name[-1] == "1"
        ]
        words = "|".join(single)
        return [re.sub(rf"\b({words})1\b", r"\1", line) if single else line for line in lines]

    def lines(self, feature: dict[str, Any]) -> list[str]:
        """What makes a feature; nothing where another one that repeats makes it."""
        self._feature = feature
        kind = feature["kind"]
        if self._repeats.is_made_elsewhere(feature):
            return []
        thread = f": {feature['thread']}, which is not cut" if "thread" in feature else ""
        found = ["", f"# {feature['name']}{thread}"]
        self._dimensioned = dict(_dimensioned(feature.get("sketch", feature)))
        if kind in ("fillet", "chamfer"):
            size = self._parameter("SIZE", feature["size"], feature["sources"]["size"])
            edges = ", ".join(f"nearest({self._part}, {tuple(p)!r})" for p in feature["places"])
            return [*found, f"{self._part} = {kind}([{edges}], {size})"]
        if kind == "hole":
            return [*found, *self._holes(feature)]
        name = feature["name"].lower()
        sketch = feature["sketch"]
        self._start = self._begins(sketch["plane"])
        found += [f"{name}_plane = {_plane(sketch['plane'], self._start)}", f"{name} = region(["]
        found += [f"    [{', '.join(edges)}]," for edges in self._outlines(sketch)]
        found.append("])")
        if kind in ("pad", "pocket"):
            length = self._length("LENGTH", feature["length"], "length")
            body = f"extrude({name}_plane.location * {name}, {written(length)})"
        else:
            (x, y), (dx, dy) = feature["axis"]["point"], feature["axis"]["direction"]
            axis = f"Axis(({x!r}, {y!r}, 0), ({dx!r}, {dy!r}, 0))"
            body = f"{name}_plane.location * revolve({name}, {axis})"
        sign = "+=" if kind in ("pad", "revolution") else "-="
        return [*found, *self._repeats.made(feature["name"], None, f"{self._part} {sign}", body)]

    def _holes(self, feature: dict[str, Any]) -> Iterator[str]:
        sources, sink = feature["sources"], feature["sink"]
        diameter = self._parameter("DIAMETER", feature["diameter"], sources["diameter"])
        plane = dict(feature["plane"])
        start = self._start = self._begins(plane)
        depth = "THROUGH"
        flip = 1.0 if feature["downward"] else -1.0
        if feature["depth"] is not None:
            length = self._length("DEPTH", -flip * feature["depth"], "depth")
            depth = written(turned(length) if feature["downward"] else length)
        if not feature["downward"]:
            # A drill goes against the normal of its plane.
            plane["normal"] = [0.0 - value for value in plane["normal"]]
            start = turned(start)
        name = feature["name"].lower()
        yield f"{name}_plane = {_plane(plane, start)}"
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

    def _begins(self, plane: dict[str, Any]) -> Terms:
        """The offset of the feature's plane: that of what it stands on, or a number of its own."""
        on = self._feature.get("stands_on")
        if on is not None:
            return self._earlier[on["feature"]].face(on, plane["normal"])
        if abs(plane["offset"]) < 1e-9:
            return ()
        name = self._parameter("OFFSET", abs(plane["offset"]), "")
        return ((1 if plane["offset"] > 0.0 else -1, name),)

    def _length(self, stem: str, length: float, key: str) -> Terms:
        """From the feature's plane to its end along the normal."""
        normal = self._feature.get("sketch", self._feature)["plane"]["normal"]
        at = self._feature.get("ends_at")
        if at is not None:
            self._end = self._earlier[at["feature"]].face(at, normal)
            return less(self._end, self._start)
        name = self._parameter(stem, abs(length), self._feature["sources"][key])
        found = ((1 if length > 0.0 else -1, name),)
        self._end = (*self._start, *found)
        return found

    def face(self, support: dict[str, Any], normal: Sequence[float]) -> Terms:
        """Where one of the feature's faces lies along a normal."""
        if support["side"] != Side.WALL.value:
            if self._repeats.is_made_elsewhere(self._feature):
                self._start = self._begins(self._feature["sketch"]["plane"])
                self._length("LENGTH", self._feature["length"], "length")
            return self._start if support["side"] == Side.START.value else self._end
        sketch = self._feature["sketch"]
        letter, value, way = edge_place(sketch, support["edge"], normal)
        name = self._place(letter, abs(value))
        return () if name == "0" else ((way if value > 0.0 else -way, name),)

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
        stem, source = self._dimensioned.get((axis, round(abs(value), 6)), (axis, ""))
        return sign + self._parameter(stem, abs(value), source)

    def _parameter(self, stem: str, value: float, source: str) -> str:
        """The name of a number, made once."""
        key = stem, round(value, 6)
        if key not in self._known:
            count = sum(1 for known, _ in self._known if known == stem) + 1
            name = f"{self._prefix}_{stem}{count if stem in _COUNTED_STEMS else ''}"
            self._known[key] = name
            note = "  # on the sheet" if source == "sheet" else ""
            self.parameters.append(f"{name} = {round(value, 9)!r}{note}")
        return self._known[key]


def _plane(plane: dict[str, Any], offset: Terms) -> str:
    return f"plane({written(offset)}, {tuple(plane['right'])!r}, {tuple(plane['normal'])!r})"


def _dimensioned(sketch: dict[str, Any]) -> Iterator[tuple[tuple[str, float], tuple[str, str]]]:
    """Of coordinates that are dimensions of the sketch, the dimension's name and its source, by the
    axis and the value: the dimension's other end is at 0."""
    axes = {"distance-x": (0, "X"), "distance-y": (1, "Y")}
    for constraint in sketch.get("constraints", ()):
        if constraint["kind"] not in axes:
            continue
        axis, letter = axes[constraint["kind"]]
        points = constraint["of"]
        if any(abs(_coordinate(sketch, number, spot, axis)) < 1e-9 for number, spot in points):
            name = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", constraint["name"]).upper()
            yield (letter, round(constraint["value"], 6)), (name, constraint["source"])


def _coordinate(sketch: dict[str, Any], element: int, spot: str | None, axis: int) -> float:
    """Of a point that a constraint names."""
    if element < 0:
        return 0.0
    if "centres" in sketch:
        return float(sketch["centres"][element][axis])
    return float(sketch["geometry"][element][spot or "start"][axis])
