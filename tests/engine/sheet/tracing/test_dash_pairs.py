"""Sheets whose hidden lines have two dashes each, or one."""

from typing import Any

import pytest

from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.dash_pairs import paired_rhythm
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import ViewShapes, find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

WIDTH, DASH, GAP = 2.0, 15.0, 15.0


def _shapes(drawn: Sketch) -> ViewShapes:
    height, width = drawn.weight.shape
    return find_shapes(clean_sheet(drawn.grey), (0.0, 0.0, float(width), float(height)))


def _pockets(sketch: Sketch, *lefts: float) -> Sketch:
    """A box with pockets below its upper side, 52 px deep and 44 px wide: their sides begin with a
    gap of 7 px, the bottom has a dash in each corner."""
    drawn = sketch(400, 200).lines(
        (20, 40), (380, 40), (380, 160), (20, 160), (20, 40), width=WIDTH
    )
    for left in lefts:
        for x in (left, left + 44.0):
            drawn.broken((x, 47), (x, 92), (DASH, GAP), WIDTH)
        drawn.line((left, 92), (left + 14.0, 92), WIDTH).line(
            (left + 30.0, 92), (left + 44.0, 92), WIDTH
        )
    return drawn


def test_pairs_of_dashes_tell_the_rhythm(sketch: Sketch) -> None:
    view = _shapes(_pockets(sketch, 60.0, 200.0))
    rhythm = view_rhythm([view], view.sheet.stroke_width)
    assert (rhythm.dash, rhythm.gap) == pytest.approx((DASH, GAP), abs=1.5)
    hidden = [s for s in classify_strokes(view, rhythm) if s.linetype is Linetype.HIDDEN]
    assert len(hidden) == 6
    assert all(isinstance(stroke, Segment) for stroke in hidden)
    ends = sorted(sorted((s.start, s.end)) for s in hidden)
    for left in (60.5, 200.5):
        for start, end in (
            ((left, 40.5), (left, 92.5)),
            ((left, 92.5), (left + 44.0, 92.5)),
            ((left + 44.0, 40.5), (left + 44.0, 92.5)),
        ):
            near = [this_end for this_end in ends if this_end[0] == pytest.approx(start, abs=1.0)]
            assert any(item[1] == pytest.approx(end, abs=1.0) for item in near)


def test_two_pairs_tell_nothing(sketch: Sketch) -> None:
    drawn = _pockets(sketch)
    for x in (60, 120):
        drawn.broken((x, 47), (x, 92), (DASH, GAP), WIDTH)
    view = _shapes(drawn)
    width = view.sheet.stroke_width
    assert view_rhythm([view], width) == Rhythm(4.0 * width + 2.0, 2.0 * width + 1.0)


def test_edges_on_one_line_are_no_dashes(sketch: Sketch) -> None:
    drawn = sketch(400, 200).lines(
        (20, 20), (380, 20), (380, 180), (20, 180), (20, 20), width=WIDTH
    )
    for top in (60.0, 100.0):
        for left in (60.0, 90.0, 200.0, 320.0):
            box = (
                (left, top),
                (left + 15, top),
                (left + 15, top + 22),
                (left, top + 22),
                (left, top),
            )
            drawn.lines(*box, width=WIDTH)
    view = _shapes(drawn)
    drawn_runs = [(view.field, shape.geometry, shape.runs) for shape in view.shapes]
    assert paired_rhythm(drawn_runs, view.sheet.stroke_width) is None
    found = classify_strokes(view, view_rhythm([view], view.sheet.stroke_width))
    assert {stroke.linetype for stroke in found} == {Linetype.VISIBLE}
