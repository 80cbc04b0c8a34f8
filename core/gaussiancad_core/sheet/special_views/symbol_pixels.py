"""The projection symbol of a picture: lines and circles of pieces of ink as small as a symbol's."""

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.special_views.symbol_shape import (
    AXES,
    Ends,
    ProjectionSymbol,
    agreed,
    is_around,
    symbol_near_text,
)
from gaussiancad_core.sheet.tracing.grown_shapes import Grown
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.ridges import RidgePoints, ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_shapes
from gaussiancad_core.sheet.votes import LARGELY, MOST

Floats = npt.NDArray[np.float64]

_SMALLEST_PX = 8
"""Size of its pieces at least."""

_MOST_PIECES = 15_000
"""Of such a size on a sheet among which it is looked for: sheets of writing have some thousands."""


def pixel_symbol(sheet: CleanSheet, largest: float) -> ProjectionSymbol | None:
    """Find the projection symbol of a sheet; nothing where there is none, or several disagree.

    Args:
        sheet: upright, with frame and title block.
        largest: px that a symbol is long at most.
    """
    small = _small_pieces(sheet.ink, largest)
    if not small.any():
        return None
    weight = np.where(small, sheet.weight, 0.0).astype(np.float32)
    width = min(sheet.stroke_width, 2.0)
    ridges = ridge_points(weight, width)
    shapes = grow_shapes(ridges, GrowthRules(gap=6.0))
    sides = [_ends(shape, ridges) for shape in shapes if isinstance(shape.geometry, Line)]
    places = np.array(sides).reshape(-1, 2, 2)
    found = []
    for circle in _ringed(shapes, ridges):
        for axis in AXES:
            symbol = symbol_near_text(circle, axis, places, lambda ends: _is_closed(ends, weight))
            if symbol is not None:
                found.append(symbol)
    symbol = agreed(found)
    return None if symbol is None else replace(symbol, mark=_from_corners(symbol.mark))


def _from_corners(mark: Mark) -> Mark:
    """A mark in px whose centres lie at halves, of one in px whose centres are integers."""
    x0, y0, x1, y1 = mark.box
    return replace(mark, box=(x0 + 0.5, y0 + 0.5, x1 + 0.5, y1 + 0.5))


def _ends(shape: Grown, ridges: RidgePoints) -> Floats:
    """(2, 2) px, ends of a straight line, centres of pixels at integers."""
    line = shape.line
    along, _ = line.coordinates(ridges.points[shape.members])
    return np.array([line.at(float(along.min())), line.at(float(along.max()))])


def _small_pieces(ink: Mask, largest: float) -> Mask:
    """(h, w) bool, pieces of ink as small as a symbol's; none where there are too many of them."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    sides = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    chosen = (sides >= _SMALLEST_PX) & (sides <= largest)
    chosen[0] = False
    if np.count_nonzero(chosen) > _MOST_PIECES:
        chosen[:] = False
    return cv2.dilate(chosen[labels].astype(np.uint8), np.ones((3, 3), np.uint8)) > 0


def _ringed(shapes: Sequence[Grown], ridges: RidgePoints) -> list[Circle]:
    """Circles with another one around the same centre in them."""
    whole = [
        shape.geometry
        for shape in shapes
        if isinstance(shape.geometry, Circle)
        and _share_drawn(shape.geometry, ridges.points[shape.members]) > LARGELY
    ]
    return [outer for outer in whole if any(is_around(outer, inner) for inner in whole)]


def _share_drawn(circle: Circle, points: Floats) -> float:
    """Share of a circle's directions in which it has points."""
    offset = points - np.array(circle.centre)
    angles = np.arctan2(offset[:, 1], offset[:, 0])
    sectors = 24
    return len(np.unique(np.floor(angles * (sectors / (2.0 * np.pi))))) / sectors


def _is_closed(ends: Ends, weight: npt.NDArray[np.float32]) -> bool:
    """Whether both ends of a cone are inked."""
    centre = np.array(ends.circle.centre)
    for along, across in zip(ends.along, ends.across, strict=True):
        steps = np.linspace(across[0], across[1], 24)[2:-2, None] * ends.crosswise
        inked = 0.0
        # The bar may stand a little off the ends that were found of its sides.
        for shift in np.arange(-3.0, 3.5, 0.5):
            points = centre + (along + shift) * ends.axis + steps
            values = sample(weight, points[:, :1], points[:, 1:])[:, 0]
            inked = max(inked, float((values > 0.35).mean()))
        if inked < MOST:
            return False
    return True
