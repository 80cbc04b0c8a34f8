"""Dashes that were read askew."""

from dataclasses import replace
from math import pi

import pytest

from gaussiancad_core.coordinates.skewed_dashes import without_askew_dashes
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_LINE = Segment((0.0, 10.0), (40.0, 10.0), Linetype.HIDDEN)
_TOLERANCE = 0.1


def _left(dash: Segment, line: Segment | Arc = _LINE) -> bool:
    views = DrawnViews({Role.FRONT: (line, dash)}, (40.0, 40.0, 40.0), _TOLERANCE)
    (_, *rest) = without_askew_dashes(views).strokes[Role.FRONT]
    return rest == [dash]


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_dash_that_leaves_its_line_a_little_goes(way: float) -> None:
    assert not _left(Segment((12.0, 10.0), (12.7, 10.0 + way * 0.15), Linetype.HIDDEN))
    # Lines on a slope have dashes, too.
    slope = Segment((0.0, 0.0), (30.0, 30.0), Linetype.HIDDEN)
    assert not _left(Segment((12.0, 12.0), (12.6 + way * 0.2, 12.6), Linetype.HIDDEN), slope)


@pytest.mark.parametrize(
    "stroke",
    [
        Segment((12.0, 10.0), (13.4, 10.15), Linetype.HIDDEN),
        Segment((12.0, 10.0), (12.7, 10.25), Linetype.HIDDEN),
        Segment((12.0, 10.0), (12.15, 10.15), Linetype.HIDDEN),
        Segment((12.0, 10.15), (12.7, 10.15), Linetype.HIDDEN),
        Segment((41.0, 10.0), (41.7, 10.15), Linetype.HIDDEN),
        Segment((12.0, 11.0), (12.7, 11.15), Linetype.HIDDEN),
    ],
    ids=["long", "far", "steep", "parallel", "beyond", "elsewhere"],
)
def test_other_strokes_stay(stroke: Segment) -> None:
    assert _left(stroke)


_CIRCLE = Arc((20.0, 10.0), 5.0, 0.0, 2.0 * pi, Linetype.HIDDEN)


def test_a_dash_that_touches_its_circle_goes() -> None:
    dash = Segment((19.5, 15.0), (20.5, 15.0), Linetype.HIDDEN)
    assert not _left(dash, _CIRCLE)
    # The arc is not drawn there, or as another line is.
    assert _left(dash, replace(_CIRCLE, start_angle=1.6, sweep=5.0))
    assert _left(dash, replace(_CIRCLE, linetype=Linetype.VISIBLE))
    assert _left(replace(dash, linetype=Linetype.VISIBLE), _CIRCLE)


@pytest.mark.parametrize(
    "stroke",
    [
        Segment((19.1, 15.0), (20.9, 15.0), Linetype.HIDDEN),
        Segment((20.0, 15.0), (21.1, 15.0), Linetype.HIDDEN),
        Segment((19.4, 15.1), (20.6, 15.1), Linetype.HIDDEN),
        Segment((20.0, 14.5), (20.0, 15.1), Linetype.HIDDEN),
    ],
    ids=["farther", "leaving", "beside", "across"],
)
def test_lines_that_a_circle_touches_stay(stroke: Segment) -> None:
    assert _left(stroke, _CIRCLE)


def test_a_long_line_along_a_wide_circle_stays() -> None:
    wide = replace(_CIRCLE, centre=(20.0, -85.0), radius=100.0)
    assert not _left(Segment((19.0, 15.0), (21.0, 15.0), Linetype.HIDDEN), wide)
    assert _left(Segment((18.7, 15.0), (21.3, 15.0), Linetype.HIDDEN), wide)
