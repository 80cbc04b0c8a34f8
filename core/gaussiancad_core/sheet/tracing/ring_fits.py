"""Which circles about a known centre are drawn, told by the ink at each distance from it.

Averaged all around, the ink is the sum of the pens' profiles over the circles, each as dark as
dashes are on the mean.  It is taken apart by least squares: non-negative ones for how dark the
circles are (Lawson and Hanson 1974), bounded ones for where they lie.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares, nnls
from scipy.special import ndtr

Floats = npt.NDArray[np.float64]

_SOFT = 0.5
"""Standard deviation in px of the edges of a line."""

SAME_PX, _BESIDE_PX = 0.6, 1.5
"""px between radii that are one, and where one of them is of a circle that is drawn through."""

_RISING, _PAPER = 0.03, 0.04
"""By how much ink rises to a circle, and up to which it is paper."""

_UNEXPLAINED, _MORE = 0.15, 3
"""Ink of a mean that shows another circle, and how many are added to a stretch at most."""

_DASHED, _DASHED_MOST = 0.25, 0.9
"""Share of a dashed circle that has ink."""

_SOLID = 0.85
"""Ink all along a circle that is drawn through, at least."""

_MOVED_PX = 0.6
"""px by which radii are off at first, at most."""

_HELD_FREE, _HELD_TOLD = 0.1, 0.4
"""Ink unexplained that a px of it is worth: of radii that the ink tells, and of known ones."""

_SECTORS, _MISSING_SECTORS = 8, 1
"""Parts of a turn, and in how many of them a circle may lie under something else."""

_WIDTHS = np.linspace(0.4, 1.15, 16)
_SOLID_WIDTHS = np.linspace(0.85, 1.35, 6)
"""Pens of dashes and of visible lines that are tried, in widths of the sheet's lines."""


@dataclass(frozen=True)
class Ring:
    """A circle about the centre.

    Attributes:
        radius: px.
        solid: whether it is drawn through, not dashed.
        held: ink unexplained that a px beside its place is worth.
    """

    radius: float
    solid: bool
    held: float = _HELD_FREE


@dataclass(frozen=True, eq=False)
class InkAbout:
    """The ink about a centre.

    Attributes:
        radii: (n,) px, evenly spaced.
        polar: (n, m) weight at these radii and m angles of a turn.
    """

    radii: Floats
    polar: Floats

    @cached_property
    def mean(self) -> Floats:
        """(n,) over all angles."""
        return self.polar.mean(axis=1)

    def of_sector(self, index: int) -> Floats:
        """(n,) over one of the parts of a turn."""
        return np.array_split(self.polar, _SECTORS, axis=1)[index].mean(axis=1)

    def ring_at(self, radius: float, held: float = _HELD_FREE) -> Ring:
        """The ring of a radius, drawn through or dashed as the ink there is."""
        at = int(np.argmin(np.abs(self.radii - radius)))
        pale = sum(self.of_sector(k)[at] < _SOLID for k in range(_SECTORS))
        return Ring(float(radius), bool(pale <= _MISSING_SECTORS), held)


def fit_rings(ink: InkAbout, stated: Sequence[float], width: float) -> list[Ring]:
    """The circles that are drawn: those told that have ink, and those that only the ink tells.

    Args:
        ink: about their centre.
        stated: radii at which there may be one, px.
        width: of the sheet's lines, px.
    """
    from scipy.signal import find_peaks

    peaks = ink.radii[find_peaks(ink.mean, height=_DASHED / 2.0, prominence=_RISING)[0]]
    known = [ink.ring_at(radius, _HELD_TOLD) for radius in stated]
    rings = _distinct([*known, *(ink.ring_at(radius) for radius in peaks)])
    parts = []
    for low, high in _stretches(ink):
        part = InkAbout(ink.radii[low:high], ink.polar[low:high])
        inside = [ring for ring in rings if part.radii[0] <= ring.radius <= part.radii[-1]]
        parts.append((part, inside))
    pens = _pen(parts, width, solid=True), _pen(parts, width, solid=False)
    found = [ring for part, inside in parts for ring in _told_apart(part, inside, pens)]
    return [ring for ring, flag in zip(found, _shown(ink, found, pens), strict=True) if flag]


def _distinct(rings: Sequence[Ring]) -> list[Ring]:
    """One of each group of rings that are alike, the first one."""
    kept: list[Ring] = []
    for ring in rings:
        if not _is_beside(ring.radius, kept):
            kept.append(ring)
    return kept


def _is_beside(radius: float, rings: Sequence[Ring]) -> bool:
    """Whether there is no room for a circle beside others."""
    return any(
        abs(radius - other.radius) < (_BESIDE_PX if other.solid else SAME_PX) for other in rings
    )


def _stretches(ink: InkAbout) -> Iterator[tuple[int, int]]:
    """First and last index, exclusive, of radii that have ink one after the other."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], ink.mean > _PAPER, [False]])))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


def _told_apart(ink: InkAbout, rings: list[Ring], pens: tuple[float, float]) -> list[Ring]:
    """Circles where they explain most of a stretch of ink, and more where they do not."""
    for _ in range(_MORE + 1):
        rings = _moved(ink, rings, pens)
        left = ink.mean - _explained(ink, rings, pens)
        worst = int(np.argmax(left))
        radius = float(ink.radii[worst])
        if left[worst] < _UNEXPLAINED or _is_beside(radius, rings):
            break
        rings = [*rings, ink.ring_at(radius)]
    return rings


def _pen(parts: Sequence[tuple[InkAbout, list[Ring]]], width: float, solid: bool) -> float:
    """Width in px of the lines of circles that are drawn through, or of dashed ones: where they are
    alone and explain the ink best."""
    tried = [
        (float(np.square(part.mean - _explained(part, rings, (pen, pen))).mean()), float(pen))
        for part, rings in parts
        if rings and all(ring.solid is solid for ring in rings)
        for pen in width * (_SOLID_WIDTHS if solid else _WIDTHS)
    ]
    return min(tried, default=(0.0, width))[1]


def _explained(ink: InkAbout, rings: Sequence[Ring], pens: tuple[float, float]) -> Floats:
    profiles = _profiles(ink.radii, rings, pens)
    return profiles @ nnls(profiles, ink.mean)[0] if rings else np.zeros(len(ink.radii))


def _moved(ink: InkAbout, rings: list[Ring], pens: tuple[float, float]) -> list[Ring]:
    """Circles a little off where they explain most of the ink."""
    if not rings:
        return []
    start = np.array([ring.radius for ring in rings])
    held = np.array([ring.held for ring in rings])

    def placed(places: Floats) -> list[Ring]:
        return [replace(r, radius=float(p)) for r, p in zip(rings, places, strict=True)]

    def off(places: Floats) -> Floats:
        left = ink.mean - _explained(ink, placed(places), pens)
        return np.append(left, held * (places - start))

    bounds = start - _MOVED_PX, start + _MOVED_PX
    return placed(least_squares(off, start, bounds=bounds, diff_step=1e-4).x)


def _profiles(radii: Floats, rings: Sequence[Ring], pens: tuple[float, float]) -> Floats:
    """(n, k) ink at some radii of circles drawn with their pens."""
    columns = [_profile(radii - ring.radius, pens[0 if ring.solid else 1]) for ring in rings]
    return np.array(columns).reshape(len(columns), len(radii)).T


def _profile(offsets: Floats, width: float) -> Floats:
    """Ink across a line of a width in px."""
    low, high = (offsets - width / 2.0) / _SOFT, (offsets + width / 2.0) / _SOFT
    return ndtr(high) - ndtr(low)


def _shown(ink: InkAbout, rings: Sequence[Ring], pens: tuple[float, float]) -> Iterator[bool]:
    """Of each circle whether it is drawn through, or has as much ink as dashes have, nearly all
    around."""
    if not rings:
        return
    profiles = _profiles(ink.radii, rings, pens)
    whole = nnls(profiles, ink.mean)[0]
    sectors = np.array([nnls(profiles, ink.of_sector(k))[0] for k in range(_SECTORS)])
    missing = (sectors < _DASHED / 2.0).sum(axis=0)
    for ring, amount, blank in zip(rings, whole, missing, strict=True):
        dark = _DASHED < amount < _DASHED_MOST
        yield ring.solid or (bool(dark) and int(blank) <= _MISSING_SECTORS)
