"""A run in sentences: what is known, why no more, and what was tried.

Everything is taken from ``report.json`` and ``reading.json``, so that a run can be explained long
after it ended.
"""

from collections.abc import Iterable, Sequence
from math import hypot

from gaussiancad_core.report.pointing import Values, distance, holds
from gaussiancad_core.report.stroke_sentences import percent, stroke_in_words
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.reading_kinds import DOUBT

_MOST = 6
"""Places that one sentence names at most."""

_NEAR_PX = 12.0
"""px within which a stroke is the one that is pointed at."""

_SOURCES = {
    "numbers": "from the sheet's numbers",
    "drawing": "from the drawing",
    "mixed": "from the sheet's numbers and the drawing",
}

_SIZE_UNKNOWN = (
    "Size unknown: pass it with --length AXIS=MM, or set the length between two "
    "points in the window."
)

_MEASURES_UNKNOWN = "How exact its measures are is not known: the views fit no one scale."

_NO_ONE_SCALE = (Code.PHOTOGRAPHED_AT_A_SLANT, Code.VIEWS_DISAGREE)
"""Reasons and warnings which say that no scale is that of all views."""

_MODELS = {
    "as-drawn": "the lines as they are drawn",
    "sketch": "slabs that explain the lines best, none of which has to hold",
    "features": "features put together, each by what it explains",
    "open-linetypes": "the same where a line no longer than a dash may be of either kind",
    "closed-outline": "the same with the outline that is open closed by a straight line",
    "lone-bodies": "with bodies of revolution that one view alone speaks of",
    "without-rough-arcs": "with arcs that only follow a curve of intersection taken for such",
    "followed-curves": "with strokes led onto the curves in which two surfaces meet",
    "undrawn-lines": "with hidden lines that were left out in the views that have none",
    "likely-measures": "with measures that most likely are round",
}

_OUTCOMES = {
    "all-lines": "a solid that has all lines",
    "deviates": "a solid whose lines differ from the sheet's",
    "unsound": "a solid that is not one valid closed body",
    "faces-open": "faces that do not close",
    "no-material": "nothing that bounds a body",
    "contradictory": "no solid: its lines contradict each other",
    "unfinished": "no answer within the work that is allowed",
    "too-large": "not tried: it is too large",
}


def verdict(report: Values) -> str:
    """What is known of the part, in one line."""
    status = report["status"]
    if status == "failed":
        return f"No model. {_first_reason(report)}"
    certain = "Shape verified." if status == "verified" else "Shape not certain."
    if not is_size_known(report):
        return f"{_SIZE_UNKNOWN} {certain}"
    measures = report.get("measures")
    if measures is None:
        exact = "" if has_measure_bound(report) else f" {_MEASURES_UNKNOWN}"
        return f"{certain}{exact}"
    bound = f"{measures['uncertainty_mm']:.2g}"
    return f"{certain} Measures to \u00b1{bound} mm ({_SOURCES[measures['source']]})."


def is_size_known(report: Values) -> bool:
    """Whether the sheet, its file or a person tells how large the part is.

    That a drawing on paper shows it full scale is nothing that anybody told.
    """
    if report.get("scale_source") == "default":
        return False
    return not any(
        item["code"] == Code.FULL_SCALE_ASSUMED and item.get("args", {}).get("case") != "file"
        for item in report.get("warnings", ())
    )


def has_measure_bound(report: Values) -> bool:
    """Whether the views fit one scale, so that a bound of the measures can be stated.

    They do not where the sheet was photographed at a slant, however well it was straightened.
    """
    remarks = (*report.get("reasons", ()), *report.get("warnings", ()))
    return not any(remark["code"] in _NO_ONE_SCALE for remark in remarks)


def explained(report: Values) -> list[str]:
    """Why the result is what it is, one sentence a line.

    Args:
        report: of a run.
    """
    lines = [verdict(report)]
    if report["reasons"]:
        lines += ["", "Why it is not certain:" if report["solid"] else "Why:"]
        lines += [f"- {reason['message']} [{reason['code']}]" for reason in report["reasons"]]
    if report.get("assumptions"):
        lines += ["", "What was assumed:"]
        lines += [
            f"- {item['message']}; otherwise: {item['alternative']}"
            for item in report["assumptions"]
        ]
    lines += ["", "What was read:", *_read(report)]
    if report.get("trace"):
        lines += ["", "What was tried:"]
        for number, attempt in enumerate(report["trace"], start=1):
            lines += _attempt(number, attempt)
    if report.get("disagreements"):
        lines += ["", "Where the solid's lines and the sheet's differ:"]
        lines += _named(map(_disagreement, report["disagreements"]))
    if report.get("conflict"):
        lines += ["", "Lines that contradict each other:"]
        lines += _named(map(_conflict, report["conflict"]))
    return lines


def explained_view(report: Values, reading: Values, role: str) -> list[str]:
    """What is known of a view.

    Args:
        report: of a run.
        reading: of the same.
        role: of the view.
    """
    view = report["views"][role]
    strokes = [stroke for stroke in reading["strokes"] if stroke["view"] == role]
    lines = [_lines_of_view(role, view["box"], strokes)]
    if "visible_recall" in view:
        lines.append(
            f"Of its visible lines the result has {percent(view['visible_recall'])}, of its "
            f"hidden ones {percent(view['hidden_recall'])}; of the result's lines it has "
            f"{percent(view['visible_precision'])} and {percent(view['hidden_precision'])}."
        )
    lines += [_disagreement(item) for item in report["disagreements"] if item["view"] == role]
    lines += [_conflict(item) for item in report["conflict"] if item["view"] == role]
    for attempt in report["trace"]:
        places = [item for item in attempt["given_up"] if item["view"] == role]
        if places:
            lines.append(f"Given up with {_MODELS[attempt['model']]}:")
            lines += _named(map(_given_up, places))
    return lines


def explained_place(report: Values, reading: Values, at: tuple[float, float]) -> list[str]:
    """What is known of a place on the sheet.

    Args:
        report: of a run.
        reading: of the same.
        at: px of the sheet as stored.
    """
    lines = read_place(reading, at)
    for role, view in report["views"].items():
        if holds(view["box"], at):
            lines.append(f"It lies within the {role} view.")
    for item in report["unused"]:
        if holds(item["box"], at):
            lines.append(f"It lies within a {item['kind']} that was not used: {item['why']}.")
    for attempt in report["trace"]:
        for entry in attempt["given_up"]:
            if hypot(entry["at"][0] - at[0], entry["at"][1] - at[1]) <= 2.0 * _NEAR_PX:
                lines.append(f"With {_MODELS[attempt['model']]}: {_given_up(entry)} was given up.")
    for element in report["disagreements"]:
        if hypot(element["at"][0] - at[0], element["at"][1] - at[1]) <= 2.0 * _NEAR_PX:
            lines.append(_disagreement(element))
    for member in report["conflict"]:
        if holds(member["box"], at, _NEAR_PX):
            lines.append(_conflict(member))
    return lines


def read_place(reading: Values, at: tuple[float, float]) -> list[str]:
    """What was read at a place on the sheet, px of the sheet as stored."""
    where = f"({at[0]:.0f}, {at[1]:.0f})"
    near = sorted(
        ((distance(stroke, at), stroke) for stroke in reading["strokes"]), key=lambda pair: pair[0]
    )
    found = [stroke for away, stroke in near if away <= _NEAR_PX]
    lines = [stroke_in_words(stroke) for stroke in found[:_MOST]]
    if not found:
        away = f"; the nearest is {near[0][0]:.0f} px away" if near else ""
        lines.append(f"No line was read at {where} px{away}.")
    lines += [
        _number(item) for item in reading.get("dimensions", ()) if holds(item["box"], at, 2.0)
    ]
    for entry in reading.get("notes", ()):
        if holds(entry["box"], at, 2.0):
            through = ", through" if entry.get("through") else ""
            lines.append(f"The note {entry['text']!r} speaks of: {entry['kind']}{through}.")
    return lines


def read_view(reading: Values, role: str) -> list[str]:
    """What was read of the views of a role, and what is in doubt of their strokes."""
    lines = []
    for view in reading["views"]:
        if view["role"] != role:
            continue
        strokes = [stroke for stroke in reading["strokes"] if stroke["view"] == view["id"]]
        lines.append(_lines_of_view(role, view["box"], strokes))
        doubtful = [stroke for stroke in strokes if stroke.get("confidence", 1.0) < DOUBT]
        lines += _named(stroke_in_words(stroke) for stroke in doubtful)
    return lines


def read_sheet_in_words(reading: Values) -> list[str]:
    """What was read on a sheet, and what is in doubt."""
    lines = [
        f"The {view['role']} view at {_box(view['box'])} px."
        if view.get("used", True)
        else f"Not used: {view.get('kind') or view['role']} at {_box(view['box'])} px."
        for view in reading["views"]
    ]
    lines += [
        f"Section {item['label']}-{item['label']} at {_box(item['box'])} px"
        + (f", cut in the {item['in_view']} view." if item.get("in_view") else ".")
        for item in reading.get("sections", ())
    ]
    scale = reading["scale"].get("mm_per_px")
    if scale:
        lines.append(f"Scale {scale:.4g} mm a pixel ({reading['scale']['source']}).")
    return lines + [f"{item['severity']}: {item['message']}" for item in reading["problems"]]


def _lines_of_view(role: str, box: Sequence[float], strokes: Sequence[Values]) -> str:
    visible, hidden = (
        sum(stroke["kind"] == kind for stroke in strokes) for kind in ("visible", "hidden")
    )
    return f"The {role} view at {_box(box)} px has {visible} visible and {hidden} hidden lines."


def _number(entry: Values) -> str:
    used = "the scale rests on it" if entry.get("used") else "the scale does not rest on it"
    found = "" if entry.get("measures") else ", and what it measures was not found"
    return f"The number {entry['text']!r} is {entry['value_mm']:g} mm: {used}{found}."


def _first_reason(report: Values) -> str:
    reasons = report["reasons"]
    return f"{reasons[0]['message'][:1].upper()}{reasons[0]['message'][1:]}." if reasons else ""


def _read(report: Values) -> list[str]:
    lines = []
    for role, view in report["views"].items():
        hidden = "" if view.get("hidden_lines") != "none" else ", no hidden line in it"
        lines.append(f"- the {role} view at {_box(view['box'])} px{hidden}")
    source = {"given": "as given", "symbol": "by its symbol", "inferred": "by its lines"}
    how = source.get(report["projection_source"], "assumed")
    lines.append(f"- {report['projection']} angle projection ({how})")
    scale = report.get("scale_mm_per_pixel")
    if scale:
        lines.append(f"- scale {scale:.4g} mm a pixel ({report['scale_source']})")
    lines += [
        f"- not used: {item['kind']} at {_box(item['box'])} px, {item['why']}"
        for item in report["unused"]
    ]
    return lines


def _attempt(number: int, attempt: Values) -> list[str]:
    size = f" ({attempt['rules']} rules over {attempt['cells']} cells)" if attempt["rules"] else ""
    taken = "; this one was taken" if attempt["taken"] else ""
    lines = [
        f"{number}. {_MODELS[attempt['model']]}{size}: {_OUTCOMES[attempt['outcome']]}{taken}."
    ]
    if attempt["faces"]:
        lines.append(
            f"   {attempt['faces']} faces; {percent(attempt['agreement'])} of all lines agree, "
            f"{attempt['disagreements']} places differ."
        )
    if attempt["others"]:
        lines.append(f"   {attempt['others']} other ways to fill the cells were built as well.")
    if attempt["given_up"]:
        lines.append(f"   {attempt['given_up_mm']:.1f} mm of line were given up:")
        lines += [f"   {line}" for line in _named(map(_given_up, attempt["given_up"]))]
    if attempt["open_at_mm"]:
        places = "; ".join(
            "({:.1f}, {:.1f}, {:.1f})".format(*place) for place in attempt["open_at_mm"][:_MOST]
        )
        lines.append(f"   Edges that bound one face only, at (x, y, z) mm: {places}.")
    return lines


def _named(sentences: Iterable[str]) -> list[str]:
    """The first of some sentences as a list, and how many there are beside."""
    every = list(sentences)
    more = [f"- and {len(every) - _MOST} more"] if len(every) > _MOST else []
    return [*(f"- {sentence}" for sentence in every[:_MOST]), *more]


def _given_up(entry: Values) -> str:
    kind = f"a {entry['drawn']} line" if entry["drawn"] else "a stretch where nothing is drawn"
    return (
        f"{kind} of {entry['length_mm']:.1f} mm in the {entry['view']} view at "
        f"({entry['at'][0]:.0f}, {entry['at'][1]:.0f}) px"
    )


def _disagreement(entry: Values) -> str:
    what = "the solid lacks" if entry["missing"] else "the sheet lacks"
    return (
        f"{what} {entry['length_mm']:.1f} mm of line in the {entry['view']} view, at "
        f"({entry['at'][0]:.0f}, {entry['at'][1]:.0f}) px"
    )


def _conflict(entry: Values) -> str:
    kind = f"a {entry['drawn']} line" if entry["drawn"] else "a stretch where nothing is drawn"
    fitting = f"as {entry['fitting']}" if entry["fitting"] else "not at all"
    suspect = f": all others agree where it is drawn {fitting}" if entry["suspect"] else ""
    return f"{kind} in the {entry['view']} view at {_box(entry['box'])} px{suspect}"


def _box(box: Sequence[float]) -> str:
    return "({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box)
