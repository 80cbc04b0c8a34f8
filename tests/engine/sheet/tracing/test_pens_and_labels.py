"""What the width of ink and the labels of its pixels tell of linetypes."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet

Sketch = Any
"""The class that the fixture gives."""

V, H = Linetype.VISIBLE, Linetype.HIDDEN
RHYTHM = (12.0, 6.0)
Window = tuple[slice, slice]
ReadView = Callable[..., Any]


def _plate(sketch: Sketch, pen: float) -> Any:  # noqa: ANN401
    """An outline with two hidden lines."""
    drawn = sketch(320, 240).box(20, 20, 300, 220)
    return drawn.broken((20, 50), (302, 50), RHYTHM, pen).broken((20, 190), (302, 190), RHYTHM, pen)


@pytest.mark.parametrize(("pen", "kind"), [(2.0, H), (3.0, V)])
def test_the_pen_tells_a_dash_between_two_strokes(
    sketch: Sketch, pen: float, kind: Linetype
) -> None:
    """Of two lines that join the same two edges, the narrow one is hidden."""
    drawn = _plate(sketch, 2.0).line((20, 100), (300, 100)).line((20, 118), (300, 118))
    drawn.ink((150, 100), (150, 118), width=pen).shows(
        Segment((150.5, 100.5), (150.5, 118.5), kind)
    )
    assert drawn.misread(2.1) == []


@pytest.mark.parametrize("place", [160.5, 200.0])
def test_a_line_changes_where_its_pen_does(sketch: Sketch, place: float) -> None:
    drawn = _plate(sketch, 2.0).line((20, 120), (place, 120))
    assert drawn.broken((place, 120), (302, 120), (302 - place, 1.0)).misread(2.5) == []


def test_crossings_do_not_cut_a_narrow_line(sketch: Sketch) -> None:
    drawn = _plate(sketch, 2.0).broken((20, 120), (302, 120), (282.0, 1.0))
    for x in (50, 57, 150):
        drawn.line((x, 20), (x, 220))
    assert drawn.misread(2.1) == []


def _labelled(sheet: CleanSheet, *hidden: Window) -> CleanSheet:
    """The sheet, all of whose ink is labelled as visible but for some windows."""
    odds = np.full(sheet.ink.shape, -6.0, np.float16)
    for window in hidden:
        odds[window] = 6.0
    return replace(sheet, hidden_odds=odds)


def _level(sheet: CleanSheet, read_view: ReadView) -> list[tuple[str, float, float]]:
    """Linetype and ends of what is read at y = 120."""
    found = [
        (s.linetype.value, *sorted((s.start[0] - 0.5, s.end[0] - 0.5)))
        for s in read_view(sheet, (10.0, 10.0, 310.0, 230.0)).strokes
        if isinstance(s, Segment) and max(abs(s.start[1] - 120.5), abs(s.end[1] - 120.5)) < 2.0
    ]
    return sorted(found, key=lambda item: item[1])


@pytest.mark.parametrize(
    ("windows", "wanted"),
    [
        ([], [("visible", 20.0, 300.0)]),
        ([np.s_[115:126, 24:297]], [("hidden", 20.0, 300.0)]),
        ([np.s_[115:126, 160:297]], [("visible", 20.0, 160.0), ("hidden", 160.0, 300.0)]),
    ],
    ids=["visible", "hidden", "both"],
)
def test_labels_tell_where_no_pen_does(
    sketch: Sketch,
    read_view: ReadView,
    windows: list[Window],
    wanted: list[tuple[str, float, float]],
) -> None:
    drawn = sketch(320, 240).box(20, 20, 300, 220, 2.5).line((20, 120), (300, 120), 2.5)
    drawn.line((100, 20), (100, 220), 2.5)
    sheet = _labelled(clean_sheet(drawn.grey), *windows)
    sheet.hidden_odds[:, 98:103] = -6.0
    found = _level(sheet, read_view)
    assert [item[0] for item in found] == [item[0] for item in wanted]
    assert [item[1:] for item in found] == [pytest.approx(item[1:], abs=1.5) for item in wanted]


def test_one_wrong_label_of_a_row_tells_nothing(sketch: Sketch, read_view: ReadView) -> None:
    drawn = sketch(320, 240).box(20, 20, 300, 220, 2.5).broken((20, 120), (302, 120), RHYTHM, 2.5)
    sheet = _labelled(clean_sheet(drawn.grey), np.s_[116:125, 24:126], np.s_[116:125, 142:300])
    assert [item[0] for item in _level(sheet, read_view)] == ["hidden"]


@pytest.mark.parametrize("odds", [-4.0, -0.5])
def test_a_line_of_which_hardly_anything_is_hidden_is_visible(
    sketch: Sketch, read_view: ReadView, odds: float
) -> None:
    sheet = clean_sheet(
        sketch(320, 240).box(20, 20, 300, 220, 2.5).line((20, 120), (300, 120), 2.5).grey
    )
    stated = np.full(sheet.ink.shape, -6.0, np.float16)
    stated[115:126] = odds
    stated[115:126, 24:45] = stated[115:126, 280:297] = 4.0
    assert "visible" in {item[0] for item in _level(replace(sheet, hidden_odds=stated), read_view)}


@pytest.mark.parametrize("wrong", [0.85, 1.15])
@pytest.mark.parametrize(("dash", "gap"), [(2.6, 2.6), (3.0, 2.5), (12.0, 2.0)])
def test_a_bore_is_found_though_the_width_is_off(
    sketch: Sketch, read_view: ReadView, dash: float, gap: float, wrong: float
) -> None:
    """Without labels dots of 2.6 px are lost where the width is too large by a seventh."""
    drawn = sketch(320, 200).box(40, 40, 280, 160, 2.4)
    for at in (80, 120):
        for start in np.arange(40.0, 278.0 - dash, dash + gap):
            drawn.ink((start, at), (start + dash, at), width=2.4)
    sheet = _labelled(clean_sheet(drawn.grey), np.s_[76:85, 44:277], np.s_[116:125, 44:277])
    sheet = replace(sheet, stroke_width=wrong * sheet.stroke_width)
    strokes = read_view(sheet, (30.0, 30.0, 290.0, 170.0)).strokes
    hidden = [stroke for stroke in strokes if stroke.linetype is H]
    assert sorted(item.start[1] - 0.5 for item in hidden) == pytest.approx([80.0, 120.0], abs=0.2)
    assert all(item.length == pytest.approx(240.0, abs=1.0) for item in hidden)
    assert len(strokes) == 6
