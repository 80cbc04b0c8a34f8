"""B-splines back to what they stand for: lines, arcs, and one chain for what is neither.

Where its curvature may jump, at knots as many as its degree less one, a spline may pass from a
straight piece to a round one; between such knots it is one piece.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.file_curves import SMALLEST_SWEEP
from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.ellipses import LEAST_SWEEP
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped

Points = npt.NDArray[np.float64]
"""(n, 2)"""

_FLATNESS = 5e-6
"""Share of a free curve's own size by which its chain may leave it."""

_STEPS, _MOST_STEPS, _MOST_OF_ALL = 8, 1024, 100_000
"""Chords that a polynomial is looked at by, that stand for one at most, and for all of a spline
but for those that each is looked at by."""

_BESIDE = 1e-5
"""Share of its length by which a piece that is straight or round may leave that: files round."""

_QUARTER, _BESIDE_QUARTER = np.pi / 2.0, 1.5e-3
"""Turn from which polynomials leave their circle by as much as they ever do, and share of the
radius by which they may; the usual ones of a quarter circle do by 2.7e-4, and those of less by the
sixth power of that."""

_SHORTEST = 0.05
"""Length of a straight piece in the spline's size, from which it is one between free pieces."""

_SMOOTH = np.radians(10.0)
"""Turn from chord to chord at most where pieces go on in each other smoothly."""


@dataclass(frozen=True, eq=False)
class Spline:
    """A B-spline.

    Attributes:
        control: (n, 2) its control points, finite.
        knots: (n + degree + 1,) in order, finite.
        degree: of its polynomials, at least 1.
        weights: (n,) positive; None of one that is not rational.
    """

    control: Points
    knots: npt.NDArray[np.float64]
    degree: int
    weights: npt.NDArray[np.float64] | None = None


def spline_curves(spline: Spline) -> list[Curve]:
    """Lines and arcs along a spline, and chains along what is neither, in the spline's unit; no
    curve if it has no size.

    Raises:
        ValueError: it has no polynomial, or a number of it is none that it may be.
    """
    _check(spline)
    size = float(np.ptp(spline.control, axis=0).max())
    if size <= 0.0:
        return []
    sections = _sections(spline, size)
    if len(sections) > 1:
        points = [sections[0].points[:1], *(section.points[1:] for section in sections)]
        nodes = np.concatenate([section.nodes for section in sections])
        arc = _arc(_Section(np.concatenate(points), nodes))
        if arc is not None and arc.sweep >= _QUARTER:
            return [arc]
    pieces = [_piece(section) for section in sections if np.ptp(section.points, axis=0).any()]
    return [piece.curve for piece in _joined(_with_whole_chains(_joined(pieces), size))]


def _check(spline: Spline) -> None:
    count, knots = len(spline.control), spline.knots
    numbers = [spline.control, knots, *([] if spline.weights is None else [spline.weights])]
    if not all(np.isfinite(values).all() for values in numbers):
        raise ValueError("a number of a spline is no finite one")
    if spline.degree < 1 or count <= spline.degree or len(knots) != count + spline.degree + 1:
        raise ValueError("a spline has too few points or knots")
    if (np.diff(knots) < 0.0).any() or knots[spline.degree] >= knots[count]:
        raise ValueError("the knots of a spline are in no order")
    if spline.weights is not None and not (spline.weights > 0.0).all():
        raise ValueError("a weight of a spline is not positive")


@dataclass(frozen=True, eq=False)
class _Section:
    """A part of a spline along which its curvature goes on.

    Attributes:
        points: (n, 2) corners of a chain along it.
        nodes: (k, 2) ends and middles of its polynomials: arcs are written so that these lie on
            them.
    """

    points: Points
    nodes: Points


def _sections(spline: Spline, size: float) -> list[_Section]:
    degree, count = spline.degree, len(spline.control)
    inner = spline.knots[degree : count + 1]
    places, repeats = np.unique(inner, return_counts=True)
    spans = np.searchsorted(spline.knots, places[:-1], side="right") - 1
    shares = np.linspace(0.0, 1.0, _STEPS + 1)
    rough = _at(spline, np.repeat(spans, _STEPS + 1), _spread(places, shares)).reshape(
        -1, _STEPS + 1, 2
    )
    bend = np.hypot(*np.moveaxis(np.diff(rough, 2, axis=1), 2, 0)).max(axis=1) / 8.0
    finer = np.ceil(np.sqrt(bend / (_FLATNESS * size)))
    most = max(1, min(_MOST_STEPS, _MOST_OF_ALL // len(spans)) // _STEPS)
    steps = np.clip(finer, 1, most).astype(np.int64) * _STEPS
    owner = np.repeat(np.arange(len(spans)), steps)
    number = np.arange(len(owner)) - np.repeat(np.cumsum(steps) - steps, steps)
    parameters = places[owner] + (number / steps[owner]) * np.diff(places)[owner]
    points = np.append(_at(spline, spans[owner], parameters), rough[-1, -1:], axis=0)
    if not np.isfinite(points).all():
        raise ValueError("a point of a spline is no finite one")
    cuts = np.flatnonzero(repeats[1:-1] >= max(degree - 1, 1)) + 1
    ends = np.array([0, *cuts, len(spans)])
    firsts = np.append(np.cumsum(steps) - steps, len(owner))
    return [
        _Section(
            points[firsts[first] : firsts[last] + 1],
            rough[first:last, [0, _STEPS // 2, _STEPS]].reshape(-1, 2),
        )
        for first, last in pairwise(ends.tolist())
    ]


def _spread(places: Points, shares: Points) -> Points:
    """(n,) parameters at shares of each interval between places."""
    return np.asarray((places[:-1, None] + np.diff(places)[:, None] * shares).ravel())


def _at(spline: Spline, spans: npt.NDArray[np.int64], parameters: Points) -> Points:
    """(n, 2) points of a spline (de Boor 1972).

    Args:
        spline: it.
        spans: (n,) number of the last knot before each parameter.
        parameters: (n,).
    """
    degree, knots = spline.degree, spline.knots
    weights = np.ones(len(spline.control)) if spline.weights is None else spline.weights
    local = np.column_stack([spline.control * weights[:, None], weights])
    held = [local[spans - degree + index] for index in range(degree + 1)]
    for level in range(1, degree + 1):
        for index in range(degree, level - 1, -1):
            low = knots[spans - degree + index]
            high = knots[spans + 1 + index - level]
            share = ((parameters - low) / (high - low))[:, None]
            held[index] = (1.0 - share) * held[index - 1] + share * held[index]
    return np.asarray(held[degree][:, :2] / held[degree][:, 2:])


@dataclass(frozen=True, eq=False)
class _Piece:
    """A section, or several, and the curve that it is."""

    section: _Section
    curve: Curve


def _piece(section: _Section) -> _Piece:
    line = _line(section.points)
    return _Piece(section, line or _arc(section) or _chain(section.points))


def _line(points: Points) -> LineSegment | None:
    chord = points[-1] - points[0]
    length = float(np.hypot(*chord))
    if length <= 0.0:
        return None
    across = (points - points[0]) @ np.array([-chord[1], chord[0]]) / length
    along = np.diff(points @ chord) / length
    if np.abs(across).max() > _BESIDE * length or along.min() < -_BESIDE * length:
        return None
    return LineSegment(to_point(points[0]), to_point(points[-1]))


def _arc(section: _Section) -> CircularArc | None:
    points = section.points
    centre, radius = circle_through(section.nodes)
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    turn = min(1.0, abs(sweep) / _QUARTER)
    most = max(_BESIDE * abs(sweep), _BESIDE_QUARTER * turn**6) * radius
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    if away.max() > most or not one_way or not SMALLEST_SWEEP <= abs(sweep) <= 1.001 * FULL_TURN:
        return None
    if np.hypot(*(points[-1] - points[0])) <= _BESIDE * radius:
        sweep = float(np.copysign(FULL_TURN, sweep))
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(to_point(centre), radius, wrapped(start), min(abs(sweep), FULL_TURN))


def _chain(points: Points) -> Chain:
    corners = [(x, y) for x, y in points.tolist()]
    if np.hypot(*(points[-1] - points[0])) <= _BESIDE * np.ptp(points, axis=0).max():
        corners[-1] = corners[0]
    return Chain(tuple(corners))


def _with_whole_chains(pieces: list[_Piece], size: float) -> list[_Piece]:
    """The pieces, those free that go on smoothly in free ones and are but a little straight or
    round: every smooth curve is, where its curvature has an extreme or is none."""
    pieces = list(pieces)
    left = [number for number, piece in enumerate(pieces) if isinstance(piece.curve, Chain)]
    while left:
        number = left.pop()
        here = pieces[number].section.points
        for neighbour, is_after in ((number - 1, False), ((number + 1) % len(pieces), True)):
            section = pieces[neighbour].section
            ends = (here, section.points) if is_after else (section.points, here)
            if _is_little(pieces[neighbour].curve, size) and _go_on(*ends):
                pieces[neighbour] = _Piece(section, _chain(section.points))
                left.append(neighbour % len(pieces))
    return pieces


def _is_little(curve: Curve, size: float) -> bool:
    """Whether a line or arc is so short that it may be a part of a free curve of some size."""
    if isinstance(curve, LineSegment):
        return curve.length < _SHORTEST * size
    return isinstance(curve, CircularArc) and curve.sweep < LEAST_SWEEP


def _joined(pieces: list[_Piece]) -> list[_Piece]:
    """The pieces, those that go on as one curve joined."""
    found: list[_Piece] = []
    for piece in pieces:
        whole = _one(found[-1], piece) if found else None
        if whole is not None:
            found[-1] = whole
        else:
            found.append(piece)
    # A closed spline may begin within a piece.
    if len(found) > 1:
        whole = _one(found[-1], found[0])
        if whole is not None:
            found = [whole, *found[1:-1]]
    return found


def _one(before: _Piece, after: _Piece) -> _Piece | None:
    """Two pieces as one, if they are pieces of one curve."""
    first, second = before.section.points, after.section.points
    if type(before.curve) is not type(after.curve) or not _go_on(first, second):
        return None
    section = _Section(
        np.concatenate([first, second[1:]]),
        np.concatenate([before.section.nodes, after.section.nodes]),
    )
    if isinstance(before.curve, Chain):
        return _Piece(section, _chain(section.points))
    curve = _line(section.points) if isinstance(before.curve, LineSegment) else _arc(section)
    if curve is None or not _are_alike(before.curve, after.curve):
        return None
    return _Piece(section, curve)


def _go_on(first: Points, second: Points) -> bool:
    """Whether a chain goes on in a second one smoothly."""
    size = float(np.ptp(np.concatenate([first, second]), axis=0).max())
    if np.hypot(*(second[0] - first[-1])) > _BESIDE * size:
        return False
    ways = np.concatenate([np.diff(first[-2:], axis=0), np.diff(second[:2], axis=0)])
    angles = np.arctan2(ways[:, 1], ways[:, 0])
    return bool(abs(np.angle(np.exp(1j * (angles[1] - angles[0])))) <= _SMOOTH)


def _are_alike(one: Curve, other: Curve) -> bool:
    """Whether arcs have one radius; lines always do."""
    if not isinstance(one, CircularArc) or not isinstance(other, CircularArc):
        return True
    return abs(one.radius - other.radius) <= _BESIDE_QUARTER * max(one.radius, other.radius)
