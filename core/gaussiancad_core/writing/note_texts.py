"""The notes of a sheet, with their places."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.writing.callouts import Callout, NoteKind, parse_callout
from gaussiancad_core.writing.dimension_layout import LOOSELY
from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.sheet_texts import SheetText

WIDER = (NoteKind.COUNTERBORE, NoteKind.COUNTERSINK)
"""Kinds of what a hole has where it is wider."""

Targets = Mapping[Box, tuple[Arc, ...]]
"""Circles and arcs that texts speak of, by the boxes of these."""

_NOTHING: Targets = {}

GOING_ON = (*WIDER, NoteKind.DEPTH)
"""Kinds of notes that say more of what stands on the line above them."""


@dataclass(frozen=True)
class SheetNote:
    """What a text says of a feature.

    Attributes:
        text: as it was read.
        box: around it, px of the upright sheet.
        callout: what it says.
        value_mm: the callout's length, of an angle its degrees.
        depth_mm: the depth that it tells.
        circle: of the hole that it speaks of, px of the upright sheet, where a person said so.
        pointed: circles and arcs that it speaks of, px of the upright sheet, by its leader, or by
            their labels where it is a row of a hole table.
    """

    text: str
    box: Box
    callout: Callout
    value_mm: float | None
    depth_mm: float | None
    circle: Arc | None = None
    pointed: tuple[Arc, ...] = ()


def notes_of(
    texts: Sequence[SheetText],
    unit: Unit,
    targets: Targets = _NOTHING,
    *,
    bare_point_is_inch: bool = True,
) -> tuple[SheetNote, ...]:
    """What texts say that is more than a mere length; those of the title block say no more of it
    than how thick it is.

    Args:
        texts: of the sheet.
        unit: of numbers that do not name theirs.
        targets: the circles that texts are known to speak of.
        bare_point_is_inch: see :func:`.parse_dimension`.
    """
    every = [
        replace(_note(text, callout, unit), pointed=targets.get(text.box, ()))
        for text in texts
        for callout in parse_callout(
            text.text, field=text.field, bare_point_is_inch=bare_point_is_inch
        )
        if callout.kind is NoteKind.THICKNESS or not text.field
    ]
    more = [note for note in every if note.callout.kind in GOING_ON]
    return tuple(
        note if note.callout.kind is not NoteKind.LENGTH else _as_hole(note)
        for note in every
        if note.callout.kind is not NoteKind.LENGTH
        or any(gap_below(note.box, each) is not None for each in more)
    )


def gap_below(above: Box, note: SheetNote) -> float | None:
    """px from a box down to a note that stands right below it and goes on; None of others."""
    x0, y0, x1, y1 = note.box
    height = min(y1 - y0, above[3] - above[1])
    gap = y0 - above[3]
    near = -0.5 * height <= gap <= LOOSELY * height and x0 <= above[2] and above[0] <= x1
    return gap if near else None


def _as_hole(note: SheetNote) -> SheetNote:
    """A length that has a depth, or is wider, on its next line: the diameter of a hole."""
    return replace(note, callout=replace(note.callout, kind=NoteKind.DIAMETER))


def _note(text: SheetText, callout: Callout, unit: Unit) -> SheetNote:
    value = (
        callout.value
        if callout.kind is NoteKind.ANGLE
        else callout.millimetres(callout.value, unit)
    )
    return SheetNote(text.text, text.box, callout, value, callout.millimetres(callout.depth, unit))
