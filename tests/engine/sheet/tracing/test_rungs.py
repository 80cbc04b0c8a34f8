"""Short strokes across the gap between two parallel lines."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.rungs import find_rungs
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

_TOP, _BOTTOM = 30.0, 130.0
_GROOVE = [(40.0, _TOP), (48.6, _TOP), (83.1, 64.5), (117.6, _TOP), (126.2, _TOP)]
"""The upper outline of a shaft with a groove and shoulders of 8.6 px beside it."""


def test_the_shoulders_of_a_groove_are_read(sketch) -> None:  # noqa: ANN001
    mirrored = [(x, _TOP + _BOTTOM - y) for x, y in _GROOVE]
    drawn = sketch().lines(*_GROOVE, *mirrored[::-1], _GROOVE[0])
    for (x, y), (_, end) in zip(_GROOVE[1:4], mirrored[1:4], strict=True):
        drawn.line((x, y), (x, end))
    drawn.line((126.2, 15.0), (126.2, 145.0))
    sheet = clean_sheet(drawn.grey)
    shapes = find_shapes(sheet, (36.0, 13.0, 130.0, 147.0))
    strokes = classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width))
    ends = (
        np.array([[stroke.start, stroke.end] for stroke in strokes if isinstance(stroke, Segment)])
        - 0.5
    )
    for corners in (_GROOVE, mirrored):
        for first in (0, 3):
            wanted = np.array(corners[first : first + 2])
            away = np.minimum(
                np.abs(ends - wanted).max(axis=(1, 2)), np.abs(ends - wanted[::-1]).max(axis=(1, 2))
            )
            assert away.min() < 0.5
    assert len(strokes) == len(ends) == 13


_LINES = ((60.0, 20.0), (60.0, 120.0)), ((70.0, 20.0), (70.0, 120.0))


def _placed(ends: tuple, linetype: Linetype = Linetype.VISIBLE) -> tuple[Line, Piece]:
    start, end = ends
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    line = Line(start, (float(way[0]) / length, float(way[1]) / length))
    return line, Piece(0.0, length, linetype, 1.0)


def test_a_rung_joins_both_lines_where_its_ink_is(sketch) -> None:  # noqa: ANN001
    drawn = sketch().line(*_LINES[0]).line(*_LINES[1]).line((60.0, 70.3), (70.0, 70.3))
    found = find_rungs([_placed(item) for item in _LINES], clean_sheet(drawn.grey), None)
    ((line, piece),) = found
    assert piece.linetype is Linetype.VISIBLE
    ends = sorted(line.at(at) for at in (piece.start, piece.end))
    assert np.array(ends) == pytest.approx(np.array([[60.0, 70.3], [70.0, 70.3]]), abs=0.2)


@pytest.mark.parametrize("what", ["a gap", "a blot", "a slanted line", "a line that is known"])
def test_there_is_no_rung(sketch, what: str) -> None:  # noqa: ANN001
    drawn = sketch().line(*_LINES[0]).line(*_LINES[1])
    pieces = [_placed(item) for item in _LINES]
    if what == "a gap":
        drawn.line((60.0, 70.0), (64.0, 70.0))
    elif what == "a blot":
        drawn.line((60.0, 70.0), (70.0, 70.0), width=9.0)
    elif what == "a slanted line":
        drawn.line((60.0, 66.0), (70.0, 72.0))
    else:
        across = (40.0, 70.0), (90.0, 70.0)
        drawn.line(*across)
        pieces.append(_placed(across))
    assert find_rungs(pieces, clean_sheet(drawn.grey), None) == []


@pytest.mark.parametrize(("width", "apart"), [(2.0, 4.6), (3.0, 5.6), (4.0, 6.6)])
def test_the_bottom_of_a_groove_with_little_paper_across(
    sketch,  # noqa: ANN001
    width: float,
    apart: float,
) -> None:
    far = 60.0 + apart
    drawn = sketch().line((60.0, 20.0), (60.0, 120.0), width).line((far, 20.0), (far, 120.0), width)
    drawn.line((60.0, 70.3), (far, 70.3), width)
    pieces = [_placed(((x, 20.0), (x, 120.0))) for x in (60.0, far)]
    ((line, piece),) = find_rungs(pieces, clean_sheet(drawn.grey), None)
    ends = sorted(line.at(at) for at in (piece.start, piece.end))
    assert np.array(ends) == pytest.approx(np.array([[60.0, 70.3], [far, 70.3]]), abs=0.3)
