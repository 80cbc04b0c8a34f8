"""Lines, circles and ellipses grown along ridge points.

From a point with a direction, a line is fitted to the points near it that run its way, followed
further, fitted again, and so on until the ink ends.  It is followed across gaps as wide as those
between dashes, so that a dashed line is found as one.  An arc starts from points that no long line
explains, with the circle that osculates the chain around one of them, and is followed around in the
same way.
"""

import heapq
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.picture_noise import COURSE, ON_LINE, TOUCHING
from gaussiancad_core.sheet.tracing.arc_kernels import grow_arcs
from gaussiancad_core.sheet.tracing.corner_fits import is_corner
from gaussiancad_core.sheet.tracing.grown_shapes import Grown
from gaussiancad_core.sheet.tracing.line_kernels import grow_lines, line_worth
from gaussiancad_core.sheet.tracing.ovals import OvalRules, grow_ovals
from gaussiancad_core.sheet.tracing.ridges import RidgePoints
from gaussiancad_core.sheet.votes import MOST
from gaussiancad_protocol.codes import Code

Floats = npt.NDArray[np.float64]

_BONUS = {Line: 1.0, Circle: 1.15, WholeEllipse: 1.05}
"""Lines explain an arc in pieces: at nearly the same number of points the arc wins.  Between them
ellipses: they win where they explain what takes two arcs, not what is one."""

_FLAT_PX, _FLAT = 1.5, 0.87
"""Sagitta of an arc that is nearly straight; what such arcs count: where a line explains nearly as
much, it is one, and at its ends it runs into others."""

_FRESH = 0.35
"""Share of a shape's points that no better shape may have taken."""

_ENOUGH = 7
"""Free points that are enough for a line: two circles that it joins take most of a short
one's."""

_LONG = 24
"""Points of a line that certainly is one; what it explains starts no arc."""


_MOST_LINES, _MOST_MEMBERS = 60_000, 15_000_000
"""Lines that are grown, and points of all of them: large sheets grow 20,000 with 8 million.  Where
lines cross everywhere each is grown again and again, with all points of the ones beside it."""


_UNEVEN_GAP = 1.3
"""Gap between dashes at most, in the sheet's usual ones."""


@dataclass(frozen=True)
class GrowthRules:
    """When points belong to a line or circle; px.

    Attributes:
        gap: widest stretch without points that is crossed.
        band: farthest from the centre line.
        turn_degrees: largest angle between a point's tangent and the line's.
        shortest: least number of points, about one a px.
        flattest: largest sagitta of a line.
        bowed: least sagitta of an arc.
        rms: largest root mean square of the points' distances.
    """

    gap: float = 14.0
    band: float = 0.8
    turn_degrees: float = 14.0
    shortest: int = 5
    flattest: float = 0.35
    bowed: float = 0.8
    rms: float = 0.32

    @classmethod
    def of_width(cls, stroke_width: float, dash_gap: float = 0.0) -> "GrowthRules":
        """The rules for strokes of a width in px: wider ones have longer gaps and rougher edges.

        Args:
            stroke_width: px.
            dash_gap: px, usual between the sheet's dashes; 0 where it is not known.
        """
        return cls(
            gap=max(14.0, 5.0 * stroke_width, _UNEVEN_GAP * dash_gap),
            band=max(0.8, 0.2 * stroke_width),
        )


def grow_shapes(ridges: RidgePoints, rules: GrowthRules = GrowthRules()) -> list[Grown]:
    """Lines and circles that explain ridge points, those that explain most first.

    Shapes compete for points: of two that run along each other only the better one stays.

    Raises:
        NoModelError: ``part-too-complex``: there are more lines than any drawing has.
    """
    lines, arcs, _ = _lines_and_arcs(ridges, rules)
    return _chosen(lines + arcs, ridges, rules.shortest)


def grow_all(ridges: RidgePoints, rules: GrowthRules = GrowthRules()) -> list[Grown]:
    """Lines, circles and ellipses, as :func:`grow_shapes` gives lines and circles.

    Raises:
        NoModelError: as there.
    """
    lines, arcs, adjacent = _lines_and_arcs(ridges, rules)
    seeds = sorted(arcs, key=lambda grown: -len(grown.members))
    cosine = float(np.cos(np.radians(rules.turn_degrees)))
    ovals = grow_ovals(
        ridges,
        [(grown.circle, grown.members) for grown in seeds],
        adjacent,
        OvalRules(rules.gap, rules.band, cosine),
    )
    shapes = lines + arcs + [Grown(ellipse, members) for ellipse, members in ovals]
    return _chosen(shapes, ridges, rules.shortest)


def _lines_and_arcs(
    ridges: RidgePoints, rules: GrowthRules
) -> tuple[list[Grown], list[Grown], Floats]:
    """All lines, all arcs, and (n,) px from each point to the long line that has it."""
    lines = _all_lines(ridges, rules)
    adjacent = np.full(len(ridges.points), np.inf)
    for grown in _chosen(lines, ridges, rules.shortest):
        certain = len(grown.members) >= _LONG
        if certain and not _bows(grown.line, ridges.points[grown.members], rules):
            away = grown.geometry.distances(ridges.points[grown.members])
            adjacent[grown.members] = np.minimum(adjacent[grown.members], away)
    found = _unpacked(grow_arcs(*_inputs(ridges, rules), adjacent))
    arcs = [Grown(_circle(row), values) for row, values in found]
    arcs = [grown for grown in arcs if not is_corner(grown.circle, ridges.points[grown.members])]
    return lines, arcs, adjacent


def _bows(line: Line, points: Floats, rules: GrowthRules) -> bool:
    """Whether the middle of what a line explains is an arc: a chord across dashes of a circle.

    A straight line between two tangent arcs explains their beginnings too: the ends say nothing.
    """
    along, across = line.coordinates(points)
    along = along - (along.min() + along.max()) / 2
    inner = MOST * float(np.abs(along).max())
    middle = np.abs(along) <= inner
    if middle.sum() < 3:
        return False
    bend = float(np.polyfit(along[middle], across[middle], 2)[0])
    return abs(bend) * inner**2 > rules.flattest


def grow_straight(ridges: RidgePoints, rules: GrowthRules = GrowthRules()) -> list[Grown]:
    """Lines alone, as :func:`grow_shapes` finds them before circles compete with them.

    Raises:
        NoModelError: as there.
    """
    return _chosen(_all_lines(ridges, rules), ridges, rules.shortest)


def _all_lines(ridges: RidgePoints, rules: GrowthRules) -> list[Grown]:
    found = grow_lines(*_inputs(ridges, rules), (_MOST_LINES, _MOST_MEMBERS))
    if len(found[0]) > _MOST_LINES or len(found[2]) > _MOST_MEMBERS:
        raise NoModelError(
            Code.PART_TOO_COMPLEX,
            "the lines of the sheet are too many, or cross each other too often, to be "
            "distinguished: "
            "draw less in one sheet, or cut the views out of the picture",
            case="picture",
        )
    return [Grown(_line(row), values) for row, values in _unpacked(found)]


def _inputs(ridges: RidgePoints, rules: GrowthRules) -> tuple[tuple, tuple, tuple]:
    """What the kernels take: tables, limits, fit."""
    cosine = float(np.cos(np.radians(rules.turn_degrees)))
    return (
        (ridges.points, ridges.tangents, ridges.index),
        (rules.gap, rules.band, cosine),
        (float(rules.shortest), rules.flattest, rules.rms, rules.bowed),
    )


def warm_up() -> None:
    """Compile the kernels, or load them from numba's cache, so that the first sheet is quick."""
    tables = (np.zeros((0, 2)), np.zeros((0, 2)), np.full((1, 1), -1, dtype=np.int32))
    limits, fit = (14.0, 0.8, 0.97), (5.0, 0.35, 0.32, 0.8)
    most = (_MOST_LINES, _MOST_MEMBERS)
    rows, splits, members = grow_lines(tables, limits, fit, most)
    line_worth(tables[0], splits, members, rows, ON_LINE)
    grow_arcs(tables, limits, fit, np.zeros(0))


def _line(row: Floats) -> Line:
    return Line((float(row[0]), float(row[1])), (float(row[2]), float(row[3])))


def _circle(row: Floats) -> Circle:
    return Circle((float(row[0]), float(row[1])), float(row[2]))


def _unpacked(
    found: tuple[Floats, npt.NDArray[np.int64], npt.NDArray[np.int64]],
) -> Iterator[tuple[Floats, npt.NDArray[np.int64]]]:
    """Rows with the members of each; what at last has none, as all its points bend, is no shape."""
    rows, splits, members = found
    for k, row in enumerate(rows):
        if splits[k + 1] > splits[k]:
            yield row, members[splits[k] : splits[k + 1]]


def _chosen(shapes: list[Grown], ridges: RidgePoints, shortest: int) -> list[Grown]:
    """Greedily the shape that follows the most points that no other has taken."""
    worth = _worth(shapes, ridges.points)
    queue = [(-float(values.sum()), k) for k, values in enumerate(worth)]
    heapq.heapify(queue)
    free = np.ones(len(ridges.points), dtype=bool)
    in_circle = np.zeros(len(ridges.points), dtype=bool)
    loose = np.full(len(ridges.points), -1)
    chosen = []
    while queue:
        score, k = heapq.heappop(queue)
        members = shapes[k].members
        is_line = isinstance(shapes[k].geometry, Line)
        left = free[members]
        if is_line and (circles := loose[members]).max() >= 0:
            # A short line between two arcs that it touches has few points that they leave.
            left = left | _is_touched(shapes[k].line, circles, shapes)
        count = np.count_nonzero(left)
        if count < shortest:
            continue
        enough = _FRESH * len(members)
        if is_line and count >= _ENOUGH and in_circle[members[~left]].all():
            enough = _ENOUGH
        if count < enough:
            continue
        current = -float(worth[k][left].sum())
        if current > score:
            heapq.heappush(queue, (current, k))
            continue
        is_arc = isinstance(shapes[k].geometry, Circle)
        in_circle[members[left]] = is_arc
        row = shapes[k].geometry.distances(ridges.points[members]) <= COURSE
        loosely = is_arc & ~row & (free | (loose >= 0))[members]
        loose[members] = np.where(loosely, k, -1)
        free[members] = False
        chosen.append(shapes[k])
    return chosen


def _worth(shapes: Sequence[Grown], points: Floats) -> list[Floats]:
    """For each shape (k,) what each of its members counts for."""
    worth = [np.empty(0)] * len(shapes)
    lines = [k for k, shape in enumerate(shapes) if isinstance(shape.geometry, Line)]
    if lines:
        # All at once: there are thousands.
        splits = np.cumsum([0, *(len(shapes[k].members) for k in lines)])
        members = np.concatenate([shapes[k].members for k in lines])
        rows = np.array([(*shapes[k].line.point, *shapes[k].line.direction) for k in lines])
        all_worth = _BONUS[Line] * line_worth(points, splits, members, rows, ON_LINE)
        items = np.split(all_worth, splits[1:-1])
        for k, each in zip(lines, items, strict=True):
            worth[k] = each
    for k, grown in enumerate(shapes):
        if not isinstance(grown.geometry, Line):
            away = grown.geometry.distances(points[grown.members])
            worth[k] = _bonus(grown, points) * _closeness(away)
    return worth


def _is_touched(
    line: Line, circles: npt.NDArray[np.int64], shapes: list[Grown]
) -> npt.NDArray[np.bool_]:
    """Of (n,) numbers of circles, -1 for none, whether a line touches each."""
    touched = np.zeros(len(circles), dtype=bool)
    for k in np.unique(circles[circles >= 0]):
        circle = shapes[k].geometry
        away = float(line.distances(np.array([circle.centre]))[0])
        touched |= (circles == k) & (abs(away - circle.radius) <= TOUCHING)
    return touched


def _bonus(grown: Grown, points: Floats) -> float:
    if isinstance(grown.geometry, Circle):
        chord = float(np.hypot(*np.ptp(points[grown.members], axis=0)))
        if chord**2 / (8.0 * grown.geometry.radius) < _FLAT_PX:
            return _FLAT
    return _BONUS[type(grown.geometry)]


def _closeness(away: Floats) -> Floats:
    """(k,) 1 for members on the centre line, falling to 0 for those so many px beside it."""
    return np.clip(1.0 - (away / ON_LINE) ** 2, 0.0, 1.0)
