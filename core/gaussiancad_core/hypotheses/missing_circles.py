"""Circles that a view may lack: two others show the outline of a cylinder along its axis."""

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations, islice
from math import pi

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.hypotheses.suppressed_slants import MOST_LOST
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.sheet.work_limits import ENDS

_SQUARE = 2
"""Sides of the square around a circle that are drawn at least where there is none."""

Band = tuple[float, float, float, float]
"""Middle and half of the width of two parallel lines, and from where to where both are drawn."""


def missing_circles(
    carriers: PartCarriers, normal: Axis, near: float
) -> Iterator[tuple[Circle, float, float]]:
    """Circles of a plane of whose cylinders both other planes show the sides.

    A square pocket has such sides as well, but is drawn.  Where no view draws any circle there are
    most likely none.

    Args:
        carriers: of all planes.
        normal: of the plane.
        near: units within which coordinates are one.
    """
    if not any(
        isinstance(carrier.curve, Circle)
        for plane in carriers.planes.values()
        for carrier in plane.carriers
    ):
        return
    first, second = (Axis(index) for index in IN_PLANE[normal])
    one = [*islice(_bands(carriers.planes[second], first, near), ENDS)]
    other = [*islice(_bands(carriers.planes[first], second, near), ENDS)]
    plane = carriers.planes[normal]
    drawn = [s.curve for s in plane.carriers if isinstance(s.curve, Circle)]
    found: list[Circle] = []
    for a, radius, *ends in one:
        for b, width, *others in other:
            apart = (radius - width, ends[0] - others[0], ends[1] - others[1])
            if max(map(abs, apart)) > near:
                continue
            circle = Circle((a, b), radius)
            known = any(_alike(circle, other, near) for other in (*drawn, *found))
            if not known and _sides(plane, circle, near) < _SQUARE:
                found.append(circle)
    for circle in sorted(found, key=lambda circle: circle.radius)[:MOST_LOST]:
        yield circle, 0.0, FULL_TURN


def sectioned_circles(
    carriers: PartCarriers, normal: Axis, cuts: Collection[tuple[Axis, float]], near: float
) -> Iterator[tuple[Circle, float, float]]:
    """Circles of a plane that sections through the centre of a drawn one show: grooves, and bores
    that are wider inside.

    Args:
        carriers: of all planes.
        normal: of the plane.
        cuts: cutting planes: the axis that one is across, units along it.
        near: units within which coordinates are one.
    """
    plane = carriers.planes[normal]
    drawn = [s.curve for s in plane.carriers if isinstance(s.curve, Circle)]
    found: list[Circle] = []
    for axis, at in cuts:
        if axis is normal:
            continue
        along = IN_PLANE[normal].index(axis.value)
        across = Axis(IN_PLANE[normal][1 - along])
        through = [curve.centre for curve in drawn if abs(curve.centre[along] - at) <= near]
        for middle, radius, *_ in islice(_bands(carriers.planes[axis], across, near), ENDS):
            for centre in through:
                circle = Circle(centre, radius)
                known = any(_alike(circle, other, near) for other in (*drawn, *found))
                coaxial = abs(centre[1 - along] - middle) <= near and not known
                ends = (middle - radius, middle + radius)
                if not coaxial or _shows(drawn, along, at, ends, near):
                    continue
                if _sides(plane, circle, near) < _SQUARE:
                    found.append(circle)
    for circle in sorted(found, key=lambda circle: circle.radius)[:MOST_LOST]:
        yield circle, 0.0, FULL_TURN


def _shows(
    circles: Sequence[Circle],
    along: int,
    at: float,
    places: tuple[float, float],
    near: float,
) -> bool:
    """Whether a line of a section is the side of a drawn circle whose centre the plane meets."""
    return any(
        abs(circle.centre[along] - at) <= near
        and abs(abs(place - circle.centre[1 - along]) - circle.radius) <= near
        for circle in circles
        for place in places
    )


def _bands(plane: PlaneCarriers, across: Axis, near: float) -> Iterator[Band]:
    """Pairs of lines at right angles to an axis that are drawn from and to the same depths."""
    place = IN_PLANE[plane.normal].index(across.value)
    lines = []
    for carrier in plane.carriers:
        curve = carrier.curve
        if isinstance(curve, Line) and curve.axis == place:
            start = curve.point[1 - place]
            for low, high in carrier.drawn():
                lines.append((curve.point[place], start + low, start + high))
    for (a, low, high), (b, other_low, other_high) in combinations(sorted(lines), 2):
        same = abs(low - other_low) <= near and abs(high - other_high) <= near
        if same and b - a > 4.0 * near:
            yield (a + b) / 2.0, (b - a) / 2.0, low, high


def _sides(plane: PlaneCarriers, circle: Circle, near: float) -> int:
    """How many sides of the square around a circle are drawn where they touch it."""
    places = [circle.at(quarter * pi / 2.0) for quarter in range(4)]
    found = 0
    for quarter, place in enumerate(places):
        found += any(
            carrier.curve.axis == quarter % 2
            and carrier.curve.distance(place) <= near
            and any(low < carrier.curve.parameter(place) < high for low, high in carrier.drawn())
            for carrier in plane.carriers
        )
    return found


def _alike(one: Circle, other: Circle, near: float) -> bool:
    (x, y), (u, v) = one.centre, other.centre
    return max(abs(x - u), abs(y - v), abs(one.radius - other.radius)) <= near
