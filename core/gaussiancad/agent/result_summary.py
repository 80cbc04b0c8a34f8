"""A part, or a comparison, as an agent sees it: short, with the reasons and their places."""

from collections.abc import Mapping
from typing import Any

from gaussiancad import Check, Comparison, Result

_MOST_ENTRIES = 12
"""Of each list."""

_KNOWN = (
    "status",
    "verdict",
    "projection",
    "projection_source",
    "scale_mm_per_pixel",
    "scale_source",
    "measures",
    "solid",
    "surface",
    "tolerance_px",
)
"""Attributes of the report that are taken as they are."""

_AGREEMENT = ("box", "visible_recall", "visible_precision", "hidden_recall", "hidden_precision")

_COMPARED = (
    "protocol",
    "volume_iou",
    "chamfer",
    "hausdorff",
    "emd",
    "point_to_surface",
    "floor",
    "points",
    "seed",
    "unit_mm",
)


def result_summary(result: Result) -> dict[str, Any]:
    """What a run made, and why it is no more."""
    report = result.report
    found: dict[str, Any] = {name: report[name] for name in _KNOWN if name in report}
    found["views"] = {
        role: {name: view[name] for name in _AGREEMENT if name in view}
        for role, view in report.get("views", {}).items()
    }
    for name in ("reasons", "warnings"):
        entries = report.get(name, ())
        found[name] = [{key: entry[key] for key in ("code", "message")} for entry in entries]
    for name in ("assumptions", "unused", "sections", "disagreements", "conflict"):
        found |= _listed(name, report.get(name, ()))
    found["seconds"] = round(sum(report.get("seconds", {}).values()), 1)
    return found


def comparison_summary(comparison: Comparison) -> dict[str, Any]:
    """The figures of a comparison."""
    found: dict[str, Any] = {name: comparison[name] for name in _COMPARED if name in comparison}
    registration = comparison.get("registration", {})
    found["registration"] = {
        name: registration[name] for name in ("mirrored", "scale", "mode") if name in registration
    }
    deviation = comparison.get("deviation") or {}
    found["deviation_mm"] = {
        name.removesuffix("_mm"): deviation[name]
        for name in ("least_mm", "greatest_mm")
        if name in deviation
    }
    found["warnings"] = [_message(entry) for entry in comparison.get("warnings", ())]
    return found


_PIECES = ("pieces", "model")
"""Names of the many pieces of a difference, whose ends and length say enough."""


def check_summary(found: Check) -> dict[str, Any]:
    """Whether a model agrees with its drawing, and the worst of what does not."""
    values: dict[str, Any] = {"verdict": found.verdict, "share": found["share"]}
    values["reasons"] = [_message(reason) for reason in found.reasons]
    differences = [
        {name: value for name, value in each.items() if name not in _PIECES and value is not None}
        for each in found.differences
    ]
    for name, entries in (
        ("differences", differences),
        ("tally", found.tally),
        ("edits", found.edits),
        ("silent", found.silent),
    ):
        values |= _listed(name, entries)
    return values


def features_summary(values: Mapping[str, Any]) -> dict[str, Any]:
    """The features of each solid, by kind, and whether they make it up alone."""
    return {
        "solids": [
            {
                "whole": solid["whole"],
                "features": [
                    {name: each[name] for name in ("kind", "name") if name in each}
                    for each in solid["features"][:_MOST_ENTRIES]
                ],
                "count": len(solid["features"]),
            }
            for solid in values["solids"]
        ]
    }


def _message(entry: Any) -> Any:  # noqa: ANN401
    if not isinstance(entry, Mapping):
        return entry
    return {key: entry[key] for key in ("code", "message") if key in entry}


def _listed(name: str, entries: Any) -> dict[str, Any]:  # noqa: ANN401
    """The first of some entries, and how many there are besides; nothing where there are none."""
    if not entries:
        return {}
    more = len(entries) - _MOST_ENTRIES
    return {name: list(entries[:_MOST_ENTRIES]), **({f"more_{name}": more} if more > 0 else {})}
