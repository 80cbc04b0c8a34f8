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
    for number, own in enumerate(operations, start=1):
        sheet = _APPLIED.get(own["op"], _unseen)(sheet, own, number)
    return sheet


def _kind(sheet: Sheet, own: dict, _: int) -> Sheet:
    name = own["target"]["id"]
    return _changed(sheet, lambda each: each.id == name, kind=own["to"], given=True)


def _erase(sheet: Sheet, own: dict, _: int) -> Sheet:
    name = own["target"]["id"]
    return replace(sheet, strokes=tuple(each for each in sheet.strokes if each.id != name))


def _draw(sheet: Sheet, own: dict, number: int) -> Sheet:
    drawn = Stroke(f"p{number}", own["view"], own["kind"], shape_in(own), given=True)
    return replace(sheet, strokes=(*sheet.strokes, drawn))


def _view(sheet: Sheet, own: dict, _: int) -> Sheet:
    box = own.get("box")
    known = next((each for each in sheet.views if each.id == own["id"]), None)
    if box is None and known is None:
        return sheet
    cut = known is not None and known.cut
    place = tuple(box) if box is not None else known.box
    made = View(own["id"], own["role"], place, cut=cut, given=True)
    rest = tuple(each for each in sheet.views if each.id != own["id"])
    return replace(sheet, views=(*rest, made))


def _region(sheet: Sheet, own: dict, _: int) -> Sheet:
    xs, ys = zip(*own["polygon"], strict=True)
    x0, y0, x1, y1 = min(xs), min(ys), max(xs), max(ys)

    def within(each: Stroke) -> bool:
        return all(x0 <= x <= x1 and y0 <= y <= y1 for x, y in each.points())

    return _changed(sheet, within, kind=own["kind"], given=True)


def _dimension(sheet: Sheet, own: dict, _: int) -> Sheet:
    return replace(
        sheet,
        numbers=tuple(
            replace(each, value=own["value_mm"], used=True, given=True)
            if each.id == own["id"]
            else each
            for each in sheet.numbers
        ),
    )


def _section(sheet: Sheet, own: dict, _: int) -> Sheet:
    box = next((each.box for each in sheet.views if each.id == own["id"]), None)
    rest = tuple(each for each in sheet.planes if each.box is None or each.box != box)
    label = next((each.label for each in sheet.planes if each.box == box), "")
    return replace(sheet, planes=(*rest, Plane(label, tuples(own["line"]), box, given=True)))


def _note(sheet: Sheet, own: dict, _: int) -> Sheet:
    x, y, radius = own["circle"]
    text = "THRU" if own.get("through") else f"\u21a7{own['depth_mm']:g}"
    made = Note(text, (x - radius, y - radius, x + radius, y + radius), (x, y, radius))
    rest = tuple(each for each in sheet.notes if each.circle != made.circle)
    return replace(sheet, notes=(*rest, made))


def _scale(sheet: Sheet, own: dict, _: int) -> Sheet:
    if own.get("axis") and own["axis"] == _unseen_axis(sheet):
        return sheet
    value = own.get("mm_per_px")
    if value is None and own.get("points"):
        (x0, y0), (x1, y1) = own["points"]
        value = own["length_mm"] / max(hypot(x1 - x0, y1 - y0), 1e-9)
    return replace(sheet, mm_per_px=value)


def _unseen_axis(sheet: Sheet) -> str:
    """The axis along which the only view looks; empty where there are several."""
    roles = [own.role for own in sheet.views if own.role in _LOOKS_ALONG]
    return _LOOKS_ALONG[roles[0]] if len(roles) == 1 else ""


def _unit(sheet: Sheet, own: dict, _: int) -> Sheet:
    if own["value"] == sheet.unit:
        return sheet
    factor = _MM_PER_INCH if own["value"] == "in" else 1.0 / _MM_PER_INCH
    numbers = tuple(replace(each, value=factor * each.value) for each in sheet.numbers)
    scale = None if sheet.mm_per_px is None else factor * sheet.mm_per_px
    return replace(sheet, unit=own["value"], numbers=numbers, mm_per_px=scale)


def _projection(sheet: Sheet, own: dict, _: int) -> Sheet:
    if own["value"] == sheet.projection:
        return sheet
    views = tuple(
        each if each.given else replace(each, role=_OPPOSITE.get(each.role, each.role))
        for each in sheet.views
    )
    return replace(sheet, projection=own["value"], views=views)


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
    strokes = tuple(replace(own, **values) if chosen(own) else own for own in sheet.strokes)
    return replace(sheet, strokes=strokes)
