"""Texts of ruled tables: each within its cell, in rows and columns."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.near_points import connected_groups
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.writing.dimension_layout import ALONG, IN_LINE
from gaussiancad_core.writing.sheet_texts import SheetText

_FEWEST_ROWS, _FEWEST_COLUMNS = 2, 3
"""Of a table at least: a number between two pairs of lines is a dimension."""

_SAME = 2.0 * IN_LINE
"""px by which the sides of neighbouring cells may lie apart."""

_HELD = 0.5
"""Share of the cells of a table that hold text at least."""


@dataclass(frozen=True)
class Table:
    """A ruled table.

    Attributes:
        rows: from the top; each cell's texts, from the left; an empty cell has none.
    """

    rows: tuple[tuple[tuple[SheetText, ...], ...], ...]

    @property
    def texts(self) -> tuple[SheetText, ...]:
        """All texts in its cells."""
        return tuple(text for row in self.rows for cell in row for text in cell)


def ruled_tables(texts: Sequence[SheetText], rules: Sequence[Rule]) -> tuple[Table, ...]:
    """The tables of a sheet.

    Args:
        texts: of the sheet.
        rules: its level and upright lines.
    """
    cells: defaultdict[Box, list[SheetText]] = defaultdict(list)
    lines = [
        np.array([(rule.at, rule.low, rule.high) for rule in rules if rule.level is level])
        for level in (False, True)
    ]
    for text in texts:
        cell = _cell(text, lines) if text.level and not text.field else None
        if cell is not None:
            cells[cell].append(text)
    found = (_table(group, cells) for group in _adjoining(list(cells)))
    return tuple(table for table in found if table is not None)


def _cell(text: SheetText, lines: Sequence[npt.NDArray[np.float64]]) -> Box | None:
    """The lines that a text stands between on all four sides; None where one is missing, or the
    cell is higher than that of a line of text.

    Args:
        text: level.
        lines: (n, 3) px, where upright lines lie, from and to where they run; then level ones.
    """
    x0, y0, x1, y1 = text.box
    middle = (x0 + x1) / 2.0, (y0 + y1) / 2.0
    sides: list[float] = []
    for at, across, items in zip(middle, middle[::-1], lines, strict=True):
        places, low, high = items.reshape(-1, 3).T
        met = places[(low - IN_LINE <= across) & (across <= high + IN_LINE)]
        before, after = met[met < at], met[met > at]
        if not len(before) or not len(after):
            return None
        sides += [float(before.max()), float(after.min())]
    left, right, top, bottom = sides
    within = x0 >= left - IN_LINE and x1 <= right + (y1 - y0) and bottom - top <= ALONG * (y1 - y0)
    # Places of lines are known to a px.
    return (round(left), round(top), round(right), round(bottom)) if within else None


def _adjoining(cells: Sequence[Box]) -> list[list[Box]]:
    """Cells in groups: those that share a side are of one."""
    left, top, right, bottom = np.array(cells, dtype=float).reshape(-1, 4).T

    def same(one: npt.NDArray[np.float64], other: npt.NDArray[np.float64]) -> npt.NDArray[np.bool_]:
        return np.abs(one[:, None] - other[None]) <= _SAME

    level = same(top, top) & same(bottom, bottom) & same(right, left)
    upright = same(left, left) & same(right, right) & same(bottom, top)
    groups = connected_groups(np.argwhere(level | upright), len(cells))
    return [
        [cells[number] for number in np.flatnonzero(groups == group).tolist()]
        for group in np.unique(groups).tolist()
    ]


def _same(one: float, other: float) -> bool:
    return abs(one - other) <= _SAME


def _table(group: Sequence[Box], cells: dict[Box, list[SheetText]]) -> Table | None:
    """The table of some adjoining cells, if they are in rows and columns."""
    tops, lefts = _places(cell[1] for cell in group), _places(cell[0] for cell in group)
    held = len(group) >= _HELD * len(tops) * len(lefts)
    if len(tops) < _FEWEST_ROWS or len(lefts) < _FEWEST_COLUMNS or not held:
        return None
    rows: list[list[list[SheetText]]] = [[[] for _ in lefts] for _ in tops]
    for cell in group:
        row = next(number for number, at in enumerate(tops) if _same(at, cell[1]))
        column = next(number for number, at in enumerate(lefts) if _same(at, cell[0]))
        rows[row][column] += sorted(cells[cell], key=lambda text: text.box[1::-1])
    return Table(tuple(tuple(tuple(cell) for cell in row) for row in rows))


def _places(values: Iterable[float]) -> list[float]:
    """Places in order, each once."""
    found: list[float] = []
    for value in sorted(values):
        if not found or not _same(found[-1], value):
            found.append(value)
    return found
