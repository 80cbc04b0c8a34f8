"""Sheets of one view: a turned part by its diameters, a plate by its thickness.

What the view tells with these is a solid, whose view from beside is what a second view would have
shown.  It stands beside the first, so that all that follows has two; that it was not drawn is an
assumption.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from OCP.TopoDS import TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.drawing.brep import moved_to_origin, soundness
from gaussiancad_core.drawing.hlr import LineDrawing
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.drawing.strokes import Polyline, mapped
from gaussiancad_core.messages import Message
from gaussiancad_core.samples.modelling import cut, cylinder
from gaussiancad_core.sheet.notes.callouts import NoteKind
from gaussiancad_core.sheet.notes.finding import SheetNote
from gaussiancad_core.sheet.reading import ReadView
from gaussiancad_core.sheet.registration import placement, strokes_in_plane
from gaussiancad_core.sheet.scale.dimensions import Span
from gaussiancad_core.sheet.scale.find import SheetScale
from gaussiancad_core.sheet.scale.numbers import Sign
from gaussiancad_core.solid.profiles import Profile, cells_of, profile_of, thickened, turned
from gaussiancad_core.views import Arc, Linetype, Segment, Stroke

_ALIKE = 0.97
"""Share of the lines of a view that its mirror image has, if it is a turned part's."""

_NEAR_PX = 1.5
"""px within which lines are one."""

"""Radians from which an arc is a circle."""

_APART = 0.3
"""Distance of the second view from the first, as a share of the first's longer side."""


@dataclass(frozen=True, eq=False)
class Companion:
    """What a second view would have shown.

    Attributes:
        role: of that view.
        strokes: px of the sheet, where it would have stood.
        message: the assumption, in a sentence.
    """

    role: Role
    strokes: tuple[Stroke, ...]
    message: str


def companion(
    view: ReadView, scale: SheetScale, notes: Sequence[SheetNote], width: float
) -> Companion | None:
    """The second view of a part that one view tells; None where it does not.

    A turned part's view is alike on both sides of its axis, and a diameter is written at a width of
    it (ISO 129-1).  A plate has its thickness in a note.

    Args:
        view: the front view.
        scale: of the sheet, with its dimensions.
        notes: of the sheet.
        width: of the sheet, px.
    """
    if scale.mm_per_pixel is None:
        return None
    x0, y0, x1, y1 = view.box
    size = (x1 - x0, 1.0, y1 - y0)
    plane = placement(Role.FRONT, view.box, size)
    strokes = strokes_in_plane(view.strokes, plane)
    try:
        for axis in (Axis.X, Axis.Z):
            if _is_round(scale, axis) and _is_alike(strokes, size, axis):
                hatched = [shapely.Polygon(plane.to_plane(np.array(own))) for own in view.hatched]
                solid = _turned(strokes, size, axis, shapely.union_all(hatched))
                if solid is not None:
                    solid = _bored(solid, axis, (strokes, size), notes, scale.mm_per_pixel)
                    role = Role.RIGHT if axis is Axis.X else Role.TOP
                    return _beside(solid, role, view, width, _TURNED)
        thickness = next(
            (own.value_mm for own in notes if own.callout.kind is NoteKind.THICKNESS), None
        )
        if thickness:
            area = _profile(strokes, shapely.box(0.0, 0.0, size[0], size[2]), None)
            if area is not None:
                solid = thickened(area, thickness / scale.mm_per_pixel)
                return _beside(solid, Role.TOP, view, width, _PLATE)
    except KERNEL_FAILURES:
        return None
    return None


_TURNED = Message(
    "the sheet has one view, alike on both sides of its axis, with diameters: a turned part was "
    "assumed; if it is none, another view is needed",
    case="turned",
)
_PLATE = Message(
    "the sheet has one view and a thickness: that all of the part is as thick, and that what is "
    "drawn inside goes through, was assumed",
    case="plate",
)


def _is_round(scale: SheetScale, axis: Axis) -> bool:
    """Whether a diameter is written at a width across an axis of the view."""
    return any(
        own.sign is Sign.DIAMETER
        and isinstance(own.place, Span)
        and own.place.level is (axis is Axis.Z)
        for own in scale.dimensions
    )


def _is_alike(strokes: Sequence[Stroke], size: tuple[float, float, float], axis: Axis) -> bool:
    points = np.concatenate([own.sample(_NEAR_PX) for own in strokes])
    index = 1 if axis is Axis.X else 0
    images = points.copy()
    images[:, index] = (size[2] if axis is Axis.X else size[0]) - images[:, index]
    away, _ = cKDTree(points).query(images)
    return bool((away <= 2.0 * _NEAR_PX).mean() >= _ALIKE)


def _turned(
    strokes: Sequence[Stroke],
    size: tuple[float, float, float],
    axis: Axis,
    hatched: shapely.Geometry,
) -> TopoDS_Shape | None:
    """The solid of a profile in px, its axis through the origin."""
    wide, _, high = size
    middle = (high if axis is Axis.X else wide) / 2.0
    long = wide if axis is Axis.X else high
    halves = []
    for sign in (1.0, -1.0):
        moved = [_along_axis(own, axis, middle, sign) for own in strokes]
        areas = _mapped(hatched, axis, middle, sign)
        halves.append((areas.intersection(shapely.box(0.0, 0.0, long, middle)).area, moved, areas))
    # The half of a half section tells more.
    _, moved, areas = max(halves, key=lambda own: own[0])
    found = _profile(moved, shapely.box(0.0, 0.0, long, middle), areas)
    return None if found is None else turned(found, axis)


def _along_axis(stroke: Stroke, axis: Axis, middle: float, sign: float) -> Stroke:
    """A stroke by its place along the axis and its distance from it."""

    def place(point: tuple[float, float]) -> tuple[float, float]:
        along, away = point if axis is Axis.X else point[::-1]
        return along, sign * (away - middle)

    if isinstance(stroke, Segment):
        return replace(stroke, start=place(stroke.start), end=place(stroke.end))
    if isinstance(stroke, Arc):
        return _arc_through(
            [place(tuple(own)) for own in stroke.sample(stroke.length / 8.0)], stroke
        )
    return stroke


def _arc_through(points: Sequence[tuple[float, float]], stroke: Arc) -> Arc:
    """The image of an arc that was turned over or not, from points along it."""
    centre = _centre(points)
    ways = np.unwrap(np.arctan2(*(np.array(points) - centre).T[::-1]))
    low = float(min(ways[0], ways[-1]))
    return replace(stroke, centre=centre, start_angle=low % (2.0 * np.pi), sweep=stroke.sweep)


def _centre(points: Sequence[tuple[float, float]]) -> tuple[float, float]:
    own = np.array(points)
    fitted = np.linalg.lstsq(np.c_[own, np.ones(len(own))], (own**2).sum(axis=1), rcond=None)[0]
    return float(fitted[0] / 2.0), float(fitted[1] / 2.0)


def _mapped(area: shapely.Geometry, axis: Axis, middle: float, sign: float) -> shapely.Geometry:
    def place(points: np.ndarray) -> np.ndarray:
        along, away = (points[:, 0], points[:, 1]) if axis is Axis.X else points.T[::-1]
        return np.stack([along, sign * (away - middle)], axis=1)

    return shapely.transform(area, place)


def _profile(
    strokes: Sequence[Stroke], within: shapely.Geometry, hatched: shapely.Geometry | None
) -> Profile | None:
    """Material of cells: what is hatched; without hatching what visible lines enclose, less what
    hidden ones bound towards the axis."""
    kept = [own for own in strokes if isinstance(own, Segment | Arc)]
    hidden = [own for own in kept if own.linetype is Linetype.HIDDEN]
    visible = [own for own in kept if own.linetype is Linetype.VISIBLE]
    whole = shapely.union_all(
        [
            own
            for own in cells_of(visible, within, _NEAR_PX / 2.0)
            if not _is_outside(own, within, kept)
        ]
    )

    def is_material(point: tuple[float, float]) -> bool:
        if hatched is not None and not hatched.is_empty:
            return bool(shapely.contains_xy(hatched, *point))
        if not shapely.contains_xy(whole, *point):
            return False
        up = shapely.LineString([point, (point[0], within.bounds[3] + 1.0)])
        crossed = sum(shapely.LineString(own.sample(1.0)).crosses(up) for own in hidden)
        return crossed % 2 == 0

    return profile_of(kept, within, is_material, _NEAR_PX / 2.0)


def _is_outside(
    cell: shapely.Geometry, within: shapely.Geometry, strokes: Sequence[Stroke]
) -> bool:
    """Whether a cell reaches the border where no stroke is drawn, but at the axis."""
    x0, y0, x1, y1 = within.bounds
    far = shapely.LineString([(x0, y0), (x0, y1), (x1, y1), (x1, y0)])
    shared = cell.boundary.intersection(far.buffer(_NEAR_PX / 2.0))
    drawn = shapely.union_all([shapely.LineString(own.sample(1.0)) for own in strokes]).buffer(
        _NEAR_PX
    )
    return bool(shared.difference(drawn).length > 4.0 * _NEAR_PX)


def _bored(
    solid: TopoDS_Shape,
    axis: Axis,
    view: tuple[Sequence[Stroke], tuple[float, float, float]],
    notes: Sequence[SheetNote],
    mm_per_px: float,
) -> TopoDS_Shape:
    """With the bores that notes say to go through: across the axis where the view shows their
    circle, else along it.

    Args:
        solid: turned around an axis through the origin, px.
        axis: x or z.
        view: strokes and extents in px of its plane.
        notes: of the sheet.
        mm_per_px: scale.
    """
    strokes, size = view
    long = size[axis.value]
    shift = (0.0, size[2] / 2.0) if axis is Axis.X else (size[0] / 2.0, 0.0)
    for own in notes:
        kind = own.callout.kind in (NoteKind.DIAMETER, NoteKind.THREAD)
        if not (kind and own.callout.through and own.value_mm):
            continue
        radius = own.value_mm / mm_per_px / 2.0
        circles = [
            each
            for each in strokes
            if isinstance(each, Arc) and each.is_full and abs(each.radius - radius) <= _NEAR_PX
        ]
        for each in circles:
            at = each.centre[0] - shift[0], each.centre[1] - shift[1]
            solid = cut(solid, cylinder(Axis.Y, at, each.radius, -long, long))
        if not circles and own.callout.count == 1:
            solid = cut(solid, cylinder(axis, (0.0, 0.0), radius, -1.0, long + 1.0))
    return solid


def _beside(
    solid: TopoDS_Shape, role: Role, view: ReadView, width: float, message: str
) -> Companion | None:
    facts = soundness(solid)
    if not (facts.valid and facts.closed and facts.solids == 1):
        return None
    lines = LineDrawing(moved_to_origin(solid)).view(role)
    x0, y0, x1, y1 = view.box
    apart = _APART * max(x1 - x0, y1 - y0)
    if role is Role.RIGHT:
        left = x1 + apart
        if left + (y1 - y0) > width:
            left = max(x0 - apart - (y1 - y0), 1.0)
        offset = (left, y1)
    else:
        offset = (x0, y1 + apart + (x1 - x0))
    strokes = tuple(
        mapped(own, 1.0, offset, flip=True) for own in lines if not isinstance(own, Polyline)
    )
    return Companion(role, strokes, message)
