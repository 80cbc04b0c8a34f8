"""Sections as cuts: their planes in millimetres, what is hatched, and where they are cut open."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import pairwise

import numpy as np
import shapely

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.section_planes import Cut, CutRegion, SectionRole
from gaussiancad_core.model.views import Arc, Stroke
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.registration.view_registration import (
    Placement,
    placement,
    strokes_in_plane,
)
from gaussiancad_core.sheet.sheet_stages import ReadView, RegisteredSheet
from gaussiancad_core.sheet.special_views.adjacent_sections import overlap
from gaussiancad_core.writing.section_titles import NamedSection, Trace

_FAR = 1e5
"""mm beyond every part."""


@dataclass(frozen=True, eq=False)
class SectionBeside:
    """A section beside a plain view of the same direction.

    Attributes:
        strokes: mm in the view's plane.
        cut: where it is cut open.
        place: of the plane on the sheet.
    """

    strokes: tuple[Stroke, ...]
    cut: Cut
    place: Placement

    @property
    def box(self) -> Box:
        """Around it, px of the upright sheet."""
        return self.place.box


def cuts_of(registered: RegisteredSheet, sections: Sequence[NamedSection]) -> dict[Role, Cut]:
    """The cuts of views that are sections.

    The planes are those of the cutting line in another view; without one it is the middle
    (ISO 128-3).

    Args:
        registered: the views.
        sections: that the sheet names.
    """
    return {
        view.role: _cut(view, registered.placements[view.role], registered, sections)
        for view in registered.drawn
        if view.hatched
    }


def sections_of(
    registered: RegisteredSheet, views: Sequence[ReadView], sections: Sequence[NamedSection]
) -> dict[SectionRole, SectionBeside]:
    """Sections that stand beside plain views, on the axes of these.

    Args:
        registered: the plain views.
        views: the sections, px of the upright sheet.
        sections: that the sheet names.
    """
    found = {}
    for number, view in enumerate(views, start=1):
        section = _named(view.box, sections)
        label = section.title.label if section is not None else str(number)
        place = placement(view.role, view.box, registered.views.size)
        cut = _cut(view, place, registered, sections)
        strokes = strokes_in_plane(view.strokes, place)
        found[SectionRole(view.role, label)] = SectionBeside(tuple(strokes), cut, place)
    return found


def _cut(
    view: ReadView,
    place: Placement,
    registered: RegisteredSheet,
    sections: Sequence[NamedSection],
) -> Cut:
    rings = [shapely.Polygon(place.to_plane(np.array(ring))).buffer(0.0) for ring in view.hatched]
    areas = reduce(shapely.symmetric_difference, rings)
    section = _named(view.box, sections)
    openings: tuple[CutRegion, ...] = ()
    if section is not None and section.trace is not None:
        openings = tuple(_traced(view.role, section.trace, registered))
    if not openings:
        axis = view.role.frame.look_axis[0]
        openings = (_untraced(view.role, axis, registered),)
    if view.opened and len(openings) == 1:
        region = shapely.Polygon(place.to_plane(np.array(view.opened))).buffer(0.0)
        openings = (replace(openings[0], region=region),)
    return Cut(openings, areas)


def _untraced(role: Role, axis: Axis, registered: RegisteredSheet) -> CutRegion:
    """The plane of a section without a cutting line: through the most circles that other views
    draw, where none of them is in the middle; else through that."""
    middle = registered.views.size[axis.value] / 2.0
    pixel = registered.mm_per_pixel
    places = []
    for view in registered.views.views:
        if view.role is not role and axis in _in_plane(view.role):
            centres = [
                stroke.centre
                for stroke in view.strokes
                if isinstance(stroke, Arc) and stroke.is_full
            ]
            places += _along(view.role, axis, np.array(centres).reshape(-1, 2)) or []
    if not places or any(abs(place - middle) <= pixel for place in places):
        return CutRegion(middle, source="symmetry")
    likely = max(places, key=lambda place: sum(abs(place - other) <= pixel for other in places))
    return CutRegion(likely, source="circle")


def _named(box: Box, sections: Sequence[NamedSection]) -> NamedSection | None:
    return next((section for section in sections if overlap(section.box, box)), None)


def _traced(role: Role, trace: Trace, registered: RegisteredSheet) -> Iterator[CutRegion]:
    """The openings of a cutting line that runs in another view, in steps where it has some; none of
    one whose steps are not known."""
    if not trace.path:
        return
    axis = role.frame.look_axis[0]
    middle = np.mean(trace.ends, axis=0)
    for other in registered.drawn:
        if other.role is role or not _holds(other.box, middle):
            continue
        points = registered.placements[other.role].to_plane(np.array(trace.path))
        depths = _along(other.role, axis, points)
        across = next(
            (
                this_axis
                for this_axis in _in_plane(other.role)
                if this_axis is not axis and this_axis in _in_plane(role)
            ),
            None,
        )
        places = None if across is None else _along(other.role, across, points)
        if depths is None or across is None or places is None:
            continue
        runs = [
            (depth, start, end)
            for (depth, after), (start, end) in zip(pairwise(depths), pairwise(places), strict=True)
            if abs(after - depth) < abs(end - start)
        ]
        if not runs:
            # It runs along the way in which the section looks, and cuts nothing square to that.
            continue
        if len(runs) == 1:
            yield CutRegion(runs[0][0])
            return
        runs = runs if runs[0][1] < runs[-1][2] else [(d, e, s) for d, s, e in runs[::-1]]
        ends = [-_FAR, *(run[1] for run in runs[1:]), _FAR]
        for (depth, _, _), low, high in zip(runs, ends, ends[1:], strict=False):
            yield CutRegion(depth, _band(role, across, low, high))
        return


def _in_plane(role: Role) -> tuple[Axis, Axis]:
    return role.frame.right_axis[0], role.frame.up_axis[0]


def _along(role: Role, axis: Axis, points: np.ndarray) -> list[float] | None:
    """mm along an axis of places in a view's plane; None where that does not show it."""
    frame = role.frame
    for index, (this_axis, sign) in enumerate((frame.right_axis, frame.up_axis)):
        if this_axis is axis:
            return (sign * points[:, index]).tolist()
    return None


def _band(role: Role, across: Axis, low: float, high: float) -> shapely.Geometry:
    """The part of a view's plane between two places along one of its axes."""
    (right, sign), (_, up_sign) = role.frame.right_axis, role.frame.up_axis
    if right is across:
        low, high = sorted((sign * low, sign * high))
        return shapely.box(low, -_FAR, high, _FAR)
    low, high = sorted((up_sign * low, up_sign * high))
    return shapely.box(-_FAR, low, _FAR, high)


def _holds(box: Box, place: np.ndarray) -> bool:
    x, y = place
    return bool(box[0] - 1.0 <= x <= box[2] + 1.0 and box[1] - 1.0 <= y <= box[3] + 1.0)
