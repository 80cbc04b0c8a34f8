"""The plain back end: every Gaussian against every pixel, in torch.

Slow and readable: the tile kernels are tested against it, and it runs wherever torch does.
"""

import torch
from torch import Tensor

from gaussiancad_core.splatting.projection import CameraBatch, Splats, conics, project
from gaussiancad_core.splatting.rasteriser import Optics, Parameters, Rendering


def draw_reference(parameters: Parameters, cameras: CameraBatch, optics: Optics) -> Rendering:
    """Draw the Gaussians in every view; see :mod:`.rasteriser` for the compositing."""
    splats = project(
        parameters.means,
        parameters.quaternions,
        parameters.log_scales,
        cameras,
        optics.dilation,
    )
    # Colour, one for alpha, and depth are composited alike.
    opacities = torch.sigmoid(parameters.logit_opacities)
    images = []
    for view in range(len(splats.means)):
        features = torch.cat(
            [
                parameters.colours,
                torch.ones_like(opacities)[:, None],
                splats.depths[view][:, None],
            ],
            dim=1,
        )
        weights, order = _weights(splats, view, opacities, cameras, optics)
        images.append((weights @ features[order]).T.reshape(5, cameras.height, cameras.width))
    stacked = torch.stack(images)
    return Rendering(stacked[:, :3], stacked[:, 3], stacked[:, 4])


def _weights(
    splats: Splats, view: int, opacities: Tensor, cameras: CameraBatch, optics: Optics
) -> tuple[Tensor, Tensor]:
    """(h w, n) weights of the Gaussians in order of depth, and (n,) that order."""
    depths = splats.depths[view]
    order = torch.argsort(depths.detach(), stable=True)
    order = order[depths[order] > cameras.nearest]
    dtype = depths.dtype
    y, x = torch.meshgrid(
        torch.arange(cameras.height, dtype=dtype) + 0.5,
        torch.arange(cameras.width, dtype=dtype) + 0.5,
        indexing="ij",
    )
    means = splats.means[view][order]
    dx = x.reshape(-1, 1) - means[:, 0]
    dy = y.reshape(-1, 1) - means[:, 1]
    xx, xy, yy = conics(splats.covariances[view][order]).unbind(-1)
    falloff = torch.exp(-0.5 * (xx * dx * dx + yy * dy * dy) - xy * dx * dy)
    alphas = (opacities[order] * falloff).clamp_max(optics.largest_alpha)
    alphas = torch.where(alphas >= optics.smallest_alpha, alphas, torch.zeros_like(alphas))
    left = torch.cumprod(1.0 - alphas, dim=1)
    before = torch.cat([torch.ones_like(left[:, :1]), left[:, :-1]], dim=1)
    seen = before > optics.smallest_transmittance
    return torch.where(seen, alphas * before, torch.zeros_like(alphas)), order
