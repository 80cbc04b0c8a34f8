"""Extension lines that run into a view as far as its rounded corner.

A dimension of a rounded outline is taken to the corner that its edges would have (ISO 129-1). Where
lines from both sides meet in it, they and the arc shut off an area, as edges do that lie behind the
rounding.  These would end in the corner; extension lines go on beyond it.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

_SQUARE = 0.5
"""Cosine of the angle between a corner's lines at most."""

_OFF = 0.4
"""Distance of a line from the circle that it touches at most, in stroke widths."""

_APART = 3.0
"""Gap between the corner and the extension line beyond it at most, in stroke widths."""


@dataclass(frozen=True)
class _Leg:
    """The way from a rounding to the corner before it.

    Attributes:
        shape: number of the line.
        touch, corner: positions along it.
    """

    shape: int
    touch: float
    corner: float


def mark_virtual_corners(shapes: list[InkedShape], kinds: Kinds, stroke_width: float) -> None:
    """Mark what lies between a rounding and the corner before it as extension lines, in place.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is; extension lines are known where they lie over paper.
        stroke_width: px.
    """
    leading = [k for k, own in enumerate(kinds) if AnnotationKind.EXTENSION in own]
    legs: list[_Leg] = []
    for shape in shapes:
        if isinstance(shape.geometry, Circle):
            legs += _legs(shape, shapes, kinds, leading, stroke_width)
    for leg in legs:
        _mark(leg, shapes, kinds)


def _legs(
    arc: InkedShape,
    shapes: list[InkedShape],
    kinds: Kinds,
    leading: list[int],
    stroke_width: float,
) -> Iterator[_Leg]:
    """Both legs of each corner before an arc whose lines lead on beyond it."""
    circle = arc.geometry
    centre = np.array([circle.centre])
    touching: list[tuple[int, Line, float]] = []
    for k in leading:
        line = shapes[k].geometry
        if isinstance(line, Line):
            along, across = line.coordinates(centre)
            if abs(abs(float(across[0])) - circle.radius) <= _OFF * stroke_width:
                touching.append((k, line, float(along[0])))
    for (k, one, first), (other_k, other, second) in combinations(touching, 2):
        corner = _crossing(one, other)
        if corner is None or not _is_before(corner, arc):
            continue
        legs = (
            _Leg(k, first, float(one.coordinates(corner[None])[0][0])),
            _Leg(other_k, second, float(other.coordinates(corner[None])[0][0])),
        )
        if all(_leads_on(leg, shapes[leg.shape], kinds[leg.shape], stroke_width) for leg in legs):
            yield from legs


def _crossing(one: Line, other: Line) -> np.ndarray | None:
    """Where two lines cross that are about square."""
    direction, second = np.array(one.direction), np.array(other.direction)
    if abs(float(direction @ second)) > _SQUARE:
        return None
    matrix = np.stack([direction, -second], axis=1)
    along = np.linalg.solve(matrix, np.array(other.point) - np.array(one.point))
    return np.array(one.point) + along[0] * direction


def _is_before(corner: np.ndarray, arc: InkedShape) -> bool:
    """Whether an arc is drawn where it faces a corner."""
    offset = corner - np.array(arc.geometry.centre)
    around = arc.geometry.around
    place = float(np.arctan2(offset[1], offset[0])) * arc.geometry.radius
    return any((place - own.run.start) % around <= own.run.length for own in arc.runs)


def _leads_on(
    leg: _Leg, shape: InkedShape, own: list[AnnotationKind | None], stroke_width: float
) -> bool:
    """Whether a leg is all ink of the part, and an extension line goes on beyond its corner."""
    low, high = sorted((leg.touch, leg.corner))
    slack = _APART * stroke_width
    inked = beyond = False
    for run, kind in zip(shape.runs, own, strict=True):
        start, end = run.run.start, run.run.end
        if kind is None and start <= low + slack and end >= high - slack:
            inked = True
        if kind is AnnotationKind.EXTENSION:
            apart = start - leg.corner if leg.corner > leg.touch else leg.corner - end
            beyond |= -slack <= apart <= slack
    return inked and beyond


def _mark(leg: _Leg, shapes: list[InkedShape], kinds: Kinds) -> None:
    """Cut the run of a leg out of its shape's runs, in place."""
    low, high = sorted((leg.touch, leg.corner))
    runs: list[InkedRun] = []
    told: list[AnnotationKind | None] = []
    shape = shapes[leg.shape]
    for run, kind in zip(shape.runs, kinds[leg.shape], strict=True):
        start, end = run.run.start, run.run.end
        if kind is not None or end <= low or start >= high:
            runs.append(run)
            told.append(kind)
            continue
        # What little lies beyond the corner is the extension line's, too.
        first = start if leg.corner < leg.touch else max(start, low)
        last = end if leg.corner > leg.touch else min(end, high)
        pieces = ((start, first, None), (first, last, AnnotationKind.EXTENSION), (last, end, None))
        for begin, finish, mark in pieces:
            if finish > begin:
                runs.append(InkedRun(Run(begin, finish), run.width))
                told.append(mark)
    shapes[leg.shape] = InkedShape(shape.geometry, tuple(runs))
    kinds[leg.shape] = told
