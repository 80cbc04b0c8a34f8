"""How far strokes of ``reading.json`` are from a place on the sheet, px of the sheet as stored."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import atan2, cos, hypot, inf, pi, sin
from typing import Any

Values = Mapping[str, Any]
"""An object of JSON."""


def length(stroke: Values) -> float:
    """px of a line or an arc; 0 of what is neither."""
    if "line" in stroke:
        (x0, y0), (x1, y1) = stroke["line"]
        return hypot(x1 - x0, y1 - y0)
    if "arc" in stroke:
        return stroke["arc"][2] * stroke["arc"][4]
    return 0.0


def distance(stroke: Values, at: tuple[float, float]) -> float:
    """px from a place to a stroke; to its box where it has no line."""
    if "line" in stroke:
        return _from_segment(stroke["line"], at)
    if "arc" in stroke:
        return _from_arc(stroke["arc"], at)
    if "ellipse" in stroke:
        return _from_ellipse(stroke["ellipse"], at)
    return 0.0 if holds(stroke["box"], at) else inf


def _from_segment(line: Sequence[Sequence[float]], at: tuple[float, float]) -> float:
    (x0, y0), (x1, y1) = line
    along = (x1 - x0) ** 2 + (y1 - y0) ** 2
    share = ((at[0] - x0) * (x1 - x0) + (at[1] - y0) * (y1 - y0)) / along if along else 0.0
    share = min(1.0, max(0.0, share))
    return hypot(at[0] - x0 - share * (x1 - x0), at[1] - y0 - share * (y1 - y0))


def _from_arc(arc: Sequence[float], at: tuple[float, float]) -> float:
    x, y, radius, start, sweep = arc
    turned = (atan2(at[1] - y, at[0] - x) - start) % (2.0 * pi)
    if turned <= sweep:
        return abs(hypot(at[0] - x, at[1] - y) - radius)
    ends = (start, start + sweep)
    return min(hypot(at[0] - x - radius * cos(end), at[1] - y - radius * sin(end)) for end in ends)


def _from_ellipse(ellipse: Sequence[float], at: tuple[float, float]) -> float:
    x, y, major, minor, rotation, start, sweep = ellipse
    steps = 64
    places = []
    for step in range(steps + 1):
        t = start + sweep * step / steps
        along, across = major * cos(t), minor * sin(t)
        places.append(
            (
                x + along * cos(rotation) - across * sin(rotation),
                y + along * sin(rotation) + across * cos(rotation),
            )
        )
    return min(_from_segment(pair, at) for pair in pairwise(places))


def holds(box: Sequence[float], at: tuple[float, float], margin: float = 0.0) -> bool:
    """Whether a place lies in a box, or within a margin of it."""
    x0, y0, x1, y1 = box
    return x0 - margin <= at[0] <= x1 + margin and y0 - margin <= at[1] <= y1 + margin
