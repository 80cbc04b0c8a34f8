"""Numbers that were read with errors, and equations that hold between them.

The numbers are moved as little as possible, by weighted least squares, until all equations hold
(Gauss-Newton on the equations; conditional adjustment in surveying).  An equation that moves a
number too far, or contradicts others, was no true one: it is dropped.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Protocol

import numpy as np
import numpy.typing as npt
from scipy.linalg import cho_solve
from scipy.linalg.lapack import dlange, dpstrf, dtrtrs
from scipy.sparse import csr_array

from gaussiancad_core.geometry.tolerances import COMPUTED

Numbers = npt.NDArray[np.float64]

Places = npt.NDArray[np.intp]

Terms = Sequence[tuple[int, float]]
"""Numbers, by their place, with factors."""

_ROUNDS = 8
"""Linearisations, at most; linear equations need one."""

_HOLDS = 1e-9
"""Units within which an equation holds."""

_STAYS = 0.9
"""Share of what was left of the equations from which another linearisation is in vain."""

_INDEPENDENT = 1e-12
"""Share of the largest multiplier's effect below which an equation follows from others."""


class Relation(Protocol):
    """An equation: something that is to be zero."""

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """What it is for some numbers, in units, and its gradient, of the same numbers always."""


@dataclass(frozen=True)
class Linear:
    """A sum of numbers with factors, and of a constant, that is to be zero."""

    terms: tuple[tuple[int, float], ...]
    constant: float = 0.0

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`Relation`."""
        total = sum((factor * numbers[column] for column, factor in self.terms), self.constant)
        return float(total), self.terms

    def holds(self, numbers: Numbers) -> bool:
        """Whether it is fulfilled, but for rounding errors."""
        return abs(self.at(numbers)[0]) <= COMPUTED


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
        The observed ones where no relation is left.
    """
    start = np.array(observed, dtype=np.float64)
    spread = 1.0 / np.array(weights, dtype=np.float64)
    limit = np.broadcast_to(np.asarray(far, dtype=np.float64), start.shape)
    equations = _Equations(relations, start)
    kept = np.arange(len(relations))
    while len(kept):
        numbers, moves, left = _adjusted(equations, kept, spread)
        moved = np.abs(numbers - start) / limit
        worst = int(np.argmax(moved))
        if moved[worst] > 1.0:
            involved = np.flatnonzero(moves[worst])
            dropped = involved[np.abs(equations.missed[kept[involved]]).argmax()]
        elif np.abs(left).max() > _HOLDS:
            dropped = np.abs(left).argmax()
        else:
            return numbers
        kept = np.delete(kept, dropped)
    return start


class _Equations:
    """Relations as rows of a sparse matrix, which stay what they are for linear ones.

    Attributes:
        start: (n,) numbers as read.
        missed: (m,) what the relations are for these.
    """

    def __init__(self, relations: Sequence[Relation], start: Numbers) -> None:
        # Single numbers of a list are read faster than those of an array.
        values = start.tolist()
        found = [relation.at(values) for relation in relations]
        terms = list(chain.from_iterable(terms for _, terms in found))
        ends = np.cumsum([0, *(len(terms) for _, terms in found)])
        columns = np.array([column for column, _ in terms], dtype=np.intp)
        factors = np.array([factor for _, factor in terms], dtype=np.float64)
        self.start, self.missed = start, np.array([value for value, _ in found])
        self._rows = csr_array((factors, columns, ends), shape=(len(found), len(start)))
        self._relations = relations
        self._curved = np.array(
            [not isinstance(relation, Linear) for relation in relations], dtype=bool
        )

    def at(self, numbers: Numbers, kept: Places) -> tuple[Numbers, csr_array]:
        """What some of them are for some numbers, and their gradients: (k,) and (k, n)."""
        rows = self._rows[kept]
        left = self.missed[kept] + rows @ (numbers - self.start)
        curved = self._curved[kept]
        if numbers is not self.start and curved.any():
            values = numbers.tolist()
            found = [self._relations[place].at(values) for place in kept[curved]]
            left[curved] = [value for value, _ in found]
            factors = [factor for _, terms in found for _, factor in terms]
            rows.data[np.repeat(curved, np.diff(rows.indptr))] = factors
        return left, rows


def _adjusted(
    equations: _Equations, kept: Places, spread: Numbers
) -> tuple[Numbers, Numbers, Numbers]:
    """Numbers that fulfil equations as far as can be.

    Args:
        equations: between the numbers.
        kept: (k,) places of those that count.
        spread: (n,) how readily each number moves.

    Returns:
        The numbers; (n, k) by how much an equation's multiplier moves each; (k,) what is left of
        each equation.
    """
    start = numbers = equations.start
    before = np.inf
    for _ in range(_ROUNDS):
        left, rows = equations.at(numbers, kept)
        moves = np.zeros(rows.shape[::-1])
        of = np.repeat(np.arange(len(kept)), np.diff(rows.indptr))
        np.add.at(moves, (rows.indices, of), rows.data * spread[rows.indices])
        most = np.abs(left).max(initial=0.0)
        # What contradicts each other stays so.
        if most <= _HOLDS or most > _STAYS * before:
            break
        before = most
        wanted = left + rows @ (start - numbers)
        numbers = start - moves @ _multipliers(rows @ moves, wanted)
    return numbers, moves, left


def _multipliers(gram: Numbers, wanted: Numbers) -> Numbers:
    """What solves a symmetric positive semi-definite system best, by pivoted Cholesky factors.

    Rows that follow from others take no part, but for what the system cannot give: that is left
    spread over all of them, as least squares has it.

    Args:
        gram: (m, m) matrix; what it holds is lost.
        wanted: (m,) right side.
    """
    least = _INDEPENDENT * dlange("1", gram.T)
    factor, places, rank, _ = dpstrf(gram.T, tol=least, lower=True, overwrite_a=True)
    places -= 1
    given, missed = wanted[places], wanted[places[rank:]]
    if len(missed):
        # Each of the other rows is a combination of the independent ones; those stand in for it.
        others = np.pad(factor[rank:, :rank], ((0, 0), (0, len(missed)))).T
        factor[rank:] = np.eye(len(factor) - rank, factor.shape[1], k=rank)
        shares, _ = dtrtrs(factor, others, lower=True, trans=1)
        given[rank:] = 0.0
        missed = missed - given @ shares
        given += shares @ np.linalg.solve(np.eye(len(missed)) + shares.T @ shares, missed)
    multipliers = np.empty_like(wanted)
    multipliers[places] = cho_solve((factor, True), given, check_finite=False)
    return multipliers
