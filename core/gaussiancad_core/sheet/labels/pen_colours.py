"""What the colour of a line says where a sheet has pens of several colours.

Which pen draws the part is learnt from the lines that the network is sure of: a pen whose sure
lines are all edges draws edges elsewhere, too.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.log_odds import SURE
from gaussiancad_core.sheet.picture_noise import COARSE_STEP

Floats = npt.NDArray[np.float64]
Tints = npt.NDArray[np.uint8]
"""(h, w) hue + 1 of coloured ink, 0 elsewhere."""

_HUES, _PENS = 180, 12
"""Hues that a tint tells, and coloured pens that are told apart."""

_LEAST = 60.0
"""Length of a pen's sure lines from which they tell what it draws, in stroke widths."""


@dataclass(frozen=True, eq=False)
class ColourPens:
    """The pens of a coloured sheet.

    Attributes:
        pens: (h, w) number of the pen of each pixel, 0 for ink without colour.
        odds_of: log-odds of the part of each pen.
    """

    pens: npt.NDArray[np.uint8]
    odds_of: Floats

    def odds(self, shape: InkedShape, run: InkedRun, log_p: Floats) -> Floats:
        """(n,) log-odds of the part at the points of a run, those of its pen.

        Args:
            shape: line or circle.
            run: of it.
            log_p: (n, classes) of the points.
        """
        return np.full(len(log_p), self.odds_of[_pen_of(self.pens, shape, run)])


def learnt_colours(
    tint: Tints,
    shapes: Sequence[InkedShape],
    labelled: Sequence[Sequence[LabelledRun]],
    stroke_width: float,
) -> ColourPens | None:
    """The pens of a sheet by their colours; None where its sure lines are of one colour.

    Args:
        tint: of the upright sheet.
        shapes: lines and circles.
        labelled: the pieces of each.
        stroke_width: px.
    """
    step = _HUES // _PENS
    # The first pen's hues lie around red, where the circle of hues is cut open.
    hues = (tint.astype(int) - 1 + step // 2) % _HUES // step
    pens = np.where(tint > 0, hues + 1, 0).astype(np.uint8)
    part, rest = np.zeros(_PENS + 1), np.zeros(_PENS + 1)
    for shape, pieces in zip(shapes, labelled, strict=True):
        for piece in pieces:
            if abs(piece.margin) >= SURE:
                into = part if piece.is_part else rest
                into[_pen_of(pens, shape, piece.run)] += piece.run.run.length
    sure = part + rest
    known = sure >= _LEAST * stroke_width
    if known.sum() < 2:
        return None
    share = np.divide(part, sure, out=np.full(len(sure), 0.5), where=sure > 0)
    return ColourPens(pens, np.where(known, SURE * (2.0 * share - 1.0), 0.0))


def _pen_of(pens: npt.NDArray[np.uint8], shape: InkedShape, run: InkedRun) -> int:
    """The pen that most of a run is drawn with."""
    seen = values_at(pens, points_along(shape.geometry, run.run, COARSE_STEP))
    return int(np.bincount(seen, minlength=_PENS + 1).argmax())
