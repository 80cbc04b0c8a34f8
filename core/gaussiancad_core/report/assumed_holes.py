"""Holes that were taken to go through, as nothing on the sheet says how deep they are."""

from collections.abc import Iterator

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.report.report_entries import Assumption
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_protocol.codes import Code

_SAME = 0.02
"""Share of its radius within which a circle is one of which a note speaks."""

_BESIDE = 0.02
"""Radii inside and outside of a circle at which the solid is looked through."""

_FINE = 1e-4
"""Tolerance of sight lines as a share of the longest extent."""


def assumed_holes(
    reading: ProjectedReading, shape: TopoDS_Shape, turn: Turn
) -> Iterator[Assumption]:
    """Circles of views without hidden lines through which one looks, those of one diameter in a
    view together.

    Args:
        reading: the views, with the holes of which notes speak.
        shape: the solid, mm.
        turn: of the sheet.
    """
    tolerance = _FINE * max(reading.registered.views.size)
    for view in reading.registered.views.views:
        if view.role in reading.cuts or any(
            stroke.linetype is Linetype.HIDDEN for stroke in view.strokes
        ):
            continue
        circles = [
            stroke
            for stroke in view.strokes
            if isinstance(stroke, Arc)
            and stroke.is_full
            and stroke.linetype is Linetype.VISIBLE
            and not _is_noted(stroke, view.role, reading)
        ]
        if not circles:
            continue
        sights = SolidRays(shape, view.role.frame, tolerance)
        inside, outside = (
            sights.crossings_at(np.array([_point_right_of(circle, share) for circle in circles]))
            for share in (1.0 - _BESIDE, 1.0 + _BESIDE)
        )
        alike: dict[float, list[Arc]] = {}
        for this_circle, within, around in zip(circles, inside, outside, strict=True):
            if not len(within.depth) and len(around.depth):
                alike.setdefault(round(this_circle.radius, 3), []).append(this_circle)
        for holes in alike.values():
            boxes = tuple(_box(hole, reading, view.role, turn) for hole in holes)
            yield _assumed(holes[0], view.role, boxes)


def _assumed(circle: Arc, role: Role, boxes: tuple[Box, ...]) -> Assumption:
    return Assumption(
        Code.HOLE_THROUGH,
        Message(
            "the hole of {diameter_mm:.4g} mm in the {view} view was taken to go through, as "
            "nothing tells its depth",
            diameter_mm=2.0 * circle.radius,
            view=role,
            case="several" if len(boxes) > 1 else "one",
            count=len(boxes),
        ),
        boxes[0],
        "it ends inside: state its depth in a note, or draw its hidden lines",
        boxes,
    )


def _point_right_of(circle: Arc, share: float) -> tuple[float, float]:
    """A place on the right of a circle's centre, so many radii away."""
    return circle.centre[0] + share * circle.radius, circle.centre[1]


def _is_noted(circle: Arc, role: Role, reading: ProjectedReading) -> bool:
    near = _SAME * circle.radius
    return any(
        hole.role is role and np.hypot(*np.subtract(hole.centre, circle.centre)) <= near
        for hole in reading.holes
    )


def _box(circle: Arc, reading: ProjectedReading, role: Role, turn: Turn) -> Box:
    x, y = circle.centre
    ends = np.array(
        [[x - circle.radius, y - circle.radius], [x + circle.radius, y + circle.radius]]
    )
    places = turn.to_stored(reading.registered.placements[role].to_sheet(ends))
    (x0, y0), (x1, y1) = places.min(0).tolist(), places.max(0).tolist()
    return round(x0, 1), round(y0, 1), round(x1, 1), round(y1, 1)
