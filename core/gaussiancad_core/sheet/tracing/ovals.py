"""Ellipses grown along ridge points: circles of the part that are seen at a slant.

An arc that the growth of circles gave is the start.  The ellipse through its points is followed
both ways, across gaps as wide as those between dashes, fitted to what it meets, and so on until it
ends.  It stays if it is one beyond doubt: where a circle fits, or a line and a fillet, it goes.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse, ellipse_through, refined
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sheet.picture_noise import FEWEST_PIXELS, LARGEST_RADIUS, SMALLEST_RADIUS
from gaussiancad_core.sheet.tracing.growth_kernels import CONSUMED, CONSUMED_COSINE, NEARER
from gaussiancad_core.sheet.tracing.ridges import RidgePoints
from gaussiancad_core.sheet.votes import LARGELY

Floats = npt.NDArray[np.float64]
Rows = npt.NDArray[np.int64]

_BANDS = (1.8, 1.8, 1.2, 1.2, 0.8)
"""px beside an ellipse that are looked at turn by turn; the last goes on."""

_TURNS = 16
"""Times that an ellipse is fitted and followed, at most."""

_LEAST_TURN = np.radians(80.0)
"""Turn of the tangent from which a curve tells its ellipse."""

_OFF = 0.2
"""Largest distance in px of nine in ten points, each the mean of its neighbours along the curve."""

_SMOOTHED = 7
"""Neighbours over which the noise of ridge points evens out."""

_ROUND = 0.3
"""Root mean square in px of the distances from a circle up to which the circle fits as well."""

_SECTORS = 36
"""Sectors of a circle: most of those of a whole one have points."""

_FILLED = 0.4
"""Share of the way along an ellipse that has points."""


@dataclass(frozen=True)
class OvalRules:
    """When points belong to an ellipse.

    Attributes:
        gap: px, widest stretch without points that is crossed.
        band: px, farthest from the centre line.
        cosine: of the largest angle between a point's tangent and the ellipse's.
    """

    gap: float
    band: float
    cosine: float


def grow_ovals(
    ridges: RidgePoints, seeds: Iterable[tuple[Circle, Rows]], adjacent: Floats, rules: OvalRules
) -> list[tuple[WholeEllipse, Rows]]:
    """Ellipses that explain ridge points, with the rows of those points.

    Args:
        ridges: the points.
        seeds: arcs with the rows of their points, those with most first.
        adjacent: (n,) px from each point to the line that has it, infinite where none has.
        rules: when points belong.
    """
    found: list[tuple[WholeEllipse, Rows]] = []
    explained = np.zeros(len(ridges.points), dtype=bool)
    for circle, members in seeds:
        if len(members) < 5 or explained[members].mean() > 0.5:
            continue
        if _is_whole_circle(circle, ridges.points[members]):
            explained[members] = True
            continue
        grown = _grown(ridges, circle, members, adjacent, rules)
        if grown is None:
            continue
        ellipse, seed = grown
        wide = OvalRules(rules.gap, CONSUMED, CONSUMED_COSINE)
        values = _followed(ridges, ellipse, seed, np.full(len(explained), np.inf), wide)[0]
        explained[values] = True
        found.append((ellipse, values))
    return found


def _is_whole_circle(circle: Circle, points: Floats) -> bool:
    """Whether points lie around a circle, on it: nothing else is to be found there."""
    offset = points - np.array(circle.centre)
    turned = np.unique(np.floor(np.arctan2(offset[:, 1], offset[:, 0]) * (_SECTORS / (2 * np.pi))))
    return len(turned) > LARGELY * _SECTORS and circle.distances(points).mean() < _OFF


def _grown(
    ridges: RidgePoints, circle: Circle, members: Rows, adjacent: Floats, rules: OvalRules
) -> tuple[WholeEllipse, int] | None:
    """The ellipse that an arc is a piece of, and one of its points."""
    points = ridges.points
    ellipse = _start(points[members], circle)
    seed = int(members[np.argmin(ellipse.distances(points[members]))])
    before = 0
    values, turned = members, 0.0
    for turn in range(_TURNS):
        band = max(rules.band, _BANDS[min(turn, len(_BANDS) - 1)])
        looser = OvalRules(rules.gap, band, rules.cosine)
        values, turned, length = _followed(ridges, ellipse, seed, adjacent, looser)
        if len(values) < 8:
            return None
        for _ in range(2):
            ellipse = refined(ellipse, points[values])
        if not SMALLEST_RADIUS <= ellipse.semi_minor <= ellipse.semi_major <= LARGEST_RADIUS:
            return None
        if turn >= len(_BANDS) and len(values) == before:
            break
        before = len(values)
    filled = len(values) >= max(FEWEST_PIXELS, _FILLED * length)
    stated = filled and turned >= _LEAST_TURN and _fits(points[values], ellipse)
    return (ellipse, seed) if stated else None


def _start(points: Floats, circle: Circle) -> WholeEllipse:
    """The ellipse through the points of an arc, or its circle where they tell none."""
    ellipse = ellipse_through(points)
    if ellipse is not None:
        sane = SMALLEST_RADIUS <= ellipse.semi_minor <= ellipse.semi_major < 4.0 * circle.radius
        if sane and ellipse.distances(points).mean() < 0.5:
            return ellipse
    return WholeEllipse(circle.centre, circle.radius, circle.radius, 0.0)


def _followed(
    ridges: RidgePoints, ellipse: WholeEllipse, seed: int, adjacent: Floats, rules: OvalRules
) -> tuple[Rows, float, float]:
    """The points along an ellipse from a seed to a gap both ways, the angle that its tangent turns
    by from the first to the last, and the length between them."""
    local = ellipse.local(ridges.points)
    # How far this is from 1, times the minor half axis, is never more than the distance.
    level = np.hypot(local[:, 0] / ellipse.semi_major, local[:, 1] / ellipse.semi_minor)
    rows = np.flatnonzero(np.abs(level - 1.0) * ellipse.semi_minor <= rules.band)
    across, parameters = ellipse.away(ridges.points[rows])
    tangents = ellipse.tangents(parameters)
    alike = np.abs((tangents * ridges.tangents[rows]).sum(1))
    near = np.abs(across) <= np.minimum(rules.band, adjacent[rows] + NEARER)
    bend = _radii(ellipse, parameters)
    slack = np.cos(np.minimum(np.arccos(rules.cosine) + 1.2 / bend, 1.2))
    kept = (near & (alike >= slack)) | (rows == seed)
    rows, parameters = rows[kept], parameters[kept]
    if seed not in rows:
        return rows[:0], 0.0, 0.0
    around = ellipse.around
    along = np.mod(ellipse.lengths(parameters), around)
    order = np.argsort(along, kind="stable")
    rows, along, parameters = rows[order], along[order], parameters[order]
    gaps = np.diff(along, append=along[0] + around)
    wide = np.flatnonzero(gaps > rules.gap)
    if not len(wide):
        return rows, 2 * np.pi, around
    at = int(np.flatnonzero(rows == seed)[0])
    first = int(wide[wide < at][-1]) + 1 if (wide < at).any() else int(wide[-1]) + 1 - len(rows)
    last = int(wide[wide >= at][0]) if (wide >= at).any() else int(wide[0]) + len(rows)
    chosen = np.arange(first, last + 1) % len(rows)
    ends = ellipse.tangents(parameters[chosen[[0, -1]]])
    length = float((along[chosen[-1]] - along[chosen[0]]) % around)
    turned = float(np.arctan2(_cross(ends[0], ends[1]), ends[0] @ ends[1]) % (2 * np.pi))
    return rows[chosen], turned, length


def _cross(one: Floats, other: Floats) -> float:
    return float(one[0] * other[1] - one[1] * other[0])


def _radii(ellipse: WholeEllipse, parameters: Floats) -> Floats:
    """(n,) radii of curvature."""
    a, b = ellipse.semi_major, ellipse.semi_minor
    return np.hypot(a * np.sin(parameters), b * np.cos(parameters)) ** 3 / (a * b)


def _fits(points: Floats, ellipse: WholeEllipse) -> bool:
    """Whether points follow an ellipse without swinging from side to side, and no circle."""
    away, _ = ellipse.away(points)
    kernel = np.ones(_SMOOTHED) / _SMOOTHED
    swing = np.abs(np.convolve(away, kernel, mode="valid"))
    if np.percentile(swing, 90) > _OFF:
        return False
    local = points - points.mean(0)
    system = np.column_stack([2.0 * local, np.ones(len(local))])
    solution = np.linalg.lstsq(system, (local**2).sum(1), rcond=None)[0]
    radius = np.sqrt(max(float(solution[2] + solution[:2] @ solution[:2]), 0.0))
    neighbour = np.hypot(*(local - solution[:2]).T) - radius
    return float(np.sqrt((neighbour**2).mean())) > _ROUND
