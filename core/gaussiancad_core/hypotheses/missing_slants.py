"""Slanted lines that a view may lack: two others show the edge, or the other side of a cone it."""

from collections.abc import Iterator, Sequence
from itertools import islice

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle, Line, line_through
from gaussiancad_core.hypotheses.suppressed_slants import EDGES, MOST_LOST, shows, slanted_edges
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE, UNITS


def missing_slants(
    carriers: PartCarriers, corners: Sequence[Point], normal: Axis, near: float
) -> Iterator[tuple[Line, float, float]]:
    """Slanted lines of a plane between corners that are drawn there.

    Args:
        carriers: of all planes.
        corners: of the plane.
        normal: of the plane.
        near: units within which coordinates are one.
    """
    plane = carriers.planes[normal]
    stated = [
        *_mirrored(carriers, normal),
        *islice(slanted_edges(carriers, normal, UNITS), EDGES),
    ]
    found: list[tuple[Point, Point]] = []
    for start, end in stated:
        flat = min(abs(a - b) for a, b in zip(start, end, strict=True)) <= near
        first, last = (_corner(corners, point, near) for point in (start, end))
        if flat or first is None or last is None or first == last:
            continue
        edge = min(first, last), max(first, last)
        if edge not in found and not any(shows(carrier, *edge, near) for carrier in plane.carriers):
            found.append(edge)
    for start, end in found[:MOST_LOST]:
        line = line_through(start, end)
        low, high = sorted((line.parameter(start), line.parameter(end)))
        yield line, low, high


def _corner(corners: Sequence[Point], point: Point, near: float) -> Point | None:
    """The corner at a point."""
    for corner in corners:
        if abs(corner[0] - point[0]) <= near and abs(corner[1] - point[1]) <= near:
            return corner
    return None


def _mirrored(carriers: PartCarriers, normal: Axis) -> Iterator[tuple[Point, Point]]:
    """Slanted lines of a plane on the other side of the axes of circles."""
    plane = carriers.planes[normal]
    slanted = [
        (carrier.curve.at(low), carrier.curve.at(high))
        for carrier in plane.carriers
        if isinstance(carrier.curve, Line) and carrier.curve.axis is None
        for low, high in carrier.drawn()
    ]
    for coordinate, index in enumerate(IN_PLANE[normal]):
        along = Axis(IN_PLANE[normal][1 - coordinate])
        for centre in sorted(_centres(carriers.planes[along], Axis(index))):
            for ends in slanted:
                start, end = (_across(point, coordinate, centre) for point in ends)
                yield start, end


def _centres(plane: PlaneCarriers, axis: Axis) -> set[float]:
    """Coordinates of the centres of circles."""
    place = IN_PLANE[plane.normal].index(axis.value)
    circles = (s.curve for s in plane.carriers if isinstance(s.curve, Circle))
    return {round(circle.centre[place], 6) for circle in circles}


def _across(point: Point, coordinate: int, centre: float) -> Point:
    x, y = point
    return (2.0 * centre - x, y) if coordinate == 0 else (x, 2.0 * centre - y)
