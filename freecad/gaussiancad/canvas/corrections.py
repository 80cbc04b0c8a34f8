"""What a correction says: the operations of ``corrections.json`` that stand for it."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain

from freecad.gaussiancad.canvas.handles import corners_of
from freecad.gaussiancad.canvas.sheet import Box, Number, Point, Shape, Sheet, Stroke, View

Circle = tuple[float, float, float]
"""Centre and radius, px of the sheet."""


def set_kind(strokes: Iterable[Stroke], kind: str) -> list[dict]:
    """Strokes stand for a kind."""
    return [{"op": "kind", "target": stroke.target(), "to": kind} for stroke in strokes]


def erase_strokes(strokes: Iterable[Stroke]) -> list[dict]:
    """Strokes are not there."""
    return [{"op": "erase", "target": stroke.target()} for stroke in strokes]


def draw_stroke(view: str | None, kind: str, shape: Shape) -> list[dict]:
    """There is a stroke in a view."""
    name, numbers = shape
    return [{"op": "draw", "view": view, "kind": kind, name: numbers}]


def move_stroke(stroke: Stroke, shape: Shape) -> list[dict]:
    """A stroke runs elsewhere."""
    return [*erase_strokes([stroke]), *draw_stroke(stroke.view, stroke.kind, shape)]


def set_role(view: View, role: str) -> list[dict]:
    """A view shows something else."""
    return [{"op": "view", "id": view.id, "role": role}]


def set_box(view: View, box: Box) -> list[dict]:
    """A view is where a box is."""
    return [{"op": "view", "id": view.id, "role": view.role, "box": list(box)}]


def add_view(sheet: Sheet | None, role: str, box: Box) -> list[dict]:
    """A box is the view of a role: the one that the sheet has already, there or elsewhere, or a
    new one."""
    known = sheet.views if sheet is not None else ()
    there = (item.id for item in known if item.shown and _is_same(item.box, box))
    set_role = (item.id for item in known if item.role == role)
    return [
        {"op": "view", "id": next(chain(there, set_role), role), "role": role, "box": list(box)}
    ]


def _is_same(one: Box, other: Box) -> bool:
    """Whether each of two boxes has the other's middle: they are drawn around the same lines."""
    middles = [((x0 + x1) / 2.0, (y0 + y1) / 2.0) for x0, y0, x1, y1 in (one, other)]
    return all(
        x0 <= x <= x1 and y0 <= y <= y1
        for (x0, y0, x1, y1), (x, y) in zip((other, one), middles, strict=True)
    )


def ignore_area(box: Box) -> list[dict]:
    """Nothing in a box is of the drawing."""
    return [{"op": "region", "polygon": corners_of(box), "kind": "ignore"}]


def set_distance(points: tuple[Point, Point], length: float) -> list[dict]:
    """Two points are so many mm apart."""
    return [{"op": "scale", "points": [list(point) for point in points], "length_mm": length}]


def set_thickness(axis: str, thickness: float) -> list[dict]:
    """The part is so many mm thick along an axis that no view shows."""
    return [{"op": "scale", "axis": axis, "length_mm": thickness}]


def set_value(number: Number, value_mm: float) -> list[dict]:
    """A dimension gives so many mm."""
    return [{"op": "dimension", "id": number.id, "value_mm": value_mm}]


def set_section(view: str, line: tuple[Point, ...], in_view: str) -> list[dict]:
    """A view shows the section along a line in another view."""
    stated = [list(item) for item in line]
    return [{"op": "section", "id": view, "in_view": in_view, "line": stated}]


def set_hole(circle: Circle, depth_mm: float | None) -> list[dict]:
    """The hole of a circle is so deep; None for one that goes through."""
    stated = {"through": True} if depth_mm is None else {"depth_mm": depth_mm}
    return [{"op": "note", "circle": list(circle), **stated}]


def set_option(name: str, value: str) -> list[dict]:
    """The whole sheet's ``projection`` or ``unit``."""
    return [{"op": name, "value": value}]
