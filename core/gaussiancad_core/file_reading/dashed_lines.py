"""Dashed lines and circles that a file draws dash by dash, put together.

Short pieces of one pen in line, at a rhythm, are one line: a hidden one where its dashes are of one
length, a centre line where long and short ones take turns (ISO 128-2).
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.files.vectors import StrokeRole
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.near_points import near_lists, near_pairs
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Points

_SHORTEST, _LONGEST = 0.05, 12.0
"""mm of a dash."""

_BESIDE = 0.03
"""mm that dashes of one line lie beside each other at most."""

_SMALLEST_GAP, _LARGEST_GAP = 0.15, 4.0
"""mm between dashes."""

_GAP_OF_DASH, _GAP_BESIDES = 1.6, 0.6
"""A gap at most, in the longer of the dashes beside it, and mm besides."""

_FEWEST, _FEWEST_NAMED = 3, 2
"""Dashes of a line, and of one that its file calls dashed."""

_EVEN_GAPS, _LEAST_GAP = 2.2, 0.3
"""The largest gap in the usual one, which counts as so many mm at least."""

_SHORT = 0.6
"""Short dashes of a centre line in its long ones at most."""

_ALIKE, _ALIKE_OF_THREE, _LONGEST_OF_THREE = 1.5, 1.3, 6.0
"""The longest dash of a hidden line in its shortest at most; where there are but three, and mm that
these have at most."""

_LEAST_CUT = 0.3
"""Dashes at the ends of a line of three in the whole one between them at least."""

_LOOSE, _LEAST_FREE = 0.08, 0.5
"""mm from the ends of a dash to those of others at least, for it to touch nothing; share of the
dashes of a line that touch nothing at either end."""

_RING_PIECE = 5.0
"""mm of a dash of a circle at most."""

_RING_NEAR, _RING_NEIGHBOURS = 8.0, 6
"""mm within which a dash's neighbours are asked, and how many of them."""

_RADII = (0.8, 150.0)
"""mm of a dashed circle's radius."""

_RING_OFF, _RING_ON, _RING_BOW = 0.03, 0.05, 0.35
"""mm by which the ends of two dashes and of the others lie beside their circle, and share of the
radius, of 1 mm at most, that their middles do."""

_RING_FEWEST, _RING_MOST = 5, 1500
"""Dashes of a circle at least; of a pen that may have any at most."""

_RING_SHOWN, _RING_OPEN = 0.6, 3.0
"""Radians that the dashes of an arc span at least; a gap in the usual one from which it is open."""


def with_dashed_lines(labelled: LabelledStrokes) -> LabelledStrokes:
    """The strokes with whole lines and circles in place of dashes that nothing is said of yet."""
    is_open = [n for n in labelled.numbers(Label.OPEN) if not labelled.strokes[n].dashes]
    loose = set(_loose(labelled.strokes, is_open))
    pieces, lines = _lines(labelled.strokes, is_open, loose)
    loose -= pieces
    rest = [
        number
        for number in is_open
        if number in loose and labelled.strokes[number].length < _RING_PIECE
    ]
    ring_pieces, rings = _rings(labelled.strokes, rest)
    reason = "dash of a line or circle"
    return labelled.joined([*pieces, *ring_pieces], [*lines, *rings], reason)


@dataclass(frozen=True)
class _Dash:
    """A piece of a line: where it lies along that and beside it, mm, and its number."""

    start: float
    end: float
    offset: float
    number: int

    @property
    def length(self) -> float:
        return self.end - self.start


def _lines(
    strokes: Sequence[PaperStroke], numbers: Sequence[int], loose: Set[int]
) -> tuple[set[int], list[PaperStroke]]:
    """Numbers of dashes, and the lines that they are.

    Edges of a comb are in line at even gaps, too: unless their file names them, most dashes touch
    nothing at either end.
    """
    by_way = defaultdict(list)
    for number in numbers:
        stroke = strokes[number]
        if stroke.is_line and _SHORTEST < stroke.length < _LONGEST:
            angle = round(float(np.degrees(np.arctan2(stroke.way[1], stroke.way[0]))), 1) % 180.0
            by_way[stroke.pen, stroke.role, angle].append(number)
    pieces: set[int] = set()
    found = []
    for (_, role, angle), alike in by_way.items():
        is_named = role in (StrokeRole.HIDDEN, StrokeRole.CENTRE)
        fewest = _FEWEST_NAMED if is_named else _FEWEST
        if len(alike) < fewest:
            continue
        along = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        for row in _rows(strokes, alike, along):
            kind = role if is_named and len(row) >= fewest else _rhythm(row)
            free = sum(dash.number in loose for dash in row)
            if kind is not None and (is_named or free > _LEAST_FREE * len(row)):
                pieces |= {dash.number for dash in row}
                found.append(_whole(strokes[row[0].number], row, along, kind))
    return pieces, found


def _rows(
    strokes: Sequence[PaperStroke], numbers: Sequence[int], along: Points
) -> Iterator[list[_Dash]]:
    """Lines of one direction that follow each other, with gaps between them."""
    across = np.array([-along[1], along[0]])
    points = np.array([strokes[number].points for number in numbers])
    spans, offsets = np.sort(points @ along, axis=1), points.mean(axis=1) @ across
    dashes = [
        _Dash(start, end, offset, number)
        for (start, end), offset, number in zip(
            spans.tolist(), offsets.tolist(), numbers, strict=True
        )
    ]
    dashes.sort(key=lambda dash: dash.offset)
    tracks = [dashes[:1]]
    for before, dash in pairwise(dashes):
        if dash.offset - before.offset > _BESIDE:
            tracks.append([])
        tracks[-1].append(dash)
    for track in tracks:
        track.sort(key=lambda dash: dash.start)
        row = track[:1]
        for before, dash in pairwise(track):
            longer = max(before.length, dash.length)
            most = min(_LARGEST_GAP, _GAP_OF_DASH * longer + _GAP_BESIDES)
            if not _SMALLEST_GAP < dash.start - before.end < most:
                yield row
                row = []
            row.append(dash)
        yield row


def _rhythm(row: Sequence[_Dash]) -> StrokeRole | None:
    """What dashes in a row stand for; nothing where they have no rhythm."""
    if len(row) < _FEWEST:
        return None
    lengths = np.array([dash.length for dash in row])
    gaps = np.array([after.start - before.end for before, after in pairwise(row)])
    if gaps.max() > _EVEN_GAPS * max(float(np.median(gaps)), _LEAST_GAP):
        return None
    if len(lengths) == _FEWEST and lengths[1] > lengths[[0, -1]].max():
        # A chain line begins and ends with long dashes, a dashed one may with cut ones.
        is_cut = _LEAST_CUT * lengths[1] < lengths.min() and lengths[1] < _LONGEST_OF_THREE
        if is_cut and lengths[[0, -1]].max() < _ALIKE_OF_THREE * lengths.min():
            return StrokeRole.HIDDEN
    # The first and the last are cut off where the line ends.
    inner = lengths[1:-1] if len(lengths) > _FEWEST else lengths
    short = inner < _SHORT * inner.max()
    if short.any() and not short.all():
        # Nowhere do two long ones follow each other.
        takes_turns = bool((short[1:] | short[:-1]).all())
        return StrokeRole.CENTRE if takes_turns else None
    if len(lengths) > _FEWEST:
        return StrokeRole.HIDDEN if inner.max() < _ALIKE * inner.min() else None
    is_even = lengths.max() < min(_ALIKE_OF_THREE * lengths.min(), _LONGEST_OF_THREE)
    return StrokeRole.HIDDEN if is_even else None


def _whole(like: PaperStroke, row: Sequence[_Dash], along: Points, role: StrokeRole) -> PaperStroke:
    across = np.array([-along[1], along[0]])
    aside = float(np.mean([dash.offset for dash in row])) * across
    line = LineSegment(
        to_point(row[0].start * along + aside), to_point(row[-1].end * along + aside)
    )
    length = float(np.median([dash.length for dash in row]))
    return replace(like, curve=line, dashes=(length, length), role=role)


def _rings(
    strokes: Sequence[PaperStroke], numbers: Sequence[int]
) -> tuple[list[int], list[PaperStroke]]:
    """Numbers of short pieces, and the circles that they are the dashes of."""
    pieces: list[int] = []
    found = []
    for pen in dict.fromkeys(strokes[number].pen for number in numbers):
        alike = [number for number in numbers if strokes[number].pen == pen]
        if _RING_FEWEST <= len(alike) <= _RING_MOST:
            for members, ring in _rings_of(strokes, alike):
                pieces += members
                found.append(ring)
    return pieces, found


def _loose(strokes: Sequence[PaperStroke], numbers: Sequence[int]) -> list[int]:
    """Those that nothing touches at either end."""
    if not numbers:
        return []
    ends = np.concatenate([strokes[number].ends for number in numbers])
    touched = set((near_pairs(ends, _LOOSE) // 2).reshape(-1).tolist())
    return [number for index, number in enumerate(numbers) if index not in touched]


def _rings_of(
    strokes: Sequence[PaperStroke], numbers: Sequence[int]
) -> Iterator[tuple[list[int], PaperStroke]]:
    """Circles through two neighbours that go through others as well."""
    ends = np.array([strokes[number].ends for number in numbers])
    middles = np.array([_middle(strokes[number]) for number in numbers])
    free = np.ones(len(numbers), dtype=bool)
    neighbours = near_lists(middles, middles, _RING_NEAR)
    for first in range(len(numbers)):
        away = np.hypot(*(middles[neighbours[first]] - middles[first]).T)
        near = np.array(neighbours[first])[np.argsort(away, kind="stable")][:_RING_NEIGHBOURS]
        tried = [_on_ring(ends[[first, n]], ends, middles) & free for n in near if n != first]
        tried = [on for on in tried if free[first] and on[first]]
        if not tried:
            continue
        best = max(tried, key=lambda on: int(on.sum()))
        if best.sum() < _RING_FEWEST:
            continue
        arc = _ring(ends[best], middles[best])
        if arc is not None:
            free &= ~best
            members = [numbers[index] for index in np.flatnonzero(best).tolist()]
            lengths = np.array([strokes[number].length for number in members])
            is_mixed = (lengths < _SHORT * lengths.max()).sum() > 1 and lengths.max() > 2.0
            role = StrokeRole.CENTRE if is_mixed else StrokeRole.HIDDEN
            dash = float(np.median(lengths))
            like = strokes[members[0]]
            yield members, replace(like, curve=arc, dashes=(dash, dash), role=role)


def _middle(stroke: PaperStroke) -> Points:
    if stroke.is_line:
        return np.asarray(stroke.points.mean(axis=0))
    return stroke.points[len(stroke.points) // 2]


def _on_ring(two: Points, ends: Points, middles: Points) -> np.ndarray:
    """(n,) which dashes lie on the circle through the ends of two of them."""
    points = two.reshape(-1, 2)
    centre, radius = circle_through(points)
    off = np.abs(np.hypot(*(points - centre).T) - radius).max()
    if not _RADII[0] < radius < _RADII[1] or off > _RING_OFF:
        return np.zeros(len(ends), dtype=bool)
    off_ends = np.abs(np.hypot(*np.moveaxis(ends - centre, 2, 0)) - radius).max(axis=1)
    bow = np.abs(np.hypot(*(middles - centre).T) - radius)
    return np.asarray((off_ends < _RING_ON) & (bow < _RING_BOW * min(1.0, radius)))


def _ring(ends: Points, middles: Points) -> CircularArc | None:
    """The arc that dashes span, or the circle; nothing where they are but a few of it."""
    centre, radius = circle_through(ends.reshape(-1, 2))
    away = middles - centre
    angles = np.sort(np.arctan2(away[:, 1], away[:, 0]))
    gaps = np.diff(np.append(angles, angles[0] + FULL_TURN))
    usual = float(np.median(gaps))
    if usual * radius > _RING_NEAR or len(angles) * usual < _RING_SHOWN:
        return None
    start, sweep = 0.0, FULL_TURN
    widest = int(np.argmax(gaps))
    if gaps[widest] > _RING_OPEN * usual:
        start = float(angles[(widest + 1) % len(angles)])
        sweep = float(FULL_TURN - gaps[widest])
    return CircularArc(to_point(centre), radius, wrapped(start), sweep)
