"""The deviation as a picture: the result in its colours beside their scale."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.deviation import Deviation, diverging_colours
from gaussiancad_core.pictures.picture_letters import put_text, text_image
from gaussiancad_core.pictures.preview import PreviewSize, render_preview

Image = npt.NDArray[np.uint8]

_SIZE = PreviewSize(1040, 900)
_PANEL = 220
_BAR = (48, 150, 600)
"""Width of the colour bar, its upper end and its height, px."""

_LETTERS = 20


def deviation_picture(deviation: Deviation) -> Image:
    """(900, 1260, 3) RGB: the coloured result, and which colour is how many mm."""
    part = render_preview(deviation.mesh, deviation.colours, _SIZE)
    panel = np.empty((part.shape[0], _PANEL, 3), dtype=np.uint8)
    panel[:] = part[0, 0]
    width, top, height = _BAR
    lowest = -1.0 if deviation.signed else 0.0
    values = np.linspace(1.0, lowest, height)
    panel[top : top + height, :width] = diverging_colours(values)[:, None]
    put_text(panel, text_image("deviation, mm", _LETTERS), 0, top - 3 * _LETTERS)
    for share in np.linspace(0.0, 1.0, 5):
        row = top + round(share * (height - 1))
        value = deviation.limit * (1.0 + share * (lowest - 1.0))
        panel[row - 1 : row + 1, width : width + 8] = 60
        label = text_image(_label(value, deviation.signed), _LETTERS)
        put_text(panel, label, width + 16, row - label.shape[0] // 2)
    notes = ("outside", "inside") if deviation.signed else ("away", "on it")
    for note, row in zip(notes, (top - 28, top + height + 12), strict=True):
        put_text(panel, text_image(note, _LETTERS), 0, row)
    return np.hstack([part, panel])


def _label(value: float, signed: bool) -> str:
    # Adding zero turns a negative zero into a positive one.
    return f"{value + 0.0:+.4g}" if signed and value else f"{abs(value):.4g}"
