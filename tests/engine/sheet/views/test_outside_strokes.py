"""Strokes that stick out of a view are no edges of the part."""

from typing import Any

import pytest

from gaussiancad_core.model.views import Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

BOX = (60.0, 60.0, 200.0, 160.0)


def _plate(sketch: Sketch) -> Any:  # noqa: ANN401
    return sketch(260, 220).box(*BOX)


def test_the_edges_of_a_part_stay(sketch: Sketch) -> None:
    drawn = _plate(sketch).line((60, 100), (200, 100)).line((60, 105), (200, 105))
    assert drawn.arc((130, 130), 9).misread() == []


def test_what_is_outside_goes(sketch: Sketch) -> None:
    drawn = _plate(sketch).ink((200, 90), (228, 90)).ink((222, 80), (222, 100))
    assert drawn.misread() == []


def test_an_edge_that_sticks_out_ends_at_the_outline(sketch: Sketch) -> None:
    drawn = _plate(sketch).ink((60, 90), (215, 90))
    drawn.shows(Segment((60.5, 90.5), (200.5, 90.5), Linetype.VISIBLE))
    assert drawn.misread(0.6) == []


@pytest.mark.parametrize("short", [3.0, 6.0])
def test_a_corner_that_the_outline_was_closed_before_stays(sketch: Sketch, short: float) -> None:
    x0, y0, x1, y1 = BOX
    drawn = sketch(260, 220)
    drawn.ink((x1 - short, y0), (x0, y0), (x0, y1), (x1, y1), (x1, y0 + short))
    drawn.drawn = _plate(sketch).drawn
    assert drawn.misread(2.5 if short < 4.0 else 7.0) == []


def test_where_most_would_go_the_outline_is_wrong(sketch: Sketch) -> None:
    drawn = sketch(360, 220).box(*BOX)
    for y in (70.0, 90.0, 110.0, 130.0):
        drawn.line((200, y), (330, y))
    ends = [max(stroke.start[0], stroke.end[0]) for stroke in drawn.strokes()]
    assert sum(end > 320.0 for end in ends) == 4
