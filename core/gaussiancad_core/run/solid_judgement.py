"""What the judge of a whole sheet says of the solid that was made from it.

A label is a guess, and so is what a reader took for annotation: an edge of a sound solid that lies
on ink is none that the sheet lacks.  That its label was wrong is said instead.  A solid that nobody
could tell from the sheet by its lines is no longer certain where the judge finds a reason against
it: a note that it does not keep, a single change with which it would explain more.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial

import numpy as np

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.judging.difference_kinds import Kind
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.judging.faceted_solids import Floats, faceted_shape
from gaussiancad_core.judging.note_tally import Tally
from gaussiancad_core.judging.sheet_ink import SheetInk, distance_to_ink, placements_of
from gaussiancad_core.judging.sheet_judgement import SheetEvidence, SheetJudgement, judge_in_place
from gaussiancad_core.judging.verdicts import Verdict, broken
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Status

_ON_INK = 0.9
"""Share of an edge that lies on ink from which the sheet draws it: it ends short where others
cross."""

_LEAST = 0.01
"""Share of the longest extent from which a difference counts."""

_MOST_PLACES = 5
"""Boxes that a message names at most."""

_AROUND = 12.0
"""px around a place that a box shows."""

ADDED = frozenset({Kind.EXTRA, Kind.EXTRA_HIDDEN})
"""What the solid shows and the sheet does not."""

Reason = tuple[str, str]


def judged_model(model: ExactModel, sheet: OpenedSheet) -> ExactModel:
    """A model whose solid was compared with all that its sheet shows.

    Args:
        model: of the sheet.
        sheet: as stored and upright.
    """
    if model.result.shape is None:
        return model
    reading = model.reading
    ink = SheetInk(distance_to_ink(sheet.clean.ink), placements_of(reading))
    evidence = SheetEvidence(reading.numbered, ink, reading.projection)
    # Only of what is certain so far is more to be known than where it differs.
    is_certain = model.result.status is Status.VERIFIED
    solid = faceted_shape(model.result.shape)
    judged = judge_in_place(solid, evidence, tries_edits=is_certain)
    result = _with_judgement(model.result, judged, sheet.turn)
    return replace(model, result=result, judged=judged)


def counted_differences(judged: SheetJudgement) -> tuple[Difference, ...]:
    """The places at which a solid and its sheet differ, without those that nobody would see and
    those that the sheet draws nevertheless."""
    return tuple(each for each in _seen(judged) if not _is_on_ink(each))


def _with_judgement(result: ExactResult, judged: SheetJudgement, turn: Turn) -> ExactResult:
    """The same with what the judge has to say."""
    if result.status is Status.VERIFIED:
        if judged.judgement.verdict is Verdict.AGREES:
            return result
        for reason in judged.judgement.reasons:
            result = result.doubted((reason.code, reason.message))
        return result
    reasons = list(result.reasons)
    if result.verification is not None and result.verification.flaws:
        reasons = list(_of_lines(reasons, judged, turn))
    to_stored = partial(_box, judged, turn)
    reasons[:0] = [_of_note(note, to_stored) for note in judged.tally if not note.agrees]
    return replace(result, reasons=tuple(reasons))


def _of_lines(reasons: Iterable[Reason], judged: SheetJudgement, turn: Turn) -> Iterable[Reason]:
    """The same reasons, with what the sheet as a whole says of the lines that disagree."""
    differing = counted_differences(judged)
    drawn = [each for each in _seen(judged) if _is_on_ink(each)]
    for code, message in reasons:
        if code != Code.LINES_UNEXPLAINED:
            yield code, message
        elif differing:
            yield code, _unexplained(differing, judged, turn)
        elif not drawn:
            yield code, message
    if drawn:
        boxes = [_box(judged, turn, each.view.role, each.pieces.reshape(-1, 2)) for each in drawn]
        yield Code.LABELS_DOUBTFUL, _doubt(boxes)


def _seen(judged: SheetJudgement) -> Iterable[Difference]:
    if judged.evidence is None:
        return ()
    least = _LEAST * max(judged.evidence.views.size)
    return (each for each in judged.differences if each.mm >= least and each.kind != Kind.TANGENT)


def _is_on_ink(difference: Difference) -> bool:
    on_ink = difference.on_ink
    return difference.kind in ADDED and on_ink is not None and on_ink >= _ON_INK


def _unexplained(differing: tuple[Difference, ...], judged: SheetJudgement, turn: Turn) -> Message:
    worst, others = differing[0], len(differing) - 1
    beyond = worst.kind in ADDED
    (right, up), _ = worst.ends
    boxes = [_box(judged, turn, each.view.role, each.pieces.reshape(-1, 2)) for each in differing]
    return Message(
        "the solid {what} a line of {length_mm:.1f} mm that the {view} view {has}, at "
        "({right:.1f}, {up:.1f}) mm{more}",
        boxes=boxes[:_MOST_PLACES],
        case="beyond" if beyond else "missing",
        what="shows" if beyond else "does not show",
        length_mm=worst.mm,
        view=worst.view.role,
        has="has not" if beyond else "has",
        right=right,
        up=up,
        more=f", and {others} more" if others else "",
        count=others + 1,
    )


def _of_note(note: Tally, to_stored: Callable[[Role, Floats], Box]) -> Reason:
    reason = broken(note, [to_stored(Role(note.role), np.array([note.at]))])
    return reason.code, reason.message


def _doubt(boxes: list[Box]) -> Message:
    places = ("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in boxes[:_MOST_PLACES])
    return Message(
        "{count} line(s) may be edges of the part or annotation, at {places} px",
        boxes=boxes,
        count=len(boxes),
        places="; ".join(places),
    )


def _box(judged: SheetJudgement, turn: Turn, role: Role, places: Floats) -> Box:
    """px of the sheet as stored around places (n, 2) mm of a view."""
    if judged.evidence is None:
        raise ValueError("a solid that was not laid has no place on the sheet")
    points = turn.to_stored(judged.evidence.ink.placements[role].to_sheet(places))
    (x0, y0), (x1, y1) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return x0 - _AROUND, y0 - _AROUND, x1 + _AROUND, y1 + _AROUND
