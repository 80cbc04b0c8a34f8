"""Points on discs: where they lie, and that they do not cross edges."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.surface.discs import DiscSampling, creases_of, discs_of
from gaussiancad_core.surface.oriented_points import OrientedPoints, disc_points


def distances(mesh: TriangleMesh, points: np.ndarray) -> np.ndarray:
    return trimesh.proximity.closest_point(mesh.to_trimesh(), points)[1]


def points_on(gaussians: Gaussians, sampling: DiscSampling) -> OrientedPoints:
    discs = discs_of(gaussians, sampling)
    return disc_points(discs, creases_of(discs, sampling), sampling)


def test_points_lie_within_their_discs(ball: TriangleMesh) -> None:
    gaussians = gaussians_on(ball, Start(count=500))
    sampling = DiscSampling(per_disc=6, reach=1.5, crease=90.0)
    found = points_on(gaussians, sampling)
    assert len(found.points) == 6 * 500
    assert np.linalg.norm(found.normals, axis=1) == pytest.approx(1.0)
    away = found.points.reshape(6, 500, 3) - gaussians.means
    sigma = np.exp(gaussians.log_scales[0, 0])
    assert np.linalg.norm(away, axis=2).max() <= 1.5 * sigma
    assert np.abs((away * gaussians.normals).sum(axis=2)).max() < 1e-5 * sigma
    assert np.linalg.norm(away, axis=2).mean() > 0.8 * sigma


def test_no_point_crosses_an_edge(bracket: TriangleMesh, bracket_gaussians: Gaussians) -> None:
    sigma = np.exp(bracket_gaussians.log_scales[0, 0])
    loose = points_on(bracket_gaussians, DiscSampling(crease=90.0))
    assert np.quantile(distances(bracket, loose.points), 0.99) > 0.3 * sigma
    held = points_on(bracket_gaussians, DiscSampling())
    assert distances(bracket, held.points).max() < 1e-4


def test_edges_get_points_of_both_faces(bracket_gaussians: Gaussians) -> None:
    count = 6 * len(bracket_gaussians)
    found = points_on(bracket_gaussians, DiscSampling())
    points, normals = found.points[count:], found.normals[count:]
    # The edge between the front (-Y) and the lower side (-Z) of the bracket.
    near = (np.abs(points[:, 1]) < 1e-4) & (np.abs(points[:, 2]) < 1e-4)
    assert {tuple(normal) for normal in np.round(normals[near]).astype(int)} == {
        (0, -1, 0),
        (0, 0, -1),
    }
    along = np.sort(points[near, 0])
    assert along[0] < 1.0
    assert along[-1] > 19.0
    assert np.diff(along).max() < 2.5


def test_transparent_and_overturned_discs_are_left_out(bracket_gaussians: Gaussians) -> None:
    logits = bracket_gaussians.logit_opacities.copy()
    logits[:100] = -9.0
    normals = bracket_gaussians.normals.copy()
    normals[100:150] = bracket_gaussians.rotations[100:150, :, 0]
    changed = replace(bracket_gaussians, logit_opacities=logits, normals=normals)
    sampling = DiscSampling(per_disc=4, edge_reach=0.0)
    assert len(points_on(changed, sampling).points) == 4 * 1850


def test_few_discs_and_none_are_no_exception(bracket_gaussians: Gaussians) -> None:
    names = ("means", "quaternions", "log_scales", "logit_opacities", "colours", "normals")
    for count in (0, 3):
        few = Gaussians(*(getattr(bracket_gaussians, name)[:count] for name in names))
        assert len(points_on(few, DiscSampling()).points) == 6 * count
