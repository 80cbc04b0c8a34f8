"""Steps of a few line widths between lines that end at them."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.outline_jogs import find_jogs
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

_STEP = [(110.0, 112.0), (110.0, 120.0)]
"""Eight px down in a lower edge: one leg between parallel lines."""

_NOTCH = [(153.0, 30.0), (153.0, 38.5), (170.0, 38.5)]
"""A corner taken off: two legs between lines at right angles."""

_OUTLINE = [(30.0, 30.0), *_NOTCH, (170.0, 120.0), *_STEP[::-1], (30.0, 112.0), (30.0, 30.0)]


def test_steps_and_notches_of_an_outline_are_read(sketch) -> None:  # noqa: ANN001
    sheet = clean_sheet(sketch().lines(*_OUTLINE).grey)
    shapes = find_shapes(sheet, (28.0, 28.0, 172.0, 122.0))
    strokes = classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width))
    assert len(strokes) == len(_OUTLINE) - 1
    sides = [np.array([a, b]) + 0.5 for a, b in pairwise(_OUTLINE)]
    for stroke in strokes:
        assert isinstance(stroke, Segment) and stroke.linetype is Linetype.VISIBLE
        ends = np.array([stroke.start, stroke.end])
        away = [min(np.abs(ends - side).max(), np.abs(ends - side[::-1]).max()) for side in sides]
        assert min(away) < 0.5
        sides.pop(int(np.argmin(away)))


def _placed(
    start: tuple[float, float], end: tuple[float, float], linetype: Linetype = Linetype.VISIBLE
) -> tuple[Line, Piece]:
    length = float(np.hypot(*np.subtract(end, start)))
    direction = np.subtract(end, start) / length
    line = Line(start, (float(direction[0]), float(direction[1])))
    return line, Piece(0.0, length, linetype, 1.0)


_LEFT, _RIGHT = ((30.0, 112.0), (111.5, 112.0)), ((108.5, 120.0), (170.0, 120.0))
"""The lines beside the step, as far as their ink reaches."""


def test_the_leg_lies_where_the_ink_of_both_lines_ends(sketch) -> None:  # noqa: ANN001
    sheet = clean_sheet(sketch().lines((30.0, 112.0), *_STEP, (170.0, 120.0)).grey)
    ((line, piece),) = find_jogs([_placed(*_LEFT), _placed(*_RIGHT)], sheet)
    found = np.array([line.at(piece.start), line.at(piece.end)])
    assert found == pytest.approx(np.array(_STEP), abs=0.3)


@pytest.mark.parametrize("blank", ["no ink", "hidden", "something else ends there"])
def test_there_is_no_leg(sketch, blank: str) -> None:  # noqa: ANN001
    drawn = sketch().line(*_LEFT).line(*_RIGHT)
    if blank != "no ink":
        drawn.line(*_STEP)
    sheet = clean_sheet(drawn.grey)
    linetype = Linetype.HIDDEN if blank == "hidden" else Linetype.VISIBLE
    pieces = [_placed(*_LEFT, linetype), _placed(*_RIGHT)]
    if blank == "something else ends there":
        pieces.append(_placed((110.0, 112.0), (110.0, 60.0)))
    assert find_jogs(pieces, sheet) == []
