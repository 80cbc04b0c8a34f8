"""How far faces lie beside those of another solid."""

import numpy as np
import pytest

from benchmarks.judge.displacements import displacements
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder, sphere


def test_each_face_is_as_far_off_as_it_was_moved() -> None:
    one = cut(box((0, 0, 0), (50, 40, 30)), cylinder(Axis.Z, (20, 20), 8.0, 10.0, 40))
    other = cut(box((0, 0, 0), (50, 40.1, 30)), cylinder(Axis.Z, (20, 20), 8.05, 10.02, 40))
    found = displacements(one, other)
    moved = {(face.kind, face.axis, round(face.place)): face for face in found.moved}
    assert len(found.moved) == len(found.other) == 8
    assert moved["plane", 1, 40].shift == pytest.approx(-0.1, abs=1e-9)
    assert moved["cylinder", None, 0].median == pytest.approx(0.05, abs=1e-9)
    assert moved["plane", 2, 10].shift == pytest.approx(-0.02, abs=1e-9)
    still = [face for face in found.moved if face.median < 1e-9]
    assert len(still) == 5
    assert found.farthest == pytest.approx(0.1, abs=1e-9)
    assert found.within(0.05 + 1e-9) == pytest.approx(14 / 16)


def test_a_cavity_is_far_off_from_a_solid_without() -> None:
    block = box((0, 0, 0), (50, 50, 50))
    hollow = cut(block, sphere((25, 25, 25), 5.0))
    there, back = displacements(block, hollow), displacements(hollow, block)
    # The block's nearest side is 20 mm from the ball's poles, 22.1 mm from what lies between.
    assert 20.5 < there.farthest < 22.2 and 20.5 < back.farthest < 22.2
    assert np.sort(there.medians)[-2] == pytest.approx(0.0, abs=1e-9)


def test_points_are_inside_where_borders_are_hollow() -> None:
    # Triangles between the holes cut across their circles.
    centres = [(10 + 12 * i, 10 + 12 * j) for i in range(4) for j in range(3)]
    bores = [cylinder(Axis.Z, centre, 5.9, -1, 11) for centre in centres]
    plate = cut(box((0, 0, 0), (56, 44, 10)), *bores)
    found = displacements(plate, plate, points=400)
    assert found.farthest < 1e-9
