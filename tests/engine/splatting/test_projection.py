"""Projection of Gaussians: exact for parallel rays, first order for a pinhole."""

import numpy as np
import pytest
import torch

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera, orthographic_camera, paper_camera
from gaussiancad_core.splatting.gaussians import rotation_matrices
from gaussiancad_core.splatting.projection import batch_of, project

SIZE = (50.0, 30.0, 40.0)
ROLES = tuple(Role)
DOUBLE = torch.float64


def random_gaussians(count: int, sigma: float) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    generator = torch.Generator().manual_seed(0)
    means = torch.rand(count, 3, generator=generator, dtype=DOUBLE) * torch.tensor(
        SIZE, dtype=DOUBLE
    )
    quaternions = torch.randn(count, 4, generator=generator, dtype=DOUBLE)
    log_scales = torch.rand(count, 3, generator=generator, dtype=DOUBLE) + np.log(sigma)
    return means, quaternions, log_scales


def covariance(quaternions: torch.Tensor, log_scales: torch.Tensor) -> np.ndarray:
    axes = rotation_matrices(quaternions.numpy()) * np.exp(log_scales.numpy())[:, None, :]
    return axes @ axes.transpose(0, 2, 1)


@pytest.mark.parametrize("role", ROLES)
def test_means_land_where_the_camera_says(role: Role) -> None:
    means, quaternions, log_scales = random_gaussians(20, 1.0)
    for camera in (orthographic_camera(role, SIZE, 200), paper_camera(role, SIZE, 0.25)):
        splats = project(means, quaternions, log_scales, batch_of((camera,), dtype=DOUBLE), 0.0)
        assert splats.means[0].numpy() == pytest.approx(camera.project(means.numpy()), abs=1e-9)
        depths = camera.to_camera(means.numpy())[:, 2]
        assert splats.depths[0].numpy() == pytest.approx(depths, abs=1e-9)


@pytest.mark.parametrize("role", ROLES)
def test_parallel_projection_keeps_the_exact_block_of_the_covariance(role: Role) -> None:
    means, quaternions, log_scales = random_gaussians(20, 1.0)
    camera = orthographic_camera(role, SIZE, 200)
    splats = project(means, quaternions, log_scales, batch_of((camera,), dtype=DOUBLE), 0.3)
    turned = camera.rotation @ covariance(quaternions, log_scales) @ camera.rotation.T
    exact = turned[:, :2, :2] * camera.fx**2 + 0.3 * np.eye(2)
    expected = exact[:, [0, 0, 1], [0, 1, 1]]
    assert splats.covariances[0].numpy() == pytest.approx(expected, rel=1e-9)


def test_pinhole_covariance_is_that_of_projected_samples() -> None:
    means, quaternions, log_scales = random_gaussians(5, 0.05)
    camera = paper_camera(Role.FRONT, SIZE)
    splats = project(means, quaternions, log_scales, batch_of((camera,), dtype=DOUBLE), 0.0)
    random = np.random.default_rng(0)
    for i, exact in enumerate(covariance(quaternions, log_scales)):
        samples = random.multivariate_normal(means[i].numpy(), exact, 40_000)
        found = np.cov(camera.project(samples).T)
        expected = splats.covariances[0, i].numpy()
        assert found[[0, 0, 1], [0, 1, 1]] == pytest.approx(
            expected, rel=0.05, abs=0.02 * expected.max()
        )


def test_cameras_of_different_kinds_are_refused() -> None:
    pair: tuple[Camera, ...] = (
        orthographic_camera(Role.FRONT, SIZE, 64),
        orthographic_camera(Role.TOP, SIZE, 32),
    )
    with pytest.raises(ValueError, match="one size"):
        batch_of(pair)
