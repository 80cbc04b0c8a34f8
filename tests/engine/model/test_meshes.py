"""Meshes: volumes, closure, pieces."""

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces, joined, make_mesh

coordinate = st.floats(-50.0, 50.0, allow_nan=False)
point = st.tuples(coordinate, coordinate, coordinate)


def box(
    size: tuple[float, float, float], at: tuple[float, float, float] = (0, 0, 0)
) -> TriangleMesh:
    mesh = trimesh.creation.box(bounds=[at, np.add(at, size)])
    return make_mesh(mesh.vertices, mesh.faces)


def test_box_has_its_volume_area_and_bounds() -> None:
    mesh = box((2.0, 3.0, 5.0), (1.0, -1.0, 4.0))
    assert mesh.volume == pytest.approx(30.0, rel=1e-12)
    assert mesh.area == pytest.approx(62.0, rel=1e-12)
    assert mesh.bounds.tolist() == [[1.0, -1.0, 4.0], [3.0, 2.0, 9.0]]
    assert mesh.watertight


@given(point, point, point, point, point)
def test_volume_of_a_tetrahedron_is_a_sixth_of_its_determinant_wherever_it_stands(
    a: tuple, b: tuple, c: tuple, d: tuple, shift: tuple
) -> None:
    corners = np.array([a, b, c, d])
    determinant = np.linalg.det(corners[1:] - corners[0])
    mesh = make_mesh(corners + np.array(shift), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    assert mesh.volume == pytest.approx(determinant / 6.0, abs=1e-6)


def test_shared_edges_are_those_where_just_two_triangles_meet() -> None:
    mesh = box((2.0, 3.0, 5.0))
    pairs, edges = mesh.shared_edges
    assert len(pairs) == len(edges) == 18
    expected = mesh.to_trimesh()
    assert {tuple(sorted(pair)) for pair in pairs.tolist()} == {
        tuple(sorted(pair)) for pair in expected.face_adjacency.tolist()
    }
    for pair, edge in zip(pairs, edges, strict=True):
        assert set(edge) <= set(mesh.triangles[pair[0]]) & set(mesh.triangles[pair[1]])
    # A third triangle at an edge, and one that stands alone.
    fan = make_mesh(np.eye(3).repeat(2, axis=0), [[0, 1, 2], [1, 0, 3], [0, 1, 4], [5, 4, 3]])
    pairs, edges = fan.shared_edges
    assert len(pairs) == 0
    open_fan = make_mesh(fan.vertices, [[0, 1, 2], [1, 0, 3], [5, 4, 3]])
    pairs, edges = open_fan.shared_edges
    assert (pairs.tolist(), edges.tolist()) == ([[0, 1]], [[0, 1]])


def test_turning_inside_out_changes_the_sign_only() -> None:
    mesh = box((1.0, 2.0, 3.0))
    assert mesh.flipped().volume == pytest.approx(-6.0)
    assert mesh.flipped().watertight
    assert mesh.flipped().oriented_outward().volume == pytest.approx(6.0)
    assert mesh.oriented_outward() is mesh


def test_a_missing_triangle_or_a_turned_one_is_no_closed_surface() -> None:
    mesh = box((1.0, 1.0, 1.0))
    assert not TriangleMesh(mesh.vertices, mesh.triangles[1:]).watertight
    turned = mesh.triangles.copy()
    turned[0] = turned[0, ::-1]
    assert not TriangleMesh(mesh.vertices, turned).watertight
    assert not make_mesh([], []).watertight


def test_pieces_come_apart_largest_first_and_join_again() -> None:
    small, large = box((1.0, 1.0, 1.0)), box((3.0, 3.0, 3.0), (10.0, 0.0, 0.0))
    both = joined([small, large])
    assert both.watertight
    assert both.volume == pytest.approx(28.0)
    pieces = connected_pieces(both)
    assert [piece.volume for piece in pieces] == [pytest.approx(27.0), pytest.approx(1.0)]
    assert all(len(piece.vertices) == 8 for piece in pieces)
    assert connected_pieces(make_mesh([], [])) == []


def test_compacting_drops_unused_vertices_only() -> None:
    mesh = box((1.0, 2.0, 3.0))
    padded = make_mesh(np.concatenate([[[9.0, 9.0, 9.0]], mesh.vertices]), mesh.triangles + 1)
    compact = padded.compacted()
    assert len(compact.vertices) == 8
    assert np.array_equal(compact.corners, mesh.corners)
