"""Whether a line of a drawing is visible, hidden, or no line at all: two sight lines decide.

Just beside the line, on both of its sides, a line of sight meets a column of surfaces.  Where the
columns agree at every depth there is nothing to draw.  Otherwise the first disagreement is what the
line shows; it is hidden if both columns meet a common surface before it.
"""

from enum import Enum

import numpy as np

from gaussiancad_core.kernel.solid_edges import SMOOTH_ANGLE
from gaussiancad_core.kernel.solid_rays import Column, SightLines
from gaussiancad_core.kernel.surface_crossings import Array
from gaussiancad_core.model.axes import ViewFrame

_OFFSETS = (1.0, 2.0, 0.5, 4.0, 12.0)
"""Distances beside the line that are tried in turn, in multiples of the first."""

_FAR_OFFSETS = (40.0, 100.0)
"""Distances tried where faces overlap or gape at their borders, as in loosely sewn solids."""


class Visibility(Enum):
    """What two columns beside a point say about a line through it.

    The smooth ones are where one face passes smoothly into another; nothing is to be seen there
    unless tangent edges are wanted.
    """

    VISIBLE = "visible"
    HIDDEN = "hidden"
    SMOOTH_VISIBLE = "smooth-visible"
    SMOOTH_HIDDEN = "smooth-hidden"
    BLANK = "blank"
    UNCERTAIN = "uncertain"


_UNSETTLED = tuple(set(Visibility) - {Visibility.VISIBLE, Visibility.HIDDEN})


class RayTest:
    """Looks beside lines of one view.

    Args:
        sight: the solid's sight lines.
        frame: the view.
        offset: mm between a line and the sight lines beside it.
    """

    def __init__(self, sight: SightLines, frame: ViewFrame, offset: float) -> None:
        self._sight = sight
        self._look = np.array(frame.look, dtype=np.float64)
        self._plane = np.array([frame.right, frame.up], dtype=np.float64)
        self._offset = offset

    def visibility_of(self, points: Array, normals: Array, slacks: Array) -> list[Visibility]:
        """What lines through points show.

        Args:
            points: (n, 2) mm on the lines.
            normals: (n, 2) unit vectors across the lines.
            slacks: (n,) mm by which the solid's faces may miss the lines.
        """
        steps = np.maximum(self._offset, 1.5 * slacks)[:, None] * normals
        answers = [Visibility.UNCERTAIN] * len(points)
        for factor in (*_OFFSETS, *_FAR_OFFSETS):
            # A line that is known to a tolerance only may lie beside both near sight lines.
            unsettled = _UNSETTLED if factor in _OFFSETS else (Visibility.UNCERTAIN,)
            self._ask(answers, unsettled, points, factor * steps)
        self._ask(answers, (Visibility.UNCERTAIN,), points, steps, trusting=True)
        return answers

    def _ask(
        self,
        answers: list[Visibility],
        again: tuple[Visibility, ...],
        points: Array,
        across: Array,
        *,
        trusting: bool = False,
    ) -> None:
        """Replace those answers that are to be asked again by better ones.

        A solid may have a fault; ``trusting`` takes what faulty columns say.
        """
        asked = [number for number, answer in enumerate(answers) if answer in again]
        if not asked:
            return
        found = self._look_beside(points[asked], across[asked], trusting)
        for number, answer in zip(asked, found, strict=True):
            if answer is not Visibility.UNCERTAIN:
                answers[number] = answer

    def _look_beside(
        self, points: Array, across: Array, trusting: bool = False
    ) -> list[Visibility]:
        columns = self._sight.columns(np.concatenate([points + across, points - across]))
        pairs = zip(columns[: len(points)], columns[len(points) :], strict=True)
        return [
            self._compare(one, other, 2.0 * way)
            if trusting or (one.sound and other.sound)
            else Visibility.UNCERTAIN
            for (one, other), way in zip(pairs, across, strict=True)
        ]

    def _compare(self, one: Column, other: Column, across: Array) -> Visibility:
        """``across`` is the (2,) way in the plane from the other column to the first."""
        matches = self._matches(one, other, across)
        shared_one, shared_other = set(matches), set(matches.values())
        lone = [one.depth[i] for i in range(len(one.depth)) if i not in shared_one]
        lone += [other.depth[i] for i in range(len(other.depth)) if i not in shared_other]
        if not lone:
            return _smooth(one, other, matches)
        before = [min(one.depth[i], other.depth[j]) for i, j in matches.items()]
        hidden = bool(before) and min(before) < min(lone)
        return Visibility.HIDDEN if hidden else Visibility.VISIBLE

    def _matches(self, one: Column, other: Column, across: Array) -> dict[int, int]:
        """Hits of the first column that continue on the same surface in the other."""
        way = across @ self._plane
        slope_one, slope_other = self._slopes(one, way), self._slopes(other, way)
        free = set(range(len(other.depth)))
        matches: dict[int, int] = {}
        for i in range(len(one.depth)):
            best: tuple[float, int] | None = None
            for j in free:
                if not self._continues(one, i, other, j):
                    continue
                expected = 0.5 * (slope_one[i] + slope_other[j])
                slack = abs(slope_one[i] - slope_other[j]) + 0.5 * float(np.hypot(*across))
                error = abs(one.depth[i] - other.depth[j] - expected)
                if error <= slack and (best is None or error < best[0]):
                    best = error, j
            if best is not None:
                matches[i] = best[1]
                free.discard(best[1])
        return matches

    def _slopes(self, column: Column, way: Array) -> Array:
        """(k,) change of depth over ``way`` on each hit's tangent plane."""
        towards = column.normal @ self._look
        return -(column.normal @ way) / np.where(np.abs(towards) < 1e-9, np.nan, towards)

    def _continues(self, one: Column, i: int, other: Column, j: int) -> bool:
        first, second = one.normal[i], other.normal[j]
        if (first @ self._look < 0.0) != (second @ self._look < 0.0):
            return False
        return bool(one.face[i] == other.face[j] or first @ second > np.cos(SMOOTH_ANGLE))


def _smooth(one: Column, other: Column, matches: dict[int, int]) -> Visibility:
    """What columns that agree say: the nearest change of face, if there is any."""
    changes = [i for i, j in matches.items() if one.face[i] != other.face[j]]
    if not changes:
        return Visibility.BLANK
    return Visibility.SMOOTH_VISIBLE if min(changes) == 0 else Visibility.SMOOTH_HIDDEN
