"""Where strokes end: at the crossings with others, not where their ink was seen to end.

The ink of a stroke ends half a stroke beyond or before the place that is meant, merges with a
tangent's, or goes on in the first dash of a hidden line.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import sqrt

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Circle, ClosedCurve, Line, WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import ONE_DASH
from gaussiancad_core.sheet.picture_noise import ONE_PLACE, SEEN_BEYOND, TOUCHING
from gaussiancad_core.sheet.tracing.corner_stubs import Placed, without_stubs
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm

FULL_TURN = 2 * np.pi

_UNSEEN = 1.3
"""Share of the ink that a hidden piece has in common with another in which its dashes get lost."""

_ROUNDS = 3
"""How often strokes are ended where the others were seen, or last found, to end."""

_BLANK_END = 1.2
"""Stroke widths of a last dash that is too short to be seen, which a gap goes before."""

_CORNER = 2.0
"""Stroke widths by which a hidden piece ends rather in a corner than in a stroke that runs past."""


@dataclass(frozen=True)
class Crossing:
    """Where along a shape another meets it.

    Attributes:
        at: position, px.
        reach: px along the shape over which they share their ink, from there.
        lead: px by which it is preferred: the other ends there, too.
    """

    at: float
    reach: float
    lead: float = 0.0


def ended_at_junctions(
    pieces: Sequence[Placed], rhythm: Rhythm, stroke_width: float
) -> list[Placed]:
    """The pieces with their ends at the nearest crossings with strokes on other shapes.

    Pieces of one shape follow each other in the order of their positions.  Those of one linetype
    that end at one crossing become one.
    """
    # A corner is known once both strokes have been drawn out to it.
    ended = pieces
    for _ in range(_ROUNDS):
        before, ended = ended, _ended(pieces, ended, rhythm, stroke_width)
        if ended == before:
            break
    return without_stubs(ended, stroke_width)


def _ended(
    pieces: Sequence[Placed], placed: Sequence[Placed], rhythm: Rhythm, stroke_width: float
) -> list[Placed]:
    moved: list[Placed] = []
    for geometry in dict.fromkeys(geometry for geometry, _ in pieces):
        stretches = [piece for other, piece in pieces if other == geometry]
        others = [(other, piece) for other, piece in placed if other != geometry]
        ended = []
        crossings: list[Crossing] = []
        for piece in stretches:
            if is_full_circle(geometry, piece):
                ended.append(piece)
                continue
            met = [
                (other, stretch, crossing)
                for other, stretch in others
                for crossing in crossings_with(
                    geometry,
                    piece,
                    other,
                    stretch,
                    stroke_width,
                    blank=_blank_end(piece, stretch, rhythm, stroke_width),
                )
            ]
            crossings = [pair[2] for pair in met if not _is_beyond(geometry, piece, pair, met)]
            ended.append(_end_at(piece, crossings, rhythm))
            ended[-2:] = _parted(ended[-2:], crossings, rhythm)
        if len(ended) > 1 and np.isfinite(geometry.around):
            # On a curve the last piece is followed by the first.
            last, first = _parted([ended[-1], _moved(ended[0], geometry.around)], crossings, rhythm)
            ended[-1], ended[0] = last, _moved(first, -geometry.around)
        moved += [(geometry, piece) for piece in _joined(ended)]
    return moved


_Met = tuple[WholeCurve, Piece, Crossing]
"""What a piece meets, and where."""


def _is_beyond(geometry: WholeCurve, piece: Piece, pair: _Met, met: Sequence[_Met]) -> bool:
    """Whether another line would be met just beyond a visible one that ends them both.

    Where two lines meet a third one at flat angles, a few px from each other, all their ink is its.
    A hidden line's end may lie in a gap before both.
    """
    other, stretch, crossing = pair
    if not isinstance(geometry, Line) or not isinstance(other, Line):
        return False
    way = 1.0 if crossing.at > (piece.start + piece.end) / 2.0 else -1.0
    seen = piece.end if way > 0.0 else piece.start
    visible = piece.linetype is Linetype.VISIBLE
    if visible and abs(crossing.at - seen) > crossing.reach + SEEN_BEYOND:
        return False
    tip = geometry.at(crossing.at)
    middles = [
        line.at((this_piece.start + this_piece.end) / 2.0)
        for line, this_piece in ((geometry, piece), (other, stretch))
    ]
    for third, limits, first in met:
        before = way * (crossing.at - first.at)
        if (
            not isinstance(third, Line)
            or limits.linetype is not Linetype.VISIBLE
            or not 0.0 < before <= first.reach + SEEN_BEYOND
        ):
            continue
        along, across = third.coordinates(np.array([tip, *middles]))
        if (across[0] * across[1:] >= 0.0).any():
            continue
        feet = along[0] + (along[1:] - along[0]) * across[0] / (across[0] - across[1:])
        ends_both = (feet > limits.start).all() and (feet < limits.end).all()
        # Beyond a corner the ink of its other line goes on.
        off, off_tip = (abs(way * (seen - place.at) - place.reach) for place in (first, crossing))
        if ends_both and off < off_tip:
            return True
    return False


def _blank_end(piece: Piece, stretch: Piece, rhythm: Rhythm, stroke_width: float) -> float:
    """px by which the end of a hidden stretch may not be seen where another hidden one ends: many
    programs start dashes at one end of a line, and leave off at the other wherever they are."""
    shortest = min(piece.end - piece.start, stretch.end - stretch.start)
    if piece.linetype is stretch.linetype is Linetype.HIDDEN and shortest > ONE_DASH * rhythm.dash:
        return rhythm.gap + _BLANK_END * stroke_width
    return 0.0


def is_full_circle(geometry: WholeCurve, piece: Piece) -> bool:
    """Whether a piece goes once around its circle or ellipse."""
    return piece.end - piece.start >= geometry.around - 1e-6


def _end_at(piece: Piece, crossings: list[Crossing], rhythm: Rhythm) -> Piece:
    """Move the ends of a piece to the nearest crossings."""
    mirrored = [replace(crossing, at=-crossing.at) for crossing in crossings]
    start = -_nearest(mirrored, -piece.start, piece.linetype, rhythm)
    end = _nearest(crossings, piece.end, piece.linetype, rhythm)
    return replace(piece, start=start, end=end) if end - start > 1.0 else piece


def _nearest(
    crossings: list[Crossing], position: float, linetype: Linetype, rhythm: Rhythm
) -> float:
    """The crossing at which a piece that was seen to end at ``position`` really ends."""
    hidden = linetype is Linetype.HIDDEN
    outward = 1.8 * rhythm.gap + 3.0 if hidden else SEEN_BEYOND
    near = [
        (abs(crossing.at - position) - hidden * crossing.lead, crossing.at)
        for crossing in crossings
        # Dashes in ink that the other stroke has too are not seen.
        if -crossing.reach - SEEN_BEYOND
        <= crossing.at - position
        <= outward + hidden * _UNSEEN * crossing.reach
    ]
    return min(near, default=(0.0, position))[1]


def _parted(pair: list[Piece], crossings: list[Crossing], rhythm: Rhythm) -> list[Piece]:
    """A visible piece and the hidden one that continues it, parted at one place.

    A visible line is only hidden from where another crosses it.  Where none does, but one does a
    dash earlier, the first dash was taken for a part of the visible line.
    """
    if len(pair) < 2 or pair[0].linetype is pair[1].linetype:
        return pair
    first, second = pair
    if second.start - first.end > ONE_PLACE:
        return pair
    visible_first = first.linetype is Linetype.VISIBLE
    at = first.end if visible_first else second.start
    if not any(abs(other.at - at) < other.reach + SEEN_BEYOND for other in crossings):
        inward = -1.0 if visible_first else 1.0
        dashes = {(other.at - at) * inward / rhythm.dash: other.at for other in crossings}
        likely = min(dashes, key=lambda dash: abs(dash - 1.0), default=0.0)
        at = dashes[likely] if 0.55 < likely < 1.45 else at
    if at - first.start < 1.0 or second.end - at < 1.0:
        return pair
    return [replace(first, end=at), replace(second, start=at)]


def _moved(piece: Piece, by: float) -> Piece:
    return replace(piece, start=piece.start + by, end=piece.end + by)


def _joined(pieces: list[Piece]) -> list[Piece]:
    """Pieces of one linetype that continue each other as one."""
    joined: list[Piece] = []
    for piece in pieces:
        before = joined[-1] if joined else None
        if (
            before
            and before.linetype is piece.linetype
            and abs(piece.start - before.end) < ONE_PLACE
        ):
            sure = max(before.confidence, piece.confidence)
            joined[-1] = replace(before, end=piece.end, confidence=sure)
        else:
            joined.append(piece)
    return joined


def crossings_with(
    geometry: WholeCurve,
    piece: Piece,
    other: WholeCurve,
    stretch: Piece,
    stroke_width: float,
    *,
    blank: float = 0.0,
) -> list[Crossing]:
    """Where along ``geometry`` a stretch of another shape meets it, whose ends may be seen so many
    px before where they are."""
    half = stroke_width / 2
    reach = half
    if isinstance(geometry, Line) and isinstance(other, Line):
        points = _line_line(geometry, other)
        # Strokes that meet at a flat angle share their ink over a longer way; runs are seen up to
        # 1 px beside the ink.
        (ax, ay), (bx, by) = geometry.direction, other.direction
        sine = max(abs(ax * by - ay * bx), 0.05)
        reach = (half + 1.0) / sine - 1.0
    elif isinstance(geometry, Line) and not isinstance(other, Line):
        points = _line_curve(geometry, other)
        reach = _shared_with_tangent(points, other, half)
    elif isinstance(other, Line) and not isinstance(geometry, Line):
        points = _line_curve(other, geometry)
        reach = _shared_with_tangent(points, geometry, half)
    elif isinstance(geometry, Circle) and isinstance(other, Circle):
        points = _circle_circle(geometry, other)
        reach = _shared_by_circles(points, geometry, other, half)
    else:
        return []
    slack = max(stroke_width, reach, blank) + 2.0
    found = []
    for point in points:
        place = _position(other, point, stretch)
        if stretch.start - slack <= place <= stretch.end + slack:
            inside = min(place - stretch.start, stretch.end - place)
            lead = _CORNER * stroke_width if inside < slack else 0.0
            found.append(Crossing(_position(geometry, point, piece), reach, lead))
    return found


def _shared_with_tangent(
    points: list[npt.NDArray[np.float64]], curve: ClosedCurve, half: float
) -> float:
    """How far from a junction a line and a curve share their ink: long if they are tangent."""
    if len(points) != 1:
        return half
    return float(np.sqrt(2.0 * _radius_at(curve, points[0]) * (half + 1.0)))


def _radius_at(curve: ClosedCurve, point: npt.NDArray[np.float64]) -> float:
    """The radius of curvature next to a point."""
    if isinstance(curve, Circle):
        return curve.radius
    a, b = curve.semi_major, curve.semi_minor
    parameter = float(curve.away(point[None])[1][0])
    return float(np.hypot(a * np.sin(parameter), b * np.cos(parameter))) ** 3 / (a * b)


def _position(geometry: WholeCurve, point: npt.NDArray[np.float64], piece: Piece) -> float:
    """Position of a point along a shape; on a curve the turn nearest to the piece's middle."""
    if isinstance(geometry, Line):
        (x, y), (dx, dy) = geometry.point, geometry.direction
        return float((point[0] - x) * dx + (point[1] - y) * dy)
    along = float(geometry.positions(point[None])[0])
    middle = (piece.start + piece.end) / 2
    return along + geometry.around * round((middle - along) / geometry.around)


def _line_line(a: Line, b: Line) -> list[npt.NDArray[np.float64]]:
    (ax, ay), (bx, by) = a.direction, b.direction
    cross = ax * by - ay * bx
    if abs(cross) < 0.05:
        return []
    along = ((b.point[0] - a.point[0]) * by - (b.point[1] - a.point[1]) * bx) / cross
    return [np.array((a.point[0] + along * ax, a.point[1] + along * ay))]


def _line_curve(line: Line, curve: ClosedCurve) -> list[npt.NDArray[np.float64]]:
    if isinstance(curve, Circle):
        return _line_circle(line, curve)
    return _line_ellipse(line, curve)


def _line_ellipse(line: Line, ellipse: WholeEllipse) -> list[npt.NDArray[np.float64]]:
    """In the frame in which the ellipse is the unit circle lines meet it as they do a circle."""
    axes = np.array([ellipse.semi_major, ellipse.semi_minor])
    ends = line.points_at(np.array([0.0, 1.0]))
    start, end = ellipse.local(ends) / axes
    way = end - start
    length = float(np.hypot(*way))
    foot = start - way * float(start @ way) / length**2
    distance = float(np.hypot(*foot))
    # How far the line passes inside or outside of its parallel tangent.
    normal = np.array([-way[1], way[0]]) / length
    touch = np.arctan2(normal[1], normal[0])
    across = np.array([-line.direction[1], line.direction[0]])
    reach = abs(float((ellipse.at(np.array([touch]))[0] - np.array(ellipse.centre)) @ across))
    if (distance - 1.0) * reach > TOUCHING:
        return []
    half = np.sqrt(max(1.0 - distance**2, 0.0))
    halves = (0.0,) if abs(distance - 1.0) * reach < TOUCHING else (-half, half)
    first = -float(start @ way) / length**2
    return [np.array(line.at(first + h / length)) for h in halves]


def _shared_by_circles(
    points: list[npt.NDArray[np.float64]], one: Circle, other: Circle, half: float
) -> float:
    """How far from a junction two circles share their ink."""
    apart = float(np.hypot(*np.subtract(one.centre, other.centre)))
    if len(points) == 1:
        # They part as a line does from a circle that bends by the difference of both.
        side = 1.0 if apart < max(one.radius, other.radius) else -1.0
        bend = max(abs(1.0 / one.radius - side / other.radius), 1e-6)
        return min(float(np.sqrt(2.0 * (half + 1.0) / bend)), one.radius)
    cosine = (one.radius**2 + other.radius**2 - apart**2) / (2.0 * one.radius * other.radius)
    sine = float(np.sqrt(max(1.0 - cosine**2, 0.0025)))
    return min((half + 1.0) / sine - 1.0, 8.0 * half)


def _circle_circle(one: Circle, other: Circle) -> list[npt.NDArray[np.float64]]:
    """Two points, one where the circles touch within a tangent's tolerance, or none."""
    way = np.subtract(other.centre, one.centre)
    apart = float(np.hypot(*way))
    if apart < TOUCHING:
        return []
    beyond = apart - one.radius - other.radius
    within = abs(one.radius - other.radius) - apart
    if max(beyond, within) > TOUCHING:
        return []
    along = (apart**2 + one.radius**2 - other.radius**2) / (2.0 * apart)
    touching = max(beyond, within) > -TOUCHING
    aside = 0.0 if touching else np.sqrt(max(one.radius**2 - along**2, 0.0))
    way = way / apart
    foot = np.array(one.centre) + (np.sign(along) * one.radius if touching else along) * way
    if touching:
        return [foot]
    side = aside * np.array([-way[1], way[0]])
    return [foot - side, foot + side]


def _line_circle(line: Line, circle: Circle) -> list[npt.NDArray[np.float64]]:
    (x, y), (dx, dy) = line.point, line.direction
    ox, oy = circle.centre[0] - x, circle.centre[1] - y
    along, distance = ox * dx + oy * dy, abs(oy * dx - ox * dy)
    if distance > circle.radius + TOUCHING:
        return []
    half = sqrt(max(circle.radius**2 - distance**2, 0.0))
    # A tangent has one junction, below the centre.
    halves = (0.0,) if abs(distance - circle.radius) < TOUCHING else (-half, half)
    return [np.array(line.at(along + h)) for h in halves]
