"""The JSON schemas of the tools' arguments, short and with words on each correction."""

from collections.abc import Mapping
from typing import Any

import msgspec

_BOUNDS = ("minimum", "maximum", "exclusiveMinimum")

_PREFIX = "#/$defs/"

_OPERATIONS: Mapping[str, tuple[str, dict[str, Any]]] = {
    "ViewOperation": (
        "A view has this role (`ignore` takes it off). With `box` all lines in it are the view's; "
        "a new id with a box is a new view, read from the ink.",
        {"op": "view", "id": "v9", "role": "top", "box": [420, 80, 1030, 460]},
    ),
    "KindOperation": (
        "A stroke stands for something else. Its present kind settles a doubt of it.",
        {"op": "kind", "target": {"id": "s12"}, "to": "hidden"},
    ),
    "EraseOperation": ("There is no such stroke.", {"op": "erase", "target": {"id": "s12"}}),
    "DrawOperation": (
        "There is one more stroke: one of line, arc and ellipse. Its ends lie on other strokes'.",
        {"op": "draw", "view": "top", "kind": "visible", "line": [[20, 300], [180, 300]]},
    ),
    "DimensionOperation": (
        "A number gives another length, or measures something else.",
        {"op": "dimension", "id": "d2", "value_mm": 42.5},
    ),
    "ScaleOperation": (
        "The scale: one of `axis` with `length_mm` (the part's extent), `points` with `length_mm` "
        "(their distance), and `mm_per_px`.",
        {"op": "scale", "axis": "x", "length_mm": 60},
    ),
    "UnitOperation": ("The unit of numbers without one.", {"op": "unit", "value": "in"}),
    "ProjectionOperation": (
        "First or third angle.",
        {"op": "projection", "value": "first"},
    ),
    "TangentEdgesOperation": (
        "Lines where faces meet smoothly are drawn as edges are, thin, or left out.",
        {"op": "tangent_edges", "value": "left-out"},
    ),
    "RegionOperation": (
        "All strokes within a polygon are of a kind; `ignore` takes them off.",
        {"op": "region", "polygon": [[0, 0], [300, 0], [300, 90]], "kind": "ignore"},
    ),
    "TraceOperation": (
        "The line in the ink at a place is a stroke of a view that was not read.",
        {"op": "trace", "view": "top", "at": [512, 300], "kind": "visible"},
    ),
    "SectionOperation": (
        "The section `id` is cut along a line in another view: two ends, or the corners of steps.",
        {"op": "section", "id": "v3", "in_view": "top", "line": [[20, 90], [400, 90]]},
    ),
    "NoteOperation": (
        "The hole of a circle (centre x, y, radius) goes `through`, or is `depth_mm` deep.",
        {"op": "note", "circle": [512, 300, 40], "through": True},
    ),
}
"""Type of an operation -> what it says, and an example."""

_PLACES: Mapping[str, str] = {
    "box": "x0, y0, x1, y1 in px of the sheet, y down.",
    "line": "Its two ends, [[x, y], [x, y]] in px of the sheet, y down.",
    "arc": "Centre x, y, radius in px; start, sweep in radians from x towards y (down).",
    "ellipse": "Centre x, y, semi-axes (larger first) in px; rotation, start, sweep in radians.",
    "polygon": "Its corners, px of the sheet.",
    "points": "Two places, px of the sheet.",
    "at": "x, y in px of the sheet.",
    "circle": "Centre x, y and radius in px of the sheet.",
    "id": "As `read` or `look` name it.",
    "view": "Id of the view.",
    "target": "A stroke by its id; with its shape it is found by its place, too.",
}
"""Attribute of an operation -> what it is."""

_NAMED = frozenset({*_OPERATIONS, "Target", "Measured"})


def input_schema(kind: type) -> dict[str, Any]:
    """The JSON schema of a tool's arguments, an object.

    Args:
        kind: of the arguments.
    """
    (root,), parts = msgspec.json.schema_components([kind], ref_template=_PREFIX + "{name}")
    name = str(root["$ref"]).removeprefix(_PREFIX)
    found: dict[str, Any] = _short(parts.pop(name), parts)
    used = {
        part: _described(part, _short(parts[part], parts)) for part in sorted(_NAMED & set(parts))
    }
    found.pop("title", None)
    found.pop("description", None)
    return {**found, "$defs": used} if used else found


def _described(part: str, schema: dict[str, Any]) -> dict[str, Any]:
    """The schema of an operation, with words on it and on its attributes."""
    properties = {
        name: {"description": _PLACES[name], **attribute} if name in _PLACES else attribute
        for name, attribute in schema["properties"].items()
    }
    schema = {**schema, "properties": properties}
    schema.pop("title", None)
    if part in _OPERATIONS:
        words, example = _OPERATIONS[part]
        schema |= {"description": words, "examples": [example]}
    return schema


def _short(schema: Any, parts: Mapping[str, Any]) -> Any:  # noqa: ANN401
    """A schema without what nobody needs: null, bounds of numbers, references to enums."""
    if isinstance(schema, list):
        return [_short(entry, parts) for entry in schema]
    if not isinstance(schema, dict):
        return schema
    part = str(schema.get("$ref", "")).removeprefix(_PREFIX)
    if part and part not in _NAMED:
        return {"enum": parts[part]["enum"]}
    found = {
        name: _short(value, parts)
        for name, value in schema.items()
        if name not in ("discriminator", "maxLength")
        and not (name in _BOUNDS and schema["type"] == "number")
        and not (name == "default" and value is None)
    }
    if "prefixItems" in found:
        # All alike: clients of older drafts know no prefixItems.
        found["items"] = found.pop("prefixItems")[0]
    kinds = [kind for kind in found.get("anyOf", ()) if kind != {"type": "null"}]
    if len(kinds) == 1 and len(found["anyOf"]) > 1:
        del found["anyOf"]
        found |= kinds[0]
    return found
