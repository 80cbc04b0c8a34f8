"""Texts of a PDF page: objects of PDFium to lines of text in px.

Programs place words, or each letter, by themselves.  What stands on one base line, close to each
other, is one text.  Fonts of drawing signs hold them under letters, or without any code at all:
then the numbers of their glyphs come out as letters.
"""

import ctypes
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pypdfium2 as pdfium
from pypdfium2 import raw

from gaussiancad_core.files.vectors import VectorText
from gaussiancad_core.geometry.points import Box, to_point

Affine = npt.NDArray[np.float64]
"""(2, 3)"""

_WORD_GAP, _TEXT_GAP = 0.27, 0.56
"""Distances over the size of the letters: from here on words are apart, and texts."""

_SLACK = 0.2
"""The same by which neighbours may overlap, or be off one base line: smaller signs are set in its
middle.  Narrow letters are often told as wider than they are: they may overlap by more, but begin
by as much after the last letter."""

_SAME_DIRECTION = 1e-2
"""Radians."""

_SIGN_FONTS = (
    (
        # Of Autodesk for the signs of ISO 1101 and ISO 129-1: the letter, and the one with the
        # number of its glyph.
        re.compile(r"(?:^|\+)(?:AIGDT|AMGDT|AMGDTANS|GDT)(?:\b|$)", re.IGNORECASE),
        {
            "nP": "\u00d8",  # diameter
            "vX": "\u2334",  # counterbore
            "wY": "\u2335",  # countersink
            "xZ": "\u21a7",  # depth
            "oQ": "\u25a1",  # square
        },
    ),
    (
        # Of KOMPAS, at the places of letters of both code pages and of symbols.
        re.compile(r"(?:^|\+)Symbol[ _-]?type[ _-]?[AB]", re.IGNORECASE),
        {
            "\u00c7\u0417\uf0c7": "\u00d8",  # diameter
            "\u00c5\u0415\uf0c5": "\u00b0",  # degree
        },
    ),
)
"""Fonts of signs by their names, and the letters that stand for these."""


@dataclass(frozen=True)
class TextPiece:
    """What a page places at once.

    Attributes:
        text: its characters.
        origin: (2,) px, on the base line.
        last: (2,) px, where its last letter begins on the base line.
        size: px of the font.
        span: px along the base line, from where it begins to where it ends; slanted letters reach
            beyond.
        angle: radians from x towards y, of that direction.
        box: px, around it.
    """

    text: str
    origin: tuple[float, float]
    last: tuple[float, float]
    size: float
    span: tuple[float, float]
    angle: float
    box: Box


Origins = Mapping[int, npt.NDArray[np.float64]]
"""By the address of a text object: (n, 2) px where its letters begin on the base line."""


def letter_origins(page: pdfium.PdfTextPage, to_pixels: Affine) -> Origins:
    """Where the letters of each text object of a page begin.

    Args:
        page: the texts.
        to_pixels: (2, 3) from the page to px.
    """
    found: dict[int, list[tuple[float, float]]] = {}
    x, y = ctypes.c_double(), ctypes.c_double()
    for index in range(max(raw.FPDFText_CountChars(page), 0)):
        item = raw.FPDFText_GetTextObject(page, index)
        if item and raw.FPDFText_GetCharOrigin(page, index, x, y):
            found.setdefault(address(item), []).append((x.value, y.value))
    linear, shift = to_pixels[:, :2], to_pixels[:, 2]
    return {item: np.array(places) @ linear.T + shift for item, places in found.items()}


def address(item: raw.FPDF_PAGEOBJECT) -> int:
    """What tells an object of a page from the others."""
    return ctypes.cast(item, ctypes.c_void_p).value or 0


def text_piece(
    page: pdfium.PdfTextPage,
    item: raw.FPDF_PAGEOBJECT,
    outer: Affine,
    values: Affine,
    letters: npt.NDArray[np.float64] | None = None,
) -> TextPiece | None:
    """A text object; None if it shows nothing.

    Args:
        page: that it stands on.
        item: the object.
        outer: (2, 3) from where the object is placed to px.
        values: (2, 3) from the text's own plane to px.
        letters: (n, 2) px, where its letters begin on the base line; None where that is not known.
    """
    text = _characters(page, item)
    quad = raw.FS_QUADPOINTSF()
    size = ctypes.c_float()
    placed = raw.FPDFPageObj_GetRotatedBounds(item, quad)
    if not text.strip() or not placed or not raw.FPDFTextObj_GetFontSize(item, size):
        return None
    corners = np.array([(getattr(quad, f"x{i}"), getattr(quad, f"y{i}")) for i in range(1, 5)])
    mapped = corners @ outer[:, :2].T + outer[:, 2]
    along, up = values[:, 0], values[:, 1]
    length = float(np.hypot(*along))
    if abs(along[0] * up[1] - along[1] * up[0]) <= 1e-9 * length * float(np.hypot(*up)):
        return None
    text = _with_signs(text, _font_name(item))
    # In the text's own plane letters stand upright, however they are slanted.
    upright = (mapped - values[:, 2]) @ np.linalg.inv(values[:, :2]).T
    reach = values[:, 2] @ (along / length) + upright[:, 0] * length
    last = values[:, 2]
    if letters is not None:
        last = letters[(letters @ along).argmax()]
    (x0, y0), (x1, y1) = mapped.min(axis=0), mapped.max(axis=0)
    return TextPiece(
        text,
        to_point(values[:, 2]),
        to_point(last),
        float(size.value * np.hypot(*up)),
        (float(reach.min()), float(reach.max())),
        float(np.arctan2(along[1], along[0])),
        (float(x0), float(y0), float(x1), float(y1)),
    )


def _with_signs(text: str, font: str) -> str:
    """A text in a font, with the signs that letters stand for in it."""
    for names, signs in _SIGN_FONTS:
        if names.search(font):
            letters = {
                ord(name): sign for own_letters, sign in signs.items() for name in own_letters
            }
            return text.translate(letters)
    return text


def _characters(page: pdfium.PdfTextPage, item: raw.FPDF_PAGEOBJECT) -> str:
    length = raw.FPDFTextObj_GetText(item, page, None, 0)
    if length < 4:
        return ""
    buffer = (ctypes.c_ushort * (length // 2))()
    raw.FPDFTextObj_GetText(item, page, buffer, length)
    return bytes(buffer).decode("utf-16-le", errors="replace").rstrip("\0")


def _font_name(item: raw.FPDF_PAGEOBJECT) -> str:
    font = raw.FPDFTextObj_GetFont(item)
    length = raw.FPDFFont_GetBaseFontName(font, None, 0) if font else 0
    if not length:
        return ""
    buffer = ctypes.create_string_buffer(length)
    raw.FPDFFont_GetBaseFontName(font, buffer, length)
    return buffer.value.decode("utf-8", errors="replace")


def joined_texts(pieces: Iterable[TextPiece]) -> list[VectorText]:
    """Lines of text, of pieces in the page's order."""
    lines: list[TextPiece] = []
    for piece in pieces:
        last = lines[-1] if lines else None
        gap = None if last is None else _gap(last, piece)
        if last is None or gap is None:
            lines.append(piece)
            continue
        low = np.minimum(last.box[:2], piece.box[:2])
        high = np.maximum(last.box[2:], piece.box[2:])
        space = " " if gap > _WORD_GAP else ""
        lines[-1] = TextPiece(
            last.text + space + piece.text,
            last.origin,
            piece.last,
            max(last.size, piece.size),
            (min(last.span[0], piece.span[0]), max(last.span[1], piece.span[1])),
            last.angle,
            (*to_point(low), *to_point(high)),
        )
    return [VectorText(" ".join(line.text.split()), line.box, line.angle) for line in lines]


def _gap(last: TextPiece, piece: TextPiece) -> float | None:
    """Distance to the next piece over the letters' size; None if it is no continuation."""
    if abs(2.0 * np.sin((last.angle - piece.angle) / 2.0)) > _SAME_DIRECTION:
        return None
    size = max(last.size, piece.size)
    across = np.array([-np.sin(last.angle), np.cos(last.angle)])
    off = abs(float(np.subtract(piece.origin, last.origin) @ across))
    gap = piece.span[0] - last.span[1]
    if size <= 0.0 or off > _SLACK * size or gap > _TEXT_GAP * size:
        return None
    along = np.array([np.cos(last.angle), np.sin(last.angle)])
    ahead = float(np.subtract(piece.origin, last.last) @ along)
    if gap < -_SLACK * size and ahead < _SLACK * size:
        return None
    return gap / size
