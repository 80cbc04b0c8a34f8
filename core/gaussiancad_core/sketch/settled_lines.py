"""Lines of a plane, moved to the places that all views agree on."""

from dataclasses import replace
from math import copysign

from gaussiancad_core.coordinates.agreed_places import Places
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.sketch.plane_lines import PlaneLine, arc_between, whole_circle


def settled(line: PlaneLine, places: Places, normal: Axis) -> PlaneLine:
    """A line of the plane across an axis at its place."""
    if line.circle is not None:
        circle = places.circle(line.circle, normal)
        if line.is_closed:
            return whole_circle(circle, line.is_visible, line.stroke)
        points = arc_between(circle, (line.points[0], line.points[-1]), _sweep(line))
        return replace(line, points=points, circle=circle)
    return replace(line, points=places.placed(line.points, normal)) if line.is_straight else line


def _sweep(line: PlaneLine) -> float:
    """Radians that an arc turns, negative from the second axis to the first."""
    (x, y), ((a, b), (c, d)) = line.arc.centre, line.points[:2].tolist()
    way = (a - x) * (d - y) - (b - y) * (c - x)
    return copysign(line.length / line.arc.radius, way)
