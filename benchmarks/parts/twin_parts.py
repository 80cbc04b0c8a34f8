"""Small parts that hardly differ in what is seen of them: blind or through, boss or pocket.

A family makes a few variants of a block, which may or may not have the same lines under some
policy; who draws them finds out.  Measures are whole millimetres by lot, or hundredths of them, and
the block is turned to any of its 24 positions.
"""

from collections.abc import Callable

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_measures import placed, rotations
from gaussiancad_core.kernel.brep import bounding_box, soundness
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import (
    box,
    cone,
    cut,
    cylinder,
    edges_along,
    filleted,
    fuse,
    prism,
    sphere,
)

_BEYOND = 1.0
"""mm by which tools reach out of the part that they cut."""

_ODD = 0.01
"""mm of the step of odd measures."""

Random = np.random.Generator
Variants = list[TopoDS_Shape]
Family = Callable[["_Block"], Variants]


def twins(family: str, seed: int, *, odd: bool = False) -> Variants:
    """The variants of a family, valid closed solids whose bounding boxes are the same.

    Args:
        family: name of one of :data:`FAMILIES`.
        seed: of measures and of how the parts are turned.
        odd: whether measures are hundredths of millimetres.
    """
    random = np.random.default_rng([seed, odd, *family.encode()])
    turn = rotations()[int(random.integers(24))]
    found: Variants = []
    for shape in FAMILIES[family](_Block(random, odd)):
        try:
            turned = placed(shape, turn)
            facts = soundness(turned)
        except KERNEL_FAILURES:
            continue
        if facts.valid and facts.closed and facts.solids == 1:
            found.append(turned)
    extents = [np.ptp(bounding_box(shape), axis=0) for shape in found]
    # Bosses make a part higher: those stand for themselves.
    return [
        shape
        for shape, extent in zip(found, extents, strict=True)
        if np.allclose(extent, extents[0])
    ]


class _Block:
    """A block by lot, and places on it.

    Attributes:
        random: the lot.
        size: (3,) mm.
        shape: the block.
    """

    def __init__(self, random: Random, odd: bool) -> None:
        self.random = random
        self._step = _ODD if odd else 1.0
        self.size = [self.whole(24.0, 60.0) for _ in range(3)]
        self.shape = box((0.0, 0.0, 0.0), (self.size[0], self.size[1], self.size[2]))

    def whole(self, low: float, high: float) -> float:
        """A whole number of steps, in mm."""
        first, last = round(low / self._step), round(high / self._step)
        return self._step * int(self.random.integers(first, max(first, last) + 1))

    def two(self, low: float, high: float) -> tuple[float, float]:
        """Two of them that are a millimetre apart at least, the smaller one first."""
        first = self.whole(low, high - 1.0)
        return first, self.whole(first + 1.0, max(high, first + 1.0))

    def side(self, axis: int) -> tuple[float, float]:
        """An interval along an axis that keeps away from both ends."""
        extent = self.size[axis]
        low = self.whole(4.0, 0.4 * extent)
        return low, self.whole(low + 5.0, extent - 4.0)

    def place(self, radius: float) -> tuple[float, float]:
        """The centre of a bore from above."""
        x, y = (self.whole(radius + 3.0, self.size[k] - radius - 3.0) for k in (0, 1))
        return x, y


def _pockets(block: _Block) -> Variants:
    """A rectangular pocket of two depths, through, from below, with an island."""
    (x0, x1), (y0, y1), top = block.side(0), block.side(1), block.size[2]
    shallow, deep = block.two(3.0, top - 4.0)
    found = [
        cut(block.shape, box((x0, y0, low), (x1, y1, high)))
        for low, high in (
            (top - shallow, top + _BEYOND),
            (top - deep, top + _BEYOND),
            (-_BEYOND, top + _BEYOND),
            (-_BEYOND, deep),
        )
    ]
    if x1 - x0 >= 8.0 and y1 - y0 >= 8.0:
        island = box((x0 + 2.0, y0 + 2.0, 0.0), (x1 - 2.0, y1 - 2.0, top - shallow))
        found.append(fuse(found[1], island))
        found.append(cut(found[0], box((x0 + 2, y0 + 2, top - deep), (x1 - 2, y1 - 2, top))))
    return found


def _bores(block: _Block) -> Variants:
    """A bore of two depths, through, from below, with a ball's end, with a tip."""
    top, radius = block.size[2], block.whole(3.0, 7.0)
    at = block.place(radius)
    shallow, deep = block.two(radius + 2.0, top - radius - 2.0)
    ends = ((top - shallow, top + 1), (top - deep, top + 1), (-1.0, top + 1), (-1.0, deep))
    found = [cut(block.shape, cylinder(Axis.Z, at, radius, *end)) for end in ends]
    found.append(cut(found[0], sphere((*at, top - shallow), radius)))
    tip = cone(Axis.Z, at, (0.0, radius), top - shallow - radius, top - shallow)
    found.append(cut(found[0], tip))
    return found


def _crossed(block: _Block) -> Variants:
    """Bores along two axes, each blind or through, meeting or not."""
    radius, other = block.whole(3.0, 5.0), block.whole(3.0, 5.0)
    x, y = block.place(radius)
    z = block.whole(other + 3.0, block.size[2] - other - 3.0)
    top, long = block.size[2], block.size[0]
    blind, short = block.whole(4.0, top - 4.0), block.whole(4.0, long - 4.0)
    neighbour = block.whole(other + 3.0, block.size[1] - other - 3.0)
    aside = y if block.random.random() < 0.5 else neighbour
    return [
        cut(
            block.shape,
            cylinder(Axis.Z, (x, y), radius, low, top + _BEYOND),
            cylinder(Axis.X, (aside, z), other, -_BEYOND, high),
        )
        for low in (-_BEYOND, top - blind)
        for high in (long + _BEYOND, short)
    ]


def _counterbores(block: _Block) -> Variants:
    """A bore that is wider at its mouth: two depths, a cone, or wider at the other end."""
    top, radius = block.size[2], block.whole(2.0, 4.0)
    wide = radius + block.whole(2.0, 4.0)
    at = block.place(wide)
    bored = cut(block.shape, cylinder(Axis.Z, at, radius, -_BEYOND, top + _BEYOND))
    shallow, deep = block.two(2.0, top - 4.0)
    return [
        *(cut(bored, cylinder(Axis.Z, at, wide, top - d, top + _BEYOND)) for d in (shallow, deep)),
        cut(bored, cone(Axis.Z, at, (radius, wide), top - shallow, top)),
        cut(bored, cone(Axis.Z, at, (radius, wide), top - deep, top)),
        cut(bored, cylinder(Axis.Z, at, wide, -_BEYOND, shallow)),
    ]


def _cavities(block: _Block) -> Variants:
    """A block, and hollow ones: cavities that nothing leads into."""
    (x0, x1), (y0, y1), (z0, z1) = (block.side(k) for k in range(3))
    radius = 0.5 * min(x1 - x0, y1 - y0)
    middle = (0.5 * (x0 + x1), 0.5 * (y0 + y1))
    height = 0.5 * block.size[2]
    least = min(radius, height - 3.0)
    return [
        block.shape,
        cut(block.shape, box((x0, y0, z0), (x1, y1, z1))),
        cut(block.shape, box((x0, y0, z0), (x1, y1, z0 + 0.5 * (z1 - z0)))),
        cut(block.shape, cylinder(Axis.Z, middle, radius, z0, z1)),
        cut(block.shape, sphere((*middle, height), least)),
    ]


def _steps(block: _Block) -> Variants:
    """A step at either end, at both sides, of two heights."""
    x, y, z = block.size
    wide = block.whole(5.0, 0.45 * x)
    low, high = block.two(4.0, z - 4.0)
    left = box((-1, -1, low), (wide, y + 1, z + 1))
    right = box((x - wide, -1, low), (x + 1, y + 1, z + 1))
    back = box((-1, 0.5 * y, low), (wide, y + 1, z + 1))
    higher = box((-1, -1, high), (wide, y + 1, z + 1))
    return [cut(block.shape, tool) for tool in (left, right, back, higher)]


def _behind(block: _Block) -> Variants:
    """A notch in the rear and below, of two depths: only hidden lines tell of it."""
    _, y, z = block.size
    (x0, x1), (shallow, deep) = block.side(0), block.two(3.0, 0.6 * y)
    z0 = block.whole(4.0, 0.5 * z)
    return [
        block.shape,
        *(cut(block.shape, box((x0, y - d, -1.0), (x1, y + 1.0, z0))) for d in (shallow, deep)),
        cut(block.shape, box((x0, y - deep, z0), (x1, y + 1.0, z + 1.0))),
        cut(
            block.shape,
            box((x0, y - deep, -1.0), (x1, y + 1.0, z0)),
            box((x0, y - shallow, z0 - 1.0), (x1, y + 1.0, min(z - 3.0, z0 + 6.0))),
        ),
    ]


def _corners(block: _Block) -> Variants:
    """A corner cut out of the bottom, the rear and the side, where no view sees it."""
    x, y, z = block.size
    (a, b), (c, d), (e, f) = block.two(4, x - 5), block.two(4, y - 5), block.two(4, z - 5)
    boxes = ((a, c, e), (b, c, e), (a, d, e), (a, c, f), (b, d, f))
    found = [cut(block.shape, box((-1.0, y - dy, -1.0), (dx, y + 1.0, dz))) for dx, dy, dz in boxes]
    return [block.shape, *found]


def _covered(block: _Block) -> Variants:
    """A pocket whose floor lies at the height of a step beside it, so that one line covers another.

    The step runs in front of the pocket; the pocket's floor is at its height, or is not.
    """
    x, y, z = block.size
    deep = block.whole(6.0, 0.4 * y)
    low, high = block.two(5.0, z - 5.0)
    stepped = cut(block.shape, box((-1, -1, high), (x + 1, deep, z + 1)))
    (x0, x1), back = block.side(0), y - block.whole(3.0, 6.0)
    front = deep + block.whole(3.0, 6.0)
    if back - front < 3.0:
        return [stepped]
    pockets = [box((x0, front, floor), (x1, back, z + 1.0)) for floor in (high, low)]
    through = box((x0, front, -1.0), (x1, back, z + 1.0))
    below = box((x0, front, -1.0), (x1, back, high))
    return [stepped, *(cut(stepped, tool) for tool in (*pockets, through, below))]


def _profiles(block: _Block) -> Variants:
    """One edge cut off by a slant, a step, a hollow or a round: one view tells them apart."""
    x, y, z = block.size
    leg = block.whole(5.0, 0.6 * min(y, z))
    slant = prism(Axis.X, [(0.0, z), (leg, z), (0.0, z - leg)], -1.0, x + 1.0)
    step = box((-1.0, -1.0, z - leg), (x + 1.0, leg, z + 1.0))
    hollow = cylinder(Axis.X, (0.0, z), leg, -1.0, x + 1.0)
    inner = cylinder(Axis.X, (leg, z - leg), leg, -1.0, x + 1.0)
    rounded = cut(step, inner)
    return [cut(block.shape, tool) for tool in (slant, step, hollow, rounded)]


def _grooves(block: _Block) -> Variants:
    """A groove along the bottom: of two depths, with an undercut, a dovetail, closed inside."""
    x, y, z = block.size
    (y0, y1), (shallow, deep) = block.side(1), block.two(3.0, 0.5 * z)
    ends = (-1.0, x + 1.0), (-1.0, 0.6 * x)
    found = [
        cut(block.shape, box((low, y0, -1.0), (high, y1, depth)))
        for low, high in ends
        for depth in (shallow, deep)
    ]
    if y0 >= 6.0 and y1 <= y - 6.0:
        wide = box((-1.0, y0 - 2.0, shallow), (x + 1.0, y1 + 2.0, deep))
        found.append(cut(found[1], wide))
        dovetail = [(y0, 0.0), (y1, 0.0), (y1 + 2.0, deep), (y0 - 2.0, deep)]
        found.append(cut(block.shape, prism(Axis.X, dovetail, -1.0, x + 1.0)))
    return found


def _bosses(block: _Block) -> Variants:
    """A plate with bosses on both sides, of two heights each: those behind hide."""
    x, y, z = block.size
    low, high = 0.35 * z, 0.65 * z
    plate = box((0.0, 0.0, round(low)), (x, y, round(high)))
    radius = block.whole(3.0, 6.0)
    at = block.place(radius)
    above = cylinder(Axis.Z, at, radius, round(low), z)
    below = [cylinder(Axis.Z, at, r, 0.0, round(high)) for r in (radius, radius - 1.0)]
    square = box((at[0] - 2, at[1] - 2, 0.0), (at[0] + 2, at[1] + 2, round(high)))
    return [fuse(plate, above, other) for other in (*below, square)]


def _rounds(block: _Block) -> Variants:
    """Edges rounded: smooth edges tell how far, where they are drawn."""
    x, y, z = block.size
    small, large = block.two(2.0, 0.4 * min(x, y))
    corners = [(0.0, 0.0), (x, y)]
    found = [
        filleted(block.shape, edges_along(block.shape, Axis.Z, corners), r) for r in (small, large)
    ]
    top = block.whole(3.0, z - 4.0)
    (x0, x1), (y0, y1) = block.side(0), block.side(1)
    radius = 0.5 * min(x1 - x0, y1 - y0)
    for r in (1.0, 2.0):
        if r < radius:
            tool = box((x0, y0, top), (x1, y1, z + 1.0))
            inside = edges_along(tool, Axis.Z, [(x0, y0), (x1, y0), (x0, y1), (x1, y1)])
            found.append(cut(block.shape, filleted(tool, inside, r)))
    return found


def _ribs(block: _Block) -> Variants:
    """An angle with a rib between its legs: in two places, of two widths, or as a full wall."""
    x, y, z = block.size
    base, wall = block.whole(4.0, 0.3 * z), block.whole(4.0, 0.3 * y)
    angle = cut(block.shape, box((-1.0, -1.0, base), (x + 1.0, y - wall, z + 1.0)))
    inside = [(0.0, base), (y - wall, base), (y - wall, z)]
    first, second = block.two(3.0, x - 8.0)
    thick = block.whole(3.0, 5.0)
    places = ((first, thick), (second, thick), (first, thick + 2.0))
    ribs = [prism(Axis.X, inside, at, at + wide) for at, wide in places]
    full = box((first, 0.0, base - 1.0), (first + thick, y - 1.0, z))
    return [fuse(angle, rib) for rib in (*ribs, full)]


FAMILIES: dict[str, Family] = {
    "pockets": _pockets,
    "bores": _bores,
    "crossed": _crossed,
    "counterbores": _counterbores,
    "cavities": _cavities,
    "steps": _steps,
    "behind": _behind,
    "corners": _corners,
    "covered": _covered,
    "profiles": _profiles,
    "grooves": _grooves,
    "bosses": _bosses,
    "rounds": _rounds,
    "ribs": _ribs,
}
