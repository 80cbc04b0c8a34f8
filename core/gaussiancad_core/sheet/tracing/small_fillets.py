"""Small fillets: where two straight strokes meet, is the corner sharp, rounded or cut?

A fillet of a few px has too few ridge points of its own to be grown: tangents on both sides bend
them.  But all is known of such a corner except one number.  The two lines are exact, and how ink
falls off beside them has been measured.  So the corner is drawn with every radius, and compared
with the sheet pixel by pixel (analysis by synthesis).  A sharp corner is drawn in the ways that
pens and printers join lines, a cut one with a straight piece.  The fillet is taken if it explains
the ink far better than they do.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import (
    AROUND,
    BETTER,
    BLUNT,
    FINEST_STEP,
    JOINED,
    LEAST_GAIN,
    OVERRUN,
    SHARP,
    SMALLEST_RADIUS,
    TOUCHING,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.corners import (
    Corner,
    End,
    from_cut,
    from_fillet,
    from_joins,
    from_ray,
)
from gaussiancad_core.sheet.tracing.flanks import has_flank, is_within, samples
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.passing_corners import passing_corners
from gaussiancad_core.sheet.tracing.pen_profile import Pen, visible_pen

Floats = npt.NDArray[np.float64]
Key = tuple[int, bool, bool]

_SAME = 1e-3
"""px between two ends that are one."""

_LONGEST_TANGENT = 26.0
"""px from the corner to where an arc begins, at most: larger fillets are grown."""

_CLEARER, _CLEARER_THAN_LINE = 0.0, 0.5
"""Squared ink that it must explain more than a straight cut; and where one is drawn already, from
corner to corner of other strokes."""


@dataclass(frozen=True)
class Fillet:
    """A corner that is round.

    Attributes:
        pieces: of the straight pieces that end at it, their number and what is left of them.
        arc: between them.
        instead: numbers of the arcs that were there before.
    """

    pieces: tuple[tuple[int, Piece], ...]
    arc: Placed
    instead: tuple[int, ...] = ()


def find_fillets(
    weight: npt.NDArray[np.float32],
    placed: Sequence[Placed],
    stroke_width: float,
    cuts: Sequence[Placed] = (),
) -> list[Fillet]:
    """The round corners between the ends of visible straight pieces.

    Args:
        weight: (h, w) ink.
        placed: pieces with their ends at junctions; px, pixel centres at integers.
        stroke_width: px.
        cuts: those of the pieces that are known to cut the corner between their ends.
    """
    ends = straight_ends(placed, Linetype.VISIBLE)
    corners = _chords_last(open_corners(ends, placed), placed)
    corners += passing_corners(ends, placed, {Linetype.VISIBLE})
    if not corners:
        return []
    pen = visible_pen(weight, placed, stroke_width)
    boxes = boxes_of(placed)
    found: list[Fillet] = []
    pieces = dict(enumerate(piece for _, piece in placed))
    taken: set[Key] = set()
    for corner in corners:
        keys = keys_of(corner)
        if keys & taken:
            continue
        others = others_near(corner, placed, boxes, pen.width + 2.0 * AROUND)
        if any(_joins(cut, corner) for cut in cuts):
            continue
        on_arc = any(is_chord(placed[corner.first.index], fillet.arc) for fillet in found)
        if on_arc or _lies_beyond(corner, others):
            continue
        clearer = _CLEARER_THAN_LINE if has_flank(corner, placed, boxes) else _CLEARER
        radius = _radius(weight, corner, others, pen, clearer)
        if radius is None:
            continue
        taken |= keys
        fillet = rounded_at(corner, radius, placed, pieces)
        pieces.update(fillet.pieces)
        found.append(fillet)
    return found


def _joins(cut: Placed, corner: Corner) -> bool:
    """Whether a piece runs from the one end at a corner to the other one."""
    tips = cut[0].points_at(np.array([cut[1].start, cut[1].end]))
    ends = np.array([corner.first.place, corner.second.place])
    away = [np.abs(ends - values).max() for values in (tips, tips[::-1])]
    return bool(min(away) < _SAME)


def keys_of(corner: Corner) -> set[Key]:
    """The sides of ends that a fillet takes: two may end where one stroke does, on either side."""
    u, v = corner.first.inward, corner.second.inward
    if corner.passes:
        return {(corner.first.index, corner.first.at_start, bool(u[0] * v[1] > u[1] * v[0]))}
    ends = corner.first, corner.second
    return {(end.index, end.at_start, side) for end in ends for side in (False, True)}


def _lies_beyond(corner: Corner, others: Sequence[Placed]) -> bool:
    """Whether both strokes end on one line that runs past them, and would meet beyond it."""
    points = np.array([corner.first.place, corner.second.place, corner.place])
    for line, piece in others:
        if isinstance(line, Line) and piece.linetype is Linetype.VISIBLE:
            along, across = line.coordinates(points)
            on = (np.abs(across[:2]) < JOINED) & (along[:2] > piece.start) & (along[:2] < piece.end)
            if on.all() and abs(across[2]) > JOINED:
                return True
    return False


def is_chord(pair: Placed, arc: Placed) -> bool:
    """Whether a piece is no longer than an arc and runs along it."""
    geometry, piece = pair
    length = arc[1].end - arc[1].start
    if piece.end - piece.start > length + 4.0:
        return False
    points = geometry.points_at(samples(piece))
    ends = arc[0].points_at(np.array([arc[1].start, arc[1].end]))
    near = np.minimum(*(np.hypot(*(points - end).T) for end in ends)) < length
    # Where it ends at the lines beside the arc it may have left the arc.
    return bool((arc[0].distances(points) < TOUCHING).mean() > 0.6 and near.all())


def straight_ends(placed: Sequence[Placed], linetype: Linetype) -> list[End]:
    """The ends of the straight pieces of a linetype."""
    ends = []
    for index, (geometry, piece) in enumerate(placed):
        if not isinstance(geometry, Line) or piece.linetype is not linetype:
            continue
        way = np.array(geometry.direction)
        length = piece.end - piece.start
        ends.append(End(index, True, np.array(geometry.at(piece.start)), way, length))
        ends.append(End(index, False, np.array(geometry.at(piece.end)), -way, length))
    return ends


def open_corners(ends: list[End], placed: Sequence[Placed]) -> list[Corner]:
    """Pairs of ends that may be joined by an arc, the nearest first."""
    others = _other_ends(placed)
    corners = []
    for first, second in combinations(ends, 2):
        if first.index == second.index:
            continue
        if np.hypot(*(first.place - second.place)) > 2.0 * _LONGEST_TANGENT:
            continue
        corner = _corner(first, second)
        if corner is not None and not _is_taken(corner, others):
            corners.append(corner)
    return sorted(corners, key=lambda c: float(np.hypot(*(c.first.place - c.second.place))))


def _chords_last(corners: list[Corner], placed: Sequence[Placed]) -> list[Corner]:
    """The corners in their order, but first those between whose lines a piece lies that may be a
    chord of their arc: with an end of the chord one of them has a corner as well, and a nearer one.
    """
    points = {
        end.index: placed[end.index][0].points_at(samples(placed[end.index][1]))
        for corner in corners
        for end in (corner.first, corner.second)
        if end.length <= 2.0 * _LONGEST_TANGENT
    }
    chords = set()
    for index, point in points.items():
        middle = point.mean(axis=0)
        chords |= {
            index
            for corner in corners
            if index not in (corner.first.index, corner.second.index)
            and np.abs(middle - corner.place).max() <= corner.longest
            and is_within(point, corner)
        }
    return sorted(
        corners, key=lambda corner: not chords.isdisjoint((corner.first.index, corner.second.index))
    )


def _corner(first: End, second: End) -> Corner | None:
    u, v = first.inward, second.inward
    cross = float(u[0] * v[1] - u[1] * v[0])
    angle = float(np.arctan2(abs(cross), u @ v))
    if not SHARP <= angle <= BLUNT:
        return None
    gap = second.place - first.place
    # How far outward from each end the lines cross.
    short = -float(gap[0] * v[1] - gap[1] * v[0]) / cross
    other = -float(gap[0] * u[1] - gap[1] * u[0]) / cross
    if not all(-OVERRUN <= beyond <= _LONGEST_TANGENT for beyond in (short, other)):
        return None
    place = first.place - short * u
    room = min(first.length + short, second.length + other)
    return Corner(first, second, place, min(_LONGEST_TANGENT, 0.75 * room))


def _other_ends(placed: Sequence[Placed]) -> list[tuple[int, Floats]]:
    """The ends of pieces of curves, with the number of the piece."""
    found = []
    for index, (geometry, piece) in enumerate(placed):
        if isinstance(geometry, Line):
            continue
        found.append((index, geometry.points_at(np.array([piece.start, piece.end]))))
    return found


def _is_taken(corner: Corner, others: list[tuple[int, Floats]]) -> bool:
    """Whether an arc that was grown goes on where one of the strokes ends."""
    return any(
        np.hypot(*(points - end.place).T).min() < JOINED
        for _, points in others
        for end in (corner.first, corner.second)
    )


def _radius(
    weight: npt.NDArray[np.float32],
    corner: Corner,
    others: Sequence[Placed],
    pen: Pen,
    clearer: float,
) -> float | None:
    """The radius that explains the corner's ink by so much more than a straight cut, None if it is
    sharp or cut."""
    most = corner.longest * np.tan(corner.half)
    if most <= SMALLEST_RADIUS:
        return None
    offsets, ink = pixels_around(weight, corner, others, pen)
    if len(ink) < 20:
        return None

    def error(distance: Floats) -> float:
        return float(((pen.ink(distance) - ink) ** 2).sum())

    def rounded(radius: float) -> float:
        return error(from_fillet(corner, offsets, radius))

    sharp = min(error(distance) for distance in from_joins(corner, offsets))
    coarse = np.arange(SMALLEST_RADIUS, most + 0.5, 1.0)
    if sharp < LEAST_GAIN:
        return None
    radius = best_of(rounded, coarse)
    radius = best_of(rounded, np.arange(radius - 1.0, radius + 1.0 + 1e-9, FINEST_STEP))
    best = rounded(radius)
    if best > BETTER * sharp or sharp - best < LEAST_GAIN or radius < SMALLEST_RADIUS:
        return None
    cuts = np.arange(1.0, corner.longest, 0.5)
    cut = min(error(from_cut(corner, offsets, float(length))) for length in cuts)
    return radius if best < 0.8 * cut and cut - best > clearer else None


def best_of(function: Callable[[float], float], values: Floats) -> float:
    """The value for which a function is least."""
    return float(values[int(np.argmin([function(float(value)) for value in values]))])


def pixels_around(
    weight: npt.NDArray[np.float32], corner: Corner, others: Sequence[Placed], pen: Pen
) -> tuple[Floats, Floats]:
    """(n, 2) px from the corner, and (n,) ink, of the pixels that tell of it: near its strokes and
    between them, away from other strokes."""
    reach = corner.longest + pen.width / 2 + AROUND
    low = np.maximum(np.floor(corner.place - reach), 0).astype(int)
    high = np.minimum(np.ceil(corner.place + reach) + 1, weight.shape[::-1]).astype(int)
    ys, xs = np.mgrid[low[1] : max(high[1], low[1]), low[0] : max(high[0], low[0])]
    pixels = np.stack([xs.ravel(), ys.ravel()], axis=1).astype(np.float64)
    offsets = pixels - corner.place
    offset = pen.width / 2 + AROUND
    near = np.minimum.reduce([from_ray(corner.first, offsets), from_ray(corner.second, offsets)])
    along = [offsets @ end.inward for end in (corner.first, corner.second)]
    inner = near <= offset
    # The triangle in which arcs run.
    a, b = corner.shares(offsets)
    inner |= (a >= 0.0) & (b >= 0.0) & (a + b <= corner.longest)
    if corner.passes:
        # On the other side may be another arc.
        inner &= b >= 0.0
    inner &= np.maximum(*along) <= corner.longest + 1.0
    for geometry, piece in others:
        away = geometry.distances(pixels)
        at = geometry.positions(pixels)
        if np.isfinite(geometry.around):
            at = piece.start + np.mod(at - piece.start, geometry.around)
        inner &= (
            (away > offset)
            | (at < piece.start - offset)
            | ((at > piece.end + offset) & (at < piece.start + geometry.around - offset))
        )
    x, y = pixels[inner].astype(int).T
    return offsets[inner], weight[y, x].astype(np.float64)


def boxes_of(placed: Sequence[Placed]) -> Floats:
    """(n, 2, 2) px, the lower and upper corner of each piece's bounding box."""
    points = [geometry.points_at(samples(piece)) for geometry, piece in placed]
    return np.array([[point.min(0), point.max(0)] for point in points])


def others_near(
    corner: Corner, placed: Sequence[Placed], boxes: Floats, margin: float
) -> list[Placed]:
    """Other pieces that come near a corner, without the chords of an arc that may be there."""
    reach = corner.longest + margin
    near = (boxes[:, 0] <= corner.place + reach) & (boxes[:, 1] >= corner.place - reach)
    near[[corner.first.index, corner.second.index]] = False
    return [
        placed[index]
        for index in np.flatnonzero(near.all(1)).tolist()
        if index not in corner.instead
        and not is_within(placed[index][0].points_at(samples(placed[index][1])), corner)
    ]


def rounded_at(
    corner: Corner, radius: float, placed: Sequence[Placed], pieces: dict[int, Piece]
) -> Fillet:
    """A corner with a radius in px; its pieces' numbers are those of ``placed``, what is left of
    them so far in ``pieces``."""
    begin = radius / np.tan(corner.half)
    cut: list[tuple[int, Piece]] = []
    touching = [corner.place + begin * end.inward for end in (corner.first, corner.second)]
    for end, place in zip((corner.first, corner.second), touching, strict=True):
        if corner.passes and end is corner.second:
            continue
        at = float(placed[end.index][0].positions(place[None])[0])
        piece = pieces[end.index]
        shorter = replace(piece, start=at) if end.at_start else replace(piece, end=at)
        cut.append((end.index, shorter))
    circle = corner.circle(radius)
    low, high = (float(circle.positions(place[None])[0]) for place in touching)
    if (high - low) % circle.around > circle.around / 2:
        low, high = high, low
    sure = min(piece.confidence for _, piece in cut)
    linetype = cut[0][1].linetype
    arc = Piece(low, low + (high - low) % circle.around, linetype, sure)
    return Fillet(tuple(cut), (circle, arc), corner.instead)
