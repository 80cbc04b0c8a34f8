"""Small fillets between a straight stroke and an arc.

As in :mod:`.small_fillets` all is known of such a corner but one number.  The
strokes are drawn up to where they cross, with every arc that touches both, and with a straight cut,
and compared with the sheet pixel by pixel.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to, visible_leg
from gaussiancad_core.sheet.tracing.pen_profile import Pen, visible_pen
from gaussiancad_core.sheet.tracing.small_fillets import AROUND, Fillet, best_of, boxes_of, is_chord

Floats = npt.NDArray[np.float64]

_REACH = 26.0
"""px from where the strokes cross to where an arc begins, and to their ends, at most."""

_BEYOND = 3.0
"""px by which a stroke may seem to end beyond the crossing."""

_LEAST_RADIUS, _FINE = 3.0, 0.1
"""px under which a corner is as good as sharp; between the radii that are tried at last."""

_OWN = 0.75
"""Share of each stroke that a fillet may take."""

_FLATTEST, _STEEPEST = np.radians(25.0), np.radians(155.0)
"""Angles between the strokes at a corner that is looked at."""

_BETTER, _LEAST_GAIN = 0.4, 1.0
"""Share of a sharp corner's squared error that a fillet may have; squared ink, in full pixels, that
it must explain more."""

_THAN_EVEN, _THAN_CUT = 1.0, 1.25
"""The same share of an even chamfer's squared error, and of any chamfer's: that has one number more
to fit, and follows a small arc as closely."""

_FEWEST = 20
"""Pixels that are compared, at least."""

_MET = 2.5
"""px from the crossing within which the end of a third stroke has the corner."""


@dataclass(frozen=True)
class _End:
    """An end of a visible piece: its number, which end, (2,) px and (2,) unit vector into it."""

    index: int
    at_start: bool
    place: Floats
    inward: Floats


@dataclass(frozen=True)
class _Rounding:
    """An arc that touches a line and a circle, and (2,) px of where."""

    circle: Circle
    on_line: Floats
    on_curve: Floats


@dataclass(frozen=True)
class _CurvedCorner:
    """Where a line and an arc meet.

    Attributes:
        line, curve: the ends that meet.
        circle: that the arc lies on.
        place: (2,) px of the crossing.
        way: (2,) unit tangent there, into the arc.
        longest: px that a fillet may take of each stroke.
    """

    line: _End
    curve: _End
    circle: Circle
    place: Floats
    way: Floats
    longest: float

    def rounding(self, radius: float) -> _Rounding | None:
        """The arc of a radius in px between the two strokes; nothing where it would be too long."""
        u, centre = self.line.inward, np.array(self.circle.centre)
        normal = np.array([-u[1], u[0]])
        normal = normal if normal @ self.way > 0.0 else -normal
        outward = self.place - centre
        inside = (u + self.way) @ outward < 0.0
        far = self.circle.radius - radius if inside else self.circle.radius + radius
        # |start + t u| = far, from the circle's centre.
        start = outward + radius * normal
        along = float(start @ u)
        square = along**2 - float(start @ start) + far**2
        if far <= 0.0 or square < 0.0:
            return None
        roots = [t for t in (-along - np.sqrt(square), -along + np.sqrt(square)) if t > 0.0]
        if not roots or min(roots) > self.longest:
            return None
        middle = centre + start + min(roots) * u
        on_line = self.place + min(roots) * u
        on_curve = centre + (middle - centre) * self.circle.radius / far
        taken = float(np.hypot(*(on_curve - self.place)))
        if taken > self.longest or (on_curve - self.place) @ self.way < 0.0:
            return None
        circle = Circle((float(middle[0]), float(middle[1])), radius)
        return _Rounding(circle, on_line, on_curve)


def find_curved_fillets(
    weight: npt.NDArray[np.float32], placed: Sequence[Placed], stroke_width: float
) -> list[Fillet]:
    """The round corners between ends of visible lines and of visible arcs.

    Args:
        weight: (h, w) ink.
        placed: pieces with their ends at junctions; px, pixel centres at integers.
        stroke_width: px.
    """
    corners = _corners(placed)
    if not corners:
        return []
    pen = visible_pen(weight, placed, stroke_width)
    boxes = boxes_of(placed)
    pieces = dict(enumerate(piece for _, piece in placed))
    taken: set[tuple[int, bool]] = set()
    found: list[Fillet] = []
    for corner in corners:
        keys = {(end.index, end.at_start) for end in (corner.line, corner.curve)}
        line = placed[corner.line.index]
        if keys & taken or any(is_chord(line, fillet.arc) for fillet in found):
            continue
        rounding = _rounding(weight, corner, placed, boxes, pen)
        if rounding is None:
            continue
        taken |= keys
        cut = tuple(
            (end.index, _ended(placed[end.index], pieces[end.index], end, place))
            for end, place in (
                (corner.line, rounding.on_line),
                (corner.curve, rounding.on_curve),
            )
        )
        pieces.update(cut)
        found.append(Fillet(cut, _arc(rounding, min(piece.confidence for _, piece in cut))))
    return found


def _corners(placed: Sequence[Placed]) -> list[_CurvedCorner]:
    """Pairs of a line's and an arc's end where no third stroke ends, the longest lines first: short
    ones may be chords of a fillet."""
    ends = [
        end
        for index, (geometry, piece) in enumerate(placed)
        if piece.linetype is Linetype.VISIBLE and piece.end - piece.start < geometry.around - 1e-6
        for end in _both(index, geometry, piece)
    ]
    lines = [end for end in ends if isinstance(placed[end.index][0], Line)]
    curves = [end for end in ends if isinstance(placed[end.index][0], Circle)]
    places = np.array([end.place for end in ends]).reshape(-1, 2)
    found = []
    for line, curve in product(lines, curves):
        if np.hypot(*(line.place - curve.place)) > _REACH:
            continue
        corner = _crossing(line, curve, placed)
        if corner is None:
            continue
        near = np.hypot(*(places - corner.place).T) < _MET
        if not {ends[k].index for k in np.flatnonzero(near)} - {line.index, curve.index}:
            found.append(corner)
    lengths = [piece.end - piece.start for _, piece in placed]
    return sorted(found, key=lambda curved_corner: -lengths[curved_corner.line.index])


def _both(index: int, geometry: WholeCurve, piece: Piece) -> list[_End]:
    at = np.array([piece.start, piece.end])
    places, ways = geometry.points_at(at), geometry.tangents_at(at)
    return [_End(index, True, places[0], ways[0]), _End(index, False, places[1], -ways[1])]


def _crossing(line: _End, curve: _End, placed: Sequence[Placed]) -> _CurvedCorner | None:
    """Where a line crosses an arc's circle next to both ends."""
    circle, piece = placed[curve.index]
    assert isinstance(circle, Circle)
    offset = line.place - np.array(circle.centre)
    along = float(offset @ line.inward)
    square = along**2 - float(offset @ offset) + circle.radius**2
    if square <= 0.0:
        return None
    # px outward from the line's end.
    beyond = [along - np.sqrt(square), along + np.sqrt(square)]
    places = [line.place - b * line.inward for b in beyond]
    nearest = int(np.argmin([np.hypot(*(place - curve.place)) for place in places]))
    place = places[nearest]
    gap = float((curve.place - place) @ curve.inward)
    if not (-_BEYOND <= beyond[nearest] <= _REACH and -_BEYOND <= gap <= _REACH):
        return None
    radial = (place - np.array(circle.centre)) / circle.radius
    way = np.array([-radial[1], radial[0]]) * (1.0 if curve.at_start else -1.0)
    angle = float(np.arccos(np.clip(line.inward @ way, -1.0, 1.0)))
    if not _FLATTEST <= angle <= _STEEPEST:
        return None
    stroke = placed[line.index][1]
    room = min(stroke.end - stroke.start + beyond[nearest], piece.end - piece.start + gap)
    longest = min(_REACH, _OWN * room, circle.radius)
    return _CurvedCorner(line, curve, circle, place, way, longest)


def _rounding(
    weight: npt.NDArray[np.float32],
    corner: _CurvedCorner,
    placed: Sequence[Placed],
    boxes: Floats,
    pen: Pen,
) -> _Rounding | None:
    """The arc that explains the corner's ink, None if it is sharp or cut."""
    reach = corner.longest + pen.width / 2.0 + AROUND
    items = {corner.line.index, corner.curve.index}
    near = ((boxes[:, 0] <= corner.place + reach) & (boxes[:, 1] >= corner.place - reach)).all(1)
    around = [placed[k] for k in np.flatnonzero(near).tolist() if k not in items]
    others = [stroke for stroke in around if not _is_between(stroke, corner)]
    pixels = _pixels_around(weight.shape, corner.place, reach)
    strokes = _cut_strokes(corner, placed, corner.place, corner.place)
    offset = pen.width / 2.0 + AROUND
    wedge = _nearest([visible_leg(*_tips(corner))], pixels) <= corner.longest / 2.0
    stated = (_nearest(strokes, pixels) <= offset) | wedge
    stated &= np.hypot(*(pixels - corner.place).T) <= corner.longest
    stated &= _nearest(others, pixels) > offset
    pixels = pixels[stated]
    if len(pixels) < _FEWEST:
        return None
    columns, rows = pixels.astype(int).T
    ink = weight[rows, columns].astype(np.float64)

    def error(strokes: Sequence[Placed]) -> float:
        return float(((pen.ink(_nearest(strokes, pixels)) - ink) ** 2).sum())

    def rounded(radius: float) -> float:
        found = corner.rounding(radius)
        if found is None:
            return np.inf
        return error([*_cut_strokes(corner, placed, found.on_line, found.on_curve), _arc(found)])

    sharp = error(strokes)
    if sharp < _LEAST_GAIN:
        return None
    radius = best_of(rounded, np.arange(_LEAST_RADIUS, 2.0 * _REACH, 1.0))
    radius = best_of(rounded, np.arange(radius - 1.0, radius + 1.0 + 1e-9, _FINE))
    best, found = rounded(radius), corner.rounding(radius)
    if found is None or radius < _LEAST_RADIUS:
        return None
    if best > _BETTER * sharp or sharp - best < _LEAST_GAIN:
        return None
    cuts = np.arange(2.0, corner.longest, 1.0)
    for lengths, share in (
        (zip(cuts, cuts, strict=True), _THAN_EVEN),
        (product(cuts, cuts), _THAN_CUT),
    ):
        cut = min((error(_with_cut(corner, placed, *length)) for length in lengths), default=np.inf)
        if best > share * cut:
            return None
    return found


def _with_cut(
    corner: _CurvedCorner, placed: Sequence[Placed], on_line: float, on_curve: float
) -> list[Placed]:
    """The strokes and the straight piece between places some px from the corner on each."""
    first = corner.place + on_line * corner.line.inward
    at = corner.circle.positions(corner.place[None]) + on_curve * (
        1.0 if corner.curve.at_start else -1.0
    )
    second = corner.circle.points_at(at)[0]
    return [*_cut_strokes(corner, placed, first, second), visible_leg(first, second)]


def _cut_strokes(
    corner: _CurvedCorner, placed: Sequence[Placed], on_line: Floats, on_curve: Floats
) -> list[Placed]:
    """The line and the arc up to (2,) px on each."""
    cut = []
    for end, place in ((corner.line, on_line), (corner.curve, on_curve)):
        geometry, piece = placed[end.index]
        cut.append((geometry, _ended(placed[end.index], piece, end, place)))
    return cut


def _ended(pair: Placed, piece: Piece, end: _End, place: Floats) -> Piece:
    """A piece that ends at (2,) px."""
    geometry = pair[0]
    at = float(geometry.positions(place[None])[0])
    old = piece.start if end.at_start else piece.end
    if np.isfinite(geometry.around):
        at += geometry.around * round((old - at) / geometry.around)
    return replace(piece, start=at) if end.at_start else replace(piece, end=at)


def _arc(rounding: _Rounding, confidence: float = 1.0) -> Placed:
    circle = rounding.circle
    low, high = (
        float(circle.positions(place[None])[0]) for place in (rounding.on_line, rounding.on_curve)
    )
    if (high - low) % circle.around > circle.around / 2.0:
        low, high = high, low
    end = low + (high - low) % circle.around
    return circle, Piece(low, end, Linetype.VISIBLE, confidence)


def _tips(corner: _CurvedCorner) -> tuple[Floats, Floats]:
    """(2,) px on the line and beside the arc that are as far from the corner as a fillet."""
    half = corner.longest / 2.0
    return corner.place + half * corner.line.inward, corner.place + half * corner.way


def _is_between(pair: Placed, corner: _CurvedCorner) -> bool:
    """Whether a piece may be a chord of a fillet, or a chamfer."""
    geometry, piece = pair
    if not isinstance(geometry, Line):
        return False
    ends = geometry.points_at(np.array([piece.start, piece.end]))
    return bool((np.hypot(*(ends - corner.place).T) < corner.longest + _MET).all())


def _pixels_around(shape: tuple[int, ...], place: Floats, reach: float) -> Floats:
    """(n, 2) px in a square."""
    low = np.maximum(np.floor(place - reach), 0).astype(int)
    high = np.minimum(np.ceil(place + reach) + 1, shape[::-1]).astype(int)
    ys, xs = np.mgrid[low[1] : max(high[1], low[1]), low[0] : max(high[0], low[0])]
    return np.stack([xs.ravel(), ys.ravel()], axis=1).astype(np.float64)


def _nearest(pieces: Sequence[Placed], pixels: Floats) -> Floats:
    """(n,) px to the nearest of some pieces; far where there is none."""
    distance = np.full(len(pixels), 1e3)
    for piece in pieces:
        distance = np.minimum(distance, distances_to(piece, pixels))
    return distance
