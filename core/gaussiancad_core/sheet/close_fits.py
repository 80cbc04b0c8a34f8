"""Visible lines close beside each other, fitted together.

Less than about a line width of paper lies between them, and the blurred ink of each pulls the fit
of the other one, by up to half a pixel.  So all lines of such a bundle are moved at once until what
a pen draws along them is the ink that the sheet has (analysis by synthesis); where bands of ink
overlap, they are one.  Concentric circles are fitted like lines.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.special import ndtr

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Geometry, Line
from gaussiancad_core.sheet.jogs import distances_to
from gaussiancad_core.sheet.junctions import Placed, is_full_circle
from gaussiancad_core.sheet.pen import Pen, visible_pen
from gaussiancad_core.sheet.runs import Piece
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_NEAREST, _PAPER = 0.6, 3.0
"""Line widths between two lines that are told apart, at least; px of paper between two that pull
each other, at most."""

_PARALLEL = np.sin(np.radians(2.0))
"""Sine of the largest angle between two lines beside each other."""

_CONCENTRIC = 1.0
"""px between the centres of two circles beside each other, at most."""

_SHORTEST = 10.0
"""px along which two run beside each other, at least."""

_BESIDE, _CLEAR, _AT_END = 2.0, 1.5, 3.0
"""px beside the ink of a bundle that are looked at; px from the ink of other strokes, and from
where one of the bundle ends."""

_MOST = 4000
"""Pixels that are looked at."""

_FEWEST = 40

_LEAST_BLUR = 0.35
"""px by which the edge of ink is blurred at least: pixels are no points, and what has no slope
leads nowhere."""

_MOVED = 1.2
"""px by which a line may be off."""

_BETTER, _EVEN = 0.8, 0.12
"""Share of the squares of what the lines as they were leave of the ink, and mean ink by which
pixels may differ from the pen's, at most."""


@dataclass(frozen=True)
class _Strand:
    """A line or circle of a bundle, and where it is drawn.

    Attributes:
        geometry: px, pixel centres at integers.
        pieces: of it.
    """

    geometry: Line | Circle
    pieces: tuple[Piece, ...]

    def moved(self, values: Floats) -> "_Strand":
        """With three numbers: px across and radians of turn about its middle, 0; or px of a
        circle's centre and of its radius."""
        if isinstance(self.geometry, Circle):
            x, y = self.geometry.centre
            centre = (float(x + values[0]), float(y + values[1]))
            circle = Circle(centre, float(self.geometry.radius + values[2]))
            factor = circle.radius / self.geometry.radius
            pieces = tuple(_scaled(piece, factor) for piece in self.pieces)
            return _Strand(circle, pieces)
        middle = 0.5 * (self.pieces[0].start + self.pieces[-1].end)
        way = np.array(self.geometry.direction)
        normal = np.array([-way[1], way[0]])
        turned = way + np.tan(values[1]) * normal
        turned /= np.hypot(*turned)
        at = np.array(self.geometry.at(middle)) + values[0] * normal
        origin = at - middle * turned
        line = Line((float(origin[0]), float(origin[1])), (float(turned[0]), float(turned[1])))
        return _Strand(line, self.pieces)

    def offsets(self, pixels: Floats, facing: Floats) -> Floats:
        """(n, 2) pixels -> (n,) px by which the strand lies beside each: signed along ``facing``,
        or away from the centre; infinite where it is not drawn."""
        geometry = self.geometry
        if isinstance(geometry, Circle):
            around = pixels - np.array(geometry.centre)
            beside = geometry.radius - np.hypot(*around.T)
        else:
            across = geometry.coordinates(pixels)[1]
            normal = np.array([-geometry.direction[1], geometry.direction[0]])
            beside = -across * np.sign(normal @ facing)
        at = geometry.positions(pixels)
        drawn = np.zeros(len(pixels), bool)
        for piece in self.pieces:
            along = at
            if np.isfinite(geometry.around):
                along = piece.start + np.mod(at - piece.start, geometry.around)
            drawn |= (along >= piece.start) & (along <= piece.end)
        return np.where(drawn, beside, np.inf)


def with_close_fits(
    pieces: Sequence[Placed], ended: Sequence[Placed], sheet: CleanSheet
) -> list[Placed]:
    """The pieces with the lines and circles of bundles where they were drawn.

    Args:
        pieces: of a view; px, pixel centres at integers.
        ended: the same ones with their ends at junctions.
        sheet: the view's ink.
    """
    strands = _strands(ended)
    bundles = _bundles(strands, sheet.stroke_width)
    if not bundles:
        return list(pieces)
    pen = visible_pen(sheet.weight, ended, sheet.stroke_width)
    better: dict[Geometry, Geometry] = {}
    for bundle in bundles:
        own = {strand.geometry for strand in bundle}
        others = [placed for placed in ended if placed[0] not in own]
        for strand, fitted in zip(bundle, _fitted(bundle, others, sheet, pen), strict=True):
            better[strand.geometry] = fitted.geometry
    return [(better.get(own, own), _as_long(own, better.get(own, own), p)) for own, p in pieces]


def _as_long(before: Geometry, after: Geometry, piece: Piece) -> Piece:
    if isinstance(before, Circle) and isinstance(after, Circle):
        return _scaled(piece, after.radius / before.radius)
    return piece


def _scaled(piece: Piece, factor: float) -> Piece:
    """The piece at the same angles of a circle of another radius."""
    return Piece(piece.start * factor, piece.end * factor, piece.linetype, piece.confidence)


def _strands(ended: Sequence[Placed]) -> list[_Strand]:
    """The lines and circles of which all pieces are visible."""
    found: dict[Line | Circle, list[Piece]] = {}
    dashed = {geometry for geometry, piece in ended if piece.linetype is Linetype.HIDDEN}
    for geometry, piece in ended:
        if isinstance(geometry, Line | Circle) and geometry not in dashed:
            found.setdefault(geometry, []).append(piece)
    return [
        _Strand(geometry, tuple(sorted(own, key=lambda piece: piece.start)))
        for geometry, own in found.items()
    ]


def _bundles(strands: Sequence[_Strand], width: float) -> list[list[_Strand]]:
    """Strands each of which runs close beside another one of its bundle."""
    bundles: list[list[_Strand]] = []
    for strand in strands:
        beside = [b for b in bundles if any(_run_beside(strand, other, width) for other in b)]
        bundles = [b for b in bundles if b not in beside]
        bundles.append([strand, *(other for b in beside for other in b)])
    return [bundle for bundle in bundles if len(bundle) > 1]


def _run_beside(one: _Strand, other: _Strand, width: float) -> bool:
    apart = _NEAREST * width, width + _PAPER
    a, b = one.geometry, other.geometry
    if isinstance(a, Circle) and isinstance(b, Circle):
        near = np.hypot(*np.subtract(a.centre, b.centre)) <= _CONCENTRIC
        return bool(near and apart[0] <= abs(a.radius - b.radius) <= apart[1])
    if not isinstance(a, Line) or not isinstance(b, Line):
        return False
    (x, y), (u, v) = a.direction, b.direction
    if abs(x * v - y * u) > _PARALLEL:
        return False
    for piece in one.pieces:
        for beside in other.pieces:
            ends = a.positions(b.points_at(np.array([beside.start, beside.end])))
            start, end = max(piece.start, float(ends.min())), min(piece.end, float(ends.max()))
            if end - start >= _SHORTEST:
                away = b.distances(a.points_at(np.array([start, end])))
                if apart[0] <= away.min() and away.max() <= apart[1]:
                    return True
    return False


def _fitted(
    bundle: Sequence[_Strand], others: Sequence[Placed], sheet: CleanSheet, pen: Pen
) -> list[_Strand]:
    """The strands as the ink has them; as they are where it does not tell."""
    from scipy.optimize import least_squares

    pixels = _pixels(bundle, others, sheet, pen)
    if len(pixels) < _FEWEST:
        return list(bundle)
    ink = sheet.weight[pixels[:, 1].astype(int), pixels[:, 0].astype(int)].astype(np.float64)
    facing = _facing(bundle[0])
    free = [[0, 1, 2] if isinstance(own.geometry, Circle) else [0, 1] for own in bundle]
    places = [3 * k + at for k, own in enumerate(free) for at in own]

    def strands(values: Floats) -> list[_Strand]:
        moves = np.zeros(3 * len(bundle))
        moves[places] = values * scales
        return [own.moved(moves[3 * k : 3 * k + 3]) for k, own in enumerate(bundle)]

    # A turn is measured by what it moves a line's ends.
    scales = np.array(
        [
            2.0 / max(bundle[at // 3].pieces[-1].end - bundle[at // 3].pieces[0].start, 1.0)
            if at % 3 == 1 and isinstance(bundle[at // 3].geometry, Line)
            else 1.0
            for at in places
        ]
    )

    def residual(values: Floats) -> Floats:
        beside = np.stack([own.offsets(pixels, facing) for own in strands(values)])
        return _inked(beside, pen) - ink

    start = np.zeros(len(places))
    before = float(np.square(residual(start)).sum())
    found = least_squares(residual, start, bounds=(-_MOVED, _MOVED), diff_step=1e-3)
    after = float(np.square(found.fun).sum())
    if after > _BETTER * before or float(np.abs(found.fun).mean()) > _EVEN:
        return list(bundle)
    if np.abs(found.x).max() > 0.99 * _MOVED:
        return list(bundle)
    return strands(found.x)


def _facing(strand: _Strand) -> Floats:
    if isinstance(strand.geometry, Circle):
        return np.zeros(2)
    x, y = strand.geometry.direction
    return np.array([-y, x])


def _inked(beside: Floats, pen: Pen) -> Floats:
    """(k, n) px by which k strands lie beside n pixels -> (n,) ink of the bands together."""
    half = pen.width / 2.0
    total = np.zeros(beside.shape[1])
    reached = np.full(beside.shape[1], -np.inf)
    for centre in np.sort(beside, axis=0):
        low, high = np.maximum(centre - half, reached), centre + half
        inside = np.isfinite(centre) & (high > low)
        total[inside] += _band(low[inside], high[inside], pen)
        reached = np.where(inside, high, reached)
    return total


def _band(low: Floats, high: Floats, pen: Pen) -> Floats:
    """(n,) ink at 0 of bands between two places in px."""
    blur = max(pen.blur, _LEAST_BLUR)
    return pen.gain * (ndtr(high / blur) - ndtr(low / blur))


def _pixels(
    bundle: Sequence[_Strand], others: Sequence[Placed], sheet: CleanSheet, pen: Pen
) -> Floats:
    """(n, 2) pixels on and beside a bundle, clear of other strokes and of its own ends."""
    reach = pen.width / 2.0 + _BESIDE
    found = []
    for strand in bundle:
        for piece in strand.pieces:
            whole = is_full_circle(strand.geometry, piece)
            inset = 0.0 if whole else _AT_END
            along = np.arange(piece.start + inset, piece.end - inset, 1.0)
            if not len(along):
                continue
            normals = strand.geometry.tangents_at(along) @ np.array([[0.0, 1.0], [-1.0, 0.0]])
            across = np.arange(-np.ceil(reach), np.ceil(reach) + 1.0)
            points = strand.geometry.points_at(along)
            found.append((points[:, None] + across[:, None] * normals[:, None]).reshape(-1, 2))
    if not found:
        return np.empty((0, 2))
    pixels = np.unique(np.rint(np.concatenate(found)).astype(int), axis=0)
    height, width = sheet.weight.shape
    x, y = pixels.T
    pixels = pixels[(x >= 0) & (y >= 0) & (x < width) & (y < height)].astype(np.float64)
    if len(pixels) > _MOST:
        pixels = pixels[np.linspace(0, len(pixels) - 1, _MOST).astype(int)]
    clear = pen.width / 2.0 + _CLEAR
    for other in others:
        pixels = pixels[distances_to(other, pixels) > clear]
    for strand in bundle:
        for piece in strand.pieces:
            if is_full_circle(strand.geometry, piece):
                continue
            for tip in strand.geometry.points_at(np.array([piece.start, piece.end])):
                pixels = pixels[np.hypot(*(pixels - tip).T) > clear + _AT_END]
    return pixels
