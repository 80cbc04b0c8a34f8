"""Runs of ink along a shape as visible and hidden pieces.

A run much longer than the sheet's dashes is visible, a series of dashes one hidden stroke, and a
lone short run is visible if it ends at other strokes.  Programs begin each edge with a dash: where
two edges meet, or others fill gaps, a run is as long as several dashes.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import ONE_DASH
from gaussiancad_core.sheet.log_odds import SURE
from gaussiancad_core.sheet.picture_noise import STEP
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, Run, widest_gap

_BY_INK = 0.8
"""Confidence of a linetype that the ink of a short run tells."""

_LONGEST_JOINT, _LONGEST_LAST = 2.35, 2.0
"""Dashes that a run is long at most of which one ends where another begins, a little of ink beyond
either end included: where the lines of two edges meet, a circle its own beginning, or an arc the
first dash of its tangent; and where only one side of a line tells that it is dashed."""

_IN_STEP, _MOST_STEPS = 0.12, 4.3
"""Share of a dash and its gap by which dashes on both sides may be out of step, and such steps from
one to the other at most, for what is between to be dashes, too."""

_EVEN_GAP = (0.4, 1.6)
"""Share of the sheet's gap that such a run has beside it, at least and at most."""


def classify(
    runs: list[Run],
    rhythm: Rhythm,
    touches: Sequence[tuple[bool, bool]],
    around: float = float("inf"),
    stated: Sequence[float] = (),
) -> list[Piece]:
    """Visible and hidden pieces of a shape.

    Args:
        runs: in order along the shape.
        rhythm: of the sheet.
        touches: for each run whether its start and its end lie on another stroke.
        around: px, of a shape that closes on itself.
        stated: for each run log-odds that its ink is hidden, 0 where it tells nothing; without it
            runs longer than dashes are visible.  Dashes beside each other that fill their gaps are
            hidden all along.
    """
    longest_dash = ONE_DASH * rhythm.dash
    widest = widest_gap(rhythm)
    pieces: list[Piece] = []
    group: list[int] = []

    def close_group() -> None:
        if group:
            seen = stated[group[0]] if stated and len(group) == 1 else 0.0
            pieces.append(_short_piece(runs, group, rhythm, all(touches[group[0]]), seen))
            group.clear()

    for index, run in enumerate(runs):
        odds = stated[index] if stated else 0.0
        visible = odds <= -TOLD
        hidden = odds >= TOLD or (
            not visible and _is_joint(runs, index, rhythm, around, touches[index])
        )
        if run.length > longest_dash and not hidden:
            close_group()
            sure = min(1.0, 0.5 + (run.length / longest_dash - 1.0))
            pieces.append(Piece(run.start, run.end, Linetype.VISIBLE, sure))
            continue
        if odds < -SURE or (visible and _is_cut(runs, index)):
            close_group()
            pieces.append(Piece(run.start, run.end, Linetype.VISIBLE, _BY_INK))
            continue
        if group and run.start - runs[group[-1]].end > widest:
            close_group()
        group.append(index)
    close_group()
    return _extend_hidden(pieces, 1.8 * rhythm.gap + 1.0, around)


def _is_joint(
    runs: list[Run], index: int, rhythm: Rhythm, around: float, touches: tuple[bool, bool]
) -> bool:
    """Whether a run is dashes in a row: the last of one edge and the first of the next, as programs
    begin each edge with a dash, or some whose gaps others fill."""
    run = runs[index]
    before, after = _neighbours(runs, index, around)
    starts = before is not None and _is_dash_beside(before, run.start - before.end, rhythm)
    ends = after is not None and _is_dash_beside(after, after.start - run.end, rhythm)
    if before is not None and after is not None and starts and ends:
        turns = (after.start - before.start) / (rhythm.dash + rhythm.gap)
        in_step = abs(turns - round(turns)) < _IN_STEP and turns < _MOST_STEPS
        return in_step or run.length <= _LONGEST_JOINT * rhythm.dash
    # Where a curve goes on as its tangent, so does its last dash; an edge ends at another stroke.
    last = (starts and after is None and (np.isfinite(around) or not touches[1])) or (
        ends and before is None and (np.isfinite(around) or not touches[0])
    )
    longest = _LONGEST_JOINT if np.isfinite(around) else _LONGEST_LAST
    return bool(last) and run.length <= longest * rhythm.dash


def _is_dash_beside(run: Run, gap: float, rhythm: Rhythm) -> bool:
    low, high = (share * rhythm.gap for share in _EVEN_GAP)
    return run.length <= ONE_DASH * rhythm.dash and low <= gap <= high


def _neighbours(runs: list[Run], index: int, around: float) -> tuple[Run | None, Run | None]:
    """The runs before and after one; on a curve those beyond its beginning, if they are near."""
    before = runs[index - 1] if index else None
    after = runs[index + 1] if index + 1 < len(runs) else None
    if np.isfinite(around) and len(runs) > 2:
        first, last = runs[0], runs[-1]
        if first.start + around - last.end < around / 4.0:
            before = before or Run(last.start - around, last.end - around)
            after = after or Run(first.start + around, first.end + around)
    return before, after


def _is_cut(runs: list[Run], index: int) -> bool:
    """Whether a run's ink goes on in a run beside it, where the pen changes.

    Wide dashes with gaps between them are two hidden lines beside each other.
    """
    before = index > 0 and runs[index].start - runs[index - 1].end < STEP
    return before or (index + 1 < len(runs) and runs[index + 1].start - runs[index].end < STEP)


def _short_piece(
    runs: list[Run], group: list[int], rhythm: Rhythm, bounded: bool, odds: float
) -> Piece:
    start, end = runs[group[0]].start, runs[group[-1]].end
    if len(group) >= 2:
        sure = min(1.0, 0.6 + 0.15 * (len(group) - 1))
        return Piece(start, end, Linetype.HIDDEN, sure)
    if abs(odds) >= TOLD:
        return Piece(start, end, Linetype.HIDDEN if odds > 0.0 else Linetype.VISIBLE, _BY_INK)
    if not bounded:
        return Piece(start, end, Linetype.HIDDEN, 0.5)
    # A hidden line no longer than a dash is drawn as one dash: told apart only by the odds.
    typical = abs(end - start - rhythm.dash) < 0.25 * rhythm.dash
    return Piece(start, end, Linetype.VISIBLE, 0.5 if typical else 0.7)


def _extend_hidden(pieces: list[Piece], reach: float, around: float) -> list[Piece]:
    """Let a dashed piece end where the solid piece beside it starts."""
    extended = list(pieces)
    for index, piece in enumerate(pieces):
        # On a curve a lone piece is beside itself.
        if piece.linetype is not Linetype.HIDDEN or len(pieces) < 2:
            continue
        start, end = piece.start, piece.end
        before = pieces[index - 1].end if index else pieces[-1].end - around
        after = pieces[index + 1].start if index + 1 < len(pieces) else pieces[0].start + around
        if 0 < start - before <= reach:
            start = before
        if 0 < after - end <= reach:
            end = after
        extended[index] = Piece(start, end, piece.linetype, piece.confidence)
    return extended
