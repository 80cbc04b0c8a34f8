"""How an outline rises from its line to a corner: followed through the ink, told by a parabola."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample

Floats = npt.NDArray[np.float64]

BEFORE, _BEYOND = 25.0, 45.0
"""px before and beyond a line's end in which the rise is looked for."""

LEAST, MOST = 1.0, 12.0
"""px by which it rises; more is an arc that is grown."""

_SHORTEST, _STEEPEST = 6.0, 1.0
"""px of the rise along the line at least; its slope at the corner at most."""

ROOM = 1.5
"""px beside the ink's edges that are blank where it is one stroke's."""

_WHITE, _WIDER = 0.15, 1.5
"""Ink up to which a place is blank; stroke widths of ink across one stroke at most."""

STEP = 0.25
"""px between places across a line."""

_FEWEST, _EVEN = 6, 0.2
"""Places of the rise that tell its course at least; root mean square of px off it at most."""

_SEEN = 0.8
"""Share of the rise, but for what the stroke at the corner hides, in which its ink is alone."""

_ROUNDER = 0.7
"""Share of a straight rise's residual that is left of an arc's, at most."""

_CROSSING = 0.5
"""Sine of the angle at which a stroke crosses at least."""


@dataclass(frozen=True)
class End:
    """An end of a visible line, from which positions count outwards.

    Attributes:
        line, piece: what ends.
        at: px along the line.
        way: 1.0 where positions grow outwards, else -1.0.
    """

    line: Line
    piece: Piece
    at: float
    way: float

    def points(self, beyond: Floats, adjacent: Floats) -> Floats:
        """(..., 2) px of places beyond the end and to the left of the line."""
        direction = np.array(self.line.direction)
        normal = np.array([-direction[1], direction[0]])
        origin = np.array(self.line.at(self.at))
        along = self.way * np.asarray(beyond)[..., None] * direction
        return origin + along + np.asarray(adjacent)[..., None] * normal


@dataclass(frozen=True)
class RunOut:
    """The rise at an end.

    Attributes:
        foot, corner: px beyond the end where it begins, and where it ends at another stroke.
        height: px to the left of the line at the corner.
    """

    foot: float
    corner: float
    height: float


def find_run_out(end: End, sheet: CleanSheet, pieces: Sequence[Placed]) -> RunOut | None:
    """The rise at an end of a line to a corner at one of the pieces; None where there is none."""
    at, off = _followed(end, sheet)
    if not len(at) or np.abs(off).max() < 0.5 * LEAST:
        return None
    # Beside the stroke at the corner no ink is one stroke's alone.
    hidden = sheet.stroke_width + ROOM + 1.0
    for corner in crossings(end, pieces, 0.0, MOST):
        before = at < corner
        if not before.any() or corner - at[before].max() > hidden:
            continue
        rise = _rise(at[before], off[before], corner)
        if rise is not None and _is_seen(at, rise, hidden):
            return rise
    return None


def _followed(end: End, sheet: CleanSheet) -> tuple[Floats, Floats]:
    """(n,) px beyond an end and to the left of the line, of the centre of the ink that goes on
    there, where that is one stroke alone."""
    half = 0.5 * sheet.stroke_width + ROOM
    places = np.arange(-min(BEFORE, end.piece.end - end.piece.start), _BEYOND)
    reach = MOST + half
    offsets = np.arange(-reach, reach + STEP, STEP)
    points = end.points(places[:, None], offsets)
    strip = sample(sheet.weight, points[..., 0], points[..., 1])
    span = round(half / STEP)
    offset, slope, alone = 0.0, 0.0, float(places[0])
    found: list[tuple[float, float]] = []
    for beyond, across in zip(places.tolist(), strip, strict=True):
        offset += slope
        middle = round((offset + reach) / STEP)
        if not span <= middle < len(offsets) - span:
            break
        ink = across[middle - span : middle + span + 1]
        total = float(ink.sum()) * STEP
        single = max(ink[0], ink[-1]) < _WHITE and total < _WIDER * sheet.stroke_width
        if single and total > 0.5 * sheet.stroke_width:
            values = offsets[middle - span : middle + span + 1]
            offset = float((ink * values).sum()) * STEP / total
            found.append((beyond, offset))
            near = [other for other in found[-5:] if other[0] >= beyond - 4.0]
            if len(near) > 2:
                slope = (near[-1][1] - near[0][1]) / (near[-1][0] - near[0][0])
            alone = beyond
        elif beyond - alone > 2.0 * half:
            break
    table = np.array(found).reshape(-1, 2)
    return table[:, 0], table[:, 1]


def crossings(
    end: End,
    pieces: Sequence[Placed],
    height: float,
    reach: float,
    farthest: float = _BEYOND,
) -> Iterator[float]:
    """Px beyond an end at which other strokes cross its line's course at a height, or would if they
    were longer by some px; nearest first."""
    found = set()
    course = end.points(np.array([0.0, 1.0]), np.full(2, height))
    direction = course[1] - course[0]
    for geometry, piece in pieces:
        if not isinstance(geometry, Line):
            continue
        dx, dy = geometry.direction
        sine = float(direction[0] * dy - direction[1] * dx)
        if abs(sine) < _CROSSING:
            continue
        x, y = np.subtract(geometry.point, course[0])
        beyond = float(x * dy - y * dx) / sine
        at = float(geometry.positions((course[0] + beyond * direction)[None])[0])
        if piece.start - reach <= at <= piece.end + reach and abs(beyond) <= farthest:
            found.add(beyond)
    yield from sorted(found)


def _rise(at: Floats, off: Floats, corner: float) -> RunOut | None:
    """The parabola that leaves the line and ends at a corner."""
    arc = min(_courses(at, off, corner, 2), default=None)
    straight = min(_courses(at, off, corner, 1), default=None)
    if arc is None or arc[0] > _EVEN or (straight and arc[0] > _ROUNDER * straight[0]):
        return None
    _, foot, height = arc
    long = corner - foot
    if not LEAST <= abs(height) <= MOST or 2.0 * abs(height) > _STEEPEST * long:
        return None
    return RunOut(foot, corner, height)


def _is_seen(at: Floats, rise: RunOut, hidden: float) -> bool:
    """Whether the ink of a rise was followed nearly all along it."""
    seen = ((at > rise.foot) & (at < rise.corner)).sum()
    return bool(seen > _SEEN * (rise.corner - rise.foot - hidden))


def _courses(
    at: Floats, off: Floats, corner: float, power: int
) -> Iterator[tuple[float, float, float]]:
    """For each foot: root mean square of px off the course that leaves the line there, the foot,
    and the height of the corner."""
    for foot in np.arange(-BEFORE, corner - _SHORTEST, 0.5):
        rising = np.clip(at - foot, 0.0, None) ** power
        if (rising > 0.0).sum() < _FEWEST or (at <= foot).sum() < 2:
            continue
        basis = np.stack([np.ones(len(at)), rising], axis=1)
        values = np.linalg.lstsq(basis, off, rcond=None)[0]
        left = float(np.sqrt(np.square(basis @ values - off).mean()))
        yield left, float(foot), float(values[1]) * (corner - float(foot)) ** power
