"""Bézier curves back to what they stand for: lines, arcs, ellipses, and chains for all others."""

import math
from itertools import groupby, pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.file_curves import (
    FLATNESS,
    MOST_CHORDS,
    SMALLEST_SWEEP,
    STRAIGHT,
    affine_arc,
)
from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.files.plotted import FEWEST_CHORDS, lines_and_arcs
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
    together = np.array(beziers)
    straight = _are_straight(together)
    arcs = _bezier_arcs(together)
    free = iter(
        _chains(together[[not s and a is None for s, a in zip(straight, arcs, strict=True)]])
    )
    curves: list[Curve] = []
    run: list[tuple[npt.NDArray[np.float64], CircularArc, bool]] = []
    for bezier, is_straight, fitted in zip(beziers, straight, arcs, strict=True):
        if is_straight or fitted is None:
            curves += _joined(run)
            run = []
        if is_straight:
            curves.append(LineSegment(to_point(bezier[0]), to_point(bezier[3])))
            continue
        if fitted is None:
            curves.append(next(free))
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
    if len(pieces) == 1 and len(pieces[0]) == 2:
        # Most paths of most files are one line.
        start, end = pieces[0].tolist()
        is_long = math.hypot(end[0] - start[0], end[1] - start[1]) > COMPUTED
        return [LineSegment((start[0], start[1]), (end[0], end[1]))] if is_long else []
    curves: list[Curve] = []
    for is_bezier, group in groupby(
        (piece for piece in pieces if _extent(piece) > COMPUTED),
        key=lambda piece: len(piece) == 4,
    ):
        run = list(group)
        if not is_bezier and step is not None and len(run) >= FEWEST_CHORDS:
            curves += lines_and_arcs(np.array([*(piece[0] for piece in run), run[-1][1]]), step)
        elif not is_bezier:
            curves += [LineSegment(to_point(start), to_point(end)) for start, end in run]
        elif step is not None:
            curves += curves_from_beziers(run)
        else:
            curves += _chains(np.array(run))
    return curves


def outlines(subpaths: list[list[npt.NDArray[np.float64]]]) -> list[Chain]:
    """The closed chains around filled areas; none around what has no area.

    Args:
        subpaths: pieces that join end to end, each as for :func:`curves_from_path`.
    """
    curved = [piece for pieces in subpaths for piece in pieces if len(piece) == 4]
    flat = iter(_flattened(np.array(curved)) if curved else ())
    found = []
    for pieces in subpaths:
        corners = [next(flat) if len(piece) == 4 else piece for piece in pieces]
        if not corners:
            continue
        ring = [tuple(point) for chain in corners for point in chain[1:].tolist()]
        first = to_point(pieces[0][0])
        # Filling closes what the path leaves open.
        ring = [first, *ring] if ring[-1] == first else [first, *ring, first]
        ring = [ring[0], *(point for before, point in pairwise(ring) if point != before)]
        if len(ring) > 3:
            found.append(Chain(tuple(ring)))
    return found


def _extent(piece: npt.NDArray[np.float64]) -> float:
    """px of the diagonal of the box around points (n, 2)."""
    # Most pieces are lines: numpy takes ten times as long for two points.
    across, up = piece.T.tolist()
    return math.hypot(max(across) - min(across), max(up) - min(up))


def _are_straight(beziers: npt.NDArray[np.float64]) -> list[bool]:
    """Which of (n, 4, 2) Bézier curves are lines."""
    chords = beziers[:, 3] - beziers[:, 0]
    lengths = np.hypot(*chords.T)
    away = beziers - beziers[:, :1]
    is_dot = np.hypot(*np.moveaxis(away, 2, 0)).max(axis=1) < STRAIGHT
    along = chords / np.maximum(lengths, 1e-300)[:, None]
    ahead = (away[:, 1:3] * along[:, None]).sum(axis=2)
    off_chord = away[:, 1:3, 1] * along[:, None, 0] - away[:, 1:3, 0] * along[:, None, 1]
    within = (ahead >= -STRAIGHT) & (ahead <= lengths[:, None] + STRAIGHT)
    is_line = (np.abs(off_chord) <= STRAIGHT).all(axis=1) & within.all(axis=1)
    return [bool(straight) for straight in np.where(lengths < STRAIGHT, is_dot, is_line)]


def _powers(t: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """(n, 4) weights of the control points at (n,) parameters."""
    s = 1.0 - t
    return np.stack([s**3, 3.0 * s * s * t, 3.0 * s * t * t, t**3], axis=1)


def _points_at(
    beziers: npt.NDArray[np.float64], t: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """(n, k, 2) points of (n, 4, 2) Bézier curves at (k,) parameters."""
    return np.asarray(_powers(t) @ beziers)


def _bezier_arcs(
    beziers: npt.NDArray[np.float64],
) -> list[tuple[CircularArc, bool] | None]:
    """The arc that each of (n, 4, 2) Bézier curves stands for, and whether it turns from x towards
    y; None for one that stands for none."""
    start, end = beziers[:, 0], beziers[:, 3]
    first, last = beziers[:, 1] - start, end - beziers[:, 2]
    # The centre lies on the normals at both ends.
    crossed = first[:, 0] * last[:, 1] - first[:, 1] * last[:, 0]
    sizes = np.hypot(*first.T) * np.hypot(*last.T)
    is_half = np.abs(crossed) <= 1e-12 * sizes + 1e-300
    one, other = (first * start).sum(axis=1), (last * end).sum(axis=1)
    met = np.stack(
        [one * last[:, 1] - other * first[:, 1], other * first[:, 0] - one * last[:, 0]], axis=1
    )
    # A half circle has parallel tangents; its centre is the middle of its chord.
    met /= np.where(is_half, 1.0, crossed)[:, None]
    centres = np.where(is_half[:, None], (start + end) / 2.0, met)
    radii = (np.hypot(*(start - centres).T) + np.hypot(*(end - centres).T)) / 2.0
    away = _points_at(beziers, np.linspace(0.0, 1.0, 17)) - centres[:, None]
    off = np.abs(np.hypot(*np.moveaxis(away, 2, 0)) - radii[:, None]).max(axis=1)
    angles = np.unwrap(np.arctan2(away[:, :, 1], away[:, :, 0]), axis=1)
    steps = np.diff(angles, axis=1)
    sweeps = angles[:, -1] - angles[:, 0]
    one_way = (steps > 0.0).all(axis=1) | (steps < 0.0).all(axis=1)
    is_arc = (off <= np.minimum(_ARC_DEVIATION * radii, 0.5)) & one_way
    is_arc &= np.abs(sweeps) >= SMALLEST_SWEEP
    starts = np.where(sweeps > 0.0, angles[:, 0], angles[:, -1])
    rows = zip(
        is_arc.tolist(),
        centres.tolist(),
        radii.tolist(),
        starts.tolist(),
        sweeps.tolist(),
        strict=True,
    )
    return [
        (CircularArc((x, y), radius, wrapped(angle), abs(sweep)), sweep > 0.0) if fits else None
        for fits, (x, y), radius, angle, sweep in rows
    ]


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
    points = _points_at(np.array(beziers), np.linspace(0.0, 1.0, 9)).reshape(-1, 2)
    unit = (points - centre) @ to_circle.T
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


def _chains(beziers: npt.NDArray[np.float64]) -> list[Chain]:
    return [Chain(tuple((x, y) for x, y in points.tolist())) for points in _flattened(beziers)]


def _flattened(beziers: npt.NDArray[np.float64]) -> list[npt.NDArray[np.float64]]:
    """(k, 2) corners of a chain along each of (n, 4, 2) Bézier curves."""
    bends = np.abs(np.diff(beziers, 2, axis=1))
    # A chord's error is at most an eighth of its squared step times the second derivative.
    most = np.hypot(*np.moveaxis(bends, 2, 0)).max(axis=1, initial=0.0)
    chords = np.clip(np.ceil(np.sqrt(0.75 * most / FLATNESS)), 1, MOST_CHORDS - 1)
    counts = chords.astype(np.int64) + 1
    owner = np.repeat(np.arange(len(beziers)), counts)
    number = np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)
    t = number / (counts[owner] - 1)
    powers = _powers(t)
    points = (powers[:, :, None] * beziers[owner]).sum(axis=1)
    return np.split(points, np.cumsum(counts)[:-1]) if len(beziers) else []


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
