"""Repair: holes, edges with four triangles, points that touch."""

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces, make_mesh
from gaussiancad_core.surface.repair import made_manifold


def boxes_that_touch(shift: tuple[float, float, float]) -> TriangleMesh:
    """Two unit boxes, the second moved, their common points welded."""
    first = trimesh.creation.box(bounds=[(0, 0, 0), (1, 1, 1)])
    second = first.copy()
    second.apply_translation(shift)
    both = trimesh.util.concatenate([first, second])
    both.merge_vertices()
    return make_mesh(both.vertices, both.faces)


@pytest.mark.parametrize("shift", [(1.0, 1.0, 0.0), (1.0, 1.0, 1.0)])
def test_what_touches_along_an_edge_or_in_a_point_is_parted(
    shift: tuple[float, float, float],
) -> None:
    touching = boxes_that_touch(shift)
    assert len(touching.vertices) < 16
    repaired = made_manifold(touching)
    assert repaired is not None
    assert repaired.watertight
    assert repaired.volume == pytest.approx(2.0, rel=0.15)
    welded = repaired.to_trimesh()
    welded.merge_vertices()
    assert welded.is_watertight
    assert len(np.unique(repaired.vertices.astype(np.float32), axis=0)) == len(repaired.vertices)


def test_holes_are_filled_flat(ball: TriangleMesh) -> None:
    holed = TriangleMesh(ball.vertices, np.delete(ball.triangles, [5, 6, 7, 4000], axis=0))
    assert not holed.watertight
    repaired = made_manifold(holed)
    assert repaired is not None
    assert repaired.watertight
    assert repaired.volume == pytest.approx(ball.volume, rel=1e-3)


def test_a_sound_mesh_keeps_its_shape(ball: TriangleMesh) -> None:
    repaired = made_manifold(ball)
    assert repaired is not None
    assert len(repaired.triangles) == len(ball.triangles)
    assert repaired.volume == pytest.approx(ball.volume, rel=1e-12)
    assert len(connected_pieces(repaired)) == 1


def test_what_bounds_nothing_is_refused() -> None:
    flat = make_mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 1)])
    assert made_manifold(flat) is None
