"""Axes of round faces, and what lies across them."""

import numpy as np
import pytest

from gaussiancad_core.features.round_axes import around, axis_through, by_axis, levels_along
from gaussiancad_core.features.solid_faces import Kind, solid_faces
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import cone, cylinder, fuse

_UP = np.array([0.0, 0.0, 1.0])
_PIN = fuse(
    cylinder(Axis.Z, (30.0, 20.0), 8.0, 0.0, 10.0),
    cone(Axis.Z, (30.0, 20.0), (8.0, 4.0), 10.0, 15.0),
    cylinder(Axis.X, (20.0, 5.0), 2.0, 30.0, 50.0),
)


def test_faces_about_one_line_have_one_axis_whichever_way_theirs_points() -> None:
    round_faces = [f for f in solid_faces(_PIN) if f.kind in (Kind.CYLINDER, Kind.CONE)]
    upright, level = sorted(by_axis(round_faces), key=lambda axis: -len(axis.faces))
    assert {face.kind for face in upright.faces} == {Kind.CYLINDER, Kind.CONE}
    assert upright.point == pytest.approx([30.0, 20.0, 0.0])
    assert level.direction == pytest.approx([1.0, 0.0, 0.0])
    assert upright.is_as(axis_through(np.array([30.0, 20.0, 7.0]), -_UP))
    assert upright.off(np.array([33.0, 24.0, 99.0])) == pytest.approx(5.0)


def test_levels_are_those_of_planes_across() -> None:
    levels = levels_along(solid_faces(_PIN), np.array([0.0, 0.0, 1.0]), _UP)
    assert sorted(levels) == pytest.approx([-1.0, 14.0])


def test_points_around_an_axis_are_equally_far_from_it() -> None:
    axis = axis_through(np.array([3.0, 4.0, 9.0]), _UP)
    found = list(around(axis.point, axis.direction, 2.5, 6, 0.1))
    assert len(found) == 6
    assert [axis.off(place) for place in found] == pytest.approx([2.5] * 6)
    assert {round(float(place[2]), 9) for place in found} == {0.0}
