"""Exact curves from what files hold: mapped ellipses, Bézier curves, points along a curve."""

from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.files.vectors import (
    FULL_TURN,
    Chain,
    CircularArc,
    Curve,
    EllipticArc,
    Line,
    Point,
)

Vector = npt.NDArray[np.float64]
"""(2,)"""

FLATNESS = 0.02
"""px by which a chain may leave the curve that it follows."""

_ROUND = 1e-6
"""Relative difference of two axes under which an ellipse is a circle."""

_ARC_DEVIATION = 1.5e-3
"""Share of its radius by which a Bézier curve that stands for an arc may leave it; the usual
quarter circle does by 2.7e-4."""

_SAME_PLACE = 1e-2
"""px within which the circles of neighbouring arcs are one."""

_STRAIGHT = 5e-3
"""px by which a Bézier curve that is a line may leave it."""

_SMALLEST_SWEEP = np.radians(2.0)
"""Under this turn, the centre of a single Bézier arc is too uncertain."""

_MOST_CHORDS = 512
"""Chords of one Bézier curve, whatever its size."""


def to_point(value: Vector) -> Point:
    """A (2,) array as a tuple."""
    return float(value[0]), float(value[1])


def affine_arc(
    centre: Vector, u: Vector, v: Vector, start: float, sweep: float
) -> Curve:
    """The arc ``centre + u cos t + v sin t``, ``t`` from ``start`` on, over a signed ``sweep``.

    Any affine image of a circle has this form.  It comes back as a circular arc where it is one,
    as a line where it is seen edge-on, and as an elliptic arc otherwise.
    """
    axes, sizes, turn = np.linalg.svd(np.stack([u, v], axis=1))
    if np.linalg.det(axes) < 0.0:
        axes[:, 1] *= -1.0
        turn[1] *= -1.0
    sweep = float(np.clip(sweep, -FULL_TURN, FULL_TURN))
    low = start if sweep >= 0.0 else start + sweep
    handed = float(np.sign(np.linalg.det(turn)))
    if handed < 0.0:
        low = start + max(sweep, 0.0)
    first = turn @ np.array([np.cos(low), np.sin(low)])
    angle = float(np.arctan2(first[1], first[0]))
    sweep = abs(sweep)
    if sizes[1] <= 1e-9 * sizes[0]:
        reach = np.cos(angle + np.linspace(0.0, sweep, 257)) * sizes[0]
        ends = [centre + axes[:, 0] * value for value in (reach.min(), reach.max())]
        return Line(to_point(ends[0]), to_point(ends[1]))
    if sizes[0] - sizes[1] <= _ROUND * sizes[0]:
        tilt = float(np.arctan2(axes[1, 0], axes[0, 0]))
        radius = float(sizes.mean())
        return CircularArc(to_point(centre), radius, _wrapped(angle + tilt), sweep)
    major = to_point(axes[:, 0] * sizes[0])
    return EllipticArc(
        to_point(centre), major, float(sizes[1] / sizes[0]), _wrapped(angle), sweep
    )


def _wrapped(angle: float) -> float:
    """An angle in [0, 2 pi)."""
    turned = float(np.mod(angle, FULL_TURN))
    return turned if FULL_TURN - turned > 1e-12 else 0.0


def curves_from_beziers(beziers: list[npt.NDArray[np.float64]]) -> list[Curve]:
    """Lines, arcs, ellipses and chains for Bézier curves that join end to end.

    Args:
        beziers: (4, 2) control points each, in px.
    """
    whole = _whole_ellipse(beziers)
    if whole is not None:
        return [whole]
    curves: list[Curve] = []
    run: list[tuple[npt.NDArray[np.float64], CircularArc, bool]] = []
    for bezier in beziers:
        if _is_straight(bezier):
            curves += _joined(run) + [Line(to_point(bezier[0]), to_point(bezier[3]))]
            run = []
            continue
        fitted = _bezier_arc(bezier)
        if fitted is None:
            curves += [*_joined(run), _chain(bezier)]
            run = []
            continue
        if run and not (
            _same_circle(run[-1][1], fitted[0]) and run[-1][2] == fitted[1]
        ):
            curves += _joined(run)
            run = []
        run.append((bezier, *fitted))
    return _chains_linked(curves + _joined(run))


def curves_from_path(
    pieces: list[npt.NDArray[np.float64]], exact: bool = True
) -> list[Curve]:
    """Curves of a path whose pieces join end to end.

    Args:
        pieces: (2, 2) the ends of a line, or (4, 2) the control points of a Bézier curve, in px.
        exact: recognise arcs; else Bézier curves become chains.
    """
    curves: list[Curve] = []
    run: list[npt.NDArray[np.float64]] = []
    for piece in pieces:
        if len(piece) == 4:
            run.append(piece)
            continue
        if np.hypot(*(piece[1] - piece[0])) <= 1e-9:
            continue
        curves += _from_run(run, exact)
        run = []
        curves.append(Line(to_point(piece[0]), to_point(piece[1])))
    return curves + _from_run(run, exact)


def _from_run(run: list[npt.NDArray[np.float64]], exact: bool) -> list[Curve]:
    if not run:
        return []
    return curves_from_beziers(run) if exact else [_chain(bezier) for bezier in run]


def _is_straight(bezier: npt.NDArray[np.float64]) -> bool:
    chord = bezier[3] - bezier[0]
    length = float(np.hypot(*chord))
    if length < _STRAIGHT:
        return bool(np.hypot(*(bezier - bezier[0]).T).max() < _STRAIGHT)
    across = (bezier[1:3] - bezier[0]) @ np.array([-chord[1], chord[0]]) / length
    along = (bezier[1:3] - bezier[0]) @ chord / length
    within = (along >= -_STRAIGHT) & (along <= length + _STRAIGHT)
    return bool((np.abs(across) <= _STRAIGHT).all() and within.all())


def _point_at(bezier: npt.NDArray[np.float64], t: npt.NDArray[np.float64]) -> Vector:
    t = t[:, None]
    s = 1.0 - t
    return (
        s**3 * bezier[0]
        + 3.0 * s * s * t * bezier[1]
        + 3.0 * s * t * t * bezier[2]
        + t**3 * bezier[3]
    )


def _bezier_arc(bezier: npt.NDArray[np.float64]) -> tuple[CircularArc, bool] | None:
    """The arc that a Bézier curve stands for, and whether it turns from x towards y."""
    first, last = bezier[1] - bezier[0], bezier[3] - bezier[2]
    # The centre lies on the normals at both ends.
    system = np.array([first, last])
    if abs(np.linalg.det(system)) <= 1e-12 * (
        np.hypot(*first) * np.hypot(*last) + 1e-300
    ):
        # A half circle has parallel tangents; its centre is the middle of its chord.
        centre = (bezier[0] + bezier[3]) / 2.0
    else:
        centre = np.linalg.solve(system, [first @ bezier[0], last @ bezier[3]])
    radii = np.hypot(*(bezier[[0, 3]] - centre).T)
    radius = float(radii.mean())
    points = _point_at(bezier, np.linspace(0.0, 1.0, 17))
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    if away.max() > min(_ARC_DEVIATION * radius, 0.5):
        return None
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    if not ((steps > 0.0).all() or (steps < 0.0).all()) or abs(sweep) < _SMALLEST_SWEEP:
        return None
    start = angles[0] if sweep > 0.0 else angles[-1]
    return CircularArc(
        to_point(centre), radius, _wrapped(float(start)), abs(sweep)
    ), sweep > 0.0


def _same_circle(a: CircularArc, b: CircularArc) -> bool:
    tolerance = max(_SAME_PLACE, 2e-5 * a.radius)
    apart = np.hypot(a.centre[0] - b.centre[0], a.centre[1] - b.centre[1])
    return bool(apart <= tolerance and abs(a.radius - b.radius) <= tolerance)


def _joined(
    run: list[tuple[npt.NDArray[np.float64], CircularArc, bool]],
) -> list[Curve]:
    """One arc for neighbouring Bézier arcs of one circle."""
    if len(run) < 2:
        return [arc for _, arc, _ in run]
    nodes = np.array([bezier[0] for bezier, _, _ in run] + [run[-1][0][3]])
    centre, radius = circle_through(nodes)
    turning = run[0][2]
    sweep = sum(arc.sweep for _, arc, _ in run)
    if np.hypot(*(nodes[0] - nodes[-1])) <= _SAME_PLACE:
        sweep = FULL_TURN
    start = nodes[0] if turning else nodes[-1]
    angle = float(np.arctan2(start[1] - centre[1], start[0] - centre[0]))
    return [
        CircularArc(to_point(centre), radius, _wrapped(angle), min(sweep, FULL_TURN))
    ]


def circle_through(points: npt.NDArray[np.float64]) -> tuple[Vector, float]:
    """Centre and radius of the circle nearest to (n, 2) points by its equation (Kåsa's fit)."""
    middle = points.mean(axis=0)
    local = points - middle
    scale = float(np.abs(local).max()) or 1.0
    local = local / scale
    system = np.column_stack([2.0 * local, np.ones(len(local))])
    solution = np.linalg.lstsq(system, (local**2).sum(axis=1), rcond=None)[0]
    radius = float(np.sqrt(max(solution[2] + solution[:2] @ solution[:2], 0.0)))
    return middle + solution[:2] * scale, radius * scale


def _whole_ellipse(beziers: list[npt.NDArray[np.float64]]) -> Curve | None:
    """The circle or ellipse that four Bézier curves, a quarter each, stand for."""
    if len(beziers) != 4 or np.hypot(*(beziers[3][3] - beziers[0][0])) > _SAME_PLACE:
        return None
    nodes = np.array([bezier[0] for bezier in beziers])
    centre = nodes.mean(axis=0)
    u, v = nodes[0] - centre, nodes[1] - centre
    size = float(max(np.hypot(*u), np.hypot(*v)))
    if abs(u[0] * v[1] - u[1] * v[0]) <= 1e-6 * size * size:
        return None
    # In the frame of its half axes, an ellipse is the unit circle.
    to_circle = np.linalg.inv(np.stack([u, v], axis=1))
    points = [_point_at(bezier, np.linspace(0.0, 1.0, 9)) for bezier in beziers]
    unit = (np.concatenate(points) - centre) @ to_circle.T
    away = np.abs(np.hypot(*unit.T) - 1.0)
    if away.max() > _ARC_DEVIATION or away.max() * size > 0.5:
        return None
    steps = np.diff(np.unwrap(np.arctan2(unit[:, 1], unit[:, 0])))
    if steps.min() < -1e-6 or abs(steps.sum() - FULL_TURN) > 1e-2:
        return None
    tilted = np.hypot(*(nodes[0] + nodes[2] - nodes[1] - nodes[3]))
    if tilted > max(_SAME_PLACE, 1e-5 * size):
        return None
    return affine_arc(
        centre, (nodes[0] - nodes[2]) / 2.0, (nodes[1] - nodes[3]) / 2.0, 0, FULL_TURN
    )


def _chain(bezier: npt.NDArray[np.float64]) -> Chain:
    bend = np.abs(bezier[:-2] - 2.0 * bezier[1:-1] + bezier[2:])
    # A chord's error is at most an eighth of its squared step times the second derivative.
    count = int(np.ceil(np.sqrt(0.75 * float(np.hypot(*bend.T).max()) / FLATNESS))) + 1
    points = _point_at(bezier, np.linspace(0.0, 1.0, min(max(count, 2), _MOST_CHORDS)))
    return Chain(tuple(to_point(point) for point in points))


def _chains_linked(curves: list[Curve]) -> list[Curve]:
    """Neighbouring chains that meet as one."""
    linked: list[Curve] = []
    for curve in curves:
        last = linked[-1] if linked else None
        if isinstance(curve, Chain) and isinstance(last, Chain):
            (x0, y0), (x1, y1) = last.points[-1], curve.points[0]
            if np.hypot(x1 - x0, y1 - y0) <= _SAME_PLACE:
                linked[-1] = Chain(last.points + curve.points[1:])
                continue
        linked.append(curve)
    return linked


def curve_along(points: npt.NDArray[np.float64]) -> Curve:
    """The line or circular arc that (n, 2) points of a smooth curve lie on, else their chain.

    Args:
        points: px, so close that the curve between two of them is as good as straight.
    """
    ends = to_point(points[0]), to_point(points[-1])
    if len(points) == 2:
        return Line(*ends)
    chord = points[-1] - points[0]
    length = float(np.hypot(*chord))
    if length > _STRAIGHT:
        across = np.abs((points - points[0]) @ np.array([-chord[1], chord[0]])) / length
        if across.max() <= _STRAIGHT:
            return Line(*ends)
    if len(points) >= 5:
        arc = _arc_along(points)
        if arc is not None:
            return arc
    return Chain(tuple(to_point(point) for point in points))


def _arc_along(points: npt.NDArray[np.float64]) -> CircularArc | None:
    centre, radius = circle_through(points)
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    if away.max() > 1e-3:
        return None
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    # The points of a polygon lie on a circle too, but turn by more at once.
    if (
        not one_way
        or np.abs(steps).max() > np.radians(15.0)
        or abs(sweep) < _SMALLEST_SWEEP
    ):
        return None
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(
        to_point(centre), radius, _wrapped(start), min(abs(sweep), FULL_TURN)
    )


def polygon_curves(points: npt.NDArray[np.float64]) -> list[Curve]:
    """A line for each piece of (n, 2) points that is longer than nothing."""
    return [
        Line(to_point(a), to_point(b))
        for a, b in pairwise(points)
        if np.hypot(*(b - a)) > 1e-9
    ]


def placed(curve: Curve, scale: float, left: float, top: float) -> Curve:
    """A curve of a drawing whose y points up, in px: the point (left, top) becomes the origin."""

    def at(point: Point) -> Point:
        return (point[0] - left) * scale, (top - point[1]) * scale

    if isinstance(curve, Line):
        return Line(at(curve.start), at(curve.end))
    if isinstance(curve, CircularArc):
        start = _wrapped(-(curve.start_angle + curve.sweep))
        return CircularArc(at(curve.centre), curve.radius * scale, start, curve.sweep)
    if isinstance(curve, EllipticArc):
        major = curve.major[0] * scale, -curve.major[1] * scale
        start = _wrapped(-(curve.start + curve.sweep))
        return EllipticArc(at(curve.centre), major, curve.ratio, start, curve.sweep)
    return Chain(tuple(at(point) for point in curve.points))
