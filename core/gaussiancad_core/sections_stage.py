"""Full sections as cuts: their planes in millimetres, and what is hatched."""

from collections.abc import Sequence
from functools import reduce

import numpy as np
import shapely

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.drawn_views import Cut
from gaussiancad_core.sheet.notes.sections import NamedSection
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.reading import ReadView, RegisteredSheet


def cuts_of(registered: RegisteredSheet, sections: Sequence[NamedSection]) -> dict[Role, Cut]:
    """The cuts of views that are full sections.

    The plane is that of the cutting line in another view; without one it is the middle (ISO 128-3).

    Args:
        registered: the views.
        sections: that the sheet names.
    """
    return {
        view.role: Cut(_place(view, registered, sections), _areas(view, registered))
        for view in registered.drawn
        if view.hatched
    }


def _place(view: ReadView, registered: RegisteredSheet, sections: Sequence[NamedSection]) -> float:
    """mm of the plane along the axis that a section looks along."""
    axis = view.role.frame.look_axis[0]
    for section in sections:
        trace = section.trace
        if trace is None or not trace.straight or not _overlap(section.box, view.box):
            continue
        middle = np.mean(trace.ends, axis=0)
        for other in registered.drawn:
            at = _along(other.role, axis, registered, middle)
            if other.role is not view.role and _holds(other.box, middle) and at is not None:
                return at
    return registered.views.size[axis.value] / 2.0


def _along(role: Role, axis: Axis, registered: RegisteredSheet, place: np.ndarray) -> float | None:
    """mm along an axis of a place on the sheet, in a view; None where that does not show it."""
    frame = role.frame
    right, up = registered.placements[role].to_plane(place[None, :])[0].tolist()
    for (own, sign), value in ((frame.right_axis, right), (frame.up_axis, up)):
        if own is axis:
            return sign * value
    return None


def _areas(view: ReadView, registered: RegisteredSheet) -> shapely.Geometry:
    """What is hatched, mm in the view's plane."""
    place = registered.placements[view.role]
    rings = [shapely.Polygon(place.to_plane(np.array(ring))).buffer(0.0) for ring in view.hatched]
    return reduce(shapely.symmetric_difference, rings)


def _overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _holds(box: Box, place: np.ndarray) -> bool:
    x, y = place
    return bool(box[0] - 1.0 <= x <= box[2] + 1.0 and box[1] - 1.0 <= y <= box[3] + 1.0)
