"""Where the letters of DXF texts stand; their widths are estimated, as fonts are not asked."""

import re
from dataclasses import dataclass

import numpy as np
from ezdxf.entities.mtext import MText
from ezdxf.entities.text import Text
from ezdxf.enums import TextEntityAlignment
from ezdxf.tools.text import fast_plain_mtext, plain_text

from gaussiancad_core.files.content import LONGEST_TEXT

_LETTER = 0.75
"""Mean width of a letter over its height, in the stroke fonts of CAD systems."""

_LINE_SPACING = 5.0 / 3.0
"""Distance of a paragraph's lines over the letters' height (DXF reference, MTEXT)."""

_LONGEST_PARAGRAPH = 20 * LONGEST_TEXT
"""Characters of a paragraph that are read, its format codes too: ezdxf takes these off in a time
that grows with their square."""

_SIGN_FONT = re.compile(r"\\F(?:am|ai)?gdt[^;{}\\]*;([^{}\\]*)", re.IGNORECASE)
"""Letters in a font of drawing signs, within an MTEXT."""

_SIGNS = str.maketrans({"n": "\u2300", "v": "\u2334", "w": "\u2335", "x": "\u21a7"})
"""What letters stand for in these fonts: diameter, counterbore, countersink, depth."""

_COLUMNS = {"LEFT": 0.0, "CENTER": 0.5, "MIDDLE": 0.5, "RIGHT": 1.0}
_ROWS = {"TOP": 1.0, "MIDDLE": 0.5, "BOTTOM": 0.0}


@dataclass(frozen=True)
class PlacedText:
    """A line of text in units of the drawing, y up.

    Attributes:
        text: the characters.
        centre: (2,).
        length, height: along and across its reading direction.
        angle: radians, counter-clockwise.
    """

    text: str
    centre: tuple[float, float]
    length: float
    height: float
    angle: float


def placed_text(text: Text) -> list[PlacedText]:
    """A TEXT or ATTRIB entity; nothing if it is blank.

    Raises:
        ValueError: its place or size is no finite number.
    """
    content = plain_text(text.dxf.text[:LONGEST_TEXT]).strip()
    align, first, second = text.get_placement()
    height = float(text.dxf.height)
    length = _LETTER * height * len(content) * float(text.dxf.get("width", 1.0))
    angle = np.radians(float(text.dxf.get("rotation", 0.0)))
    column, row = _anchor(align)
    if second is not None:
        # Fitted between two points.
        angle = float(np.arctan2(second.y - first.y, second.x - first.x))
        length = float(np.hypot(second.x - first.x, second.y - first.y)) or length
    points = text.ocs().to_wcs(first)
    return _lines([content], (points.x, points.y), (column, row), (length, height), float(angle))


def placed_paragraph(text: MText) -> list[PlacedText]:
    """The lines of an MTEXT entity.

    Raises:
        ValueError: its place or size is no finite number.
    """
    content = _SIGN_FONT.sub(
        lambda found: found[1].translate(_SIGNS), text.text[:_LONGEST_PARAGRAPH]
    )
    every = fast_plain_mtext(content, split=True)
    lines = [line.strip()[:LONGEST_TEXT] for line in every[:LONGEST_TEXT]]
    height = float(text.dxf.char_height)
    attachment = int(text.dxf.get("attachment_point", 1)) - 1
    anchor = ((attachment % 3) / 2.0, 1.0 - (attachment // 3) / 2.0)
    longest = _LETTER * height * max((len(line) for line in lines), default=0)
    angle = float(np.radians(text.get_rotation()))
    insert = text.dxf.insert
    spacing = height * _LINE_SPACING * float(text.dxf.get("line_spacing_factor", 1.0))
    return _lines(lines, (insert.x, insert.y), anchor, (longest, height), angle, spacing=spacing)


def _anchor(align: TextEntityAlignment) -> tuple[float, float]:
    """Where in its box a text is held: 0 is left and bottom, 1 right and top."""
    name = align.name
    row = next((value for word, value in _ROWS.items() if name.startswith(word)), 0.0)
    column = next((value for word, value in _COLUMNS.items() if name.endswith(word)), 0.0)
    return column, row


def _lines(
    lines: list[str],
    insert: tuple[float, float],
    anchor: tuple[float, float],
    size: tuple[float, float],
    angle: float,
    *,
    spacing: float = 0.0,
) -> list[PlacedText]:
    """Lines under each other, the block of them held at its anchor; blank ones left out."""
    longest, height = size
    if not np.isfinite((*insert, *size, angle, spacing)).all():
        raise ValueError("the place or size of a text is no finite number")
    along = np.array([np.cos(angle), np.sin(angle)])
    up = np.array([-along[1], along[0]])
    total = height + spacing * (len(lines) - 1)
    widest = max((len(line) for line in lines), default=1) or 1
    placed = []
    for index, line in enumerate(lines):
        length = longest * len(line) / widest
        x = (0.5 - anchor[0]) * length
        y = total * (1.0 - anchor[1]) - index * spacing - height / 2.0
        centre = np.array(insert) + x * along + y * up
        if line and height > 0.0:
            place = (float(centre[0]), float(centre[1]))
            placed.append(PlacedText(line, place, float(length), height, angle))
    return placed
