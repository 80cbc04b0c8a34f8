"""Which lines of a sheet are the part's, told by their weight and their rhythm (ISO 128-2).

Visible edges are wide and continuous, hidden ones dashed.  Narrow continuous lines are dimension,
extension and leader lines; lines of long and short dashes in turn are centre lines.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.corners import Corners
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.long_short import long_short_span
from gaussiancad_core.sheet.annotations.swallowed_dots import mark_beyond_swallowed_dots
from gaussiancad_core.sheet.runs import Rhythm, learn_rhythm

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

_LONE = 3
"""Dashes of which one is between two at most."""

_DOT = 3.0
"""Length of what is a dot and no dash at most, in stroke widths."""

_LONGEST = 12.0
"""Length of a long dash at most, in the short ones beside it, where these are no dots (ISO 128-2
has 24 widths beside dots, AutoCAD five times the short dash)."""

_NOISE = 1.1
"""Share of the limit by which the width of something as short as a dash may be off."""

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
            start, end = long_short_span([run.run for run in group])
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


def widest_gap(stroke_width: float, dash_gap: float) -> float:
    """px, the gap in a line of dashes at most."""
    return max(_WIDEST_PX, _WIDEST * stroke_width, dash_gap)


def _spread(own: list[AnnotationKind | None], runs: Sequence[InkedRun], limit: float) -> None:
    """Narrow runs between two of an annotation are of it as well, in place."""
    for k in range(1, len(own) - 1):
        between = own[k - 1] is not None and own[k + 1] is not None
        if own[k] is None and between and not _is_wide(runs[k], limit):
            own[k] = own[k - 1]


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
