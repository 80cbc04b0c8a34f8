"""What repeats, in a build123d script: a body is made once, and its copies in a loop."""

from collections.abc import Sequence
from math import atan2, degrees
from typing import Any

import numpy as np

REPEATING = '''
def along(bodies, direction, count, distance):
    """Bodies and their copies at equal distances."""
    steps = [[k * distance * part for part in direction] for k in range(count)]
    return [Pos(*step) * body for step in steps for body in bodies]


def around(bodies, point, direction, count, angle):
    """Bodies and their copies at equal angles around an axis."""
    return [body.rotate(Axis(point, direction), k * angle) for k in range(count) for body in bodies]


def mirrored(bodies, normal, offset):
    """Bodies and their images in a plane."""
    where = Plane(origin=[offset * part for part in normal], z_dir=normal)
    return [*bodies, *(body.mirror(where) for body in bodies)]


def on_circle(middle, diameter, angle):
    """The point of a circle at an angle in degrees."""
    x, y = (diameter / 2 * turn(radians(angle)) for turn in (cos, sin))
    return (middle[0] + x, middle[1] + y)

'''


class Repeats:
    """The patterns of a solid.

    Args:
        patterns: as ``features.json`` has them.
        prefix: of their parameters' names.

    Attributes:
        parameters: lines that give numbers to the names that were used.
    """

    def __init__(self, patterns: Sequence[dict[str, Any]], prefix: str) -> None:
        self.parameters: list[str] = []
        self._prefix = prefix
        self._seeds = {tuple(pattern["members"][0]): pattern for pattern in patterns}
        self._images = {tuple(member) for pattern in patterns for member in pattern["members"][1:]}

    def is_image(self, name: str, centre: int | None) -> bool:
        """Whether a feature, or a hole of it, is made where another one repeats."""
        return (name, centre) in self._images

    def is_made_elsewhere(self, feature: dict[str, Any]) -> bool:
        """Whether all of a feature is made where others repeat."""
        centres = range(len(feature["centres"])) if feature["kind"] == "hole" else (None,)
        return all(self.is_image(feature["name"], centre) for centre in centres)

    def made(self, name: str, centre: int | None, change: str, body: str) -> list[str]:
        """Lines that change a part by a body, and by its copies where it repeats.

        Args:
            name: of the feature.
            centre: number of the hole.
            change: the part and the operator.
            body: that is added or taken away.
        """
        pattern = self._seeds.get((name, centre))
        if pattern is None:
            return [f"{change} {body}"]
        return [f"for copy in {self._copies(pattern, f'[{body}]')}:", f"    {change} copy"]

    def centre(self, holes: dict[str, Any], number: int) -> str | None:
        """The centre of a hole by the circle of its pattern, where it has one around the normal;
        in the plane that it is drilled into."""
        pattern = self._seeds.get((holes["name"], number))
        plane = holes["plane"]
        if pattern is None or pattern["kind"] != "circular":
            return None
        right, up, normal, direction, point = (
            np.array(vector)
            for vector in (
                *(plane[name] for name in ("right", "up", "normal")),
                *(pattern["axis"][name] for name in ("direction", "point")),
            )
        )
        if abs(float(normal @ direction)) < 1.0 - 1e-9:
            return None
        # With the normal turned, up runs the other way.
        flip = 1.0 if holes["downward"] else -1.0
        middle = np.array([float(point @ right), flip * float(point @ up)])
        x, y = np.array(holes["centres"][number]) * (1.0, flip) - middle
        at = ", ".join(repr(round(value, 9) + 0.0) for value in middle.tolist())
        diameter = self._parameter(pattern, "DIAMETER", pattern["diameter"], pattern["sources"])
        return f"on_circle(({at}), {diameter}, {round(degrees(atan2(y, x)), 9)!r})"

    def _copies(self, pattern: dict[str, Any], bodies: str) -> str:
        if pattern["kind"] in ("linear", "grid"):
            for number, step in enumerate(pattern["steps"], 1):
                ending = str(number) if len(pattern["steps"]) > 1 else ""
                count = self._parameter(pattern, "COUNT", step["count"], {}, ending)
                sources, value = step["sources"], step["distance"]
                distance = self._parameter(pattern, "DISTANCE", value, sources, ending)
                bodies = f"along({bodies}, {tuple(step['direction'])!r}, {count}, {distance})"
            return bodies
        if pattern["kind"] == "circular":
            point, direction = (tuple(pattern["axis"][name]) for name in ("point", "direction"))
            count = self._parameter(pattern, "COUNT", pattern["count"], {})
            angle = self._parameter(pattern, "ANGLE", pattern["angle"], {})
            return f"around({bodies}, {point!r}, {direction!r}, {count}, {angle})"
        plane = pattern["plane"]
        offset = self._parameter(pattern, "OFFSET", plane["offset"], pattern["sources"])
        return f"mirrored({bodies}, {tuple(plane['normal'])!r}, {offset})"

    def _parameter(
        self,
        pattern: dict[str, Any],
        stem: str,
        value: float,
        sources: dict[str, str],
        ending: str = "",
    ) -> str:
        name = f"{self._prefix}{pattern['name'].upper()}_{stem}{ending}"
        note = "  # on the sheet" if sources.get(stem.lower()) == "sheet" else ""
        self.parameters.append(f"{name} = {round(value, 9)!r}{note}")
        return name
