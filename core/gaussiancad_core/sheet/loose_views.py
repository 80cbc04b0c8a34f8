"""Views that stand out of line: told by their extents and by the places of their lines.

Views are usually in line with each other, but are dragged to where there is room.  Two views that
show one axis show the same coordinates on it: as long an extent, and lines at the same places.
What that is worth is weighed by how easily chance does the same.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import log

import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Axis, Projection, Role
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.layout import Layout, arrange_clusters, is_unusual, may_be_views
from gaussiancad_core.sheet.options import Box

Ink = npt.NDArray[np.bool_]
Places = npt.NDArray[np.float64]

_SAME_PX, _SAME = 2.0, 0.01
"""px, and share of an extent, by which places are one."""

_LONG = 0.12
"""Share of a view's width or height that a line along it has, at least, to be asked."""

_SHOWN = 0.8
"""Probability with which a line of one view has one at its place in another that shows its axis
and has more lines."""

_SURE = log(100.0)
"""Log-odds against chance from which a drawing is a view."""


def with_loose_views(layout: Layout, ink: Ink) -> Layout:
    """The layout, with those of the drawings that it leaves out that are views out of line.

    Args:
        layout: with a front view.
        ink: (h, w) of the part.
    """
    if Role.FRONT not in layout.boxes:
        return layout
    boxes = dict(layout.boxes)
    rest = list(layout.left_out)
    while found := _best(boxes, may_be_views(rest), layout.projection, ink):
        role, box = found
        boxes[role] = box
        rest.remove(box)
    return replace(layout, boxes=boxes, left_out=tuple(rest))


def arrange_loosely(
    clusters: list[Box], given: dict[Role, Box], projection: Projection | None, ink: Ink
) -> Layout:
    """Name clusters of ink as :func:`.arrange_clusters` does, in line or not.

    Args:
        clusters: boxes of groups of lines, px.
        given: views that the user named.
        projection: as told by the user, or None.
        ink: (h, w) of the part.

    Raises:
        NoModelError: there are fewer than two views that belong together.
        UsageError: a given box holds no cluster.
    """
    try:
        layout = arrange_clusters(clusters, given, projection)
    except NoModelError as error:
        if error.code != "views-not-aligned":
            raise
        layout = _without_a_line(clusters, given, projection, ink)
        if layout is None:
            raise
        return layout
    if len(given) > 1:
        return layout
    found = with_loose_views(layout, ink)
    if projection is not None or given or not is_unusual(found.boxes):
        return found
    turned = with_loose_views(arrange_clusters(clusters, given, layout.projection.other), ink)
    return replace(turned, source=layout.source, alternatives=(layout.projection,))


def _without_a_line(
    clusters: list[Box], given: dict[Role, Box], projection: Projection | None, ink: Ink
) -> Layout | None:
    """The layout around a front view to which all other drawings belong that are as large as views;
    None where there is none."""
    for front in may_be_views(clusters):
        if given and given.get(Role.FRONT) != front:
            continue
        taken = projection or Projection.THIRD
        source = "default" if projection is None else "given"
        alternatives = (taken.other,) if projection is None else ()
        rest = tuple(box for box in clusters if box != front)
        alone = Layout({Role.FRONT: front}, taken, source, alternatives, rest)
        layout = with_loose_views(alone, ink)
        if len(layout.boxes) > 1 and not may_be_views(layout.left_out):
            return layout
    return None


def _best(
    boxes: Mapping[Role, Box], others: Sequence[Box], projection: Projection, ink: Ink
) -> tuple[Role, Box] | None:
    """The role and the box of the drawing that is most surely a further view, if any is."""
    found = [
        (odds, role, box)
        for box in others
        for role in Role
        if role not in boxes and _stands(role, box, boxes[Role.FRONT], projection)
        for odds in [_log_odds(role, box, boxes, ink)]
        if odds >= _SURE
    ]
    if not found:
        return None
    _, role, box = max(found, key=lambda own: own[0])
    return role, box


def _stands(role: Role, box: Box, front: Box, projection: Projection) -> bool:
    """Whether a drawing lies on the side of the front view on which a role's view does."""
    column, row = role.slot(projection)
    across, up = (box[0] + box[2]) / 2.0, (box[1] + box[3]) / 2.0
    if role is Role.REAR:
        return not front[0] <= across <= front[2]
    if column:
        return across > front[2] if column > 0 else across < front[0]
    return up < front[1] if row > 0 else up > front[3]


def _log_odds(role: Role, box: Box, boxes: Mapping[Role, Box], ink: Ink) -> float:
    """How surely a drawing is the view of a role, by the views that are known."""
    total = 0.0
    for axis, sign, level in _shown(role):
        for other, known in boxes.items():
            shared = next((own for own in _shown(other) if own[0] is axis), None)
            if shared is not None:
                total += _agreement(
                    _levels(box, ink, level=level),
                    _levels(known, ink, level=shared[2]),
                    (_extent(box, level=level), _extent(known, level=shared[2])),
                    is_turned=sign != shared[1],
                )
                break
    return total


def _shown(role: Role) -> Iterator[tuple[Axis, int, bool]]:
    """The axes that a view shows: which, the sign in which it runs with the px of the sheet, and
    whether it runs across it."""
    axis, sign = role.frame.right_axis
    yield axis, sign, True
    axis, sign = role.frame.up_axis
    yield axis, -sign, False


def _agreement(
    own: Places, known: Places, extents: tuple[float, float], *, is_turned: bool
) -> float:
    """Log-odds that two drawings show one axis: by their extents, and by the lines of the one that
    has fewer."""
    near = max(_SAME_PX, _SAME * max(extents))
    if abs(extents[0] - extents[1]) > near:
        return -np.inf
    length = float(np.mean(extents))
    odds = -log(2.0 * near / length)
    if is_turned:
        own = extents[0] - own[::-1]
    fewer, more = sorted((own, known), key=len)
    chance = min(len(more) * 2.0 * near / length, _SHOWN)
    for place in fewer:
        is_there = bool((np.abs(more - place) <= near).any())
        odds += log(_SHOWN / chance) if is_there else log((1.0 - _SHOWN) / (1.0 - chance))
    return odds


def _extent(box: Box, *, level: bool) -> float:
    return box[2] - box[0] if level else box[3] - box[1]


def _levels(box: Box, ink: Ink, *, level: bool) -> Places:
    """px from where a drawing begins to its long lines across an axis, but for its outermost."""
    x0, y0, x1, y1 = (int(value) for value in box)
    sums = ink[y0:y1, x0:x1].sum(axis=0 if level else 1)
    across = (y1 - y0) if level else (x1 - x0)
    is_long = np.concatenate([[False], sums >= _LONG * across, [False]])
    begins, ends = (np.flatnonzero(np.diff(is_long.astype(int)) == way) for way in (1, -1))
    middles = (begins + ends) / 2.0
    edge = max(_SAME_PX, _SAME * len(sums)) + 2.0
    return middles[(middles > edge) & (middles < len(sums) - edge)]
