"""What a person sees of corrections at once; the engine corrects a reading when it solves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import hypot

from freecad.gaussiancad.canvas.sheet import Note, Plane, Sheet, Stroke, View, shape_in, tuples

_MM_PER_INCH = 25.4
_LOOKS_ALONG = {
    **dict.fromkeys(("front", "rear"), "y"),
    **dict.fromkeys(("top", "bottom"), "z"),
    **dict.fromkeys(("left", "right"), "x"),
}
_OPPOSITE = {"top": "bottom", "bottom": "top", "left": "right", "right": "left"}


def corrected(sheet: Sheet, operations: list[dict]) -> Sheet:
    """A sheet after corrections, one after another."""
    for number, operation in enumerate(operations, start=1):
        sheet = _APPLIED.get(operation["op"], _unseen)(sheet, operation, number)
    return sheet


def _kind(sheet: Sheet, item: dict, _: int) -> Sheet:
    name = item["target"]["id"]
    return _changed(sheet, lambda each: each.id == name, kind=item["to"], given=True)


def _erase(sheet: Sheet, item: dict, _: int) -> Sheet:
    name = item["target"]["id"]
    return replace(sheet, strokes=tuple(each for each in sheet.strokes if each.id != name))


def _draw(sheet: Sheet, item: dict, number: int) -> Sheet:
    drawn = Stroke(f"p{number}", item["view"], item["kind"], shape_in(item), given=True)
    return replace(sheet, strokes=(*sheet.strokes, drawn))


def _view(sheet: Sheet, item: dict, _: int) -> Sheet:
    box = item.get("box")
    known = next((each for each in sheet.views if each.id == item["id"]), None)
    if box is None and known is None:
        return sheet
    cut = known is not None and known.cut
    place = tuple(box) if box is not None else known.box
    made = View(item["id"], item["role"], place, cut=cut, given=True)
    rest = tuple(each for each in sheet.views if each.id != item["id"])
    return replace(sheet, views=(*rest, made))


def _region(sheet: Sheet, item: dict, _: int) -> Sheet:
    xs, ys = zip(*item["polygon"], strict=True)
    x0, y0, x1, y1 = min(xs), min(ys), max(xs), max(ys)

    def within(each: Stroke) -> bool:
        return all(x0 <= x <= x1 and y0 <= y <= y1 for x, y in each.points())

    return _changed(sheet, within, kind=item["kind"], given=True)


def _dimension(sheet: Sheet, item: dict, _: int) -> Sheet:
    return replace(
        sheet,
        numbers=tuple(
            replace(each, value=item["value_mm"], used=True, given=True)
            if each.id == item["id"]
            else each
            for each in sheet.numbers
        ),
    )


def _section(sheet: Sheet, item: dict, _: int) -> Sheet:
    box = next((each.box for each in sheet.views if each.id == item["id"]), None)
    rest = tuple(each for each in sheet.planes if each.box is None or each.box != box)
    label = next((each.label for each in sheet.planes if each.box == box), "")
    return replace(sheet, planes=(*rest, Plane(label, tuples(item["line"]), box, given=True)))


def _note(sheet: Sheet, item: dict, _: int) -> Sheet:
    x, y, radius = item["circle"]
    text = "THRU" if item.get("through") else f"\u21a7{item['depth_mm']:g}"
    made = Note(text, (x - radius, y - radius, x + radius, y + radius), (x, y, radius))
    rest = tuple(each for each in sheet.notes if each.circle != made.circle)
    return replace(sheet, notes=(*rest, made))


def _scale(sheet: Sheet, item: dict, _: int) -> Sheet:
    if item.get("axis") and item["axis"] == _unseen_axis(sheet):
        return sheet
    value = item.get("mm_per_px")
    if value is None and item.get("points"):
        (x0, y0), (x1, y1) = item["points"]
        value = item["length_mm"] / max(hypot(x1 - x0, y1 - y0), 1e-9)
    return replace(sheet, mm_per_px=value)


def _unseen_axis(sheet: Sheet) -> str:
    """The axis along which the only view looks; empty where there are several."""
    roles = [view.role for view in sheet.views if view.role in _LOOKS_ALONG]
    return _LOOKS_ALONG[roles[0]] if len(roles) == 1 else ""


def _unit(sheet: Sheet, item: dict, _: int) -> Sheet:
    if item["value"] == sheet.unit:
        return sheet
    factor = _MM_PER_INCH if item["value"] == "in" else 1.0 / _MM_PER_INCH
    numbers = tuple(replace(each, value=factor * each.value) for each in sheet.numbers)
    scale = None if sheet.mm_per_px is None else factor * sheet.mm_per_px
    return replace(sheet, unit=item["value"], numbers=numbers, mm_per_px=scale)


def _projection(sheet: Sheet, item: dict, _: int) -> Sheet:
    if item["value"] == sheet.projection:
        return sheet
    views = tuple(
        each if each.given else replace(each, role=_OPPOSITE.get(each.role, each.role))
        for each in sheet.views
    )
    return replace(sheet, projection=item["value"], views=views)


def _unseen(sheet: Sheet, _own: dict, _number: int) -> Sheet:
    """What changes nothing that is shown."""
    return sheet


_APPLIED: dict[str, Callable[[Sheet, dict, int], Sheet]] = {
    "kind": _kind,
    "erase": _erase,
    "draw": _draw,
    "view": _view,
    "region": _region,
    "dimension": _dimension,
    "section": _section,
    "note": _note,
    "scale": _scale,
    "unit": _unit,
    "projection": _projection,
}


def _changed(sheet: Sheet, chosen: Callable[[Stroke], bool], **values: object) -> Sheet:
    strokes = tuple(
        replace(stroke, **values) if chosen(stroke) else stroke for stroke in sheet.strokes
    )
    return replace(sheet, strokes=strokes)
