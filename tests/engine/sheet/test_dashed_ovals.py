"""The hidden rest of an ellipse whose visible part is known."""

from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np
import pytest

from gaussiancad_core.sheet.dashed_ovals import with_dashed_rests
from gaussiancad_core.sheet.runs import Rhythm
from gaussiancad_core.views import Ellipse, Linetype, Segment, Stroke

_VISIBLE, _HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
_RHYTHM = Rhythm(12.0, 6.0)
_RIM = Ellipse((300.0, 400.0), 200.0, 140.0, 0.0, 0.0, pi, _VISIBLE)
"""Its upper half is open."""


def _dashes(start: float, end: float, beside: float) -> list[Stroke]:
    """Dashes by the rhythm between two parameters, that far inside of the ellipse."""
    inner = replace(
        _RIM,
        semi_major=_RIM.semi_major - beside,
        semi_minor=_RIM.semi_minor - beside,
        start=start,
        sweep=end - start,
    )
    points = inner.sample(_RHYTHM.dash / 2.0)
    return [
        Segment(tuple(a.tolist()), tuple(b.tolist()), _HIDDEN, 0.5)
        for a, b in pairwise(points[::2])
        if int(np.flatnonzero((points == a).all(axis=1))[0]) % 3 == 0
    ]


def test_dashes_beside_the_rest_of_an_ellipse_are_its_hidden_part() -> None:
    dashes = _dashes(pi + 0.05, 2.0 * pi - 0.05, 0.7)
    assert len(dashes) > 10
    shown, rest = with_dashed_rests([_RIM, *dashes], _RHYTHM)
    assert shown == _RIM
    assert isinstance(rest, Ellipse) and rest.linetype is _HIDDEN
    assert rest.whole == _RIM.whole
    assert rest.start == pytest.approx(pi) and rest.sweep == pytest.approx(pi)


def test_dashes_of_a_part_of_it_hide_that_part() -> None:
    dashes = _dashes(pi + 0.6, pi + 1.4, 0.7)
    _, rest = with_dashed_rests([_RIM, *dashes], _RHYTHM)
    assert isinstance(rest, Ellipse)
    assert rest.start == pytest.approx(pi + 0.6, abs=0.1)
    # The last dash may end a period before.
    assert rest.start + rest.sweep == pytest.approx(pi + 1.4, abs=0.16)


def test_dashes_elsewhere_stay() -> None:
    """Farther inside; on the visible part; and fewer than three."""
    for dashes in (
        _dashes(pi, 2.0 * pi, 4.0),
        _dashes(0.3, pi - 0.3, 0.7),
        _dashes(pi + 0.6, pi + 0.75, 0.7),
    ):
        assert dashes
        assert with_dashed_rests([_RIM, *dashes], _RHYTHM) == [_RIM, *dashes]


@pytest.mark.parametrize("beyond", [0.0, 0.18])
def test_one_begins_where_the_ellipse_touches_an_outline(beyond: float) -> None:
    """The first dash runs beside the outline, and was taken for the visible part's ink."""
    walls = [Segment((x, 400.0), (x, 0.0), _VISIBLE) for x in (100.0, 500.0)]
    read = replace(_RIM, sweep=pi + beyond)
    strokes = [*walls, read, *_dashes(pi + beyond + 0.02, 2.0 * pi - 0.05, 0.7)]
    *kept, shown, rest = with_dashed_rests(strokes, _RHYTHM)
    assert kept == walls
    assert isinstance(shown, Ellipse) and isinstance(rest, Ellipse)
    assert (shown.linetype, rest.linetype) == (_VISIBLE, _HIDDEN)
    assert shown.sweep == pytest.approx(pi, abs=0.01)
    assert rest.sweep == pytest.approx(pi, abs=0.01)
