import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import bounding_box, faces_of, soundness, volume
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import (
    box,
    chamfered,
    cone,
    cut,
    cylinder,
    edges_along,
    edges_where,
    filleted,
    fuse,
    leaning_cylinder,
    prism,
    revolved,
    slot,
    sphere,
)

PI = float(np.pi)


@pytest.mark.parametrize(
    ("shape", "corners", "expected"),
    [
        (box((1, 2, 3), (4, 6, 8)), ((1, 2, 3), (4, 6, 8)), 60.0),
        (cylinder(Axis.X, (5, 6), 2, 1, 4), ((1, 3, 4), (4, 7, 8)), 12 * PI),
        (cylinder(Axis.Y, (5, 6), 2, 1, 4), ((3, 1, 4), (7, 4, 8)), 12 * PI),
        (cylinder(Axis.Z, (5, 6), 2, 1, 4), ((3, 4, 1), (7, 8, 4)), 12 * PI),
        (cone(Axis.Z, (0, 0), (3, 1), 0, 6), ((-3, -3, 0), (3, 3, 6)), 26 * PI),
        (sphere((1, 1, 1), 3), ((-2, -2, -2), (4, 4, 4)), 36 * PI),
        (prism(Axis.Y, [(0, 0), (4, 0), (0, 3)], 2, 7), ((0, 2, 0), (4, 7, 3)), 30.0),
        (slot(Axis.Z, ((2, 2), (8, 2)), 2, 0, 5), ((0, 0, 0), (10, 4, 5)), 120 + 20 * PI),
        (
            revolved([(0, 1), (0, 3), (2, 3), (2, 1)], Axis.X, (3, 3)),
            ((0, 0, 0), (2, 6, 6)),
            16 * PI,
        ),
    ],
)
def test_shapes_are_where_and_as_large_as_they_say(
    shape: TopoDS_Shape, corners: tuple, expected: float
) -> None:
    np.testing.assert_allclose(bounding_box(shape), corners, atol=1e-6)
    assert volume(shape) == pytest.approx(expected, rel=1e-9)
    assert soundness(shape).valid


def test_a_leaning_cylinder_leans() -> None:
    rod = leaning_cylinder((10, 20, 30), (0, 3, 4), 5, 20)
    assert volume(rod) == pytest.approx(500 * PI)
    low, high = bounding_box(rod)
    np.testing.assert_allclose((low + high) / 2.0, (10, 20, 30), atol=1e-6)
    np.testing.assert_allclose(
        high - low, (10, 20 * 0.6 + 10 * 0.8, 20 * 0.8 + 10 * 0.6), atol=1e-6
    )


def test_faces_that_continue_each_other_become_one() -> None:
    assert len(faces_of(fuse(box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (2, 1, 1))))) == 6
    assert len(faces_of(cut(box((0, 0, 0), (2, 1, 1)), box((1, -1, -1), (3, 2, 2))))) == 6


def test_edges_are_chosen_by_where_they_are() -> None:
    block = box((0, 0, 0), (8, 6, 4))
    assert len(edges_along(block, Axis.Z, [(0, 0), (8, 6), (5, 5)])) == 2
    assert len(edges_along(block, Axis.X, [(0, 4)])) == 1
    assert len(edges_where(block, lambda one, other: one[2] == other[2] == 4)) == 4


def test_rounding_and_bevelling_take_off_what_they_should() -> None:
    block = box((0, 0, 0), (8, 6, 4))
    edges = edges_along(block, Axis.Z, [(0, 0), (8, 0)])
    assert volume(filleted(block, edges, 2)) == pytest.approx(192 - 2 * (4 - PI) * 4)
    assert volume(chamfered(block, edges, 2)) == pytest.approx(192 - 2 * 2 * 4)
