"""Level and upright lines of a sheet."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

_SLANT = 0.01
"""Sine of the angle within which a line is level or upright."""


@dataclass(frozen=True)
class Rule:
    """A level or upright line in px of the upright sheet.

    Attributes:
        level: whether it runs along x.
        at: its coordinate across.
        low, high: its ends' coordinates along.
    """

    level: bool
    at: float
    low: float
    high: float


def rule_of(start: Sequence[float], end: Sequence[float]) -> Rule | None:
    """The rule between two points; nothing if it is slanted."""
    (x0, y0), (x1, y1) = start, end
    dx, dy = abs(x1 - x0), abs(y1 - y0)
    length = hypot(dx, dy)
    if length == 0.0 or min(dx, dy) > max(_SLANT * length, 0.5):
        return None
    if dx > dy:
        return Rule(True, 0.5 * (y0 + y1), min(x0, x1), max(x0, x1))
    return Rule(False, 0.5 * (x0 + x1), min(y0, y1), max(y0, y1))
