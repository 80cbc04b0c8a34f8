"""What a run's report says, in rows with their places on the sheet."""

from __future__ import annotations

from freecad.gaussiancad.canvas.sheet import Box
from freecad.gaussiancad.language import translate

MARKS = {
    "verified": "\u2714",
    "approximate": "\u26a0",
    "failed": "\u26d4",
    "refused": "\u26d4",
    "doubt": "\u26a0",
    "warning": "\u2139",
}

_AROUND = 20.0
"""px around a place that is shown with it."""

_MOST = 12
"""Places of disagreement that are listed."""


def found_in(report: dict) -> list[tuple[str, Box | None]]:
    """Rows of a report: the verdict, its reasons, what was assumed, where lines disagree."""
    status = report["status"]
    rows: list[tuple[str, Box | None]] = [(f"{MARKS[status]} {_verdict(status)}", None)]
    rows += [(own["message"], None) for own in report.get("reasons", ())]
    assumed = translate("GaussianCAD", "Assumed: {0}")
    rows += [
        (assumed.format(own["message"]), tuple(own["at"]) if own.get("at") else None)
        for own in report.get("assumptions", ())
    ]
    missing = translate("GaussianCAD", "The part lacks a line of {0} mm here")
    beyond = translate("GaussianCAD", "The part has a line of {0} mm here that the sheet has not")
    for own in report.get("disagreements", ())[:_MOST]:
        text = missing if own["missing"] else beyond
        x, y = own["at"]
        box = (x - _AROUND, y - _AROUND, x + _AROUND, y + _AROUND)
        rows.append((text.format(own["length_mm"]), box))
    conflict = translate("GaussianCAD", "These lines contradict each other")
    rows += [(conflict, tuple(own["box"])) for own in report.get("conflict", ())]
    return rows


def _verdict(status: str) -> str:
    return {
        "verified": translate("GaussianCAD", "Verified: the part has the sheet's lines, no others"),
        "approximate": translate("GaussianCAD", "Approximate: check the part against the sheet"),
        "failed": translate("GaussianCAD", "No part follows from the sheet as it is"),
    }[status]
