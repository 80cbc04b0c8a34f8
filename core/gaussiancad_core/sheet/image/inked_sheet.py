"""The ink of a sheet, and that of strokes alone."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.painting import paint
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.pale_strokes import mean_stroke_width

_INK = 0.3
"""Share of a pixel that painted strokes cover from which it is ink, about as in pictures."""

Ink = npt.NDArray[np.bool_]
"""(h, w), True where there is ink."""


@dataclass(frozen=True)
class CleanSheet:
    """The ink of a sheet.

    Attributes:
        ink: (h, w) bool, the thresholded strokes.
        weight: (h, w) float32 in 0..1, darkness relative to the ink's; for sub-pixel measuring.
        stroke_width: px, the mean over the sheet.
        turn: by which the sheet was turned back to be upright.
        dash_gap: px between dashes, of an upright sheet; 0 where they do not tell.
        hidden_odds: (h, w) float16, log-odds of a hidden line's ink against a visible one's; None
            where no labels told them.
    """

    ink: Ink
    weight: npt.NDArray[np.float32]
    stroke_width: float
    turn: Turn
    dash_gap: float = 0.0
    hidden_odds: npt.NDArray[np.float16] | None = None

    @property
    def picture(self) -> npt.NDArray[np.uint8]:
        """(h, w) uint8, the ink dark on white paper, upright."""
        return np.rint(255.0 * (1.0 - self.weight)).astype(np.uint8)


def painted_sheet(drawing: VectorDrawing, shape: tuple[int, int], turn: Turn) -> CleanSheet:
    """The ink of strokes alone, as if nothing else were drawn on the sheet.

    Args:
        drawing: in px of the upright sheet.
        shape: height and width of the sheet, px.
        turn: of the sheet.
    """
    grey = paint(drawing, shape[1], shape[0])
    weights = 1.0 - np.arange(256, dtype=np.float32) / np.float32(255.0)
    weight, ink = weights[grey], (weights > _INK)[grey]
    width = mean_stroke_width(ink, weight) if ink.any() else 0.0
    return CleanSheet(ink, weight, width, turn)
