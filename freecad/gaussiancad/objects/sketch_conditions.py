"""The conditions of a sketch in a ``features.json`` as constraints of FreeCAD's sketcher."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import radians

import FreeCAD
import Sketcher

from freecad.gaussiancad.objects.body_model import Condition, Curve, Point

_X_AXIS, _Y_AXIS = -1, -2
"""FreeCAD's numbers of a sketch's axes."""

_POINTS = {"start": 1, "end": 2, "centre": 3}
"""FreeCAD's numbers of a curve's points."""

_SAME_MM = 1e-5
"""How far a curve may be moved by the numbers of its conditions."""

_MOST_DROPPED = 20
"""Constraints of a sketch that are left out before it is given up: each is searched for."""


@dataclass(frozen=True)
class _Form:
    """How a kind of condition is written.

    Attributes:
        name: of the constraint.
        trailing: what follows the condition's own curves and points.
        axis: 0 or 1 of a distance along x or y, whose order of points gives its sign.
        is_angle: whether the value is in degrees.
    """

    name: str
    trailing: tuple[int, ...] = ()
    axis: int | None = None
    is_angle: bool = False


_FORMS = {
    "coincident": _Form("Coincident"),
    "tangent": _Form("Tangent"),
    "perpendicular": _Form("Perpendicular"),
    "parallel": _Form("Parallel"),
    "horizontal": _Form("Horizontal"),
    "vertical": _Form("Vertical"),
    "equal": _Form("Equal"),
    "symmetric": _Form("Symmetric"),
    "block": _Form("Block"),
    "distance": _Form("Distance"),
    "distance-x": _Form("DistanceX", axis=0),
    "distance-y": _Form("DistanceY", axis=1),
    "radius": _Form("Radius"),
    "diameter": _Form("Diameter"),
    "angle": _Form("Angle", is_angle=True),
    "point-on": _Form("PointOnObject"),
    "point-on-x-axis": _Form("PointOnObject", (_X_AXIS,)),
    "point-on-y-axis": _Form("PointOnObject", (_Y_AXIS,)),
}


def constrain(
    sketch: FreeCAD.DocumentObject, curves: Sequence[Curve], conditions: Sequence[Condition]
) -> tuple[Condition, ...]:
    """Constrain the curves of a sketch.

    What says nothing new after those before it, contradicts them or moves a curve is left out.
    Where there is too much of that, or there are no conditions, the curves are fixed as they are.

    Args:
        sketch: has the curves as its only geometry, clockwise arcs from their end to their start.
        curves: the same curves.
        conditions: between them, the most important ones first.

    Returns:
        The conditions that hold.

    Raises:
        ValueError: a condition is of a kind that nobody knows, or a name is given twice.
    """
    constraints = [_constraint(condition, curves) for condition in conditions]
    kept = list(range(len(constraints)))
    drawn, certain = sketch.Geometry, 0
    while kept and not _hold(sketch, drawn, [constraints[number] for number in kept]):
        if len(constraints) - len(kept) == _MOST_DROPPED:
            kept = []
            break
        holds, fails = certain, len(kept)
        while fails - holds > 1:
            middle = (holds + fails) // 2
            if _hold(sketch, drawn, [constraints[number] for number in kept[:middle]]):
                holds = middle
            else:
                fails = middle
        del kept[fails - 1]
        certain = holds
    if not kept:
        _clear(sketch, drawn)
        fix(sketch, range(len(curves)))
    for place, number in enumerate(kept):
        if conditions[number].name:
            sketch.renameConstraint(place, conditions[number].name)
    return tuple(conditions[number] for number in kept)


def _hold(
    sketch: FreeCAD.DocumentObject, drawn: Sequence[object], constraints: Sequence[object]
) -> bool:
    """Put constraints into a sketch in place of others; whether all can hold where it is drawn."""
    _clear(sketch, drawn)
    sketch.addConstraint(list(constraints))
    if sketch.solve() != 0:
        return False
    pairs = zip(_numbers(drawn), _numbers(sketch.Geometry), strict=True)
    return all(abs(before - after) <= _SAME_MM for before, after in pairs)


def _clear(sketch: FreeCAD.DocumentObject, drawn: Sequence[object]) -> None:
    sketch.Constraints = []
    sketch.Geometry = list(drawn)


def _numbers(curves: Sequence[object]) -> Iterator[float]:
    """What tells where curves are, mm."""
    for curve in curves:
        for name in ("StartPoint", "EndPoint", "Center"):
            if hasattr(curve, name):
                yield from getattr(curve, name)
        if hasattr(curve, "Radius"):
            yield curve.Radius


def fix(sketch: FreeCAD.DocumentObject, numbers: Sequence[int]) -> None:
    """Have curves of a sketch stay where they are."""
    sketch.addConstraint([Sketcher.Constraint("Block", number) for number in numbers])


def _constraint(condition: Condition, curves: Sequence[Curve]) -> object:
    form = _FORMS.get(condition.kind)
    if form is None:
        raise ValueError(f"a constraint {condition.kind}")
    value, places = condition.value, condition.of
    if form.axis is not None and value is not None:
        if len(places) == 1 and not places[0][1]:
            places = ((places[0][0], "start"), (places[0][0], "end"))
        if len(places) == 2:
            first, second = (_place(place, curves)[form.axis] for place in places)
            # FreeCAD counts from the first point to the second one.
            places, value = (places if second >= first else places[::-1]), abs(value)
    numbers = [number for place in places for number in reference(place, curves)]
    numbers.extend(form.trailing)
    if value is None:
        return Sketcher.Constraint(form.name, *numbers)
    return Sketcher.Constraint(form.name, *numbers, radians(value) if form.is_angle else value)


def reference(place: tuple[int, str], curves: Sequence[Curve]) -> tuple[int, ...]:
    """FreeCAD's numbers of a curve, or of a point on it; its arcs run counterclockwise."""
    number, point = place
    if not point:
        return (number,)
    if number >= 0 and not curves[number].counterclockwise and point != "centre":
        point = "end" if point == "start" else "start"
    return number, _POINTS[point]


def _place(place: tuple[int, str], curves: Sequence[Curve]) -> Point:
    number, point = place
    return (0.0, 0.0) if number < 0 else getattr(curves[number], point or "centre")
