"""A reading as an agent sees it: short, with what is in doubt and what may help."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gaussiancad import Reading
from gaussiancad_core.report.pointing import length
from gaussiancad_protocol.reading_kinds import DOUBT

_MOST_ENTRIES = 20
"""Dimensions, notes, sections, problems or doubtful strokes that one summary lists."""

_DIGITS = 1
"""Of px: as many as a place can be pointed at with."""

_LENGTHS = {5: 3, 7: 4}
"""Numbers that an arc or an ellipse has -> those that are px; the others are angles."""

Values = Mapping[str, Any]


def reading_summary(reading: Reading) -> dict[str, Any]:
    """What was read, in a few kilobytes however much it is."""
    data = reading.data
    strokes = data.get("strokes", ())
    views = data.get("views", ())
    outside = [stroke for stroke in strokes if stroke.get("view") is None]
    return {
        "page": reading.page,
        "size_px": data["sheet"].get("size"),
        "projection": data["projection"],
        "unit": data["unit"],
        "scale": data["scale"],
        **_listed("views", [_view(view, strokes) for view in views]),
        "strokes_outside_views": _kinds(outside),
        **_listed("dimensions", [_dimension(entry) for entry in data.get("dimensions", ())]),
        **_listed("notes", [_note(entry) for entry in data.get("notes", ())]),
        **_listed("sections", [_section(entry) for entry in data.get("sections", ())]),
        **_listed("problems", [_problem(entry, data) for entry in data.get("problems", ())]),
        **_listed("doubtful_strokes", list(_doubtful(views, strokes))),
        "corrections": data.get("corrected", 0),
    }


def stroke_entry(stroke: Values) -> dict[str, Any]:
    """A stroke as an agent sees it."""
    why = stroke.get("why") or {}
    shape = {
        name: rounded(stroke[name])
        for name in ("line", "arc", "ellipse", "box")
        if stroke.get(name) is not None
    }
    found = {"id": stroke["id"], "view": stroke.get("view"), "kind": stroke["kind"], **shape}
    found["confidence"] = round(float(stroke.get("confidence", 1.0)), 2)
    if why.get("otherwise"):
        found["otherwise"] = why["otherwise"]
    if why.get("by"):
        found["by"] = why["by"]
    if stroke.get("source") == "given":
        found["source"] = "given"
    return found


def rounded(value: Any) -> Any:  # noqa: ANN401
    """Numbers of a shape: px with as many digits as serve, angles with more."""
    if isinstance(value, list | tuple):
        lengths = _LENGTHS.get(len(value), len(value))
        return [rounded(entry) for entry in value[:lengths]] + [
            round(float(angle), 4) for angle in value[lengths:]
        ]
    return round(float(value), _DIGITS)


def _listed(name: str, entries: Sequence[Any]) -> dict[str, Any]:
    """The first of some entries, and how many there are besides."""
    more = {f"more_{name}": len(entries) - _MOST_ENTRIES} if len(entries) > _MOST_ENTRIES else {}
    return {name: list(entries[:_MOST_ENTRIES]), **more}


def _kinds(strokes: Sequence[Values]) -> dict[str, int]:
    return dict(Counter(str(stroke["kind"]) for stroke in strokes).most_common())


def _view(view: Values, strokes: Sequence[Values]) -> dict[str, Any]:
    inside = [stroke for stroke in strokes if stroke.get("view") == view["id"]]
    found = {
        "id": view["id"],
        "role": view["role"],
        "box": rounded(view["box"]),
        "strokes": _kinds(inside),
    }
    if not view.get("used", True):
        found["used"] = False
        found["what"] = view.get("kind") or view["role"]
    return found


def _dimension(entry: Values) -> dict[str, Any]:
    return {
        "id": entry["id"],
        "text": entry["text"],
        "value_mm": entry["value_mm"],
        "box": rounded(entry["box"]),
        "type": entry.get("type", "linear"),
        "scale_rests_on_it": bool(entry.get("used", False)),
        "measures_something": entry.get("measures") is not None,
    }


def _note(entry: Values) -> dict[str, Any]:
    known = ("value_mm", "count", "depth_mm", "through")
    return {
        "text": entry["text"],
        "kind": entry["kind"],
        "box": rounded(entry["box"]),
        **{name: entry[name] for name in known if entry.get(name) is not None},
    }


def _section(entry: Values) -> dict[str, Any]:
    known = ("in_view", "looks")
    found = {"label": entry["label"], "box": rounded(entry["box"])}
    if entry.get("line") is not None:
        found["line"] = [rounded(end) for end in entry["line"]]
    return found | {name: entry[name] for name in known if entry.get(name) is not None}


def _problem(entry: Values, data: Values) -> dict[str, Any]:
    boxes = [rounded(box) for box in entry.get("at", ())]
    found = {
        "code": entry["code"],
        "severity": entry["severity"],
        "message": entry["message"],
        "offers": [_offer(str(name), boxes, data) for name in entry.get("offers", ())],
    }
    return {**found, "boxes": boxes} if boxes else found


def _offer(name: str, boxes: Sequence[Any], data: Values) -> dict[str, Any]:
    """A correction that may help: ready to be sent, but for words in capitals, which only the sheet
    can tell."""
    view = _view_meant(boxes, data)
    stroke = {"target": {"id": "ID"}}
    box = boxes[0] if boxes else ["X0", "Y0", "X1", "Y1"]
    other = "first" if data["projection"]["value"] == "third" else "third"
    inch = "in" if data["unit"].get("value", "mm") == "mm" else "mm"
    attributes: dict[str, Any] = {
        "view": {"id": view, "role": "ROLE", **({"box": box} if view == "ID" else {})},
        "kind": {**stroke, "to": "KIND"},
        "erase": stroke,
        "draw": {"view": view, "kind": "visible", "line": [["X", "Y"], ["X", "Y"]]},
        "dimension": {"id": "ID", "value_mm": "MM"},
        "scale": {"axis": "x", "length_mm": "MM"},
        "unit": {"value": inch},
        "projection": {"value": other},
        "region": {"polygon": _corners(box), "kind": "ignore"},
        "trace": {"view": view, "at": ["X", "Y"], "kind": "visible"},
        "section": {"id": "ID", "in_view": "ID", "line": [["X", "Y"], ["X", "Y"]]},
        "note": {"circle": ["X", "Y", "RADIUS"], "through": True},
    }
    return {"op": name, **attributes.get(name, {})}


def _view_meant(boxes: Sequence[Any], data: Values) -> str:
    """The view of which a problem speaks: that of its box, else one that is not used."""
    for view in data.get("views", ()):
        if rounded(view["box"]) in boxes or (not boxes and not view.get("used", True)):
            return str(view["id"])
    return "ID"


def _corners(box: Sequence[Any]) -> list[Any]:
    x0, y0, x1, y1 = box
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def _doubtful(views: Sequence[Values], strokes: Sequence[Values]) -> Iterator[dict[str, Any]]:
    """Strokes of views whose kind may be another, the most doubtful first, with what says so."""
    used = {view["id"] for view in views if view.get("used", True)}
    found = [
        stroke
        for stroke in strokes
        if stroke.get("view") in used and stroke.get("confidence", 1.0) < DOUBT
    ]
    for stroke in sorted(found, key=lambda entry: (entry["confidence"], -length(entry))):
        target = {"id": stroke["id"]}
        kinds = dict.fromkeys((stroke["kind"], (stroke.get("why") or {}).get("otherwise")))
        offers = [{"op": "kind", "target": target, "to": kind} for kind in kinds if kind]
        yield {**stroke_entry(stroke), "offers": offers}
