"""How sure a stroke of a reading is, why, and what else it may be: from labels and back to them."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.readings.reading_schema import GIVEN, StrokeEntry, Why
from gaussiancad_core.readings.reading_shapes import shape_of, stroke_of
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.labels.ink_classes import BY_LABELS, PART, Evidence, InkClass
from gaussiancad_core.sheet.labels.label_evidence import LabelledLine, SheetLabels, solver_weight
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_protocol.reading_kinds import StrokeKind

_KINDS = {
    InkClass.VISIBLE: StrokeKind.VISIBLE,
    InkClass.HIDDEN: StrokeKind.HIDDEN,
    InkClass.CENTRE: StrokeKind.CENTRE,
    InkClass.DIMENSION: StrokeKind.DIMENSION,
    InkClass.HATCHING: StrokeKind.HATCH,
    InkClass.TEXT: StrokeKind.TEXT,
    InkClass.FRAME: StrokeKind.FRAME,
    InkClass.PICTORIAL: StrokeKind.PICTURE,
    InkClass.OTHER: StrokeKind.SYMBOL,
    InkClass.THIN: StrokeKind.TANGENT,
}
"""What a stroke of each class stands for."""

_INKS = {
    **{kind: ink for ink, kind in _KINDS.items()},
    StrokeKind.CUT: InkClass.CENTRE,
    StrokeKind.EXTENSION: InkClass.DIMENSION,
    StrokeKind.LEADER: InkClass.DIMENSION,
    StrokeKind.THREAD: InkClass.THIN,
    StrokeKind.IGNORE: InkClass.OTHER,
}

_DIGITS = 4
"""Decimals of confidences and log-odds."""

_STEP_PX = 2.0
"""px between the points at which strokes are compared."""

Certainty = Mapping[str, Any]
"""``confidence``, ``why`` and ``source`` of a :class:`StrokeEntry`."""


OF_FILE: Certainty = {"source": StrokesSource.VECTOR.value, "why": Why(by=Evidence.FILE)}
"""What is known of a line of a file."""


def view_certainty(view: ReadView) -> list[tuple[Stroke, Certainty]]:
    """The strokes of a view, each with what is known of it."""
    return [(stroke, _certainty(stroke, view.source, view.labels)) for stroke in view.strokes]


def _certainty(stroke: Stroke, source: StrokesSource, labels: SheetLabels) -> Certainty:
    line = labels.along(stroke.sample(_STEP_PX), part=True)
    if line is not None and line.why is Evidence.PERSON:
        return {"confidence": 1.0, "source": GIVEN}
    if line is not None and stroke.confidence >= solver_weight(line.confidence):
        return {**_by_label(line), "source": source.value}
    sure = _rounded(min(stroke.confidence, line.confidence if line is not None else 1.0))
    if sure < 1.0:
        hidden = stroke.linetype is Linetype.HIDDEN
        other = StrokeKind.VISIBLE if hidden else StrokeKind.HIDDEN
        return {
            "confidence": sure,
            "why": Why(by=Evidence.LINETYPE, otherwise=other),
            "source": source.value,
        }
    why = Why(by=Evidence.FILE) if source is not StrokesSource.RASTER else None
    return {"confidence": 1.0, "why": why, "source": source.value}


def read_entry(
    name: str, view: str | None, stroke: Stroke, turn: Turn, stated: Certainty
) -> StrokeEntry:
    """The entry of a stroke of the part.

    Args:
        name: its id.
        view: the id of its view.
        stroke: px of the upright sheet.
        turn: of the sheet.
        stated: how sure it is, and why.
    """
    hidden = stroke.linetype is Linetype.HIDDEN
    kind = StrokeKind.HIDDEN if hidden else StrokeKind.VISIBLE
    return StrokeEntry(id=name, view=view, kind=kind, **stated, **shape_of(stroke, turn))


def tangent_entry(name: str, view: ReadView, stroke: Stroke, turn: Turn) -> StrokeEntry:
    """The entry of a line of a view along which faces meet smoothly.

    Args:
        name: its id.
        view: that shows it.
        stroke: px of the upright sheet.
        turn: of the sheet.
    """
    return StrokeEntry(
        id=name,
        view=view.role.value,
        kind=StrokeKind.TANGENT,
        source=view.source.value,
        **shape_of(stroke, turn),
    )


def mark_certainty(mark: Mark, labels: SheetLabels) -> Certainty:
    """What is known of an annotation; nothing of one that is no line.

    Args:
        mark: px of the upright sheet.
        labels: of the sheet.
    """
    if mark.line is None or not labels.lines:
        return {}
    points = Segment(*mark.line, Linetype.VISIBLE).sample(_STEP_PX)
    line = labels.along(points, part=False)
    if line is None:
        return {}
    return {"source": GIVEN} if line.why is Evidence.PERSON else _by_label(line)


def entry_labels(entries: Iterable[StrokeEntry], turn: Turn, stroke_width: float) -> SheetLabels:
    """The lines of a reading of which labels, or a person, told what they are.

    Args:
        entries: strokes and annotations.
        turn: of the upright sheet.
        stroke_width: px of that.
    """
    found = []
    for entry in entries:
        by_person = entry.source == GIVEN
        why = entry.why
        if not by_person and (why is None or why.by not in BY_LABELS):
            continue
        stroke = stroke_of(entry, turn)
        if stroke is None:
            continue
        ink = _INKS[entry.kind]
        stated = (entry.confidence, why.by) if why and not by_person else (1.0, Evidence.PERSON)
        other = _INKS[why.otherwise] if why and why.otherwise else _opposite(ink)
        margin = why.margin if why and why.margin is not None else 0.0
        points = np.asarray(stroke.sample(_STEP_PX))
        found.append(LabelledLine(points, stroke.length, ink, other, margin, *stated))
    return SheetLabels(tuple(found), stroke_width)


def _opposite(ink: InkClass) -> InkClass:
    return InkClass.OTHER if ink in PART else InkClass.VISIBLE


def _by_label(line: LabelledLine) -> dict[str, Any]:
    why = Why(by=line.why, otherwise=_KINDS[line.otherwise], margin=_rounded(line.margin))
    return {"confidence": _rounded(line.confidence), "why": why}


def _rounded(value: float) -> float:
    return round(float(value), _DIGITS)
