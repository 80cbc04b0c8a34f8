"""Strokes of views as shapes of a reading and back: px of the upright sheet, and as stored."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.readings.reading_schema import Box, StrokeEntry
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.labels.ink_classes import BY_LABELS
from gaussiancad_core.sheet.labels.label_evidence import solver_weight
from gaussiancad_protocol.reading_kinds import StrokeKind

_DIGITS = 4
"""Decimals of px: lines of files are known that well."""

_ANGLE_DIGITS = 8
"""Decimals of radians."""


def shape_of(stroke: Stroke, turn: Turn) -> Mapping[str, Any]:
    """A stroke of the upright sheet as the attribute of a :class:`StrokeEntry`."""
    if isinstance(stroke, Segment):
        return {"line": tuple(_stored([stroke.start, stroke.end], turn))}
    (centre,) = _stored([stroke.centre], turn)
    turned = _turned(stroke.centre, turn)
    if isinstance(stroke, Arc):
        radius = _size(stroke.radius * turn.scale)
        return {"arc": (*centre, radius, _angle(stroke.start_angle + turned), _sweep(stroke.sweep))}
    axes = (_size(value * turn.scale) for value in (stroke.semi_major, stroke.semi_minor))
    angles = _angle(stroke.rotation + turned), _angle(stroke.start), _sweep(stroke.sweep)
    return {"ellipse": (*centre, *axes, *angles)}


def stroke_of(entry: StrokeEntry, turn: Turn) -> Stroke | None:
    """A stroke of a reading on the upright sheet; None where it has no shape, or no length."""
    linetype = Linetype.HIDDEN if entry.kind is StrokeKind.HIDDEN else Linetype.VISIBLE
    kind = linetype, _weight(entry)
    if entry.line is not None:
        start, end = _upright(entry.line, turn)
        return Segment(start, end, *kind) if start != end else None
    if entry.arc is not None:
        x, y, radius, first, sweep = entry.arc
        (centre,) = _upright([(x, y)], turn)
        begin = first - _turned(centre, turn)
        return Arc(centre, radius / turn.scale, begin % (2.0 * np.pi), sweep, *kind)
    if entry.ellipse is not None:
        x, y, major, minor, rotation, first, sweep = entry.ellipse
        (centre,) = _upright([(x, y)], turn)
        axes = major / turn.scale, minor / turn.scale, rotation - _turned(centre, turn)
        return Ellipse(centre, *axes, first, sweep, *kind)
    return None


def _weight(entry: StrokeEntry) -> float:
    """How sure a stroke is whether it is visible or hidden, and what a doubtful label takes."""
    by_label = entry.why is not None and entry.why.by in BY_LABELS
    return solver_weight(entry.confidence) if by_label else entry.confidence


def stored_box(box: Box, turn: Turn) -> Box:
    """A box of the upright sheet on the sheet as stored."""
    x0, y0, x1, y1 = (round(float(value), 2) for value in turn.box_to_stored(box))
    return x0, y0, x1, y1


def stored_points(points: Any, turn: Turn) -> list[tuple[float, float]]:  # noqa: ANN401
    """Points of the upright sheet on the sheet as stored."""
    return _stored(points, turn)


def stored_ring(ring: Sequence[tuple[float, float]], turn: Turn) -> tuple[tuple[float, float], ...]:
    """Corners of a polygon on the sheet as stored, to hundredths of a px; an empty one stays so."""
    if not ring:
        return ()
    return tuple((round(x, 2), round(y, 2)) for x, y in turn.to_stored(np.array(ring)).tolist())


def _stored(points: Any, turn: Turn) -> list[tuple[float, float]]:  # noqa: ANN401
    moved = np.round(turn.to_stored(np.asarray(points, np.float64)), _DIGITS)
    return [(x, y) for x, y in moved.tolist()]


def _upright(points: Any, turn: Turn) -> list[tuple[float, float]]:  # noqa: ANN401
    return [(x, y) for x, y in turn.to_upright(np.asarray(points, np.float64)).tolist()]


def _turned(centre: tuple[float, float], turn: Turn) -> float:
    """Radians by which directions turn from the upright sheet to the sheet as stored."""
    (x0, y0), (x1, y1) = turn.to_stored(np.array(centre) + np.array([[0.0, 0.0], [1.0, 0.0]]))
    return float(np.arctan2(y1 - y0, x1 - x0))


def _angle(value: float) -> float:
    return round(float(value), _ANGLE_DIGITS)


def _size(value: float) -> float:
    """px, and never none: what is so small is drawn all the same."""
    return max(round(float(value), _DIGITS), 10.0**-_DIGITS)


def _sweep(value: float) -> float:
    """Up to a whole turn, rounded down: more is none; and never none."""
    return min(max(round(float(value), _ANGLE_DIGITS), 10.0**-_ANGLE_DIGITS), 6.28318531)
