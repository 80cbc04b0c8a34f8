"""The strokes of one view: Hough shapes, cut by the ink under them, with exact ends.

The shapes with the most ink come first; every accepted stroke explains its ink, and a shape that
explains little that is new is dropped: a chord of a circle, or an arc that cuts a corner.  What no
line or circle explains (ellipses, free curves, small fillets) is traced as short segments.
"""

from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.runs import (
    InkField,
    Piece,
    Rhythm,
    Run,
    circle_runs,
    classify,
    ink_field,
    learn_rhythm,
    line_runs,
    runs_spans,
)
from gaussiancad_core.sheet.shapes import (
    Circle,
    Line,
    edge_map,
    find_circles,
    find_lines,
    following,
    line_support,
    radial_profile,
    refit_line,
)
from gaussiancad_core.sheet.tracing import trace_remainder
from gaussiancad_core.views import Arc, Linetype, Segment, Stroke

_MIN_NEW = 0.4
"""Share of a run's ink that no earlier stroke explains."""

_MIN_SAGITTA = 1.2
"""Height in px of the flattest arc that is told from a straight line, beyond half a stroke."""

_FULL = 2 * np.pi


@dataclass(frozen=True)
class Shape:
    """A line or circle with the runs of ink along it.

    Attributes:
        geometry: the fitted shape.
        runs: in order along it.
        support: px of its ink whose centre line it follows, in doubt less than its length.
    """

    geometry: Line | Circle
    runs: tuple[Run, ...]
    support: float


@dataclass(frozen=True)
class ViewShapes:
    """Shapes of one view before their linetypes are known.

    Attributes:
        sheet: the view's part of the sheet.
        field: its ink with directions.
        shapes: circles, then lines.
        offset: (x, y) px of the crop on the sheet.
    """

    sheet: CleanSheet
    field: InkField
    shapes: tuple[Shape, ...]
    offset: tuple[int, int]


def find_shapes(sheet: CleanSheet, box: tuple[float, float, float, float]) -> ViewShapes:
    """Lines and circles of the view inside a box of the sheet."""
    crop, offset = _crop(sheet, box)
    field = ink_field(crop)
    height, width = crop.ink.shape
    circles = find_circles(crop)
    shapes = [shape for circle in circles if (shape := _circle_shape(crop, field, circle))]
    for line in find_lines(crop, edge_map(crop)):
        along, _ = line.coordinates(
            np.array([[0, 0], [width, 0], [0, height], [width, height]], dtype=np.float64)
        )
        reach = float(along.min()), float(along.max())
        runs = line_runs(field, line, *reach)
        if runs:
            refitted = refit_line(crop, line, runs_spans(runs))
            runs = line_runs(field, refitted, *reach)
            support = line_support(crop, refitted, runs_spans(runs))
            shapes.append(Shape(refitted, tuple(runs), support))
    return ViewShapes(crop, field, tuple(shapes), offset)


def view_rhythm(views: list[ViewShapes], stroke_width: float) -> Rhythm:
    """The rhythm of dashes of a sheet, learnt from all its views."""
    series = [list(shape.runs) for view in views for shape in view.shapes]
    return learn_rhythm(series, stroke_width)


def classify_strokes(view: ViewShapes, rhythm: Rhythm) -> tuple[Stroke, ...]:
    """Visible and hidden strokes of a view in px of the sheet (y down, pixel centres at .5)."""
    explained = np.zeros(view.sheet.ink.shape, np.uint8)
    pieces: list[tuple[Line | Circle, Piece]] = []
    order = sorted(view.shapes, key=lambda shape: -shape.support)
    for shape in order:
        fresh = [run for run in shape.runs if _new_share(shape.geometry, run, explained) > _MIN_NEW]
        touches = [_touches(view.field, shape.geometry, run) for run in fresh]
        found = classify(fresh, rhythm, touches)
        if isinstance(shape.geometry, Circle):
            found = [piece for piece in found if _is_curved(shape.geometry, piece, view.sheet)]
            found = _closed(shape.geometry, found, rhythm)
        for piece in found:
            pieces.append((shape.geometry, piece))
            _explain(explained, shape.geometry, piece, view.sheet.stroke_width)
    ended = [
        (geometry, _end_at_junctions(geometry, piece, pieces, rhythm, view.sheet.stroke_width))
        for geometry, piece in pieces
    ]
    strokes = [_stroke(geometry, piece) for geometry, piece in ended]
    remainder = view.sheet.ink & (explained == 0)
    strokes += trace_remainder(remainder, view.sheet.stroke_width, rhythm.dash)
    shift = np.array(view.offset) + 0.5
    return tuple(_shifted(stroke, shift) for stroke in strokes if stroke.length > 1.5)


def _crop(
    sheet: CleanSheet, box: tuple[float, float, float, float]
) -> tuple[CleanSheet, tuple[int, int]]:
    margin = int(np.ceil(sheet.stroke_width)) + 6
    x0, y0 = max(0, int(box[0]) - margin), max(0, int(box[1]) - margin)
    x1, y1 = int(np.ceil(box[2])) + margin, int(np.ceil(box[3])) + margin
    part = replace(sheet, ink=sheet.ink[y0:y1, x0:x1], weight=sheet.weight[y0:y1, x0:x1].copy())
    return part, (x0, y0)


def _circle_shape(sheet: CleanSheet, field: InkField, circle: Circle) -> Shape | None:
    """The circle with its runs, if the ink follows it and not a tangent or a polygon."""
    angles, radii = radial_profile(sheet, circle, sheet.stroke_width / 2 + 1.5)
    residual = radii - circle.radius
    followed = angles[np.abs(residual) < 0.6] * circle.radius
    runs = []
    for run in circle_runs(field, circle):
        inside = _count_within(followed, run, _FULL * circle.radius)
        if inside > 0.75 * run.length:
            runs.append(run)
    longest = max((run.length for run in runs), default=0.0)
    covered = sum(run.length for run in runs) / (_FULL * circle.radius)
    bowed = longest**2 / (8 * circle.radius) > _MIN_SAGITTA + sheet.stroke_width / 2
    if covered < 0.45 and not (bowed and longest > 6):
        return None
    return Shape(circle, tuple(runs), following(residual))


def _count_within(positions: npt.NDArray[np.float64], run: Run, around: float) -> int:
    relative = (positions - run.start) % around
    return int((relative <= run.length).sum())


def _is_curved(circle: Circle, piece: Piece, sheet: CleanSheet) -> bool:
    length = piece.end - piece.start
    sagitta = length**2 / (8 * circle.radius)
    return sagitta > _MIN_SAGITTA + sheet.stroke_width / 2 or length > np.pi * circle.radius


def _closed(circle: Circle, pieces: list[Piece], rhythm: Rhythm) -> list[Piece]:
    """Make a piece that leaves only a dash's gap open the full circle."""
    around = _FULL * circle.radius
    if len(pieces) == 1:
        piece = pieces[0]
        slack = 2.5 * rhythm.gap + 1.0 if piece.linetype is Linetype.HIDDEN else 6.0
        if around - (piece.end - piece.start) <= slack:
            return [replace(piece, end=piece.start + around)]
    elif len(pieces) == 2 and pieces[0].linetype is pieces[1].linetype is Linetype.HIDDEN:
        # One dashed circle that was cut at angle 0.
        first, last = pieces
        if first.start + around - last.end <= 2.5 * rhythm.gap + 1.0:
            return [replace(last, end=first.end + around)]
    return pieces


def _points(geometry: Line | Circle, start: float, end: float) -> npt.NDArray[np.float64]:
    """(n, 2) px about one px apart along a shape."""
    along = np.linspace(start, end, max(2, int(np.ceil(end - start)) + 1))
    if isinstance(geometry, Line):
        return np.array(geometry.point) + along[:, None] * np.array(geometry.direction)
    angles = along / geometry.radius
    radial = np.stack([np.cos(angles), np.sin(angles)], 1)
    return np.array(geometry.centre) + geometry.radius * radial


def _new_share(geometry: Line | Circle, run: Run, explained: npt.NDArray[np.uint8]) -> float:
    points = np.rint(_points(geometry, run.start, run.end)).astype(int)
    height, width = explained.shape
    xs, ys = np.clip(points[:, 0], 0, width - 1), np.clip(points[:, 1], 0, height - 1)
    return float((explained[ys, xs] == 0).mean())


def _explain(
    explained: npt.NDArray[np.uint8], geometry: Line | Circle, piece: Piece, stroke_width: float
) -> None:
    """Mark the ink of a piece, a little wider and longer than the stroke."""
    reach = stroke_width / 2
    points = _points(geometry, piece.start - reach, piece.end + reach)
    path = np.rint(points * 8).astype(np.int32)
    cv2.polylines(explained, [path], False, 1, int(np.ceil(stroke_width)) + 2, shift=3)


def _touches(field: InkField, geometry: Line | Circle, run: Run) -> tuple[bool, bool]:
    """Whether the start and the end of a run lie on another stroke: there is ink beside it."""
    half = field.stroke_width / 2
    beside = half + 2.0

    def touch(position: float, outward: float) -> bool:
        for along in (position - outward * half, position, position + outward * half):
            here, ahead = _points(geometry, along, along + 1.0)[[0, -1]]
            tangent = (ahead - here) / max(float(np.hypot(*(ahead - here))), 1e-9)
            normal = np.array([-tangent[1], tangent[0]])
            for side in (beside, -beside):
                x, y = np.rint(here + side * normal).astype(int)
                inside = 0 <= y < field.weight.shape[0] and 0 <= x < field.weight.shape[1]
                if inside and field.weight[y, x] > 0.45:
                    return True
        return False

    return touch(run.start, -1.0), touch(run.end, 1.0)


def _end_at_junctions(
    geometry: Line | Circle,
    piece: Piece,
    pieces: list[tuple[Line | Circle, Piece]],
    rhythm: Rhythm,
    stroke_width: float,
) -> Piece:
    """Move the ends of a piece to the nearest crossing with another stroke."""
    if isinstance(geometry, Circle) and piece.end - piece.start >= _FULL * geometry.radius - 1e-6:
        return piece
    crossings: list[Crossing] = []
    for other, stretch in pieces:
        if other is not geometry:
            crossings += _crossings(geometry, piece, other, stretch, stroke_width)
    outward = 1.8 if piece.linetype is Linetype.VISIBLE else 1.8 * rhythm.gap + 3.0
    start = -_nearest([(-at, reach) for at, reach in crossings], -piece.start, outward)
    end = _nearest(crossings, piece.end, outward)
    return replace(piece, start=start, end=end) if end - start > 1.0 else piece


Crossing = tuple[float, float]
"""Position along a shape where another meets it, and how far their common ink reaches from it."""


def _nearest(crossings: list[Crossing], position: float, outward: float) -> float:
    """The crossing at which a piece that was seen to end at ``position`` really ends."""
    near = [at for at, reach in crossings if -reach - 1.8 <= at - position <= outward]
    return min(near, key=lambda at: abs(at - position), default=position)


def _crossings(
    geometry: Line | Circle, piece: Piece, other: Line | Circle, stretch: Piece, stroke_width: float
) -> list[Crossing]:
    """Where along ``geometry`` a stretch of another shape meets it."""
    half = stroke_width / 2
    reach = half
    if isinstance(geometry, Line) and isinstance(other, Line):
        points = _line_line(geometry, other)
        # Strokes that meet at a flat angle share their ink over a longer way; runs are seen up to
        # 1 px beside the ink.
        da, db = np.array(geometry.direction), np.array(other.direction)
        sine = max(abs(da[0] * db[1] - da[1] * db[0]), 0.05)
        reach = min((half + 1.0) / sine - 1.0, 8.0 * half)
    elif isinstance(geometry, Line) and isinstance(other, Circle):
        points = _line_circle(geometry, other)
        reach = _shared_with_tangent(points, other, half)
    elif isinstance(geometry, Circle) and isinstance(other, Line):
        points = _line_circle(other, geometry)
        reach = _shared_with_tangent(points, geometry, half)
    else:
        return []
    slack = max(stroke_width, reach) + 2.0
    return [
        (_position(geometry, point, piece), reach)
        for point in points
        if stretch.start - slack <= _position(other, point, stretch) <= stretch.end + slack
    ]


def _shared_with_tangent(
    points: list[npt.NDArray[np.float64]], circle: Circle, half: float
) -> float:
    """How far from a junction a line and a circle share their ink: long if they are tangent."""
    return float(np.sqrt(2.0 * circle.radius * (half + 1.0))) if len(points) == 1 else half


def _position(geometry: Line | Circle, point: npt.NDArray[np.float64], piece: Piece) -> float:
    """Position of a point along a shape; on a circle the turn nearest to the piece's middle."""
    if isinstance(geometry, Line):
        return float(geometry.coordinates(point[None])[0][0])
    offset = point - np.array(geometry.centre)
    around = _FULL * geometry.radius
    along = float(np.arctan2(offset[1], offset[0])) * geometry.radius
    middle = (piece.start + piece.end) / 2
    return along + around * round((middle - along) / around)


def _line_line(a: Line, b: Line) -> list[npt.NDArray[np.float64]]:
    da, db = np.array(a.direction), np.array(b.direction)
    cross = da[0] * db[1] - da[1] * db[0]
    if abs(cross) < 0.05:
        return []
    offset = np.array(b.point) - np.array(a.point)
    along = (offset[0] * db[1] - offset[1] * db[0]) / cross
    return [np.array(a.point) + along * da]


def _line_circle(line: Line, circle: Circle) -> list[npt.NDArray[np.float64]]:
    along, across = line.coordinates(np.array([circle.centre]))
    distance = abs(float(across[0]))
    if distance > circle.radius + 1.2:
        return []
    half = np.sqrt(max(circle.radius**2 - distance**2, 0.0))
    # Within 1.2 px a line is tangent: one junction, below the centre.
    halves = (0.0,) if abs(distance - circle.radius) < 1.2 else (-half, half)
    return [np.array(line.at(float(along[0]) + h)) for h in halves]


def _stroke(geometry: Line | Circle, piece: Piece) -> Stroke:
    if isinstance(geometry, Line):
        return Segment(
            geometry.at(piece.start), geometry.at(piece.end), piece.linetype, piece.confidence
        )
    sweep = min((piece.end - piece.start) / geometry.radius, _FULL)
    start = (piece.start / geometry.radius) % _FULL
    return Arc(geometry.centre, geometry.radius, start, sweep, piece.linetype, piece.confidence)


def _shifted(stroke: Stroke, shift: npt.NDArray[np.float64]) -> Stroke:
    def moved(point: tuple[float, float]) -> tuple[float, float]:
        return float(point[0] + shift[0]), float(point[1] + shift[1])

    if isinstance(stroke, Segment):
        return replace(stroke, start=moved(stroke.start), end=moved(stroke.end))
    return replace(stroke, centre=moved(stroke.centre), radius=float(stroke.radius))
