"""Whether what lines go around are views, where nothing else tells a frame from an outline.

A plate with holes looks like a frame with drawings in it.  Views are large, and one of them at
least has edges within its outline that are no mere counterbore; all others stand in a row with such
a view: a hole beside what looks like one is in the part that the outline is of.
"""

from collections.abc import Sequence
from enum import Enum

import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView

_VIEW = 0.1
"""Share of a frame's width and height that a view in it has at least: engraved letters have
less."""

_INSIDE = 0.05
"""mm within an outline from which an edge lies in it."""

_CONCENTRIC = 0.1
"""mm within which circles have one middle."""

_EVEN = 0.3
"""mm by which drawings in a row begin and end apart."""


class Surety(Enum):
    """How sure it is that lines go around views."""

    NONE = 0
    GUESSED = 1
    CERTAIN = 2


def surety_of_views(views: Sequence[DrawnView], area: Polygon) -> Surety:
    """How sure it is that drawings in an area are views.

    Args:
        views: all drawings of the sheet.
        area: that lines go around, mm.
    """
    x0, y0, x1, y1 = area.bounds
    least = _VIEW * (x1 - x0), _VIEW * (y1 - y0)
    closed = [view for view in views if not view.outline.is_empty]
    held = [
        view
        for view in closed
        if not any(view is not other and _is_within(view, other) for other in closed)
    ]
    shown = [
        view
        for view in held
        if view.size[0] >= least[0] and view.size[1] >= least[1] and _has_inner_edges(view)
    ]
    if not shown:
        return Surety.NONE
    others = [view for view in held if view not in shown and view.kind is not DrawingKind.SCRAP]
    if not all(any(_are_in_row(view, other) for other in shown) for view in others):
        return Surety.NONE
    return Surety.CERTAIN if len(shown) + len(others) > 1 else Surety.GUESSED


def _is_within(view: DrawnView, other: DrawnView) -> bool:
    box, around = np.array(view.box), np.array(other.box)
    return bool((box[:2] > around[:2]).all() and (box[2:] < around[2:]).all())


def _has_inner_edges(view: DrawnView) -> bool:
    """Whether edges lie within a drawing's outline, but for circles about its own middle."""
    inner = view.outline.buffer(0.0)
    inner = shapely.union_all([Polygon(piece.exterior) for piece in shapely.get_parts(inner)])
    inner = inner.buffer(-_INSIDE)
    inside = [edge for edge in view.edges if edge.line.intersection(inner).length > _INSIDE]
    middle = np.array([(view.box[0] + view.box[2]) / 2.0, (view.box[1] + view.box[3]) / 2.0])
    return any(
        not isinstance(edge.curve, CircularArc)
        or np.abs(np.array(edge.curve.centre) - middle).max() > _CONCENTRIC
        for edge in inside
    )


def _are_in_row(view: DrawnView, other: DrawnView) -> bool:
    apart = np.abs(np.array(view.box) - np.array(other.box))
    return bool(min(apart[::2].max(), apart[1::2].max()) <= _EVEN)
