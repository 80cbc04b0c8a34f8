"""Numbers that were read with errors, and equations that hold between them.

The numbers are moved as little as possible, by weighted least squares, until all equations hold
(Gauss-Newton on the equations; conditional adjustment in surveying).  An equation that moves a
number too far, or contradicts others, was no true one: it is dropped.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import numpy.typing as npt
from scipy.linalg import lstsq

Numbers = npt.NDArray[np.float64]

Terms = list[tuple[int, float]]
"""Numbers, by their place, with factors."""

_ROUNDS = 8
"""Linearisations, at most; linear equations need one."""

_HOLDS = 1e-9
"""Units within which an equation holds."""

_FULFILLED = 1e-6
"""The same once all are solved together."""

_STAYS = 0.9
"""Share of what was left of the equations from which another linearisation is in vain."""


class Relation(Protocol):
    """An equation: something that is to be zero."""

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """What it is for some numbers, in units, and its gradient."""


@dataclass(frozen=True)
class Linear:
    """A sum of numbers with factors, and of a constant, that is to be zero."""

    terms: tuple[tuple[int, float], ...]
    constant: float = 0.0

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`Relation`."""
        total = sum((factor * numbers[column] for column, factor in self.terms), self.constant)
        return float(total), list(self.terms)

    def holds(self, numbers: Numbers) -> bool:
        """Whether it is fulfilled, but for rounding errors."""
        return abs(self.at(numbers)[0]) <= _FULFILLED


def solved(
    observed: Sequence[float],
    weights: Sequence[float],
    relations: Sequence[Relation],
    far: float | Sequence[float],
) -> Numbers:
    """The numbers nearest to the observed ones that fulfil the relations.

    Args:
        observed: as read.
        weights: what each counts.
        relations: between them.
        far: units by which each number may move; relations that ask for more are dropped, worst
            first.

    Returns:
        The observed ones where no relation is left, or the equations cannot be solved.
    """
    start = np.array(observed, dtype=np.float64)
    spread = 1.0 / np.array(weights, dtype=np.float64)
    limit = np.broadcast_to(np.asarray(far, dtype=np.float64), start.shape)
    kept = list(relations)
    while kept:
        try:
            numbers, rows, left = _adjusted(start, spread, kept)
        except np.linalg.LinAlgError:
            break
        moved = np.abs(numbers - start) / limit
        worst = int(np.argmax(moved))
        if moved[worst] > 1.0:
            involved = np.flatnonzero(rows[:, worst])
            missed = np.array([abs(kept[row].at(start)[0]) for row in involved])
            del kept[int(involved[missed.argmax()])]
        elif np.abs(left).max() > _HOLDS:
            del kept[int(np.abs(left).argmax())]
        else:
            return numbers
    return start


def _adjusted(
    start: Numbers, spread: Numbers, relations: Sequence[Relation]
) -> tuple[Numbers, Numbers, Numbers]:
    """Numbers that fulfil the relations, their gradients there, and what is left of each."""
    numbers = start
    rows = np.zeros((len(relations), len(start)))
    left = np.zeros(len(relations))
    before = np.inf
    for _ in range(_ROUNDS):
        rows[:] = 0.0
        for row, relation in enumerate(relations):
            left[row], terms = relation.at(numbers)
            for column, factor in terms:
                rows[row, column] += factor
        most = np.abs(left).max(initial=0.0)
        # What contradicts each other stays so.
        if most <= _HOLDS or most > _STAYS * before:
            break
        before = most
        wanted = left + rows @ (start - numbers)
        gram = (rows * spread) @ rows.T
        multipliers = lstsq(gram, wanted, cond=1e-12, lapack_driver="gelsy")[0]
        numbers = start - spread * (rows.T @ multipliers)
    return numbers, rows, left
