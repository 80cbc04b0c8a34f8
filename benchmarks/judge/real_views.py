"""How a sheet's reading lies on the true part: roles of views, their strokes, the scale.

The true part is drawn from its six sides.  Of the 24 ways to hold it the one counts under which the
read views show most of it, all at one scale.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import permutations, product
from typing import Any

import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.kernel.brep import moved_to_origin
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.readings.reading_schema import SheetReading, ViewEntry
from gaussiancad_core.readings.stroke_anchors import points_of
from gaussiancad_protocol.reading_kinds import StrokeKind

_NEAR_PX = 2.0
"""px within which points of lines are at a line."""

_NEAR_SHARE = 2e-3
"""The same, of the view's longer side: what is drawn is rounded."""

_SAME_SHAPE = 0.01
"""Share by which the scales of a view's width and height, and of two views, may differ."""

_SHOWN = 0.9
"""Share of a view's lines that the part has at least, if it is seen from there."""

_STEPS = 1500
"""Points over the longer side of the part."""

Floats = npt.NDArray[np.float64]
Turned = npt.NDArray[np.int64]
"""(3, 3) a proper rotation that maps axes to axes."""


@dataclass(frozen=True)
class Side:
    """Points along the lines of the part from one side, mm of its plane (right, up).

    Attributes:
        visible, hidden: edges.
        smooth: edges between tangent faces, which some draw.
    """

    visible: Floats
    hidden: Floats
    smooth: Floats


@dataclass(frozen=True)
class ViewFit:
    """How a read view lies on the part.

    Attributes:
        mm_per_px: by its box.
        visible, hidden: precision and recall of its lines; recall of hidden lines is None where the
            view shows none.
    """

    mm_per_px: float
    visible: tuple[float, float]
    hidden: tuple[float, float | None]


@dataclass(frozen=True)
class SheetFit:
    """How the views of a sheet lie on the part.

    Attributes:
        views: by role; those that are seen from elsewhere are left out.
        count: of the principal views that were read; sections are not asked, as the part has not
            their lines.
        mm_per_px: of those that are right.
    """

    views: dict[str, ViewFit]
    count: int
    mm_per_px: float | None

    @property
    def right(self) -> bool:
        """Whether there are views, and all have their roles."""
        return self.count > 0 and len(self.views) == self.count

    def strokes(self) -> tuple[float, float]:
        """The least precision and recall of visible lines."""
        pairs = [view.visible for view in self.views.values()]
        return min(pair[0] for pair in pairs), min(pair[1] for pair in pairs)


def fit_of(reading: SheetReading, part: TopoDS_Shape) -> SheetFit:
    """How a reading lies on the true part."""
    sides = _sides(moved_to_origin(part))
    views = {
        Role(view.role.value): view
        for view in reading.views
        if view.used and _is_principal(view) and not view.hatch
    }
    read = {role: _read(reading, view) for role, view in views.items()}
    best: tuple[float, SheetFit] = (-1.0, SheetFit({}, len(views), None))
    for turn in _turns():
        found = {}
        for role, lines in read.items():
            fit = _fitted(lines, _seen(sides, role, turn))
            if fit is not None:
                found[role.value] = fit
        common = _at_one_scale(found)
        score = sum(min(item.visible) + 1.0 for item in common.values())
        if score > best[0]:
            scales = [item.mm_per_px for item in common.values()]
            median = float(np.median(scales)) if scales else None
            best = score, SheetFit(common, len(views), median)
    return best[1]


def _is_principal(view: ViewEntry) -> bool:
    return view.role.value in {role.value for role in Role}


def _sides(part: TopoDS_Shape) -> dict[Role, Side]:
    plain = LineDrawing(part, LineOptions())
    smooth = LineDrawing(part, LineOptions(tangent_edges=True))
    found = {}
    for role in Role:
        strokes = plain.view(role)
        every = [item for item in smooth.view(role) if item.linetype is Linetype.VISIBLE]
        spread = (
            np.concatenate([stroke.sample(1e9) for stroke in strokes])
            if strokes
            else np.zeros((1, 2))
        )
        step = max(float(np.ptp(spread, axis=0).max()) / _STEPS, 1e-6)
        kinds = [
            [stroke for stroke in strokes if stroke.linetype is kind]
            for kind in (Linetype.VISIBLE, Linetype.HIDDEN)
        ]
        found[role] = Side(*(_points(kind, step) for kind in (*kinds, every)))
    return found


def _points(strokes: Any, step: float) -> Floats:  # noqa: ANN401
    return np.concatenate([np.empty((0, 2)), *(stroke.sample(step) for stroke in strokes)])


def _read(reading: SheetReading, view: ViewEntry) -> tuple[Floats, Floats]:
    """Points along visible and hidden strokes of a view, px with y up."""
    lines = []
    for kind in (StrokeKind.VISIBLE, StrokeKind.HIDDEN):
        outlines = [points_of(s) for s in reading.strokes if s.view == view.id and s.kind is kind]
        dense = [_denser(points) for points in outlines if len(points)]
        lines.append(np.concatenate([np.empty((0, 2)), *dense]) * [1.0, -1.0])
    return lines[0], lines[1]


def _denser(points: Floats) -> Floats:
    """The points of a chain evenly, one a px or so: long strokes count for their length."""
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], max(2, int(lengths[-1])))
    return np.stack([np.interp(at, lengths, axis) for axis in points.T], 1)


def _turns() -> Iterator[Turned]:
    for order in permutations(range(3)):
        for signs in product((1, -1), repeat=3):
            turn = np.zeros((3, 3), int)
            turn[range(3), order] = signs
            if round(np.linalg.det(turn)) == 1:
                yield turn


def _seen(sides: Mapping[Role, Side], role: Role, turn: Turned) -> Side:
    """The part as it is seen in a role when it is held another way."""
    frame = role.frame
    right, up, look = (turn.T @ np.array(item) for item in (frame.right, frame.up, frame.look))
    this_side = next(side for side in Role if np.array_equal(side.frame.look, look))
    axes = np.array([this_side.frame.right, this_side.frame.up])
    plane = np.stack([axes @ right, axes @ up], 1).astype(float)
    side = sides[this_side]
    return Side(side.visible @ plane, side.hidden @ plane, side.smooth @ plane)


def _fitted(read: tuple[Floats, Floats], side: Side) -> ViewFit | None:
    """How the lines of a view lie on those of a side; None if it is another side."""
    visible, hidden = read
    if not len(visible) or not len(side.visible):
        return None
    low, extent = visible.min(0), np.ptp(visible, axis=0)
    true_low, true = side.visible.min(0), np.ptp(side.visible, axis=0)
    if extent.min() <= 0.0 or true.min() <= 0.0:
        return None
    scales = true / extent
    near = _NEAR_PX + _NEAR_SHARE * float(extent.max())
    if abs(np.log(scales[0] / scales[1])) > _SAME_SHAPE + near / float(extent.min()):
        return None
    scale = float(true.max() / extent[int(np.argmax(true))])
    placed = [(item - true_low) / scale + low for item in (side.visible, side.hidden, side.smooth)]
    precision = _share(visible, np.concatenate([placed[0], placed[2]]), near)
    if precision < _SHOWN:
        return None
    recall = _share(placed[0], visible, near)
    drawn = None if not len(hidden) else _share(placed[1], np.concatenate([hidden, visible]), near)
    return ViewFit(
        scale, (precision, recall), (_share(hidden, np.concatenate(placed), near), drawn)
    )


def _share(points: Floats, others: Floats, near: float) -> float:
    if not len(points):
        return 1.0
    if not len(others):
        return 0.0
    return float((cKDTree(others).query(points)[0] <= near).mean())


def _at_one_scale(found: dict[str, ViewFit]) -> dict[str, ViewFit]:
    """The largest group of views that have one scale."""
    groups = [
        {
            role: other
            for role, other in found.items()
            if abs(np.log(other.mm_per_px / item.mm_per_px)) <= 2.0 * _SAME_SHAPE
        }
        for item in found.values()
    ]
    return max(groups, key=len, default={})
