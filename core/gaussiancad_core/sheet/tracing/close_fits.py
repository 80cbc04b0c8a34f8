"""Lines close beside each other, fitted together.

Less than about a line width of paper lies between them, and the blurred ink of each pulls the fit
of the other one, by up to half a pixel.  So all lines of such a bundle are moved at once until what
a pen draws along them is the ink that the sheet has (analysis by synthesis); where bands of ink
overlap, they are one.  Visible concentric circles are fitted like lines, and so are hidden lines,
where their dashes are.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt
from scipy.special import ndtr

from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    AROUND,
    CLOSER,
    DARK,
    DASH_END,
    EVEN,
    FEWEST_PIXELS,
    FINE_STEP,
    ONE_PLACE,
)
from gaussiancad_core.sheet.tracing.close_strands import Strand, find_bundles, scaled
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, runs_of_ink
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.junctions import is_full_circle
from gaussiancad_core.sheet.tracing.leftover import dash_pen
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.tracing.pen_profile import Pen, visible_pen
from gaussiancad_core.sheet.work_limits import PLACES

Floats = npt.NDArray[np.float64]

_CLEAR, _AT_END = 1.5, 3.0
"""px from the ink of other strokes, and from where one of the bundle ends."""

_LEAST_BLUR = 0.35
"""px by which the edge of ink is blurred at least: pixels are no points, and what has no slope
leads nowhere."""


def with_close_fits(
    pieces: Sequence[Placed], ended: Sequence[Placed], sheet: CleanSheet
) -> list[Placed]:
    """The pieces with the lines and circles of bundles where they were drawn.

    Args:
        pieces: of a view; px, pixel centres at integers.
        ended: the same ones with their ends at junctions.
        sheet: the view's ink.
    """
    bundles = find_bundles(ended, sheet.stroke_width)
    if not bundles:
        return list(pieces)
    pens = {
        Linetype.VISIBLE: visible_pen(sheet.weight, ended, sheet.stroke_width),
        Linetype.HIDDEN: dash_pen(ended, sheet),
    }
    better: dict[WholeCurve, WholeCurve] = {}
    for bundle in bundles:
        items = {strand.geometry for strand in bundle}
        others = [placed for placed in ended if placed[0] not in items]
        for strand, fitted in zip(bundle, _fitted(bundle, others, sheet, pens), strict=True):
            better[strand.geometry] = fitted.geometry
    return [
        (better.get(item, item), _as_long(item, better.get(item, item), p)) for item, p in pieces
    ]


def _as_long(before: WholeCurve, after: WholeCurve, piece: Piece) -> Piece:
    if isinstance(before, Circle) and isinstance(after, Circle):
        return scaled(piece, after.radius / before.radius)
    return piece


def _fitted(
    bundle: Sequence[Strand],
    others: Sequence[Placed],
    sheet: CleanSheet,
    pens: Mapping[Linetype, Pen],
) -> list[Strand]:
    """The strands as the ink has them; as they are where it does not tell."""
    from scipy.optimize import least_squares

    bundle = [_dashed(strand, sheet, pens) for strand in bundle]
    pixels = _pixels(bundle, others, sheet, pens[Linetype.VISIBLE])
    if len(pixels) < FEWEST_PIXELS:
        return list(bundle)
    ink = sheet.weight[pixels[:, 1].astype(int), pixels[:, 0].astype(int)].astype(np.float64)
    facing = _facing(bundle[0])
    free = [[0, 1, 2] if isinstance(strand.geometry, Circle) else [0, 1] for strand in bundle]
    own_pens = [pens[strand.kind] for strand in bundle]
    places = [3 * k + at for k, items in enumerate(free) for at in items]

    def strands(values: Floats) -> list[Strand]:
        moves = np.zeros(3 * len(bundle))
        moves[places] = values * scales
        return [strand.moved(moves[3 * k : 3 * k + 3]) for k, strand in enumerate(bundle)]

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
        adjacent = np.stack([strand.offsets(pixels, facing) for strand in strands(values)])
        return _inked(adjacent, own_pens) - ink

    start = np.zeros(len(places))
    before = float(np.square(residual(start)).sum())
    found = least_squares(residual, start, bounds=(-ONE_PLACE, ONE_PLACE), diff_step=1e-3)
    after = float(np.square(found.fun).sum())
    if after > CLOSER * before or np.abs(found.x).max() > 0.99 * ONE_PLACE:
        return list(bundle)
    fitted = strands(found.x)
    for this_strand, pen in zip(fitted, own_pens, strict=True):
        near = np.abs(this_strand.offsets(pixels, facing)) <= pen.width / 2.0 + ONE_PLACE
        # What bends away from its line was none.
        if near.any() and float(np.abs(found.fun[near]).mean()) > EVEN:
            return list(bundle)
    return fitted


def _facing(strand: Strand) -> Floats:
    if isinstance(strand.geometry, Circle):
        return np.zeros(2)
    x, y = strand.geometry.direction
    return np.array([-y, x])


def _dashed(strand: Strand, sheet: CleanSheet, pens: Mapping[Linetype, Pen]) -> Strand:
    """A hidden strand with its dashes, where its ink is more than half of the pen's."""
    if strand.kind is Linetype.VISIBLE:
        return strand
    dark = DARK * float(pens[Linetype.HIDDEN].ink(np.zeros(1))[0])
    dashes = []
    for piece in strand.pieces:
        along = np.arange(piece.start, piece.end, FINE_STEP)
        points = strand.geometry.points_at(along)
        ink = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0]
        dashes += [(float(along[a]), float(along[b])) for a, b in runs_of_ink(ink > dark)]
    return replace(strand, dashes=tuple(dashes))


def _inked(adjacent: Floats, pens: Sequence[Pen]) -> Floats:
    """(k, n) px by which k strands lie beside n pixels -> (n,) ink of the bands together."""
    total = np.zeros(adjacent.shape[1])
    reached = np.full(adjacent.shape[1], -np.inf)
    half, gain, blur = (
        np.array(items)[:, None]
        for items in (
            [pen.width / 2.0 for pen in pens],
            [pen.gain for pen in pens],
            [max(pen.blur, _LEAST_BLUR) for pen in pens],
        )
    )
    order = np.argsort(adjacent, axis=0)
    for rank in order:
        centre = np.take_along_axis(adjacent, rank[None], axis=0)[0]
        wide, dark, soft = (values[rank, 0] for values in (half, gain, blur))
        low, high = np.maximum(centre - wide, reached), centre + wide
        inside = np.isfinite(centre) & (high > low)
        ends = ndtr(high[inside] / soft[inside]), ndtr(low[inside] / soft[inside])
        total[inside] += dark[inside] * (ends[0] - ends[1])
        reached = np.where(inside, high, reached)
    return total


def _pixels(
    bundle: Sequence[Strand], others: Sequence[Placed], sheet: CleanSheet, pen: Pen
) -> Floats:
    """(n, 2) pixels on and beside a bundle, clear of other strokes and of its own ends."""
    reach = pen.width / 2.0 + AROUND
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
    if len(pixels) > PLACES:
        pixels = pixels[np.linspace(0, len(pixels) - 1, PLACES).astype(int)]
    clear = pen.width / 2.0 + _CLEAR
    for other in others:
        pixels = pixels[distances_to(other, pixels) > clear]
    for strand in bundle:
        for tip in (tip for dash in strand.dashes or () for tip in dash):
            # A dash leaves off within a few px.
            along, across = strand.line.coordinates(pixels)
            pixels = pixels[(np.abs(along - tip) > DASH_END) | (np.abs(across) > clear)]
        for piece in strand.pieces:
            if is_full_circle(strand.geometry, piece):
                continue
            for tip in strand.geometry.points_at(np.array([piece.start, piece.end])):
                pixels = pixels[np.hypot(*(pixels - tip).T) > clear + _AT_END]
    return pixels
