"""Notes of holes against a solid: which of them it keeps, counted as the sheet counts them."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats
from gaussiancad_core.judging.lines_of_sight import crossings
from gaussiancad_core.judging.model_features import Bore, bores_of
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole

_COUNT = re.compile(r"^\s*(\d{1,3})\s*[x×X]\s*(?=[^\d\s]|\d)")

_INSIDE, _OUTSIDE = 0.96, 1.04
"""Shares of a hole's radius at which lines of sight run within it and around it."""

_AROUND = 16

_AGREE = 0.75
"""Share of the lines of sight that must meet the same: a hole may cut another one."""

_WIDTH = 0.02
"""Share of a radius by which a bore may be another one and still be as wide as a note says."""

_DEPTH = 0.02
"""Share of a depth, and of the longest extent times a tenth, by which it may be off."""


@dataclass(frozen=True)
class Tally:
    """A note, and how many of what it speaks of a solid has.

    Attributes:
        text: of the note.
        kind: ``hole``.
        at: (right, up) mm of the first hole in its view.
        role: name of this view.
        count_stated: that the sheet speaks of.
        count_found: that the solid has as the note says.
    """

    text: str
    kind: str
    at: tuple[float, float]
    role: str
    count_stated: int
    count_found: int

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
        kept = sum(_is_kept(solid, hole) for hole in group)
        counted = _COUNT.match(text)
        stated = max(len(group), int(counted.group(1)) if counted else 1)
        # Those for which no circle was found may be anywhere.
        others = min(stated - len(group), max(0, _alike(bores, group[0]) - kept))
        found.append(Tally(text, "hole", group[0].centre, role, stated, kept + others))
    return tuple(sorted(found, key=lambda each: each.agrees))


def _alike(bores: Sequence[Bore], hole: NotedHole) -> int:
    """How many bores run the way of a hole and are as wide as its narrowest step."""
    radius = min(step.diameter for step in hole.steps) / 2.0
    return sum(
        bore.axis is hole.role.frame.look_axis[0] and abs(bore.radius - radius) <= _WIDTH * radius
        for bore in bores
    )


def _is_kept(solid: FacetedSolid, hole: NotedHole) -> bool:
    """Whether a solid has a hole as its note says."""
    face = _first_depths(solid, hole, _OUTSIDE * max(s.diameter for s in hole.steps) / 2.0)
    solid_around = np.isfinite(face)
    if solid_around.mean() < _AGREE:
        return False
    start = float(np.median(face[solid_around]))
    return all(_has_step(solid, hole, step, start) for step in hole.steps)


def _has_step(solid: FacetedSolid, hole: NotedHole, step: HoleStep, start: float) -> bool:
    """Whether a hole has a cylinder of a diameter that reaches as deep as stated."""
    floors = _first_depths(solid, hole, _INSIDE * step.diameter / 2.0) - start
    longest = float(solid.extent.max())
    least = _DEPTH * 0.1 * longest
    if step.depth is None:
        return bool((floors > least).mean() >= _AGREE)
    slack = max(_DEPTH * step.depth, least)
    return bool((np.abs(floors - step.depth) <= slack).mean() >= _AGREE)


def _first_depths(solid: FacetedSolid, hole: NotedHole, radius: float) -> Floats:
    """(k,) mm along the look to what lines of sight on a circle meet first; infinite for
    nothing."""
    angles = 2.0 * np.pi * (np.arange(_AROUND) + 0.37) / _AROUND
    places = np.array(hole.centre) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    met = crossings(solid, hole.role.frame, places)
    return np.where(met.count > 0, met.depth[:, 0], np.inf)
