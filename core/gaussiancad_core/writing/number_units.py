"""The unit of numbers that do not name theirs: by a note, by the file, by what they measure."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isclose, log

from gaussiancad_core.files.content import Note
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.messages import Message
from gaussiancad_core.writing.numbers import Unit, parse_unit
from gaussiancad_core.writing.scale_agreement import PAPER
from gaussiancad_core.writing.sheet_texts import SheetText
from gaussiancad_protocol.codes import Code


@dataclass(frozen=True)
class Units:
    """What tells the unit of numbers that do not name theirs.

    Attributes:
        given: by the user.
        noted: by a note.
        in_file: by the file, of the lengths that it draws.
        fitting: in which the numbers say the lengths that are drawn.
    """

    given: Unit | None
    noted: Unit | None
    in_file: Unit | None
    fitting: Unit | None

    @property
    def taken(self) -> Unit | None:
        """What the user says; else what is drawn and what is written tell it together before a
        note does."""
        if self.given is not None:
            return self.given
        if self.in_file is not None and self.fitting is not None:
            return self.fitting
        return self.noted or self.fitting or self.in_file

    @property
    def contradictions(self) -> tuple[Note, ...]:
        """That a note names another unit than the one that was taken."""
        taken = self.taken
        if self.noted is None or taken is None or self.noted is taken:
            return ()
        message = Message(
            "a note names {noted} as the unit, but the numbers fit what the file draws in {taken}: "
            "{taken} was taken",
            noted=self.noted.value,
            taken=taken.value,
        )
        return (Note(Code.UNIT_CONTRADICTS_NOTE, message),)


def other_size(drawing: VectorDrawing | None, written: float, drawn: float) -> tuple[Note, ...]:
    """That numbers say another size than the one that a file draws, by the unit that it states.

    Args:
        drawing: of the file.
        written: mm per px by the numbers.
        drawn: the same by the file's unit and the scale note, if there is one.
    """
    share = written / drawn
    if drawing is None or drawing.unit_mm is None or abs(log(share)) <= PAPER:
        return ()
    message = Message(
        "the dimensions say that the part is {share:.4g} times as large as the file draws it in "
        "the unit that it states: the dimensions were taken",
        share=share,
    )
    return (Note(Code.SIZE_CONTRADICTS_UNIT, message),)


def file_unit(drawing: VectorDrawing | None) -> Unit | None:
    """The unit that a file says its lengths are in, if numbers on a drawing may be in it."""
    stated = drawing.unit_mm if drawing is not None else None
    if stated is None:
        return None
    return next((unit for unit in Unit if isclose(unit.millimetres, stated)), None)


def noted_unit(texts: Sequence[SheetText]) -> Unit | None:
    """The one unit that notes name."""
    units = {unit for text in texts if (unit := parse_unit(text.text, text.field)) is not None}
    return units.pop() if len(units) == 1 else None
