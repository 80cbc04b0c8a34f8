"""Wide arcs with a short straight piece between them: the end of a slot whose corners are rounded.

Where only a few px are left between two rounded corners nothing tells the straight piece: one
circle, or two, or an ellipse grow along both arcs, a little too large.  Two arcs and the piece
between them have their middle, their radius and its length to fit, and follow the ink where no such
curve does.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares

from gaussiancad_core.ellipses import WholeEllipse
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Curve, Line
from gaussiancad_core.sheet.junctions import Placed, is_full_circle
from gaussiancad_core.sheet.runs import Piece
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_LEAST_RADIUS = 12.0
"""px of an arc that is grown for sure."""

_ALIKE, _LEVEL_PX, _ASIDE = 0.08, 1.0, 0.3
"""Share of the radius by which two circles differ at most, px by which their centres are out of
level, and share of the radius by which these are apart."""

_TURN = np.radians(30.0)
"""By which an arc goes on beyond the middle of the straight piece, both ways, at least."""

_FLAT_PX, _MOST = 3.0, 0.8
"""Length of a straight piece at least, and at most, in radii."""

_FEWEST = 24
"""Places at which the ink is clear, at least."""

_OFF_PX, _BETTER = 0.15, 0.5
"""px by which the ink is off the curves somewhere at least; root mean square distance of the ink
from the arcs with a piece between them, in that from the curves, at most."""

_STEP, _ACROSS = 1.0, 0.25
"""px between places along a curve, and across it."""


@dataclass(frozen=True)
class _End:
    """What may be a rounded end.

    Attributes:
        numbers: of its pieces.
        arcs: them.
        axis: along which its straight piece lies, 0 or 1.
        top: 1 or -1, on which side of the centres along the other axis that is.
        start: middle between the centres, half of the straight piece, and radius, at first; px.
    """

    numbers: tuple[int, ...]
    arcs: tuple[tuple[Curve, Piece], ...]
    axis: int
    top: float
    start: tuple[float, float, float, float]


def with_flat_ends(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces of a view, wide arcs around rounded ends with the straight piece between them.

    Args:
        pieces: where their ink is seen; px, pixel centres at integers.
        sheet: the ink.
    """
    found: list[Placed] = []
    gone: set[int] = set()
    for end in _ends(pieces):
        parts = None if gone & {*end.numbers} else _parts(end, sheet)
        if parts is not None:
            gone |= {*end.numbers}
            found += parts
    return [own for k, own in enumerate(pieces) if k not in gone] + found


def _ends(pieces: Sequence[Placed]) -> Iterator[_End]:
    curves = [
        (index, geometry, piece)
        for index, (geometry, piece) in enumerate(pieces)
        if not isinstance(geometry, Line)
        and piece.linetype is Linetype.VISIBLE
        and not is_full_circle(geometry, piece)
        and min(_size(geometry)) >= _LEAST_RADIUS
    ]
    for (i, one, its), (k, other, own) in combinations(curves, 2):
        if not isinstance(one, Circle) or not isinstance(other, Circle):
            continue
        way = np.abs(np.subtract(one.centre, other.centre))
        axis = int(np.argmax(way))
        alike = abs(one.radius - other.radius) <= _ALIKE * one.radius
        if alike and way[1 - axis] <= _LEVEL_PX and way[axis] <= _ASIDE * one.radius:
            x, y = ((np.add(one.centre, other.centre)) / 2.0).tolist()
            start = x, y, _FLAT_PX, (one.radius + other.radius) / 2.0
            for top in (-1.0, 1.0):
                if all(_passes(*arc, axis, top, 0.0) for arc in ((one, its), (other, own))):
                    yield _End((i, k), ((one, its), (other, own)), axis, top, start)
    for index, curve, piece in curves:
        x, y = curve.centre
        longer, shorter = _size(curve)
        for axis in (0, 1):
            start = x, y, max(longer - shorter, _FLAT_PX), shorter
            for top in (-1.0, 1.0):
                if _passes(curve, piece, axis, top, _TURN):
                    yield _End((index,), ((curve, piece),), axis, top, start)


def _size(curve: Curve) -> tuple[float, float]:
    """px of the longer and the shorter half axis."""
    if isinstance(curve, WholeEllipse):
        return curve.semi_major, curve.semi_minor
    return curve.radius, curve.radius


def _passes(curve: Curve, piece: Piece, axis: int, top: float, turn: float) -> bool:
    """Whether a curve goes on both ways, by an angle, from where it is level."""
    towards = np.zeros(2)
    towards[1 - axis] = top
    middle = np.array(curve.centre)
    far = 4.0 * _size(curve)[0]
    for angle in (-turn, 0.0, turn):
        cosine, sine = np.cos(angle), np.sin(angle)
        x, y = towards
        place = middle + far * np.array([cosine * x - sine * y, sine * x + cosine * y])
        at = (float(curve.positions(place[None])[0]) - piece.start) % curve.around
        if at > piece.end - piece.start:
            return False
    return True


def _parts(end: _End, sheet: CleanSheet) -> list[Placed] | None:
    """Both arcs anew, and the straight piece; None if the curves follow the ink as well."""
    seen = [_places(*arc, sheet) for arc in end.arcs]
    points = np.concatenate([places for places, _ in seen])
    plain = np.concatenate([off for _, off in seen])
    if len(points) < _FEWEST:
        return None
    fit = least_squares(_off, end.start, args=(points, end))
    x, y, half, radius = (float(value) for value in fit.x)
    if np.mean(fit.fun**2) > _BETTER**2 * np.mean(plain**2) or np.abs(plain).max() < _OFF_PX:
        return None
    if not _FLAT_PX <= 2.0 * half <= _MOST * radius:
        return None
    middle = np.array([x, y])
    outer = np.concatenate([c.points_at(np.array([p.start, p.end])) for c, p in end.arcs])
    along = (outer - middle)[:, end.axis]
    sides = [outer[int(np.argmax(side * along))] for side in (-1.0, 1.0)]
    piece = end.arcs[0][1]
    arcs = [
        (circle, replace(piece, start=first, end=last))
        for side, place in zip((-1.0, 1.0), sides, strict=True)
        for circle, first, last in [_arc(side, place, end, fit.x)]
    ]
    corner = middle.copy()
    corner[1 - end.axis] += end.top * radius
    corner[end.axis] -= half
    line = Line((float(corner[0]), float(corner[1])), (1.0 - end.axis, 0.0 + end.axis))
    return [*arcs, (line, replace(piece, start=0.0, end=2.0 * half))]


def _places(curve: Curve, piece: Piece, sheet: CleanSheet) -> tuple[Floats, Floats]:
    """(n, 2) px on the middle of the ink, but for its ends, which others' ink meets, and (n,) px by
    which it is off the curve."""
    at = np.arange(piece.start + sheet.stroke_width, piece.end - sheet.stroke_width, _STEP)
    half = sheet.stroke_width / 2.0
    across = np.arange(-half - 1.5, half + 1.5 + _ACROSS / 2.0, _ACROSS)
    way = curve.tangents_at(at)
    normals = np.stack([-way[:, 1], way[:, 0]], axis=1)
    middle = curve.points_at(at)
    points = middle[:, None] + across[:, None] * normals[:, None]
    ink = sample(sheet.weight, points[..., 0], points[..., 1])
    total = ink.sum(axis=1)
    off = (ink @ across) / np.maximum(total, 1e-9)
    # Where another stroke passes there is more ink.
    clear = (total * _ACROSS <= 1.3 * sheet.stroke_width) & (total * _ACROSS >= 0.6 * half)
    return (middle + off[:, None] * normals)[clear], off[clear]


def _off(values: Floats, points: Floats, end: _End) -> Floats:
    """(n,) px from points to two arcs, what is between them, and their tangents behind."""
    offset = points - values[:2]
    along = np.abs(offset[:, end.axis])
    up = end.top * offset[:, 1 - end.axis]
    round_ = np.hypot(np.maximum(along - values[2], 0.0), up) - values[3]
    return np.where(up < 0.0, along - values[2] - values[3], round_)


def _arc(side: float, place: Floats, end: _End, values: Floats) -> tuple[Circle, float, float]:
    """An arc from where the straight piece begins to its outer end at (2,) px, or a quarter of a
    turn: its circle, and from where to where."""
    centre, (half, radius) = values[:2].copy(), values[2:]
    centre[end.axis] += side * half
    circle = Circle((float(centre[0]), float(centre[1])), float(radius))
    corner, outer = centre.copy(), place
    corner[1 - end.axis] += end.top * radius
    if end.top * (outer - centre)[1 - end.axis] < 0.0:
        outer = centre.copy()
        outer[end.axis] += side * radius
    first, last = (float(at) for at in circle.positions(np.array([corner, outer])))
    if (last - first) % circle.around > circle.around / 2.0:
        first, last = last, first
    return circle, first, first + (last - first) % circle.around
