"""Arcs that end in short straight pieces along the axes of the sheet.

The end of a slot whose sides are a few px long is all but a circle that is a little too large.  A
half circle between two parallel lines has its centre and radius to fit, as the circle has, and so
has an arc that goes on straight at one end: whichever follows the ink is what is drawn.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import STEP, Piece
from gaussiancad_core.sheet.shapes import radial_profile, sample
from gaussiancad_core.sheet.stubs import Placed

Floats = npt.NDArray[np.float64]

_SWEEP = np.radians(40.0), np.radians(330.0)
"""Turn of such an arc at least and at most."""

_TURN = np.radians(30.0)
"""Angle between the arc's direction at its end and the axis along which it goes on, at most."""

_SHORTEST_PX = 24.0
"""Length of such an arc at least."""

_FEWEST = 16
"""Places at which its ink is clear, at least."""

_LEAST_PX = 3.0
"""Length of a straight piece at least, beyond the stroke that it may end on."""

_OFF_PX = 0.15
"""px by which the ink is off the best circle at some place at least."""

_PARALLEL = float(np.cos(np.radians(6.0)))
"""Cosine of the angle between a straight end and a line that was bent into its arc, at least."""

_EVEN = float(np.cos(np.radians(0.8)))
"""Cosine of the angle between a straight end and a line that has its ink alone, at least."""

_BENT, _BESIDE_PX = 4.0, 1.5
"""Length of such a line at most, in the end's, and px by which it passes the end's middle."""

_INK = 0.5
"""Weight from which a place is ink."""

_BETTER = 0.5
"""Root mean square distance of the ink from straight ends, in that from the circle, at most."""


@dataclass(frozen=True)
class _Fit:
    """An arc with straight ends: its circle, where it goes on straight, and how well it fits."""

    circle: Circle
    ways: tuple[tuple[float, float], ...]
    error: float


def with_straight_ends(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces of a view, arcs that go on straight at an end in two or three parts.

    Lines that were bent into such an arc go: its straight ends have their ink.

    Args:
        pieces: px.
        sheet: their ink.
    """
    found: list[Placed] = []
    straight: list[Placed] = []
    for geometry, piece in pieces:
        fit = _fit(geometry, piece, sheet) if isinstance(geometry, Circle) else None
        parts = [] if fit is None else list(_parts(geometry, piece, fit, sheet))
        # Where a line is known there, it has the ink.
        ends = [
            end
            for end in parts[:-1]
            if not any(_shares_ink(own, end, _EVEN, 1.0) for own in pieces)
        ]
        straight += ends
        found.append(parts[-1] if ends else (geometry, piece))
    if not straight:
        return found
    bent = [any(_shares_ink(own, end, _PARALLEL, _EVEN) for end in straight) for own in found]
    return [own for own, off in zip(found, bent, strict=True) if not off] + straight


def _fit(circle: Circle, piece: Piece, sheet: CleanSheet) -> _Fit | None:
    """What follows the ink better than any circle does, if anything."""
    length = piece.end - piece.start
    low, high = _SWEEP
    if length < _SHORTEST_PX or not low < length / circle.radius < high:
        return None
    ways = _ways(circle, piece)
    points = _places(circle, piece, sheet)
    if not ways or len(points) < _FEWEST:
        return None
    plain = _fitted(points, circle, ())
    off = np.abs(_distances(_values(plain.circle), points, ()))
    fits = [
        _fitted(points, plain.circle, chosen)
        for count in range(1, len(ways) + 1)
        for chosen in combinations(ways, count)
    ]
    # An end of which too little is straight may be drawn out a little by the fit.
    fits = [own for own in fits if (_beyond(points, own).max(axis=0) >= _LEAST_PX).all()]
    best = min(fits, key=lambda own: own.error, default=plain)
    if best.error >= plain.error:
        return None
    straight = (_beyond(points, best) > 0.0).any(axis=1)
    left = np.abs(_distances(_values(best.circle), points, best.ways))
    better = np.mean(left[straight] ** 2) <= _BETTER**2 * np.mean(off[straight] ** 2)
    return best if better and off[straight].max() >= _OFF_PX else None


def _beyond(points: Floats, fit: _Fit) -> Floats:
    """(n, ways) px by which points lie beyond where an arc goes on straight."""
    return (points - np.array(fit.circle.centre)) @ np.array(fit.ways).T


def _ways(circle: Circle, piece: Piece) -> list[tuple[float, float]]:
    """The axes' directions, unit vectors, in which an arc may go on at its ends."""
    ways: dict[tuple[float, float], None] = {}
    for at, outward in ((piece.start, -1.0), (piece.end, 1.0)):
        tangent = outward * circle.tangents_at(np.array([at]))[0]
        axis = int(np.abs(tangent).argmax())
        if abs(tangent[axis]) >= np.cos(_TURN):
            sign = float(np.sign(tangent[axis]))
            ways[(sign, 0.0) if axis == 0 else (0.0, sign)] = None
    return list(ways)


def _places(circle: Circle, piece: Piece, sheet: CleanSheet) -> Floats:
    """(n, 2) px on the middle of the ink, but for its ends, which others' ink meets."""
    angles, radii = radial_profile(sheet, circle, sheet.stroke_width / 2 + 1.5)
    along = (angles * circle.radius - piece.start) % circle.around
    within = (along > sheet.stroke_width) & (along < piece.end - piece.start - sheet.stroke_width)
    ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return (np.array(circle.centre) + radii[:, None] * ways)[within]


def _fitted(points: Floats, start: Circle, ways: tuple[tuple[float, float], ...]) -> _Fit:
    solved = least_squares(_distances, _values(start), args=(points, ways))
    x, y, radius = (float(value) for value in solved.x)
    error = float(np.sqrt(np.mean(solved.fun**2)))
    return _Fit(Circle((x, y), abs(radius)), ways, error)


def _values(circle: Circle) -> Floats:
    return np.array([*circle.centre, circle.radius])


def _distances(values: Floats, points: Floats, ways: tuple[tuple[float, float], ...]) -> Floats:
    """(n,) px from points to a circle of values (x, y, radius) that goes on straight some ways."""
    offset = points - values[:2]
    distances = np.hypot(*offset.T)
    for way in ways:
        straight = offset @ np.array(way) > 0.0
        beside = np.abs(offset @ np.array([-way[1], way[0]]))
        distances = np.where(straight, beside, distances)
    return distances - values[2]


def _inked_up_to(line: Line, end: float, sheet: CleanSheet) -> float:
    """Where the ink of a straight end ends, a few px beyond where the arc was seen to."""
    along = end + np.arange(0.0, 3.0 * sheet.stroke_width, STEP)
    points = line.points_at(along)
    blank = np.flatnonzero(sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] < _INK)
    return float(along[max(int(blank[0]) - 1, 0) if len(blank) else -1])


def _shares_ink(own: Placed, straight: Placed, least: float, most: float) -> bool:
    """Whether a line has the ink of a straight end, from the cosine of the angle between them: one
    that was fitted to the arc behind it as well is turned a little."""
    line, piece = own
    end, extent = straight
    if not isinstance(line, Line) or not isinstance(end, Line):
        return False
    if not least <= abs(float(np.dot(line.direction, end.direction))) <= most + 1e-12:
        return False
    if most < 1.0 and piece.end - piece.start > _BENT * extent.end:
        return False
    middle = end.points_at(np.array([0.5 * (extent.start + extent.end)]))
    (along,), (across,) = line.coordinates(middle)
    return abs(across) < _BESIDE_PX and piece.start < along < piece.end


def _parts(old: Circle, piece: Piece, fit: _Fit, sheet: CleanSheet) -> Iterator[Placed]:
    """The straight ends, then the arc."""
    circle, ends = fit.circle, old.points_at(np.array([piece.start, piece.end]))
    centre = np.array(circle.centre)
    touches = ends.copy()
    for k, end in enumerate(ends):
        for way in fit.ways:
            beyond = float((end - centre) @ np.array(way))
            if beyond <= 0.0:
                continue
            normal = np.array([-way[1], way[0]])
            side = float(np.sign((end - centre) @ normal))
            touches[k] = centre + side * circle.radius * normal
            x, y = touches[k]
            line = Line((float(x), float(y)), way)
            yield line, replace(piece, start=0.0, end=_inked_up_to(line, beyond, sheet))
    first, last = (float(at) for at in circle.positions(touches))
    last = first + (last - first) % circle.around
    yield circle, replace(piece, start=first, end=last)
