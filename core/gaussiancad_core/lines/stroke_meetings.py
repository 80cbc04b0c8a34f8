"""Where strokes meet: the positions along a stroke at which its visibility can change."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.arcs import SAGITTA
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.lines.coverage import StrokeIndex
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Arc, Ellipse, Segment

Points = npt.NDArray[np.float64]


def junctions(stroke: DrawnStroke, others: StrokeIndex, tolerance: float) -> Points:
    """(k,) sorted lengths along a stroke where other strokes cross, touch or end at it.

    Lines and circles are met exactly, chains chord by chord; what comes within ``tolerance``
    touches.
    """
    found = [
        _meet(stroke, other, tolerance)
        for other in others.near(stroke, tolerance)
        if other is not stroke
    ]
    return np.unique(np.concatenate(found)) if found else np.zeros(0)


def _meet(one: DrawnStroke, other: DrawnStroke, tolerance: float) -> Points:
    if isinstance(one, Arc):
        if isinstance(other, Arc):
            points = _circles_meet(one, other, tolerance)
            points = points[_on_arc(points, other, tolerance)]
        else:
            points, _ = _chords_meet_circle(_vertices(other), one, tolerance)
        points = points[_on_arc(points, one, tolerance)]
        return _angles_along(points, one) * one.radius
    if isinstance(other, Arc):
        points, positions = _chords_meet_circle(_vertices(one), other, tolerance)
        return positions[_on_arc(points, other, tolerance)]
    return _chords_meet(_vertices(one), _vertices(other), tolerance)


def _vertices(stroke: Segment | Ellipse | Polyline) -> Points:
    if isinstance(stroke, Ellipse):
        return stroke.chords(SAGITTA * stroke.semi_major)
    return stroke.vertices(np.inf)


def _angles_along(points: Points, arc: Arc) -> Points:
    """(n,) angles from the arc's start, those just before it negative."""
    offsets = points - np.array(arc.centre)
    turn = np.mod(np.arctan2(offsets[:, 1], offsets[:, 0]) - arc.start_angle, FULL_TURN)
    return np.where(turn > arc.sweep / 2.0 + np.pi, turn - FULL_TURN, turn)


def _on_arc(points: Points, arc: Arc, tolerance: float) -> npt.NDArray[np.bool_]:
    slack = tolerance / arc.radius
    turn = _angles_along(points, arc)
    return (turn >= -slack) & (turn <= arc.sweep + slack)


def _circles_meet(one: Arc, other: Arc, tolerance: float) -> Points:
    way = np.array(other.centre) - np.array(one.centre)
    apart = float(np.hypot(*way))
    if apart < tolerance:
        return np.zeros((0, 2))
    if apart > one.radius + other.radius + tolerance:
        return np.zeros((0, 2))
    if apart < abs(one.radius - other.radius) - tolerance:
        return np.zeros((0, 2))
    way = way / apart
    along = (apart**2 + one.radius**2 - other.radius**2) / (2.0 * apart)
    aside = np.sqrt(max(0.0, one.radius**2 - along**2))
    foot = np.array(one.centre) + along * way
    side = aside * np.array([-way[1], way[0]])
    return np.stack([foot + side, foot - side])


def _chords_meet_circle(vertices: Points, arc: Arc, tolerance: float) -> tuple[Points, Points]:
    """(k, 2) points where chords meet an arc's circle, and (k,) their lengths along the chain."""
    starts, spans = vertices[:-1], np.diff(vertices, axis=0)
    lengths = np.maximum(np.hypot(*spans.T), 1e-300)
    along = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
    directions = spans / lengths[:, None]
    offsets = np.array(arc.centre) - starts
    feet = (offsets * directions).sum(axis=1)
    aside = offsets[:, 0] * directions[:, 1] - offsets[:, 1] * directions[:, 0]
    reach = np.sqrt(np.maximum(0.0, arc.radius**2 - aside**2))
    close = np.abs(aside) <= arc.radius + tolerance
    points, positions = [], []
    for at in (feet - reach, feet + reach):
        inside = close & (at >= -tolerance) & (at <= lengths + tolerance)
        points.append(starts[inside] + at[inside, None] * directions[inside])
        positions.append(along[inside] + at[inside])
    return np.concatenate(points), np.concatenate(positions)


def _chords_meet(one: Points, other: Points, tolerance: float) -> Points:
    """(k,) lengths along the first chain where its chords meet those of the second."""
    starts, spans = one[:-1], np.diff(one, axis=0)
    lengths = np.maximum(np.hypot(*spans.T), 1e-300)
    along = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
    other_starts, other_spans = other[:-1], np.diff(other, axis=0)
    other_lengths = np.maximum(np.hypot(*other_spans.T), 1e-300)
    gaps = other_starts[None] - starts[:, None]
    crossed = _cross(spans[:, None], other_spans[None])
    # Parallel chords overlap or miss each other; neither is a crossing.
    steep = np.abs(crossed) > 1e-9 * lengths[:, None] * other_lengths[None]
    safe = np.where(steep, crossed, 1.0)
    share = _cross(gaps, other_spans[None]) / safe
    other_share = _cross(gaps, spans[:, None]) / safe
    slack, other_slack = tolerance / lengths[:, None], tolerance / other_lengths[None]
    meets = (
        steep
        & (share >= -slack)
        & (share <= 1.0 + slack)
        & (other_share >= -other_slack)
        & (other_share <= 1.0 + other_slack)
    )
    rows, columns = np.nonzero(meets)
    return along[rows] + share[rows, columns] * lengths[rows]


def _cross(one: Points, other: Points) -> Points:
    return one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]
