"""Bows: stretches on which an outline leaves its line by a pixel or two, and comes back.

At the mouth of a bore the outline of a shaft bows in.  Such an arc is too flat to be grown: its ink
lies under the line's course for a while, and what is left between both ends is a sliver.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    BLANK,
    COURSE,
    FEWEST_PLACES,
    FINE_STEP,
    INFERRED,
    NARROWEST,
    WIDEST,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.votes import LARGELY

Floats = npt.NDArray[np.float64]

_LEAVES = 0.4
"""px beside a line from which the centre of its ink is on its way elsewhere."""

_LEAST, _MOST = 1.0, 4.0
"""px by which a bow leaves the line: less may be the pen's, and more is an arc that is grown."""

_SHORTEST, _LONGEST = 8.0, 80.0
"""px of a bow along its line."""

_OVERRUN = 1.7
"""Times the length of a bow up to which an arc along it was grown from its ink."""

_NEAR = 3.0
"""px from a foot of the parabola to the stroke at which the bow ends."""

_FOOT = 0.15
"""Share of a bow by which its feet may lie beyond the pieces of its line."""

_ASTRAY, _BESIDE = 2.5, 0.97
"""px from a bow and its line within which all of another line is their ink; cosine of the angle
between the two lines at least."""


def with_bows(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces with the arcs of bows, and lines that end where these begin.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
    """
    found = list(pieces)
    for line in dict.fromkeys(this_line for this_line, _ in pieces if isinstance(this_line, Line)):
        drawn = [piece for item, piece in pieces if item == line and _may_be_visible(piece)]
        others = [piece for piece in pieces if piece[0] != line]
        for start, end in _spans(drawn):
            for first, last, arc in _bows(line, (start, end), sheet, others):
                found = [pair for pair in found if not _is_same(pair, arc)]
                found = [part for pair in found for part in _without(pair, line, (first, last))]
                found = [pair for pair in found if not _is_chord(pair, line, arc, found)]
                found.append(arc)
    return found


def _may_be_visible(piece: Piece) -> bool:
    """Whether a piece is visible, or what was seen of a bow between two that are."""
    return piece.linetype is Linetype.VISIBLE or piece.end - piece.start <= _LONGEST


def _is_same(pair: Placed, arc: Placed) -> bool:
    """Whether a piece is an arc that was grown along another one."""
    geometry, piece = pair
    if not isinstance(geometry, Circle) or piece.linetype is not Linetype.VISIBLE:
        return False
    middle = geometry.points_at(np.array([(piece.start + piece.end) / 2.0]))
    longer = _OVERRUN * (arc[1].end - arc[1].start)
    return bool(distances_to(arc, middle)[0] < _LEAST) and piece.end - piece.start < longer


def _is_chord(pair: Placed, line: Line, arc: Placed, pieces: Sequence[Placed]) -> bool:
    """Whether a piece is a line that was grown from ink of a bow, and of its line beside that."""
    geometry, piece = pair
    if not isinstance(geometry, Line) or geometry == line:
        return False
    cosine = abs(float(np.dot(geometry.direction, line.direction)))
    if piece.end - piece.start < _SHORTEST or cosine < _BESIDE:
        return False
    course = [arc, *(other for other in pieces if other[0] == line)]
    points = geometry.points_at(np.linspace(piece.start, piece.end, int(piece.end - piece.start)))
    away = np.array([distances_to(other, points) for other in course])
    # What lies along the line alone is another's business.
    along = bool((away[0] < _ASTRAY).any())
    return along and float(away.min(axis=0).max()) < _ASTRAY


def _spans(drawn: Sequence[Piece]) -> Iterator[tuple[float, float]]:
    """From where to where pieces of a line follow each other, with gaps as wide as a bow."""
    order = sorted(drawn, key=lambda piece: piece.start)
    visible = [k for k, piece in enumerate(order) if piece.linetype is Linetype.VISIBLE]
    if not visible:
        return
    order = order[visible[0] : visible[-1] + 1]
    start = order[0].start
    for before, after in pairwise(order):
        if after.start - before.end > _LONGEST:
            yield start, before.end
            start = after.start
    yield start, order[-1].end


def _bows(
    line: Line, span: tuple[float, float], sheet: CleanSheet, others: Sequence[Placed]
) -> Iterator[tuple[float, float, Placed]]:
    """Where bows begin and end along a line, and their arcs."""
    at, off = _centres(sheet, line, span)
    away = np.concatenate([[False], np.abs(off) > _LEAVES, [False]])
    for low, high in np.flatnonzero(np.diff(away.astype(int))).reshape(-1, 2):
        places, adjacent = at[low:high], off[low:high]
        length = float(np.ptp(places))
        if not _SHORTEST <= length <= _LONGEST or len(places) < LARGELY * length:
            continue
        bend, slope, shift = np.polyfit(places, adjacent, 2)
        even = np.abs(np.polyval((bend, slope, shift), places) - adjacent) <= COURSE
        if even.sum() >= FEWEST_PLACES:
            # The ink of what ends there is in that of the bow's ends.
            bend, slope, shift = np.polyfit(places[even], adjacent[even], 2)
            even = np.abs(np.polyval((bend, slope, shift), places) - adjacent) <= COURSE
        if even.mean() < LARGELY or bend == 0.0:
            continue
        top = -slope / (2.0 * bend)
        height = shift - bend * top**2
        if not _LEAST <= abs(height) <= _MOST or bend * height >= 0.0:
            continue
        # Ink that only leaves the line, as before a corner, may follow a bow far from there.
        if not places[0] <= top <= places[-1]:
            continue
        half = float(np.sqrt(-height / bend))
        ends = [_foot(line, float(top) + way * half, others) for way in (-1.0, 1.0)]
        room = _FOOT * 2.0 * half
        if span[0] - room <= ends[0] < ends[1] <= span[1] + room:
            yield ends[0], ends[1], _arc(line, (ends[0], ends[1]), float(height))


def _centres(sheet: CleanSheet, line: Line, span: tuple[float, float]) -> tuple[Floats, Floats]:
    """(n,) px along a line and to its left, of the centre of what ink is beside it, where that is
    one stroke alone."""
    along = np.arange(span[0], span[1] + 0.5)
    reach = sheet.stroke_width / 2.0 + _MOST + 1.0
    offsets = np.arange(-reach, reach + FINE_STEP, FINE_STEP)
    normal = np.array([-line.direction[1], line.direction[0]])
    points = line.points_at(along)
    profile = sample(
        sheet.weight,
        points[:, :1] + offsets * normal[0],
        points[:, 1:] + offsets * normal[1],
    )
    total = profile.sum(axis=1) * FINE_STEP
    inked = profile > BLANK
    strokes = (np.diff(inked.astype(int), axis=1, prepend=0) == 1).sum(axis=1)
    alone = (strokes == 1) & ~inked[:, 0] & ~inked[:, -1]
    alone &= (total > NARROWEST * sheet.stroke_width) & (total < WIDEST * sheet.stroke_width)
    centre = (profile[alone] * offsets).sum(axis=1) * FINE_STEP / total[alone]
    return along[alone], centre


def _foot(line: Line, at: float, others: Sequence[Placed]) -> float:
    """Where a stroke crosses a line near a position, or that position."""
    found = []
    for geometry, piece in others:
        if not isinstance(geometry, Line):
            continue
        (dx, dy), (ex, ey) = line.direction, geometry.direction
        sine = dx * ey - dy * ex
        if abs(sine) < 0.5:
            continue
        x, y = np.subtract(geometry.point, line.point)
        crossing = (x * ey - y * ex) / sine
        position = float(geometry.positions(np.array([line.at(crossing)]))[0])
        if piece.start - _NEAR <= position <= piece.end + _NEAR:
            found.append(float(crossing))
    nearest = min(found, key=lambda value: abs(value - at), default=at)
    return nearest if abs(nearest - at) <= _NEAR else at


def _arc(line: Line, ends: tuple[float, float], height: float) -> Placed:
    """The arc over a stretch of a line that leaves it by so many px to its left."""
    half = (ends[1] - ends[0]) / 2.0
    radius = (half**2 + height**2) / (2.0 * abs(height))
    normal = np.array([-line.direction[1], line.direction[0]])
    middle = np.array(line.at((ends[0] + ends[1]) / 2.0))
    centre = middle + np.sign(height) * (abs(height) - radius) * normal
    circle = Circle((float(centre[0]), float(centre[1])), float(radius))
    first, last = circle.positions(line.points_at(np.array(ends)))
    if (last - first) % circle.around > circle.around / 2.0:
        first, last = last, first
    end = first + (last - first) % circle.around
    return circle, Piece(float(first), float(end), Linetype.VISIBLE, INFERRED)


def _without(pair: Placed, line: Line, stretch: tuple[float, float]) -> Iterator[Placed]:
    """A piece without a stretch of its line."""
    geometry, piece = pair
    if geometry != line or piece.end <= stretch[0] or piece.start >= stretch[1]:
        yield pair
        return
    if stretch[0] - piece.start > 1.0:
        yield geometry, replace(piece, end=stretch[0])
    if piece.end - stretch[1] > 1.0:
        yield geometry, replace(piece, start=stretch[1])
