"""How surely the ink of a run is hidden: what its pen and its label tell, along a shape.

Log-odds of hidden against visible add up where they know the ink: the width of the pen where a
sheet's differ, and the label of each pixel where the network told it.  Where another stroke shares
the ink, it tells nothing.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from scipy.ndimage import median_filter

from gaussiancad_core.geometry.whole_curves import WholeCurve
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD, label_odds
from gaussiancad_core.sheet.tracing.ink_runs import Run
from gaussiancad_core.sheet.tracing.line_widths import Pens, widths_along

Floats = npt.NDArray[np.float64]

RunOdds = tuple[Run, float]
"""A run, and log-odds that it is hidden: what something but its length tells; 0 for nothing."""

_BY_PEN = 2.5
"""Log-odds that a width tells at most: a row of dashes tells more, as wide ones are two lines'."""

_STEADY = 3
"""px on either side over which odds are made steady."""

_SHORTEST = 6.0
"""px of a stretch that is told at least."""

_KNOWN = 0.15
"""Share of a stretch whose ink is its own at least for that to tell it."""


def run_odds(
    sheet: CleanSheet, geometry: WholeCurve, runs: Sequence[Run], pens: Pens
) -> list[RunOdds]:
    """The runs of a shape, cut where its ink changes from hidden to visible, with their log-odds.

    Args:
        sheet: its ink, with the labels that it has.
        geometry: the shape.
        runs: its ink, in order.
        pens: of the sheet.
    """
    if sheet.hidden_odds is None and not pens.distinct:
        return [(run, 0.0) for run in runs]
    found: list[RunOdds] = []
    for run in runs:
        cut: list[RunOdds] = []
        odds = odds_along(sheet, geometry, run, pens)
        for first, last in _stretches(odds):
            step = run.length / (len(odds) - 1)
            values = odds[first : last + 1]
            values = values[np.isfinite(values)]
            least = max(0.5 * _SHORTEST, _KNOWN * (last - first) * step)
            stated = float(np.median(values)) if len(values) * step >= least else 0.0
            start = run.start if first == 0 else run.start + (first - 0.5) * step
            end = run.end if last == len(odds) - 1 else run.start + (last + 0.5) * step
            cut.append((Run(start, end), stated))
        found += _joined(cut)
    return _shared_in_rows(found)


def odds_along(sheet: CleanSheet, geometry: WholeCurve, run: Run, pens: Pens) -> Floats:
    """(n,) log-odds of hidden about every px of a run; NaN where its ink is not its own."""
    widths = widths_along(sheet, geometry, run, edges=True)
    odds = np.where(np.isfinite(widths), 0.0, np.nan)
    if pens.distinct:
        middle, half = 0.5 * (pens.hidden + pens.visible), 0.5 * (pens.visible - pens.hidden)
        odds += np.clip(TOLD * (middle - widths) / half, -_BY_PEN, _BY_PEN)
    if sheet.hidden_odds is not None:
        odds += label_odds(sheet, geometry.points_at(np.linspace(run.start, run.end, len(widths))))
    return odds


def _joined(cut: list[RunOdds]) -> list[RunOdds]:
    """The stretches of a run, without the cuts beside which nothing is told to change; all of it
    with the mean log-odds where none is visible, as then no edge begins."""
    if all(odds > -TOLD for _, odds in cut):
        weights = [run.length for run, _ in cut]
        mean = float(np.average([odds for _, odds in cut], weights=weights))
        return [(Run(cut[0][0].start, cut[-1][0].end), mean)]
    joined = cut[:1]
    for run, odds in cut[1:]:
        before, known = joined[-1]
        sides = (known >= TOLD) - (known <= -TOLD), (odds >= TOLD) - (odds <= -TOLD)
        if sides[0] == sides[1] or 1 not in sides:
            joined[-1] = (Run(before.start, run.end), known if sides[0] else odds)
        else:
            joined.append((run, odds))
    return joined


def _shared_in_rows(runs: list[RunOdds]) -> list[RunOdds]:
    """The runs, those of a row of dashes with their mean log-odds: they are of one kind."""
    lengths = np.array([run.length for run, _ in runs])
    alike = np.maximum(lengths[1:], lengths[:-1]) <= (1.0 + LIKE_A_DASH) * np.minimum(
        lengths[1:], lengths[:-1]
    )
    # Two of equal length may be anything; three are a row.
    adjacent = np.pad(alike, 1)
    follows = np.concatenate([[False], alike & (adjacent[:-2] | adjacent[2:])])[: len(runs)]
    found: list[RunOdds] = []
    for row in np.split(np.arange(len(runs)), np.flatnonzero(~follows))[1:]:
        odds = [runs[k][1] for k in row]
        known = [odd for odd in odds if odd]
        mean = float(np.mean(known)) if known else 0.0
        found += [(runs[k][0], mean) for k in row]
    return found


def _stretches(odds: Floats) -> list[tuple[int, int]]:
    """First and last place of each stretch that is rather hidden, or rather visible, all along."""
    known = np.flatnonzero(np.isfinite(odds))
    last = len(odds) - 1
    if len(known) < _SHORTEST or last < 2 * _SHORTEST:
        return [(0, last)]
    filled = np.interp(np.arange(len(odds)), known, odds[known])
    hidden = median_filter(filled, 2 * _STEADY + 1, mode="nearest") > 0.0
    borders = [0, *(np.flatnonzero(np.diff(hidden)) + 1).tolist(), last + 1]
    # Stretches too short to be told are a part of what is beside them.
    kept = [0]
    for start, end in pairwise(borders):
        if end - start >= _SHORTEST and hidden[start] != hidden[kept[-1]] and start > 0:
            kept.append(start)
        elif start == 0 and end - start < _SHORTEST and len(borders) > 2:
            hidden[: borders[1]] = hidden[borders[1]]
    return [(start, end - 1) for start, end in pairwise([*kept, last + 1])]
