"""Whether two shapes of strokes are the same one: of one kind, close to each other, as long."""

from collections.abc import Iterable
from typing import Protocol

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.readings.reading_schema import (
    ArcShape,
    Box,
    EllipseShape,
    LineShape,
    StrokeEntry,
)

_NEAR_PX = 3.0
"""px within which points of one shape lie at the other."""

_SHARE = 0.6
"""Share of either that does so at least."""

_WHOLE = 0.999
"""Share from which on two shapes are one."""

_SAMPLES = 64

_SHARES = np.linspace(0.0, 1.0, _SAMPLES)
"""Where samples lie, as shares of a shape."""

_HALF_STEP = 0.5 / (_SAMPLES - 1)
"""Half of what lies between two samples, as a share of a line."""


class Shaped(Protocol):
    """What has one of three shapes, or none."""

    @property
    def line(self) -> LineShape | None:
        """Its ends."""

    @property
    def arc(self) -> ArcShape | None:
        """Of a circle."""

    @property
    def ellipse(self) -> EllipseShape | None:
        """Of an ellipse."""


def points_of(shaped: Shaped) -> npt.NDArray[np.float64]:
    """(n, 2) px along a shape, evenly; (0, 2) where there is none."""
    if shaped.line is not None:
        start, end = np.array(shaped.line)
        return start + _SHARES[:, None] * (end - start)
    if shaped.arc is not None:
        x, y, radius, first, sweep = shaped.arc
        angles = first + _SHARES * sweep
        return np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], 1)
    if shaped.ellipse is not None:
        x, y, major, minor, rotation, first, sweep = shaped.ellipse
        return WholeEllipse((x, y), major, minor, rotation).at(first + _SHARES * sweep)
    return np.empty((0, 2))


def box_of(shaped: Shaped) -> Box | None:
    """The box around a shape."""
    points = points_of(shaped)
    if not len(points):
        return None
    (x0, y0), (x1, y1) = points.min(0).tolist(), points.max(0).tolist()
    return x0, y0, x1, y1


def overlap(shaped: Shaped, other: Shaped) -> float:
    """Share of both shapes that lies at the other; 0 where they are of different kinds."""
    if (
        _kind(shaped) != _kind(other)
        or _kind(shaped) is None
        or _are_apart(shaped.line, other.line)
    ):
        return 0.0
    first, last = points_of(shaped), points_of(other)
    apart = np.hypot(*(first[:, None, :] - last[None, :, :]).transpose(2, 0, 1))
    # Samples are at most one step apart; what lies between two of them is near both.
    steps = [np.hypot(*np.diff(points, axis=0).T).max() / 2.0 for points in (first, last)]
    shares = [float((apart.min(axis) <= _NEAR_PX + steps[axis - 1]).mean()) for axis in (1, 0)]
    return min(shares)


def _are_apart(pair: LineShape | None, other: LineShape | None) -> bool:
    """Whether two lines have no place in common, nor one that is near: most have none, and telling
    so by their boxes is quick."""
    if pair is None or other is None:
        return False
    (x0, y0), (x1, y1) = pair
    (u0, v0), (u1, v1) = other
    reach = _NEAR_PX + _HALF_STEP * max(abs(x1 - x0) + abs(y1 - y0), abs(u1 - u0) + abs(v1 - v0))
    return (
        min(x0, x1) > max(u0, u1) + reach
        or min(u0, u1) > max(x0, x1) + reach
        or min(y0, y1) > max(v0, v1) + reach
        or min(v0, v1) > max(y0, y1) + reach
    )


def are_one(shaped: Shaped, other: Shaped) -> bool:
    """Whether two shapes lie at each other all along: lines whose boxes differ do not."""
    if shaped.line is not None and other.line is not None:
        (x0, y0), (x1, y1) = shaped.line
        (u0, v0), (u1, v1) = other.line
        reach = _NEAR_PX + _HALF_STEP * (abs(x1 - x0) + abs(y1 - y0) + abs(u1 - u0) + abs(v1 - v0))
        if (
            abs(min(x0, x1) - min(u0, u1)) > reach
            or abs(max(x0, x1) - max(u0, u1)) > reach
            or abs(min(y0, y1) - min(v0, v1)) > reach
            or abs(max(y0, y1) - max(v0, v1)) > reach
        ):
            return False
    return overlap(shaped, other) > _WHOLE


def matching(anchor: Shaped, candidates: Iterable[StrokeEntry]) -> StrokeEntry | None:
    """The shape that is the anchor's, if there is one."""
    best = max(
        ((overlap(anchor, candidate), candidate) for candidate in candidates),
        key=lambda found: found[0],
        default=(0.0, None),
    )
    return best[1] if best[0] >= _SHARE else None


def _kind(shaped: Shaped) -> str | None:
    return next(
        (name for name in ("line", "arc", "ellipse") if getattr(shaped, name) is not None), None
    )
