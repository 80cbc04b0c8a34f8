"""What kind of drawing a view is: cut open where it is hatched, pictorial by its three axes."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.sheet_model.paper_sheet import PaperStroke
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.stroke_levels import is_painted

_HATCHED, _FEWEST_HATCHES = 0.02, 3
"""Share of a section's outline that is hatched at least, and lines of that."""

_GREY, _FILLED = 120, 0.3
"""Level from which a filled area is pale; share of the outline that it fills of a section."""

_FEWEST_LINES = 9
"""Lines of a pictorial at least."""

_SLANTED, _ASKEW = 2.0, 4.0
"""Degrees from the sheet's axes from which a line is slanted, and from which an axis is."""

_MOST_SLANTED, _OF_AXIS, _ON_AXES = 0.45, 0.1, 0.5
"""Share of a pictorial's lines that are slanted, of those along each axis, and along all, at
least."""

_WIDE = 6
"""Degrees to either side of an axis that are its own."""

_NOT_SQUARE = 8.0
"""Degrees by which both slanted axes are not square to each other at least."""


_CONVEX = 0.98
"""Share of its hull that an outline fills which is convex."""


def with_kinds(views: Sequence[DrawnView], fills: Sequence[PaperStroke]) -> list[DrawnView]:
    """The drawings, sections and pictorials told.

    Args:
        views: of a sheet.
        fills: filled areas that are no letters.
    """
    pale = [
        Polygon(fill.points).buffer(0.0)
        for fill in fills
        if fill.pen.colour and min(fill.pen.colour) > _GREY and len(fill.points) > 3
    ]
    found = []
    for view in views:
        kind = view.kind
        if kind is not DrawingKind.SCRAP:
            if _is_hatched(view) or _is_filled(view, pale):
                kind = DrawingKind.SECTION
            elif kind is DrawingKind.PLAIN and _is_pictorial(view):
                kind = DrawingKind.PICTORIAL
        found.append(replace(view, kind=kind))
    return found


def _is_hatched(view: DrawnView) -> bool:
    if sum(map(len, view.hatching)) < _FEWEST_HATCHES:
        return False
    hulls = [shapely.union_all([s.line for s in family]).convex_hull for family in view.hatching]
    return sum(hull.area for hull in hulls) > _HATCHED * view.outline.area


def _is_filled(view: DrawnView, pale: Sequence[shapely.Geometry]) -> bool:
    least = _FILLED * view.outline.area
    return any(area.intersection(view.outline).area > least for area in pale)


def _is_pictorial(view: DrawnView) -> bool:
    """Whether most lines run along three directions, two of them slanted, and not square."""
    lines = [edge for edge in view.edges if edge.is_line]
    if len(lines) < _FEWEST_LINES:
        return False
    ways = np.array([line.way for line in lines])
    angles = np.degrees(np.arctan2(ways[:, 1], ways[:, 0])) % 180.0
    lengths = np.array([line.length for line in lines])
    off_axis = np.minimum(angles % 90.0, 90.0 - angles % 90.0)
    if lengths[off_axis > _SLANTED].sum() < _MOST_SLANTED * lengths.sum():
        return False
    along = np.bincount(angles.astype(int) % 180, lengths, minlength=180)
    smooth = along + np.roll(along, 1) + np.roll(along, -1)
    axes = []
    for _ in range(3):
        degree = int(np.argmax(smooth))
        if smooth[degree] > _OF_AXIS * lengths.sum():
            axes.append((degree, float(smooth[degree])))
        smooth[(degree + np.arange(-_WIDE, _WIDE + 1)) % 180] = 0.0
    slants = [degree for degree, _ in axes if min(degree % 90, 90 - degree % 90) > _ASKEW]
    if len(axes) < 3 or len(slants) < 2:
        return False
    apart = abs(slants[0] - slants[1]) % 180
    is_square = abs(min(apart, 180 - apart) - 90.0) <= _NOT_SQUARE
    if is_square or sum(share for _, share in axes) <= _ON_AXES * lengths.sum():
        return False
    # The outline of a hexagon has those directions as well.
    hull = view.outline.convex_hull
    return not is_painted(view) or view.outline.area < _CONVEX * hull.area
