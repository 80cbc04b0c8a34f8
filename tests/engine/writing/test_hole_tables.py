"""Ruled tables, and the rows of those that speak of holes."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.writing.hole_tables import hole_rows, labelled_circles
from gaussiancad_core.writing.measured_texts import SheetMeasures, dimensions_of, with_tables
from gaussiancad_core.writing.ruled_cells import Table, ruled_tables
from gaussiancad_core.writing.sheet_texts import SheetText

_HIGH, _ROW = 20.0, 48.0
_LEFT, _TOP = 1000.0, 100.0
_WIDTH = 150.0

_HEAD = ("TAG", "X LOC", "Y LOC", "SIZE")
_ROWS = (
    ("A1", "10", "10", "\u00d85 THRU"),
    ("B1", "30", "25", "\u00d820 \u21a7 6"),
    ("C1", "60", "25", "\u00d88 \u21a7 12"),
)


def _texts(*rows: tuple[str, ...]) -> tuple[SheetText, ...]:
    """The texts of a table, each in its cell."""
    return tuple(
        SheetText(text, (x, y, x + 0.6 * _HIGH * len(text), y + _HIGH), exact=True)
        for k, row in enumerate(rows)
        for n, text in enumerate(row)
        if text
        for x, y in [(_LEFT + _WIDTH * n + 10.0, _TOP + _ROW * k + 12.0)]
    )


def _rules(rows: int, columns: int) -> list[Rule]:
    """The lines of a table."""
    right, bottom = _LEFT + columns * _WIDTH, _TOP + rows * _ROW
    level = [Rule(True, _TOP + k * _ROW, _LEFT, right) for k in range(rows + 1)]
    return level + [Rule(False, _LEFT + k * _WIDTH, _TOP, bottom) for k in range(columns + 1)]


def _table(*rows: tuple[str, ...]) -> Table:
    (table,) = ruled_tables(_texts(*rows), _rules(len(rows), len(rows[0])))
    return table


def test_a_ruled_table_has_its_texts_in_rows_and_columns() -> None:
    table = _table(_HEAD, *_ROWS)
    assert [[cell[0].text for cell in row] for row in table.rows] == [
        list(row) for row in (_HEAD, *_ROWS)
    ]


def test_a_cell_may_be_empty() -> None:
    table = _table(("A", "", "1", "2"), ("B", "3", "4", "5"))
    assert table.rows[0][1] == () and len(table.texts) == 7


@pytest.mark.parametrize("missing", [0, 4, -5, -1])
def test_without_a_line_of_its_border_a_cell_belongs_to_no_table(missing: int) -> None:
    rules = _rules(4, 4)
    del rules[missing]
    found = ruled_tables(_texts(_HEAD, *_ROWS), rules)
    assert sum(len(table.texts) for table in found) < 16


def test_a_number_between_the_lines_of_dimensions_is_in_no_table() -> None:
    rules = [Rule(True, 0.0, 0.0, 90.0), Rule(True, 60.0, 0.0, 90.0)]
    rules += [Rule(False, 0.0, 0.0, 60.0), Rule(False, 90.0, 0.0, 60.0)]
    assert ruled_tables([SheetText("90", (30.0, 20.0, 60.0, 40.0))], rules) == ()


@pytest.mark.parametrize(
    ("head", "row", "text"),
    [
        (_HEAD, _ROWS[0], "\u00d85 THRU"),
        (_HEAD, _ROWS[1], "\u00d820 \u21a7 6"),
        (("HOLE", "X", "Y", "DIA", "DEPTH"), ("1", "5", "5", "8", "12"), "\u00d88 \u21a712"),
        (("HOLE", "X", "Y", "\u2300", "DEPTH"), ("1", "5", "5", "8", "THRU"), "\u00d88 THRU"),
        (("Pos", "X", "Y", "Durchm.", "Tiefe"), ("B2", "5", "5", "8", "12"), "\u00d88 \u21a712"),
        (("ID", "X", "Y", "DESCRIPTION"), ("A", "5", "5", "M8 \u21a7 14"), "M8 \u21a7 14"),
    ],
)
def test_a_row_is_a_callout(head: tuple[str, ...], row: tuple[str, ...], text: str) -> None:
    (found,) = hole_rows(_table(head, row))
    assert (found.label, found.text.text) == (row[0], text)


def test_tables_of_something_else_have_no_rows_of_holes() -> None:
    assert hole_rows(_table(("ITEM", "QTY", "NAME"), ("1", "2", "PLATE"), ("2", "4", "BOLT"))) == ()


def _circle(x: float, y: float, radius: float) -> Arc:
    return Arc((x, y), radius, 0.0, 6.283185307179586, Linetype.VISIBLE)


def _label(text: str, x: float, y: float) -> SheetText:
    return SheetText(text, (x, y - _HIGH, x + 24.0, y), exact=True)


_SMALL, _WIDE, _MIDDLE = _circle(100, 100, 20), _circle(300, 200, 80), _circle(500, 100, 32)
_LABELS = (_label("A1", 130, 90), _label("B1", 390, 130), _label("C1", 538, 80))


def test_rows_belong_to_the_circles_that_carry_their_labels() -> None:
    rows = hole_rows(_table(_HEAD, *_ROWS))
    found = labelled_circles(rows, _LABELS, (_SMALL, _WIDE, _MIDDLE))
    assert [found[row.text.box] for row in rows] == [(_SMALL,), (_WIDE,), (_MIDDLE,)]


def test_a_nearer_circle_of_another_size_does_not_take_a_label() -> None:
    nearer = _circle(425, 80, 20)
    rows = hole_rows(_table(_HEAD, *_ROWS))
    found = labelled_circles(rows, _LABELS, (nearer, _SMALL, _WIDE, _MIDDLE))
    assert found[rows[1].text.box] == (_WIDE,)


def test_one_label_at_many_circles_is_a_row_of_all() -> None:
    (row,) = hole_rows(_table(_HEAD, ("A", "", "", "\u00d85 THRU")))
    other = _circle(900, 100, 20)
    labels = (_label("A", 130, 90), _label("A", 930, 90))
    assert labelled_circles([row], labels, (_SMALL, other)) == {row.text.box: (_SMALL, other)}


def test_cells_are_no_dimensions_and_rows_measure_their_circles_alone() -> None:
    texts = (*_LABELS, *_texts(_HEAD, *_ROWS))
    measures = SheetMeasures(_rules(4, 4), [], [_SMALL, _WIDE, _MIDDLE])
    free, rows = with_tables(texts, measures)
    found = dimensions_of(free, measures, rows, bare_point_is_inch=False)
    assert [dimension.text for dimension in found] == [row[3] for row in _ROWS]
    assert [dimension.said.value for dimension in found] == [5.0, 20.0, 8.0]
    assert [[each.pixels for each in item.candidates] for item in found] == [
        [40.0],
        [160.0],
        [64.0],
    ]


def test_a_leader_at_the_widest_circle_may_speak_of_those_within() -> None:
    within = _circle(100, 100, 11)
    leader = np.array([114.0, 86.0]), np.array([200.0, 0.0])
    text = SheetText("4x \u00d85.5", (202.0, -10.0, 280.0, 10.0), exact=True)
    measures = SheetMeasures([], [], [_SMALL, within, _WIDE], leaders=(leader,))
    (found,) = dimensions_of([text], measures, {}, bare_point_is_inch=False)
    assert [(each.pixels, each.weight) for each in found.candidates] == [(40.0, 0.9), (22.0, 0.5)]


@pytest.mark.parametrize("exact", [True, False])
def test_the_text_of_a_file_has_all_its_digits(exact: bool) -> None:
    """A line through the beginning of a text hides digits of pixels alone."""
    (text,) = _texts(("\u00d85 THRU",))
    x0, y0, _, y1 = text.box
    measures = SheetMeasures([Rule(False, x0, y0 - 9.0, y1 + 9.0)], [], [])
    (found,) = dimensions_of([replace(text, exact=exact)], measures, {}, bare_point_is_inch=False)
    assert found.cut is not exact
