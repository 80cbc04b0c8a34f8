"""Strokes in doubt on the canvas: orange, listed in order with a yes and a no, and settled."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from freecad.gaussiancad.canvas.doubts import MOST, doubt_in_words, doubt_lines, doubts_of
from freecad.gaussiancad.canvas.kinds import DOUBTFUL
from freecad.gaussiancad.canvas.rows import Line
from freecad.gaussiancad.canvas.sheet import Sheet, sheet_of
from freecad.gaussiancad.canvas.window import SheetWindow
from gaussiancad_protocol.reading_kinds import DOUBT

_DOUBTS = {
    "s2": (0.55, "network", "dimension"),
    "s5": (0.51, "loose-end", "visible"),
    "s6": (0.99, "network", "centre"),
}
"""Confidence, what decided and what it would be otherwise, of strokes of the reading."""


@pytest.fixture
def reading(reading: dict) -> dict:
    """The same with two strokes in doubt, and one far from the views."""
    for item in reading["strokes"]:
        if item["id"] in _DOUBTS:
            item["confidence"], by, otherwise = _DOUBTS[item["id"]]
            item["why"] = {"by": by, "otherwise": otherwise, "margin": 0.1}
    far = {"id": "s9", "view": None, "kind": "frame", "line": [[5, 400], [600, 400]]}
    reading["strokes"].append({**far, "confidence": 0.5})
    return reading


def doubts(window: SheetWindow) -> list[Line]:
    return [line for line in window.problems.lines if "In doubt" in line.text]


def colours(window: SheetWindow) -> dict[str, str]:
    """The colour of each stroke, by its id."""
    items = window.canvas_view._drawing._strokes.items()
    return {name: item.pen().color().name() for name, item in items}


def test_the_canvas_doubts_from_where_the_engine_does(window: SheetWindow) -> None:
    stroke = window.sheet.strokes[0]
    assert replace(stroke, confidence=DOUBT - 1e-6).doubtful
    assert not replace(stroke, confidence=DOUBT).doubtful
    assert not replace(stroke, confidence=0.0, given=True).doubtful


def test_strokes_in_doubt_are_orange_whatever_their_kind(window: SheetWindow) -> None:
    found = colours(window)
    assert found["s2"] == found["s5"] == DOUBTFUL
    assert DOUBTFUL not in (found["s1"], found["s6"])
    stated = window.canvas_view._drawing._strokes["s2"].toolTip()
    assert stated == doubt_in_words(window.sheet.strokes[1])


def test_they_are_listed_most_doubtful_first_with_the_reason(window: SheetWindow) -> None:
    assert [doubt.id for doubt in doubts_of(window.sheet)] == ["s5", "s2"]
    first, second = doubts(window)
    assert "centre line, 51% sure. As an edge it would end at no other edge." in first.text
    assert first.text.endswith("Otherwise: visible")
    assert "visible, 55% sure. Its ink looks like that. Otherwise: dimension" in second.text
    assert (first.box, second.box) == ((200, 100, 200, 250), (300, 100, 300, 250))


def test_tab_goes_from_doubt_to_doubt(window: SheetWindow) -> None:
    asked: list[tuple] = []
    window.problems.place_asked.connect(asked.append)
    for _ in range(3):
        window.problems.show_next()
    assert asked[1:] == [(200, 100, 200, 250), (300, 100, 300, 250)]


@pytest.mark.parametrize(("button", "kind"), [(0, "visible"), (1, "dimension")])
def test_yes_and_no_settle_a_doubt(window: SheetWindow, button: int, kind: str) -> None:
    texts = [text for text, _ in doubts(window)[1].buttons]
    assert texts == ["Yes: visible", "No: dimension"]
    doubts(window)[1].buttons[button][1]()
    (said,) = window.operations
    assert (said["op"], said["target"]["id"], said["to"]) == ("kind", "s2", kind)
    assert len(doubts(window)) == 1
    assert colours(window)["s2"] != DOUBTFUL
    window.undo()
    assert len(doubts(window)) == 2
    assert colours(window)["s2"] == DOUBTFUL


def test_a_key_says_that_a_doubtful_stroke_is_what_it_seems(window: SheetWindow) -> None:
    window.canvas_view.select({"s1", "s2"})
    window.canvas_view.set_kind("visible")
    assert [operation["target"]["id"] for operation in window.operations] == ["s2"]


def test_doubts_stay_listed_under_a_verdict(window: SheetWindow, tmp_path: Path) -> None:
    warning = {"code": "scale-assumed", "message": "of no known size"}
    report = {"status": "approximate", "reasons": [], "warnings": [warning]}
    window.session.solved.emit(report, str(tmp_path))
    assert window.problems.lines[0].colour
    assert window.problems.lines[1:3] == doubts(window)
    assert len(window.problems.lines) == 4


def _many() -> Iterator[dict]:
    for number in range(MOST + 3):
        line = [[100, 100 + number], [300, 100 + number]]
        yield {"id": f"s{number}", "view": "a", "kind": "hidden", "line": line, "confidence": 0.5}


def test_a_long_list_ends_with_how_many_more_there_are() -> None:
    values = {
        "sheet": {"sha256": "0" * 64},
        "views": [{"id": "a", "role": "front", "box": [100, 100, 300, 200]}],
        "strokes": list(_many()),
    }
    sheet: Sheet = sheet_of(values)
    lines = doubt_lines(sheet, lambda _: None)
    assert len(lines) == MOST + 1
    assert lines[-1].text.endswith(" 3")
    assert [text for text, _ in lines[0].buttons] == ["Yes: hidden"]
