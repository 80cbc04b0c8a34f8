"""Dimensions that count from a common zero."""

import pytest

from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.writing.ordinates import is_zero, ordinate_length
from gaussiancad_core.writing.sheet_texts import SheetText

ZERO = SheetText("0", (89.0, 391.0, 100.0, 409.0))
TEXTS = (
    SheetText("25,00", (40.0, 292.0, 100.0, 310.0)),
    SheetText("39,90", (40.0, 241.0, 100.0, 259.0)),
)
RULES = [Rule(True, at, 106.0, 300.0) for at in (400.0, 300.5, 249.75)]


def turned(text: SheetText) -> SheetText:
    x0, y0, x1, y1 = text.box
    return SheetText(text.text, (y0, x0, y1, x1), not text.level)


def test_lengths_run_from_the_line_of_the_zero() -> None:
    assert [ordinate_length(text, [ZERO], RULES) for text in TEXTS] == [99.5, 150.25]


def test_the_same_up_the_sheet() -> None:
    rules = [Rule(False, rule.at, rule.low, rule.high) for rule in RULES]
    # A lone zero is read either way.
    for zero in (turned(ZERO), SheetText("0", turned(ZERO).box)):
        found = [ordinate_length(turned(text), [zero], rules) for text in TEXTS]
        assert found == [99.5, 150.25]


def test_without_a_zero_or_a_line_there_is_no_length() -> None:
    assert ordinate_length(TEXTS[0], [], RULES) is None
    assert ordinate_length(TEXTS[0], [ZERO], RULES[:1]) is None
    assert ordinate_length(TEXTS[0], [ZERO], RULES[1:]) is None
    away = SheetText("0", (289.0, 391.0, 300.0, 409.0))
    assert ordinate_length(TEXTS[0], [away], RULES) is None


@pytest.mark.parametrize(
    ("text", "zero"), [("0", True), ("0,00", True), ("O", True), ("0.5", False), ("10", False)]
)
def test_zeros(text: str, zero: bool) -> None:
    assert is_zero(SheetText(text, ZERO.box)) is zero
    assert not is_zero(SheetText(text, ZERO.box, field=True))


def test_far_lines_count_where_they_stand_in_a_row() -> None:
    far = [Rule(True, rule.at, 160.0, 200.0) for rule in RULES]
    assert [ordinate_length(text, [ZERO], far) for text in TEXTS] == [99.5, 150.25]
    # An edge beyond the lines of the row is none of them.
    edges = [Rule(True, rule.at, 206.0, 800.0) for rule in RULES]
    found = [ordinate_length(text, [ZERO], [*edges[:2], *far]) for text in TEXTS]
    assert found == [99.5, 150.25]
    shifted = [far[0], *(Rule(True, rule.at, 185.0, 225.0) for rule in far[1:])]
    assert [ordinate_length(text, [ZERO], shifted) for text in TEXTS] == [None, None]
