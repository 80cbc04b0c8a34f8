"""The plain back end: in torch alone, tile by tile.

Slow and readable: the compiled kernels are tested against it, and it runs wherever torch does.
"""

from dataclasses import replace

import torch
from torch import Tensor

from gaussiancad_core.splatting.projection import CameraBatch, Splats, conics, project
from gaussiancad_core.splatting.rasterizer import Parameters, RasterSettings, Rendering

_TILE = 32
"""Edge of a tile in pixels; a Gaussian is drawn only in the tiles that it reaches."""


def draw_reference(
    parameters: Parameters,
    cameras: CameraBatch,
    optics: RasterSettings,
    shifts: Tensor | None = None,
) -> Rendering:
    """Draw the Gaussians in every view; see :mod:`.rasterizer` for the compositing."""
    splats = project(
        parameters.means,
        parameters.quaternions,
        parameters.log_scales,
        cameras,
        optics.dilation,
    )
    if shifts is not None:
        splats = replace(splats, means=splats.means + shifts)
    opacities = torch.sigmoid(parameters.logit_opacities)
    views = []
    for view in range(len(splats.means)):
        # Colour, one for alpha, and depth are composited alike.
        features = torch.cat(
            [parameters.colours, torch.ones_like(opacities)[:, None], splats.depths[view][:, None]],
            dim=1,
        )
        order = _front_to_back(splats, view, cameras)
        reach = _reach(splats.covariances[view], opacities, optics)
        lines = []
        for top in range(0, cameras.height, _TILE):
            tiles = []
            for left in range(0, cameras.width, _TILE):
                size = (min(_TILE, cameras.height - top), min(_TILE, cameras.width - left))
                chosen = _meeting(splats.means[view], reach, order, (left, top), size)
                pixels = _centres((left, top), size, features.dtype)
                weights = _weights(
                    splats.means[view][chosen],
                    conics(splats.covariances[view][chosen]),
                    opacities[chosen],
                    pixels,
                    optics,
                )
                tiles.append((weights @ features[chosen]).T.reshape(5, *size))
            lines.append(torch.cat(tiles, dim=2))
        views.append(torch.cat(lines, dim=1))
    stacked = torch.stack(views)
    return Rendering(stacked[:, :3], stacked[:, 3], stacked[:, 4])


def _front_to_back(splats: Splats, view: int, cameras: CameraBatch) -> Tensor:
    """Indices of what lies in front of the camera, the nearest first."""
    depths = splats.depths[view].detach()
    order = torch.argsort(depths, stable=True)
    return order[depths[order] > cameras.nearest]


def _reach(covariances: Tensor, opacities: Tensor, optics: RasterSettings) -> Tensor:
    """(n, 2) px to each side within which a Gaussian's alpha is large enough to be drawn."""
    if optics.smallest_alpha == 0.0:
        return torch.full_like(covariances[:, :2], float("inf"))
    ratio = (opacities.detach() / optics.smallest_alpha).clamp_min(1.0)
    return torch.sqrt(2.0 * torch.log(ratio)[:, None] * covariances.detach()[:, [0, 2]])


def _meeting(
    means: Tensor, reach: Tensor, order: Tensor, corner: tuple[int, int], size: tuple[int, int]
) -> Tensor:
    """Those of ``order`` that reach a tile with this upper left corner and (height, width)."""
    low = torch.tensor(corner, dtype=means.dtype)
    high = low + torch.tensor(size[::-1], dtype=means.dtype)
    places, reaches = means.detach()[order], reach[order]
    meets = (places + reaches >= low).all(dim=1) & (places - reaches <= high).all(dim=1)
    return order[meets]


def _centres(corner: tuple[int, int], size: tuple[int, int], dtype: torch.dtype) -> Tensor:
    """(h w, 2) centres of a tile's pixels, line by line."""
    y, x = torch.meshgrid(
        torch.arange(size[0], dtype=dtype) + corner[1] + 0.5,
        torch.arange(size[1], dtype=dtype) + corner[0] + 0.5,
        indexing="ij",
    )
    return torch.stack([x.reshape(-1), y.reshape(-1)], dim=1)


def _weights(
    means: Tensor, inverses: Tensor, opacities: Tensor, pixels: Tensor, optics: RasterSettings
) -> Tensor:
    """(p, n) weights at p pixels of n Gaussians, which come from front to back."""
    dx, dy = (pixels[:, None] - means).unbind(-1)
    xx, xy, yy = inverses.unbind(-1)
    falloff = torch.exp(-0.5 * (xx * dx * dx + yy * dy * dy) - xy * dx * dy)
    alphas = (opacities * falloff).clamp_max(optics.largest_alpha)
    alphas = torch.where(alphas >= optics.smallest_alpha, alphas, torch.zeros_like(alphas))
    left = torch.cumprod(1.0 - alphas, dim=1)
    before = torch.cat([torch.ones_like(left[:, :1]), left[:, :-1]], dim=1)
    seen = before > optics.smallest_transmittance
    return torch.where(seen, alphas * before, torch.zeros_like(alphas))
