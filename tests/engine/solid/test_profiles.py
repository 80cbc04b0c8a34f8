"""Profiles turned around an axis, and plates as thick as told."""

from math import pi

import pytest
import shapely

from gaussiancad_core.axes import Axis
from gaussiancad_core.drawing.brep import soundness, volume
from gaussiancad_core.solid.profiles import profile_of, thickened, turned
from gaussiancad_core.views import Arc, Linetype, Segment, Stroke


def _line(start: tuple[float, float], end: tuple[float, float]) -> Segment:
    return Segment(start, end, Linetype.VISIBLE)


@pytest.mark.parametrize("axis", [Axis.X, Axis.Z])
def test_steps_are_cylinders(axis: Axis) -> None:
    strokes: list[Stroke] = [
        _line((0.0, 0.0), (0.0, 10.0)),
        _line((0.0, 10.0), (30.0, 10.0)),
        _line((30.0, 0.0), (30.0, 16.0)),
        _line((30.0, 16.0), (50.0, 16.0)),
        _line((50.0, 16.0), (50.0, 0.0)),
    ]
    outline = shapely.Polygon([(0, 0), (0, 10), (30, 10), (30, 16), (50, 16), (50, 0)])
    within = shapely.box(0.0, 0.0, 50.0, 16.0)
    profile = profile_of(strokes, within, lambda at: shapely.contains_xy(outline, *at), 0.01)
    assert profile is not None
    solid = turned(profile, axis)
    facts = soundness(solid)
    assert (facts.valid, facts.closed, facts.solids, facts.faces) == (True, True, 1, 5)
    assert volume(solid) == pytest.approx(pi * (100.0 * 30.0 + 256.0 * 20.0), rel=1e-9)


def test_an_arc_of_a_profile_is_one_face() -> None:
    strokes: list[Stroke] = [
        Arc((20.0, 0.0), 20.0, 0.0, pi, Linetype.VISIBLE),
        _line((0.0, 0.0), (40.0, 0.0)),
    ]
    within = shapely.box(0.0, 0.0, 40.0, 20.0)
    ball = shapely.Point(20.0, 0.0).buffer(19.9, quad_segs=64)
    profile = profile_of(strokes, within, lambda at: shapely.contains_xy(ball, *at), 0.05)
    assert profile is not None
    solid = turned(profile, Axis.X)
    assert soundness(solid).faces == 1
    assert volume(solid) == pytest.approx(4.0 / 3.0 * pi * 20.0**3, rel=1e-6)


def test_what_is_drawn_inside_a_plate_goes_through() -> None:
    circle = Arc((30.0, 20.0), 8.0, 0.0, 2.0 * pi, Linetype.VISIBLE)
    corners = [(0.0, 0.0), (60.0, 0.0), (60.0, 40.0), (0.0, 40.0)]
    sides = [_line(a, b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]
    hole = shapely.Point(30.0, 20.0).buffer(8.0, quad_segs=64)
    within = shapely.box(0.0, 0.0, 60.0, 40.0)
    profile = profile_of(
        [*sides, circle], within, lambda at: not shapely.contains_xy(hole, *at), 0.01
    )
    assert profile is not None
    solid = thickened(profile, 5.0)
    assert soundness(solid).faces == 7
    assert volume(solid) == pytest.approx(5.0 * (60.0 * 40.0 - pi * 64.0), rel=1e-9)
