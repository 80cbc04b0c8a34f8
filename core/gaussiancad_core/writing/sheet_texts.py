"""The texts of a sheet: from its file where that has them, else read from its pixels."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.files.vectors import VectorText
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet, Ink
from gaussiancad_core.sheet.line_conventions import FRAME
from gaussiancad_core.sheet.picture_noise import FAINT, PARALLEL
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.writing.numbers import parse_dimension
from gaussiancad_core.writing.ocr import ReadText, read_text

_SURE = 0.7
"""Least confidence of a text that counts."""

_STROKES = ("", "1")
"""What is read where there may be a mere stroke."""

MOST_TEXTS = 200
"""Texts of a sheet that are read, or asked what they measure, at most: more take too long."""

_LONG = 1.9
"""Ratio of a box's sides from which its text runs along the longer one."""

_BORDER = 2
"""px of paper around the picture of a text."""

_BELOW = 0.3
"""How far letters reach out of their box, in its height: commas below the line."""

_LARGEST_FIELD = 0.025
"""Share of the sheet that a field of the title block has at most; others are its border's."""

_SMALLEST_LETTER = 6
"""px of height under which nothing can be read."""

_TALLEST_LETTER = 0.04
"""Height of a line of text at most, as a share of the sheet's longest side."""


@dataclass(frozen=True)
class SheetText:
    """A line of text on a sheet.

    Attributes:
        text: the characters.
        box: px of the upright sheet.
        level: whether it runs along x; otherwise it runs up the sheet.
        confidence: 0 to 1.
        field: whether it stands in a field of the frame or title block, or in a cell of a table.
        exact: whether its characters are those of a file; others were read from pixels.
    """

    text: str
    box: Box
    level: bool = True
    confidence: float = 1.0
    field: bool = False
    exact: bool = False


def file_texts(
    texts: Iterable[VectorText], turn: Turn, fields: Sequence[Box]
) -> tuple[SheetText, ...]:
    """Level and upright texts of a vector file.

    Args:
        texts: of the file.
        turn: of the sheet.
        fields: of the title block, see :func:`fields_of`.
    """
    found = []
    for text in texts:
        angle = text.angle - turn.angle
        level = abs(np.sin(angle)) < PARALLEL
        if level or abs(np.cos(angle)) < PARALLEL:
            box = turn.box_to_upright(text.box)
            field = any(_holds(this_field, box) for this_field in fields)
            found.append(SheetText(text.text.strip(), box, bool(level), field=field, exact=True))
    return tuple(found)


def fields_of(marks: Iterable[Mark], pixels: int) -> list[Box]:
    """Fields of the title block among the marks of a sheet of so many pixels."""
    boxes = (mark.box for mark in marks if mark.kind is AnnotationKind.TITLE_BLOCK)
    return [
        box for box in boxes if (box[2] - box[0]) * (box[3] - box[1]) <= _LARGEST_FIELD * pixels
    ]


def framed(
    texts: Iterable[SheetText], marks: Iterable[Mark], shape: tuple[int, int]
) -> tuple[SheetText, ...]:
    """The texts, those in the margin of the sheet as fields: there stand the letters and numbers of
    its zones (ISO 5457).

    Args:
        texts: of the sheet.
        marks: found on it.
        shape: height and width of the sheet in px.
    """
    within = _inner_frame(marks, shape)
    return tuple(text if _holds(within, text.box) else replace(text, field=True) for text in texts)


def _inner_frame(marks: Iterable[Mark], shape: tuple[int, int]) -> Box:
    """The area within the innermost lines of a frame; the whole sheet where there is none."""
    found = [0.0, 0.0, float(shape[1]), float(shape[0])]
    for mark in marks:
        if mark.kind is not AnnotationKind.FRAME or mark.line is None:
            continue
        ends = np.array(mark.line)
        for across in (0, 1):
            long = float(np.ptp(ends[:, 1 - across])) >= FRAME * shape[across]
            if long and float(np.ptp(ends[:, across])) <= PARALLEL * shape[across]:
                at, size = float(ends[:, across].mean()), shape[1 - across]
                if at < size / 2.0:
                    found[across] = max(found[across], at)
                else:
                    found[across + 2] = min(found[across + 2], at)
    x0, y0, x1, y1 = found
    return x0, y0, x1, y1


def _holds(field: Box, box: Box) -> bool:
    x, y = 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])
    return field[0] <= x <= field[2] and field[1] <= y <= field[3]


def pixel_texts(sheet: CleanSheet, marks: Sequence[Mark]) -> tuple[SheetText, ...]:
    """Texts read from the pixels of a sheet.

    Args:
        sheet: upright, with all of its ink.
        marks: found on it; those of texts and of the title block are read.
    """
    boxes = [mark.box for mark in marks if mark.kind is AnnotationKind.TEXT]
    written = sorted(filter(_is_readable, boxes), key=_thickness, reverse=True)
    found = [_read(sheet, box) for box in written[:MOST_TEXTS]]
    lines = [
        line for field in fields_of(marks, sheet.ink.size) for line in _lines_of(sheet.ink, field)
    ]
    for box in lines[: MOST_TEXTS - len(found)]:
        read = read_text(_picture(sheet, box))
        found.append(SheetText(read.text, box, True, read.confidence, field=True))
    return tuple(text for text in found if text.text not in _STROKES and text.confidence >= _SURE)


def _thickness(box: Box) -> float:
    return min(box[2] - box[0], box[3] - box[1])


def _is_readable(box: Box) -> bool:
    """Whether letters of a box's size can be read."""
    return max(box[2] - box[0], box[3] - box[1]) >= _SMALLEST_LETTER


def _read(sheet: CleanSheet, box: Box) -> SheetText:
    """Read a text that is level or runs up the sheet."""
    picture = _picture(sheet, box)
    upright = np.ascontiguousarray(np.rot90(picture, -1))
    width, height = box[2] - box[0], box[3] - box[1]
    if width > _LONG * height:
        ways = {True: read_text(picture)}
    elif height > _LONG * width:
        # A single one is as narrow as a number that runs up the sheet.
        ways = {False: read_text(upright), True: read_text(picture)}
    else:
        ways = {True: read_text(picture), False: read_text(upright)}
    level = max(ways, key=lambda way: _credit(ways[way]))
    return SheetText(ways[level].text, box, level, ways[level].confidence)


def _credit(read: ReadText) -> tuple[bool, float]:
    """How good a reading is: sure numbers first."""
    number = parse_dimension(read.text) is not None
    return number and read.confidence >= _SURE, read.confidence


def _picture(sheet: CleanSheet, box: Box) -> npt.NDArray[np.float32]:
    """(h, w) the letters in a box, cut out closely."""
    part, _ = _letters(sheet, box)
    rows, columns = np.nonzero(part > FAINT)
    if not len(rows):
        return part
    part = part[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    around = cv2.copyMakeBorder(part, *4 * (_BORDER,), cv2.BORDER_CONSTANT)
    return np.asarray(around, dtype=np.float32)


def _letters(sheet: CleanSheet, box: Box) -> tuple[npt.NDArray[np.float32], tuple[int, int]]:
    """The ink of the letters in a box, and the column and row where it starts.

    Commas reach below the box; lines pass through it or beside it.
    """
    height, width = sheet.weight.shape
    reach = max(_BORDER, round(_BELOW * _thickness(box)))
    x0, y0 = (max(0, int(np.floor(value)) - reach) for value in box[:2])
    x1 = min(width, int(np.ceil(box[2])) + reach)
    y1 = min(height, int(np.ceil(box[3])) + reach)
    part = sheet.weight[y0:y1, x0:x1]
    _, labels = cv2.connectedComponents((part > FAINT).astype(np.uint8), connectivity=8)
    passing = np.unique(np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]]))
    values = np.unique(labels[reach - 1 : 1 - reach, reach - 1 : 1 - reach])
    letters = np.isin(labels, np.setdiff1d(values, np.append(passing, 0)))
    near = cv2.dilate(letters.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    return np.where(near, part, np.float32(0.0)), (x0, y0)


def _lines_of(ink: Ink, field: Box) -> list[Box]:
    """Boxes of the lines of text in a field."""
    x0, y0, x1, y1 = (round(value) for value in field)
    inner = ink[y0 + 2 : y1 - 2, x0 + 2 : x1 - 2].astype(np.uint8)
    if not inner.any():
        return []
    reach = max(9, int(0.008 * max(ink.shape)))
    closed = cv2.dilate(inner, np.ones((1, 2 * (reach // 2) + 1), np.uint8))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    found = []
    for label in range(1, len(stats)):
        x, y, w, h = (int(value) for value in stats[label, :4])
        item = (labels[y : y + h, x : x + w] == label) & (inner[y : y + h, x : x + w] > 0)
        rows, columns = np.nonzero(item)
        width, height = int(np.ptp(columns)) + 1, int(np.ptp(rows)) + 1
        if not _SMALLEST_LETTER <= height <= _TALLEST_LETTER * max(ink.shape) or width < height:
            continue
        left, top = x0 + 2 + x + int(columns.min()), y0 + 2 + y + int(rows.min())
        found.append((float(left), float(top), float(left + width), float(top + height)))
    return found
