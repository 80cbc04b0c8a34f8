"""Places to which a gesture snaps: ends, centres and outermost places of circles, intersections,
tangents, rows and columns."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations
from math import acos, atan2, cos, hypot, sin

from freecad.gaussiancad.canvas.sheet import Point, Sheet, Stroke

_SQUARE = 0.02
"""Share of its length by which a line may lean that is meant to be square to the sheet."""


def snapped(sheet: Sheet, at: Point, reach: float, start: Point | None = None) -> Point:
    """Where a place snaps to.

    An end, a centre, an outermost place of a circle or an intersection goes first, then a place at
    which a line from ``start`` is tangent to a circle, then the row and the column of such a place
    in any view: the hidden lines of a hole are in the columns of its circle's left and right.

    Args:
        sheet: with its strokes.
        at: the place, px of the sheet.
        reach: px from it.
        start: of a line that ends there, if there is one.
    """
    found = _snapped(sheet, at, reach, start)
    if start is None:
        return found
    # A line that was drawn about square is square: its places are those of different strokes.
    across, along = abs(found[0] - start[0]), abs(found[1] - start[1])
    if min(across, along) > min(reach, _SQUARE * max(across, along)):
        return found
    return (start[0], found[1]) if across < along else (found[0], start[1])


def _snapped(sheet: Sheet, at: Point, reach: float, start: Point | None) -> Point:
    strokes = sheet.drawn()
    ends = list(_ends(strokes))
    near = _nearest(ends, at, reach) or _nearest(_crossings(strokes, at, reach), at, reach)
    if near is None and start is not None:
        near = _nearest(_tangents(strokes, start), at, reach)
    if near is not None:
        return near
    found = list(at)
    for index in (0, 1):
        places = [end[index] for end in ends]
        away = [abs(place - at[index]) for place in places]
        if away and min(away) <= reach:
            found[index] = places[away.index(min(away))]
    return found[0], found[1]


def _nearest(places: Iterable[Point], at: Point, reach: float) -> Point | None:
    best = min(places, key=lambda place: hypot(place[0] - at[0], place[1] - at[1]), default=None)
    if best is None or hypot(best[0] - at[0], best[1] - at[1]) > reach:
        return None
    return best


def _ends(strokes: Iterable[Stroke]) -> Iterator[Point]:
    for stroke in strokes:
        if stroke.circle is not None:
            x, y, radius = stroke.circle
            yield from ((x - radius, y), (x + radius, y), (x, y - radius), (x, y + radius))
        else:
            points = stroke.points()
            yield from (points[0], points[-1])
        if stroke.shape[0] != "line":
            yield stroke.shape[1][0], stroke.shape[1][1]


def _crossings(strokes: Iterable[Stroke], at: Point, reach: float) -> Iterator[Point]:
    """Where two straight strokes that pass near a place meet, or would if they went on."""
    lines = [
        stroke.shape[1]
        for stroke in strokes
        if stroke.shape[0] == "line" and _beside(stroke.shape[1], at) <= reach
    ]
    for (a, b), (c, d) in combinations(lines, 2):
        one = b[0] - a[0], b[1] - a[1]
        other = d[0] - c[0], d[1] - c[1]
        cross = one[0] * other[1] - one[1] * other[0]
        if abs(cross) > 1e-9:
            share = ((c[0] - a[0]) * other[1] - (c[1] - a[1]) * other[0]) / cross
            yield a[0] + share * one[0], a[1] + share * one[1]


def _beside(line: tuple[Point, Point], at: Point) -> float:
    """px from a place to the straight line along a stroke."""
    (x0, y0), (x1, y1) = line
    length = hypot(x1 - x0, y1 - y0)
    if not length:
        return hypot(at[0] - x0, at[1] - y0)
    return abs((x1 - x0) * (at[1] - y0) - (y1 - y0) * (at[0] - x0)) / length


def _tangents(strokes: Iterable[Stroke], start: Point) -> Iterator[Point]:
    """Places on arcs at which a line from a start touches them."""
    for stroke in strokes:
        if stroke.shape[0] != "arc":
            continue
        x, y, radius = stroke.shape[1][:3]
        away = hypot(start[0] - x, start[1] - y)
        if away > radius:
            towards, half = atan2(start[1] - y, start[0] - x), acos(radius / away)
            for angle in (towards - half, towards + half):
                yield x + radius * cos(angle), y + radius * sin(angle)
