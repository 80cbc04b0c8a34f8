"""The projection symbol of a sheet: a truncated cone and its end view (ISO 5456-2).

The end view shows both of the cone's circles, so it looks at the narrow end.  In third angle a view
stands on the side from which it looks, in first angle on the far side: where the circles stand
beside the narrow end it is third angle, beside the wide end first angle, whichever way the symbol
is turned.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Projection
from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.marks import Mark, Mask
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.growth import Grown, GrowthRules, grow_shapes
from gaussiancad_core.sheet.ridges import RidgePoints, ridge_points
from gaussiancad_core.sheet.shapes import sample

Floats = npt.NDArray[np.float64]

_LARGEST = 0.07
"""Size of a symbol's pieces at most, as a share of the sheet's longer side."""

_SMALLEST_PX = 8
"""Size of its pieces at least."""

_DRAWN = 0.75
"""Share of a circle that has ridge points at least."""

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

_BAR = 0.6
"""Share of the cone's ends that is inked at least."""


@dataclass(frozen=True)
class ProjectionSymbol:
    """A symbol and what it says.

    Attributes:
        projection: first or third angle.
        mark: around it.
    """

    projection: Projection
    mark: Mark


def find_symbol(sheet: CleanSheet) -> ProjectionSymbol | None:
    """Find the projection symbol of a sheet; nothing where there is none, or several disagree.

    Args:
        sheet: upright, with frame and title block.
    """
    small = _small_pieces(sheet.ink)
    if not small.any():
        return None
    weight = np.where(small, sheet.weight, 0.0).astype(np.float32)
    width = min(sheet.stroke_width, 2.0)
    ridges = ridge_points(weight, width)
    shapes = grow_shapes(ridges, GrowthRules(gap=6.0))
    lines = [_Side.of(shape, ridges) for shape in shapes if isinstance(shape.geometry, Line)]
    found = []
    for circle in _ringed(shapes, ridges):
        for axis in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
            symbol = _beside(circle, np.array(axis), lines, weight)
            if symbol is not None:
                found.append(symbol)
    if len({symbol.projection for symbol in found}) != 1:
        return None
    return found[0]


@dataclass(frozen=True)
class _Side:
    """A straight line with its ends: (2, 2) px, centres of pixels at integers."""

    ends: Floats

    @classmethod
    def of(cls, shape: Grown, ridges: RidgePoints) -> "_Side":
        along, _ = shape.geometry.coordinates(ridges.points[shape.members])
        line = shape.geometry
        return cls(np.array([line.at(float(along.min())), line.at(float(along.max()))]))


def _small_pieces(ink: Mask) -> Mask:
    """(h, w) bool, pieces of ink as small as a symbol's."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    sides = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    chosen = (sides >= _SMALLEST_PX) & (sides <= _LARGEST * max(ink.shape))
    chosen[0] = False
    return cv2.dilate(chosen[labels].astype(np.uint8), np.ones((3, 3), np.uint8)) > 0


def _ringed(shapes: Sequence[Grown], ridges: RidgePoints) -> list[Circle]:
    """Circles with another one around the same centre in them."""
    whole = [
        shape.geometry
        for shape in shapes
        if isinstance(shape.geometry, Circle)
        and _share_drawn(shape.geometry, ridges.points[shape.members]) > _DRAWN
    ]
    found = []
    for outer in whole:
        for inner in whole:
            apart = np.hypot(*np.subtract(outer.centre, inner.centre))
            share = inner.radius / outer.radius
            if _INNER[0] < share < _INNER[1] and apart < _CONCENTRIC * outer.radius:
                found.append(outer)
                break
    return found


def _share_drawn(circle: Circle, points: Floats) -> float:
    """Share of a circle's directions in which it has points."""
    offset = points - np.array(circle.centre)
    angles = np.arctan2(offset[:, 1], offset[:, 0])
    sectors = 24
    return len(np.unique(np.floor(angles * (sectors / (2.0 * np.pi))))) / sectors


def _beside(
    circle: Circle, axis: Floats, lines: Sequence[_Side], weight: npt.NDArray[np.float32]
) -> ProjectionSymbol | None:
    """The cone beside two circles in a direction, and what it says."""
    across = np.array([-axis[1], axis[0]])
    sides = []
    for line in lines:
        place = (line.ends - np.array(circle.centre)) @ np.stack([axis, across], axis=1)
        place = place[np.argsort(place[:, 0])] / circle.radius
        middle = place.mean(axis=0)
        run = place[1] - place[0]
        near = _ALONG[0] < middle[0] < _ALONG[1] and _ACROSS[0] < abs(middle[1]) < _ACROSS[1]
        if near and run[0] > 0.6 and _SLOPES[0] < abs(run[1]) / run[0] < _SLOPES[1]:
            sides.append(place)
    for one, other in combinations(sides, 2):
        if _mirrored(one, other) and _closed(one, other, (circle, axis, across), weight):
            opens = abs(one[1, 1]) > abs(one[0, 1])
            projection = Projection.THIRD if opens else Projection.FIRST
            return ProjectionSymbol(projection, _mark(circle, axis, max(one[1, 0], other[1, 0])))
    return None


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


def _closed(
    one: Floats,
    other: Floats,
    place: tuple[Circle, Floats, Floats],
    weight: npt.NDArray[np.float32],
) -> bool:
    """Whether both ends of the cone are drawn."""
    circle, axis, across = place
    for end in (0, 1):
        inked = 0.0
        # The bar may stand a little off the ends that were found of its sides.
        for shift in np.arange(-3.0, 3.5, 0.5):
            along = 0.5 * (one[end, 0] + other[end, 0]) * circle.radius + shift
            steps = np.linspace(one[end, 1], other[end, 1], 24)[2:-2] * circle.radius
            points = np.array(circle.centre) + along * axis + steps[:, None] * across
            values = sample(weight, points[:, :1], points[:, 1:])[:, 0]
            inked = max(inked, float((values > 0.35).mean()))
        if inked < _BAR:
            return False
    return True


def _mark(circle: Circle, axis: Floats, reach: float) -> Mark:
    """Around the circles and the cone."""
    centre = np.array(circle.centre) + 0.5
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
