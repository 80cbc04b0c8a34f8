"""Profiles turned around an axis, and swept along one."""

from math import pi

import pytest
import shapely

from gaussiancad_core.kernel.brep import soundness, volume
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.solid.profiles import Profile, prism, turned

_CHORDS = 24
"""Of a quarter of a circle: as fine as arcs are made of."""


def _circle(centre: tuple[float, float], radius: float) -> tuple[Arc, shapely.Polygon]:
    disc = shapely.Point(centre).buffer(radius, quad_segs=_CHORDS)
    return Arc(centre, radius, 0.0, 2.0 * pi, Linetype.VISIBLE), disc


@pytest.mark.parametrize("axis", [Axis.X, Axis.Z])
def test_steps_are_cylinders(axis: Axis) -> None:
    outline = shapely.Polygon([(0, 0), (0, 10), (30, 10), (30, 16), (50, 16), (50, 0)])
    solid = turned(Profile(outline, (), 0.01), axis)
    facts = soundness(solid)
    assert (facts.valid, facts.closed, facts.solids, facts.faces) == (True, True, 1, 5)
    assert volume(solid) == pytest.approx(pi * (100.0 * 30.0 + 256.0 * 20.0), rel=1e-9)


def test_an_arc_of_a_profile_is_one_face() -> None:
    arc, disc = _circle((20.0, 0.0), 20.0)
    half = disc.intersection(shapely.box(0.0, 0.0, 40.0, 20.0))
    solid = turned(Profile(half, (arc,), 0.05), Axis.X)
    assert soundness(solid).faces == 1
    assert volume(solid) == pytest.approx(4.0 / 3.0 * pi * 20.0**3, rel=1e-6)


def test_a_round_hole_of_a_profile_is_one_face() -> None:
    arc, disc = _circle((30.0, 20.0), 8.0)
    area = shapely.geometry.polygon.orient(shapely.box(0.0, 0.0, 60.0, 40.0).difference(disc))
    solid = prism(Profile(area, (arc,), 0.01), Axis.Y, (0.0, 5.0))
    assert soundness(solid).faces == 7
    assert volume(solid) == pytest.approx(5.0 * (60.0 * 40.0 - pi * 64.0), rel=1e-9)
