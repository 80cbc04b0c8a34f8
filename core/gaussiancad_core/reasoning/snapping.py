"""One value for what is one: axis values and circles shared by the views.

A plane of the part that is parallel to an axis shows its coordinate in two views, a cylinder shows
its centre and radius as a circle in one view and as the values ``centre +- radius`` in two others.
The lines of the sheet tell each of these with a small error.  What lies together within a tolerance
is made equal, as a weighted least-squares problem with linear equations: values, centres and radii
move as little as possible, and tangencies hold exactly afterwards.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Axis
from gaussiancad_core.reasoning.curves import CircleCurve
from gaussiancad_core.reasoning.nominal import nominal_step, on_step
from gaussiancad_core.reasoning.planes import IN_PLANE

_TOO_SMALL = 4.0
"""Tolerances that a radius has at least for its extremes to be told from its centre."""

_EXACT = 0.02
"""Units of tolerance up to which readings are exact, and are not rounded."""

_CERTAIN = 1e6
"""Weight of a number that is known to be a multiple of the part's step."""

_FAR = 2.5
"""Tolerances by which anything moves at most; an equation that asks for more is dropped."""


@dataclass(frozen=True)
class Reading:
    """A coordinate as a view shows it.

    Attributes:
        axis: of the model.
        value: units.
        weight: how much it counts: the length of the line.
    """

    axis: Axis
    value: float
    weight: float


@dataclass(frozen=True)
class CircleReading:
    """A circle or arc as a view shows it.

    Attributes:
        normal: of the plane it lies in.
        circle: units.
        weight: how much it counts.
    """

    normal: Axis
    circle: CircleCurve
    weight: float


@dataclass(frozen=True)
class Snapped:
    """Values and circles of a part.

    Attributes:
        values: of each axis, ascending.
        weights: of the values.
        circles: distinct ones, with the normal of their plane.
        reach: how far a reading may lie from its value.
    """

    values: dict[Axis, tuple[float, ...]]
    weights: dict[tuple[Axis, float], float]
    circles: tuple[tuple[Axis, CircleCurve], ...]
    reach: float

    def value(self, axis: Axis, reading: float, reach: float | None = None) -> float | None:
        """The value nearest to a reading, if it is within reach."""
        values = self.values[axis]
        if not values:
            return None
        nearest = min(values, key=lambda value: abs(value - reading))
        within = self.reach if reach is None else reach
        return nearest if abs(nearest - reading) <= within else None

    def circle(self, normal: Axis, reading: CircleCurve) -> CircleCurve | None:
        """The circle that a reading is one of."""
        best: tuple[float, CircleCurve] | None = None
        for axis, circle in self.circles:
            off = _circle_distance(circle, reading)
            if axis is normal and off <= 2.0 * self.reach and (best is None or off < best[0]):
                best = off, circle
        return best[1] if best else None


def snapped(
    readings: Sequence[Reading], circles: Sequence[CircleReading], tolerance: float
) -> Snapped:
    """Make readings that belong together equal.

    Args:
        readings: of lines parallel to an axis.
        circles: of all planes.
        tolerance: units by which a reading may be off.
    """
    variables = _Variables()
    clusters = {
        axis: [
            variables.add(*_mean(cluster))
            for cluster in _clusters([r for r in readings if r.axis is axis], tolerance)
        ]
        for axis in Axis
    }
    merged = _merged_circles(circles, 2.0 * tolerance)
    own: list[tuple[Axis, int, int, int]] = []
    for reading in merged:
        (x, y), radius = reading.circle.centre, reading.circle.radius
        weight = reading.weight
        columns = (variables.add(number, weight) for number in (x, y, radius))
        own.append((reading.normal, *columns))
    relations = _relations(variables.observed, clusters, own, tolerance)
    solved = _solved(variables, relations, _FAR * tolerance)
    if tolerance > _EXACT:
        solved = _rounded(variables, solved, relations, tolerance)
    values = {
        axis: tuple(sorted({float(solved[column]) for column in clusters[axis]})) for axis in Axis
    }
    weights: dict[tuple[Axis, float], float] = {}
    for axis in Axis:
        for column in clusters[axis]:
            key = axis, float(solved[column])
            weights[key] = weights.get(key, 0.0) + variables.weights[column]
    circles_out = tuple(
        (normal, CircleCurve((float(solved[x]), float(solved[y])), float(solved[radius])))
        for normal, x, y, radius in own
    )
    return Snapped(values, weights, circles_out, 2.0 * tolerance)


class _Variables:
    """Numbers as they were read, and how much each reading counts."""

    def __init__(self) -> None:
        self.observed: list[float] = []
        self.weights: list[float] = []

    def add(self, observed: float, weight: float) -> int:
        self.observed.append(observed)
        self.weights.append(max(weight, 1e-3))
        return len(self.observed) - 1


def _clusters(readings: list[Reading], tolerance: float) -> list[list[Reading]]:
    clusters: list[list[Reading]] = []
    for reading in sorted(readings, key=lambda r: r.value):
        if clusters and reading.value - clusters[-1][-1].value <= tolerance:
            clusters[-1].append(reading)
        else:
            clusters.append([reading])
    return clusters


def _mean(cluster: list[Reading]) -> tuple[float, float]:
    total = sum(reading.weight for reading in cluster)
    if total <= 0.0:
        return cluster[0].value, 0.0
    return sum(reading.value * reading.weight for reading in cluster) / total, total


def _circle_distance(one: CircleCurve, other: CircleCurve) -> float:
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
        circle = CircleCurve((float(x), float(y)), float(radius))
        merged.append(CircleReading(group[0].normal, circle, float(weights.sum())))
    return merged


Relation = tuple[tuple[int, float], ...]
"""A linear equation: variables with factors, whose sum is to be zero."""


def _relations(
    observed: list[float],
    clusters: dict[Axis, list[int]],
    circles: list[tuple[Axis, int, int, int]],
    tolerance: float,
) -> list[Relation]:
    """Equations between what lies together."""
    relations: list[Relation] = []
    centres: dict[Axis, list[int]] = {axis: [] for axis in Axis}
    for normal, x, y, radius in circles:
        for index, centre in zip(IN_PLANE[normal], (x, y), strict=True):
            axis = Axis(index)
            own = [(centre, 1.0)]
            if observed[radius] > _TOO_SMALL * tolerance:
                low: list[tuple[int, float]] = [(centre, 1.0), (radius, -1.0)]
                high: list[tuple[int, float]] = [(centre, 1.0), (radius, 1.0)]
                candidates = (own, low, high)
            else:
                candidates = (own,)
            for terms in candidates:
                at = sum(factor * observed[column] for column, factor in terms)
                for value in clusters[axis]:
                    if abs(observed[value] - at) <= tolerance:
                        relations.append((*terms, (value, -1.0)))
            for other in centres[axis]:
                if abs(observed[other] - observed[centre]) <= tolerance:
                    relations.append(((centre, 1.0), (other, -1.0)))
                    break
            else:
                centres[axis].append(centre)
    return relations


def _rounded(
    variables: _Variables,
    solved: npt.NDArray[np.float64],
    relations: list[Relation],
    tolerance: float,
) -> npt.NDArray[np.float64]:
    """The numbers as multiples of the step that the part was designed in, if they tell one."""
    # What is shown twice is no further evidence.
    distinct = {round(float(number) / tolerance): float(number) for number in solved}
    step = nominal_step(list(distinct.values()), tolerance)
    if step is None:
        return solved
    nominal = _Variables()
    for number, weight in zip(solved, variables.weights, strict=True):
        multiple = on_step(float(number), step, tolerance)
        if multiple is None:
            nominal.add(float(number), weight)
        else:
            nominal.add(multiple, weight * _CERTAIN)
    return _solved(nominal, relations, _FAR * tolerance)


def _solved(
    variables: _Variables, relations: list[Relation], far: float
) -> npt.NDArray[np.float64]:
    """The numbers nearest to the readings that fulfil the relations.

    Relations that would move something by more than ``far`` are dropped, worst first.
    """
    observed = np.array(variables.observed, dtype=np.float64)
    spread = 1.0 / np.array(variables.weights, dtype=np.float64)
    kept = list(relations)
    while kept:
        rows = np.zeros((len(kept), len(observed)))
        for row, relation in enumerate(kept):
            for column, factor in relation:
                rows[row, column] += factor
        residual = rows @ observed
        gram = (rows * spread) @ rows.T
        multipliers = np.linalg.lstsq(gram, residual, rcond=1e-12)[0]
        moved = spread * (rows.T @ multipliers)
        worst = int(np.argmax(np.abs(moved)))
        if abs(moved[worst]) <= far:
            return observed - moved
        involved = [row for row in range(len(kept)) if rows[row, worst] != 0.0]
        del kept[max(involved, key=lambda row: abs(residual[row]))]
    return observed
