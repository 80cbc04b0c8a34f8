"""Notes of holes against a solid: which of them it keeps, counted as the sheet counts them."""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats
from gaussiancad_core.judging.lines_of_sight import crossings
from gaussiancad_core.judging.model_features import Bore, bores_of
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole

_COUNT = re.compile(r"^\s*(\d{1,3})\s*[x×X]\s*(?=[^\d\s]|\d)")

_ASIDE = 0.03
"""Share of a hole's radius inside and outside of its cylinder at which the solid is looked
through."""

_AROUND = 16

_KEPT = 0.5
"""Share of the lines of sight around a hole that must find it: others pass through what crosses
it."""

_SAME = 0.02
"""Share of a hole's radius and depth by which the solid's may differ from what the note says."""

_FINE = 1e-3
"""The same as a share of the longest extent: round faces are looked at as facets."""


@dataclass(frozen=True)
class Tally:
    """A note, and how many of what it speaks of a solid has.

    Attributes:
        text: of the note.
        kind: ``hole``.
        at: (right, up) mm of the first hole in its view that is not kept, or else of the first.
        role: name of this view.
        count_stated: that the sheet speaks of.
        count_found: that the solid has as the note says.
        count_otherwise: of those whose circles the sheet shows, how many are not as it says.
    """

    text: str
    kind: str
    at: tuple[float, float]
    role: str
    count_stated: int
    count_found: int
    count_otherwise: int = 0

    @property
    def agrees(self) -> bool:
        """Whether all are there."""
        return self.count_found >= self.count_stated


def tally(solid: FacetedSolid, holes: Iterable[NotedHole]) -> tuple[Tally, ...]:
    """The notes of holes against a solid, those that it does not keep first.

    Args:
        solid: on the sheet's axes, mm.
        holes: of which notes speak, each at its circle.
    """
    groups: dict[tuple[str, str], list[NotedHole]] = {}
    for hole in holes:
        groups.setdefault((hole.text, hole.role.value), []).append(hole)
    found, bores = [], bores_of(solid)
    for (text, role), group in groups.items():
        otherwise = [hole for hole in group if not all(_steps_kept(solid, hole))]
        kept = len(group) - len(otherwise)
        counted = _COUNT.match(text)
        stated = max(len(group), int(counted.group(1)) if counted else 1)
        # Those for which no circle was found may be anywhere.
        others = min(stated - len(group), max(0, _alike(bores, group[0]) - kept))
        at = (otherwise or group)[0].centre
        found.append(Tally(text, "hole", at, role, stated, kept + others, len(otherwise)))
    return tuple(sorted(found, key=lambda each: each.agrees))


def kept_notes(solid: FacetedSolid, holes: Iterable[NotedHole]) -> frozenset[Box]:
    """The boxes of notes whose every cylinder a solid has, px of the upright sheet.

    Args:
        solid: on the sheet's axes, mm.
        holes: of which notes speak.
    """
    kept: set[Box] = set()
    broken: set[Box] = set()
    for hole in holes:
        for step, is_kept in zip(hole.steps, _steps_kept(solid, hole), strict=True):
            (kept if is_kept else broken).update(step.notes)
    return frozenset(kept - broken)


def _alike(bores: Sequence[Bore], hole: NotedHole) -> int:
    """How many bores run the way of a hole and are as wide as its narrowest step."""
    radius = min(step.diameter for step in hole.steps) / 2.0
    return sum(
        bore.axis is hole.role.frame.look_axis[0] and abs(bore.radius - radius) <= _SAME * radius
        for bore in bores
    )


def _steps_kept(solid: FacetedSolid, hole: NotedHole) -> Iterator[bool]:
    """Whether a solid has each cylinder of a hole as the note says."""
    if not hole.steps:
        return
    fine = _FINE * float(solid.extent.max())
    widest = max(step.diameter for step in hole.steps)
    around = _material(solid, hole, (1.0 + _ASIDE) * widest / 2.0)
    for step in hole.steps:
        inner = _material(solid, hole, (1.0 - _ASIDE) * step.diameter / 2.0)
        outer = _material(solid, hole, (1.0 + _ASIDE) * step.diameter / 2.0)
        slack = _SAME * max(step.depth or 0.0, step.diameter / 2.0) + fine
        kept = [_has(step, *each, slack) for each in zip(inner, outer, around, strict=True)]
        yield float(np.mean(kept)) >= _KEPT


Intervals = Sequence[tuple[float, float]]
"""mm along the look from and to which a line of sight lies in material."""


def _material(solid: FacetedSolid, hole: NotedHole, radius: float) -> list[Intervals]:
    """What lines of sight on a circle around a hole pass through."""
    angles = 2.0 * np.pi * (np.arange(_AROUND) + 0.37) / _AROUND
    places = np.array(hole.centre) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    met = crossings(solid, hole.role.frame, places)
    return [_pairs(depth[:count]) for depth, count in zip(met.depth, met.count, strict=True)]


def _pairs(depth: Floats) -> Intervals:
    values = depth.tolist()
    return list(zip(values[::2], values[1::2], strict=False))


def _has(
    step: HoleStep, inside: Intervals, outside: Intervals, face: Intervals, slack: float
) -> bool:
    """Whether a cylinder is empty as far as its note says, and no farther, and stands in material.

    Args:
        step: of the hole.
        inside, outside: what is passed through on either side of the cylinder.
        face: the same beside the hole's widest cylinder.
        slack: mm.
    """
    if not face or not outside:
        return False
    if step.depth is None:
        return any(
            _is_void(inside, low + slack, high - slack) and not _is_void(outside, low, high)
            for low, high in face
        )
    return any(
        _is_void(inside, low, floor - slack)
        and not _is_void(inside, floor - slack, floor + slack)
        and not _is_void(outside, low, floor - slack)
        for low, floor in ((low, low + step.depth) for low, _ in face)
    )


def _is_void(intervals: Intervals, low: float, high: float) -> bool:
    """Whether a line of sight lies in no material between two depths."""
    return not any(start < high and end > low for start, end in intervals)
