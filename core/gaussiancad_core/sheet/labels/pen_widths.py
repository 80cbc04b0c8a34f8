"""What the width of a line says where a sheet has two pens: thin lines are no visible edges.

The pens are learnt from the lines that the network is sure of.  Along a line the width tells where
an edge ends and an extension line goes on.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.line_conventions import THIN
from gaussiancad_core.sheet.log_odds import SURE
from gaussiancad_core.sheet.tracing.line_widths import run_width, widths_along

Floats = npt.NDArray[np.float64]

_LONG = 7.0
"""Length of a line from which its width is believed, in stroke widths."""

_LEAST = 4
"""Lines of each pen at least."""

_MOST = 80.0
"""Per cent of the thin lines that are thinner than as many of the thick ones."""

_THIN = (InkClass.DIMENSION, InkClass.CENTRE)
"""What is drawn with the thin pen, if there is one."""


@dataclass(frozen=True, eq=False)
class Pens:
    """The pens of a sheet.

    Attributes:
        sheet: with its ink.
        thick: width in px of visible edges.
        thin: of dimensions and centre lines.
    """

    sheet: CleanSheet
    thick: float
    thin: float

    def odds(self, shape: InkedShape, run: InkedRun, log_p: Floats) -> Floats:
        """(n,) log-odds of the part at the points of a run, from its width at each of them.

        A hidden line may be thin, so that a thin one speaks against the part only as far as it
        would be visible.

        Args:
            shape: line or circle.
            run: of it.
            log_p: (n, classes) of the points.
        """
        widths = widths_along(self.sheet, shape.geometry, run.run)
        known = np.isfinite(widths)
        if known.sum() < 2:
            return np.zeros(len(log_p))
        at = np.linspace(0.0, 1.0, len(widths))
        along = np.interp(np.linspace(0.0, 1.0, len(log_p)), at[known], widths[known])
        seen = np.interp(np.linspace(0.0, 1.0, len(log_p)), at, known.astype(float))
        middle, half = 0.5 * (self.thick + self.thin), 0.5 * (self.thick - self.thin)
        stated = SURE * np.clip((along - middle) / half, -1.0, 1.0) * seen
        visible = 1.0 / (1.0 + np.exp(log_p[:, InkClass.HIDDEN] - log_p[:, InkClass.VISIBLE]))
        return np.where(stated < 0.0, stated * visible, stated)


def learnt_pens(
    sheet: CleanSheet, shapes: Sequence[InkedShape], labelled: Sequence[Sequence[LabelledRun]]
) -> Pens | None:
    """The pens of a sheet; None where its lines are of one width.

    Where no line is sure, the widths part two pens by themselves.

    Args:
        sheet: the ink.
        shapes: its lines and circles.
        labelled: the pieces of each.
    """
    thick: list[float] = []
    thin: list[float] = []
    for shape, pieces in zip(shapes, labelled, strict=True):
        for piece in pieces:
            known = abs(piece.margin) >= SURE and piece.run.run.length >= _LONG * sheet.stroke_width
            if known and piece.ink in (InkClass.VISIBLE, *_THIN):
                width = run_width(sheet, shape.geometry, piece.run.run)
                (thick if piece.is_part else thin).append(width)
    if not thick and not thin:
        thick, thin = _by_width_alone(sheet, shapes)
    thick, thin = ([value for value in each if np.isfinite(value)] for each in (thick, thin))
    if min(len(thick), len(thin)) < _LEAST:
        return None
    wide, narrow = float(np.median(thick)), float(np.median(thin))
    apart = np.percentile(thin, _MOST) < np.percentile(thick, 100.0 - _MOST)
    return Pens(sheet, wide, narrow) if apart and narrow <= THIN * wide else None


def _by_width_alone(
    sheet: CleanSheet, shapes: Sequence[InkedShape]
) -> tuple[list[float], list[float]]:
    """Widths in px of the long lines of two pens, the wide one's first: parted where that leaves
    the least variance within both (Otsu 1979)."""
    widths = np.sort(
        [
            run.width
            for shape in shapes
            for run in shape.runs
            if run.width is not None and run.run.length >= _LONG * sheet.stroke_width
        ]
    )
    if len(widths) < 2 * _LEAST:
        return [], []
    cuts = range(_LEAST, len(widths) - _LEAST + 1)
    cut = min(cuts, key=lambda k: k * widths[:k].var() + (len(widths) - k) * widths[k:].var())
    return widths[cut:].tolist(), widths[:cut].tolist()
