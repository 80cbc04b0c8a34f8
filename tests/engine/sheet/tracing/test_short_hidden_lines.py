"""Hidden lines are led on to the corner that another one ends at."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.short_hidden_lines import with_corners_reached

RHYTHM = Rhythm(12.0, 6.0)
LEVEL = Line((100.0, 50.0), (1.0, 0.0))
SLANT = Line((100.0, 50.0), (float(np.cos(1.2)), float(np.sin(1.2))))
UPRIGHT = Line((95.5, 0.0), (0.0, 1.0))


def _placed(line: Line, start: float, end: float, kind: Linetype = Linetype.HIDDEN) -> Placed:
    return line, Piece(start, end, kind, 1.0)


def test_a_slant_that_ended_at_a_line_on_the_way_goes_on() -> None:
    ended = [
        _placed(LEVEL, 0.0, 80.0),
        _placed(SLANT, -70.0, -12.0),
        _placed(UPRIGHT, -200.0, 200.0),
    ]
    found = with_corners_reached(ended, RHYTHM)
    assert found[1][1].end == pytest.approx(0.0, abs=1e-9)
    assert [found[0], found[2]] == [ended[0], ended[2]]


@pytest.mark.parametrize("gap", [-19.0, 0.5])
def test_farther_ones_and_those_that_pass_stay(gap: float) -> None:
    ended = [_placed(LEVEL, 0.0, 80.0), _placed(SLANT, -70.0, gap)]
    assert with_corners_reached(ended, RHYTHM) == ended


def test_an_end_that_meets_a_stroke_is_no_corner() -> None:
    meeting = Line((100.0, 0.0), (0.0, 1.0))
    ended = [
        _placed(LEVEL, 0.0, 80.0),
        _placed(SLANT, -70.0, -12.0),
        _placed(meeting, 0.0, 200.0, Linetype.VISIBLE),
    ]
    assert with_corners_reached(ended, RHYTHM) == ended
