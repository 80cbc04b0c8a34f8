"""Why a part is what it is: its report in sentences for who uses the window."""

from collections.abc import Iterable, Iterator
from typing import Any

from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import Report
from freecad.gaussiancad.engine.wording import alternative, drawing_name, role_name, worded
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate

_MOST = 6
"""Places that are named at most, the longest first."""

MODELS = {
    "as-drawn": QT_TRANSLATE_NOOP("GaussianCAD", "The lines as they are drawn"),
    "sketch": QT_TRANSLATE_NOOP("GaussianCAD", "Slabs that explain the lines best"),
    "features": QT_TRANSLATE_NOOP("GaussianCAD", "Features put together by what they explain"),
    "open-linetypes": QT_TRANSLATE_NOOP(
        "GaussianCAD", "Short lines as visible or hidden, whichever fits"
    ),
    "closed-outline": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The open outline closed by a straight line"
    ),
    "lone-bodies": QT_TRANSLATE_NOOP(
        "GaussianCAD", "With bodies of revolution that only one view shows"
    ),
    "without-rough-arcs": QT_TRANSLATE_NOOP(
        "GaussianCAD", "Rough arcs taken for curves in which surfaces meet"
    ),
    "followed-curves": QT_TRANSLATE_NOOP(
        "GaussianCAD", "Lines led onto the curves in which two surfaces meet"
    ),
    "undrawn-lines": QT_TRANSLATE_NOOP(
        "GaussianCAD", "With hidden lines that may have been left out"
    ),
    "likely-measures": QT_TRANSLATE_NOOP("GaussianCAD", "With measures that are most likely round"),
}
"""What a search for the solid went by."""

OUTCOMES = {
    "all-lines": QT_TRANSLATE_NOOP("GaussianCAD", "a solid with all lines"),
    "deviates": QT_TRANSLATE_NOOP("GaussianCAD", "a solid whose lines differ from the drawing's"),
    "unsound": QT_TRANSLATE_NOOP("GaussianCAD", "a solid that is not one valid closed body"),
    "faces-open": QT_TRANSLATE_NOOP("GaussianCAD", "faces that do not close"),
    "no-material": QT_TRANSLATE_NOOP("GaussianCAD", "nothing that bounds a body"),
    "contradictory": QT_TRANSLATE_NOOP(
        "GaussianCAD", "no solid, as the lines contradict each other"
    ),
    "unfinished": QT_TRANSLATE_NOOP("GaussianCAD", "no answer within the work that is allowed"),
    "too-large": QT_TRANSLATE_NOOP("GaussianCAD", "not tried, as there are too many lines"),
}


def explanation_lines(report: Report) -> list[str]:
    """Why the shape is not certain, what was assumed and left out, and what was tried."""
    uncertain = (
        translate("GaussianCAD", "Why there is no part:")
        if report.status is Status.FAILED
        else translate("GaussianCAD", "Why the shape is not certain:")
    )
    parts = (
        (uncertain, [remark.words for remark in report.reasons]),
        (translate("GaussianCAD", "What was assumed:"), list(_assumed(report))),
        (translate("GaussianCAD", "What was not used:"), list(_unused(report))),
        (translate("GaussianCAD", "What was tried for the solid:"), list(_tried(report))),
        (
            translate("GaussianCAD", "Where the part's lines and the drawing's differ:"),
            _longest(_differing(report)),
        ),
        (
            translate("GaussianCAD", "Lines that contradict each other:"),
            _longest(_contradicting(report)),
        ),
    )
    lines: list[str] = []
    for title, item in parts:
        if item:
            lines += [*([""] if lines else []), title, *(f"• {line}" for line in item)]
    return lines


def _entries(values: object) -> Iterator[dict[str, Any]]:
    """The objects in a list; nothing of what is none."""
    if isinstance(values, list):
        yield from (value for value in values if isinstance(value, dict))


def _assumed(report: Report) -> Iterator[str]:
    otherwise = translate("GaussianCAD", "Otherwise: {0}")
    for entry in _entries(report.values.get("assumptions")):
        code = str(entry.get("code", ""))
        line = worded(code, str(entry.get("message", "")), entry.get("args"))
        other = alternative(code, str(entry.get("alternative", "")))
        yield f"{line} {otherwise.format(other)}" if other else line


def _unused(report: Report) -> Iterator[str]:
    yield from (
        drawing_name(str(entry.get("kind", ""))) for entry in _entries(report.values.get("unused"))
    )


def _tried(report: Report) -> Iterator[str]:
    result = translate("GaussianCAD", "{model}: {outcome}.")
    faces = translate("GaussianCAD", "Faces: {faces}, agreement of the lines: {share}.")
    given_up = translate("GaussianCAD", "Length of the lines that were given up: {length} mm.")
    for entry in _entries(report.values.get("trace")):
        model, outcome = str(entry.get("model", "")), str(entry.get("outcome", ""))
        words = [
            result.format(
                model=_known(MODELS, model),
                outcome=_known(OUTCOMES, outcome),
            )
        ]
        if entry.get("faces"):
            words.append(faces.format(faces=entry["faces"], share=_share(entry.get("agreement"))))
        if entry.get("given_up"):
            words.append(given_up.format(length=_length(entry.get("given_up_mm"))))
        if entry.get("taken"):
            words.append(translate("GaussianCAD", "This one was taken."))
        yield " ".join(words)


def _differing(report: Report) -> Iterator[str]:
    lacks = translate("GaussianCAD", "{view}: the part lacks a line of {length} mm")
    has = translate("GaussianCAD", "{view}: the part has a line of {length} mm too many")
    for entry in _entries(report.values.get("disagreements")):
        view, length = role_name(str(entry.get("view", ""))), _length(entry.get("length_mm"))
        yield (lacks if entry.get("missing") else has).format(view=view, length=length)


def _contradicting(report: Report) -> Iterator[str]:
    names = {
        "visible": translate("GaussianCAD", "{view}: a visible line"),
        "hidden": translate("GaussianCAD", "{view}: a hidden line"),
    }
    blank = translate("GaussianCAD", "{view}: a place where nothing is drawn")
    suspect = translate("GaussianCAD", "without it all others agree")
    for entry in _entries(report.values.get("conflict")):
        text = names.get(str(entry.get("drawn")), blank).format(
            view=role_name(str(entry.get("view", "")))
        )
        yield f"{text} ({suspect})" if entry.get("suspect") else text


def _longest(lines: Iterable[str]) -> list[str]:
    """The first of some lines, and how many there are beside."""
    every = list(lines)
    more = translate("GaussianCAD", "and {count} more").format(count=len(every) - _MOST)
    return [*every[:_MOST], *([more] if len(every) > _MOST else [])]


def _known(names: dict[str, str], key: str) -> str:
    """The name of what the engine calls by a key; an unknown one stays as it is."""
    return translate("GaussianCAD", names[key]) if key in names else key


def _length(value: object) -> str:
    return f"{value:.1f}" if isinstance(value, int | float) else "?"


def _share(value: object) -> str:
    return f"{value:.1%}" if isinstance(value, int | float) else "?"
