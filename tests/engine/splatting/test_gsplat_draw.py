"""The CUDA back end: what it hands to gsplat, and on a GPU whether the three back ends agree.

On a machine without a GPU a stand-in for gsplat composites in torch as its manual says, so that
the order, the shapes and the units of all arguments and results are checked everywhere.
"""

import sys
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from engine.splatting.gaussian_scenes import SIZE, cameras, gradients

from gaussiancad_core.model.cameras import CameraModel
from gaussiancad_core.splatting.gsplat_draw import draw_gsplat
from gaussiancad_core.splatting.rasterizer import Parameters, RasterSettings
from gaussiancad_core.splatting.reference import draw_reference
from gaussiancad_core.splatting.tiles import draw_tiles
from gaussiancad_core.splatting.torch_devices import cuda_problem

MODELS = pytest.mark.parametrize("model", list(CameraModel))


def parameters(count: int, dtype: torch.dtype, device: str = "cpu") -> Parameters:
    random = np.random.default_rng(3)
    arrays = (
        random.random((count, 3)) * np.array(SIZE) / 10.0,
        random.normal(size=(count, 4)),
        0.3 * random.normal(size=(count, 3)) + np.log(0.2),
        random.normal(size=count),
        random.random((count, 3)),
    )
    tensors = (torch.tensor(array, dtype=dtype, device=device) for array in arrays)
    return Parameters(*(tensor.requires_grad_() for tensor in tensors))


def _rotations(quaternions: torch.Tensor) -> torch.Tensor:
    w, x, y, z = torch.nn.functional.normalize(quaternions, dim=1).unbind(1)
    vector = torch.stack([x, y, z], dim=1)
    cross = torch.linalg.cross(
        vector[:, None].expand(-1, 3, -1), torch.eye(3, dtype=w.dtype).expand(len(w), -1, -1)
    ).transpose(1, 2)
    identity = torch.eye(3, dtype=w.dtype)
    return identity + 2 * (w[:, None, None] * cross + cross @ cross)


def _places(
    means: torch.Tensor, pose: torch.Tensor, matrix: torch.Tensor, namespace: SimpleNamespace
) -> torch.Tensor:
    local = means @ pose[:3, :3].T + pose[:3, 3]
    plane = local / local[:, 2:] if namespace.camera_model == "pinhole" else local
    return plane[:, :2] * matrix[[0, 1], [0, 1]] + matrix[:2, 2]


def stand_in(**asked: object) -> tuple[torch.Tensor, torch.Tensor, dict[str, torch.Tensor]]:
    """What gsplat's ``rasterization`` returns, one pixel after the other in plain torch."""
    stated = SimpleNamespace(**asked)
    assert (stated.packed, stated.render_mode) == (False, "RGB+D")
    turned = _rotations(stated.quats) * stated.scales[:, None, :]
    covariances = turned @ turned.transpose(1, 2)
    places = torch.stack(
        [
            _places(stated.means, *camera, stated)
            for camera in zip(stated.viewmats, stated.Ks, strict=True)
        ]
    )
    images, alphas = [], []
    y, x = torch.meshgrid(
        torch.arange(stated.height) + 0.5, torch.arange(stated.width) + 0.5, indexing="ij"
    )
    for pose, matrix, means in zip(stated.viewmats, stated.Ks, places, strict=True):
        local = stated.means @ pose[:3, :3].T + pose[:3, 3]
        jacobian = matrix[:2, :3].repeat(len(local), 1, 1)
        jacobian[:, :, 2] = 0.0
        plane = local
        if stated.camera_model == "pinhole":
            plane = local / local[:, 2:]
            depth = local[:, 2, None, None]
            jacobian = torch.cat(
                [jacobian[:, :, :2], -jacobian[:, :, :2] @ plane[:, :2, None]], dim=2
            )
            jacobian = jacobian / depth
        else:
            assert stated.camera_model == "ortho"
        linear = jacobian @ pose[:3, :3]
        blurred = (
            linear @ covariances @ linear.transpose(1, 2) + stated.eps2d * torch.eye(2).double()
        )
        offsets = torch.stack([x.flatten(), y.flatten()], dim=1)[:, None] - means
        falloff = torch.einsum("pni,nij,pnj->pn", offsets, torch.linalg.inv(blurred), offsets)
        weighed = (stated.opacities * torch.exp(-falloff / 2)).clamp_max(0.999)
        weighed = torch.where(weighed < 1 / 255, torch.zeros_like(weighed), weighed)
        order = torch.argsort(local[:, 2])
        assert (local[:, 2] > stated.near_plane).all()
        weighed = weighed[:, order]
        left = torch.cumprod(1 - weighed, dim=1)
        weights = weighed * torch.cat([torch.ones_like(left[:, :1]), left[:, :-1]], dim=1)
        features = torch.cat([stated.colors, local[:, 2:]], dim=1)[order]
        images.append((weights @ features).reshape(stated.height, stated.width, 4))
        alphas.append(weights.sum(dim=1).reshape(stated.height, stated.width, 1))
    return torch.stack(images), torch.stack(alphas), {"means2d": places}


@MODELS
def test_what_is_handed_to_gsplat_is_what_the_reference_draws(
    model: CameraModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "gsplat", SimpleNamespace(rasterization=stand_in))
    batch = cameras(model, 32, torch.float64)
    found = []
    for draw in (draw_gsplat, draw_reference, draw_tiles):
        some = parameters(12, torch.float64)
        shifts = torch.zeros(3, 12, 2, dtype=torch.float64, requires_grad=True)
        rendering = draw(some, batch, RasterSettings(dilation=0.1), shifts)
        images = (rendering.colours, rendering.alphas, rendering.depths)
        slopes = gradients(rendering, (*some.tensors, shifts))
        found.append([tensor.detach() for tensor in (*images, *slopes)])
    for item in (found[0], found[2]):
        for one, other in zip(item, found[1], strict=True):
            assert (one - other).abs().max() <= 1e-9 * other.abs().max()


def test_limits_that_gsplat_does_not_have_are_refused() -> None:
    batch = cameras(CameraModel.ORTHOGRAPHIC, 32, torch.float32)
    with pytest.raises(ValueError, match="fixed"):
        draw_gsplat(
            parameters(2, torch.float32), batch, replace(RasterSettings(), largest_alpha=0.9)
        )


@MODELS
def test_on_a_gpu_all_back_ends_agree(model: CameraModel) -> None:
    problem = cuda_problem()
    if problem:
        pytest.skip(f"no GPU to compare with: {problem}")
    batch = cameras(model, 96, torch.float32)
    plain, fast = (
        gradients(draw(item, batch, RasterSettings()), item.tensors)
        for draw, item in (
            (draw_reference, parameters(200, torch.float32)),
            (draw_tiles, parameters(200, torch.float32)),
        )
    )
    this_parameters = parameters(200, torch.float32, "cuda")
    rendering = draw_gsplat(this_parameters, batch.on("cuda"), RasterSettings())
    other = draw_reference(parameters(200, torch.float32), batch, RasterSettings())
    for name, tolerance in (("colours", 4e-3), ("alphas", 4e-3), ("depths", 4e-2)):
        difference = (getattr(rendering, name).cpu() - getattr(other, name)).abs().max()
        assert difference <= tolerance, name
    for one, two, three in zip(
        gradients(rendering, this_parameters.tensors), plain, fast, strict=True
    ):
        assert (two - three).norm() <= 1e-4 * two.norm()
        assert (one.cpu() - two).norm() <= 1e-2 * two.norm()
