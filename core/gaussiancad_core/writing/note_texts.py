"""The notes of a sheet, with their places."""

from collections.abc import Sequence
from dataclasses import dataclass

from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.writing.callouts import Callout, NoteKind, parse_callout
from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.sheet_texts import SheetText


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
    """

    text: str
    box: Box
    callout: Callout
    value_mm: float | None
    depth_mm: float | None
    circle: Arc | None = None


def notes_of(
    texts: Sequence[SheetText], unit: Unit, *, bare_point_is_inch: bool = True
) -> tuple[SheetNote, ...]:
    """What texts say that is more than a mere length; those of the title block say no more of it
    than how thick it is.

    Args:
        texts: of the sheet.
        unit: of numbers that do not name theirs.
        bare_point_is_inch: see :func:`.parse_dimension`.
    """
    return tuple(
        _note(text, callout, unit)
        for text in texts
        for callout in parse_callout(
            text.text, field=text.field, bare_point_is_inch=bare_point_is_inch
        )
        if callout.kind is not NoteKind.LENGTH
        and (callout.kind is NoteKind.THICKNESS or not text.field)
    )


def _note(text: SheetText, callout: Callout, unit: Unit) -> SheetNote:
    value = (
        callout.value
        if callout.kind is NoteKind.ANGLE
        else callout.millimetres(callout.value, unit)
    )
    return SheetNote(text.text, text.box, callout, value, callout.millimetres(callout.depth, unit))
