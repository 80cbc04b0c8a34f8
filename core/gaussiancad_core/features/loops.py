"""Closed outlines of regions: straight edges, arcs and circles that meet at their ends."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from math import atan2, hypot, pi

from gaussiancad_core.features.sketch_cells import Cells, Piece
from gaussiancad_core.geometry.outline_edges import OutlineEdge, enclosed_area, whole_circle
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import SHORTEST
from gaussiancad_core.geometry.whole_curves import Circle

_ROUNDED = 9
"""Decimal places."""


class OpenLoopError(Exception):
    """The pieces around a region do not close."""


Loop = tuple[OutlineEdge, ...]
"""With the region on the left of its edges."""


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
    return tuple(sorted(found, key=lambda loop: -abs(enclosed_area(loop))))


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
    first = runs[0][0]
    if len(runs) == 1 and isinstance(first.piece.curve, Circle):
        return (whole_circle(_rounded_circle(first.piece.curve), first.is_forward),)
    edges = [_edge(run) for run in runs]
    # Each ends where the next one starts, to the last digit.
    return tuple(
        replace(edge, end=edges[(k + 1) % len(edges)].start) for k, edge in enumerate(edges)
    )


def _go_on(one: _Directed, other: _Directed) -> bool:
    return one.piece.support == other.piece.support and one.is_forward == other.is_forward


def _edge(run: Sequence[_Directed]) -> OutlineEdge:
    start, end = _rounded(run[0].start), _rounded(run[-1].end)
    curve = run[0].piece.curve
    if not isinstance(curve, Circle):
        return OutlineEdge(start, end)
    return OutlineEdge(start, end, _rounded_circle(curve), run[0].is_forward)


def _rounded_circle(circle: Circle) -> Circle:
    return Circle(_rounded(circle.centre), round(circle.radius, _ROUNDED))


def _rounded(point: Point) -> Point:
    x, y = (round(value, _ROUNDED) + 0.0 for value in point)
    return x, y
