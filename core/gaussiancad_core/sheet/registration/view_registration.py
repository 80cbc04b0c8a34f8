"""Bring the views of a sheet onto shared axes in millimetres.

Each view's box runs between the centre lines of its outermost strokes.  Views that show the same
axis are drawn to the same length; where they differ a little the mean is taken and each view is
stretched to it, where they differ much the views do not belong together.  In between, each
coordinate is shared by all views (:mod:`gaussiancad_core.sheet.registration.shared_axes`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment, Stroke, View
from gaussiancad_core.sheet.picture_noise import OVERSHOOT
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.registration.axis_residuals import Residual
from gaussiancad_core.sheet.registration.shared_axes import ViewMap
from gaussiancad_core.sheet.registration.view_masks import Outline
from gaussiancad_protocol.codes import Code

DEFAULT_LONGEST_MM = 100.0
"""Longest edge of the bounding box when the sheet's scale is not known."""

_SAME = 1.5
"""px by which the extents of an axis may differ between views without a word."""

_CONTRADICTION = 0.1
"""Share by which they may differ at most."""

_NEAR_OUTLINE = 1.5
"""px between a stroke along a side of a view and the outline there."""

_NEAR_EXACT = 4.0
"""The same for strokes of a file."""

_LEVEL, _SHORTEST_SIDE = 0.6, 8.0
"""px: largest lean and shortest length of a stroke along a side."""

_UPON = 0.75
"""px beyond an edge that ends strokes within which they are not drawn too long."""

_MARGIN = 4
"""Blank mask px around the view's box."""


@dataclass(frozen=True)
class AxisExtents:
    """Extent of each axis of the part in sheet px.

    Attributes:
        extents: axis -> mean over the views that show it.
        spread: axis -> largest minus smallest.
        residuals: axis -> distances of what the views show from the shared coordinates, for axes
            that two views show.
    """

    extents: dict[Axis, float]
    spread: dict[Axis, float]
    residuals: dict[Axis, Residual] = field(default_factory=dict)

    @property
    def disagreeing(self) -> tuple[Axis, ...]:
        """Axes on which the views differ noticeably, in extent or in what lies between."""
        return tuple(
            axis
            for axis, spread in self.spread.items()
            if spread > _SAME
            or (axis in self.residuals and self.residuals[axis].median > _SAME / 3)
        )


@dataclass(frozen=True)
class Placement:
    """The affine map from sheet px to a view's plane.

    Attributes:
        role: of the view.
        box: of the view in sheet px.
        right: (mm at the box's left edge, mm at its right edge).
        up: (mm at the box's lower edge, mm at its upper edge).
    """

    role: Role
    box: Box
    right: tuple[float, float]
    up: tuple[float, float]

    def to_plane(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) sheet px -> (n, 2) mm (right, up)."""
        x0, y0, x1, y1 = self.box
        u = (points[:, 0] - x0) / (x1 - x0)
        v = (y1 - points[:, 1]) / (y1 - y0)
        return np.stack(
            [
                self.right[0] + u * (self.right[1] - self.right[0]),
                self.up[0] + v * (self.up[1] - self.up[0]),
            ],
            axis=1,
        )

    def to_sheet(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) mm (right, up) -> (n, 2) sheet px."""
        x0, y0, x1, y1 = self.box
        u = (points[:, 0] - self.right[0]) / (self.right[1] - self.right[0])
        v = (points[:, 1] - self.up[0]) / (self.up[1] - self.up[0])
        return np.stack([x0 + u * (x1 - x0), y1 - v * (y1 - y0)], axis=1)


def view_box(strokes: tuple[Stroke, ...], outline: Outline, exact: bool = False) -> Box:
    """The box between the centre lines of the outermost strokes.

    The strokes are exact to a tenth of a px; where the outline says something else (a curve that no
    stroke follows) it is the outline that counts.  Of the strokes those along a side of the box
    tell where it is, though others that cross them were drawn too long; ends of others only where
    there are none.  Exact strokes count farther from
    the outline, which closes narrow gaps between lines.
    """
    rough = outline.box
    reach = _NEAR_EXACT if exact else _NEAR_OUTLINE
    solid = [stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE]
    if not solid:
        return rough
    points = np.concatenate([stroke.extremes() for stroke in solid])
    sides = []
    for side, near in enumerate(rough):
        direction, inward = side % 2, 1.0 if side < 2 else -1.0
        along = [level for stroke in solid for level in _levels(stroke, direction)]
        found = [level for level in along if abs(level - near) < reach]
        ends = points[:, direction]
        outermost = float(ends.min() if inward > 0 else ends.max())
        overshot = None if found else _overshot(solid, direction, near, inward)
        if found:
            sides.append(min(found) if inward > 0 else max(found))
        elif overshot is not None:
            sides.append(overshot)
        else:
            sides.append(outermost if abs(outermost - near) < reach else near)
    return sides[0], sides[1], sides[2], sides[3]


def _overshot(
    strokes: Sequence[Stroke], direction: int, near: float, inward: float
) -> float | None:
    """The outermost stroke along a side, if all that reaches beyond it crosses it and ends soon."""
    levels = [level for stroke in strokes for level in _levels(stroke, direction)]
    inside = [level for level in levels if 0.0 < (level - near) * inward < OVERSHOOT]
    if not inside:
        return None
    side = min(inside, key=lambda level: level * inward)
    beyond = []
    for stroke in strokes:
        ends = stroke.extremes()
        depths = (ends[:, direction] - side) * inward
        crosses = isinstance(stroke, Segment) and depths.max() > OVERSHOOT
        if depths.min() < -_UPON:
            if not crosses:
                return None
            beyond.append(ends[int(np.argmin(depths))])
    # Where two of them meet they end at a corner, as at the rim of a cone.
    for one, other in combinations(beyond, 2):
        if np.hypot(*(one - other)) < _UPON:
            return None
    return side


def _levels(stroke: Stroke, direction: int) -> list[float]:
    """Coordinates at which a stroke runs across a direction of the sheet."""
    if isinstance(stroke, Segment):
        across = np.abs(np.subtract(stroke.end, stroke.start))
        is_level = across[direction] < _LEVEL and across[1 - direction] > _SHORTEST_SIDE
        return [(stroke.start[direction] + stroke.end[direction]) / 2.0] if is_level else []
    return [float(point[direction]) for point in stroke.extremes()[2:]]


def axis_extents(boxes: dict[Role, Box], unseen: Axis | None = None) -> AxisExtents:
    """Extent of each axis over the views.

    Args:
        boxes: of the views, px.
        unseen: the axis that no view has to show; it has no extent then.

    Raises:
        NoModelError: ``views-contradict`` if two views show an axis with very different lengths.
    """
    seen: dict[Axis, dict[Role, float]] = {}
    for role, (x0, y0, x1, y1) in boxes.items():
        seen.setdefault(role.frame.right_axis[0], {})[role] = x1 - x0
        seen.setdefault(role.frame.up_axis[0], {})[role] = y1 - y0
    missing = [axis.name for axis in Axis if axis not in seen and axis is not unseen]
    if missing:
        raise NoModelError(
            Code.VIEWS_PARALLEL,
            "the views show nothing of the {axis} axis: two orthogonal views are needed",
            axis=missing[0],
        )
    for axis, by_role in seen.items():
        longest, shortest = max(by_role.values()), min(by_role.values())
        if longest - shortest > max(_CONTRADICTION * longest, 3.0):
            text = ", ".join(f"{role.value} {px:.0f} px" for role, px in by_role.items())
            raise NoModelError(
                Code.VIEWS_CONTRADICT,
                "the views disagree about the part's extent along {axis} ({extents}): "
                "check that they show one part at one scale, or name them with --view",
                boxes=[boxes[role] for role in by_role],
                axis=axis.name,
                extents=text,
                views=", ".join(role.value for role in by_role),
                percent=round(100 * (1.0 - shortest / longest)),
            )
    known = {axis: list(seen[axis].values()) for axis in Axis if axis in seen}
    extents = {axis: float(np.mean(items)) for axis, items in known.items()}
    spread = {axis: max(items) - min(items) for axis, items in known.items()}
    return AxisExtents(extents, spread)


def placement(role: Role, box: Box, size: tuple[float, float, float]) -> Placement:
    """Where a view's box lies in its plane, for a part of a size in mm."""

    def interval(axis: Axis, sign: int) -> tuple[float, float]:
        extent = size[axis.value]
        return (0.0, extent) if sign > 0 else (-extent, 0.0)

    return Placement(role, box, interval(*role.frame.right_axis), interval(*role.frame.up_axis))


def shared_placement(
    plain: Placement, view_map: ViewMap, size: tuple[float, float, float]
) -> Placement:
    """Where a view lies in its plane once the axes are shared.

    Args:
        plain: its box in its plane, in px of its own extents.
        view_map: its place on the shared axes.
        size: of the part in px.
    """
    shared = placement(plain.role, plain.box, size)
    frame = plain.role.frame
    signs = np.array([frame.right_axis[1], frame.up_axis[1]])
    corners = np.array([[shared.right[0], shared.up[0]], [shared.right[1], shared.up[1]]])
    # Where the ends of the shared axes were on the view's own.
    (x0, y1), (x1, y0) = plain.to_sheet(
        (corners - signs * view_map.shift) / np.array(view_map.gain)
    )
    box = (float(x0), float(y0), float(x1), float(y1))
    return Placement(plain.role, box, shared.right, shared.up)


def strokes_in_plane(strokes: tuple[Stroke, ...], place: Placement) -> tuple[Stroke, ...]:
    """Strokes in sheet px (y down) -> strokes in mm (right, up)."""
    x0, y0, x1, y1 = place.box
    scale = (place.right[1] - place.right[0]) / (x1 - x0) + (place.up[1] - place.up[0]) / (y1 - y0)

    def moved(point: tuple[float, float]) -> tuple[float, float]:
        right, up = place.to_plane(np.array([point]))[0]
        return float(right), float(up)

    placed: list[Stroke] = []
    for stroke in strokes:
        if isinstance(stroke, Segment):
            placed.append(replace(stroke, start=moved(stroke.start), end=moved(stroke.end)))
            continue
        # The sheet's y runs down: angles change sign and the arc starts at its other end.
        turned_over = stroke.mapped(Similarity(scale / 2, flip=True))
        placed.append(replace(turned_over, centre=moved(stroke.centre)))
    return tuple(placed)


def make_view(
    place: Placement,
    strokes: tuple[Stroke, ...],
    depth: npt.NDArray[np.float32],
    outline: Outline,
    mm_per_pixel: float,
) -> View:
    """A view on the shared grid, its mask resampled, without colour yet.

    Args:
        place: the view's box in its plane.
        strokes: in mm of its plane.
        depth: (h, w) mask px inside the material, on the outline's grid.
        outline: gives the grid of ``depth``.
        mm_per_pixel: of the view's mask.
    """
    width = int(np.ceil((place.right[1] - place.right[0]) / mm_per_pixel)) + 2 * _MARGIN
    height = int(np.ceil((place.up[1] - place.up[0]) / mm_per_pixel)) + 2 * _MARGIN
    origin = (
        place.right[0] - _MARGIN * mm_per_pixel,
        place.up[1] + _MARGIN * mm_per_pixel,
    )
    corners = np.array([[0.5, 0.5], [width - 0.5, 0.5], [0.5, height - 0.5]])
    plane = np.array(origin) + corners * np.array([mm_per_pixel, -mm_per_pixel])
    sheet = place.to_sheet(plane)
    source = (sheet - np.array(outline.offset)) * outline.supersampling - 0.5
    affine = cv2.getAffineTransform((corners - 0.5).astype(np.float32), source.astype(np.float32))
    resampled = cv2.warpAffine(
        depth,
        affine,
        (width, height),
        flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP,
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=-1.0,
    )
    return View(
        place.role,
        place.box,
        strokes,
        resampled > 0,
        np.full((height, width, 3), 255, np.uint8),
        origin,
        mm_per_pixel,
    )
