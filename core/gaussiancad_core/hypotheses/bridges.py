"""Gaps between the end of one drawn curve and another, closed.

Curves of intersection are known as points only, and drawings leave out the shortest strokes.  Where
a curve ends a hair before another one, the outside would leak into the part.
"""

from collections.abc import Sequence
from math import hypot

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.coordinates.point_chains import Chain
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import ON_CURVE
from gaussiancad_core.geometry.whole_curves import Circle


def bridges(arrangement: Arrangement, chains: Sequence[Chain], reach: float) -> list[Chain]:
    """Links from ends that touch nothing to the nearest curve within reach.

    Args:
        arrangement: of the carriers.
        chains: the other boundaries.
        reach: units.
    """
    found: list[Chain] = []
    for number, (index, low, high) in enumerate(arrangement.stretches):
        curve = arrangement.carriers[index].curve
        if isinstance(curve, Circle) and high - low > FULL_TURN - 1e-9:
            continue
        for end in (curve.at(low), curve.at(high)):
            found += _bridge(end, _feet(arrangement, chains, end, number, None), reach, found)
    for value, chain in enumerate(chains):
        for end in (chain[0], chain[-1]):
            found += _bridge(end, _feet(arrangement, chains, end, None, value), reach, found)
    return found


def _bridge(
    end: Point, feet: npt.NDArray[np.float64], reach: float, known: Sequence[Chain]
) -> list[Chain]:
    """A link over the gap at an end, unless the gap has one from its other side."""
    if not len(feet):
        return []
    away = np.hypot(*(feet - np.array(end)).T)
    nearest = int(away.argmin())
    if not ON_CURVE < away[nearest] <= reach:
        return []
    foot = (float(feet[nearest, 0]), float(feet[nearest, 1]))
    if any(hypot(foot[0] - a, foot[1] - b) <= reach for (a, b), _ in known):
        return []
    return [(end, foot)]


def _feet(
    arrangement: Arrangement,
    chains: Sequence[Chain],
    end: Point,
    own_stretch: int | None,
    own_chain: int | None,
) -> npt.NDArray[np.float64]:
    """The nearest point of each other stretch and chain to an end."""
    feet = []
    for number, (index, low, high) in enumerate(arrangement.stretches):
        if number != own_stretch:
            curve = arrangement.carriers[index].curve
            feet.append(curve.at(_clamped(curve.parameter(end), low, high, curve)))
    for number, chain in enumerate(chains):
        if number != own_chain:
            feet.append(_chain_foot(np.array(chain), np.array(end)))
    return np.array(feet).reshape(-1, 2)


def _clamped(at: float, low: float, high: float, curve: object) -> float:
    if low <= at <= high:
        return at
    if not isinstance(curve, Circle):
        return min(max(at, low), high)
    to_low, to_high = (
        (at - low + np.pi) % FULL_TURN - np.pi,
        (at - high + np.pi) % FULL_TURN - np.pi,
    )
    return low if abs(to_low) < abs(to_high) else high


def _chain_foot(
    chain: npt.NDArray[np.float64], point: npt.NDArray[np.float64]
) -> tuple[float, float]:
    starts, intervals = chain[:-1], np.diff(chain, axis=0)
    squares = np.maximum((intervals**2).sum(axis=1), 1e-300)
    shares = np.clip(((point - starts) * intervals).sum(axis=1) / squares, 0.0, 1.0)
    feet = starts + shares[:, None] * intervals
    best = feet[int(np.hypot(*(feet - point).T).argmin())]
    return float(best[0]), float(best[1])
