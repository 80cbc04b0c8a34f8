"""Edge breaks taken off before the search: chamfers and roundings around a face, seen from beside.

A break around a face is a short slanted stroke, or an arc, at either end of the face in a view from
beside, and a line at its foot; in the view on the face it is a narrow band along the outline.  What
is like that in one view alone is a profile's own corner.  Here corners are made sharp, and what the
breaks draw is taken off; :mod:`.breaking_edges` puts them on the solid.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.proposing.break_bands import without_bands
from gaussiancad_core.proposing.broken_corners import (
    MEET,
    BrokenCorner,
    EdgeBreak,
    broken_corners,
    sharpened,
)
from gaussiancad_core.proposing.stroke_lines import StrokeLine, as_stroke, stroke_lines


@dataclass(frozen=True, eq=False)
class EdgeBreaks:
    """The breaks of a sheet.

    Attributes:
        each: one for each corner that shows one.
        rims: of the faces across each axis, holes whose edges are broken, too.
    """

    each: tuple[EdgeBreak, ...]
    rims: Mapping[Axis, tuple[shapely.Polygon, ...]]


def without_breaks(views: DrawnViews) -> tuple[DrawnViews, EdgeBreaks]:
    """Views whose edges are sharp where they were broken around a face, and these breaks."""
    near = MEET * views.tolerance
    lines = {role: stroke_lines(strokes, role) for role, strokes in views.strokes.items()}
    corners = [
        corner
        for role, drawn in lines.items()
        for corner in broken_corners(drawn, role, views, near)
    ]
    found: dict[Role, list[BrokenCorner]] = {}
    breaks: list[EdgeBreak] = []
    for corner in corners:
        around = [
            each
            for each in (corner.around(0), corner.around(1))
            if _goes_around(each, corner.role, corners, lines, near)
        ]
        if around:
            found.setdefault(corner.role, []).append(corner)
            breaks += around
    strokes: dict[Role, tuple[DrawnStroke, ...]] = {}
    rims: dict[Axis, list[shapely.Polygon]] = {}
    for role, drawn in lines.items():
        kept, plane = sharpened(drawn, found.get(role, ()), near), role_plane(role)
        around = [each for each in breaks if each.axis is plane.normal]
        if around:
            kept, holes = without_bands(kept, around, views.tolerance)
            rims.setdefault(plane.normal, []).extend(holes)
        strokes[role] = tuple(as_stroke(line, np.array(plane.signs)) for line in kept)
    every = {axis: tuple(holes) for axis, holes in rims.items()}
    return replace(views, strokes=strokes), EdgeBreaks(tuple(breaks), every)


def _goes_around(
    edge_break: EdgeBreak,
    role: Role,
    corners: Sequence[BrokenCorner],
    lines: Mapping[Role, Sequence[StrokeLine]],
    near: float,
) -> bool:
    """Whether other views show that a break goes around its face: from beside a corner at the same
    place, or, where no other looks from beside, a line in the view on the face that ends before the
    outline does."""
    look = role_plane(role).normal
    lateral = [
        other
        for other in lines
        if role_plane(other).normal not in (edge_break.axis, look)
        and any(line.stroke.linetype is Linetype.VISIBLE for line in lines[other])
    ]
    if lateral:
        return any(
            corner.role in lateral
            and any(_is_same(corner.around(column), edge_break, near) for column in (0, 1))
            for corner in corners
        )
    return any(
        _ends_before(drawn, edge_break, look, near)
        for other, drawn in lines.items()
        if role_plane(other).normal is edge_break.axis
    )


def _is_same(one: EdgeBreak, other: EdgeBreak, near: float) -> bool:
    """Whether two breaks are of one face."""
    return (
        one.axis is other.axis
        and abs(one.at - other.at) <= near
        and abs(one.height - other.height) <= near
    )


def _ends_before(
    drawn: Sequence[StrokeLine], edge_break: EdgeBreak, look: Axis, near: float
) -> bool:
    """Whether a view on a face has a line at a break's foot that is shorter than the outline."""
    across = IN_PLANE[edge_break.axis].index(edge_break.across.value)
    along = IN_PLANE[edge_break.axis].index(look.value)
    whole = np.vstack([line.points for line in drawn])
    low, high = whole[:, along].min(), whole[:, along].max()
    feet = edge_break.place - edge_break.width, edge_break.place + edge_break.width
    for line in drawn:
        ends = line.points[:, across].min(), line.points[:, across].max()
        if min(abs(end - foot) for end in ends for foot in feet) > near:
            continue
        first, last = line.points[:, along].min(), line.points[:, along].max()
        inset = edge_break.width / 2.0
        if last - first > edge_break.width and first > low + inset and last < high - inset:
            return True
    return False
