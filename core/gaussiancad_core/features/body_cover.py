"""The fewest and simplest bodies that make up a solid: pads, less pockets.

Each point in the solid is in a pad and in no pocket; each outside of it is in no pad, or in a
pocket.  Which bodies are taken is a weighted covering problem, solved by CP-SAT.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from ortools.sat.python import cp_model

from gaussiancad_core.features.sample_points import Samples
from gaussiancad_core.features.sweeps import Sweep, SweptPlane

_OF_AN_EDGE, _OF_A_BODY = 1000, 3000
"""What each edge of an outline weighs, and each body; a unit of its length weighs 1, so that of the
same plate the thickness is its length."""

_SAME_LENGTH = 3
"""Decimal places of units within which outlines are as long."""

_MOST_EFFORT = 4.0
"""Deterministic seconds of the solver."""


@dataclass(frozen=True, eq=False)
class Choice:
    """The bodies that are offered, and which points each of them covers.

    Attributes:
        sweeps: on offer.
        covers: (sweeps, points) bool.
    """

    sweeps: tuple[Sweep, ...]
    covers: npt.NDArray[np.bool_]


def offered(sweeps: Sequence[Sweep], planes: Sequence[SweptPlane], samples: Samples) -> Choice:
    """The bodies that may be part of a solid: no pocket takes away what is material.

    Args:
        sweeps: candidates.
        planes: by the numbers that the sweeps carry.
        samples: of the solid.
    """
    where = [plane.located(samples.points) for plane in planes]
    kept, covers = [], []
    for sweep in sweeps:
        covered = sweep.covers(*where[sweep.plane])
        if not covered.any():
            continue
        if sweep.adds or not bool((covered & samples.is_inside).any()):
            kept.append(sweep)
            covers.append(covered)
    table = np.array(covers, dtype=bool).reshape(len(kept), len(samples.points))
    return Choice(tuple(kept), table)


def cheapest_cover(choice: Choice, samples: Samples) -> tuple[Sweep, ...] | None:
    """The bodies whose outlines have the fewest edges; None where none of them make up the
    solid."""
    model = cp_model.CpModel()
    taken = [model.new_bool_var("") for _ in choice.sweeps]
    adds = np.array([sweep.adds for sweep in choice.sweeps], dtype=bool)
    for covered, is_inside in _distinct(choice.covers, samples.is_inside):
        pads = [taken[k] for k in np.flatnonzero(covered & adds)]
        pockets = [taken[k] for k in np.flatnonzero(covered & ~adds)]
        if is_inside:
            if not pads:
                return None
            model.add_bool_or(pads)
        else:
            for pad in pads:
                model.add_bool_or([~pad, *pockets])
    model.minimize(sum(_weighed(model, choice.sweeps, taken)))
    solver = cp_model.CpSolver()
    solver.parameters.max_deterministic_time = _MOST_EFFORT
    solver.parameters.num_workers = 1
    if solver.solve(model) not in (cp_model.OPTIMAL, cp_model.FEASIBLE):
        return None
    return tuple(
        sweep for sweep, var in zip(choice.sweeps, taken, strict=True) if solver.value(var)
    )


def _weighed(
    model: cp_model.CpModel, sweeps: Sequence[Sweep], taken: Sequence[cp_model.IntVar]
) -> Iterator[cp_model.LinearExpr]:
    """What bodies weigh if they are taken: of like ones only one has a sketch of its own."""
    alike: dict[tuple[object, ...], list[int]] = {}
    for k, sweep in enumerate(sweeps):
        outline = sweep.edges, round(sweep.border, _SAME_LENGTH)
        alike.setdefault((sweep.plane, sweep.ends, sweep.adds, *outline), []).append(k)
    for group in alike.values():
        first = sweeps[group[0]]
        weight = _OF_A_BODY + _OF_AN_EDGE * first.edges + round(first.ends[1] - first.ends[0])
        if len(group) == 1 or first.ends == (0.0, 0.0):
            yield from (weight * taken[k] for k in group)
            continue
        sketched = model.new_bool_var("")
        for k in group:
            model.add_implication(taken[k], sketched)
            yield _OF_A_BODY * taken[k]
        yield (weight - _OF_A_BODY) * sketched


def _distinct(
    covers: npt.NDArray[np.bool_], is_inside: npt.NDArray[np.bool_]
) -> list[tuple[npt.NDArray[np.bool_], bool]]:
    """The different columns: points that the same bodies cover say the same."""
    columns = np.vstack([covers, is_inside[None]]).T
    return [(column[:-1], bool(column[-1])) for column in np.unique(columns, axis=0)]
