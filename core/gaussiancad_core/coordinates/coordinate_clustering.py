"""One value for what is one: axis values and circles shared by the views.

A plane of the part that is parallel to an axis shows its coordinate in two views, a cylinder shows
its centre and radius as a circle in one view and as the values ``centre +- radius`` in two others.
The lines of the sheet tell each of these with a small error.  What lies together within a tolerance
is made equal, as a weighted least-squares problem with linear equations: values, centres and radii
move as little as possible, and tangencies hold exactly afterwards.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from gaussiancad_core.coordinates.circle_constraints import circle_relations
from gaussiancad_core.coordinates.constrained_places import ConstrainedPlaces, constrained_places
from gaussiancad_core.coordinates.design_step import ODD, NominalStep, nominal_step
from gaussiancad_core.coordinates.dimension_equations import dimension_relations, with_dimensions
from gaussiancad_core.coordinates.grid_fitting import Roughness, likely_numbers
from gaussiancad_core.coordinates.linear_constraints import Linear, Numbers, solved
from gaussiancad_core.coordinates.round_numbers import round_numbers
from gaussiancad_core.evidence.dimension_constraints import DimensionConstraints
from gaussiancad_core.geometry.tolerances import MOVED
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

CERTAIN = 1e6
"""Weight of a number that is known to be a multiple of the part's step."""

_AGREEING = 0.15
"""Share of the reach within which ends of slanted lines that have one coordinate agree."""

_FEWEST_AGREEING = 3
"""Such ends, in two planes at least, that tell a value within reach of another one."""

_AT_CIRCLE = 0.25
"""Share of the reach within which an end of a line has the coordinate of a circle's centre or
extreme: half a tolerance."""


@dataclass(frozen=True)
class CoordinateReading:
    """A coordinate as a view shows it.

    Attributes:
        axis: of the model.
        value: units.
        weight: how much it counts: the length of the line.
        normal: of the plane that shows it, where it matters.
    """

    axis: Axis
    value: float
    weight: float
    normal: Axis | None = None


@dataclass(frozen=True)
class CircleReading:
    """A circle or arc as a view shows it.

    Attributes:
        normal: of the plane it lies in.
        circle: units.
        weight: how much it counts.
    """

    normal: Axis
    circle: Circle
    weight: float


@dataclass(frozen=True)
class Snapped:
    """Values and circles of a part.

    Attributes:
        values: of each axis, ascending.
        weights: of the values.
        circles: distinct ones, with the normal of their plane.
        circle_weights: of each.
        reach: how far a reading may lie from its value.
        step: that the part was designed in; None where none is told.
        nominal: whether all values and circles are multiples of it, or follow from such.
        moved: units by which those moved, at the mean, that most likely are multiples of a step.
        begins: units that all readings of an axis move towards its beginning by, as told.
        unread: whether numbers are multiples of the step only as the sheet says: what it says may
            have been misread.
        places: that follow from what the sheet says; None where it says nothing.
    """

    values: dict[Axis, tuple[float, ...]]
    weights: dict[tuple[Axis, float], float]
    circles: tuple[tuple[Axis, Circle], ...]
    circle_weights: tuple[float, ...]
    reach: float
    step: NominalStep | None = None
    nominal: bool = False
    moved: float = 0.0
    begins: Mapping[Axis, float] = field(default_factory=dict)
    unread: bool = False
    places: ConstrainedPlaces | None = None

    def value(self, axis: Axis, reading: float, reach: float | None = None) -> float | None:
        """The value nearest to a reading, if it is within reach."""
        values = self.values[axis]
        if not values:
            return None
        nearest = min(values, key=lambda value: abs(value - reading))
        within = self.reach if reach is None else reach
        return nearest if abs(nearest - reading) <= within else None

    @property
    def odd_numbers(self) -> int:
        """How many values, centres and radii are no multiples of the step, nor follow from such."""
        if self.step is None:
            return 0
        groups = {axis.value: list(value) for axis, value in self.values.items()}
        for normal, circle in self.circles:
            for index, place in zip(IN_PLANE[normal], circle.centre, strict=True):
                groups[index].append(place)
        extents = [max(group, default=0.0) for group in groups.values()]
        groups[len(extents)] = [circle.radius for _, circle in self.circles]
        return sum(map(self.step.odd, groups.values(), (*extents, 0.0)))

    def circle(self, normal: Axis, reading: Circle) -> Circle | None:
        """The circle that a reading is one of."""
        best: tuple[float, Circle] | None = None
        for axis, circle in self.circles:
            off = _circle_distance(circle, reading)
            if axis is normal and off <= 2.0 * self.reach and (best is None or off < best[0]):
                best = off, circle
        return best[1] if best else None


def snapped(
    readings: Sequence[CoordinateReading],
    circles: Sequence[CircleReading],
    tolerance: float,
    apart: float | None = None,
    millimetre: float = 0.0,
    *,
    noise: float = 0.0,
    stated: DimensionConstraints | None = None,
    scaled: bool = False,
) -> Snapped:
    """Make readings that belong together equal.

    Args:
        readings: of lines parallel to an axis.
        circles: of all planes.
        tolerance: units by which a reading may be off.
        apart: units from which values are different ones; the tolerance if it is None.
        millimetre: units, as far as the scale is known; 0 where it is not.
        noise: units by which readings are off; 0 where only sure measures become round.
        stated: lengths that the sheet has in numbers, units.
        scaled: whether the scale is known for certain.
    """
    apart = tolerance if apart is None else apart
    variables = _Variables()
    clusters = {
        axis: [
            variables.add(*_mean(cluster))
            for cluster in _clusters([r for r in readings if r.axis is axis], apart)
        ]
        for axis in Axis
    }
    merged = _merged_circles(circles, 2.0 * tolerance)
    items: list[tuple[Axis, int, int, int]] = []
    for reading in merged:
        (x, y), radius = reading.circle.centre, reading.circle.radius
        weight = reading.weight
        x_at, y_at, radius_at = (variables.add(number, weight) for number in (x, y, radius))
        items.append((reading.normal, x_at, y_at, radius_at))
    relations = circle_relations(variables.observed, clusters, items, tolerance)
    read, known = variables.weights, None
    if stated is not None:
        said = dimension_relations(variables.observed, clusters, items, stated, tolerance)
        known = with_dimensions(
            variables.observed, (clusters, items), (relations, said), MOVED * tolerance
        )
        variables.observed, relations = known.numbers, [*relations, *known.kept]
        variables.weights = (known.factors * variables.weights).tolist()
    numbers = solved(variables.observed, variables.weights, relations, MOVED * tolerance)
    # Files round as well: solids that lie a hundred-thousandth beside each other defeat Booleans.
    step = _step(numbers, tolerance, millimetre)
    nominal, moved, far = False, 0.0, MOVED * tolerance
    if step is not None:
        step = step.moving(numbers)
        variables, numbers, nominal = _rounded(
            (variables.weights, read), numbers, relations, step, far
        )
    elif noise:
        rough = Roughness(tolerance, noise, millimetre)
        likely = likely_numbers(numbers, clusters, items, rough)
        if likely is None and scaled:
            likely = round_numbers(numbers, clusters, items, rough)
        if likely is not None:
            variables.observed, moved = likely.numbers, likely.moved
            variables.weights = (likely.factors * variables.weights).tolist()
            numbers = solved(variables.observed, variables.weights, relations, far)
    values = {
        axis: tuple(sorted({float(numbers[column]) for column in clusters[axis]})) for axis in Axis
    }
    weights: dict[tuple[Axis, float], float] = {}
    for axis in Axis:
        for column in clusters[axis]:
            key = axis, float(numbers[column])
            weights[key] = weights.get(key, 0.0) + variables.weights[column]
    circles_out = tuple(
        (normal, Circle((float(numbers[x]), float(numbers[y])), float(numbers[radius])))
        for normal, x, y, radius in items
    )
    circle_weights = tuple(variables.weights[radius] for *_, radius in items)
    snap = Snapped(
        values, weights, circles_out, circle_weights, 2.0 * tolerance, step, nominal, moved
    )
    if stated is None or known is None:
        return snap
    unread = step is not None and _is_unread(step, numbers, known.drawn)
    places = constrained_places(
        (numbers, known.drawn), (clusters, items), (relations, known.kept), stated.digit
    )
    return replace(snap, begins=known.begins, unread=unread, places=places)


def _is_unread(step: NominalStep, numbers: Numbers, drawn: Numbers) -> bool:
    """Whether some numbers are multiples of a step that were not drawn as these."""
    pairs = [
        (step.multiple(float(a)), step.multiple(float(b)))
        for a, b in zip(numbers, drawn, strict=True)
    ]
    return any(value is not None and value != other for value, other in pairs)


def with_lone_values(snap: Snapped, readings: Sequence[CoordinateReading]) -> Snapped:
    """The values, and those that further readings tell where there are none yet.

    A countersink's slanted lines end at the extremes of its circles, and a drill's at its axis.
    Where a value is near, ends tell another one only if they agree about it in two planes.
    """
    values, weights, nominal, step = dict(snap.values), dict(snap.weights), snap.nominal, snap.step
    for axis in Axis:
        round_ones = _circle_values(snap, axis)
        this_readings = [reading for reading in readings if reading.axis is axis]
        lone = [reading for reading in this_readings if _is_lone(snap, reading, round_ones)]
        means = [_mean(cluster) for cluster in _clusters(lone, snap.reach)]
        means += [
            _mean(cluster)
            for cluster in _agreeing(snap, axis, this_readings)
            if cluster[0] not in lone
        ]
        means = [(nearest_value(round_ones, at, _AT_CIRCLE * snap.reach), w) for at, w in means]
        if step is not None:
            multiples = [step.multiple(at) for at, _ in means]
            nominal &= None not in multiples
            step = step.moving(at for at, _ in means)
            means = [
                (at if multiple is None else multiple, w)
                for multiple, (at, w) in zip(multiples, means, strict=True)
            ]
        values[axis] = tuple(sorted({*values[axis], *(value for value, _ in means)}))
        weights.update({(axis, value): weight for value, weight in means})
    return replace(snap, values=values, weights=weights, nominal=nominal, step=step)


def _agreeing(
    snap: Snapped, axis: Axis, readings: list[CoordinateReading]
) -> Iterator[list[CoordinateReading]]:
    """Readings of two planes that agree about a coordinate which no value is at."""
    for cluster in _clusters(readings, _AGREEING * snap.reach):
        at, _ = _mean(cluster)
        agree = cluster[-1].value - cluster[0].value <= _AGREEING * snap.reach
        planes = {reading.normal for reading in cluster}
        near = snap.value(axis, at, snap.reach / 2.0) is not None
        if agree and len(cluster) >= _FEWEST_AGREEING and len(planes) > 1 and not near:
            yield cluster


def _is_lone(snap: Snapped, reading: CoordinateReading, round_ones: Sequence[float]) -> bool:
    """Whether no value is near, or only one that is not the circle's which the reading is at."""
    value = snap.value(reading.axis, reading.value)
    if value is None:
        return True
    near = _AT_CIRCLE * snap.reach
    at = nearest_value(round_ones, reading.value, near)
    return at != reading.value and abs(value - at) > snap.reach / 2.0


def _circle_values(snap: Snapped, axis: Axis) -> list[float]:
    """Coordinates of the centres and extremes of circles."""
    return [
        circle.centre[IN_PLANE[normal].index(axis.value)] + side * circle.radius
        for normal, circle in snap.circles
        if normal is not axis
        for side in (-1.0, 0.0, 1.0)
    ]


def nearest_value(values: Sequence[float], value: float, near: float) -> float:
    """The nearest of some values, or the value itself if none is near."""
    found = min(values, key=lambda other: abs(other - value), default=value)
    return found if abs(found - value) <= near else value


class _Variables:
    """Numbers as they were read, and how much each reading counts."""

    def __init__(self) -> None:
        self.observed: list[float] = []
        self.weights: list[float] = []

    def add(self, observed: float, weight: float) -> int:
        self.observed.append(observed)
        self.weights.append(max(weight, 1e-3))
        return len(self.observed) - 1


def _clusters(readings: list[CoordinateReading], tolerance: float) -> list[list[CoordinateReading]]:
    clusters: list[list[CoordinateReading]] = []
    for reading in sorted(readings, key=lambda r: r.value):
        if clusters and reading.value - clusters[-1][-1].value <= tolerance:
            clusters[-1].append(reading)
        else:
            clusters.append([reading])
    return clusters


def _mean(cluster: list[CoordinateReading]) -> tuple[float, float]:
    total = sum(reading.weight for reading in cluster)
    if total <= 0.0:
        return cluster[0].value, 0.0
    return sum(reading.value * reading.weight for reading in cluster) / total, total


def _circle_distance(one: Circle, other: Circle) -> float:
    return max(
        abs(one.centre[0] - other.centre[0]),
        abs(one.centre[1] - other.centre[1]),
        abs(one.radius - other.radius),
    )


def _merged_circles(circles: Sequence[CircleReading], near: float) -> list[CircleReading]:
    """Distinct circles; of arcs on one circle the weightiest leads, the others are averaged in."""
    groups: list[list[CircleReading]] = []
    for reading in sorted(circles, key=lambda c: -c.weight):
        for group in groups:
            leader = group[0]
            same = leader.normal is reading.normal
            if same and _circle_distance(leader.circle, reading.circle) <= near:
                group.append(reading)
                break
        else:
            groups.append([reading])
    merged = []
    for group in groups:
        weights = np.array([reading.weight for reading in group])
        rows = np.array([(*r.circle.centre, r.circle.radius) for r in group])
        x, y, radius = (weights[:, None] * rows).sum(0) / weights.sum()
        circle = Circle((float(x), float(y)), float(radius))
        merged.append(CircleReading(group[0].normal, circle, float(weights.sum())))
    return merged


def _step(numbers: Numbers, tolerance: float, millimetre: float) -> NominalStep | None:
    """The step that the part was designed in, if the numbers tell one."""
    # What is shown twice is no further evidence.
    distinct = {round(float(number) / tolerance): float(number) for number in numbers}
    return nominal_step(list(distinct.values()), tolerance, millimetre)


def _rounded(
    weights: tuple[Sequence[float], Sequence[float]],
    numbers: Numbers,
    relations: Sequence[Linear],
    step: NominalStep,
    far: float,
) -> tuple[_Variables, Numbers, bool]:
    """The numbers as multiples of the step that the part was designed in, and whether all are
    known: those of circles between two multiples are.

    Their weights are what the sheet's numbers make of them, and as they were read: a multiple is as
    sure as others, told or not.  Weights that differ by more spoil the equations.
    """
    nominal = _Variables()
    multiples = [step.multiple(float(number)) for number in numbers]
    for number, multiple, stated, read in zip(numbers, multiples, *weights, strict=True):
        if multiple is None:
            nominal.add(float(number), stated)
        else:
            nominal.add(multiple, read * CERTAIN)
    rounded = solved(nominal.observed, nominal.weights, relations, far)
    known = all(
        multiple is not None or _follows(float(number), step.length)
        for multiple, number in zip(multiples, rounded, strict=True)
    )
    return nominal, rounded, known


def _follows(number: float, step: float) -> bool:
    """Whether a number is a multiple of a step, or halfway between two, because they make it so."""
    halves = 2.0 * number / step
    return abs(halves - round(halves)) <= 2.0 * 0.1 * ODD
