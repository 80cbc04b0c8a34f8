"""Strokes that stick out of a view are no edges of the part."""

from itertools import pairwise
from typing import Any

import pytest

from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.registration.view_masks import Outline, find_outline
from gaussiancad_core.sheet.views.outside_strokes import without_outside

Sketch = Any
"""The class that the fixture gives."""

VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
BOX = (60.0, 60.0, 200.0, 160.0)


def _outline(drawn: Sketch) -> Outline:
    outline = find_outline(clean_sheet(drawn.grey), (58.0, 58.0, 203.0, 163.0), 2)
    assert outline is not None
    return outline


def _rectangle() -> tuple[Stroke, ...]:
    x0, y0, x1, y1 = (value + 0.5 for value in BOX)
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
    return tuple(Segment(start, end, VISIBLE) for start, end in pairwise(corners))


def _drawn(sketch: Sketch) -> Sketch:
    x0, y0, x1, y1 = BOX
    return sketch(260, 220).lines((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))


def test_the_edges_of_a_part_stay(sketch: Sketch) -> None:
    drawn = (
        _drawn(sketch).line((60, 100), (200, 100)).line((60, 103), (200, 103)).arc((130, 130), 9)
    )
    strokes = (
        *_rectangle(),
        Segment((60.5, 100.5), (200.5, 100.5), VISIBLE),
        Segment((60.5, 103.5), (200.5, 103.5), HIDDEN),
        Arc((130.5, 130.5), 9.0, 0.0, 6.28, VISIBLE),
    )
    assert without_outside(strokes, _outline(drawn)) == strokes


@pytest.mark.parametrize("linetype", [VISIBLE, HIDDEN])
def test_what_is_outside_goes(sketch: Sketch, linetype: Linetype) -> None:
    drawn = _drawn(sketch).line((200, 90), (228, 90)).line((222, 80), (222, 100))
    neighbours = (
        Segment((200.5, 90.5), (228.5, 90.5), linetype),
        Segment((222.5, 80.5), (222.5, 100.5), linetype),
    )
    strokes = _rectangle()
    assert without_outside((*strokes, *neighbours), _outline(drawn)) == strokes


def test_an_edge_that_sticks_out_ends_at_the_outline(sketch: Sketch) -> None:
    drawn = _drawn(sketch).line((60, 90), (215, 90))
    long = Segment((60.5, 90.5), (215.5, 90.5), VISIBLE)
    *rest, cut = without_outside((*_rectangle(), long), _outline(drawn))
    assert tuple(rest) == _rectangle()
    assert isinstance(cut, Segment)
    assert cut.start == pytest.approx((60.5, 90.5))
    assert cut.end == pytest.approx((200.5, 90.5))


def test_a_corner_that_the_outline_was_closed_before_stays(sketch: Sketch) -> None:
    x0, y0, x1, y1 = BOX
    drawn = sketch(260, 220).lines((x1 - 6, y0), (x0, y0), (x0, y1), (x1, y1), (x1, y0 + 6))
    assert without_outside(_rectangle(), _outline(drawn)) == _rectangle()


def test_a_corner_of_hidden_lines_outside_is_none_of_the_part(sketch: Sketch) -> None:
    corner = (130.5, 54.5)
    hidden = Segment((130.5, 120.5), corner, HIDDEN), Segment((150.5, 94.5), corner, HIDDEN)
    found = without_outside((*_rectangle(), *hidden), _outline(_drawn(sketch)))
    assert all(stroke.end[1] > 58.0 for stroke in found[4:] if isinstance(stroke, Segment))


def test_where_most_would_go_the_outline_is_wrong(sketch: Sketch) -> None:
    outline = _outline(_drawn(sketch))
    far = tuple(Segment((10.0, y), (50.0, y), VISIBLE) for y in (20.0, 60.0, 100.0, 140.0))
    assert without_outside((*_rectangle(), *far), outline) == (*_rectangle(), *far)
