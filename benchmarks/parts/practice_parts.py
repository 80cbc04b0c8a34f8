"""Parts of six classes as workshops draw them: their holes are known one by one, for notes.

All lengths are millimetres; boxes begin at the origin.  Front views look along +Y: a section in
place of the front is a plane at a y.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import product
from math import cos, pi, sin
from random import Random

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import Point2, box, cut, cylinder, fuse, revolved

_OVER = 1.0
"""mm by which tools reach beyond a part."""


@dataclass
class Lot:
    """The measures and variants of one part, drawn by lot.

    Attributes:
        name: of the class.
        seed: parts of one class and seed are alike.
    """

    name: str
    seed: int
    _random: Random = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self._random = Random(f"{self.name} {self.seed}")

    def size(self, low: float, high: float, step: float = 1.0) -> float:
        """A measure in mm between two others, which differ by whole steps."""
        return low + step * self._random.randint(0, int((high - low) / step + 1e-9))

    def chance(self) -> bool:
        """Whether a part has something that half of its kind have."""
        return self._random.random() < 0.5

    def one_of(self, *choices: float) -> float:
        """Any of some values."""
        return self._random.choice(choices)


def ring_of_points(count: int, radius: float, centre: Point2) -> Iterator[Point2]:
    """Points on a circle, evenly spaced, the first one to its right."""
    for angle in (2.0 * pi * number / count for number in range(count)):
        yield centre[0] + radius * cos(angle), centre[1] + radius * sin(angle)


def corners(length: float, width: float, inset: float) -> Iterator[Point2]:
    """The four points inside a rectangle from the origin that are ``inset`` from two sides."""
    yield from product((inset, length - inset), (inset, width - inset))


@dataclass(frozen=True)
class Hole:
    """A round hole from one face of a part inwards.

    Attributes:
        axis: that it runs along.
        centre: in the plane across it, the other axes in the order x, y, z.
        diameter: of the hole.
        face: where it begins along the axis.
        end: where it ends; beyond the other face where it goes through.
        through: whether it does.
        bore: diameter and depth of a counterbore at its beginning.
    """

    axis: Axis
    centre: Point2
    diameter: float
    face: float
    end: float
    through: bool = True
    bore: tuple[float, float] | None = None

    def tools(self) -> list[TopoDS_Shape]:
        """What it takes away."""
        found = [self._tool(self.diameter, self.end)]
        if self.bore is not None:
            inwards = -1.0 if self.end < self.face else 1.0
            found.append(self._tool(self.bore[0], self.face + inwards * self.bore[1]))
        return found

    def _tool(self, diameter: float, end: float) -> TopoDS_Shape:
        out = self.face + (_OVER if end < self.face else -_OVER)
        low, high = sorted((out, end))
        return cylinder(self.axis, self.centre, diameter / 2.0, low, high)


@dataclass(frozen=True)
class Part:
    """A part and what a draughtsman knows of it.

    Attributes:
        shape: the solid.
        holes: that are told by notes where no section shows them.
        plane: y of a full section that shows most.
        steps: of an offset section: x from which on the plane is at a y; none where no holes
            lie beside each other.
        symmetric: whether a half section of the front view tells all of it.
        diameters: of a turned part along x: (x from, x to, diameter); none of others.
        open: whether views without hidden lines show all that is no hole.
    """

    shape: TopoDS_Shape
    holes: tuple[Hole, ...]
    plane: float
    steps: tuple[tuple[float, float], ...] = ()
    symmetric: bool = False
    diameters: tuple[tuple[float, float, float], ...] = ()
    open: bool = True


def _drilled(shape: TopoDS_Shape, holes: list[Hole]) -> TopoDS_Shape:
    return cut(shape, *(tool for hole in holes for tool in hole.tools()))


def plate(lot: Lot) -> Part:
    """A plate with four through holes, one of two more with a counterbore, and a step at times."""
    length, width, thick = lot.size(70, 110, 5), lot.size(50, 70, 5), lot.size(10, 18, 2)
    small, inset = lot.size(5, 8), 10.0
    holes = [Hole(Axis.Z, at, small, thick, -_OVER) for at in corners(length, width, inset)]
    y1, y2 = width / 2.0 - lot.size(4, 8), width / 2.0 + lot.size(4, 8)
    first, second = lot.size(9, 12), lot.size(6, 8)
    holes += [
        Hole(Axis.Z, (length / 3.0, y1), first, thick, -_OVER),
        Hole(
            Axis.Z, (2.0 * length / 3.0, y2), second, thick, -_OVER,
            bore=(second + 6.0, lot.size(4, 6)),
        ),
    ]  # fmt: skip
    body = box((0, 0, 0), (length, width, thick))
    if lot.chance():
        body = cut(body, box((length - 5.0, -1, thick / 2.0), (length + 1, width + 1, thick + 1)))
    return Part(_drilled(body, holes), tuple(holes), y2, ((0.0, y1), (length / 2.0, y2)))


def block(lot: Lot) -> Part:
    """A block with two blind bores from above and one from the side that goes through."""
    length, width, height = lot.size(60, 90, 5), lot.size(40, 60, 5), lot.size(35, 50, 5)
    large, small = lot.size(16, 22, 2), lot.size(8, 12)
    y1, y2 = width / 2.0, width / 2.0 - lot.size(5, 9)
    holes = [
        Hole(Axis.Z, (length / 4.0, y1), large, height, lot.size(8, 14), through=False),
        Hole(Axis.Z, (3.0 * length / 4.0, y2), small, height, lot.size(12, 20), through=False),
    ]
    cross = lot.size(5, 7)
    holes.append(Hole(Axis.Y, (length / 2.0, height / 2.0), cross, 0.0, width + _OVER))
    body = box((0, 0, 0), (length, width, height))
    return Part(_drilled(body, holes), tuple(holes), y1, ((0.0, y1), (length / 2.0, y2)))


def flange(lot: Lot) -> Part:
    """A disc with a hub, a bore in steps and a ring of holes."""
    outer, hub = lot.size(90, 120, 10), lot.size(40, 50, 5)
    thick, high = lot.size(12, 16, 2), lot.size(30, 45, 5)
    bore, seat, deep = lot.size(16, 20, 2), lot.size(26, 32, 2), lot.size(6, 10)
    count, size = int(lot.one_of(4, 6, 8)), lot.size(7, 10)
    centre = (outer / 2.0, outer / 2.0)
    body = fuse(
        cylinder(Axis.Z, centre, outer / 2.0, 0.0, thick),
        cylinder(Axis.Z, centre, hub / 2.0, 0.0, high),
    )
    ring = ring_of_points(count, (outer + hub) / 4.0, centre)
    holes = [Hole(Axis.Z, centre, bore, high, -_OVER, bore=(seat, deep))]
    holes += [Hole(Axis.Z, at, size, thick, -_OVER) for at in ring]
    return Part(_drilled(body, holes), tuple(holes), outer / 2.0, symmetric=True)


def shaft(lot: Lot) -> Part:
    """A turned part along x: shoulders, and a bore from the right end, or through, or none."""
    radii = [lot.size(10, 14), lot.size(16, 22, 2), lot.size(8, 12)]
    if lot.chance():
        radii.insert(2, radii[1] + lot.size(4, 8))
    middle = max(radii)
    outline, at, steps = [(0.0, 0.0)], 0.0, []
    for radius in radii:
        start, at = at, at + lot.size(15, 35, 5)
        outline += [(start, radius), (at, radius)]
        steps.append((start, at, 2.0 * radius))
    outline.append((at, 0.0))
    body = revolved(outline, Axis.X, (middle, middle))
    kind, holes = lot.one_of(0, 1, 2), []
    if kind:
        end = -_OVER if kind == 1 else at - lot.size(15, 30, 5)
        size = lot.size(6, 10)
        holes = [Hole(Axis.X, (middle, middle), size, at, end, through=kind == 1)]
        body = _drilled(body, holes)
    return Part(body, tuple(holes), middle, symmetric=True, diameters=tuple(steps))


def bracket(lot: Lot) -> Part:
    """An angle: a foot with two holes, a wall with one that has a counterbore."""
    length, width, height = lot.size(60, 80, 5), lot.size(40, 60, 10), lot.size(50, 70, 5)
    foot, wall = lot.size(8, 12, 2), lot.size(10, 14, 2)
    body = fuse(box((0, 0, 0), (length, width, foot)), box((0, 0, 0), (wall, width, height)))
    size, pin = lot.size(6, 9), lot.size(8, 11)
    x = wall + (length - wall) / 2.0
    holes = [Hole(Axis.Z, (x, at), size, foot, -_OVER) for at in (width / 4.0, 3.0 * width / 4.0)]
    up = foot + (height - foot) / 2.0
    holes.append(
        Hole(Axis.X, (width / 2.0, up), pin, wall, -_OVER, bore=(pin + 6.0, lot.size(3, 5)))
    )
    return Part(_drilled(body, holes), tuple(holes), width / 2.0)


def housing(lot: Lot) -> Part:
    """A box with a pocket from above, a bore in its floor and one through its right wall."""
    length, width, height = lot.size(70, 100, 5), lot.size(50, 70, 5), lot.size(35, 50, 5)
    wall, floor = lot.size(6, 10, 2), lot.size(8, 12, 2)
    body = cut(
        box((0, 0, 0), (length, width, height)),
        box((wall, wall, floor), (length - wall, width - wall, height + 1)),
    )
    middle = (length / 2.0, width / 2.0)
    holes = [Hole(Axis.Z, middle, lot.size(14, 20, 2), floor, -_OVER)]
    up = floor + (height - floor) / 2.0
    inside = length - wall - _OVER
    holes.append(Hole(Axis.X, (width / 2.0, up), lot.size(8, 12), length, inside))
    return Part(_drilled(body, holes), tuple(holes), width / 2.0, open=False)


CLASSES: dict[str, Callable[[Lot], Part]] = {
    item.__name__: item for item in (plate, block, flange, shaft, bracket, housing)
}
"""The six classes by name."""
