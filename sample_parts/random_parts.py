"""Parts by chance: blocks, angles, stairs and shafts with holes, slots, pockets, bosses and slants.

Every measure is a whole even number of millimetres, so that features are either apart or coincide
exactly, as in drawings of real parts.
"""

from collections.abc import Callable

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import bounding_box, moved_to_origin, soundness
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import (
    Point2,
    Point3,
    box,
    chamfered,
    cone,
    cut,
    cylinder,
    edges_along,
    filleted,
    fuse,
    prism,
    slot,
)

Step = Callable[["_Workpiece", np.random.Generator], TopoDS_Shape]

_FAILURES: tuple[type[Exception], ...] = (*KERNEL_FAILURES, ValueError)

_BEYOND = 1.0
"""mm by which tools reach out of the part that they cut."""


class _Workpiece:
    """A part as far as it is made, and its bounding box."""

    def __init__(self, shape: TopoDS_Shape) -> None:
        self.shape = shape
        low, high = bounding_box(shape)
        self.low, self.high = np.rint(low), np.rint(high)

    def place(self, axis: Axis, radius: float, random: np.random.Generator) -> Point2 | None:
        """A centre across an axis that keeps ``radius`` and two millimetres from the borders."""
        low, high = (np.delete(side, axis.value) for side in (self.low, self.high))
        first, last = low + radius + 2.0, high - radius - 2.0
        if (last < first).any():
            return None
        x, y = (_even(random, a, b) for a, b in zip(first, last, strict=True))
        return x, y

    def along(self, axis: Axis) -> tuple[float, float]:
        """Its interval along an axis."""
        return float(self.low[axis.value]), float(self.high[axis.value])


def random_part(seed: int, steps: int | None = None) -> TopoDS_Shape:
    """One valid closed solid, its bounding box starting at the origin.

    Args:
        seed: the same seed gives the same part.
        steps: number of features beside the body; by chance two to six if None.
    """
    random = np.random.default_rng(seed)
    body = _BODIES[random.integers(len(_BODIES))](random)
    wanted = int(random.integers(2, 7)) if steps is None else steps
    for _ in range(6 * wanted):
        if wanted == 0:
            break
        step = _STEPS[random.integers(len(_STEPS))]
        changed = _tried(step, body, random)
        if changed is not None:
            body = changed
            wanted -= 1
    return moved_to_origin(body)


def _tried(step: Step, body: TopoDS_Shape, random: np.random.Generator) -> TopoDS_Shape | None:
    """The body after a step, if that changed it and left one sound solid."""
    try:
        changed = step(_Workpiece(body), random)
        before, after = soundness(body), soundness(changed)
    except _FAILURES:
        return None
    sound = after.valid and after.closed and after.solids == 1
    different = abs(after.volume_mm3 - before.volume_mm3) > 1.0
    # A part of which most is gone has little left to draw.
    enough = after.volume_mm3 > 0.5 * before.volume_mm3
    return changed if sound and different and enough else None


def _even(random: np.random.Generator, low: float, high: float) -> float:
    """An even number from ``low`` to ``high``, both included; the lower even one at least."""
    first, last = int(np.ceil(low / 2.0)), int(np.floor(high / 2.0))
    return 2.0 * float(random.integers(first, max(first, last) + 1))


def _axis(random: np.random.Generator) -> Axis:
    return Axis(int(random.integers(3)))


def _block(random: np.random.Generator) -> TopoDS_Shape:
    x, y, z = (_even(random, 24, 100) for _ in range(3))
    return box((0, 0, 0), (x, y, z))


def _angle(random: np.random.Generator) -> TopoDS_Shape:
    x, y, z = (_even(random, 40, 100) for _ in range(3))
    leg, floor = _even(random, 8, 0.4 * x), _even(random, 8, 0.4 * z)
    outline = [(0, 0), (x, 0), (x, floor), (leg, floor), (leg, z), (0, z)]
    return prism(Axis.Y, outline, 0, y)


def _stair(random: np.random.Generator) -> TopoDS_Shape:
    x, y, z = (_even(random, 40, 100) for _ in range(3))
    first, second = _even(random, 0.25 * x, 0.4 * x), _even(random, 0.55 * x, 0.75 * x)
    low, middle = _even(random, 0.2 * z, 0.35 * z), _even(random, 0.5 * z, 0.75 * z)
    outline = [
        (0, 0), (x, 0), (x, low), (second, low), (second, middle), (first, middle), (first, z),
        (0, z),
    ]  # fmt: skip
    return prism(Axis(int(random.integers(2))), outline, 0, y)


def _wedge(random: np.random.Generator) -> TopoDS_Shape:
    x, y, z = (_even(random, 40, 100) for _ in range(3))
    top, side = _even(random, 8, 0.6 * x), _even(random, 6, 0.6 * z)
    return prism(_axis(random), [(0, 0), (x, 0), (x, side), (top, z), (0, z)], 0, y)


def _shaft(random: np.random.Generator) -> TopoDS_Shape:
    axis, at, start = _axis(random), (0.0, 0.0), 0.0
    pieces = []
    for _ in range(int(random.integers(1, 4))):
        end = start + _even(random, 14, 40)
        pieces.append(cylinder(axis, at, _even(random, 10, 30), start, end))
        start = end
    return fuse(*pieces)


def _link(random: np.random.Generator) -> TopoDS_Shape:
    radius, length = _even(random, 14, 26), _even(random, 30, 70)
    return slot(_axis(random), ((0, 0), (length, 0)), radius, 0, _even(random, 10, 30))


def _hole(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    axis, radius = _axis(random), _even(random, 3, 14)
    centre = work.place(axis, radius, random)
    if centre is None:
        return work.shape
    low, high = work.along(axis)
    bottom = low - _BEYOND if random.random() < 0.7 else _even(random, low + 4, high - 4)
    tools = [cylinder(axis, centre, radius, bottom, high + _BEYOND)]
    kind = random.random()
    wider = radius + _even(random, 2, 6)
    depth = _even(random, 4, max(4.0, 0.4 * (high - low)))
    if kind < 0.2:
        tools.append(cylinder(axis, centre, wider, high - depth, high + _BEYOND))
    elif kind < 0.3:
        tools.append(cone(axis, centre, (radius, wider), high - (wider - radius), high))
    return cut(work.shape, *tools)


def _pair(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    """Two equal holes, mirrored in the part's middle."""
    axis, radius = _axis(random), _even(random, 3, 8)
    centre = work.place(axis, radius, random)
    if centre is None:
        return work.shape
    low, high = work.along(axis)
    middle = np.delete(work.low + work.high, axis.value)
    mirrored = (float(middle[0] - centre[0]), centre[1])
    tools = [cylinder(axis, at, radius, low - _BEYOND, high + _BEYOND) for at in (centre, mirrored)]
    return cut(work.shape, *tools)


def _slot(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    axis, radius = _axis(random), _even(random, 3, 10)
    centre = work.place(axis, 2.0 * radius, random)
    if centre is None:
        return work.shape
    reach = _even(random, 2, 2.0 * radius)
    way = (reach, 0.0) if random.random() < 0.5 else (0.0, reach)
    one, other = ((centre[0] + s * way[0], centre[1] + s * way[1]) for s in (-0.5, 0.5))
    low, high = work.along(axis)
    bottom = low - _BEYOND if random.random() < 0.6 else _even(random, low + 4, high - 4)
    return cut(work.shape, slot(axis, (one, other), radius, bottom, high + _BEYOND))


def _pocket(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    """A rectangular pocket from one side, or a groove where it reaches a border."""
    axis = _axis(random)
    lower, upper = work.low.copy(), work.high.copy()
    for index in range(3):
        low, high = work.low[index], work.high[index]
        if index == axis.value:
            lower[index], upper[index] = _even(random, low + 4, high - 4), high + _BEYOND
            continue
        lower[index] = _even(random, low + 4, 0.5 * (low + high))
        upper[index] = _even(random, lower[index] + 6, high - 4)
        if random.random() < 0.3:
            upper[index] = high + _BEYOND
        if random.random() < 0.2:
            lower[index] = low - _BEYOND
    return cut(work.shape, box(_point(lower), _point(upper)))


def _corner(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    """A step cut off along one edge of the bounding box."""
    lower, upper = work.low - _BEYOND, work.high + _BEYOND
    axis = _axis(random)
    for index in range(3):
        if index == axis.value:
            continue
        low, high = work.low[index], work.high[index]
        if random.random() < 0.5:
            lower[index] = _even(random, 0.5 * (low + high), high - 4)
        else:
            upper[index] = _even(random, low + 4, 0.5 * (low + high))
    return cut(work.shape, box(_point(lower), _point(upper)))


def _slant(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    """One edge of the bounding box along an axis cut off at an angle."""
    axis = _axis(random)
    low, high = (np.delete(side, axis.value) for side in (work.low, work.high))
    legs = [_even(random, 4, max(4.0, 0.5 * (b - a))) for a, b in zip(low, high, strict=True)]
    corner, way = high, np.array([-1.0, -1.0])
    if random.random() < 0.5:
        corner, way = np.array([low[0], high[1]]), np.array([1.0, -1.0])
    outline = [
        (corner[0], corner[1]),
        (corner[0] + way[0] * legs[0], corner[1]),
        (corner[0], corner[1] + way[1] * legs[1]),
    ]
    start, end = work.along(axis)
    return cut(work.shape, prism(axis, outline, start - _BEYOND, end + _BEYOND))


def _boss(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    axis, radius = _axis(random), _even(random, 6, 16)
    centre = work.place(axis, radius, random)
    if centre is None:
        return work.shape
    _, high = work.along(axis)
    boss = cylinder(axis, centre, radius, high - 2.0, high + _even(random, 6, 24))
    body = fuse(work.shape, boss)
    if random.random() < 0.5:
        bore = cylinder(axis, centre, radius - _even(random, 2, 0.6 * radius), high, high + 30.0)
        body = cut(body, bore)
    return body


def _round(work: _Workpiece, random: np.random.Generator) -> TopoDS_Shape:
    """Edges of the bounding box along an axis rounded or cut off, as far as the part has them."""
    axis = _axis(random)
    low, high = (np.delete(side, axis.value) for side in (work.low, work.high))
    corners = [(float(x), float(y)) for x in (low[0], high[0]) for y in (low[1], high[1])]
    edges = edges_along(work.shape, axis, corners)
    if not edges:
        return work.shape
    size = _even(random, 2, 0.2 * float((high - low).min()))
    maker = filleted if random.random() < 0.7 else chamfered
    return maker(work.shape, edges, size)


def _point(values: np.ndarray) -> Point3:
    x, y, z = (float(value) for value in values)
    return x, y, z


_BODIES = (_block, _block, _block, _angle, _stair, _wedge, _shaft, _link)
_STEPS: tuple[Step, ...] = (
    _hole,
    _hole,
    _hole,
    _pair,
    _slot,
    _pocket,
    _pocket,
    _corner,
    _slant,
    _boss,
    _round,
)
