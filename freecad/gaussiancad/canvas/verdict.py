"""What a run's report says, in rows with their places on the sheet."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from freecad.gaussiancad.canvas.corrections import Circle
from freecad.gaussiancad.canvas.rows import Line
from freecad.gaussiancad.canvas.scene import Mark
from freecad.gaussiancad.canvas.sheet import Box
from freecad.gaussiancad.engine.report import are_measures_told, is_size_known
from freecad.gaussiancad.engine.summary import measures_unknown
from freecad.gaussiancad.engine.wording import Place, alternative, worded
from freecad.gaussiancad.language import translate

SIGNS = {
    "verified": "\u2714",
    "approximate": "\u26a0",
    "failed": "\u2716",
    "refused": "\u2716",
    "doubt": "\u26a0",
    "warning": "\u2139",
}

_COLOURS = {"verified": "#2e7d32", "approximate": "#a86200", "failed": "#b3261e"}

_AROUND = 20.0
"""px around a place that is shown with it."""

_MOST = 12
"""Places of disagreement that are listed."""

Buttons = tuple[tuple[str, Callable[[], None]], ...]


@dataclass(frozen=True)
class Help:
    """What can be done about what a report says.

    Attributes:
        go_through: says that the holes of circles go through.
        ask_depths: asks how deep the holes of circles are.
        offers: buttons, by the code of a reason or a warning, or by ``code:case``.
        mend: buttons for a line that part and sheet do not share, an entry of the report.
    """

    go_through: Callable[[list[Circle]], None]
    ask_depths: Callable[[list[Circle]], None]
    offers: Mapping[str, Buttons]
    mend: Callable[[dict], Buttons]


def verdict_lines(report: dict, help_with: Help, doubts: Sequence[Line] = ()) -> list[Line]:
    """Rows of a report: the verdict with its colour, its reasons, what was assumed with a yes and a
    no, where lines disagree or contradict each other, strokes in doubt, and warnings.

    Args:
        report: of a run.
        help_with: what is offered for its rows.
        doubts: rows of strokes in doubt.
    """
    lines = [verdict_line(report["status"], _measures(report))]
    assumed = {item["message"] for item in report.get("assumptions", ())}
    offers = help_with.offers
    lines += [
        _remark("doubt", item, offers)
        for item in report.get("reasons", ())
        if item["message"] not in assumed
    ]
    assumptions = report.get("assumptions", ())
    holes = [circle for assumption in assumptions for circle in _holes_of(assumption)]
    lines += [_assumed(assumption, help_with, holes) for assumption in assumptions]
    lines += [Line(text, box, help_with.mend(item)) for item, (box, text) in _disagreements(report)]
    lines += [Line(text, box) for box, text in _conflicts(report)]
    lines += doubts
    lines += [_remark("warning", item, offers) for item in report.get("warnings", ())]
    return lines


def verdict_line(status: str, measures: str = "") -> Line:
    """The row with the verdict, in its colour; ``measures`` is a second line of it."""
    text = f"{SIGNS[status]} {_shape(status)}"
    return Line(f"{text}\n{measures}" if measures else text, colour=_COLOURS[status])


def _remark(severity: str, item: dict, offers: Mapping[str, Buttons]) -> Line:
    text = worded(item["code"], item["message"], item.get("args"), Place.CANVAS)
    box: Box | None = next(map(tuple, item.get("at", ())), None)
    case = f"{item['code']}:{item.get('args', {}).get('case')}"
    buttons = offers.get(case, offers.get(item["code"], ()))
    return Line(f"{SIGNS[severity]} {text}", box, buttons)


def marks_of(report: dict) -> list[Mark]:
    """Places of disagreements and contradictions."""
    return [*(mark for _, mark in _disagreements(report)), *_conflicts(report)]


def _disagreements(report: dict) -> Iterator[tuple[dict, Mark]]:
    missing = translate("GaussianCAD", "The part lacks a line of {0} mm here")
    beyond = translate("GaussianCAD", "The part has a line of {0} mm here that the sheet has not")
    for item in report.get("disagreements", ())[:_MOST]:
        text = missing if item["missing"] else beyond
        x, y = item["at"]
        box = (x - _AROUND, y - _AROUND, x + _AROUND, y + _AROUND)
        yield item, (box, text.format(f"{item['length_mm']:.4g}"))


def _conflicts(report: dict) -> Iterator[Mark]:
    conflict = translate("GaussianCAD", "These lines contradict each other")
    for item in report.get("conflict", ()):
        x0, y0, x1, y1 = item["box"]
        yield (x0 - _AROUND, y0 - _AROUND, x1 + _AROUND, y1 + _AROUND), conflict


def _holes_of(item: dict) -> list[Circle]:
    """The circles of holes that were assumed to go through."""
    if item["code"] != "hole-through":
        return []
    return [
        ((x0 + x1) / 2.0, (y0 + y1) / 2.0, (x1 - x0) / 2.0)
        for x0, y0, x1, y1 in item.get("places", ())
    ]


def _assumed(item: dict, help_with: Help, holes: list[Circle]) -> Line:
    stated = worded(item["code"], item["message"], item.get("args"), Place.CANVAS)
    text = translate("GaussianCAD", "Assumed: {0}").format(stated)
    if item.get("alternative"):
        other = alternative(item["code"], item["alternative"])
        text += "\n" + translate("GaussianCAD", "Otherwise: {0}").format(other)
    box: Box | None = tuple(item["at"]) if item.get("at") else None
    circles, tell = _holes_of(item), help_with
    if not circles:
        return Line(text, box)
    yes = translate("GaussianCAD", "Yes, Through"), lambda: tell.go_through(circles)
    no = translate("GaussianCAD", "No, so Deep\u2026"), lambda: tell.ask_depths(circles)
    every = translate("GaussianCAD", "All {0} Go Through").format(len(holes))
    more = ((every, lambda: tell.go_through(holes)),) if len(holes) > len(circles) else ()
    return Line(text, box, (yes, no, *more))


def _measures(report: dict) -> str:
    if not is_size_known(report):
        return translate("GaussianCAD", "The size is not known: tell a length")
    bound = (report.get("measures") or {}).get("uncertainty_mm")
    if not isinstance(bound, (int, float)):
        exact = report["status"] == "failed" or are_measures_told(report)
        return "" if exact else measures_unknown()
    return translate("GaussianCAD", "Measures to \u00b1{0} mm").format(f"{bound:.2g}")


def _shape(status: str) -> str:
    return {
        "verified": translate("GaussianCAD", "Verified: the part has the sheet's lines, no others"),
        "approximate": translate("GaussianCAD", "Approximate: check the part against the sheet"),
        "failed": translate("GaussianCAD", "No part follows from the sheet as it is"),
    }[status]
