"""How much of some strokes runs along others, by length."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype

Floats = npt.NDArray[np.float64]
Box = tuple[float, float, float, float]

REACH = 1.0
"""px within which a stroke is another one."""

STEP = 0.5
"""px between points along a stroke."""

PARALLEL = float(np.cos(np.radians(20.0)))
"""Cosine of the largest angle between strokes that are the same."""


@dataclass(frozen=True)
class Matched:
    """Lengths in px of one linetype: all that was drawn and read, and what of it agrees."""

    drawn: float = 0.0
    drawn_found: float = 0.0
    read: float = 0.0
    read_true: float = 0.0

    @property
    def recall(self) -> float:
        """Share of what was drawn; 1 where nothing was."""
        return self.drawn_found / self.drawn if self.drawn else 1.0

    @property
    def precision(self) -> float:
        """Share of what was read; 1 where nothing was."""
        return self.read_true / self.read if self.read else 1.0


@dataclass(frozen=True)
class Points:
    """Points along strokes.

    Attributes:
        at: (n, 2) px, in the middle of each step.
        way: (n, 2) unit directions.
        weight: (n,) px of the stroke that each stands for.
    """

    at: Floats
    way: Floats
    weight: Floats

    @classmethod
    def along(cls, strokes: Iterable[DrawnStroke]) -> "Points":
        """Points every :data:`STEP` px at most."""
        steps, middles = [np.empty((0, 2))], [np.empty((0, 2))]
        for stroke in strokes:
            points = stroke.sample(STEP)
            steps.append(np.diff(points, axis=0))
            middles.append(0.5 * (points[1:] + points[:-1]))
        step, middle = np.concatenate(steps), np.concatenate(middles)
        length = np.hypot(*step.T)
        solid = length > 0.0
        return cls(middle[solid], step[solid] / length[solid, None], length[solid])

    def across(self, others: "Points", limit: float = REACH) -> Floats:
        """(n,) px across the nearest of the other points' strokes; inf beyond a limit in px."""
        error = np.full(len(self.at), np.inf)
        if not len(others.at) or not len(self.at):
            return error
        # The nearest step of a stroke at the limit is at most half a step farther along it.
        reach = float(np.hypot(limit, 0.5 * STEP))
        count = min(16, len(others.at))
        tree = cKDTree(others.at)
        distance, index = tree.query(self.at, k=count, distance_upper_bound=reach)
        distance, index = distance.reshape(-1, count), index.reshape(-1, count)
        for column in range(count):
            there = np.isfinite(distance[:, column]) & np.isinf(error)
            near = index[there, column]
            way, gap = others.way[near], self.at[there] - others.at[near]
            alike = np.abs((self.way[there] * way).sum(axis=1)) >= PARALLEL
            off = np.abs(way[:, 0] * gap[:, 1] - way[:, 1] * gap[:, 0])
            error[np.flatnonzero(there)[alike & (off <= limit)]] = off[alike & (off <= limit)]
        return error


def match(
    drawn: list[DrawnStroke], seen: list[DrawnStroke], covered: float
) -> tuple[dict[Linetype, Matched], Floats]:
    """Lengths of each linetype, and the errors of matched points in px.

    Args:
        drawn: the true strokes.
        seen: those that were read.
        covered: px beside a visible stroke within which a hidden one along it cannot be seen, so
            that reading it or not is the same.
    """
    truth = {kind: Points.along(of_kind(drawn, kind)) for kind in Linetype}
    reading = {kind: Points.along(of_kind(seen, kind)) for kind in Linetype}
    lengths, errors = {}, []
    for kind in Linetype:
        missed, error = truth[kind].across(reading[kind]), reading[kind].across(truth[kind])
        found, right = np.isfinite(missed), np.isfinite(error)
        asked, given = np.ones(len(found), bool), np.ones(len(right), bool)
        if kind is Linetype.HIDDEN:
            asked = np.isinf(truth[kind].across(truth[Linetype.VISIBLE], covered))
            given = ~right | np.isinf(reading[kind].across(truth[Linetype.VISIBLE], covered))
        lengths[kind] = Matched(
            float(truth[kind].weight[asked].sum()),
            float(truth[kind].weight[asked & found].sum()),
            float(reading[kind].weight[given].sum()),
            float(reading[kind].weight[given & right].sum()),
        )
        errors.append(error[right])
    return lengths, np.concatenate(errors)


def total(parts: Sequence[Matched]) -> Matched:
    """Lengths of several sheets."""
    names = ("drawn", "drawn_found", "read", "read_true")
    return Matched(*(float(np.sum([getattr(part, name) for part in parts])) for name in names))


def of_kind(strokes: Iterable[DrawnStroke], kind: Linetype) -> list[DrawnStroke]:
    """The strokes of a linetype."""
    return [stroke for stroke in strokes if stroke.linetype is kind]


def overlap(one: Box, other: Box) -> float:
    """Intersection over union of two boxes."""
    width = min(one[2], other[2]) - max(one[0], other[0])
    height = min(one[3], other[3]) - max(one[1], other[1])
    common = max(0.0, width) * max(0.0, height)
    areas = sum((box[2] - box[0]) * (box[3] - box[1]) for box in (one, other))
    return common / max(areas - common, 1e-9)
