"""Strokes of a sheet, each with what it stands for as far as anybody has said, and who said so."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet_model.paper_sheet import PaperStroke

Flags = npt.NDArray[np.bool_]


class Label(Enum):
    """What a stroke stands for."""

    OPEN = "open"
    EDGE = "edge"
    HIDDEN = "hidden"
    CENTRE = "centre"
    HATCH = "hatch"
    DIMENSION = "dimension"
    EXTENSION = "extension"
    ARROW = "arrow"
    TEXT = "text"
    FRAME = "frame"
    TABLE = "table"
    DASH = "dash"
    """A piece of a dashed line that another stroke stands for."""
    OTHER = "other"


@dataclass(frozen=True, eq=False)
class LabelledStrokes:
    """Strokes with their labels.  A mechanism takes one of these and returns the next.

    Attributes:
        strokes: in the order of the file, those put together from others after them.
        labels: of each.
        reasons: which mechanism said so, for whoever asks why; empty of what is open.
    """

    strokes: tuple[PaperStroke, ...]
    labels: tuple[Label, ...]
    reasons: tuple[str, ...]

    @classmethod
    def open(cls, strokes: Sequence[PaperStroke]) -> "LabelledStrokes":
        """Strokes of which nothing is said yet."""
        return cls(tuple(strokes), (Label.OPEN,) * len(strokes), ("",) * len(strokes))

    def numbers(self, *labels: Label) -> list[int]:
        """Numbers of the strokes that have one of some labels."""
        return [number for number, label in enumerate(self.labels) if label in labels]

    def of(self, *labels: Label) -> list[PaperStroke]:
        """The strokes that have one of some labels."""
        return [self.strokes[number] for number in self.numbers(*labels)]

    def with_label(self, numbers: Iterable[int], label: Label, reason: str) -> "LabelledStrokes":
        """The same with a label for some strokes, whatever was said of these."""
        labels, reasons = list(self.labels), list(self.reasons)
        for number in numbers:
            labels[number], reasons[number] = label, reason
        return replace(self, labels=tuple(labels), reasons=tuple(reasons))

    def joined(
        self, pieces: Iterable[int], wholes: Sequence[PaperStroke], reason: str
    ) -> "LabelledStrokes":
        """The same with whole strokes, which are open, in place of the pieces of which they are."""
        found = self.with_label(pieces, Label.DASH, reason)
        return LabelledStrokes(
            (*found.strokes, *wholes),
            (*found.labels, *(Label.OPEN for _ in wholes)),
            (*found.reasons, *("" for _ in wholes)),
        )
