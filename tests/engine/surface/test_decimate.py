"""Decimation: few triangles, closed, the same body."""

import pytest
import trimesh

from gaussiancad_core.errors import EngineError
from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces, joined, make_mesh
from gaussiancad_core.surface.decimate import FACETED_LIMIT, decimated


@pytest.mark.parametrize("limit", [5000, 1000, 200])
def test_fewer_triangles_for_the_same_body(ball: TriangleMesh, limit: int) -> None:
    fewer = decimated(ball, limit)
    assert 0.7 * limit <= len(fewer.triangles) <= limit
    assert fewer.watertight
    assert fewer.volume == pytest.approx(ball.volume, rel=15.0 / limit)


def test_a_mesh_that_is_small_enough_is_left_alone(box: TriangleMesh) -> None:
    assert decimated(box, FACETED_LIMIT) is box


def test_flat_faces_lose_nothing(bracket: TriangleMesh) -> None:
    fewer = decimated(bracket, 60)
    assert fewer.watertight
    assert fewer.volume == pytest.approx(bracket.volume, rel=1e-6)
    assert fewer.bounds == pytest.approx(bracket.bounds, abs=1e-6)


def test_pieces_stay(ball: TriangleMesh) -> None:
    other = make_mesh(ball.vertices * 0.5 + [30.0, 0.0, 0.0], ball.triangles)
    fewer = decimated(joined([ball, other]), 800)
    assert fewer.watertight
    assert len(connected_pieces(fewer)) == 2


def test_holes_stay() -> None:
    ring = trimesh.creation.torus(10.0, 3.0, major_sections=80, minor_sections=40)
    fewer = decimated(make_mesh(ring.vertices, ring.faces), 500)
    assert fewer.watertight
    assert fewer.to_trimesh().euler_number == 0


def test_the_impossible_is_told(ball: TriangleMesh) -> None:
    with pytest.raises(EngineError) as caught:
        decimated(ball, 3)
    assert caught.value.code == "decimation-failed"
