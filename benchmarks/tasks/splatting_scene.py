"""Gaussians on a sphere, three views of them, and what their images are differentiated by."""

import numpy as np
import torch
import trimesh

from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.model.cameras import orthographic_camera
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.splatting.projection import CameraBatch, batch_of
from gaussiancad_core.splatting.rasterizer import (
    Backend,
    Parameters,
    RasterSettings,
    rasteriser,
)

MINUTES = 15

RADIUS = 50.0
"""mm of the sphere."""

Tensors = tuple[torch.Tensor, ...]


def sphere(count: int) -> Gaussians:
    """Gaussians on a sphere whose box starts at the origin, coloured by their place."""
    ball = trimesh.creation.icosphere(subdivisions=5, radius=RADIUS)
    surface = make_mesh(ball.vertices + RADIUS, ball.faces)
    if count <= 100_000:
        gaussians = gaussians_on(surface, Start(count))
        gaussians.colours[:] = gaussians.means / (2.0 * RADIUS)
        return gaussians
    # Spreading a million points evenly takes minutes: some are repeated with smaller discs.
    base = gaussians_on(surface, Start(50_000))
    times = -(-count // 50_000)
    columns = (
        np.tile(getattr(base, item), (times, 1))[:count] for item in ("means", "quaternions")
    )
    scales = np.tile(base.log_scales, (times, 1))[:count] - np.float32(np.log(times) / 2.0)
    logits = np.tile(base.logit_opacities, times)[:count]
    shades = np.full((count, 3), 0.5, np.float32)
    return Gaussians(*columns, scales, logits, shades, np.tile(base.normals, (times, 1))[:count])


def views(pixels: int) -> CameraBatch:
    """Three orthographic views of the sphere."""
    size = (2.0 * RADIUS,) * 3
    return batch_of(tuple(orthographic_camera(role, size, pixels) for role in ROLES))


def weights(pixels: int, device: str) -> Tensors:
    """Fixed random upstream gradients for colours, alphas and depths."""
    generator = torch.Generator().manual_seed(0)
    shapes = ((3, 3, pixels, pixels), (3, pixels, pixels), (3, pixels, pixels))
    return tuple(torch.randn(shape, generator=generator).to(device) for shape in shapes)


def gradients(
    backend: Backend, parameters: Parameters, cameras: CameraBatch, upstream: Tensors
) -> Tensors:
    """Draw all views and differentiate them."""
    rendering = rasteriser(backend)(parameters, cameras, RasterSettings())
    images = (rendering.colours, rendering.alphas, rendering.depths)
    found = torch.autograd.grad(images, parameters.tensors, upstream)
    if backend is Backend.GSPLAT:
        torch.cuda.synchronize()
    return found
