"""Short strokes aslant across the gap between two parallel lines."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.line_widths import Pens
from gaussiancad_core.sheet.tracing.slanted_rungs import find_slanted_rungs
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

_PEN = 2.7


def _segments(drawn: Sketch, box: tuple[float, float, float, float]) -> list[np.ndarray]:
    """Ends of the strokes of a view, (2, 2) px each; all of them are straight."""
    sheet = clean_sheet(drawn.grey)
    shapes = find_shapes(sheet, box)
    strokes = classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width))
    assert all(isinstance(stroke, Segment) for stroke in strokes)
    return [np.array([stroke.start, stroke.end]) - 0.5 for stroke in strokes]


def _is_read(found: list[np.ndarray], start: tuple, end: tuple) -> bool:
    wanted = np.array([start, end])
    return any(min(np.abs(item - w).max() for w in (wanted, wanted[::-1])) < 0.5 for item in found)


@pytest.mark.parametrize("deep", [5.3, 6.2, 7.1, 8.3, 9.2])
@pytest.mark.parametrize("offset", [7.1, 24.0, 33.0])
def test_the_flanks_of_a_narrow_groove(sketch: Sketch, deep: float, offset: float) -> None:
    """Between two flanges, and with a shoulder on either side of it."""
    levels = [35.3, 35.3 + offset, 35.3 + offset + deep, 35.3 + offset + 2.0 * deep]
    levels.append(levels[-1] + offset)
    drawn = sketch(200, 180)
    left = list(zip([40.0, 40.0, 40.0 + deep, 40.0, 40.0], levels, strict=True))
    right = [(200.0 - x, y) for x, y in left]
    drawn.lines(*left, width=_PEN).lines(*right, width=_PEN)
    for one, other in zip(left[1:-1], right[1:-1], strict=True):
        drawn.line(one, other, _PEN)
    for near, far in ((levels[0], levels[0] - 18.0), (levels[-1], levels[-1] + 18.0)):
        drawn.lines((30, near), (170, near), (170, far), (30, far), (30, near), width=_PEN)
    found = _segments(drawn, (28.0, 15.0, 172.0, levels[-1] + 20.0))
    for side in (left, right):
        assert all(_is_read(found, *side[k : k + 2]) for k in range(4))
    assert len(found) == 19


def test_an_undercut_ends_where_nothing_else_does(sketch: Sketch) -> None:
    """Its flank leads from the corner of a shoulder to the next face, along which nothing ends."""
    drawn = sketch(200, 140)
    left, right = [(50.0, 20.0), (50.0, 60.0), (56.2, 66.2)], [(150.0, 20.0), (150.0, 60.0)]
    right.append((143.8, 66.2))
    drawn.lines(*left, width=_PEN).lines(*right, width=_PEN).line(left[0], right[0], _PEN)
    drawn.line(left[1], right[1], _PEN)
    drawn.lines(
        (30.0, 66.2), (170.0, 66.2), (170.0, 110.0), (30.0, 110.0), (30.0, 66.2), width=_PEN
    )
    found = _segments(drawn, (28.0, 18.0, 172.0, 112.0))
    assert _is_read(found, *left[1:])
    assert _is_read(found, *right[1:])
    assert len(found) == 10


_LINES = ((60.0, 20.0), (60.0, 120.0)), ((68.0, 20.0), (68.0, 120.0))


def _placed(start: tuple[float, float], end: tuple[float, float]) -> tuple[Line, Piece]:
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    line = Line(start, (float(way[0]) / length, float(way[1]) / length))
    return line, Piece(0.0, length, Linetype.VISIBLE, 1.0)


@pytest.mark.parametrize("what", ["a rung", "a blot", "a bend", "a known line", "a gap"])
def test_there_is_none(sketch: Sketch, what: str) -> None:
    drawn = sketch().line(*_LINES[0], _PEN).line(*_LINES[1], _PEN)
    pieces = [_placed(*item) for item in _LINES]
    if what == "a rung":
        drawn.line((60.0, 70.0), (68.0, 70.0), _PEN)
    elif what == "a blot":
        drawn.filled((58.0, 60.0), (70.0, 66.0), (70.0, 80.0), (58.0, 74.0))
    elif what == "a bend":
        drawn.lines((60.0, 66.0), (64.0, 71.0), (68.0, 66.0), width=_PEN)
    elif what == "a known line":
        drawn.line((52.0, 62.0), (76.0, 86.0), _PEN)
        pieces.append(_placed((52.0, 62.0), (76.0, 86.0)))
    else:
        drawn.line((60.0, 66.0), (63.0, 69.0), _PEN)
    assert find_slanted_rungs(pieces, clean_sheet(drawn.grey)) == []


@pytest.mark.parametrize(("width", "kind"), [(1.6, Linetype.HIDDEN), (2.7, Linetype.VISIBLE)])
def test_where_pens_differ_its_width_tells_its_linetype(
    sketch: Sketch, width: float, kind: Linetype
) -> None:
    drawn = sketch().line(*_LINES[0], _PEN).line(*_LINES[1], _PEN)
    drawn.line((60.0, 66.0), (68.0, 74.0), width)
    sheet, pieces = clean_sheet(drawn.grey), [_placed(*item) for item in _LINES]
    ((_, piece),) = find_slanted_rungs(pieces, sheet, Pens(hidden=2.0, visible=2.3))
    assert piece.linetype is kind
