"""What dimension lines measure from tip to tip."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.writing.arrows import ArrowPair, arrow_pairs, arrow_spans
from gaussiancad_core.writing.sheet_texts import SheetText

_STILL = Turn(0.0, (0.0, 0.0))
_HEAD = 12.0


def _heads(level: bool, at: float, low: float, high: float, inside: bool) -> list[Head]:
    outward = -1.0 if inside else 1.0
    found = []
    for along, way in ((low, outward), (high, -outward)):
        tip, direction = ((along, at), (way, 0.0)) if level else ((at, along), (0.0, way))
        found.append(Head(tip, direction, _HEAD))
    return found


def _line(level: bool, at: float, low: float, high: float, inside: bool) -> list[Rule]:
    if inside:
        return [Rule(level, at, low + _HEAD, high - _HEAD)]
    return [Rule(level, at, low - 40.0, low - _HEAD), Rule(level, at, high + _HEAD, high + 40.0)]


@given(
    level=st.booleans(),
    inside=st.booleans(),
    low=st.floats(100.0, 300.0),
    length=st.floats(40.0, 120.0),
)
def test_two_heads_of_a_line_measure_from_tip_to_tip(
    level: bool, inside: bool, low: float, length: float
) -> None:
    items = (level, 500.0, low, low + length, inside)
    # Another line in line with it, farther on, is a pair of its own.
    far = (level, 500.0, low + 900.0, low + 1000.0, True)
    heads = [*_heads(*items), *_heads(*far)]
    pairs = arrow_pairs(heads, [*_line(*items), *_line(*far)], [], _STILL)
    assert ArrowPair(*items) in pairs and ArrowPair(*far) in pairs
    middle = low + length / 2.0
    box = (middle - 15.0, 478.0, middle + 15.0, 498.0)
    text = SheetText("30", box if level else (478.0, middle - 15.0, 498.0, middle + 15.0), level)
    first, *_ = arrow_spans(text, pairs)
    assert (first.low, first.high) == pytest.approx((low, low + length))
    assert first.level is level


def test_a_chain_of_dimensions_is_told_apart_by_its_texts() -> None:
    marks = [100.0, 180.0, 330.0]
    heads = [*_heads(True, 50.0, 100.0, 180.0, True), *_heads(True, 50.0, 180.0, 330.0, True)]
    rules = [Rule(True, 50.0, 112.0, 168.0), Rule(True, 50.0, 192.0, 318.0)]
    pairs = arrow_pairs(heads, rules, [], _STILL)
    for low, high in ((marks[0], marks[1]), (marks[1], marks[2])):
        middle = (low + high) / 2.0
        text = SheetText("8", (middle - 8.0, 28.0, middle + 8.0, 48.0))
        assert (arrow_spans(text, pairs)[0].low, arrow_spans(text, pairs)[0].high) == (low, high)


def test_a_text_in_its_line_is_part_of_it_and_a_bare_gap_is_none() -> None:
    heads = _heads(True, 50.0, 100.0, 300.0, True)
    rules = [Rule(True, 50.0, 112.0, 130.0), Rule(True, 50.0, 270.0, 288.0)]
    text = SheetText("1234.5", (140.0, 40.0, 260.0, 60.0))
    (pair,) = arrow_pairs(heads, rules, [text], _STILL)
    assert (pair.low, pair.high) == (100.0, 300.0)
    assert arrow_pairs(heads, rules, [], _STILL) == ()
    away = SheetText("1234.5", (140.0, 90.0, 260.0, 110.0))
    assert arrow_spans(away, [pair]) == ()


@given(angle=st.floats(-0.09, 0.09))
def test_a_turned_sheet_is_measured_upright(angle: float) -> None:
    turn = Turn(angle, (400.0, 300.0))
    tips = turn.to_stored(np.array([(100.0, 50.0), (260.0, 50.0)]))
    way = np.diff(tips, axis=0)[0] / np.hypot(*np.diff(tips, axis=0)[0])
    heads = [Head(tuple(tips[0]), tuple(-way), _HEAD), Head(tuple(tips[1]), tuple(way), _HEAD)]
    (pair,) = arrow_pairs(heads, [Rule(True, 50.0, 112.0, 248.0)], [], turn)
    assert (pair.low, pair.high, pair.at) == pytest.approx((100.0, 260.0, 50.0), abs=1e-6)
