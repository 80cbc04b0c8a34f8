"""Closed outlines of regions: straight edges, arcs and circles that meet at their ends."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from math import atan2, hypot, pi

from gaussiancad_core.features.sketch_cells import Cells, Piece
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import SHORTEST
from gaussiancad_core.geometry.whole_curves import Circle

_ROUNDED = 9
"""Decimal places."""


class OpenLoopError(Exception):
    """The pieces around a region do not close."""


@dataclass(frozen=True)
class Edge:
    """An edge of an outline, with the region on its left.

    Attributes:
        start, end: in the plane; equal of a circle.
        centre, radius: of an arc or circle; None of a straight edge.
        is_ccw: whether an arc runs counter-clockwise.
    """

    start: Point
    end: Point
    centre: Point | None = None
    radius: float | None = None
    is_ccw: bool = True

    @property
    def is_circle(self) -> bool:
        """Whether it is a whole circle."""
        return self.centre is not None and self.start == self.end

    @property
    def sweep(self) -> float:
        """Radians that an arc turns, positive; a whole turn of a circle."""
        if self.centre is None:
            return 0.0
        if self.is_circle:
            return FULL_TURN
        first, last = (
            atan2(point[1] - self.centre[1], point[0] - self.centre[0])
            for point in (self.start, self.end)
        )
        return (last - first) % FULL_TURN if self.is_ccw else (first - last) % FULL_TURN

    def heading(self, at_start: bool) -> Point:
        """Unit vector in which it runs at its start or end."""
        place = self.start if at_start else self.end
        if self.centre is None:
            dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
        else:
            way = 1.0 if self.is_ccw else -1.0
            dx, dy = way * (self.centre[1] - place[1]), way * (place[0] - self.centre[0])
        length = hypot(dx, dy)
        return dx / length, dy / length


Loop = tuple[Edge, ...]


@dataclass(frozen=True)
class _Directed:
    """A piece, in the direction in which the region is on its left."""

    piece: Piece
    start: Point
    end: Point
    is_forward: bool

    def heading(self, at_start: bool) -> float:
        """Angle of its tangent where it starts or ends, in the way that it runs."""
        curve, is_forward = self.piece.curve, self.is_forward
        at = self.piece.low if at_start == is_forward else self.piece.high
        (dx, dy) = curve.normal(at)
        # Along a line the normal is its direction turned to the left; of a circle it points out.
        tangent = (-dy, dx) if isinstance(curve, Circle) else (dy, -dx)
        way = 1.0 if is_forward else -1.0
        return atan2(way * tangent[1], way * tangent[0])


def loops_of(cells: Cells, region: Collection[int]) -> tuple[Loop, ...]:
    """The outlines of a region: outer ones counter-clockwise, those of holes clockwise.

    Args:
        cells: of the plane.
        region: some of them.

    Raises:
        OpenLoopError: they do not close.
    """
    inside = set(region)
    left = [_directed(piece, inside) for piece in cells.border(region)]
    found = []
    while left:
        chain = [left.pop()]
        while not _meet(chain[-1].end, chain[0].start):
            following = [k for k, other in enumerate(left) if _meet(chain[-1].end, other.start)]
            if not following:
                raise OpenLoopError
            turn = min(following, key=lambda k: -_turn(chain[-1], left[k]))
            chain.append(left.pop(turn))
        found.append(_loop(chain))
    return tuple(sorted(found, key=lambda loop: -abs(area_of(loop))))


def area_of(loop: Loop) -> float:
    """Area that an outline encloses; negative where it runs clockwise."""
    total = 0.0
    for edge in loop:
        (x0, y0), (x1, y1) = edge.start, edge.end
        total += (x0 * y1 - x1 * y0) / 2.0
        if edge.centre is not None and edge.radius is not None:
            way = 1.0 if edge.is_ccw else -1.0
            chord = (x0 - edge.centre[0]) * (y1 - edge.centre[1])
            chord -= (x1 - edge.centre[0]) * (y0 - edge.centre[1])
            total += (way * edge.sweep * edge.radius**2 - chord) / 2.0
    return total


def _directed(piece: Piece, inside: set[int]) -> _Directed:
    low, high = piece.curve.at(piece.low), piece.curve.at(piece.high)
    # A circle's normal points out of it, so its left is inside only when it runs counter-clockwise.
    is_circle = isinstance(piece.curve, Circle)
    is_forward = (piece.right in inside) if is_circle else (piece.left in inside)
    return _Directed(piece, *((low, high) if is_forward else (high, low)), is_forward)


def _meet(one: Point, other: Point) -> bool:
    return hypot(one[0] - other[0], one[1] - other[1]) < SHORTEST


def _turn(one: _Directed, other: _Directed) -> float:
    """Radians to the left from the end of one to the start of another, -pi to pi."""
    angle = other.heading(at_start=True) - one.heading(at_start=False)
    return (angle + pi) % FULL_TURN - pi


def _loop(chain: Sequence[_Directed]) -> Loop:
    runs: list[list[_Directed]] = []
    for link in chain:
        if runs and _go_on(runs[-1][-1], link):
            runs[-1].append(link)
        else:
            runs.append([link])
    if len(runs) > 1 and _go_on(runs[-1][-1], runs[0][0]):
        runs[0] = runs.pop() + runs[0]
    if len(runs) == 1 and isinstance(runs[0][0].piece.curve, Circle):
        return (_circle(runs[0][0]),)
    edges = [_edge(run) for run in runs]
    # Each ends where the next one starts, to the last digit.
    return tuple(
        replace(edge, end=edges[(k + 1) % len(edges)].start) for k, edge in enumerate(edges)
    )


def _go_on(one: _Directed, other: _Directed) -> bool:
    return one.piece.support == other.piece.support and one.is_forward == other.is_forward


def _edge(run: Sequence[_Directed]) -> Edge:
    start, end = _rounded(run[0].start), _rounded(run[-1].end)
    curve = run[0].piece.curve
    if not isinstance(curve, Circle):
        return Edge(start, end)
    centre, radius = _rounded(curve.centre), round(curve.radius, _ROUNDED)
    return Edge(start, end, centre, radius, run[0].is_forward)


def _circle(link: _Directed) -> Edge:
    curve = link.piece.curve
    if not isinstance(curve, Circle):
        raise ValueError("the piece is no circle")
    centre, radius = _rounded(curve.centre), round(curve.radius, _ROUNDED)
    start = (centre[0] + radius, centre[1])
    return Edge(start, start, centre, radius, link.is_forward)


def _rounded(point: Point) -> Point:
    x, y = (round(value, _ROUNDED) + 0.0 for value in point)
    return x, y
