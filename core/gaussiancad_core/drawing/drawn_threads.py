"""Thread symbols: three quarters of a thin circle, and thin lines along the sides (ISO 6410-1)."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.annotation_pen import Direction
from gaussiancad_core.drawing.centre_lines import (
    SAME_PX,
    Round,
    flanks,
    from_model,
    model_axis,
    rounds,
    runs_at,
    to_model,
)
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.stroke_raster import dashed
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Linetype, Segment

_MINOR = 0.83
"""Minor diameter of a thread in major ones."""

_APART_PX = 4.0
"""px between the two circles at least: closer ones would be one line."""

_START, _SWEEP = 0.1, 1.5 * np.pi
"""The arc lacks about a quadrant, which neither starts nor ends at a centre line."""


@dataclass(frozen=True)
class _Side:
    """The bore or shaft of a circle as another view shows it: its axis, at a place and over a
    span in px, with hidden or visible sides."""

    view: DrawnView
    direction: Direction
    at: float
    span: tuple[float, float]
    linetype: Linetype


def draw_threads(views: tuple[DrawnView, ...], style: SheetStyle) -> list[Annotation]:
    """Thread symbols on every bore and shaft that has room for one.

    Bores have their thin circle outside, shafts inside of the wide one.

    Args:
        views: not turned.
        style: widths, dashes of what is hidden.
    """
    found: list[Annotation] = []
    for view in views:
        circles = rounds(view)
        for circle in circles:
            sides = list(_sides(view, views, circle))
            if not circle.whole or not circle.visible or not sides:
                continue
            inside = sides[0].linetype is Linetype.HIDDEN
            radius = circle.radius / _MINOR if inside else circle.radius * _MINOR
            if not has_room(circle, radius, circles):
                continue
            strokes: list[DrawnStroke] = [
                Arc(circle.centre, radius, _START, _SWEEP, Linetype.VISIBLE)
            ]
            for side in sides:
                strokes += _lines(side, radius, style)
            found.append(
                Annotation(AnnotationKind.THREAD, 0, tuple(strokes), style.annotation_width)
            )
    return found


def has_room(circle: Round, radius: float, circles: list[Round]) -> bool:
    """Whether nothing concentric lies between a circle and the thin one."""
    low, high = sorted((circle.radius, radius))
    others = [
        other.radius
        for other in circles
        if other is not circle and np.hypot(*np.subtract(other.centre, circle.centre)) < SAME_PX
    ]
    between = any(low - _APART_PX < other < high + _APART_PX for other in others)
    return high - low >= _APART_PX and not between


def _sides(view: DrawnView, views: tuple[DrawnView, ...], circle: Round) -> Iterator[_Side]:
    """Where other views show both sides of what a circle bounds."""
    look = view.role.frame.look_axis[0]
    for other in views:
        for direction in Direction:
            if other is view or model_axis(other, direction)[0] is not look:
                continue
            across = model_axis(other, direction.other)[0]
            seen = next(d for d in Direction if model_axis(view, d)[0] is across)
            distance = to_model(view, seen, circle.centre[seen.value])
            at = from_model(other, direction.other, distance)
            span = flanks(other, direction, at, circle.radius)
            if span is None:
                continue
            kinds = {
                stroke.linetype
                for stroke in other.strokes
                if isinstance(stroke, Segment)
                for side in (at - circle.radius, at + circle.radius)
                if runs_at(stroke, direction, side, SAME_PX)
            }
            if len(kinds) == 1:
                yield _Side(other, direction, at, span, kinds.pop())


def _lines(side: _Side, radius: float, style: SheetStyle) -> list[DrawnStroke]:
    """The thin lines of a side view, those of a hidden thread in dashes."""
    found: list[DrawnStroke] = []
    for across in (side.at - radius, side.at + radius):
        line = side.direction.segment((side.span[0], across), (side.span[1], across))
        hidden = side.linetype is Linetype.HIDDEN
        found += dashed(line, style) if hidden else [line]
    return found
