"""Names of a sketch's dimensions: what an engineer would call them, as far as that is certain."""

from collections import Counter
from collections.abc import Iterable, Sequence

from gaussiancad_core.features.constraints import Constraint, Kind
from gaussiancad_core.features.sketch_geometry import ORIGIN, Reference, Spot
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.tolerances import COMPUTED

_ROUND = {Kind.RADIUS: "Radius", Kind.DIAMETER: "Diameter"}

_WHOLE = {Kind.DISTANCE_X: "Width", Kind.DISTANCE_Y: "Height"}
"""What spans all of a sketch."""

_AXES = {Kind.DISTANCE_X: (0, "X"), Kind.DISTANCE_Y: (1, "Y")}


def dimension_names(found: Sequence[Constraint], edges: Sequence[OutlineEdge]) -> list[str | None]:
    """A name for each constraint that has a value, its own in the sketch; None for others.

    ``Width`` and ``Height`` span the whole sketch, ``OffsetX`` and ``OffsetY`` lead to it from an
    origin that lies apart, ``DistanceX`` and ``DistanceY`` are other distances.  What there is
    several times has a number.

    Args:
        found: constraints of the sketch.
        edges: its elements, mm.
    """
    stems = [None if each.value is None else _stem(each, edges) for each in found]
    counts = Counter(stems)
    used: Counter[str] = Counter()
    names: list[str | None] = []
    for stem in stems:
        if stem is None or counts[stem] == 1:
            names.append(stem)
            continue
        used[stem] += 1
        names.append(f"{stem}{used[stem]}")
    return names


def _stem(constraint: Constraint, edges: Sequence[OutlineEdge]) -> str:
    if constraint.kind in _ROUND:
        return _ROUND[constraint.kind]
    axis, letter = _AXES[constraint.kind]
    ends = sorted(_place(each, edges)[axis] for each in constraint.of)
    low, high = _extent(edges, axis)
    if abs(ends[0] - low) < COMPUTED and abs(ends[-1] - high) < COMPUTED:
        return _WHOLE[constraint.kind]
    is_apart = ORIGIN in constraint.of and not _has_point(edges, axis, 0.0)
    return f"{'Offset' if is_apart else 'Distance'}{letter}"


def _place(reference: Reference, edges: Sequence[OutlineEdge]) -> tuple[float, float]:
    if reference == ORIGIN:
        return 0.0, 0.0
    edge = edges[reference.element]
    if reference.spot is Spot.CENTRE and edge.circle is not None:
        return edge.circle.centre
    return edge.end if reference.spot is Spot.END else edge.start


def _extent(edges: Iterable[OutlineEdge], axis: int) -> tuple[float, float]:
    """Where a sketch begins and ends along an axis, or a little outside of that: whole circles
    stand for arcs."""
    values: list[float] = []
    for edge in edges:
        if edge.circle is not None:
            middle, radius = edge.circle.centre[axis], edge.circle.radius
            values += [middle - radius, middle + radius]
        if not edge.is_circle:
            values += [edge.start[axis], edge.end[axis]]
    return min(values), max(values)


def _has_point(edges: Iterable[OutlineEdge], axis: int, value: float) -> bool:
    """Whether an end or a centre lies at a coordinate."""
    for edge in edges:
        places = [] if edge.is_circle else [edge.start, edge.end]
        places += [] if edge.circle is None else [edge.circle.centre]
        if any(abs(place[axis] - value) < COMPUTED for place in places):
            return True
    return False
