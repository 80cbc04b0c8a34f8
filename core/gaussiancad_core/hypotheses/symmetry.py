"""Whether what is drawn is alike on both sides of a middle, and which cells are mirror images."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.cells.cell_complex import Cell, Crossing
from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import MEETING, SAME_PLACE
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE


def is_symmetric(carriers: PartCarriers, axis: Axis) -> bool:
    """Whether all lines of the views that show an axis are alike on both sides of its middle."""
    middle = carriers.size[axis.value] / 2.0
    reach = max(SAME_PLACE, MEETING * carriers.tolerance)
    shown = False
    for normal, plane in carriers.planes.items():
        if normal is axis:
            continue
        shown = True
        place = IN_PLANE[normal].index(axis.value)
        stretches = np.array([_key(stretch) for stretch in _stretches(plane)])
        if not len(stretches):
            continue
        mirrored = stretches.copy().reshape(-1, 3, 2)
        mirrored[:, :, place] = 2.0 * middle - mirrored[:, :, place]
        images = np.array([_key(tuple(map(tuple, items))) for items in mirrored.tolist()])
        away, _ = cKDTree(stretches).query(images)
        if away.max() > reach:
            return False
    return shown


def _stretches(plane: PlaneCarriers) -> Iterator[tuple[Point, Point, Point]]:
    """Middle and both ends of what is drawn; of whole circles two ends of a diameter."""
    for carrier in plane.carriers:
        curve = carrier.curve
        for low, high in carrier.drawn():
            if isinstance(curve, Circle) and high - low > FULL_TURN - 1e-3:
                x, y = curve.centre
                yield curve.centre, (x - curve.radius, y), (x + curve.radius, y)
                continue
            yield curve.at((low + high) / 2.0), curve.at(low), curve.at(high)


def _key(places: tuple[Point, ...]) -> tuple[float, ...]:
    """The middle, and the ends in an order that does not depend on the direction."""
    middle, *ends = places
    return (*middle, *(value for end in sorted(ends) for value in end))


def mirror_images(column: Sequence[Crossing], at: float) -> Iterator[tuple[Cell, Cell]]:
    """Different cells of a column that are as far before a plane as behind it."""
    intervals = [(c.depth, d.depth, c.after) for c, d in pairwise(column) if c.after is not None]
    for low, high, cell in intervals:
        image = 2.0 * at - 0.5 * (low + high)
        for start, end, other in intervals:
            if start < image < end and cell < other:
                yield cell, other
