"""Bézier curves back to what they stand for: lines, arcs, ellipses, and chains for all others."""

import math
from itertools import groupby

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.file_curves import (
    FLATNESS,
    MOST_CHORDS,
    SMALLEST_SWEEP,
    STRAIGHT,
    Vector,
    affine_arc,
    polygon_curves,
)
from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.files.plotted import lines_and_arcs
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped
from gaussiancad_core.geometry.tolerances import COMPUTED

_ARC_DEVIATION = 1.5e-3
"""Share of its radius by which a Bézier curve that stands for an arc may leave it; the usual
quarter circle does by 2.7e-4."""


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
            curves += [*_joined(run), LineSegment(to_point(bezier[0]), to_point(bezier[3]))]
            run = []
            continue
        fitted = _bezier_arc(bezier)
        if fitted is None:
            curves += [*_joined(run), _chain(bezier)]
            run = []
            continue
        if run and not (_same_circle(run[-1][1], fitted[0]) and run[-1][2] == fitted[1]):
            curves += _joined(run)
            run = []
        run.append((bezier, *fitted))
    return _chains_linked(curves + _joined(run))


def curves_from_path(pieces: list[npt.NDArray[np.float64]], step: float | None) -> list[Curve]:
    """Curves of a path whose pieces join end to end.

    Args:
        pieces: (2, 2) the ends of a line, or (4, 2) the control points of a Bézier curve, in px.
        step: px of the grid to which they were rounded, 0 of exact ones, by which arcs are
            recognised; None to leave lines as they are, and Bézier curves as chains.
    """
    curves: list[Curve] = []
    for is_bezier, group in groupby(
        (piece for piece in pieces if _extent(piece) > COMPUTED),
        key=lambda piece: len(piece) == 4,
    ):
        run = list(group)
        if not is_bezier:
            points = np.array([piece[0] for piece in run] + [run[-1][1]])
            curves += polygon_curves(points) if step is None else lines_and_arcs(points, step)
        elif step is not None:
            curves += curves_from_beziers(run)
        else:
            curves += [_chain(bezier) for bezier in run]
    return curves


def _extent(piece: npt.NDArray[np.float64]) -> float:
    """px of the diagonal of the box around points (n, 2)."""
    # Most pieces are lines: numpy takes ten times as long for two points.
    across, up = piece.T.tolist()
    return math.hypot(max(across) - min(across), max(up) - min(up))


def _is_straight(bezier: npt.NDArray[np.float64]) -> bool:
    chord = bezier[3] - bezier[0]
    length = float(np.hypot(*chord))
    if length < STRAIGHT:
        return bool(np.hypot(*(bezier - bezier[0]).T).max() < STRAIGHT)
    across = (bezier[1:3] - bezier[0]) @ np.array([-chord[1], chord[0]]) / length
    along = (bezier[1:3] - bezier[0]) @ chord / length
    within = (along >= -STRAIGHT) & (along <= length + STRAIGHT)
    return bool((np.abs(across) <= STRAIGHT).all() and within.all())


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
    if abs(np.linalg.det(system)) <= 1e-12 * (np.hypot(*first) * np.hypot(*last) + 1e-300):
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
    if not ((steps > 0.0).all() or (steps < 0.0).all()) or abs(sweep) < SMALLEST_SWEEP:
        return None
    start = angles[0] if sweep > 0.0 else angles[-1]
    return CircularArc(to_point(centre), radius, wrapped(float(start)), abs(sweep)), sweep > 0.0


def _same_circle(a: CircularArc, b: CircularArc) -> bool:
    tolerance = max(FLATNESS, 2e-5 * a.radius)
    apart = np.hypot(a.centre[0] - b.centre[0], a.centre[1] - b.centre[1])
    return bool(apart <= tolerance and abs(a.radius - b.radius) <= tolerance)


def _joined(run: list[tuple[npt.NDArray[np.float64], CircularArc, bool]]) -> list[Curve]:
    """One arc for neighbouring Bézier arcs of one circle."""
    if len(run) < 2:
        return [arc for _, arc, _ in run]
    nodes = np.array([bezier[0] for bezier, _, _ in run] + [run[-1][0][3]])
    centre, radius = circle_through(nodes)
    turning = run[0][2]
    sweep = sum(arc.sweep for _, arc, _ in run)
    if np.hypot(*(nodes[0] - nodes[-1])) <= FLATNESS:
        sweep = FULL_TURN
    start = nodes[0] if turning else nodes[-1]
    angle = float(np.arctan2(start[1] - centre[1], start[0] - centre[0]))
    return [CircularArc(to_point(centre), radius, wrapped(angle), min(sweep, FULL_TURN))]


def _whole_ellipse(beziers: list[npt.NDArray[np.float64]]) -> Curve | None:
    """The circle or ellipse that four Bézier curves, a quarter each, stand for."""
    if len(beziers) != 4 or np.hypot(*(beziers[3][3] - beziers[0][0])) > FLATNESS:
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
    if tilted > max(FLATNESS, 1e-5 * size):
        return None
    return affine_arc(
        centre, (nodes[0] - nodes[2]) / 2.0, (nodes[1] - nodes[3]) / 2.0, 0, FULL_TURN
    )


def _chain(bezier: npt.NDArray[np.float64]) -> Chain:
    bend = np.abs(bezier[:-2] - 2.0 * bezier[1:-1] + bezier[2:])
    # A chord's error is at most an eighth of its squared step times the second derivative.
    count = int(np.ceil(np.sqrt(0.75 * float(np.hypot(*bend.T).max()) / FLATNESS))) + 1
    points = _point_at(bezier, np.linspace(0.0, 1.0, min(max(count, 2), MOST_CHORDS)))
    return Chain(tuple(to_point(point) for point in points))


def _chains_linked(curves: list[Curve]) -> list[Curve]:
    """Neighbouring chains that meet as one."""
    linked: list[Curve] = []
    for curve in curves:
        last = linked[-1] if linked else None
        if isinstance(curve, Chain) and isinstance(last, Chain):
            (x0, y0), (x1, y1) = last.points[-1], curve.points[0]
            if np.hypot(x1 - x0, y1 - y0) <= FLATNESS:
                linked[-1] = Chain(last.points + curve.points[1:])
                continue
        linked.append(curve)
    return linked
