"""A stroke of ``reading.json`` in sentences: what it is, how sure, why, and what else it may be."""

from gaussiancad_core.report.pointing import Values, length

_BY = {
    "network": "The labels network tells it by the look of its ink.",
    "line": "The rest of its line decides; by the look of its own ink it would be another.",
    "figure": "The figure that it hangs together with tells it.",
    "linetype": "Its dashes, or its pen, decide.",
    "file": "The file has it as a line of its own.",
}
"""What decided, by its name in the file."""

_BY_KIND = {
    ("pen", True): "Its width, colour or rhythm tells it; its look is that of annotation.",
    ("pen", False): "Its width, colour or rhythm tells it; its look is that of an edge.",
    ("loose-end", True): "Without it, other edges of the part would end where nothing meets them.",
    ("loose-end", False): "As an edge it would end where no other edge meets it.",
}
"""The same where it differs between edges and annotation."""

_EDGES = ("visible", "hidden")

_NAMES = {
    "visible": "a visible edge",
    "hidden": "a hidden edge",
    "centre": "a centre line",
    "tangent": "a tangent edge",
    "cut": "a cutting line",
    "hatch": "hatching",
    "dimension": "a dimension line",
    "extension": "an extension line",
    "leader": "a leader",
    "frame": "a line of the frame",
    "text": "writing",
    "thread": "a line of a thread",
    "symbol": "a symbol",
    "picture": "a line of a pictorial view",
    "ignore": "nothing of the drawing",
}


def stroke_in_words(stroke: Values) -> str:
    """What is known of a stroke.

    Args:
        stroke: an entry of the reading.
    """
    return " ".join(part for part in (_kind(stroke), _why(stroke), _otherwise(stroke)) if part)


def percent(share: float) -> str:
    """A share as per cent; what is not all is not called all."""
    return f"{100.0 * share:.1f} %" if share < 0.9995 or share == 1.0 else "99.9 %"


def _kind(stroke: Values) -> str:
    long = length(stroke)
    size = f" of {long:.0f} px" if long else ""
    confidence = stroke.get("confidence", 1.0)
    sure = f", {percent(confidence)} sure" if confidence < 1.0 else ""
    if stroke["view"] is None:
        return f"A {stroke['kind']}{size}: no line of the part{sure} ({stroke['id']})."
    shape = next(name for name in ("line", "arc", "ellipse") if name in stroke)
    return f"A {stroke['kind']} {shape}{size} of the {stroke['view']} view{sure} ({stroke['id']})."


def _why(stroke: Values) -> str:
    if stroke.get("source") == "given":
        return "A person said so."
    by = stroke.get("why", {}).get("by")
    return _BY.get(by) or _BY_KIND.get((by, stroke["kind"] in _EDGES), "")


def _otherwise(stroke: Values) -> str:
    other = stroke.get("why", {}).get("otherwise")
    return f"If that is wrong, it is {_NAMES.get(other, other)}." if other else ""
