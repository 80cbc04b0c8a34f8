"""Texts as pixels."""

import random
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw

from learning.sheets.canvas import SUPERSAMPLING
from learning.sheets.letter_fonts import HERSHEY, Fonts, has, opened

Bytes = npt.NDArray[np.uint8]

_SIZE = 1.38
"""Size of a font in heights of its capitals, about."""

_LOWEST = 6
"""Pixels of capitals at least."""

_SIMILAR = str.maketrans({"⌀": "Ø", "↧": "v", "⌴": "U", "⌵": "V", "√": "v"})
"""Letters that stand for signs which a font lacks."""

_ASCII = str.maketrans(
    {"⌀": "O", "°": "o", "±": "+", "↧": "v", "×": "x", "⌴": "U", "⌵": "v", "√": "v"}
)
"""The same in OpenCV's fonts, which have little else; a stroke is drawn through the O."""


@dataclass(frozen=True)
class Lettering:
    """How texts are lettered.

    Attributes:
        font: file of the font; None, one of OpenCV's.
        hershey: that one.
        pen: px of the lines of OpenCV's fonts.
        squeeze: width of letters in usual widths.
        shaking: of the hand, in heights; 0, a machine letters.
    """

    font: Path | None
    hershey: int
    pen: float
    squeeze: float = 1.0
    shaking: float = 0.0


def random_lettering(chance: random.Random, fonts: Fonts, height: float, pen: float) -> Lettering:
    """Some font.

    Args:
        chance: says which.
        fonts: to choose from.
        height: px of capitals.
        pen: px of lines.
    """
    font = None if chance.random() < 0.3 else fonts.any(chance)
    return Lettering(
        font,
        chance.choice(HERSHEY),
        max(0.6, min(pen, height / 5.5)),
        chance.choice([1.0, 1.0, chance.uniform(0.65, 1.1)]),
        chance.uniform(0.03, 0.1) if chance.random() < 0.12 else 0.0,
    )


def text_mask(text: str, height: float, lettering: Lettering) -> Bytes:
    """(h, w) ink of a text, 0 to 255, :data:`.SUPERSAMPLING` pixels a px.

    Args:
        text: one line.
        height: px of its capitals.
        lettering: how.
    """
    capitals = max(_LOWEST, round(height * SUPERSAMPLING))
    if lettering.shaking:
        steady = text_mask(text, height, replace(lettering, shaking=0.0))
        return _shaken(steady, lettering.shaking * capitals)
    if lettering.font is None:
        pen = max(1, round(min(lettering.pen, height / 4.0) * SUPERSAMPLING))
        return _hershey_mask(text, capitals, lettering.hershey, pen)
    mask = _font_mask(text, max(8, int(capitals * _SIZE)), lettering.font)
    if lettering.squeeze != 1.0:
        width = max(2, int(mask.shape[1] * lettering.squeeze))
        narrow = cv2.resize(mask, (width, mask.shape[0]), interpolation=cv2.INTER_AREA)
        mask = np.asarray(narrow, dtype=np.uint8)
    return mask


def _font_mask(text: str, size: int, path: Path) -> Bytes:
    """In a TrueType font; rows without ink are left out."""
    text = "".join(name if has(path, name) else name.translate(_SIMILAR) for name in text)
    font = opened(path, size)
    _, _, width, height = font.getbbox(text)
    image = Image.new("L", (max(1, int(width) + 4), max(1, int(height) + 4)))
    ImageDraw.Draw(image).text((1, 1), text, fill=255, font=font)
    mask = np.asarray(image)
    rows = np.flatnonzero(mask.any(axis=1))
    return mask[rows[0] : rows[-1] + 1] if len(rows) else mask


def _hershey_mask(text: str, capitals: int, face: int, pen: int) -> Bytes:
    """In one of OpenCV's fonts."""
    scale = capitals / cv2.getTextSize("H", face, 1.0, 1)[0][1]
    plain = text.translate(_ASCII).encode("ascii", "replace").decode()
    (width, height), below = cv2.getTextSize(plain, face, scale, pen)
    mask = np.zeros((height + below + 2 * pen + 2, width + 2 * pen + 2), np.uint8)
    foot = height + pen
    cv2.putText(mask, plain, (pen, foot), face, scale, 255, pen, cv2.LINE_AA)
    over = capitals // 8
    for place, character in enumerate(text):
        if character == "⌀":
            left = pen + cv2.getTextSize(plain[:place], face, scale, pen)[0][0]
            right = left + cv2.getTextSize("O", face, scale, pen)[0][0]
            ends = (left, foot + over), (right, foot - capitals - over)
            cv2.line(mask, *ends, 255, pen, cv2.LINE_AA)
    return mask


def _shaken(mask: Bytes, amount: float) -> Bytes:
    """Smoothly bent by so many pixels, the same text always alike."""
    mask = np.pad(mask, int(amount * 2) + 2)
    height, width = mask.shape
    rng = np.random.default_rng([height, width])
    knots = max(2, int(1.5 * width / height) + 2)
    rows, columns = np.mgrid[0:height, 0:width].astype(np.float32)
    right, down = (
        amount * cv2.resize(item, (width, height), interpolation=cv2.INTER_CUBIC)
        for item in rng.standard_normal((2, 3, knots)).astype(np.float32)
    )
    bent = cv2.remap(mask, columns + right, rows + down, cv2.INTER_LINEAR)
    return np.asarray(bent, dtype=np.uint8)
