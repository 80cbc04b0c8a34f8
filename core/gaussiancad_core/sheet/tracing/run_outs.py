"""Run-outs: ends of an outline that rise from their line by a few pixels, to a corner.

A keyway with round ends lowers the outline of its shaft; along the round end the edge comes back to
the outline as a flat arc that is tangent to the lower line.  Too flat to be grown, its ink was an
end of that line, or a chord, and the short rest of the outline beyond the corner was lost.  A step
of little more than a pixel was not seen at all: one line was drawn through.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import LEVEL
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import refit_line, sample
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.tracing.rising_ends import (
    BEFORE,
    LEAST,
    ROOM,
    STEP,
    End,
    RunOut,
    crossings,
    find_run_out,
)

Floats = npt.NDArray[np.float64]

_LONG = 20.0
"""px of a line that may end so."""

_FAR, _MOST_STEP, _BLANK = 60.0, 3.0, 0.15
"""px before the corner in which its lower level is; px between the two levels at most; ink up to
which a place is blank."""

_LEADS_ON = 0.5
"""Cosine of the angle from which a stroke goes on as the outline, not across it."""

_REACHED = 4.0
"""px by which the stroke at the corner may end before it or behind it."""

_FLAT, _FLAT_LONG = 0.5, 3.0
"""px by which the outline may be off beyond the corner, and px of it that tell."""

_ALONG, _ASTRAY = 1.3, 2.2
"""px from the arc within which a stroke runs along it, and within which all of a stroke is what the
ink of the arc and of the outline beyond it was taken for."""

_KNOWN = 2.0
"""px from the middle of the arc, or from its corner, within which there is no other curve."""

_CONFIDENCE = 0.7


def with_run_outs(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces with the arcs of run-outs, and the outline on the other side of their corners.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
    """
    found = list(pieces)
    for placed in pieces:
        pair = placed
        for way in (1.0, -1.0):
            current = _current(pair, found)
            if current is None:
                continue
            line, piece = current
            end = End(line, piece, piece.end if way > 0.0 else piece.start, way)
            rise = find_run_out(end, sheet, found)
            if rise is not None and not _is_known(end, rise, found):
                end, rise = _on_own_ink(end, rise, sheet, found)
                found = [(end.line, p) if p is piece else (g, p) for g, p in found]
                found = _drawn(end, rise, sheet, found)
                pair = end.line, piece
    return with_steps_parted(found, sheet)


def with_steps_parted(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces, lines parted that step within their own ink, with the arcs that lead there."""
    found, todo = list(pieces), list(pieces)
    while todo:
        current = _current(todo.pop(), found)
        if current is None or min(abs(value) for value in current[0].direction) > LEVEL:
            continue
        parted = _parted(current, sheet, found)
        if parted is not None:
            found, new = parted
            todo += new
    return found


def _current(placed: Placed, found: Sequence[Placed]) -> tuple[Line, Piece] | None:
    """What a piece is now, if it is a visible line that may end in a run-out."""
    geometry, piece = placed
    if not isinstance(geometry, Line):
        return None
    middle = 0.5 * (piece.start + piece.end)
    for other, this_piece in found:
        if other is geometry and this_piece.start <= middle <= this_piece.end:
            long = (
                this_piece.end - this_piece.start >= _LONG
                and this_piece.linetype is Linetype.VISIBLE
            )
            return (other, this_piece) if long else None
    return None


def _is_known(end: End, rise: RunOut, pieces: Sequence[Placed]) -> bool:
    """Whether the rise is a curve that was found."""
    middle = end.points(
        np.array([0.5 * (rise.foot + rise.corner), rise.corner]),
        np.array([0.25 * rise.height, rise.height]),
    )
    curves = (piece for piece in pieces if not isinstance(piece[0], Line))
    return any(bool((distances_to(curve, middle) < _KNOWN).any()) for curve in curves)


def _parted(
    placed: tuple[Line, Piece], sheet: CleanSheet, pieces: Sequence[Placed]
) -> tuple[list[Placed], list[Placed]] | None:
    """The pieces with one parted at the first stroke where it steps, and its parts."""
    line, piece = placed
    whole = End(line, piece, piece.start, 1.0)
    for corner in crossings(whole, pieces, 0.0, LEAST, piece.end - piece.start):
        for way in (1.0, -1.0):
            step = _step_at(line, piece, piece.start + corner, way, sheet)
            if step is None:
                continue
            end, high = step
            parts: list[Placed] = [(end.line, end.piece), high]
            rest = [
                this_piece
                for this_piece in pieces
                if this_piece[0] is not line or this_piece[1] is not piece
            ]
            rise = find_run_out(end, sheet, rest)
            if rise is not None and not _is_known(end, rise, rest):
                return _drawn(end, rise, sheet, [*rest, *parts]), parts
    return None


def _step_at(
    line: Line, piece: Piece, corner: float, way: float, sheet: CleanSheet
) -> tuple[End, Placed] | None:
    """The part of a line before a place along it, seen one way, and that behind it, if these are
    not on one level."""
    axis = np.rint(line.direction)
    x, y = line.at(corner)
    level = Line((x, y), (float(axis[0]), float(axis[1])))
    hidden = 0.5 * sheet.stroke_width + 0.5 * ROOM
    room = [way * (value - corner) for value in (piece.start, piece.end)]
    before, after = max(0.0, -min(room)), max(0.0, *room)
    if before < _LONG or after < hidden + _FLAT_LONG:
        return None
    low = _levels(level, -way * np.arange(hidden, min(before - hidden, _FAR)), sheet)
    high = _levels(level, way * np.arange(hidden, min(after - hidden, _LONG)), sheet)
    if len(low) < _LONG / 2.0 or len(high) < _FLAT_LONG:
        return None
    top = float(np.median(high))
    ends = np.percentile(low, (10.0, 90.0))
    base = float(ends[np.argmax(np.abs(ends - top))])
    if not LEAST <= abs(base - top) <= _MOST_STEP:
        return None
    back = min(BEFORE, 0.5 * before)
    spans = sorted((-way * before, -way * back)), sorted((0.0, way * after))
    lines = [replace(level, point=tuple(_beside(level, value))) for value in (base, top)]
    parts = [Piece(start, end, piece.linetype, piece.confidence) for start, end in spans]
    return End(lines[0], parts[0], -way * back, way), (lines[1], parts[1])


def _beside(line: Line, shift: float) -> Floats:
    """(2,) px of the point of a line, moved to its left."""
    dx, dy = line.direction
    return np.array(line.point) + shift * np.array([-dy, dx])


def _levels(line: Line, places: Floats, sheet: CleanSheet) -> Floats:
    """(n,) px to the left of a line of the centre of the ink, where that is one stroke's alone."""
    reach = 0.5 * sheet.stroke_width + ROOM + _MOST_STEP
    offsets = np.arange(-reach, reach + STEP, STEP)
    dx, dy = line.direction
    points = line.points_at(places)[:, None] + offsets[:, None] * np.array([-dy, dx])
    ink = sample(sheet.weight, points[..., 0], points[..., 1])
    total = ink.sum(axis=1)
    single = (np.maximum(ink[:, 0], ink[:, -1]) < _BLANK) & (
        total * STEP > 0.5 * sheet.stroke_width
    )
    return (ink @ offsets)[single] / total[single]


def _drawn(end: End, rise: RunOut, sheet: CleanSheet, pieces: Sequence[Placed]) -> list[Placed]:
    """The pieces with a run-out drawn."""
    arc = _arc(end, rise)
    corner = end.points(np.array(rise.corner), np.array(rise.height))
    beyond = _outline_beyond(end, rise, sheet, pieces)
    course = [arc] if beyond is None else [arc, beyond]
    found: list[Placed] = []
    for geometry, piece in pieces:
        if geometry is end.line and piece is end.piece:
            cut = end.at + end.way * rise.foot
            shorter = replace(piece, end=cut) if end.way > 0.0 else replace(piece, start=cut)
            found.append((geometry, shorter))
        elif not _is_within(course, (geometry, piece)):
            found.append(_met(geometry, piece, corner, end))
    if beyond is not None and any(_is_within([pair], beyond, _ALONG) for pair in found):
        return [*found, arc]
    return [*found, *course]


def _on_own_ink(
    end: End, rise: RunOut, sheet: CleanSheet, pieces: Sequence[Placed]
) -> tuple[End, RunOut]:
    """The line fitted to its ink up to where it rises, and its rise: that ink pulled it aside."""
    cut = end.at + end.way * rise.foot
    first, last = (end.piece.start, cut) if end.way > 0.0 else (cut, end.piece.end)
    margin = sheet.stroke_width
    if last - first < _LONG + 2.0 * margin:
        return end, rise
    line = refit_line(sheet, end.line, [(first + margin, last - margin)])
    better = replace(end, line=line)
    again = find_run_out(better, sheet, pieces)
    return (end, rise) if again is None else (better, again)


def _is_within(course: Sequence[Placed], pair: Placed, away: float = _ASTRAY) -> bool:
    """Whether all of a piece is what the ink of others was taken for."""
    geometry, piece = pair
    length = piece.end - piece.start
    if length > sum(part.end - part.start for _, part in course) + 2.0 * _REACHED:
        return False
    points = geometry.points_at(np.linspace(piece.start, piece.end, max(3, int(length))))
    return bool(np.min([distances_to(part, points) for part in course], axis=0).max() < away)


def _met(geometry: WholeCurve, piece: Piece, corner: Floats, end: End) -> Placed:
    """A stroke that ends at the corner, exactly there."""
    if not isinstance(geometry, Line):
        return geometry, piece
    at, away = (float(coordinate[0]) for coordinate in geometry.coordinates(corner[None]))
    if abs(away) > _ALONG:
        return geometry, piece
    cosine = end.way * float(np.dot(geometry.direction, end.line.direction))
    # What goes on as the outline begins there, however far it was drawn back.
    back = _REACHED if abs(cosine) < _LEADS_ON else np.inf
    if -_REACHED <= at - piece.start <= back and cosine > -_LEADS_ON and at < piece.end:
        return geometry, replace(piece, start=at)
    if -_REACHED <= piece.end - at <= back and cosine < _LEADS_ON and at > piece.start:
        return geometry, replace(piece, end=at)
    return geometry, piece


def _outline_beyond(
    end: End, rise: RunOut, sheet: CleanSheet, pieces: Sequence[Placed]
) -> Placed | None:
    """The line from the corner on, as high as it, to the next stroke; None where no ink is."""
    half = 0.5 * sheet.stroke_width
    across = crossings(end, pieces, rise.height, LEAST, rise.corner + _FAR)
    last = next((value for value in across if value > rise.corner + 2.0 * half), None)
    if last is None:
        return None
    places = np.arange(rise.corner + half + 1.0, last - half - 1.0, 1.0)
    if len(places) < _FLAT_LONG:
        return None
    offsets = np.arange(-half - ROOM, half + ROOM + STEP, STEP)
    points = end.points(places[:, None], rise.height + offsets)
    ink = sample(sheet.weight, points[..., 0], points[..., 1])
    total = ink.sum(axis=1)
    if (total * STEP < half).any():
        return None
    centre = float(np.median((ink @ offsets) / total))
    if abs(centre) > _FLAT:
        return None
    start, stop = end.points(np.array([rise.corner, last]), np.full(2, rise.height + centre))
    way = (stop - start) / np.hypot(*(stop - start))
    line = Line((float(start[0]), float(start[1])), (float(way[0]), float(way[1])))
    return line, Piece(0.0, last - rise.corner, Linetype.VISIBLE, _CONFIDENCE)


def _arc(end: End, rise: RunOut) -> Placed:
    """The arc that is tangent to the line at the foot and ends at the corner."""
    long = rise.corner - rise.foot
    radius = (long**2 + rise.height**2) / (2.0 * rise.height)
    centre = end.points(np.array(rise.foot), np.array(radius))
    circle = Circle((float(centre[0]), float(centre[1])), abs(float(radius)))
    ends = end.points(np.array([rise.foot, rise.corner]), np.array([0.0, rise.height]))
    first, last = (float(position) for position in circle.positions(ends))
    if (last - first) % circle.around > circle.around / 2.0:
        first, last = last, first
    stop = first + (last - first) % circle.around
    return circle, Piece(first, stop, Linetype.VISIBLE, _CONFIDENCE)
