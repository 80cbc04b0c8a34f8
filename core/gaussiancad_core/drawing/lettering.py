"""Text in ink: Pillow's own scalable font, and a diameter sign, which it lacks.

Letters are drawn several times as large as asked, then turned and averaged down, so that they have
the same grey edges as the lines.
"""

import re
from functools import lru_cache

import cv2
import numpy as np
import numpy.typing as npt
from PIL import Image as PillowImage
from PIL import ImageDraw, ImageFont

from gaussiancad_core.drawing.annotation import Label, Point

DIAMETER = "\u00d8"

_SIGNS = (DIAMETER, "\u00b0")

_FINE = 4
"""Pixels of the drawn letters in one of the sheet, each way."""

_CAPITALS = 0.7
"""Height of the font's capitals as a share of its size."""

_SIGN = 1.0
"""Width of the diameter sign as a share of the capitals' height."""


def label(text: str, centre: Point, height: float, angle: float = 0.0) -> Label:
    """A label of its true width; characters that the font lacks become question marks."""
    plain = "".join(c if c in _SIGNS or " " <= c <= "~" else "?" for c in text)
    return Label(plain, centre, height, text_width(plain, height), angle)


def text_width(text: str, height: float) -> float:
    """Width in px of a text whose capitals are ``height`` px high."""
    total = 0.0
    for piece in _pieces(text):
        total += _SIGN if piece == DIAMETER else _font(100).getlength(piece) / 100.0 / _CAPITALS
    return float(total * height)


def ink_label(ink: npt.NDArray[np.float32], written: Label) -> None:
    """Write a label into (h, w) ink, 0 to 1, in place; what leaves the sheet is cut off."""
    letters = _letters(written)
    reach = int(np.ceil(np.hypot(*letters.shape) / _FINE / 2.0)) + 2
    x0, y0 = (int(np.floor(value)) - reach for value in written.centre)
    side = 2 * reach + 1
    cosine, sine = np.cos(written.angle), np.sin(written.angle)
    turn = np.array([[cosine, -sine], [sine, cosine]])
    # Both images count from the corner of their first pixel, OpenCV from its centre.
    from_middle = np.array([letters.shape[1] / 2.0, letters.shape[0] / 2.0]) - 0.5
    to_middle = (np.array(written.centre) - (x0, y0)) * _FINE - 0.5
    shift = to_middle - turn @ from_middle
    size = (side * _FINE, side * _FINE)
    fine = cv2.warpAffine(letters, np.column_stack([turn, shift]), size)
    coarse = cv2.resize(fine, (side, side), interpolation=cv2.INTER_AREA)
    height, width = ink.shape
    left, top = max(0, x0), max(0, y0)
    right, bottom = min(width, x0 + side), min(height, y0 + side)
    if left < right and top < bottom:
        area = ink[top:bottom, left:right]
        np.maximum(area, coarse[top - y0 : bottom - y0, left - x0 : right - x0], out=area)


def _letters(written: Label) -> npt.NDArray[np.float32]:
    """The text upright, ``_FINE`` times as large; its middle is the middle of the image."""
    height = written.height * _FINE
    font = _font(height / _CAPITALS)
    width = int(np.ceil(written.width * _FINE)) + 2 * _FINE
    # Room for letters that reach below the line, and as much above.
    rows = 2 * int(np.ceil(height))
    image = PillowImage.new("L", (width, rows))
    draw = ImageDraw.Draw(image)
    base = (rows + height) / 2.0
    at = (width - written.width * _FINE) / 2.0
    for piece in _pieces(written.text):
        if piece == DIAMETER:
            _draw_sign(draw, at, base, height)
            at += _SIGN * height
        else:
            draw.text((at, base), piece, fill=255, font=font, anchor="ls")
            at += font.getlength(piece)
    return np.asarray(image, dtype=np.float32) / 255.0


def _draw_sign(draw: ImageDraw.ImageDraw, left: float, base: float, height: float) -> None:
    """A circle with a slash (ISO 3098-2)."""
    width = max(1, round(0.1 * height))
    x, y = left + 0.45 * height, base - 0.5 * height
    radius = 0.36 * height
    draw.ellipse((x - radius, y - radius, x + radius, y + radius), outline=255, width=width)
    dx, dy = 0.30 * height, 0.5 * height
    draw.line((x - dx, y + dy, x + dx, y - dy), fill=255, width=width)


def _pieces(text: str) -> list[str]:
    """The text cut before and after each diameter sign."""
    return [piece for piece in re.split(f"({DIAMETER})", text) if piece]


@lru_cache(maxsize=16)
def _font(size: float) -> ImageFont.FreeTypeFont:
    font = ImageFont.load_default(size)
    assert isinstance(font, ImageFont.FreeTypeFont)
    return font
