"""Strokes may go on to lines close by, and nowhere else."""

from itertools import pairwise

import pytest

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.curves import LineCurve
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.open_ends import with_open_ends
from gaussiancad_core.reasoning.spans import Support
from gaussiancad_core.reasoning.supports import find_supports
from gaussiancad_core.views import Arc, Linetype, Segment

_SIZE = (100.0, 60.0, 50.0)


def _views(*front: Segment | Arc) -> DrawnViews:
    def box(width: float, height: float) -> tuple[Segment, ...]:
        corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0)]
        return tuple(Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(corners))

    strokes = {
        Role.FRONT: (*box(100.0, 50.0), *front),
        Role.TOP: box(100.0, 60.0),
        Role.RIGHT: box(60.0, 50.0),
    }
    return DrawnViews(strokes, _SIZE, 0.2, 0.06)


def _slant(views: DrawnViews) -> Support:
    supports = with_open_ends(find_supports(views)).planes[Axis.Y].supports
    (slanted,) = (s for s in supports if isinstance(s.curve, LineCurve) and s.curve.axis is None)
    return slanted


def _hidden(*ends: tuple[float, float]) -> Segment:
    return Segment(*ends, Linetype.HIDDEN)


def test_a_slanted_line_may_go_on_to_the_next_line_within_reach() -> None:
    short = _hidden((20.0, 10.0), (50.0, 40.0))
    level, next_level = _hidden((30.0, 40.0), (90.0, 40.0)), _hidden((30.0, 41.0), (90.0, 41.0))
    slanted = _slant(_views(short, level, next_level))
    spans = sorted(slanted.spans[Role.FRONT], key=lambda span: span.low)
    assert [span.confidence for span in spans] == [1.0, 0.0]
    drawn, further = spans
    assert slanted.curve.at(drawn.high) == pytest.approx((50.0, 40.0))
    assert slanted.curve.at(further.low) == pytest.approx((50.0, 40.0))
    assert slanted.curve.at(further.high) == pytest.approx((51.0, 41.0))
    assert slanted.is_open_at(Role.FRONT, (further.low + further.high) / 2.0)
    assert slanted.linetype_at(Role.FRONT, (further.low + further.high) / 2.0) is None


@pytest.mark.parametrize(
    "other",
    [
        _hidden((30.0, 41.5), (90.0, 41.5)),
        _hidden((60.0, 41.0), (90.0, 41.0)),
        _hidden((30.0, 39.0), (90.0, 39.0)),
    ],
    ids=["far", "drawn elsewhere", "passed"],
)
def test_it_goes_nowhere_else(other: Segment) -> None:
    short, level = _hidden((20.0, 10.0), (50.0, 40.0)), _hidden((30.0, 40.0), (90.0, 40.0))
    slanted = _slant(_views(short, level, other))
    assert all(span.confidence > 0.0 for span in slanted.spans[Role.FRONT])


def test_lines_along_axes_may_go_on_to_the_outline_and_circles_stay() -> None:
    upright = Segment((40.0, 0.0), (40.0, 49.3), Linetype.VISIBLE)
    slope = Segment((10.0, 20.0), (40.0, 49.3), Linetype.VISIBLE)
    bore = Arc((70.0, 25.0), 10.0, 0.0, 6.283185307179586, Linetype.VISIBLE)
    plane = with_open_ends(find_supports(_views(upright, slope, bore))).planes[Axis.Y]
    for support in plane.supports:
        further = [s for s in support.spans[Role.FRONT] if s.confidence == 0.0]
        curve = support.curve
        goes_on = isinstance(curve, LineCurve) and 0.0 < curve.distance((0.0, 0.0)) < 45.0
        assert len(further) == int(goes_on and curve.axis != 1)
        for span in further:
            assert curve.at(span.high)[1] == pytest.approx(50.0)
