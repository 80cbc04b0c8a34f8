"""Words that parts of textbooks are modelled with, beside those of the samples, and their measures.

All lengths are millimetres; a plane across an axis has the two other axes as coordinates, in the
order x, y, z.  Parts may stand anywhere: they are moved to the origin when all is done.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import product
from math import acos, atan2, cos, hypot, pi, sin
from random import Random

from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape

from gaussiancad_core.kernel.brep import moved_to_origin, soundness
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import (
    Point2,
    Point3,
    box,
    cut,
    cylinder,
    edges_along,
    edges_where,
    filleted,
    fuse,
    prism,
    slot,
)

Circle = tuple[Point2, float]
"""A centre and a radius in mm."""

FAR = 300.0
"""mm beyond every part."""

_ODD_SHARE = 0.3
"""Of a step: by so much odd measures are beside round ones at most."""


@dataclass
class Lot:
    """The measures and variants of one part, drawn by lot.

    Attributes:
        name: of the family.
        seed: parts of one family and seed are alike.
        odd: whether measures are hundredths of a millimetre instead of round numbers.
    """

    name: str
    seed: int
    odd: bool = False
    _random: Random = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self._random = Random(f"{self.name} {self.seed}")

    def size(self, low: float, high: float, step: float = 1.0) -> float:
        """A measure in mm between two others, which differ by whole steps."""
        value = low + step * self._random.randint(0, int((high - low) / step + 1e-9))
        if self.odd:
            value += round(self._random.uniform(-_ODD_SHARE, _ODD_SHARE) * step, 2)
        return round(value, 3)

    def chance(self) -> bool:
        """Whether a part has something that half of its kind have."""
        return self._random.random() < 0.5

    def one_of(self, *choices: float) -> float:
        """Any of some values."""
        return self._random.choice(choices)


@dataclass(frozen=True)
class Family:
    """A kind of part.

    Attributes:
        name: of the kind.
        group: of kinds that are alike.
        model: makes one.
    """

    name: str
    group: str
    model: Callable[[Lot], TopoDS_Shape]

    def part(self, seed: int, odd: bool = False) -> TopoDS_Shape:
        """One part, its box starting at the origin.

        Raises:
            ValueError: the measures make no valid closed solid.
        """
        shape = moved_to_origin(self.model(Lot(self.name, seed, odd)))
        facts = soundness(shape)
        if not (facts.valid and facts.closed and facts.solids == 1):
            raise ValueError(f"{self.name} {seed} is not one valid solid")
        return shape


def families(group: str, *models: Callable[[Lot], TopoDS_Shape]) -> tuple[Family, ...]:
    """Families named after the functions that model their parts."""
    return tuple(Family(model.__name__.replace("_", "-"), group, model) for model in models)


def hole(
    axis: Axis, centre: Point2, radius: float, start: float = -FAR, end: float = FAR
) -> TopoDS_Shape:
    """What a drill takes away: through everything, or from or to a depth."""
    return cylinder(axis, centre, radius, start, end)


def milled_slot(
    axis: Axis, middle: Point2, half: float, radius: float, *, start: float = -FAR
) -> TopoDS_Shape:
    """What a cutter takes away that goes ``half`` to both sides of a middle."""
    u, v = middle
    return slot(axis, ((u - half, v), (u + half, v)), radius, start, FAR)


def ring_of_points(
    count: int, radius: float, centre: Point2 = (0.0, 0.0), first: float = 0.0
) -> Iterator[Point2]:
    """Points on a circle, evenly spaced, the first one at an angle in radians."""
    for number in range(count):
        angle = first + 2.0 * pi * number / count
        yield centre[0] + radius * cos(angle), centre[1] + radius * sin(angle)


def corners(length: float, width: float, inset: float) -> Iterator[Point2]:
    """The four points inside a rectangle from the origin that are ``inset`` from two sides."""
    yield from product((inset, length - inset), (inset, width - inset))


def rounded_plate(length: float, width: float, radius: float, thickness: float) -> TopoDS_Shape:
    """A plate with round corners, from the origin."""
    plate = box((0, 0, 0), (length, width, thickness))
    upright = edges_along(plate, Axis.Z, product((0, length), (0, width)))
    return filleted(plate, upright, radius)


def belt(one: Circle, other: Circle, start: float, end: float) -> TopoDS_Shape:
    """Two circles and what lies between their outer tangents, extruded along Z."""
    (one_centre, one_radius), (other_centre, other_radius) = one, other
    run, rise = other_centre[0] - one_centre[0], other_centre[1] - one_centre[1]
    way, turn = atan2(rise, run), acos((one_radius - other_radius) / hypot(run, rise))

    def touching(centre: Point2, radius: float, side: float) -> Point2:
        angle = way + side * turn
        return centre[0] + radius * cos(angle), centre[1] + radius * sin(angle)

    flank = [
        touching(one_centre, one_radius, 1.0),
        touching(one_centre, one_radius, -1.0),
        touching(other_centre, other_radius, -1.0),
        touching(other_centre, other_radius, 1.0),
    ]
    return fuse(
        prism(Axis.Z, flank, start, end),
        cylinder(Axis.Z, one_centre, one_radius, start, end),
        cylinder(Axis.Z, other_centre, other_radius, start, end),
    )


def hexagon(across_flats: float, turned: bool) -> list[Point2]:
    """The corners of a hexagon around the origin; two of them lie level, or upright if turned."""
    first = pi / 6.0 if turned else 0.0
    return list(ring_of_points(6, across_flats / 3.0**0.5, first=first))


def edges_at(shape: TopoDS_Shape, axis: Axis, place: float) -> list[TopoDS_Edge]:
    """The edges that end at a coordinate along an axis with both ends: the rims of a face there."""
    index = axis.value
    return edges_where(
        shape, lambda start, end: max(abs(start[index] - place), abs(end[index] - place)) < 1e-6
    )


def rims(shape: TopoDS_Shape, axis: Axis, circle: Circle, *places: float) -> list[TopoDS_Edge]:
    """The ends, at some coordinates along an axis, of a bore whose cross section is a circle."""
    centre, radius = circle

    def is_rim(start: Point3, end: Point3) -> bool:
        for point in (start, end):
            u, v = (point[index] for index in range(3) if index != axis.value)
            if abs(hypot(u - centre[0], v - centre[1]) - radius) > 1e-6:
                return False
        return any(
            max(abs(start[axis.value] - place), abs(end[axis.value] - place)) < 1e-6
            for place in places
        )

    return edges_where(shape, is_rim)


def upright_edges(shape: TopoDS_Shape, length: float, width: float) -> list[TopoDS_Edge]:
    """The edges along Z at the corners of a rectangle from the origin."""
    return edges_along(shape, Axis.Z, product((0, length), (0, width)))


def counterbored(
    shape: TopoDS_Shape, centre: Point2, radii: tuple[float, float], depth: float
) -> TopoDS_Shape:
    """A hole along Z through everything, wider from a height ``depth`` on."""
    return cut(shape, hole(Axis.Z, centre, radii[0]), hole(Axis.Z, centre, radii[1], depth))
