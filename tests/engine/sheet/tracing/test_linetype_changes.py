"""A line goes from visible to hidden where another stroke meets it."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.junctions import Placed
from gaussiancad_core.sheet.tracing.linetype_changes import with_changes_at_junctions

RHYTHM = Rhythm(12.0, 6.0)
PEN = 2.0
LEVEL = Line((0.0, 50.0), (1.0, 0.0))


def _piece(start: float, end: float, linetype: Linetype = Linetype.VISIBLE) -> Piece:
    return Piece(start, end, linetype, 1.0)


def _upright(x: float, low: float = 20.0, high: float = 80.0) -> Placed:
    return Line((x, 0.0), (0.0, 1.0)), _piece(low, high)


def _changed(*pieces: Placed) -> list[tuple[float, float, str]]:
    """Start, end and kind of what lies on the level line."""
    found = with_changes_at_junctions(pieces, RHYTHM, PEN)
    assert len(found) >= len(pieces) - 1
    return sorted(
        (round(item.start, 3), round(item.end, 3), item.linetype.value)
        for line, item in found
        if line == LEVEL
    )


@pytest.mark.parametrize(
    "crossing", [_upright(112.0), _upright(112.0, 50.0), _upright(112.0, 52.0)]
)
@pytest.mark.parametrize("turned", [False, True])
def test_the_last_dash_of_a_hidden_line_is_not_the_beginning_of_the_edge_beyond(
    crossing: Placed, turned: bool
) -> None:
    visible, hidden = _piece(101.0, 200.0), _piece(20.0, 101.0, Linetype.HIDDEN)
    wanted = [(20.0, 112.0, "hidden"), (112.0, 200.0, "visible")]
    if turned:
        visible, hidden = _piece(20.0, 123.0), _piece(123.0, 200.0, Linetype.HIDDEN)
        wanted = [(20.0, 112.0, "visible"), (112.0, 200.0, "hidden")]
    assert _changed((LEVEL, visible), (LEVEL, hidden), crossing) == wanted


def test_a_change_where_another_stroke_meets_the_line_stays() -> None:
    pieces = (LEVEL, _piece(101.0, 200.0)), (LEVEL, _piece(20.0, 101.0, Linetype.HIDDEN))
    wanted = [(20.0, 101.0, "hidden"), (101.0, 200.0, "visible")]
    assert _changed(*pieces, _upright(99.0), _upright(112.0)) == wanted
    # Nor is there a place for it without one near.
    assert _changed(*pieces, _upright(140.0)) == wanted


def test_dashes_of_a_line_and_of_an_arc_that_leaves_it_are_no_visible_line() -> None:
    radius = 140.0
    arc = Circle((20.0, 50.0 + radius), radius)
    quarter = Piece(1.5 * np.pi * radius, 2.0 * np.pi * radius, Linetype.HIDDEN, 1.0)
    seen, hidden = _piece(20.0, 42.0), _piece(42.0, 300.0, Linetype.HIDDEN)
    pieces = (LEVEL, seen), (LEVEL, hidden), (arc, quarter)
    assert _changed(*pieces) == [(20.0, 300.0, "hidden")]
    # A longer stretch is what it looks like.
    seen, hidden = _piece(20.0, 62.0), _piece(62.0, 300.0, Linetype.HIDDEN)
    assert len(_changed((LEVEL, seen), (LEVEL, hidden), (arc, quarter))) == 2
