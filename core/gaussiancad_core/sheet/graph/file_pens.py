"""The pens of a sheet, and which of them draws the part.

A pen is a colour and a width, and a layer where the file has layers.  That of the part is told once
for the whole sheet, by evidence: its strokes meet others of it at both ends, as edges do, and the
ends of dimensions, centre lines and leaders do not; and it is the wide one (ISO 128-2).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.files.vectors import Colour, StrokeKind, StrokeRole, VectorStroke
from gaussiancad_core.sheet.graph.touching_ends import Flags, Ints, Touches
from gaussiancad_core.sheet.votes import NEARLY_ALL

_ALIKE = 1.1
"""Ratio of widths up to which they are one pen's."""

_EDGES = (StrokeKind.GEOMETRY, StrokeKind.BLOCK)
"""Kinds of strokes that may be edges, as the file tells."""


@dataclass(frozen=True)
class Pen:
    """What strokes look like.

    Attributes:
        width: px; None where the file does not say.
        colour: red, green, blue; None where the file does not say.
        layer: its name, empty where there is none.
    """

    width: float | None
    colour: Colour | None
    layer: str


@dataclass(frozen=True)
class PenEvidence:
    """What a pen draws.

    Attributes:
        pen: it.
        length: px of solid strokes.
        closed: share of that of strokes that meet others of the pen at both ends.
    """

    pen: Pen
    length: float
    closed: float

    @property
    def closes_outlines(self) -> bool:
        """Whether it draws nothing else; outlines of filled shapes have no width."""
        return self.closed >= NEARLY_ALL and self.pen.width != 0.0

    @property
    def weight(self) -> float:
        """How much speaks for the part's pen: px^2 of ink that closes outlines."""
        return self.closed**2 * self.length * (self.pen.width or 1.0)


def pens_of(strokes: Sequence[VectorStroke]) -> tuple[tuple[Pen, ...], Ints]:
    """The pens of strokes, and (n,) the number of each stroke's pen."""
    widths = sorted({stroke.width for stroke in strokes if stroke.width is not None})
    usual: dict[float | None, float | None] = {None: None}
    last = 0.0
    for width in widths:
        last = last if last > 0.0 and width <= _ALIKE * last else width
        usual[width] = last
    keys = [Pen(usual[stroke.width], stroke.colour, stroke.layer) for stroke in strokes]
    pens = tuple(dict.fromkeys(keys))
    numbers = {pen: number for number, pen in enumerate(pens)}
    return pens, np.array([numbers[key] for key in keys], dtype=np.int64)


def may_be_edge(stroke: VectorStroke) -> bool:
    """Whether the file does not say that a stroke is something else than a visible edge."""
    is_given = stroke.role in (StrokeRole.VISIBLE, StrokeRole.UNKNOWN)
    return stroke.is_solid and is_given and stroke.kind in _EDGES


def evidence(
    strokes: Sequence[VectorStroke],
    pens: Sequence[Pen],
    numbers: Ints,
    touches: Touches,
    candidates: Flags,
) -> list[PenEvidence]:
    """What each pen draws.

    Args:
        strokes: of the sheet.
        pens: of these.
        numbers: (n,) of each stroke's pen.
        touches: of the strokes.
        candidates: (n,) which strokes may be edges.
    """
    lengths = np.array([stroke.curve.length for stroke in strokes])
    closed = touches.closed
    found = []
    for number, pen in enumerate(pens):
        item = candidates & (numbers == number)
        meets = item & (closed | touches.met(item).all(axis=1))
        total = float(lengths[item].sum())
        found.append(PenEvidence(pen, total, float(lengths[meets].sum()) / max(total, 1e-9)))
    return found


def other_layers(
    pens: Sequence[Pen], numbers: Ints, best: int, touches: Touches, candidates: Flags
) -> list[int]:
    """Pens that draw the part, too: they look as its pen does but for the layer, and close outlines
    with it.

    Args:
        pens: of the sheet.
        numbers: (n,) of each stroke's pen.
        best: the number of the part's pen.
        touches: of the strokes.
        candidates: (n,) which strokes may be edges.
    """
    part = candidates & (numbers == best)
    look = pens[best].width, pens[best].colour
    found = []
    for number, pen in enumerate(pens):
        item = candidates & (numbers == number)
        if number == best or (pen.width, pen.colour) != look or not item.any():
            continue
        meets = touches.closed | touches.met(item | part).all(axis=1)
        if meets[item].mean() >= NEARLY_ALL:
            found.append(number)
    return found
