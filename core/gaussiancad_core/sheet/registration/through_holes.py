"""Which blank regions of a view are through holes: the hidden lines of the other views tell.

The walls of a through hole show in each view beside as a line at either end of the hole's extent,
over the whole depth of the material that the views leave there.  Where a wider hole leads into it
(a counterbore), that hole's hidden lines cover the rest of the depth.  This is evidence, not
proof: rows of holes can lend each other their lines.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.sheet.votes import NEARLY_ALL

_SAMPLES = 2000
"""Places along the depth that are looked at."""


@dataclass(frozen=True)
class ViewEvidence:
    """What a view beside shows.

    Attributes:
        role: of the view.
        strokes: in px of its sheet, y down.
        box: (x0, y0, x1, y1) sheet px of the view.
        mask: (h, w) bool of its filled outline.
        mask_scale: mask px per sheet px.
        mask_offset: (x, y) sheet px of the mask's corner.
    """

    role: Role
    strokes: tuple[Stroke, ...]
    box: tuple[float, float, float, float]
    mask: npt.NDArray[np.bool_]
    mask_scale: float
    mask_offset: tuple[float, float]

    @cached_property
    def segments(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.bool_]]:
        """(n, 2, 2) ends of the straight strokes, and (n,) whether they are hidden."""
        straight = [stroke for stroke in self.strokes if isinstance(stroke, Segment)]
        ends = np.array([(item.start, item.end) for item in straight]).reshape(-1, 2, 2)
        return ends, np.array([item.linetype is Linetype.HIDDEN for item in straight], bool)


Extent = dict[Axis, tuple[float, float]]
"""Interval of a region on each axis of its view, as fractions 0..1 of the part's size."""


def is_through(
    role: Role, extent: Extent, around: list[Extent], others: list[ViewEvidence], tolerance: float
) -> bool:
    """Whether a region of a view is a through hole.

    Args:
        role: the view that shows the region.
        extent: of the region.
        around: extents of the interior regions around it, innermost first.
        others: the other views.
        tolerance: px by which lines may be off.
    """
    depth_axis = role.frame.look_axis[0]
    seen_from = [
        view
        for view in others
        if depth_axis in (view.role.frame.right_axis[0], view.role.frame.up_axis[0])
    ]
    if not seen_from:
        return False
    samples = np.linspace(0.0, 1.0, _SAMPLES)
    material = np.ones(_SAMPLES, bool)
    for view in seen_from:
        low, high = extent[_shared_axis(view.role, depth_axis)]
        material &= _wall_samples(view, depth_axis, (low + high) / 2, samples, tolerance).material
    if not material.any():
        return False
    hidden_somewhere = False
    for view in seen_from:
        shared = _shared_axis(view.role, depth_axis)
        for side in (0, 1):
            walls = _wall_samples(view, depth_axis, extent[shared][side], samples, tolerance)
            covered = walls.hidden | walls.visible
            hidden_somewhere |= bool(walls.hidden[material].mean() > 0.4)
            for outer in around:
                wider = _wall_samples(view, depth_axis, outer[shared][side], samples, tolerance)
                covered = covered | wider.hidden
            if covered[material].mean() < NEARLY_ALL:
                return False
    return hidden_somewhere


def _shared_axis(role: Role, depth_axis: Axis) -> Axis:
    axes = role.frame.right_axis[0], role.frame.up_axis[0]
    return axes[1] if axes[0] is depth_axis else axes[0]


@dataclass(frozen=True)
class _Walls:
    """(n,) bool samples along the depth in a view, at one position of the axis shared with the
    hole's view: material by the outline, and lines there."""

    material: npt.NDArray[np.bool_]
    hidden: npt.NDArray[np.bool_]
    visible: npt.NDArray[np.bool_]


def _wall_samples(
    view: ViewEvidence,
    depth_axis: Axis,
    fraction: float,
    samples: npt.NDArray[np.float64],
    tolerance: float,
) -> _Walls:
    """Material and lines in a view at fractions of the depth, at a fraction of the other axis."""
    frame = view.role.frame
    x0, y0, x1, y1 = view.box
    ends = {0: (x0, x1), 1: (y1, y0)}
    axes = (frame.right_axis, frame.up_axis)
    down_the_sheet = axes[1][0] is depth_axis
    number, other = (1, 0) if down_the_sheet else (0, 1)

    def placed(index: int, at: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        low, high = ends[index] if axes[index][1] > 0 else ends[index][::-1]
        return low + at * (high - low)

    depth = placed(number, samples)
    position = float(placed(other, np.array([fraction]))[0])
    level = np.full_like(depth, position)
    xs, ys = (level, depth) if down_the_sheet else (depth, level)
    hidden = np.zeros(len(depth), bool)
    visible = np.zeros(len(depth), bool)
    segments, are_hidden = view.segments
    across = 0 if down_the_sheet else 1
    near = (np.abs(segments[:, :, across] - position) <= tolerance).all(axis=1)
    along = segments[near, :, 1 - across]
    for low, high, is_hidden in zip(
        along.min(axis=1), along.max(axis=1), are_hidden[near], strict=True
    ):
        walls = hidden if is_hidden else visible
        walls |= (depth >= low - tolerance) & (depth <= high + tolerance)
    return _Walls(_material(view, xs, ys), hidden, visible)


def _material(
    view: ViewEvidence, xs: npt.NDArray[np.float64], ys: npt.NDArray[np.float64]
) -> npt.NDArray[np.bool_]:
    """Whether the view's outline covers sheet points."""
    columns = np.floor((xs - view.mask_offset[0]) * view.mask_scale).astype(int)
    rows = np.floor((ys - view.mask_offset[1]) * view.mask_scale).astype(int)
    height, width = view.mask.shape
    inside = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
    result = np.zeros(len(xs), bool)
    result[inside] = view.mask[rows[inside], columns[inside]]
    return result
