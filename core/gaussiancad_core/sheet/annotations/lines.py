"""Which lines of a sheet are the part's, told by their weight and their rhythm (ISO 128-2).

Visible edges are wide and continuous, hidden ones dashed.  Narrow continuous lines are dimension,
extension and leader lines; lines of long and short dashes in turn are centre lines.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.corners import Corners
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.swallowed_dots import mark_beyond_swallowed_dots
from gaussiancad_core.sheet.runs import Rhythm, Run, learn_rhythm

_SOLID_PX = 20.0
"""px of a run that says how wide continuous lines are."""

_CONTRAST = 1.3
"""Least ratio of the widths of wide and narrow lines (ISO 128-2 asks for 2, many take 1.4)."""

_APART = 2.3
"""Spreads by which the two families of widths differ at least."""

_LEAST_SHARE = 0.1
"""Share of the lines' length that either family has at least."""

_BLOT = 1.25
"""Width up to which what is wider counts, in that which a tenth of the lines' length exceeds."""

_WIDEST_PX, _WIDEST = 12.0, 5.0
"""px, and stroke widths, of the gaps in a line of dashes at most."""

_BREAK = 0.5
"""Gap between dashes at least, in the sheet's usual gaps."""

_CUT, _CUT_PX = 0.35, 5.0
"""Gap between two pieces of one dash that another line crosses at most, in the gaps beside it, and
px by which it is smaller at least."""

_SHORT = 0.45
"""Length of the short dashes of a centre line, as a share of the long ones, at most."""

_LONE = 3
"""Dashes of which one is between two at most."""

_DOT = 3.0
"""Length of what is a dot and no dash at most, in stroke widths."""

_LONGEST = 12.0
"""Length of a long dash at most, in the short ones beside it, where these are no dots (ISO 128-2
has 24 widths beside dots, AutoCAD five times the short dash)."""

_NOISE = 1.1
"""Share of the limit by which the width of something as short as a dash may be off."""

_FADED = 0.25
"""Share by which the gap that a short dash left may differ from what it and its gaps take."""

_STRICT = 5
"""Dashes, long and short strictly in turn, that are a centre line beside something else."""

_UNEVEN = 0.4
"""Share by which dashes of one kind differ there at most."""

_EVEN_PX, _EVEN = 1.5, 0.3
"""px, and share of the gaps beside them, by which dots of centre lines in line differ at most."""

_LONG_IN_A_ROW = 3
"""Long dashes one after the other, at most, where one centre line ends and the next begins, with a
piece between them where they overlap."""

_LONGEST_DASH = 1.75
"""Length of a dash at most, in the sheet's usual ones."""

_WHOLE_DASH = 0.6
"""Length of a whole dash at least, in the sheet's usual ones."""

_ABOUT = 0.75, 1.25
"""Length of a whole dash at least and at most, in the sheet's usual ones, where two are beside each
other."""

_IN_A_ROW = 3
"""Dashes from which a row is a hidden line."""

_JOINED = 3
"""Dashes that crossing strokes join at most."""

_ALTERNATING = 0.75
"""Share of a centre line's neighbouring dashes of which one is long and one short."""


@dataclass(frozen=True)
class Weights:
    """The widths of a sheet's continuous lines.

    Attributes:
        visible: px, of the part's edges.
        limit: px under which a continuous line is narrow; 0 where all lines are of one width.
    """

    visible: float
    limit: float


def line_weights(
    shapes: Sequence[InkedShape], stroke_width: float, least_px: float = 0.0
) -> Weights:
    """Learn from a sheet's continuous runs whether it has wide and narrow lines.

    Args:
        shapes: with their runs measured.
        stroke_width: px, the mean over the sheet.
        least_px: by which wide lines are wider than narrow ones at least.
    """
    pairs = [
        (own.width, own.run.length)
        for shape in shapes
        for own in shape.runs
        if own.width is not None and own.run.length > _SOLID_PX
    ]
    if not pairs:
        return Weights(stroke_width, 0.0)
    widths, lengths = np.array(pairs).T
    order = np.argsort(widths)
    widths, lengths = widths[order], lengths[order]
    limit = _valley(widths, lengths, least_px)
    wide = widths >= limit
    middle = np.searchsorted(np.cumsum(lengths[wide]), lengths[wide].sum() / 2)
    return Weights(float(widths[wide][min(middle, wide.sum() - 1)]), limit)


def _valley(widths: np.ndarray, lengths: np.ndarray, least_px: float) -> float:
    """The width between two families of widths (Otsu 1979), or 0 where there is but one."""
    total = lengths.sum()
    # Heads of arrows and dots are runs, too, several times as wide as any line.
    usual = np.searchsorted(np.cumsum(lengths), (1.0 - _LEAST_SHARE) * total)
    widths = np.minimum(widths, _BLOT * widths[min(usual, len(widths) - 1)])
    below = np.cumsum(lengths)[:-1]
    sums = np.cumsum(lengths * widths)[:-1]
    distinct = np.diff(widths) > 1e-6
    if not distinct.any():
        return 0.0
    above = total - below
    low, high = sums / below, ((lengths * widths).sum() - sums) / above
    between = np.where(distinct, below * above * (high - low) ** 2, -1.0)
    cut = int(np.argmax(between))
    if min(below[cut], above[cut]) < _LEAST_SHARE * total or high[cut] < _CONTRAST * low[cut]:
        return 0.0
    first, second = slice(0, cut + 1), slice(cut + 1, None)
    spread = sum(
        float(np.sqrt(np.average((widths[part] - mean) ** 2, weights=lengths[part])))
        for part, mean in ((first, low[cut]), (second, high[cut]))
    )
    if high[cut] - low[cut] < max(_APART * spread, least_px):
        return 0.0
    # Nearer to the narrow ones: a wide line that was scanned faintly stays the part's.
    return float(low[cut] + 0.45 * (high[cut] - low[cut]))


def kinds_of_runs(
    shapes: Sequence[InkedShape], weights: Weights, stroke_width: float, dash_gap: float = 0.0
) -> list[list[AnnotationKind | None]]:
    """For each run of each shape what annotation it is, or nothing where it is the part's.

    Args:
        shapes: with their runs measured.
        weights: of the sheet's lines.
        stroke_width: px.
        dash_gap: px, usual between the sheet's dashes; 0 where it is not known.
    """
    widest = widest_gap(stroke_width, dash_gap)
    kinds: list[list[AnnotationKind | None]] = [[None] * len(shape.runs) for shape in shapes]
    rest: list[list[InkedRun]] = []
    corners = Corners.of(shapes, stroke_width)
    for shape, own in zip(shapes, kinds, strict=True):
        for first, last in _groups(shape.runs, widest, weights.limit):
            group = shape.runs[first:last]
            whole = _whole_dashes([run.run for run in group])
            start, end = _long_short_part([dash for dash, _ in whole])
            start, end = (sum(count for _, count in whole[:at]) for at in (start, end))
            # Where wide and narrow lines are told apart, a group is of one kind.
            part = group[start:end]
            if part and (weights.limit or not _is_edge(shape, part, corners, stroke_width)):
                own[first + start : first + end] = [AnnotationKind.CENTRE_LINE] * (end - start)
        mark_beyond_swallowed_dots(shape.runs, own)
        rest.append([run for run, kind in zip(shape.runs, own, strict=True) if kind is None])
    if not weights.limit:
        return kinds
    rhythm = learn_rhythm([[run.run for run in runs] for runs in rest], stroke_width)
    for shape, own in zip(shapes, kinds, strict=True):
        for k, run in enumerate(shape.runs):
            narrow = run.width is not None and run.width < weights.limit
            if own[k] is None and narrow and not _is_dash(shape.runs, k, rhythm, weights.limit):
                own[k] = AnnotationKind.EXTENSION
        _spread(own, shape.runs, weights.limit)
    return kinds


def _whole_dashes(runs: Sequence[Run]) -> list[tuple[Run, int]]:
    """Dashes with those made one that another line cut, and of how many pieces each is."""
    gaps = [after.start - before.end for before, after in pairwise(runs)]
    usual = float(np.median(gaps)) if gaps else 0.0
    most = min(_CUT * usual, usual - _CUT_PX)
    whole = [(runs[0], 1)]
    for gap, run in zip(gaps, runs[1:], strict=True):
        last, count = whole[-1]
        if gap <= most:
            whole[-1] = Run(last.start, run.end), count + 1
        else:
            whole.append((run, 1))
    return whole


def widest_gap(stroke_width: float, dash_gap: float) -> float:
    """px, the gap in a line of dashes at most."""
    return max(_WIDEST_PX, _WIDEST * stroke_width, dash_gap)


def _spread(own: list[AnnotationKind | None], runs: Sequence[InkedRun], limit: float) -> None:
    """Narrow runs between two of an annotation are of it as well, in place."""
    for k in range(1, len(own) - 1):
        between = own[k - 1] is not None and own[k + 1] is not None
        if own[k] is None and between and not _is_wide(runs[k], limit):
            own[k] = own[k - 1]


def is_long_short(runs: Sequence[Run]) -> bool:
    """Whether dashes are long and short in turn, as those of a centre line.

    Where one short dash at least was seen, others may have faded: they count where the gap between
    two long ones has room for them.
    """
    if len(runs) < 3:
        return False
    lengths = np.array([run.length for run in runs])
    longest = np.median(np.sort(lengths)[len(lengths) // 2 :])
    short = lengths < _SHORT * longest
    if len(runs) >= _STRICT:
        # Behind a dot at the end of a line the dash is cut, however little is left of it.
        for last, before in ((0, 1), (-1, -2)):
            short[last] &= not short[before]
    short = _with_faded(runs, short)
    # The pattern starts and ends with a long dash, but a crossing may cut one.
    inner = short[1:-1]
    turns = short[1:] != short[:-1]
    mixed = inner.any() and (not inner.all() or len(inner) == 1)
    return bool(mixed) and bool(turns.mean() >= _ALTERNATING or _has_even_dots(runs, short))


def _has_even_dots(runs: Sequence[Run], short: npt.NDArray[np.bool_]) -> bool:
    """Whether short dashes, two at least, are alike and each is between two long ones at even gaps:
    centre lines one after the other, as those of a slot's two ends.  What crossings leave of a
    hidden line's dashes is of any length and touches what crosses it; where a circle crosses a
    dashed one twice, it leaves two that are alike, with many between."""
    if len(short) != len(runs) or short[0] or short[-1] or (short[1:] & short[:-1]).any():
        return False
    dots = np.flatnonzero(short)
    if (np.diff(dots) > _LONG_IN_A_ROW + 1).any():
        return False
    lengths = np.array([runs[k].length for k in dots])
    gaps = np.array(
        [(runs[k].start - runs[k - 1].end, runs[k + 1].start - runs[k].end) for k in dots.tolist()]
    )
    even = np.ptp(gaps) <= max(_EVEN_PX, _EVEN * gaps.mean())
    even &= np.ptp(lengths) <= _EVEN_PX
    # Both ends are whole long dashes: beyond, another line may begin.
    ends = runs[0].length, runs[-1].length
    even &= abs(ends[0] - ends[1]) <= _UNEVEN * min(ends)
    return len(dots) > 1 and bool(even)


def _long_short_part(runs: Sequence[Run]) -> tuple[int, int]:
    """First and one past the last of the dashes that are a centre line's: all, none, or some of
    them beside an extension line that ends where the centre line begins."""
    if is_long_short(runs):
        return 0, len(runs)
    lengths = np.array([run.length for run in runs])
    best = 0, 0
    for first in range(len(runs) - _STRICT + 1):
        long = lengths[first]
        last = first + 1
        while last < len(runs) and (lengths[last] < _SHORT * long) == bool((last - first) % 2):
            last += 1
        # It ends with a long dash, as it starts.
        last -= 1 - (last - first) % 2
        if last - first >= max(_STRICT, best[1] - best[0] + 1) and _is_regular(runs[first:last]):
            best = first, last
    return best


def _is_regular(runs: Sequence[Run]) -> bool:
    """Whether the long dashes are of one length, but for those at the ends, and so are the short
    ones and the gaps: of a dash that faded in part the rest of its place is blank."""
    lengths = np.array([run.length for run in runs])
    gaps = np.array([after.start - before.end for before, after in pairwise(runs)])
    families = lengths[2:-1:2], lengths[1::2], gaps
    return all(np.ptp(own) <= _UNEVEN * own.mean() for own in families if len(own))


def _is_edge(
    shape: InkedShape, runs: Sequence[InkedRun], corners: Corners, stroke_width: float
) -> bool:
    """Whether long and short dashes are an edge and hidden lines that go on from it."""
    lengths = np.array([own.run.length for own in runs])
    shortest = float(lengths.min())
    # A row of them is a centre line, though others' ink joins some.
    lone = len(runs) <= _LONE and shortest > _DOT * stroke_width
    too_long = lone and float(lengths.max()) > _LONGEST * shortest
    return too_long or not _is_even(runs) or corners.has_end(shape.geometry, runs)


def _is_even(runs: Sequence[InkedRun]) -> bool:
    """Whether the longest dash is no wider than the others: an edge that hidden dashes lead to,
    some of them made longer by a stroke that touches them, is."""
    longest = max(runs, key=lambda own: own.run.length)
    others = [own.width for own in runs if own is not longest and own.width is not None]
    if longest.width is None or not others:
        return True
    return longest.width <= _CONTRAST * float(np.median(others))


def _with_faded(runs: Sequence[Run], short: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Which dashes are short, those added that are missing between two long ones: no more than were
    seen."""
    gaps = np.array([after.start - before.end for before, after in pairwise(runs)])
    beside = short[1:] != short[:-1]
    # A dash of a hidden line that faded falls to pieces, which lie side by side.
    if not beside.any() or (short[1:] & short[:-1]).any():
        return short
    gap = float(np.median(gaps[beside]))
    dots = [run.length for run, is_short in zip(runs, short, strict=True) if is_short]
    room = 2.0 * gap + float(np.median(dots))
    empty = ~short[1:] & ~short[:-1] & (np.abs(gaps - room) < _FADED * room)
    if empty.sum() > len(dots):
        return short
    return np.insert(short, np.flatnonzero(empty) + 1, True)


def _groups(runs: Sequence[InkedRun], widest: float, limit: float) -> list[tuple[int, int]]:
    """First and one past the last of runs that follow each other at gaps of a dashed line, wide and
    narrow ones apart."""
    groups, first = [], 0
    for k in range(1, len(runs) + 1):
        if k < len(runs):
            far = runs[k].run.start - runs[k - 1].run.end > widest
            if not far and _is_wide(runs[k], limit) == _is_wide(runs[k - 1], limit):
                continue
        groups.append((first, k))
        first = k
    return groups


def _is_wide(run: InkedRun, limit: float) -> bool:
    return bool(limit) and run.width is not None and run.width >= limit


def _is_dash(runs: Sequence[InkedRun], k: int, rhythm: Rhythm, limit: float) -> bool:
    """Whether a run is a dash of a hidden line: of the sheet's length, with another dash on one
    side or an edge on both.  Beside one edge only, it is the extension line of that edge.

    Strokes that cross in gaps join dashes: between two dashes a run may be as long as three.
    """
    first = last = k
    while first > 0 and _is_broken(runs[first - 1], runs[first], rhythm, limit):
        if _is_wide(runs[first - 1], limit):
            break
        first -= 1
    while last + 1 < len(runs) and _is_broken(runs[last], runs[last + 1], rhythm, limit):
        if _is_wide(runs[last + 1], limit):
            break
        last += 1
    start, end = runs[first].run.start, runs[last].run.end
    gap = 2.2 * rhythm.gap + 2.0
    beside = []
    if first > 0 and start - runs[first - 1].run.end <= gap:
        beside.append(runs[first - 1])
    if last + 1 < len(runs) and runs[last + 1].run.start - end <= gap:
        beside.append(runs[last + 1])
    longest, wide = _LONGEST_DASH * rhythm.dash, _NOISE * limit
    dashes = [run for run in beside if run.run.length <= longest and not _is_wide(run, wide)]
    if end - start > longest:
        # The dots of a centre line are shorter than dashes.
        whole = [run for run in dashes if run.run.length > _WHOLE_DASH * rhythm.dash]
        joined = _JOINED * rhythm.dash + (_JOINED - 1) * rhythm.gap
        if len(whole) == 2:
            return end - start <= _NOISE * joined
        # Where a hidden line ends at an edge, another's first dash may go on from its last.
        row = _row_beside(runs, (first, last), gap, longest, wide)
        return row >= _IN_A_ROW and end - start <= _NOISE * (2.0 * rhythm.dash + limit)
    return bool(dashes) or len(beside) == 2


def _is_broken(before: InkedRun, after: InkedRun, rhythm: Rhythm, limit: float) -> bool:
    """Whether faded ink broke a line between two runs: at less than a gap between dashes.

    A stroke that crosses beside a dash covers some of the gap, and makes the dash longer.
    """
    shorter, longer = sorted((before.run.length, after.run.length))
    least, most = (share * rhythm.dash for share in _ABOUT)
    dashes = least <= shorter <= most and longer <= most + limit
    return not dashes and after.run.start - before.run.end < _BREAK * rhythm.gap


def _row_beside(
    runs: Sequence[InkedRun], span: tuple[int, int], gap: float, longest: float, wide: float
) -> int:
    """Number of dashes in a row on either side of some runs, the larger one."""
    first, last = span
    sides = [runs[k] for k in range(first, -1, -1)], list(runs[last:])
    counts = []
    for side in sides:
        count = 0
        for near, far in pairwise(side):
            apart = max(far.run.start - near.run.end, near.run.start - far.run.end)
            if apart > gap or far.run.length > longest or _is_wide(far, wide):
                break
            count += 1
        counts.append(count)
    return max(counts)
