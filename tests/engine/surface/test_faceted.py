"""Faceted solids: valid, closed, of the mesh's volume."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.errors import EngineError
from gaussiancad_core.kernel.brep import bounding_box, soundness
from gaussiancad_core.model.meshes import TriangleMesh, joined, make_mesh
from gaussiancad_core.surface.faceted import faceted_solid


def test_coplanar_triangles_become_one_face(bracket: TriangleMesh) -> None:
    assert len(bracket.triangles) == 320
    shape = faceted_solid(bracket)
    state = soundness(shape)
    assert (state.valid, state.closed, state.solids, state.faces) == (True, True, 1, 8)
    assert state.volume_mm3 == pytest.approx(bracket.volume, rel=1e-9)
    assert bounding_box(shape) == pytest.approx(bracket.bounds, abs=1e-6)


def test_pieces_become_solids(box: TriangleMesh) -> None:
    other = make_mesh(box.vertices + np.array([50.0, 0.0, 0.0]), box.triangles)
    state = soundness(faceted_solid(joined([box, other])))
    assert (state.valid, state.closed, state.solids, state.faces) == (True, True, 2, 12)
    assert state.volume_mm3 == pytest.approx(2 * box.volume)


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 10_000))
def test_any_convex_body_keeps_its_volume(seed: int) -> None:
    import trimesh

    points = np.random.default_rng(seed).standard_normal((20, 3)) * 10.0
    hull = trimesh.convex.convex_hull(points)
    mesh = make_mesh(hull.vertices, hull.faces)
    state = soundness(faceted_solid(mesh))
    assert (state.valid, state.closed, state.solids) == (True, True, 1)
    assert state.faces == len(mesh.triangles)
    assert state.volume_mm3 == pytest.approx(mesh.volume, rel=1e-9)


def test_what_is_open_inverted_or_without_volume_is_refused(box: TriangleMesh) -> None:
    flat = make_mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2], [0, 2, 1]])
    for wrong in (TriangleMesh(box.vertices, box.triangles[1:]), box.flipped(), flat):
        with pytest.raises(EngineError) as caught:
            faceted_solid(wrong)
        assert caught.value.code == "faceted-solid-failed"


@pytest.mark.parametrize("order", ["C", "F"])
def test_a_triangle_whose_corners_lie_on_one_line_is_left_out(
    order: str, box: TriangleMesh
) -> None:
    # Over an edge of the box, between its ends and its middle, and the triangle beyond it in two.
    start, end, third = box.triangles[0].tolist()
    neighbour = next(
        triangle
        for triangle in box.triangles[1:].tolist()
        if (end, start) in zip(triangle, triangle[1:] + triangle[:1], strict=True)
    )
    middle = len(box.vertices)
    with_needle = make_mesh(
        np.vstack([box.vertices, box.vertices[[start, end]].mean(axis=0)]),
        [
            *(t for t in box.triangles.tolist() if t not in ([start, end, third], neighbour)),
            [start, middle, third],
            [middle, end, third],
            [start, end, middle],
            neighbour,
        ],
    )
    assert with_needle.watertight
    assert with_needle.areas.min() == 0.0
    vertices = np.array(with_needle.vertices, order=order)
    vertices.flags.writeable = False
    with_needle = TriangleMesh(vertices, np.array(with_needle.triangles, order=order))
    state = soundness(faceted_solid(with_needle))
    assert (state.valid, state.closed, state.solids, state.faces) == (True, True, 1, 6)
    assert state.volume_mm3 == pytest.approx(box.volume)


def test_corners_in_one_place_are_one(box: TriangleMesh) -> None:
    # Both triangles at an edge have a second ``b``; two triangles more fill what opens.
    a, b, c = box.triangles[0]
    count = len(box.vertices)
    shared = np.isin(box.triangles, [a, b]).sum(axis=1) == 2
    rest = box.triangles[~shared]
    (other,) = set(box.triangles[shared].ravel()) - {a, b, c}
    split = make_mesh(
        np.vstack([box.vertices, box.vertices[b]]),
        np.vstack([rest, [a, count, c], [count, a, other], [b, c, count], [b, count, other]]),
    )
    assert split.watertight
    assert (split.areas == 0.0).sum() == 2
    state = soundness(faceted_solid(split))
    assert (state.valid, state.closed, state.solids, state.faces) == (True, True, 1, 6)
    assert state.volume_mm3 == pytest.approx(box.volume, rel=1e-12)
