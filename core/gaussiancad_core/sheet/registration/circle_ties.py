"""Coordinates and radii that hold together: the side of a circle is its centre and its radius.

A hole's circle in one view and its sides, as lines, in another tell the same three numbers.  They
are found together by least squares, with the ties held exactly.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

_MOST = 1500
"""Unknowns up to which ties are held: drawings with more are no parts of a few views."""


_ROUNDS = 20
"""Times that ties are dropped before all are."""


@dataclass(frozen=True)
class Tie:
    """``values[edge] = values[centre] + side * values[radius]``, all by their numbers."""

    edge: int
    centre: int
    radius: int
    side: int


@dataclass(frozen=True, eq=False)
class Estimates:
    """What the views say about the unknowns.

    Attributes:
        information: (n, n) of all observations.
        start: (n,) values without ties.
        limits: (n,) by how much ties may move each.
        chains: numbers of unknowns whose values must keep rising.
    """

    information: Floats
    start: Floats
    limits: Floats
    chains: tuple[npt.NDArray[np.int64], ...]


def tied(known: Estimates, pull: Floats, ties: Sequence[Tie]) -> Floats:
    """(n,) the most likely values that hold the ties.

    Of the ties at a value that they would move further than it can be wrong, or past another, the
    one that fits worst is dropped, until the rest hold together.

    Args:
        known: what the views say.
        pull: (n,) information times observed values, summed over the observations.
        ties: of circles and their sides.
    """
    held = list(ties) if len(known.start) <= _MOST else []
    misfit = {tie: abs(_misfit(known.start, tie)) for tie in held}
    for _ in range(_ROUNDS):
        if not held:
            break
        values = _solved(known, pull, held)
        wrong = np.flatnonzero(_violated(known, values))
        if not len(wrong):
            return values
        worst = set()
        for number in wrong:
            touching = [tie for tie in held if number in (tie.edge, tie.centre, tie.radius)]
            if touching:
                worst.add(max(touching, key=misfit.__getitem__))
        # What is wrong without a tie of its own is so through others.
        for tie in worst or {max(held, key=misfit.__getitem__)}:
            held.remove(tie)
    return known.start


def _misfit(values: Floats, tie: Tie) -> float:
    return float(values[tie.edge] - values[tie.centre] - tie.side * values[tie.radius])


def _solved(known: Estimates, pull: Floats, ties: Sequence[Tie]) -> Floats:
    rows = np.zeros((len(ties), len(known.start)))
    for row, tie in zip(rows, ties, strict=True):
        row[[tie.edge, tie.centre, tie.radius]] = 1.0, -1.0, -float(tie.side)
    # Only what ties touch needs the null space; all else would make it large.
    touched = np.flatnonzero(np.abs(rows).sum(axis=0))
    free = np.setdiff1d(np.arange(len(known.start)), touched)
    inner = _null_space(rows[:, touched])
    basis = np.zeros((len(known.start), len(free) + inner.shape[1]))
    basis[free, np.arange(len(free))] = 1.0
    basis[touched, len(free) :] = inner
    system = basis.T @ known.information @ basis
    # Solved for the move from the start: that keeps the digits.
    right = basis.T @ (pull - known.information @ _projected(known.start, basis))
    found = np.linalg.lstsq(system, right, rcond=None)[0]
    return _projected(known.start, basis) + basis @ found


def _projected(values: Floats, basis: Floats) -> Floats:
    """The nearest values that hold the ties; the basis is orthonormal."""
    return basis @ (basis.T @ values)


def _violated(known: Estimates, values: Floats) -> npt.NDArray[np.bool_]:
    wrong = np.abs(values - known.start) > known.limits
    for chain in known.chains:
        falling = np.flatnonzero(np.diff(values[chain]) <= 0.0)
        wrong[chain[falling]] = True
        wrong[chain[falling + 1]] = True
    return wrong


def _null_space(rows: Floats) -> Floats:
    """(n, k) directions in which (m, n) rows say nothing."""
    _, sizes, ways = np.linalg.svd(rows)
    least = float(sizes.max(initial=0.0)) * max(rows.shape) * np.finfo(np.float64).eps
    return np.asarray(ways[int((sizes > least).sum()) :].T)
