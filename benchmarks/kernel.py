"""The compiled rasteriser against the plain one: speed and agreement in one run.

Draws three views of Gaussians on a sphere and differentiates them, with both back ends on the same
input, and prints the medians, their ratio and the largest relative difference.

    python benchmarks/kernel.py [--pixels 256] [--counts 2000 10000] [--repeats 7]
"""

import argparse
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import torch
import trimesh

from gaussiancad_core.axes import Role
from gaussiancad_core.cameras import orthographic_camera
from gaussiancad_core.meshes import make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.splatting.projection import CameraBatch, batch_of
from gaussiancad_core.splatting.rasteriser import (
    Backend,
    Optics,
    Parameters,
    parameters_of,
    rasteriser,
)
from gaussiancad_core.splatting.tiles import warm_up

RADIUS = 50.0
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
Tensors = tuple[torch.Tensor, ...]


@dataclass(frozen=True)
class Row:
    """One line of the table; times in seconds."""

    count: int
    fast: float
    plain: float
    difference: float


def sphere(count: int) -> Gaussians:
    """Gaussians spread over a sphere whose box starts at the origin, coloured by their place."""
    ball = trimesh.creation.icosphere(subdivisions=5, radius=RADIUS)
    gaussians = gaussians_on(make_mesh(ball.vertices + RADIUS, ball.faces), Start(count))
    gaussians.colours[:] = gaussians.means / (2.0 * RADIUS)
    return gaussians


def views(pixels: int) -> CameraBatch:
    """Three orthographic views of the sphere."""
    size = (2.0 * RADIUS,) * 3
    return batch_of(tuple(orthographic_camera(role, size, pixels) for role in ROLES))


def weights(pixels: int) -> Tensors:
    """Fixed random upstream gradients for colours, alphas and depths."""
    generator = torch.Generator().manual_seed(0)
    shapes = ((3, 3, pixels, pixels), (3, pixels, pixels), (3, pixels, pixels))
    return tuple(torch.randn(shape, generator=generator) for shape in shapes)


def gradients(
    backend: Backend, parameters: Parameters, cameras: CameraBatch, upstream: Tensors
) -> Tensors:
    """Draw all views and differentiate them."""
    rendering = rasteriser(backend)(parameters, cameras, Optics())
    images = (rendering.colours, rendering.alphas, rendering.depths)
    return torch.autograd.grad(images, parameters.tensors, upstream)


def timed(work: Callable[[], Tensors], repeats: int) -> tuple[float, Tensors]:
    """Median of the wall times in seconds, and what came out."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        found = work()
        times.append(time.perf_counter() - start)
    return statistics.median(times), found


def measure(count: int, pixels: int, repeats: int) -> Row:
    """Both back ends on one scene."""
    parameters, cameras, upstream = parameters_of(sphere(count)), views(pixels), weights(pixels)
    found = {
        backend: timed(
            lambda backend=backend: gradients(backend, parameters, cameras, upstream), repeats
        )
        for backend in Backend
    }
    (fast, one), (plain, other) = found[Backend.TILES], found[Backend.REFERENCE]
    differences = [
        float((a - b).abs().max() / b.abs().max()) for a, b in zip(one, other, strict=True)
    ]
    return Row(count, fast, plain, float(np.max(differences)))


def main() -> None:
    """Measure and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pixels", type=int, default=256)
    parser.add_argument("--counts", type=int, nargs="+", default=[2_000, 10_000])
    parser.add_argument("--repeats", type=int, default=7)
    options = parser.parse_args()
    warm_up()
    print(f"forward + backward, three views of {options.pixels} x {options.pixels} px")
    print(f"{'Gaussians':>10} {'compiled':>12} {'plain torch':>12} {'ratio':>8} {'difference':>12}")
    for count in options.counts:
        row = measure(count, options.pixels, options.repeats)
        print(
            f"{row.count:>10} {row.fast * 1e3:>9.1f} ms {row.plain * 1e3:>9.0f} ms"
            f" {row.plain / row.fast:>7.0f}x {row.difference:>12.1e}"
        )


if __name__ == "__main__":
    main()
