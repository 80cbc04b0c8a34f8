"""Centre lines by their rhythm: long and short dashes in turn (ISO 128-2)."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.runs import Run

_CUT, _CUT_PX = 0.35, 5.0
"""Gap between two pieces of one dash that another line crosses at most, in the gaps beside it, and
px by which it is smaller at least."""

_SHORT = 0.45
"""Length of the short dashes of a centre line, as a share of the long ones, at most."""

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

_ALTERNATING = 0.75
"""Share of a centre line's neighbouring dashes of which one is long and one short."""


def long_short_span(runs: Sequence[Run]) -> tuple[int, int]:
    """First and one past the last of the runs that are a centre line's dashes, or pieces of these.

    Args:
        runs: of a line, in order, at the gaps of a dashed one.
    """
    whole = _whole_dashes(runs)
    first, last = _long_short_part([dash for dash, _ in whole])
    return sum(count for _, count in whole[:first]), sum(count for _, count in whole[:last])


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
