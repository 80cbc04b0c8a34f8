"""Parts that are made in no time: plain slabs with holes, and drawn parts squashed thin."""

import math
import random
from dataclasses import replace

import numpy as np

from gaussiancad_core.model.axes import Axis, Role
from learning.sheets.chains_of_points import Points, circle, inside
from learning.training_parts import Chain, Circle, DrawnPart, PartView

_SLABS, _SQUASHED = 0.14, 0.16
"""Shares of the sheets on which there is a slab, and a part squashed thin."""

_THINNEST, _THICKEST = 0.02, 0.6
"""Of squashed parts, in thicknesses before."""

_SMALLEST_MM, _LARGEST_MM = 6.0, 120.0
"""Extents of slabs."""

_CORNER_STEPS = 24
"""Places at which it is looked whether something stands before an edge."""


def varied(part: DrawnPart, chance: random.Random) -> DrawnPart:
    """The part, or now and then a slab instead, and either of them squashed at times."""
    if chance.random() < _SLABS:
        part = slab(chance)
    return squashed(part, chance) if chance.random() < _SQUASHED else part


def squashed(part: DrawnPart, chance: random.Random) -> DrawnPart:
    """The part made thin along one axis: some of its views are a few pixels high on a sheet."""
    axis = chance.choice(tuple(Axis))
    factor = math.exp(chance.uniform(math.log(_THINNEST), math.log(_THICKEST)))
    views = {}
    for role, view in part.views.items():
        frame = role.frame
        shares = [factor if pair[0] is axis else 1.0 for pair in (frame.right_axis, frame.up_axis)]
        if min(shares) < 1.0:
            # What was round is no longer.
            matrix = np.diag(shares).astype(np.float32)
            views[role] = replace(view, circles=()).moved(matrix, (0.0, 0.0))
        else:
            views[role] = view
    return DrawnPart(views)


def slab(chance: random.Random) -> DrawnPart:
    """An outline with round holes through it, in all views."""
    width, height, depth = (
        math.exp(chance.uniform(math.log(_SMALLEST_MM), math.log(_LARGEST_MM))) for _ in range(3)
    )
    if chance.random() < 0.5:
        depth = min(width, height) * chance.uniform(0.03, 0.3)
    if chance.random() < 0.1:
        height = width
        outline = circle((width / 2, width / 2), width / 2)
        rounds = [Circle((width / 2, width / 2), width / 2, 0.0, 2.0 * math.pi, hidden=False)]
        corners = np.array(
            [(0.0, width / 2), (width, width / 2), (width / 2, 0), (width / 2, width)]
        )
        lines = [outline]
    else:
        corners = _outline(chance) * (width, height)
        outline = np.concatenate([corners, corners[:1]])
        rounds = []
        lines = [outline[place : place + 2] for place in range(len(corners))]
    holes = _holes(chance, outline)
    lines += [circle(hole.centre, hole.radius) for hole in holes]
    front = PartView(tuple(line.astype(np.float32) for line in lines), (), (), (*rounds, *holes))
    solid = _Slab(outline, corners, tuple(holes), depth)
    mirror = np.diag([-1.0, 1.0]).astype(np.float32)
    swap = np.array([[0, 1], [1, 0]], np.float32)
    return DrawnPart(
        {
            Role.FRONT: front,
            Role.REAR: front.moved(mirror, (width, 0.0)),
            Role.TOP: solid.side(1, 1),
            Role.BOTTOM: solid.side(1, -1),
            Role.RIGHT: solid.side(0, 1).moved(swap, (0.0, 0.0)),
            Role.LEFT: solid.side(0, -1).moved(swap, (0.0, 0.0)),
        }
    )


class _Slab:
    """An outline (n, 2) with its corners and holes, pulled to a depth."""

    def __init__(
        self, outline: Points, corners: Points, holes: tuple[Circle, ...], depth: float
    ) -> None:
        self.outline, self.corners, self.holes, self.depth = outline, corners, holes, depth
        self._fine = 1e-3 * float(np.ptp(outline, axis=0).min())

    def side(self, axis: int, sign: int) -> PartView:
        """Its lines, seen along an axis of the outline from where a sign points."""
        other = self.outline[:, 1 - axis]
        first, last = float(other.min()), float(other.max())
        visible = {round(value / self._fine): value for value in (first, last)}
        hidden: dict[int, float] = {}
        for corner in self.corners:
            place = float(corner[1 - axis])
            shown = not self._behind(corner, axis, sign)
            if len(self.corners) < len(self.outline) - 1 and first < place < last:
                # A round outline has no edge there.
                continue
            (visible if shown else hidden)[round(place / self._fine)] = place
        for hole in self.holes:
            for radius in (-hole.radius, hole.radius):
                place = hole.centre[1 - axis] + radius
                hidden[round(place / self._fine)] = place
        across = [np.array([[first, at], [last, at]], np.float32) for at in (0.0, self.depth)]
        return PartView(
            (*across, *(self._edge(value) for value in visible.values())),
            tuple(self._edge(value) for key, value in hidden.items() if key not in visible),
        )

    def _edge(self, place: float) -> Chain:
        return np.array([[place, 0.0], [place, self.depth]], np.float32)

    def _behind(self, corner: Points, axis: int, sign: int) -> bool:
        """Whether the slab itself stands before an edge, on both sides of it."""
        along = self.outline[:, axis]
        end = along.max() if sign > 0 else along.min()
        steps = np.linspace(corner[axis], end, _CORNER_STEPS)[1:]

        def covered(place: float) -> bool:
            points = [(place, step) if axis else (step, place) for step in steps]
            return any(inside(self.outline, *point) for point in points)

        return all(covered(corner[1 - axis] + aside) for aside in (-self._fine, self._fine))


def _outline(chance: random.Random) -> Points:
    """(n, 2) corners of an outline that fills a square of side 1."""
    low, stem, high, edge = (chance.uniform(0.12, 0.45) for _ in range(4))
    box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    angle = [(0, 0), (1, 0), (1, low), (stem, low), (stem, 1), (0, 1)]
    channel = [
        (0, 0),
        (1, 0),
        (1, 1),
        (1 - low, 1),
        (1 - low, stem),
        (high, stem),
        (high, 1),
        (0, 1),
    ]
    tee = [
        (low, 0),
        (1 - stem, 0),
        (1 - stem, high),
        (1, high),
        (1, 1),
        (0, 1),
        (0, high),
        (low, high),
    ]
    clamp = [(0, 0), (1, 0), (1, low), (stem, low), (stem, 1 - high), (1, 1 - high), (1, 1), (0, 1)]
    nut = [(0.25, 0), (0.75, 0), (1, 0.5), (0.75, 1), (0.25, 1), (0, 0.5)]
    wedge = [(0, 0), (1, 0), (1, edge), (stem, 1), (0, 1)]
    forms = [box, box, angle, channel, tee, clamp, nut, wedge, _skyline(chance)]
    return np.array(chance.choice(forms), dtype=np.float64)


def _skyline(chance: random.Random) -> list[tuple[float, float]]:
    """Steps of chance heights, the highest one 1."""
    count = chance.randint(2, 5)
    ends = np.cumsum([chance.uniform(0.2, 1.0) for _ in range(count)])
    heights = np.array([chance.uniform(0.2, 1.0) for _ in range(count)])
    ends, heights = ends / ends[-1], heights / heights.max()
    corners = [(0.0, 0.0), (1.0, 0.0)]
    for place in reversed(range(count)):
        start = float(ends[place - 1]) if place else 0.0
        corners += [(float(ends[place]), float(heights[place])), (start, float(heights[place]))]
    return corners


def _holes(chance: random.Random, outline: Points) -> list[Circle]:
    """Holes within the outline, apart from each other."""
    width, height = outline.max(axis=0)
    holes: list[Circle] = []
    for _ in range(chance.choice([0, 0, 1, 1, 2, 4])):
        radius = min(width, height) * chance.uniform(0.02, 0.25)
        x, y = (chance.uniform(radius, item - radius) for item in (width, height))
        rim = circle((x, y), 1.2 * radius)[::4]
        apart = all(math.dist((x, y), hole.centre) > 1.2 * (radius + hole.radius) for hole in holes)
        if apart and all(inside(outline, *point) for point in rim):
            holes.append(Circle((x, y), radius, 0.0, 2.0 * math.pi, hidden=False))
    return holes
