"""What the ink of a run tells of its linetype: the width of its pen, the labels of its pixels."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.line_widths import Pens, widths_along
from gaussiancad_core.sheet.tracing.linetype_odds import RunOdds, run_odds
from gaussiancad_core.sheet.tracing.run_linetypes import classify
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

VISIBLE, HIDDEN = Linetype
RHYTHM = Rhythm(12.0, 6.0)
LEVEL = Line((0.0, 60.0), (1.0, 0.0))
PENS = Pens(2.3, 2.7)


def _labelled(sheet: CleanSheet, hidden: list[tuple[slice, slice]]) -> CleanSheet:
    """The sheet, all of whose ink is labelled as visible but for some windows."""
    odds = np.full(sheet.ink.shape, -6.0, np.float16)
    for window in hidden:
        odds[window] = 6.0
    return replace(sheet, hidden_odds=odds)


def _kinds(stated: list[RunOdds]) -> list[tuple[Run, Linetype | None]]:
    """What is told of each run."""
    return [
        (run, HIDDEN if odds >= TOLD else VISIBLE if odds <= -TOLD else None)
        for run, odds in stated
    ]


@pytest.mark.parametrize("place", [60.5, 81.0, 120.25])
def test_a_run_is_cut_where_the_pen_changes(sketch: Sketch, place: float) -> None:
    drawn = sketch().line((20, 60), (place, 60), 3.0)
    sheet = clean_sheet(drawn.line((place, 60), (150, 60), 2.0).grey)
    stated = _kinds(run_odds(sheet, LEVEL, [Run(20.0, 150.0)], PENS))
    assert [kind for _, kind in stated] == [VISIBLE, HIDDEN]
    first, second = (run for run, _ in stated)
    assert (first.start, second.end) == (20.0, 150.0)
    assert first.end == second.start == pytest.approx(place, abs=2.0)


def test_crossings_do_not_cut(sketch: Sketch) -> None:
    drawn = sketch().line((20, 60), (150, 60), 2.0)
    for x in (50, 57, 100):
        drawn.line((x, 20), (x, 100), 3.0)
    sheet = clean_sheet(drawn.grey)
    run = Run(22.0, 147.0)
    assert _kinds(run_odds(sheet, LEVEL, [run], PENS)) == [(run, HIDDEN)]
    widths = widths_along(sheet, LEVEL, run)
    assert len(widths) == 126
    assert np.nanmedian(widths) == pytest.approx(2.0, abs=0.2)


def test_the_last_pixels_do_not_tell_a_long_run(sketch: Sketch) -> None:
    """All but its end merges with what lies beside it."""
    drawn = sketch().line((20, 60), (144, 60), 3.0).line((144, 60), (150, 60), 2.0)
    drawn.line((20, 63), (146, 63), 3.0)
    run = Run(20.0, 150.0)
    assert _kinds(run_odds(clean_sheet(drawn.grey), LEVEL, [run], PENS)) == [(run, None)]


def test_nothing_is_cut_where_no_pen_is_told_to_change(sketch: Sketch) -> None:
    """Wider by what two slanted lines leave beside it, and in between neither pen's."""
    drawn = sketch().line((20, 60), (150, 60), 2.5).line((50, 60), (80, 130), 2.5)
    sheet = clean_sheet(drawn.line((120, 60), (90, 130), 2.5).line((60, 60), (100, 60), 3.0).grey)
    run = Run(22.0, 147.0)
    assert _kinds(run_odds(sheet, LEVEL, [run], PENS)) == [(run, VISIBLE)]


def test_the_pen_tells_what_dashes_do_not() -> None:
    """A dash long, between two other strokes: a hidden edge, or a short visible one."""
    touches = [(True, True)]
    for kind, odds in ((HIDDEN, 2.0), (VISIBLE, -2.0)):
        found = classify([Run(0.0, 12.0)], RHYTHM, touches, stated=[odds])
        assert [(piece.linetype, piece.confidence) for piece in found] == [(kind, 0.8)]
    # Wide dashes in a row are two hidden lines side by side.
    row = [Run(18.0 * k, 18.0 * k + 12.0) for k in range(4)]
    found = classify(row, RHYTHM, [(False, False)] * 4, stated=[-2.5] * 4)
    assert [piece.linetype for piece in found] == [HIDDEN]
    # Wide ink that goes on narrow is visible up to there.
    row = [Run(0.0, 9.0), Run(9.0, 21.0), Run(27.0, 39.0)]
    found = classify(row, RHYTHM, [(True, False)] * 3, stated=[-2.5, 2.5, 2.5])
    assert [piece.linetype for piece in found] == [VISIBLE, HIDDEN]
    assert (found[0].end, found[1].start) == (9.0, 9.0)


def test_labels_tell_where_no_pen_does(sketch: Sketch) -> None:
    """One pen; what crosses the line is labelled as visible, and is not asked."""
    drawn = sketch().line((20, 60), (150, 60), 2.5)
    for x in (50, 100):
        drawn.line((x, 20), (x, 100), 2.5)
    sheet = _labelled(clean_sheet(drawn.grey), [np.s_[57:64, :]])
    for x in (50, 100):
        sheet.hidden_odds[:, x - 2 : x + 3] = -6.0
    run = Run(22.0, 147.0)
    assert _kinds(run_odds(sheet, LEVEL, [run], Pens())) == [(run, HIDDEN)]
    assert run_odds(clean_sheet(drawn.grey), LEVEL, [run], Pens()) == [(run, 0.0)]


def test_a_run_is_cut_where_its_label_changes(sketch: Sketch) -> None:
    sheet = clean_sheet(sketch().line((20, 60), (150, 60), 2.5).grey)
    stated = run_odds(_labelled(sheet, [np.s_[:, 90:]]), LEVEL, [Run(20.0, 150.0)], Pens())
    assert [kind for _, kind in _kinds(stated)] == [VISIBLE, HIDDEN]
    assert stated[0][0].end == stated[1][0].start == pytest.approx(90.0, abs=1.0)


def test_a_run_of_which_nothing_is_visible_is_not_cut(sketch: Sketch) -> None:
    """Most of a thin circle's ink looks like nothing that is known, its ends like a hidden line's;
    it is drawn through, as no hidden line is."""
    sheet = clean_sheet(sketch().line((20, 60), (150, 60), 2.5).grey)
    odds = np.full(sheet.ink.shape, -0.5, np.float16)
    odds[:, :45] = odds[:, 130:] = 4.0
    run = Run(20.0, 150.0)
    stated = run_odds(replace(sheet, hidden_odds=odds), LEVEL, [run], Pens())
    assert _kinds(stated) == [(run, None)]
    found = classify([run], RHYTHM, [(False, False)], stated=[odds for _, odds in stated])
    assert [piece.linetype for piece in found] == [VISIBLE]


def test_pen_and_label_add_up(sketch: Sketch) -> None:
    """A label that is hardly sure tells nothing against a pen; one that is sure does."""
    sheet = clean_sheet(sketch().line((20, 60), (150, 60), 2.0).grey)
    run = Run(22.0, 147.0)
    doubtful, sure = (
        replace(sheet, hidden_odds=np.full(sheet.ink.shape, odds, np.float16))
        for odds in (-0.3, -6.0)
    )
    (stated,) = run_odds(doubtful, LEVEL, [run], PENS)
    assert TOLD < stated[1] < run_odds(sheet, LEVEL, [run], PENS)[0][1]
    assert run_odds(sure, LEVEL, [run], PENS)[0][1] < 0.0


def test_a_row_shares_what_its_dashes_tell(sketch: Sketch) -> None:
    """One dash of five has the wrong label; alone it would be visible."""
    drawn = sketch()
    row = [Run(20.0 + 18.0 * k, 32.0 + 18.0 * k) for k in range(5)]
    for run in row:
        drawn.line((run.start, 60), (run.end, 60), 2.5)
    sheet = _labelled(clean_sheet(drawn.grey), [np.s_[:, :54], np.s_[:, 70:]])
    stated = run_odds(sheet, LEVEL, row, Pens())
    assert len({odds for _, odds in stated}) == 1
    found = classify(row, RHYTHM, [(True, True)] * 5, stated=[odds for _, odds in stated])
    assert [piece.linetype for piece in found] == [HIDDEN]
    ((_, alone),) = run_odds(sheet, LEVEL, row[2:3], Pens())
    assert alone < -TOLD


def test_edges_in_a_row_whose_labels_are_sure_are_visible() -> None:
    """Teeth of a comb are as long as dashes and as far apart."""
    row = [Run(18.0 * k, 18.0 * k + 12.0) for k in range(4)]
    found = classify(row, RHYTHM, [(True, True)] * 4, stated=[-4.0] * 4)
    assert [(piece.start, piece.end) for piece in found] == [(run.start, run.end) for run in row]
    assert {piece.linetype for piece in found} == {VISIBLE}


@pytest.mark.parametrize("wrong", [0.85, 1.0, 1.15])
@pytest.mark.parametrize(("dash", "gap"), [(2.6, 2.6), (3.0, 2.5), (6.0, 3.0), (12.0, 2.0)])
def test_a_bore_is_found_though_the_width_is_off(
    sketch: Sketch, dash: float, gap: float, wrong: float
) -> None:
    """Without labels dots of 2.6 px are lost where the width is too large by a seventh."""
    drawn = sketch(320, 200)
    for at in (40, 160):
        drawn.line((40, at), (280, at), 2.4)
    for at in (40, 280):
        drawn.line((at, 40), (at, 160), 2.4)
    for at in (80, 120):
        for start in np.arange(40.0, 278.0 - dash, dash + gap):
            drawn.line((start, at), (start + dash, at), 2.4)
    sheet = _labelled(clean_sheet(drawn.grey), [np.s_[76:85, 44:277], np.s_[116:125, 44:277]])
    sheet = replace(sheet, stroke_width=wrong * sheet.stroke_width)
    view = find_shapes(sheet, (30.0, 30.0, 290.0, 170.0))
    rhythm = view_rhythm([view], sheet.stroke_width)
    strokes = classify_strokes(view, rhythm, view_pens([view], rhythm))
    hidden = [stroke for stroke in strokes if stroke.linetype is HIDDEN]
    assert sorted(item.start[1] - 0.5 for item in hidden) == pytest.approx([80.0, 120.0], abs=0.2)
    assert all(item.length == pytest.approx(240.0, abs=1.0) for item in hidden)
    assert len(strokes) == 6
