"""Part or annotation, along a line: where a line changes from one to the other, it is parted.

An extension line goes on where an edge ends, a centre line where it leaves the view.  Along each
line or circle the log-odds of its points are added, and a change costs as much as a few points
tell: the cheapest assignment is found exactly (Viterbi 1967).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.labels.ink_classes import PART, Evidence, InkClass
from gaussiancad_core.sheet.labels.labels_network import InkLabels, part_odds
from gaussiancad_core.sheet.log_odds import IMPOSSIBLE, OF_A_POINT
from gaussiancad_core.sheet.tracing.ink_runs import Run

Floats = npt.NDArray[np.float64]

_SHARED = 0.1
"""Weight of a point that lies on another line's ink, too: a crossing has the other's label."""

_PER_PX = 0.25
"""Weight of a px: neighbouring points see the same ink."""

_CHANGE = 5.0
"""Cost of a change along unbroken ink where something else meets it, as log-odds."""

_CHANGE_ALONE = 1000.0
"""The same where nothing meets it, more than ink of any length tells: an edge ends at edges, so
that ink which runs on is of one kind.  Which one, all of it says, and then what its ends meet."""

_CHANGE_AT_GAP = 1.5
"""The same between two runs of one line."""

_CHANGE_IN_ROW = 8.0
"""The same between dashes of a row: they are of one kind, whatever crosses them."""

_STEP = 1.0
"""px between the points."""

_TELLING_PX = 40.0
"""px of a line that tell what it is: what one stretch of it looks like, the rest does, too."""


@dataclass(frozen=True, eq=False)
class SharedInk:
    """Where the lines of a sheet meet.

    Attributes:
        shared: (h, w) bool, ink that more than one line runs through.
        met: (h, w) bool, what is near to ink of two lines, or to a curve that is no line.
    """

    shared: npt.NDArray[np.bool_]
    met: npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class LabelledRun:
    """A piece of a run of ink with what it stands for.

    Attributes:
        run: where it is.
        ink: what it is taken for.
        margin: mean log-odds of the part against annotation, before neighbours were asked.
        log_p: (classes,) mean log-probabilities.
        why: what decided.
        support: log-odds of the decision where something else than its own ink made it.
    """

    run: InkedRun
    ink: InkClass
    margin: float
    log_p: Floats
    why: Evidence = Evidence.NETWORK
    support: float | None = None

    @property
    def is_part(self) -> bool:
        """Whether it is an edge."""
        return self.ink in PART

    @property
    def evidence(self) -> float:
        """What its ink says for the part, as log-odds: no more than so many px tell."""
        return float(_weighed(self.margin)) * _PER_PX * min(self.run.run.length, _TELLING_PX)

    def turned(self, support: float | None = None) -> "LabelledRun":
        """The same as the likeliest class of the other group, as its ends are loose otherwise."""
        ink = likeliest(self.log_p, part=not self.is_part)
        return replace(self, ink=ink, why=Evidence.LOOSE_END, support=support)

    def as_figure(self, ink: InkClass, support: float) -> "LabelledRun":
        """The same taken for what its figure is."""
        return replace(self, ink=ink, why=Evidence.FIGURE, support=support)

    def no_longer(self, ink: InkClass) -> "LabelledRun":
        """The same where it is known that it is not of a class: the others tell what it is."""
        log_p = self.log_p.copy()
        log_p[ink] = IMPOSSIBLE
        margin = float(part_odds(log_p[None])[0])
        ink = likeliest(log_p, margin > 0.0)
        why = Evidence.FIGURE
        return replace(self, ink=ink, margin=margin, log_p=log_p, why=why, support=None)

    def otherwise(self) -> InkClass:
        """The likeliest class of the other group: what it would be if the decision is wrong."""
        return likeliest(self.log_p, part=not self.is_part)


def likeliest(log_p: Floats, part: bool) -> InkClass:
    """The likeliest class of ink of a group."""
    ranked = (InkClass(k) for k in np.argsort(-log_p, kind="stable") if k)
    return next(ink_class for ink_class in ranked if (ink_class in PART) is part)


@dataclass(frozen=True, eq=False)
class _Points:
    """Of a run: (n, classes) log-probabilities, (n,) log-odds of the part, the same by the network
    alone, (n,) weights."""

    log_p: Floats
    odds: Floats
    network: Floats
    weights: Floats


def labelled_runs(
    shape: InkedShape,
    labels: InkLabels,
    ink: SharedInk,
    pens: Sequence[Callable[[InkedShape, InkedRun, Floats], Floats]] = (),
) -> list[LabelledRun]:
    """The runs of a line or circle, parted where they change from the part's to annotation.

    Args:
        shape: with its runs.
        labels: of the picture.
        ink: where others meet it.
        pens: further log-odds of the points of a run each, from their (n, classes)
            log-probabilities.
    """
    points, met = [], []
    for inked_run in shape.runs:
        where = points_along(shape.geometry, inked_run.run, _STEP)
        log_p = labels.at(where)
        network = part_odds(log_p)
        odds = network + sum(pen(shape, inked_run, log_p) for pen in pens)
        weights = np.where(values_at(ink.shared, where), _SHARED, 1.0)
        met.append(values_at(ink.met, where))
        odds, network = (np.clip(each, -OF_A_POINT, OF_A_POINT) for each in (odds, network))
        points.append(_Points(log_p, odds, network, weights))
    if not points:
        return []
    rows = _rows([run.run.length for run in shape.runs])
    points = _with_row_linetypes(points, rows)
    stated = np.concatenate([_weighed(point.odds) * point.weights for point in points]) * _PER_PX
    starts = np.cumsum([0, *(len(point.odds) for point in points)])
    change = np.where(np.concatenate(met), _CHANGE, _CHANGE_ALONE)
    change[starts[:-1]] = np.where(rows, _CHANGE_IN_ROW, _CHANGE_AT_GAP)
    is_part = _cheapest(stated, change)
    return [
        _labelled(
            run,
            point,
            piece,
            part=bool(is_part[start + piece[0]]),
            kept=_kept(stated, change, is_part, (start + piece[0], start + piece[1])),
        )
        for run, point, start in zip(shape.runs, points, starts[:-1].tolist(), strict=True)
        for piece in _pieces(is_part[start : start + len(point.odds)])
    ]


def _rows(lengths: Sequence[float]) -> npt.NDArray[np.bool_]:
    """(n,) whether each run of a line goes on a row of dashes with the one before it."""
    values = np.asarray(lengths)
    alike = np.maximum(values[1:], values[:-1]) <= (1.0 + LIKE_A_DASH) * np.minimum(
        values[1:], values[:-1]
    )
    # Two of equal length may be anything; three are a row.
    adjacent = np.pad(alike, 1)
    return np.concatenate([[False], alike & (adjacent[:-2] | adjacent[2:])])


def _with_row_linetypes(points: list[_Points], rows: npt.NDArray[np.bool_]) -> list[_Points]:
    """The points of runs, those of a row with one ratio of hidden to visible; what they have of
    both together stays."""
    found = list(points)
    for row in np.split(np.arange(len(points)), np.flatnonzero(~rows))[1:]:
        if len(row) < 2:
            continue
        log_p = np.concatenate([points[k].log_p for k in row])
        ratio = float(np.mean(log_p[:, InkClass.HIDDEN] - log_p[:, InkClass.VISIBLE]))
        for k in row:
            item = points[k].log_p.copy()
            both = np.logaddexp(item[:, InkClass.VISIBLE], item[:, InkClass.HIDDEN])
            item[:, InkClass.HIDDEN] = both - np.logaddexp(0.0, -ratio)
            item[:, InkClass.VISIBLE] = both - np.logaddexp(0.0, ratio)
            found[k] = replace(points[k], log_p=item)
    return found


def _weighed(odds: Floats | float) -> Floats | float:
    """What log-odds of the network are worth: small ones are right as often as not, large ones
    nearly always."""
    return odds * np.abs(odds) / OF_A_POINT


def _cheapest(stated: Floats, change: Floats) -> npt.NDArray[np.bool_]:
    """(n,) whether each point is the part's.

    Args:
        stated: (n,) log-odds.
        change: (n,) cost of a change between a point and the one before it.
    """
    # By how much being the part's costs less up to here; a change lowers it to what that costs.
    ahead = 0.0
    back = []
    for item, cost in zip(stated.tolist(), change.tolist(), strict=True):
        back.append((ahead > cost, ahead < -cost))
        ahead = min(max(ahead, -cost), cost) + item
    state = int(ahead >= 0.0)
    states = np.zeros(len(stated), bool)
    for k in range(len(stated) - 1, -1, -1):
        states[k] = bool(state)
        if back[k][state]:
            state = 1 - state
    return states


def _pieces(states: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of each stretch of one state."""
    borders = np.flatnonzero(np.diff(states)) + 1
    firsts, lasts = [0, *borders], [*(borders - 1), len(states) - 1]
    return [(int(a), int(b)) for a, b in zip(firsts, lasts, strict=True)]


def _kept(
    stated: Floats, change: Floats, is_part: npt.NDArray[np.bool_], piece: tuple[int, int]
) -> float:
    """By how much a piece costs less as it is than turned, all else as it is.

    Args:
        stated, change: as of :func:`_cheapest`.
        is_part: (n,) what that found.
        piece: first and last index.
    """
    first, last = piece
    state = bool(is_part[first])
    saved = float(stated[first : last + 1].sum()) * (1.0 if state else -1.0)
    if first > 0:
        saved += float(change[first]) * (1.0 if bool(is_part[first - 1]) is state else -1.0)
    if last + 1 < len(stated):
        saved += float(change[last + 1]) * (1.0 if bool(is_part[last + 1]) is state else -1.0)
    return saved


def _labelled(
    run: InkedRun, points: _Points, piece: tuple[int, int], part: bool, kept: float
) -> LabelledRun:
    first, last = piece
    count = len(points.odds)
    step = run.run.length / max(count - 1, 1)
    start = run.run.start + step * (first - 0.5 if first else 0)
    end = run.run.start + step * (last + 0.5) if last < count - 1 else run.run.end
    this_slice = slice(first, last + 1)
    weights = points.weights[this_slice] / points.weights[this_slice].sum()
    mean = weights @ points.log_p[this_slice]
    margin = float(weights @ points.odds[this_slice])
    network = float(weights @ points.network[this_slice])
    ink = likeliest(mean, part)
    why = Evidence.NETWORK
    if (margin > 0.0) is not part:
        why = Evidence.LINE
    elif (network > 0.0) is not part:
        why = Evidence.PEN
    support = kept if why is Evidence.LINE else None
    return LabelledRun(InkedRun(Run(start, end), run.width), ink, margin, mean, why, support)
