"""What a projection symbol looks like: a truncated cone and its end view (ISO 5456-2).

The end view shows both of the cone's circles, so it looks at the narrow end.  In third angle a view
stands on the side from which it looks, in first angle on the far side: where the circles stand
beside the narrow end it is third angle, beside the wide end first angle, whichever way the symbol
is turned.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_core.sheet.annotations.annotation_marks import Mark

Floats = npt.NDArray[np.float64]

AXES = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))
"""Ways from the circles to the cone."""

LARGEST_MM, LARGEST_SHARE = 32.0, 0.11
"""Length of a symbol at most, with an axis that is drawn through it: on paper, and as a share of
the sheet's longer side where the paper is not known."""

_INNER = (0.3, 0.8)
"""Diameter of the inner circle as a share of the outer one's; the standard has a half."""

_CONCENTRIC = 0.15
"""Distance of the circles' centres at most, in radii of the outer one."""

_SLOPES = np.tan(np.radians([5.0, 28.0]))
"""Least and largest slope of the cone's sides against its axis."""

_UNLIKE = 0.07
"""Largest difference of the slopes of both sides."""

_ALONG = (1.0, 6.0)
"""Where the cone's middle lies along its axis from the circles' centre, in their radius."""

_ACROSS = (0.3, 1.3)
"""How far its sides lie from the axis in their middle, in the same."""

_SHORTEST = 0.6
"""Length of its sides along the axis at least, in the same."""


@dataclass(frozen=True)
class ProjectionSymbol:
    """A symbol and what it says.

    Attributes:
        projection: first or third angle.
        mark: around it, px of the upright sheet.
    """

    projection: Projection
    mark: Mark


@dataclass(frozen=True, eq=False)
class Ends:
    """The ends of a cone beside two circles.

    Attributes:
        circle: the outer one.
        axis: (2,) from the circles to the cone.
        along: places of both ends along the axis from the circles' centre, px, the near one first.
        across: (2, 2) places of both sides there, px: near and far end, one side and the other.
    """

    circle: Circle
    axis: Floats
    along: tuple[float, float]
    across: Floats

    @property
    def crosswise(self) -> Floats:
        """(2,) square to the axis."""
        return np.array([-self.axis[1], self.axis[0]])


def largest_symbol(size: tuple[int, int], pixels_per_inch: float | None) -> float:
    """px that a symbol is long at most.

    Args:
        size: height and width of the sheet in px.
        pixels_per_inch: of its paper; None where that is not known.
    """
    if pixels_per_inch is None:
        return LARGEST_SHARE * max(size)
    return LARGEST_MM / MM_PER_INCH * pixels_per_inch


def is_around(outer: Circle, inner: Circle) -> bool:
    """Whether two circles are those of a symbol's end view."""
    apart = np.hypot(*np.subtract(outer.centre, inner.centre))
    share = inner.radius / outer.radius
    return bool(_INNER[0] < share < _INNER[1] and apart < _CONCENTRIC * outer.radius)


def symbol_near_text(
    circle: Circle, axis: tuple[float, float], sides: Floats, is_closed: Callable[[Ends], bool]
) -> ProjectionSymbol | None:
    """The symbol of two circles and the cone beside them in a direction.

    Args:
        circle: the outer one, px.
        axis: from it to the cone.
        sides: (n, 2, 2) ends of straight lines, px.
        is_closed: whether both ends of a cone are drawn.
    """
    way = np.array(axis)
    across = np.array([-way[1], way[0]])
    places = (sides - np.array(circle.centre)) @ np.stack([way, across], axis=1) / circle.radius
    middle = places.mean(axis=1)
    low, high = _ALONG[0] < middle[:, 0], middle[:, 0] < _ALONG[1]
    neighbour = (_ACROSS[0] < np.abs(middle[:, 1])) & (np.abs(middle[:, 1]) < _ACROSS[1])
    places = places[low & high & neighbour]
    turned = places[:, 0, 0] > places[:, 1, 0]
    places[turned] = places[turned, ::-1]
    run = places[:, 1] - places[:, 0]
    slopes = np.abs(run[:, 1]) / np.maximum(run[:, 0], 1e-9)
    slanted = (run[:, 0] > _SHORTEST) & (_SLOPES[0] < slopes) & (slopes < _SLOPES[1])
    for one, other in combinations(places[slanted], 2):
        along = 0.5 * (one[:, 0] + other[:, 0]) * circle.radius
        widths = np.stack([one[:, 1], other[:, 1]], axis=1) * circle.radius
        ends = Ends(circle, way, (float(along[0]), float(along[1])), widths)
        if _mirrored(one, other) and is_closed(ends):
            opens = abs(one[1, 1]) > abs(one[0, 1])
            projection = Projection.THIRD if opens else Projection.FIRST
            return ProjectionSymbol(projection, _mark(circle, way, max(one[1, 0], other[1, 0])))
    return None


def agreed(found: list[ProjectionSymbol]) -> ProjectionSymbol | None:
    """The symbol of a sheet; nothing where there is none, or several disagree."""
    return found[0] if len({symbol.projection for symbol in found}) == 1 else None


def _mirrored(one: Floats, other: Floats) -> bool:
    """Whether two lines are each other's picture across the axis; in radii along and across."""
    slopes = [(side[1, 1] - side[0, 1]) / (side[1, 0] - side[0, 0]) for side in (one, other)]
    opposite = one.mean(axis=0)[1] * other.mean(axis=0)[1] < 0.0
    return (
        opposite
        and abs(slopes[0] + slopes[1]) < _UNLIKE
        and bool(np.abs(one[:, 0] - other[:, 0]).max() < 0.4)
        and bool(np.abs(one[:, 1] + other[:, 1]).max() < 0.3)
    )


def _mark(circle: Circle, axis: Floats, reach: float) -> Mark:
    """Around the circles and the cone."""
    centre = np.array(circle.centre)
    far = centre + reach * circle.radius * axis
    corners = np.array([centre, far])
    x0, y0 = corners.min(axis=0) - circle.radius * np.array([1.0, 1.0])
    x1, y1 = corners.max(axis=0) + circle.radius * np.array([1.0, 1.0])
    # Beyond the cone's far end there is nothing of it.
    if abs(axis[0]) > 0.5:
        x0, x1 = (x0, far[0]) if axis[0] > 0 else (far[0], x1)
    else:
        y0, y1 = (y0, far[1]) if axis[1] > 0 else (far[1], y1)
    return Mark(AnnotationKind.SYMBOL, (float(x0), float(y0), float(x1), float(y1)))
