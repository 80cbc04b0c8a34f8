"""Where drawings stand on the sheet, as views stand around the front view (ISO 5456-2)."""

from collections.abc import Sequence

from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.views.sheet_layout import alignment_tolerance
from gaussiancad_protocol.codes import Code


def nearest(front: Box, boxes: Sequence[Box], role: Role, projection: Projection) -> list[Box]:
    """The drawings in line where a role's view stands, the nearest first."""
    gaps = [
        (gap_to_neighbour(front, box, role.slot(projection)), box) for box in boxes if box != front
    ]
    return [box for gap, box in sorted((gap, box) for gap, box in gaps if gap is not None)]


def stands(role: Role, box: Box, front: Box, projection: Projection) -> bool:
    """Whether a drawing lies on the side of the front view on which a role's view does."""
    across, up = (box[0] + box[2]) / 2.0, (box[1] + box[3]) / 2.0
    if role is Role.REAR:
        return not front[0] <= across <= front[2]
    column, row = role.slot(projection)
    if column:
        return across > front[2] if column > 0 else across < front[0]
    return up < front[1] if row > 0 else up > front[3]


def gap_to_neighbour(front: Box, box: Box, slot: tuple[int, int]) -> float | None:
    """px from a front view to a drawing in line with it on the side of a slot, or None."""
    column, row = slot
    if row:
        in_line = _same_interval(front[0], front[2], box[0], box[2])
        gap = front[1] - box[3] if row > 0 else box[1] - front[3]
    else:
        in_line = _same_interval(front[1], front[3], box[1], box[3])
        gap = box[0] - front[2] if column > 0 else front[0] - box[2]
    return gap if in_line and gap > 0 else None


def box_inside(boxes: Sequence[Box], box: Box, role: Role) -> Box:
    """The box around the drawings whose middle lies in a given box.

    Raises:
        UsageError: there is none.
    """
    x0, y0, x1, y1 = box
    found = [c for c in boxes if x0 <= (c[0] + c[2]) / 2 <= x1 and y0 <= (c[1] + c[3]) / 2 <= y1]
    if not found:
        raise UsageError(
            Code.EMPTY_VIEW_BOX,
            "--view {view}: there are no lines in the box {box}",
            view=role,
            box=f"{x0:g},{y0:g},{x1:g},{y1:g}",
        )
    low_x, low_y, high_x, high_y = zip(*found, strict=True)
    return min(low_x), min(low_y), max(high_x), max(high_y)


def _same_interval(a0: float, a1: float, b0: float, b1: float) -> bool:
    tolerance = alignment_tolerance(max(a1 - a0, b1 - b0))
    return abs(a0 - b0) <= tolerance and abs(a1 - b1) <= tolerance
