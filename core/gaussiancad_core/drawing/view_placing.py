"""Where each view stands on the sheet (ISO 5456-2), with shared rows and columns exact."""

from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_protocol.codes import Code


@dataclass(frozen=True)
class Placement:
    """A view's place.

    Attributes:
        role: the view.
        box: (x0, y0, x1, y1) sheet px of the part's extent, y down.
        scale: px per mm.
        offset: (2,) px, so that a plane point (right, up) lies at
            ``(offset[0] + scale * right, offset[1] - scale * up)``.
    """

    role: Role
    box: tuple[float, float, float, float]
    scale: float
    offset: tuple[float, float]


def check_roles(roles: tuple[Role, ...]) -> None:
    """Refuse views that are no set of two to six different ones.

    Raises:
        UsageError: ``views-count``, ``views-repeat``.
    """
    if not 2 <= len(roles) <= len(Role):
        raise UsageError(Code.VIEWS_COUNT, f"{len(roles)} views asked for: name two to six")
    if len(set(roles)) < len(roles):
        raise UsageError(Code.VIEWS_REPEAT, "a view is named twice: name each view once")


def place_views(
    size: npt.NDArray[np.float64],
    roles: tuple[Role, ...],
    projection: Projection,
    style: SheetStyle,
    corner: tuple[float, float] = (0.0, 0.0),
) -> tuple[Placement, ...]:
    """Place the views of a part on a sheet, as large as it allows, centred.

    Where a view would reach into the corner that stays free, all views stand above the corner or
    to the left of it, whichever leaves more room.

    Views in one column share their horizontal interval, views in one row their vertical one.

    Args:
        size: (3,) extent in mm of the part; its bounding box starts at the origin.
        roles: two to six different views.
        projection: first or third angle.
        style: sheet size, margin, gap, scale.
        corner: width and height in px at the sheet's lower right that stays free.

    Raises:
        UsageError: ``views-count``, ``views-repeat``, ``sheet-too-small``.
    """
    check_roles(roles)
    whole = _placed(size, roles, projection, style)
    left, top = style.width - corner[0], style.height - corner[1]
    if not any(place.box[2] > left and place.box[3] > top for place in whole):
        return whole
    rooms = [
        replace(style, height=round(style.height - max(0.0, corner[1] - style.margin))),
        replace(style, width=round(style.width - max(0.0, corner[0] - style.margin))),
    ]
    fitting = []
    for room in rooms:
        with suppress(UsageError):
            fitting.append(_placed(size, roles, projection, room))
    if not fitting:
        raise _too_small(style)
    return max(fitting, key=lambda places: places[0].scale)


def _placed(
    size: npt.NDArray[np.float64],
    roles: tuple[Role, ...],
    projection: Projection,
    style: SheetStyle,
) -> tuple[Placement, ...]:
    """Views centred on the sheet of a style."""
    slots = {role: role.slot(projection) for role in roles}
    widths = {slots[role][0]: _extent(size, role.frame.right_axis[0]) for role in roles}
    heights = {slots[role][1]: _extent(size, role.frame.up_axis[0]) for role in roles}
    scale = _scale(sum(widths.values()), sum(heights.values()), len(widths), len(heights), style)
    lefts = _starts(sorted(widths), widths, scale, style.width, style.view_gap)
    # Rows count up, the sheet's y runs down.
    tops = _starts(sorted(heights, reverse=True), heights, scale, style.height, style.view_gap)
    placements = []
    for role in roles:
        column, row = slots[role]
        x0, y0 = lefts[column], tops[row]
        x1, y1 = x0 + scale * widths[column], y0 + scale * heights[row]
        right_least = min(0.0, role.frame.right_axis[1] * widths[column])
        up_least = min(0.0, role.frame.up_axis[1] * heights[row])
        offset = (x0 - scale * right_least, y1 + scale * up_least)
        placements.append(Placement(role, (x0, y0, x1, y1), scale, offset))
    return tuple(placements)


def _extent(size: npt.NDArray[np.float64], axis: Axis) -> float:
    return float(size[axis.value])


def _scale(width: float, height: float, columns: int, rows: int, style: SheetStyle) -> float:
    """px per mm."""
    room_x = style.width - 2.0 * style.margin - (columns - 1) * style.view_gap
    room_y = style.height - 2.0 * style.margin - (rows - 1) * style.view_gap
    largest = min(room_x / width, room_y / height)
    scale = largest if style.mm_per_pixel is None else 1.0 / style.mm_per_pixel
    if largest <= 0.0 or scale > largest * (1.0 + 1e-9):
        raise _too_small(style)
    return scale


def _too_small(style: SheetStyle) -> UsageError:
    return UsageError(
        Code.SHEET_TOO_SMALL,
        f"the views do not fit on {style.width} x {style.height} px with these margins and "
        "this scale: take a larger sheet, or mm_per_pixel=fit",
    )


def _starts(
    order: list[int], extents: dict[int, float], scale: float, room: int, gap: float
) -> dict[int, float]:
    """The first coordinate of each column (or row), the whole centred in ``room``."""
    total = scale * sum(extents.values()) + gap * (len(order) - 1)
    position = (room - total) / 2.0
    starts = {}
    for key in order:
        starts[key] = position
        position += scale * extents[key] + gap
    return starts
