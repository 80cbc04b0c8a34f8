"""Both back ends: analytic images, agreement, gradients, determinism."""

from dataclasses import replace

import numba
import numpy as np
import pytest
import torch
from engine.splatting.gaussian_scenes import SIZE, cameras, gradients

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import CameraModel, orthographic_camera
from gaussiancad_core.splatting.projection import batch_of
from gaussiancad_core.splatting.rasterizer import Parameters, RasterSettings
from gaussiancad_core.splatting.reference import draw_reference
from gaussiancad_core.splatting.tiles import draw_tiles, warm_up

BOTH = pytest.mark.parametrize("draw", [draw_tiles, draw_reference])
MODELS = pytest.mark.parametrize("model", list(CameraModel))
SMOOTH = RasterSettings(smallest_alpha=0.0, largest_alpha=0.9999, smallest_transmittance=0.0)


def parameters(count: int, sigma: float, dtype: torch.dtype, seed: int = 0) -> Parameters:
    """Random Gaussians in the part's box, in units of 10 mm."""
    generator = torch.Generator().manual_seed(seed)

    def normal(*shape: int) -> torch.Tensor:
        return torch.randn(*shape, generator=generator, dtype=dtype)

    box = torch.tensor(SIZE, dtype=dtype) / 10.0
    return Parameters(
        *(
            tensor.requires_grad_()
            for tensor in (
                torch.rand(count, 3, generator=generator, dtype=dtype) * box,
                normal(count, 4),
                0.3 * normal(count, 3) + np.log(sigma),
                normal(count),
                torch.rand(count, 3, generator=generator, dtype=dtype),
            )
        )
    )


def one_gaussian(dtype: torch.dtype = torch.float64) -> Parameters:
    """An upright, axis-parallel Gaussian in the middle, opacity 0.8."""
    rows = (
        [[2.5, 1.5, 2.0]],
        [[1.0, 0.0, 0.0, 0.0]],
        [np.log([0.5, 0.2, 0.3]).tolist()],
        [np.log(0.8 / 0.2)],
        [[1.0, 0.5, 0.25]],
    )
    return Parameters(*(torch.tensor(row, dtype=dtype).requires_grad_() for row in rows))


@BOTH
def test_one_gaussian_under_parallel_projection_is_its_marginal(draw: object) -> None:
    camera = orthographic_camera(Role.FRONT, SIZE, 40)
    batch = batch_of((camera,), unit=10.0, dtype=torch.float64)
    rendering = draw(one_gaussian(), batch, replace(SMOOTH, dilation=0.1))
    y, x = np.mgrid[:40, :40] + 0.5
    scale = camera.fx * 10.0
    variance_x, variance_y = (0.5 * scale) ** 2 + 0.1, (0.3 * scale) ** 2 + 0.1
    exact = 0.8 * np.exp(-((x - 20.0) ** 2 / variance_x + (y - 20.0) ** 2 / variance_y) / 2)
    assert rendering.alphas[0].detach().numpy() == pytest.approx(exact, abs=1e-12)
    expected = exact * np.array([1.0, 0.5, 0.25])[:, None, None]
    assert rendering.colours[0].detach().numpy() == pytest.approx(expected, abs=1e-12)
    depth = camera.reference_depth / 10.0
    assert rendering.depths[0].detach().numpy() == pytest.approx(exact * depth, abs=1e-9)


@BOTH
def test_the_nearer_gaussian_covers_the_farther_one(draw: object) -> None:
    single = one_gaussian()
    pair = Parameters(
        *(torch.cat([t.detach(), t.detach()]).requires_grad_() for t in single.tensors)
    )
    with torch.no_grad():
        # The front view looks along +Y: the second stands nearer.
        pair.means[1, 1] -= 1.0
        pair.colours[0] = torch.tensor([1.0, 0.0, 0.0])
        pair.colours[1] = torch.tensor([0.0, 1.0, 0.0])
    batch = cameras(CameraModel.ORTHOGRAPHIC, 41, torch.float64, (Role.FRONT,))
    rendering = draw(pair, batch, replace(SMOOTH, dilation=0.0))
    middle = rendering.colours[0, :, 20, 20].detach().numpy()
    assert middle == pytest.approx([0.2 * 0.8, 0.8, 0.0], abs=1e-12)
    assert float(rendering.alphas[0, 20, 20].detach()) == pytest.approx(0.96)


@MODELS
@pytest.mark.parametrize(("dtype", "tolerance"), [(torch.float32, 2e-5), (torch.float64, 1e-12)])
def test_tiles_draw_and_differentiate_as_the_reference_does(
    model: CameraModel, dtype: torch.dtype, tolerance: float
) -> None:
    batch = cameras(model, 70, dtype)
    some = parameters(60, 0.2, dtype)
    fast, plain = (draw(some, batch, RasterSettings()) for draw in (draw_tiles, draw_reference))
    for name in ("colours", "alphas", "depths"):
        one, other = getattr(fast, name), getattr(plain, name)
        assert one.dtype == dtype
        assert (one - other).abs().max() <= tolerance * other.abs().max(), name
    for one, other in zip(
        gradients(fast, some.tensors), gradients(plain, some.tensors), strict=True
    ):
        assert (one - other).abs().max() <= tolerance * other.abs().max()


@MODELS
def test_thin_slanting_gaussians_lose_no_pixel(model: CameraModel) -> None:
    batch = cameras(model, 150, torch.float64)
    some = parameters(80, 0.3, torch.float64, seed=5)
    with torch.no_grad():
        some.log_scales[:, 2] -= 4.0
        some.log_scales[::2, 1] -= 3.0
    optics = RasterSettings(dilation=0.02)
    fast, plain = (draw(some, batch, optics) for draw in (draw_tiles, draw_reference))
    assert float(plain.alphas.detach().max()) > 0.5
    for name in ("colours", "alphas", "depths"):
        one, other = getattr(fast, name), getattr(plain, name)
        assert (one - other).abs().max() <= 1e-12 * other.abs().max(), name
    for one, other in zip(
        gradients(fast, some.tensors), gradients(plain, some.tensors), strict=True
    ):
        assert (one - other).abs().max() <= 1e-11 * other.abs().max()


@MODELS
def test_gradients_of_the_tiles_are_those_of_finite_differences(model: CameraModel) -> None:
    batch = cameras(model, 20, torch.float64, (Role.FRONT, Role.RIGHT))
    some = parameters(4, 0.5, torch.float64, seed=2)
    generator = torch.Generator().manual_seed(4)

    def combinations(*tensors: torch.Tensor) -> torch.Tensor:
        """A few random sums over all images: each depends on every pixel."""
        rendering = draw_tiles(Parameters(*tensors), batch, SMOOTH)
        images = (rendering.colours, rendering.alphas, rendering.depths)
        pixels = torch.cat([image.flatten() for image in images])
        return weights[:, : len(pixels)] @ pixels

    weights = torch.randn(6, 10_000, generator=generator, dtype=torch.float64)
    assert torch.autograd.gradcheck(combinations, some.tensors, eps=1e-6, atol=1e-6, rtol=1e-5)


@MODELS
def test_an_opaque_pile_ends_the_drawing_in_both_back_ends(model: CameraModel) -> None:
    some = parameters(400, 0.6, torch.float64)
    with torch.no_grad():
        some.logit_opacities.fill_(6.0)
    batch = cameras(model, 40, torch.float64)
    fast, plain = (draw(some, batch, RasterSettings()) for draw in (draw_tiles, draw_reference))
    assert float((1.0 - plain.alphas).min().detach()) < 1e-4
    assert torch.allclose(fast.colours, plain.colours, atol=1e-12)
    for one, other in zip(
        gradients(fast, some.tensors), gradients(plain, some.tensors), strict=True
    ):
        assert (one - other).abs().max() <= 1e-9 * other.abs().max()


@BOTH
@MODELS
def test_what_lies_outside_or_behind_draws_nothing_and_gets_no_gradient(
    draw: object, model: CameraModel
) -> None:
    some = parameters(5, 0.1, torch.float64)
    far = 1e4
    with torch.no_grad():
        some.means[0] += torch.tensor([far, 0.0, 0.0])
        some.means[1] += torch.tensor([0.0, 0.0, -far])
        some.means[2] += torch.tensor([0.0, -far if model is CameraModel.PINHOLE else far, far])
        some.logit_opacities[3] = -20.0
    batch = cameras(model, 64, torch.float64, (Role.FRONT,))
    rendering = draw(some, batch, RasterSettings())
    alone = Parameters(*(tensor.detach()[4:].requires_grad_() for tensor in some.tensors))
    assert torch.allclose(rendering.alphas, draw(alone, batch, RasterSettings()).alphas, atol=1e-12)
    for gradient in gradients(rendering, some.tensors):
        assert torch.isfinite(gradient).all()
        assert (gradient[:4] == 0.0).all()


@BOTH
def test_no_gaussians_draw_blank_images(draw: object) -> None:
    none = Parameters(*(tensor.detach()[:0].requires_grad_() for tensor in one_gaussian().tensors))
    rendering = draw(none, cameras(CameraModel.ORTHOGRAPHIC, 20, torch.float64), RasterSettings())
    assert rendering.colours.shape == (3, 3, 20, 20)
    assert (rendering.alphas == 0.0).all()
    assert all(gradient.numel() == 0 for gradient in gradients(rendering, none.tensors))


def test_the_number_of_threads_does_not_change_a_bit() -> None:
    some = parameters(300, 0.2, torch.float32)
    batch = cameras(CameraModel.ORTHOGRAPHIC, 96, torch.float32)
    before = numba.get_num_threads()
    found = []
    try:
        for threads in (1, before):
            numba.set_num_threads(threads)
            rendering = draw_tiles(some, batch, RasterSettings())
            found.append((rendering.colours.detach(), *gradients(rendering, some.tensors)))
    finally:
        numba.set_num_threads(before)
    assert all(torch.equal(one, other) for one, other in zip(*found, strict=True))


def test_warming_up_compiles_what_a_run_calls() -> None:
    from gaussiancad_core.splatting.tile_kernels import composite_backward, composite_forward

    warm_up()
    kernels = (composite_forward, composite_backward)
    before = [len(kernel.signatures) for kernel in kernels]
    some = parameters(10, 0.2, torch.float32)
    for model in CameraModel:
        rendering = draw_tiles(some, cameras(model, 32, torch.float32), RasterSettings())
        gradients(rendering, some.tensors)
    assert [len(kernel.signatures) for kernel in kernels] == before
