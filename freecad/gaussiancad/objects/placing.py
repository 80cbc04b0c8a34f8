"""Where a view of the sheet stands in space, so that it lies behind the part at true scale.

The six planes form a box around the part, as the views of a drawing do before they are unfolded:
each view is on the far side of the part as its viewer sees it.  Axes are FreeCAD's: the front view
looks along +Y with X to its right and Z up; the part's bounding box starts at the origin.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from freecad.gaussiancad.engine.report import ViewBox, ViewReport

Triple = tuple[float, float, float]

GAP_SHARE = 0.15
"""Distance between the part and a view's plane, as a share of the part's longest edge."""


@dataclass(frozen=True)
class Frame:
    """A view's directions in model axes.

    Attributes:
        right, up: on the sheet.
        look: away from the viewer.
    """

    right: tuple[int, int, int]
    up: tuple[int, int, int]
    look: tuple[int, int, int]


FRAMES = {
    "front": Frame((1, 0, 0), (0, 0, 1), (0, 1, 0)),
    "top": Frame((1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "right": Frame((0, 1, 0), (0, 0, 1), (-1, 0, 0)),
    "left": Frame((0, -1, 0), (0, 0, 1), (1, 0, 0)),
    "bottom": Frame((1, 0, 0), (0, -1, 0), (0, 0, 1)),
    "rear": Frame((-1, 0, 0), (0, 0, 1), (0, -1, 0)),
}


@dataclass(frozen=True)
class PlanePlacement:
    """A rectangle in space.

    Attributes:
        centre: mm.
        right, up, towards: unit vectors; ``towards`` points to the viewer.
        width, height: mm.
    """

    centre: Triple
    right: Triple
    up: Triple
    towards: Triple
    width: float
    height: float


def part_size(views: Iterable[ViewReport], mm_per_pixel: float) -> Triple:
    """(x, y, z) extent of the part in mm as its views show it; 0 along an axis that none shows."""
    size = [0.0, 0.0, 0.0]
    for view in views:
        frame = FRAMES.get(view.role)
        if frame is None or view.box is None:
            continue
        x0, y0, x1, y1 = view.box
        for direction, extent in ((frame.right, x1 - x0), (frame.up, y1 - y0)):
            axis = _axis(direction)
            size[axis] = size[axis] or extent * mm_per_pixel
    return (size[0], size[1], size[2])


def place_view(
    view: ViewReport, crop: ViewBox, size: Triple, mm_per_pixel: float
) -> PlanePlacement | None:
    """Where a piece of the sheet around a view stands.

    Args:
        view: the view, with its box in sheet pixels.
        crop: (x0, y0, x1, y1) of the piece in sheet pixels.
        size: (x, y, z) extent of the part in mm.
        mm_per_pixel: of the sheet.

    Returns:
        None for a view without a box or with an unknown role.
    """
    frame = FRAMES.get(view.role)
    if frame is None or view.box is None:
        return None
    x0, _, _, y1 = view.box
    middle_x, middle_y = (crop[0] + crop[2]) / 2.0, (crop[1] + crop[3]) / 2.0
    right = _lowest(frame.right, size) + (middle_x - x0) * mm_per_pixel
    up = _lowest(frame.up, size) + (y1 - middle_y) * mm_per_pixel
    depth = _highest(frame.look, size) + GAP_SHARE * max(size)
    centre = [
        right * frame.right[axis] + up * frame.up[axis] + depth * frame.look[axis]
        for axis in range(3)
    ]
    return PlanePlacement(
        (centre[0], centre[1], centre[2]),
        _floats(frame.right),
        _floats(frame.up),
        _floats(_reversed(frame.look)),
        (crop[2] - crop[0]) * mm_per_pixel,
        (crop[3] - crop[1]) * mm_per_pixel,
    )


def plane_corner(role: str, size: Triple) -> tuple[float, float]:
    """Least coordinates of the part in a view's plane, mm: along its right and along its up.

    Args:
        role: one of :data:`FRAMES`.
        size: (x, y, z) extent of the part in mm.
    """
    frame = FRAMES[role]
    return _lowest(frame.right, size), _lowest(frame.up, size)


def place_plane(role: str, drawn: Iterable[str], size: Triple) -> PlanePlacement:
    """The plane of a view through the origin, as wide as the part; its coordinates are the part's.

    Of two views that look against each other the one that sees the far end of the axis stands
    there, so that they do not lie over each other.

    Args:
        role: one of :data:`FRAMES`.
        drawn: roles of all views.
        size: (x, y, z) extent of the part in mm.

    Returns:
        The plane, its ``centre`` where its two coordinates are 0.
    """
    frame = FRAMES[role]
    away = _reversed(frame.look)
    faces_both = any(FRAMES[item].look == away for item in drawn)
    depth = _highest(away, size) if faces_both else 0.0
    return PlanePlacement(
        (depth * away[0], depth * away[1], depth * away[2]),
        _floats(frame.right),
        _floats(frame.up),
        _floats(away),
        size[_axis(frame.right)],
        size[_axis(frame.up)],
    )


def _axis(direction: tuple[int, int, int]) -> int:
    return next(axis for axis in range(3) if direction[axis])


def _lowest(direction: tuple[int, int, int], size: Triple) -> float:
    """Least coordinate of the part along a direction."""
    axis = _axis(direction)
    return 0.0 if direction[axis] > 0 else -size[axis]


def _highest(direction: tuple[int, int, int], size: Triple) -> float:
    axis = _axis(direction)
    return size[axis] if direction[axis] > 0 else 0.0


def _reversed(direction: tuple[int, int, int]) -> tuple[int, int, int]:
    return (-direction[0], -direction[1], -direction[2])


def _floats(direction: tuple[int, int, int]) -> Triple:
    return (float(direction[0]), float(direction[1]), float(direction[2]))
