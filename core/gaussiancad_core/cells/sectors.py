"""Through which angles profiles turn about an axis.

A profile that turns around a rounded corner ends where the arc of its rim passes smoothly into
straight sides; where the rim just ends, something else has cut the body, and at a slant as a rule:
of a profile's two rims the one that is farther out is cut earlier.
"""

from collections.abc import Sequence
from math import pi

from gaussiancad_core.coordinates.drawn_intervals import Carrier
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.geometry.whole_curves import Circle

Sector = tuple[float, float]
"""(start, sweep) in radians of the axis' projection plane, sweep at most pi."""

_SMOOTH = 0.02
"""Sine of the angle within which a line or circle goes on from an arc's end."""


def sector_of(
    arc: Circle,
    stretch: tuple[float, float],
    carriers: Sequence[Carrier],
    near: float,
) -> Sector | None:
    """The angles through which the profile turns whose rim is an arc; None for a whole turn.

    Args:
        arc: the circle that it is a part of.
        stretch: (low, high) radians, high up to a turn more than 2 pi.
        carriers: of the plane of the axis.
        near: units within which a line ends at an arc's end.
    """
    low, high = stretch
    if high - low > pi + COMPUTED:
        # More than a half has no sides.
        return None
    begins, ends = (_goes_on(arc, angle, carriers, near) for angle in stretch)
    if begins and ends:
        return low, high - low
    if not begins and not ends:
        return None
    return (low if begins else high - pi, pi)


def _goes_on(arc: Circle, angle: float, carriers: Sequence[Carrier], near: float) -> bool:
    """Whether another line or circle touches an arc at an angle, and is drawn there."""
    end = arc.at(angle)
    a, b = arc.normal(angle)
    for carrier in carriers:
        curve = carrier.curve
        if curve == arc or curve.distance(end) > near:
            continue
        at = curve.parameter(end)
        x, y = curve.normal(at)
        if abs(a * y - b * x) <= _SMOOTH and _is_drawn(carrier, at, near):
            return True
    return False


def _is_drawn(carrier: Carrier, at: float, near: float) -> bool:
    slack = near / carrier.curve.speed
    turns = (0.0,) if not isinstance(carrier.curve, Circle) else (-FULL_TURN, 0.0, FULL_TURN)
    return any(
        low - slack <= at + turn <= high + slack for low, high in carrier.drawn() for turn in turns
    )
