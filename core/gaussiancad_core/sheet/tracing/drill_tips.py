"""Tips of blind bores: two short dashed lines from the ends of a bore's sides to a point between.

A tip is a few dashes long, and its dashes melt with those of the bore's bottom, with each other at
the point, and with whatever crosses it.  What is found of it by itself is an arc around the point,
or a leg too many.  But a bore tells where its tip is: only how high it is remains to be seen.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to

Floats = npt.NDArray[np.float64]

_PARALLEL = 0.9998
"""Cosine of the angle between a bore's sides at least."""

_LEVEL_PX = 2.5
"""px by which its sides may end beside each other."""

_NARROWEST, _WIDEST = 11.0, 60.0
"""px between them; tips of wider bores are found by themselves."""

_FLATTEST, _STEEPEST, _STEP = 0.4, 1.1, 0.02
"""Heights of tips that are tried, in the bore's radius (118 degrees: .6), and between them."""

_DASHED, _BLANK = 0.55, 0.3
"""Share of each flank that has ink at least, and of the paper beside it at most."""

_ASIDE = 2.0
"""px from a flank's edge where the paper is looked at."""

_SAME_PX = 1.5
"""px from the corners within which a flank that was found ends."""

_ASTRAY = 2.2
"""px by which a stroke may lie outside of a tip that is what the tip's ink was taken for."""

_MIDDLE, _FLANKED, _LEAST_BOTTOM = 0.2, 0.8, 0.35
"""Share of the bottom at either end that does not tell its level; share of the most ink across it
from which it is the bottom's; and share of it that has ink at least."""

_MOST = 400
"""Hidden lines of a view up to which bores are looked for."""

_CONFIDENCE = 0.6


@dataclass(frozen=True)
class _Bottom:
    """Where a bore's sides end.

    Attributes:
        sides: the two lines.
        corners: (2, 2) px.
        outward: (2,) unit vector along the sides, beyond their ends.
        ink: weight of the dashes of the sides.
    """

    sides: tuple[tuple[Line, Piece], tuple[Line, Piece]]
    corners: Floats
    outward: Floats
    ink: float

    @property
    def radius(self) -> float:
        return float(np.hypot(*(self.corners[1] - self.corners[0]))) / 2.0

    def tip(self, height: float) -> Floats:
        """(2,) px of the point so many radii beyond the bottom."""
        return self.corners.mean(axis=0) + height * self.radius * self.outward


def with_drill_tips(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces with the tips of bores, in the place of what their ink was taken for.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
    """
    found = list(pieces)
    for bottom in _bottoms(pieces, sheet):
        level = _on_its_ink(bottom, sheet)
        height = _height(level, sheet)
        if height is None:
            continue
        point = level.tip(height)
        flanks = [_line(corner, point) for corner in level.corners]
        base = _line(*level.corners)
        # The edge at the bottom melts with both flanks.
        lost = level is not bottom and not _is_known(base, found)
        if lost or not all(_is_known(flank, found) for flank in flanks):
            course = [*flanks, base]
            outline = np.array([*level.corners, point])
            found = [_met(pair, level) for pair in found if not _is_inside(outline, pair)]
            found += [pair for pair in course if not _is_known(pair, found)]
    return found


def _bottoms(pieces: Sequence[Placed], sheet: CleanSheet) -> Iterator[_Bottom]:
    """Where two hidden lines side by side end level with each other, and go no farther."""
    sides = [
        (line, piece)
        for line, piece in pieces
        if isinstance(line, Line) and piece.linetype is Linetype.HIDDEN
    ]
    if len(sides) > _MOST:
        return
    for (line, piece), (other, its) in combinations(sides, 2):
        direction = np.array(line.direction)
        if abs(float(direction @ other.direction)) < _PARALLEL:
            continue
        apart = abs(float(line.coordinates(np.array([other.point]))[1][0]))
        if not _NARROWEST <= apart <= _WIDEST:
            continue
        ends = np.array([line.at(piece.start), line.at(piece.end)])
        others = np.array([other.at(its.start), other.at(its.end)])
        if float((others[1] - others[0]) @ direction) < 0.0:
            others = others[::-1]
        for index, way in ((0, -1.0), (1, 1.0)):
            corners = np.array([ends[index], others[index]])
            if abs(float((corners[1] - corners[0]) @ direction)) > _LEVEL_PX:
                continue
            middle = corners.mean(axis=0) @ direction
            corners += (middle - corners @ direction)[:, None] * direction
            long = min(piece.end - piece.start, its.end - its.start)
            if long >= apart / 2.0:
                outward = way * direction
                ink = _ink(sheet, corners, -outward, long)
                yield _Bottom(((line, piece), (other, its)), corners, outward, ink)


def _ink(sheet: CleanSheet, corners: Floats, inward: Floats, long: float) -> float:
    """Weight of the dashes of a bore's sides."""
    places = corners[:, None] + np.arange(2.0, long)[:, None] * inward
    return float(np.percentile(sample(sheet.weight, places[..., 0], places[..., 1]), 80.0))


def _on_its_ink(bottom: _Bottom, sheet: CleanSheet) -> _Bottom:
    """A bottom where its own line is, whose dashes tell better than the ends of the sides."""
    first, last = bottom.corners
    # Towards its ends the flanks leave it slowly.
    margin = max(_MIDDLE, sheet.stroke_width / (2.0 * bottom.radius))
    shares = np.linspace(margin, 1.0 - margin, max(3, round(4.0 * bottom.radius)))
    places = first + shares[:, None] * (last - first)
    off = np.arange(-_LEVEL_PX, _LEVEL_PX + 0.25, 0.25)
    points = places + off[:, None, None] * bottom.outward
    ink = sample(sheet.weight, points[..., 0], points[..., 1]).mean(axis=1) / max(bottom.ink, 1e-6)
    best = int(np.argmax(ink))
    if ink[best] < _LEAST_BOTTOM or best in (0, len(off) - 1):
        return bottom
    near = ink > _FLANKED * ink[best]
    shift = float(np.average(off[near], weights=ink[near]))
    return replace(bottom, corners=bottom.corners + shift * bottom.outward)


def _met(pair: Placed, bottom: _Bottom) -> Placed:
    """A piece, one of the bore's sides as far as its bottom."""
    line, piece = pair
    for (side, its), corner in zip(bottom.sides, bottom.corners, strict=True):
        if line is side and piece is its:
            at = float(side.positions(corner[None])[0])
            outwards = float(np.dot(side.direction, bottom.outward)) > 0.0
            return line, replace(piece, end=at) if outwards else replace(piece, start=at)
    return pair


def _height(bottom: _Bottom, sheet: CleanSheet) -> float | None:
    """Of the tip, in radii; None where there is no ink of it alone on both sides."""
    if bottom.ink <= 0.0:
        return None
    heights = np.arange(_FLATTEST, _STEEPEST, _STEP)
    worth = np.zeros(len(heights))
    for k, height in enumerate(heights):
        shares = [_shares(corner, bottom, float(height), sheet) for corner in bottom.corners]
        if (
            min(share[0] for share in shares) >= _DASHED
            and max(share[1] for share in shares) <= _BLANK
        ):
            worth[k] = sum(share[0] - share[1] for share in shares)
    best = int(np.argmax(worth))
    # What has more ink the flatter it is, or the steeper, is another stroke's.
    return float(heights[best]) if 0 < best < len(heights) - 1 and worth[best] > 0.0 else None


def _shares(
    corner: Floats, bottom: _Bottom, height: float, sheet: CleanSheet
) -> tuple[float, float]:
    """How much of a flank has ink, and of the paper outside of it, 0 to 1."""
    way = bottom.tip(height) - corner
    long = float(np.hypot(*way))
    way = way / long
    # At both ends its ink is that of others, too.
    margin = sheet.stroke_width
    along = np.arange(margin, max(long - margin / 2.0, margin + 1.0), 0.5)
    places = corner + along[:, None] * way
    outside = bottom.outward - float(bottom.outward @ way) * way
    outside = outside / np.hypot(*outside)
    neighbour = places + (sheet.stroke_width / 2.0 + _ASIDE) * outside
    ink, paper = (
        np.clip(
            sample(sheet.weight, item[None, :, 0], item[None, :, 1])[0] / bottom.ink,
            0.0,
            1.0,
        )
        for item in (places, neighbour)
    )
    return float(ink.mean()), float(paper.mean())


def _line(start: Floats, end: Floats) -> Placed:
    long = float(np.hypot(*(end - start)))
    way = (end - start) / long
    line = Line((float(start[0]), float(start[1])), (float(way[0]), float(way[1])))
    return line, Piece(0.0, long, Linetype.HIDDEN, _CONFIDENCE)


def _is_known(flank: Placed, pieces: Sequence[Placed]) -> bool:
    """Whether lines that were found cover a flank, from one of its ends to the other."""
    line, piece = flank
    ends = line.points_at(np.array([piece.start, piece.end]))
    lines = [this_piece for this_piece in pieces if isinstance(this_piece[0], Line)]
    if any(distances_to(this_line, ends).max() < _SAME_PX for this_line in lines):
        return True
    near = [
        this_line for this_line in lines if distances_to(flank, _ends(this_line)).max() < _SAME_PX
    ]
    return all(
        any(float(np.hypot(*(_ends(pair) - end).T).min()) < _SAME_PX for pair in near)
        for end in ends
    )


def _ends(placed: Placed) -> Floats:
    geometry, piece = placed
    return geometry.points_at(np.array([piece.start, piece.end]))


def _is_inside(outline: Floats, pair: Placed) -> bool:
    """Whether all of a piece lies in a tip, (3, 2) corners, whose ink it was taken from."""
    geometry, piece = pair
    count = max(3, int(piece.end - piece.start))
    points = geometry.points_at(np.linspace(piece.start, piece.end, count))
    ways = np.roll(outline, -1, axis=0) - outline
    ways /= np.hypot(*ways.T)[:, None]
    normals = np.stack([-ways[:, 1], ways[:, 0]], axis=1)
    # The normals point inwards on one side of the turn, outwards on the other.
    normals *= np.sign(normals[0] @ (outline[2] - outline[0]))
    inwards = ((points[:, None] - outline) * normals).sum(axis=2)
    return bool(inwards.min() > -_ASTRAY)
