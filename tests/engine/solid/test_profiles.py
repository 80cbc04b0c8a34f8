"""Profiles turned around an axis, and swept along one."""

from math import pi

import numpy as np
import pytest
import shapely

from gaussiancad_core.geometry.outline_edges import enclosed_area
from gaussiancad_core.kernel.brep import soundness, volume
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.solid.profiles import Profile, edges_of, prism, turned

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


@pytest.mark.parametrize("radius", [0.2, 3.0])
@pytest.mark.parametrize("is_ccw", [True, False])
def test_edges_of_an_outline_are_its_lines_and_arcs(radius: float, is_ccw: bool) -> None:
    # With the smaller radius, a corner may be farther off than chords are long.
    plate = shapely.box(0.0, 0.0, 20.0, 10.0).buffer(radius, quad_segs=_CHORDS)
    corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0)]
    arcs = tuple(Arc(corner, radius, 0.0, 2.0 * pi, Linetype.VISIBLE) for corner in corners)
    ring = np.array(plate.exterior.normalize().coords)[:-1]
    if shapely.LinearRing(ring).is_ccw is not is_ccw:
        ring = ring[::-1]
    edges = edges_of(ring, Profile(plate, arcs, 0.05))
    assert [edge.circle is None for edge in edges].count(True) == 4
    rounds = [edge for edge in edges if edge.circle is not None]
    assert {edge.is_ccw for edge in rounds} == {is_ccw}
    assert sum(edge.sweep for edge in rounds) == pytest.approx(2.0 * pi, abs=1e-6)
    area = 200.0 + 60.0 * radius + pi * radius**2
    assert enclosed_area(edges) == pytest.approx(area if is_ccw else -area, rel=1e-6)
