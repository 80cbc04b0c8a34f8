"""First or third angle by geometry: what one view has open towards its neighbour, or away from it.

In third angle a view shows the side of its neighbour that faces it, in first angle the far one.  So
what is open to one side alone, corners of the outline and hidden lines with one end at an edge that
is seen, must be edges in the neighbour, or must not.
"""

from collections.abc import Iterator
from math import log

import numpy as np
import shapely
from shapely import LineString, Point

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.stroke_levels import Places, distinct, is_painted

_MOST = 6.0
"""Log-odds by corners, at most."""

_ONE_PLACE, _AT_EDGE = 0.2, 0.12
"""mm within which corners are at one place, and within which an edge is at a corner."""

_AT_PICTURE = 0.35
"""The same at a corner of a picture's outline."""

_WEIGHT, _WEIGHT_OF_PICTURE = 0.6, 0.3
"""Share of a corner's log-odds that count, as corners of one part are not independent."""

_SHOWN, _BY_CHANCE, _MOST_BY_CHANCE = 0.85, 0.3, 0.8
"""Probability that a corner's edge is drawn on its side; that there is one seen from the other, at
least and at most."""

_APART = 0.3
"""mm from which corners are two."""

_SMOOTH = 0.004
"""mm by which an outline is made simpler."""

_INSIDE = 0.03
"""mm within an outline from which lines out of it are looked for."""

_LEAST_TURN = 25.0
"""Degrees of a corner at least."""

_AT_END = 0.25
"""mm from the ends of a view within which corners say nothing."""

_FAR = 1e3
"""mm beyond any sheet."""

_LEVEL, _LEVEL_EDGE, _SHORTEST, _SHORTEST_EDGE = 0.01, 0.01, 0.6, 0.8
"""Sines of the angles, and mm, of hidden lines and of edges along an axis."""

_OPEN_END = 0.15
"""mm from the end of a hidden line to the edge that it is open at."""


def odds_for_third(one: DrawnView, other: DrawnView, axis: int, *, is_before: bool) -> float:
    """Log-odds for third angle from two views in line.

    Args:
        one, other: the views.
        axis: of the sheet, that both share: 0 across, 1 down.
        is_before: whether the first lies before the other on the sheet's other axis.
    """
    found = 0.0
    for view, neighbour, faces_high in ((one, other, is_before), (other, one, not is_before)):
        if neighbour.kind is not DrawingKind.SECTION and not is_painted(neighbour):
            found += _votes(view, neighbour, axis, faces_high=faces_high)
    return float(np.clip(found, -_MOST, _MOST))


def _votes(view: DrawnView, neighbour: DrawnView, axis: int, *, faces_high: bool) -> float:
    seen = _edge_places(neighbour, axis)
    if not len(seen):
        return 0.0
    near = list(_open_places(view, axis, high=faces_high))
    far = list(_open_places(view, axis, high=not faces_high))
    through = [*_corners(neighbour, axis, high=True), *_corners(neighbour, axis, high=False)]
    reach = _AT_PICTURE if is_painted(view) else _AT_EDGE + view.rough / 2.0
    chance = min(
        _MOST_BY_CHANCE, _BY_CHANCE + 2.0 * reach * len(seen) / max(neighbour.size[axis], 1.0)
    )
    hit, miss = log(_SHOWN / chance), log((1.0 - _SHOWN) / (1.0 - chance))
    total = 0.0
    for places, others, sign in ((near, far, 1.0), (far, near, -1.0)):
        alone = [place for place in places if not _has(others, place)]
        for place in distinct(alone, _APART).tolist():
            if not _has(through, place):
                is_seen = float(np.abs(seen - place).min()) < reach
                total += sign * (hit if is_seen else miss)
    return total * (_WEIGHT_OF_PICTURE if is_painted(view) or view.rough else _WEIGHT)


def _has(places: list[float], place: float) -> bool:
    return any(abs(place - other) < _ONE_PLACE for other in places)


def _open_places(view: DrawnView, axis: int, *, high: bool) -> Iterator[float]:
    """Places along an axis of what is open towards a side: corners of the outline, and blind holes
    by their hidden lines."""
    yield from _corners(view, axis, high=high)
    across = 1 - axis
    for stroke in view.hidden:
        is_along = stroke.is_line and abs(float(stroke.way[axis])) <= _LEVEL
        if not is_along or stroke.length < _SHORTEST:
            continue
        ends = stroke.points[np.argsort(stroke.points[:, across])]
        # One that ends in the midst of the view is a floor's.
        first, last = (_is_at_edge(view, end) for end in ends)
        if first != last and last == high:
            yield float(stroke.points[:, axis].mean() - view.box[axis])


def _is_at_edge(view: DrawnView, end: np.ndarray) -> bool:
    place = Point(end)
    return any(edge.line.dwithin(place, _OPEN_END) for edge in view.edges)


def _corners(view: DrawnView, axis: int, *, high: bool) -> Iterator[float]:
    """Places along an axis of the corners of a view's outline that are free towards a side."""
    low, extent = view.box[axis], view.size[axis]
    shape = view.outline.buffer(0.0)
    inner = shape.buffer(-_INSIDE)
    shapely.prepare(inner)
    for polygon in getattr(shape, "geoms", [shape]):
        corners = np.array(polygon.exterior.simplify(_SMOOTH).coords)[:-1]
        if len(corners) < 3:
            continue
        before, after = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, 0) - corners
        angles = np.arctan2(after[:, 1], after[:, 0]) - np.arctan2(before[:, 1], before[:, 0])
        turns = np.abs(np.degrees(np.angle(np.exp(1j * angles))))
        for corner, turn in zip(corners, turns, strict=True):
            place = float(corner[axis]) - low
            if turn < _LEAST_TURN or not _AT_END <= place <= extent - _AT_END:
                continue
            end = corner.copy()
            end[1 - axis] += _FAR if high else -_FAR
            if not inner.intersects(LineString([corner, end])):
                yield place


def _edge_places(view: DrawnView, axis: int) -> Places:
    """Places along an axis of a view's edges across it, and where its arcs turn back."""
    found: list[float] = []
    for edge in (*view.edges, *view.narrow):
        found += [place - view.box[axis] for place in _places(edge, axis)]
    return distinct(found)


def _places(edge: PaperStroke, axis: int) -> list[float]:
    curve = edge.curve
    if edge.is_line:
        is_across = abs(float(edge.way[axis])) < _LEVEL_EDGE and edge.length > _SHORTEST_EDGE
        return [float(edge.points[:, axis].mean())] if is_across else []
    if isinstance(curve, CircularArc):
        # Where it turns back, not where it ends.
        turning = curve.extremes()[2:]
        middle = curve.centre[axis]
        is_side = np.abs(np.abs(turning[:, axis] - middle) - curve.radius) < 1e-6 * curve.radius
        return [float(place) for place in turning[is_side, axis]]
    return [float(edge.points[:, axis].min()), float(edge.points[:, axis].max())]
