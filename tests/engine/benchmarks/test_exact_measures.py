import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_measures import (
    closeness,
    fine_mesh,
    mesh_iou,
    mirrored_alike,
    placed,
    registered,
    rotations,
    sight_iou,
    solid_iou,
)
from gaussiancad_core.kernel.brep import bounding_box, volume
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.meshes import make_mesh
from sample_parts.modelling import box, cut, cylinder


@pytest.fixture(scope="module")
def bracket() -> TopoDS_Shape:
    """An angle with a bore, like none of its mirror images."""
    angle = cut(box((0, 0, 0), (60, 40, 30)), box((20, -1, 10), (61, 41, 31)))
    return cut(angle, cylinder(Axis.Z, (45, 12), 5, -1, 31), box((-1, 30, 20), (8, 41, 31)))


def test_a_solid_is_itself(bracket: TopoDS_Shape) -> None:
    same = closeness(bracket, bracket)
    assert same.exact
    assert (same.iou, same.mesh_iou) == (pytest.approx(1.0), pytest.approx(1.0))
    assert same.faces == same.true_faces


def test_both_booleans_measure_volumes() -> None:
    one, other = box((0, 0, 0), (10, 10, 10)), box((5, 0, 0), (15, 10, 10))
    assert solid_iou(one, other) == pytest.approx(1.0 / 3.0)
    assert mesh_iou(fine_mesh(one), fine_mesh(other)) == pytest.approx(1.0 / 3.0)
    bored = cut(one, cylinder(Axis.Z, (5, 5), 3, -1, 11))
    expected = 1.0 - 0.09 * np.pi
    assert solid_iou(one, bored) == pytest.approx(expected)
    assert mesh_iou(fine_mesh(one), fine_mesh(bored)) == pytest.approx(expected, abs=1e-3)


def test_lines_of_sight_measure_volumes_like_booleans() -> None:
    one = box((0, 0, 0), (10, 10, 10))
    bored = cut(one, cylinder(Axis.X, (5, 5), 3, -1, 11))
    assert sight_iou(one, box((5, 0, 0), (15, 10, 10))) == pytest.approx(1.0 / 3.0, abs=2e-3)
    assert sight_iou(one, bored) == pytest.approx(1.0 - 0.09 * np.pi, abs=2e-3)


def test_a_solid_that_touches_itself_is_measured_where_booleans_find_nothing() -> None:
    """A wide bore touches two walls: the corner between hangs on lines."""
    bores = (cylinder(Axis.Z, (10, 10), 9, 4, 11), cylinder(Axis.Z, (10, 10), 10, 7, 11))
    touching = cut(box((0, 0, 0), (20, 30, 10)), *bores)
    nearly = placed(touching, np.eye(3), 0.999999)
    assert solid_iou(touching, nearly) == 0.0
    assert closeness(touching, nearly).iou == pytest.approx(1.0, abs=1e-4)


def test_a_solid_turned_inside_out_is_not_valid(bracket: TopoDS_Shape) -> None:
    inverted = bracket.Reversed()
    assert volume(inverted) < 0.0
    assert solid_iou(inverted, bracket) is None
    close = closeness(inverted, bracket)
    assert not close.valid and not close.exact


def test_a_thin_difference_is_not_exact(bracket: TopoDS_Shape) -> None:
    close = closeness(cut(bracket, cylinder(Axis.Z, (30, 30), 3, -1, 31)), bracket)
    assert close.valid
    assert 0.98 < close.iou < 0.999
    assert not close.exact
    assert close.faces == close.true_faces + 1


@pytest.mark.parametrize("index", range(3))
def test_mirror_images_are_told(bracket: TopoDS_Shape, index: int) -> None:
    matrix = np.eye(3)
    matrix[index, index] = -1.0
    mirrored = placed(bracket, matrix)
    assert volume(mirrored) == pytest.approx(volume(bracket))
    np.testing.assert_allclose(bounding_box(mirrored), bounding_box(bracket), atol=1e-6)
    assert mirrored_alike(mirrored, bracket) == "xyz"[index]
    assert not closeness(mirrored, bracket).exact


def test_there_are_24_rotations() -> None:
    found = rotations()
    assert len(found) == len({tuple(matrix.ravel()) for matrix in found}) == 24
    assert all(np.linalg.det(matrix) == pytest.approx(1.0) for matrix in found)
    np.testing.assert_array_equal(found[0], np.eye(3))


def test_the_truth_is_turned_and_scaled_to_fit(bracket: TopoDS_Shape) -> None:
    turn = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    assert np.linalg.det(turn) == pytest.approx(1.0)
    small = placed(bracket, turn, 0.03)
    back, name = registered(fine_mesh(bracket), small, (60.0, 40.0, 30.0))
    assert closeness(back, bracket).exact
    assert name == "-y-z+x x33.33"


def test_a_surface_that_bounds_no_solid_is_turned_to_fit(bracket: TopoDS_Shape) -> None:
    turn = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    whole = fine_mesh(bracket)
    mesh = make_mesh(whole.vertices, whole.triangles[1:])
    assert mesh_iou(mesh, whole) is None
    back, _ = registered(mesh, placed(bracket, turn, 0.03), (60.0, 40.0, 30.0))
    assert closeness(back, bracket).exact
