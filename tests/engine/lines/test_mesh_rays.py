from collections.abc import Callable

import numpy as np
import pytest

from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh, joined


def test_first_hits_agree_with_all_hits(blind_hole: TriangleMesh) -> None:
    grid = RayGrid.of_view(Role.TOP, (-2.0, -2.0, 42.0, 32.0), 0.4)
    caster = RayCaster(blind_hole)
    first, every = caster.first_hits(grid), caster.all_hits(grid)
    starts, counts = every.splits[:-1], np.diff(every.splits)
    hit = np.isfinite(first.depth).ravel()
    assert (hit == (counts > 0)).all()
    assert first.depth.ravel()[hit] == pytest.approx(every.depth[starts[hit]], abs=1e-4)
    weights = first.weights[np.isfinite(first.depth)]
    assert weights.sum(axis=-1) == pytest.approx(np.ones(len(weights)), abs=1e-5)


def test_a_gap_without_thickness_is_none(box: Callable[..., TriangleMesh]) -> None:
    """Out of one body and into the next at nearly the same place: the ray stays in material."""
    pair = joined([box((0, 0, 0), (10, 5, 8)), box((0, 5.00004, 0), (10, 9, 8))])
    hits = RayCaster(pair).all_hits(RayGrid.of_view(Role.FRONT, (1.0, 1.0, 9.0, 7.0), 0.5))
    assert (np.diff(hits.splits) == 2).all()
    assert np.diff(hits.depth.reshape(-1, 2)) == pytest.approx(
        np.full((len(hits.depth) // 2, 1), 9.0), rel=1e-5
    )


def test_edges_of_triangles_count_once(box: Callable[..., TriangleMesh]) -> None:
    """A grid whose rays would all run along the diagonal of a square's two triangles."""
    cube = box((0, 0, 0), (8, 8, 8))
    hits = RayCaster(cube).all_hits(RayGrid.of_view(Role.FRONT, (0.0, 0.0, 8.0, 8.0), 1.0))
    assert (np.diff(hits.splits) == 2).all()


def test_no_ray_slips_through_between_triangles(blind_hole: TriangleMesh) -> None:
    grid = RayGrid.of_view(Role.FRONT, (0.0, 0.0, 40.0, 20.0), 0.025)
    assert grid.width * grid.height > 1_000_000
    first = RayCaster(blind_hole).first_hits(grid)
    assert np.isfinite(first.depth).all()
    assert np.ptp(first.depth) < 1e-4


@pytest.mark.parametrize("look", [(0.0, 0.0, -1.0), (0.48, 0.6, -0.64)])
def test_the_scan_finds_what_open3d_finds(
    blind_hole: TriangleMesh, look: tuple[float, float, float]
) -> None:
    from gaussiancad_core.kernel.bare_open3d import open3d

    up = np.cross([0.36, 0.48, 0.8] if look[0] else [0.0, 1.0, 0.0], look)
    up /= np.linalg.norm(up)
    right = np.cross(look, up)
    across, along = blind_hole.vertices @ right, blind_hole.vertices @ up
    left, top = float(across.min() - 1.0), float(along.max() + 1.0)
    grid = RayGrid(tuple(right), tuple(up), look, left, top, 0.21, 250, 250)
    found = RayCaster(blind_hole).first_hits(grid)
    # Where the rays leave from, by the depth and the weights that were found.
    corners = grid.corners(blind_hole)
    hit = found.triangle >= 0
    assert 0.3 < hit.mean() < 0.95
    places = np.einsum("nij,ni->nj", corners[found.triangle[hit]], found.weights[hit])
    rows, columns = np.nonzero(hit)
    assert places[:, 0] == pytest.approx(columns, abs=1e-2)
    assert places[:, 1] == pytest.approx(rows, abs=1e-2)
    assert places[:, 2] == pytest.approx(found.depth[hit], abs=1e-2)

    # A plane whose pixels are the rays, for a caster that knows nothing of grids.
    flat = np.stack([corners[..., 0], corners[..., 1], corners[..., 2] / grid.pitch], axis=-1)
    scene = open3d.t.geometry.RaycastingScene()
    numbers = np.arange(3 * len(flat), dtype=np.uint32).reshape(-1, 3)
    scene.add_triangles(flat.reshape(-1, 3).astype(np.float32), numbers)
    y, x = np.mgrid[: grid.height, : grid.width]
    ahead = np.zeros(x.shape)
    rays = np.stack([x, y, ahead - 1.0, ahead, ahead, ahead + 1.0], axis=-1).astype(np.float32)
    expected = (scene.cast_rays(open3d.core.Tensor(rays))["t_hit"].numpy() - 1.0) * grid.pitch
    same = np.isfinite(expected) == hit
    assert same.mean() > 0.9999
    both = np.isfinite(expected) & hit
    close = np.abs(expected[both] - found.depth[both]) < 1e-3
    assert close.mean() > 0.9999
