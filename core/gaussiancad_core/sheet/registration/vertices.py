"""Ends of strokes from what the strokes lie on: one vertex where several end, exact at crossings.

All in px of a view's plane.  Lines along an axis and circles are settled before; here slanted lines
are laid through the vertices that are known and along the circles that they touch, and every end is
put where the supports meet.
"""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.near_points import near_pairs
from gaussiancad_core.geometry.points import to_point
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Arc, Ellipse, Segment, Stroke
from gaussiancad_core.sheet.registration.curve_crossings import crossings, meeting, nearest
from gaussiancad_core.sheet.registration.stroke_carriers import (
    AxisLine,
    CarriedStrokes,
    Round,
    Slant,
    Support,
)
from gaussiancad_core.sheet.registration.stroke_precision import Precision

Floats = npt.NDArray[np.float64]
Point = tuple[float, float]

_TOUCHING = 0.6
"""Share of the ends' uncertainty within which strokes touch."""


@dataclass(frozen=True)
class Vertex:
    """A place where strokes end.

    Attributes:
        ends: (stroke, 0 for its start or 1 for its end).
        supports: numbers of what these and strokes that pass through lie on.
        place: px, as it was read.
    """

    ends: tuple[tuple[int, int], ...]
    supports: tuple[int, ...]
    place: Point


@dataclass(frozen=True, eq=False)
class Grid:
    """Settled coordinates that ends may lie on.

    Attributes:
        levels: for each direction of the plane the sorted coordinates in px.
        precision: of the view.
    """

    levels: tuple[Floats, Floats]
    precision: Precision

    @property
    def touch(self) -> float:
        """px within which a line that passes a circle touches it."""
        return _TOUCHING * self.precision.ends

    def snapped(self, direction: int, value: float, reach: float | None = None) -> float:
        """The settled coordinate within ``reach`` px, by default as ends need, or the value."""
        levels = self.levels[direction]
        if not len(levels):
            return value
        nearest = float(levels[int(np.argmin(np.abs(levels - value)))])
        allowed = self.precision.ends if reach is None else reach
        return nearest if abs(nearest - value) <= allowed else value


def settled_strokes(strokes: CarriedStrokes, grid: Grid) -> tuple[Stroke, ...]:
    """The strokes with their ends at common vertices.

    Args:
        strokes: lines along axes and circles as they are to stay.
        grid: coordinates for ends that nothing else tells.
    """
    vertices = _vertices(strokes, grid.precision)
    supports = list(strokes.supports)
    places = [_place(vertex, strokes, grid, slanted=False) for vertex in vertices]
    strokes_on: dict[int | None, list[Stroke]] = defaultdict(list)
    for stroke, number in zip(strokes.strokes, strokes.of, strict=True):
        strokes_on[number].append(stroke)
    ends_on: dict[int, list[tuple[Vertex, Point | None]]] = defaultdict(list)
    for vertex, place in zip(vertices, places, strict=True):
        for number in set(vertex.supports):
            ends_on[number].append((vertex, place))
    for number, support in enumerate(supports):
        if isinstance(support, Slant):
            supports[number] = _relaid(number, strokes, (strokes_on[number], ends_on[number]), grid)
    strokes = replace(strokes, supports=tuple(supports))
    ends: dict[tuple[int, int], Point] = {}
    for vertex, known in zip(vertices, places, strict=True):
        place = known or _place(vertex, strokes, grid, slanted=True) or vertex.place
        ends.update(dict.fromkeys(vertex.ends, place))
    return tuple(_settled(strokes, index, ends) for index in range(len(strokes.strokes)))


def end_points(stroke: Stroke) -> tuple[Point, Point] | None:
    """Start and end of a segment or open arc."""
    if isinstance(stroke, Ellipse) or stroke.is_closed:
        return None
    start, end = stroke.extremes()[:2]
    return to_point(start), to_point(end)


def _vertices(strokes: CarriedStrokes, precision: Precision) -> list[Vertex]:
    """Ends that lie together, and what passes there."""
    keys: list[tuple[int, int]] = []
    points: list[Point] = []
    for index, stroke in enumerate(strokes.strokes):
        ends = end_points(stroke) if strokes.of[index] is not None else None
        if ends is not None:
            keys += [(index, 0), (index, 1)]
            points += ends
    if not points:
        return []
    at = np.array(points)
    pairs = near_pairs(at, precision.ends)
    apart = np.hypot(*(at[pairs[:, 0]] - at[pairs[:, 1]]).T)
    group = list(range(len(at)))
    members = {index: [index] for index in group}
    for a, b in pairs[np.argsort(apart, kind="stable")]:
        first, second = group[a], group[b]
        if first == second:
            continue
        both = {keys[i][0] for i in members[first]} & {keys[i][0] for i in members[second]}
        if both:
            continue
        for index in members[second]:
            group[index] = first
        members[first] += members.pop(second)
    places = {number: at[held].mean(axis=0) for number, held in members.items()}
    through = _passing(strokes, np.array(list(places.values())), precision.ends)
    return [
        Vertex(
            tuple(keys[i] for i in held),
            tuple(
                dict.fromkeys(
                    number
                    for number in (*(strokes.of[keys[i][0]] for i in held), *crossing)
                    if number is not None
                )
            ),
            (float(places[number][0]), float(places[number][1])),
        )
        for (number, held), crossing in zip(members.items(), through, strict=True)
    ]


def _passing(strokes: CarriedStrokes, places: Floats, reach: float) -> list[list[int]]:
    """For each of (n, 2) places the supports of strokes that run through it."""
    found: list[list[int]] = [[] for _ in places]
    for stroke, support in zip(strokes.strokes, strokes.of, strict=True):
        if support is None:
            continue
        if isinstance(stroke, Segment):
            start, way = np.array(stroke.start), np.subtract(stroke.end, stroke.start)
            share = (places - start) @ way / max(float(way @ way), 1e-12)
            nearest = start + np.clip(share, 0.0, 1.0)[:, None] * way
            near = np.hypot(*(places - nearest).T) <= reach
        elif isinstance(stroke, Arc):
            offset = places - np.array(stroke.centre)
            slack = reach / max(stroke.radius, 1e-9)
            turn = np.arctan2(offset[:, 1], offset[:, 0]) - stroke.start_angle + slack
            within = np.mod(turn, 2 * np.pi) <= stroke.sweep + 2 * slack
            near = within & (np.abs(np.hypot(*offset.T) - stroke.radius) <= reach)
        else:
            continue
        for index in np.flatnonzero(near):
            found[index].append(support)
    return found


def _place(vertex: Vertex, strokes: CarriedStrokes, grid: Grid, slanted: bool) -> Point | None:
    """Where the supports of a vertex meet.

    Args:
        vertex: the ends.
        strokes: with the supports as they are known.
        grid: coordinates for ends that nothing else tells.
        slanted: whether slanted lines are settled; without them, None where they are needed and
            no settled coordinate is near.
    """
    supports = [strokes.supports[number] for number in vertex.supports]
    fixed: list[float | None] = [None, None]
    for direction in (0, 1):
        lines = [s.at for s in supports if isinstance(s, AxisLine) and s.fixed == direction]
        if lines:
            fixed[direction] = min(lines, key=lambda at: abs(at - vertex.place[direction]))
    if fixed[0] is not None and fixed[1] is not None:
        return fixed[0], fixed[1]
    circles = [s for s in supports if isinstance(s, Round)]
    slants = [s for s in supports if isinstance(s, Slant)]
    known = next(((i, value) for i, value in enumerate(fixed) if value is not None), None)
    if known is None:
        place = _crossing(circles, slants, vertex.place, grid)
    else:
        place = _on_axis_line(*known, [*circles, *slants], vertex.place, grid)
    if slanted or not slants or place is None:
        return place
    if circles:
        # A slanted line that touches a circle is laid along it first.
        return place if known is not None else None
    reach = grid.precision.limits.apart
    snapped = grid.snapped(0, place[0], reach), grid.snapped(1, place[1], reach)
    return snapped if snapped != place else None


def _crossing(
    circles: Sequence[Round], slants: Sequence[Slant], place: Point, grid: Grid
) -> Point | None:
    """Where circles and slanted lines meet; None if there are none."""
    both: list[Round | Slant] = [*circles, *slants]
    points = [
        point
        for i, first in enumerate(both)
        for second in both[i + 1 :]
        for point in meeting(first, second, grid.touch)
    ]
    near = nearest(points, place, 2.0 * grid.precision.ends)
    if near is None and both:
        return _free_end(both[0], place, grid)
    return near


def _on_axis_line(
    direction: int, value: float, crossing: Sequence[Round | Slant], place: Point, grid: Grid
) -> Point:
    """The vertex on a line along an axis, whose coordinate in ``direction`` is known."""

    def point(other: float) -> Point:
        return (value, other) if direction == 0 else (other, value)

    found = [
        point(other) for item in crossing for other in crossings(item, direction, value, grid.touch)
    ]
    near = nearest(found, place, 2.0 * grid.precision.ends)
    if near is not None:
        return near
    return point(grid.snapped(1 - direction, place[1 - direction]))


def _free_end(this_round: Round | Slant, place: Point, grid: Grid) -> Point:
    """An end that meets nothing: where its support has a settled coordinate, else as it was."""
    found: list[Point] = []
    for direction in (0, 1):
        value = grid.snapped(direction, place[direction])
        if value == place[direction]:
            continue
        for other in crossings(this_round, direction, value, grid.touch):
            found.append((value, other) if direction == 0 else (other, value))
    near = nearest(found, place, grid.precision.ends)
    if near is None:
        return _foot(this_round, place)
    # A corner of two settled coordinates, if the support leads there.
    corner = grid.snapped(0, near[0]), grid.snapped(1, near[1])
    away = np.hypot(corner[0] - near[0], corner[1] - near[1])
    return corner if away <= grid.precision.limits.apart else near


def _foot(slant: Round | Slant, place: Point) -> Point:
    """The point of a support next to a place."""
    if isinstance(slant, Slant):
        return slant.line.at(float(slant.line.coordinates(np.array([place]))[0][0]))
    offset = np.subtract(place, slant.centre)
    point = np.array(slant.centre) + offset * (slant.radius / max(float(np.hypot(*offset)), 1e-12))
    return float(point[0]), float(point[1])


def _relaid(
    number: int,
    supported_strokes: CarriedStrokes,
    on_it: tuple[Sequence[Stroke], Sequence[tuple[Vertex, Point | None]]],
    grid: Grid,
) -> Slant:
    """A slanted line through the settled vertices at its ends, or along the circles there.

    Args:
        number: of the line among the supports.
        supported_strokes: the strokes of the view, as they were supported before.
        on_it: strokes of the line, and the vertices there with their settled places.
        grid: coordinates for ends that nothing else tells.
    """
    slant = supported_strokes.supports[number]
    if not isinstance(slant, Slant):
        raise ValueError("the support is no slanted line")
    strokes, own_vertices = on_it
    raw = np.array([point for s in strokes for point in (end_points(s) or ())])
    along, _ = slant.line.coordinates(raw)
    first, last = raw[int(np.argmin(along))], raw[int(np.argmax(along))]
    held: list[tuple[Point, float]] = []
    for end in (first, last):
        vertex, place = min(
            own_vertices, key=lambda pair: float(np.hypot(*np.subtract(pair[0].place, end)))
        )
        circles = (supported_strokes.supports[index] for index in vertex.supports)
        touched = _touched(circles, slant.line, grid.touch)
        held.append(touched or (place or _foot(slant, (float(end[0]), float(end[1]))), 0.0))
    line = _tangent(held[0], held[1], slant.line)
    if line is None or line.distances(raw).max() > grid.precision.ends:
        return slant
    return Slant(line, slant.weight)


_LEFT = 0.3
"""Share of a stroke's length that is left of it at least."""

Hold = tuple[Point, float]
"""A centre, and how far to its left a line passes it: 0 is a point of the line."""


def _touched(supports: Iterable[Support], line: Line, touch: float) -> Hold | None:
    """The circle at an end of a slanted line that the line touches."""
    for circle in supports:
        if isinstance(circle, Round):
            across = float(line.coordinates(np.array([circle.centre]))[1][0])
            if abs(abs(across) - circle.radius) <= touch:
                return circle.centre, float(np.copysign(circle.radius, across))
    return None


def _tangent(first: Hold, last: Hold, like: Line) -> Line | None:
    """The line that passes two centres at given distances, in the direction of another."""
    (a, left_a), (b, left_b) = first, last
    way = np.subtract(b, a)
    distance = float(np.hypot(*way))
    if distance <= abs(left_b - left_a) or distance < 1e-9:
        return None
    way = way / distance
    if float(way @ np.array(like.direction)) < 0.0:
        # Seen the other way, both lie on the same sides of the line as before.
        return _tangent(last, first, like)
    # The centres rise over the line by the difference of their distances.
    sine = (left_b - left_a) / distance
    cosine = float(np.sqrt(1.0 - sine * sine))
    direction = np.array([cosine * way[0] + sine * way[1], cosine * way[1] - sine * way[0]])
    normal = np.array([-direction[1], direction[0]])
    point = np.array(a) - left_a * normal
    return Line((float(point[0]), float(point[1])), (float(direction[0]), float(direction[1])))


def _settled_segment(
    segment: Segment, support: Support | None, ends: tuple[Point, Point]
) -> Segment:
    way = np.subtract(segment.end, segment.start)
    share = float(way @ np.subtract(ends[1], ends[0])) / max(float(way @ way), 1e-12)
    # A short stroke between two vertices that became one would vanish or turn around.
    points = [list(end) for end in (ends if share > _LEFT else (segment.start, segment.end))]
    if isinstance(support, AxisLine):
        for point in points:
            point[support.fixed] = support.at
    start, end = ((point[0], point[1]) for point in points)
    return replace(segment, start=start, end=end)


def _settled(strokes: CarriedStrokes, index: int, ends: dict[tuple[int, int], Point]) -> Stroke:
    """A stroke on its support, with the ends of its vertices."""
    stroke, number = strokes.strokes[index], strokes.of[index]
    support = strokes.supports[number] if number is not None else None
    if isinstance(stroke, Segment):
        return _settled_segment(stroke, support, (ends[index, 0], ends[index, 1]))
    if not isinstance(stroke, Arc) or not isinstance(support, Round):
        return stroke
    moved = replace(stroke, centre=support.centre, radius=support.radius)
    if (index, 0) not in ends:
        return moved
    offsets = [np.subtract(ends[index, end], support.centre) for end in (0, 1)]
    start, stop = (float(np.arctan2(offset[1], offset[0])) for offset in offsets)
    sweep = float(np.mod(stop - start, 2 * np.pi))
    # Neither a whole turn more nor less than it was.
    if abs(sweep - stroke.sweep) > np.pi:
        sweep = stroke.sweep
    return replace(moved, start_angle=float(np.mod(start, 2 * np.pi)), sweep=sweep)
