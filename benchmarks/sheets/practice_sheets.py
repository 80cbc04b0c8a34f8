"""Sheets as practice draws them: no hidden lines; sections with traces, notes, few views.

Lines are those of the engine's own removal of hidden lines; cuts, places, texts and pens are not.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from random import Random

import numpy as np
import shapely
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut
from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.practice_parts import Hole, Part
from benchmarks.sheets.practice_pdf import Page, Pen, Point, arrow
from gaussiancad_core.kernel.brep import bounding_box, tessellate
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.views import Linetype, Segment
from sample_parts.modelling import box

_WIDE, _NARROW = 0.5, 0.18
_VISIBLE, _THIN = Pen(_WIDE), Pen(_NARROW)
_CENTRE = Pen(_NARROW, (6.0, 1.2, 1.2, 1.2))
_TRACE = Pen(_WIDE, (8.0, 1.5, 1.5, 1.5))

_TEXT, _HEAD, _GAP = 3.5, 3.0, 34.0
"""mm of the sheet: capitals, arrowheads, distance between views."""

_NOTE = 60.0
"""mm for notes at the right."""

_PITCH = 3.0
"""mm between lines of hatching."""

_SAME = 1e-6


class Practice(Enum):
    """How a part is drawn."""

    PLACE = "section-in-place"
    BESIDE = "section-beside"
    HALF = "half-section"
    OFFSET = "offset-section"
    NOTES = "three-views-notes"
    TWO = "two-views-notes"
    ONE = "one-view"

    def draws(self, part: Part) -> bool:
        """Whether a draughtsman would draw a part so."""
        if self is Practice.OFFSET:
            return bool(part.steps)
        if self is Practice.HALF:
            return part.symmetric
        if self is Practice.ONE:
            return bool(part.diameters) and all(hole.through for hole in part.holes)
        if self is Practice.NOTES:
            return part.open
        if self is Practice.TWO:
            along = Axis.Y if part.diameters else Axis.X
            return part.open and not any(hole.axis is along for hole in part.holes)
        return True


@dataclass(frozen=True)
class _View:
    """A view on the sheet.

    Attributes:
        role: its direction.
        strokes: visible lines, mm of its plane.
        at: place of the plane's origin on the sheet.
        hatched: cut material; None where nothing is cut.
        label: letter of a section.
    """

    role: Role
    strokes: Sequence[DrawnStroke]
    at: Point = (0.0, 0.0)
    hatched: shapely.Geometry | None = None
    label: str = ""


def write_sheet(part: Part, how: Practice, projection: Projection, seed: int, path: Path) -> None:
    """The PDF sheet of a part at full size."""
    low, high = bounding_box(part.shape)
    wide, deep, tall = (high - low).tolist()
    lot = Random(f"{how.value} {seed}")
    front = _front(part, how)
    plain = {
        role: _View(role, _visible(part.shape, role))
        for role in _roles(part, how)
        if role is not Role.FRONT
    }
    sign = 1.0 if projection is Projection.THIRD else -1.0
    across, up = 0.5 * (wide + deep) + _GAP, 0.5 * (tall + deep) + _GAP
    centre = np.array([0.0, 0.0])
    places = {Role.FRONT: (0, 0), Role.TOP: (0, sign * up), Role.RIGHT: (sign * across, 0)}
    views = [front, *plain.values()]
    drawn = [
        _placed(this_view, centre + places[this_view.role], (wide, deep, tall))
        for this_view in views
    ]
    if how is Practice.BESIDE:
        whole = _View(Role.FRONT, _visible(part.shape, Role.FRONT))
        drawn[0] = _placed(whole, centre, (wide, deep, tall))
        aside = max(0.0, sign) * deep + _GAP + wide + (_GAP if sign > 0 else 0.0)
        drawn.append(_placed(front, centre + np.array([aside, 0.0]), (wide, deep, tall)))
    drawn = _moved_in(drawn, (wide, deep, tall))
    page = Page(*drawn[1])
    for view in drawn[0]:
        _draw(page, view)
    _tell(page, drawn[0], part, how, lot)
    page.write(path)


def _roles(part: Part, how: Practice) -> tuple[Role, ...]:
    if how is Practice.ONE:
        return (Role.FRONT,)
    if how in (Practice.TWO, Practice.HALF) and part.diameters:
        return (Role.FRONT, Role.RIGHT)
    if how in (Practice.TWO, Practice.HALF):
        return (Role.FRONT, Role.TOP)
    return (Role.FRONT, Role.TOP, Role.RIGHT)


def _visible(shape: TopoDS_Shape, role: Role) -> list[DrawnStroke]:
    return [item for item in LineDrawing(shape).view(role) if item.linetype is Linetype.VISIBLE]


def _front(part: Part, how: Practice) -> _View:
    """The front view, cut where it is."""
    wide = float(bounding_box(part.shape)[1][0])
    if how in (Practice.PLACE, Practice.BESIDE):
        return _cut(part.shape, [(-1.0, wide + 1.0, part.plane)])
    if how is Practice.HALF:
        return _cut(part.shape, [(wide / 2.0, wide + 1.0, part.plane)])
    if how is Practice.OFFSET:
        ends = [x for x, _ in part.steps[1:]] + [wide + 1.0]
        stretches = [
            (x if x else -1.0, end, y) for (x, y), end in zip(part.steps, ends, strict=True)
        ]
        return _cut(part.shape, stretches)
    return _View(Role.FRONT, _visible(part.shape, Role.FRONT))


def _cut(shape: TopoDS_Shape, stretches: Sequence[tuple[float, float, float]]) -> _View:
    """A front view cut in stretches (x from, x to, y of the plane)."""
    top = float(bounding_box(shape)[1][2]) + 1.0
    left, areas = shape, shapely.Polygon()
    for low, high, at in stretches:
        left = BRepAlgoAPI_Cut(left, box((low, -1.0, -1.0), (high, at, top))).Shape()
        slab = box((low, at, -1.0), (high, at + 1e-3, top))
        points, triangles = tessellate(BRepAlgoAPI_Common(shape, slab).Shape(), 1e-3)
        faces = [
            points[triangle][:, [0, 2]]
            for triangle in triangles
            if np.ptp(points[triangle][:, 1]) < _SAME
        ]
        areas = areas.union(shapely.union_all([shapely.Polygon(face) for face in faces]))
    strokes = _visible(left, Role.FRONT)
    whole = {_key(item) for item in _visible(shape, Role.FRONT)}
    borders = [low for low, _, _ in stretches[1:]]
    if stretches[0][0] > 0.0:
        borders.append(stretches[0][0])
    kept = [stroke for stroke in strokes if not _on(stroke, borders) or _key(stroke) in whole]
    return _View(Role.FRONT, kept, hatched=areas.simplify(1e-3), label="A")


def _on(stroke: DrawnStroke, places: Sequence[float]) -> bool:
    ends = (stroke.start[0], stroke.end[0]) if isinstance(stroke, Segment) else ()
    return bool(ends) and any(max(abs(x - at) for x in ends) < _SAME for at in places)


def _key(stroke: DrawnStroke) -> object:
    if not isinstance(stroke, Segment):
        return stroke
    return tuple(
        sorted(tuple(round(item, 4) for item in end) for end in (stroke.start, stroke.end))
    )


def _placed(view: _View, middle: np.ndarray, size: tuple[float, float, float]) -> _View:
    x0, y0, x1, y1 = _extent(view.role, size)
    at = (float(middle[0]) - (x0 + x1) / 2.0, float(middle[1]) - (y0 + y1) / 2.0)
    return _View(view.role, view.strokes, at, view.hatched, view.label)


def _extent(role: Role, size: tuple[float, float, float]) -> tuple[float, float, float, float]:
    (right, rs), (up, us) = role.frame.right_axis, role.frame.up_axis
    xs = sorted((0.0, rs * size[right.value]))
    ys = sorted((0.0, us * size[up.value]))
    return xs[0], ys[0], xs[1], ys[1]


def _box(view: _View, size: tuple[float, float, float]) -> tuple[float, float, float, float]:
    x0, y0, x1, y1 = _extent(view.role, size)
    (x, y) = view.at
    return x0 + x, y0 + y, x1 + x, y1 + y


def _moved_in(
    views: Sequence[_View], size: tuple[float, float, float]
) -> tuple[list[_View], Point]:
    """The views on a sheet with margins, and the sheet's width and height."""
    boxes = np.array([_box(view, size) for view in views])
    margin = 1.6 * _GAP
    low, high = boxes[:, :2].min(axis=0) - margin, boxes[:, 2:].max(axis=0) + margin
    high[0] += _NOTE
    moved = [
        _View(view.role, view.strokes, tuple((np.array(view.at) - low).tolist()), view.hatched,
              view.label)
        for view in views
    ]  # fmt: skip
    return moved, tuple((high - low).tolist())


def _draw(page: Page, view: _View) -> None:
    page.strokes(view.strokes, view.at, 1.0, _VISIBLE)
    if view.hatched is None or view.hatched.is_empty:
        return
    a0, b0, a1, b1 = view.hatched.bounds
    reach = (a1 - a0) + (b1 - b0)
    for shift in np.arange(_PITCH / 2.0, reach, _PITCH):
        line = shapely.LineString([(a0 + shift, b0), (a0 + shift - reach, b0 + reach)])
        for piece in shapely.get_parts(shapely.intersection(line, view.hatched)):
            if piece.geom_type == "LineString" and piece.length > 0.2:
                ends = [(x + view.at[0], y + view.at[1]) for x, y in piece.coords]
                page.line(ends[0], ends[-1], _THIN)


def _tell(page: Page, views: Sequence[_View], part: Part, how: Practice, lot: Random) -> None:
    """Dimensions, notes, titles and traces."""
    low, high = bounding_box(part.shape)
    size = tuple((high - low).tolist())
    by_role = {this_view.role: this_view for this_view in reversed(views)}
    _extents(page, by_role, size)
    front = next((this_view for this_view in views if this_view.hatched is not None), None)
    if front is not None and how is not Practice.HALF:
        x0, y0, x1, _ = _box(front, size)
        words = lot.choice(("A-A", "SECTION A-A"))
        page.text(((x0 + x1) / 2.0 - 8.0, y0 - 24.0), words, 5.0)
        _trace(page, by_role[Role.TOP], part, how, size)
    stated = _untold(part, how)
    for role, view in by_role.items():
        if view.hatched is None:
            _notes(
                page, view, [item for item in stated if item.axis is role.frame.look_axis[0]], size
            )
    if front is not None and how is Practice.HALF:
        x0, y0, x1, y1 = _box(front, size)
        page.line(((x0 + x1) / 2.0, y0 - 4.0), ((x0 + x1) / 2.0, y1 + 4.0), _CENTRE)
    if how is Practice.ONE:
        _diameters(page, by_role[Role.FRONT], part, size)


def _untold(part: Part, how: Practice) -> list[Hole]:
    """Holes of the kinds of which no section goes through some."""
    if how in (Practice.NOTES, Practice.TWO, Practice.ONE):
        return list(part.holes)
    planes = [y for _, y in part.steps] if how is Practice.OFFSET else [part.plane]
    kinds = {
        (hole.axis, note_of(hole))
        for hole in part.holes
        if hole.axis is Axis.Y
        or not any(abs(_y_of(hole) - at) < hole.diameter / 2.0 for at in planes)
    }
    return [hole for hole in part.holes if (hole.axis, note_of(hole)) in kinds]


def _y_of(hole: Hole) -> float:
    return hole.centre[0] if hole.axis is Axis.X else hole.centre[1]


def _extents(page: Page, views: dict[Role, _View], size: tuple[float, float, float]) -> None:
    """The three lengths of the part, as dimensions."""
    done: set[Axis] = set()
    for role, view in views.items():
        x0, y0, x1, y1 = _box(view, size)
        if role.frame.right_axis[0] not in done:
            done.add(role.frame.right_axis[0])
            _dimension(page, (x0, y0), (x1, y0), 12.0, f"{x1 - x0:g}")
        if role.frame.up_axis[0] not in done:
            done.add(role.frame.up_axis[0])
            _dimension(page, (x0, y0), (x0, y1), 12.0, f"{y1 - y0:g}")


def _dimension(page: Page, start: Point, end: Point, aside: float, text: str) -> None:
    """A dimension below a level line, or to the left of an upright one."""
    level = abs(end[0] - start[0]) > abs(end[1] - start[1])
    shift = (0.0, -aside) if level else (-aside, 0.0)
    ends = []
    for point in (start, end):
        far = (point[0] + shift[0], point[1] + shift[1])
        near = (point[0] + shift[0] / 10.0, point[1] + shift[1] / 10.0)
        over = (point[0] + shift[0] * 1.15, point[1] + shift[1] * 1.15)
        page.line(near, over, _THIN)
        ends.append(far)
    page.line(ends[0], ends[1], _THIN)
    arrow(page, ends[0], ends[1], _HEAD)
    arrow(page, ends[1], ends[0], _HEAD)
    wide = 0.78 * _TEXT * len(text)
    x, y = (ends[0][0] + ends[1][0]) / 2.0, (ends[0][1] + ends[1][1]) / 2.0
    if level:
        page.text((x - wide / 2.0, y + 0.8), text, _TEXT)
    else:
        page.text((x - 0.8, y - wide / 2.0), text, _TEXT, upright=True)


def _trace(
    page: Page, view: _View, part: Part, how: Practice, size: tuple[float, float, float]
) -> None:
    """Where the front view is cut, in the plan; the arrows look to the rear."""
    x0, _, x1, _ = _box(view, size)
    out = 6.0
    steps = part.steps if how is Practice.OFFSET else ((0.0, part.plane),)
    xs = [x0 - out, *(view.at[0] + x for x, _ in steps[1:]), x1 + out]
    points: list[Point] = []
    for index, (_, y) in enumerate(steps):
        level = view.at[1] + y
        points += [(xs[index], level), (xs[index + 1], level)]
    page.path(points, _TRACE)
    for (x, y), side in ((points[0], -1.0), (points[-1], 1.0)):
        tip = (x, y + 9.0)
        page.line((x, y), tip, _THIN)
        arrow(page, tip, (x, y), 4.0)
        page.text((x + side * 3.0 - (1.5 if side > 0 else 3.5), tip[1] - 1.0), "A", 5.0)


def _notes(
    page: Page, view: _View, holes: Sequence[Hole], size: tuple[float, float, float]
) -> None:
    """A note for each kind of hole, on a leader to the one that is nearest above."""
    kinds: dict[str, list[Hole]] = {}
    for this_hole in holes:
        kinds.setdefault(note_of(this_hole), []).append(this_hole)
    _, _, x1, y1 = _box(view, size)
    rows = [(y1 + 8.0 + 7.0 * number) for number in range(len(kinds))]
    for (text, item), row in zip(kinds.items(), rows, strict=True):
        centres = [_centre(view, hole) for hole in item]
        place = max(range(len(item)), key=lambda index: centres[index][0])
        x, y = centres[place]
        radius = item[place].diameter / 2.0
        elbow = (x1 + 6.0, row)
        far = np.hypot(elbow[0] - x, elbow[1] - y)
        tip = (x + radius * (elbow[0] - x) / far, y + radius * (elbow[1] - y) / far)
        words = f"{len(item)}x {text}" if len(item) > 1 else text
        page.line(elbow, tip, _THIN)
        page.line(elbow, (elbow[0] + 0.75 * _TEXT * len(words), row), _THIN)
        arrow(page, tip, elbow, _HEAD)
        page.text((elbow[0] + 1.0, row + 0.8), words, _TEXT)


def _centre(view: _View, hole: Hole) -> Point:
    place = [0.0, 0.0, 0.0]
    others = [axis for axis in Axis if axis is not hole.axis]
    for axis, value in zip(others, hole.centre, strict=True):
        place[axis.value] = value
    right, up = (np.array(item) for item in (view.role.frame.right, view.role.frame.up))
    return view.at[0] + float(right @ place), view.at[1] + float(up @ place)


def note_of(hole: Hole) -> str:
    """What a note says of a hole."""
    depth = abs(hole.face - hole.end)
    said = (
        f"\u00d8{hole.diameter:g} THRU"
        if hole.through
        else (f"\u00d8{hole.diameter:g} DEPTH {depth:g}")
    )
    if hole.bore is not None:
        said += f" CBORE \u00d8{hole.bore[0]:g} DEPTH {hole.bore[1]:g}"
    return said


def _diameters(page: Page, view: _View, part: Part, size: tuple[float, float, float]) -> None:
    """Diameters and shoulders of a turned part in its only view."""
    x0, y0, x1, y1 = _box(view, size)
    middle = (y0 + y1) / 2.0
    page.line((x0 - 4.0, middle), (x1 + 4.0, middle), _CENTRE)
    for hole in part.holes:
        elbow = (x1 + 12.0, y1 + 8.0)
        arrow(page, (x1, middle), elbow, _HEAD)
        page.line((x1, middle), elbow, _THIN)
        page.text((elbow[0] + 1.0, elbow[1]), note_of(hole), _TEXT)
    for number, (start, end, diameter) in enumerate(part.diameters):
        if diameter == max(item for _, _, item in part.diameters):
            continue
        at = x0 + (start + end) / 2.0
        ends = [(at, middle - diameter / 2.0), (at, middle + diameter / 2.0)]
        page.line(*ends, _THIN)
        arrow(page, ends[0], ends[1], _HEAD)
        arrow(page, ends[1], ends[0], _HEAD)
        page.text((at - 0.8, middle + 1.0), f"\u00d8{diameter:g}", _TEXT, upright=True)
        if number:
            _dimension(page, (x0, y0), (x0 + start, y0), 12.0 + 8.0 * number, f"{start:g}")
