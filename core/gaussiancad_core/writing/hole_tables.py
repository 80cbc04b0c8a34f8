"""Hole tables: rows of a label, two coordinates, a diameter and a depth (ASME Y14.5, ISO 129-1).

A row is a call-out of the holes that carry its label in a view.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, log

import numpy as np

from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.writing.callout_words import DEPTH, in_signs
from gaussiancad_core.writing.callouts import NoteKind, parse_callout
from gaussiancad_core.writing.dimension_layout import ALONG
from gaussiancad_core.writing.numbers import DECIMAL, plain_text
from gaussiancad_core.writing.ruled_cells import Table
from gaussiancad_core.writing.sheet_texts import SheetText

_LABEL = re.compile(r"[^\W\d_]{1,2}\d{0,3}|\d{1,3}")
"""A hole's name: letters, a number, or both."""

_NUMBER = re.compile(rf"[+-]?{DECIMAL}")

_DIAMETER = re.compile(
    r"\u00d8|\bDIA|\bSIZE\b|DURCHM|DIAM|\u0434\u0438\u0430\u043c|\u76f4\u5f84|\u5b54\u5f84",
    re.IGNORECASE,
)
"""What a column of bare diameters is called."""

_ALIKE = 0.03
"""Logarithm of the ratio of two diameters that are one at most."""

_HOLES = (NoteKind.DIAMETER, NoteKind.THREAD)


@dataclass(frozen=True)
class HoleRow:
    """A row of a hole table.

    Attributes:
        label: of its holes.
        text: its call-out, with the box around its cells.
        diameter: of the holes, in the table's unit; None where it tells none.
    """

    label: str
    text: SheetText
    diameter: float | None = None


def hole_rows(table: Table) -> tuple[HoleRow, ...]:
    """The rows of a table that speak of holes; none of a table of something else."""
    heads = [plain_text(" ".join(text.text for text in cell)) for cell in table.rows[0]]
    return tuple(row for cells in table.rows if (row := _hole_row(cells, heads)) is not None)


def labelled_circles(
    rows: Sequence[HoleRow], texts: Sequence[SheetText], arcs: Sequence[Arc]
) -> dict[Box, tuple[Arc, ...]]:
    """The circles that carry the labels of rows, by the boxes of these.

    Of the circles near a label the nearest is meant whose size fits the scale on which the
    diameters of most rows agree.

    Args:
        rows: of the tables of a sheet.
        texts: of the sheet, those in tables apart.
        arcs: of the views, px of the upright sheet.
    """
    circles = [arc for arc in arcs if arc.is_full]
    near = [
        (row, _near(text, circles))
        for row in rows
        for text in texts
        if not text.field and plain_text(text.text).upper() == row.label
    ]
    scale = _commonest_scale(near)
    found: dict[Box, tuple[Arc, ...]] = {row.text.box: () for row in rows}
    for row, around in near:
        fitting = [arc for arc in around if _fits(row, arc, scale)] or around
        found[row.text.box] += tuple(fitting[:1])
    return found


def _near(text: SheetText, circles: Sequence[Arc]) -> list[Arc]:
    """The circles that a text may stand at, the nearest first."""
    reach = ALONG * (text.box[3] - text.box[1])
    x0, y0, x1, y1 = text.box
    apart = []
    for circle in circles:
        x, y = circle.centre
        away = hypot(max(x0 - x, x - x1, 0.0), max(y0 - y, y - y1, 0.0)) - circle.radius
        if abs(away) <= reach:
            apart.append((abs(away), circle))
    return [circle for _, circle in sorted(apart, key=lambda pair: pair[0])]


def _commonest_scale(near: Sequence[tuple[HoleRow, Sequence[Arc]]]) -> float | None:
    """Size of a diameter's unit in px on which most rows agree; None where no row tells any."""
    scales = [
        2.0 * arc.radius / row.diameter for row, around in near if row.diameter for arc in around
    ]
    return max(
        scales,
        key=lambda scale: sum(
            any(_fits(row, arc, scale) for arc in around) for row, around in near
        ),
        default=None,
    )


def _fits(row: HoleRow, arc: Arc, scale: float | None) -> bool:
    if scale is None or not row.diameter:
        return False
    return abs(log(2.0 * arc.radius / (row.diameter * scale))) <= _ALIKE


def _hole_row(cells: Sequence[tuple[SheetText, ...]], heads: Sequence[str]) -> HoleRow | None:
    """What a row says of holes: its first cell is their label, a further one their diameter."""
    label = plain_text(" ".join(text.text for text in cells[0])).upper()
    if _LABEL.fullmatch(label) is None:
        return None
    words: list[str] = []
    texts: list[SheetText] = []
    for cell, head in zip(cells[1:], heads[1:], strict=True):
        said = _said(plain_text(" ".join(text.text for text in cell)), head)
        if said:
            words.append(said)
            texts += cell
    text = " ".join(words)
    callouts = [each for each in parse_callout(text) if each.kind in _HOLES]
    if not callouts:
        return None
    first = callouts[0]
    diameter = first.value if first.kind is NoteKind.DIAMETER else None
    corners = np.array([each.box for each in texts])
    x0, y0 = corners[:, :2].min(axis=0).tolist()
    x1, y1 = corners[:, 2:].max(axis=0).tolist()
    return HoleRow(label, SheetText(text, (x0, y0, x1, y1), exact=texts[0].exact), diameter)


def _said(text: str, head: str) -> str:
    """A cell as a part of a call-out; nothing of a coordinate and of what is no call-out."""
    if _NUMBER.fullmatch(text):
        if in_signs(f"{head} 1")[1].endswith(f"{DEPTH}1"):
            return f"{DEPTH}{text}"
        return f"\u00d8{text}" if _DIAMETER.search(head) else ""
    return text if parse_callout(text) else ""
