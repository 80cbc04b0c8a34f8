"""Rasterisers side by side, recipes side by side, and memory: one run each.

    .venv/bin/python benchmarks/splatting.py kernels [--counts N ...] [--pixels N ...]
        [--threads N ...] [--chart FILE]
    .venv/bin/python benchmarks/splatting.py recipes [--sample NAME] [--paper-iterations N]
        [--gpu] [--scale-down N]
    .venv/bin/python benchmarks/splatting.py memory [--count N]

``kernels``: forward and backward of three views of Gaussians on a sphere.  Times on one thread are
those of the processor, the least of all repeats, so that other work on the machine counts little;
on more threads and on a GPU they are those of the clock.  ``ns a pair``: one Gaussian at one pixel
of its box.  The reference in plain torch is left out where it would take minutes.

``recipes``: seconds of training and distance of the surface from the truth, the default against the
paper's, which is timed for some iterations and extrapolated, or trained to its end.  Times are
those of the processor, with ``--gpu`` of the clock.

``memory``: the most that a process holds that draws and differentiates so many Gaussians.
"""

import argparse
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numba
import numpy as np
import torch
import trimesh
from charts import Chart, Series, write_chart
from disturbed_views import cases, solid_mesh, views_of
from surface import measure_mesh

from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import orthographic_camera
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.modes import Preset, Recipe
from gaussiancad_core.report.run_report import peak_memory_mb
from gaussiancad_core.samples import sample
from gaussiancad_core.splatting.gaussian_training import train
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.splatting.projection import CameraBatch, batch_of, project
from gaussiancad_core.splatting.rasterizer import (
    Backend,
    Optics,
    Parameters,
    parameters_of,
    rasteriser,
)
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.splatting.targets import mean_colour, targets_of
from gaussiancad_core.splatting.tiles import warm_up
from gaussiancad_core.splatting.torch_devices import cuda_problem
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface

RADIUS = 50.0
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
Tensors = tuple[torch.Tensor, ...]

REFERENCE_LIMIT = 10_000 * 256**2
"""Gaussians times pixels of a view up to which plain torch is run."""

_MEMORY_PX = 512


@dataclass(frozen=True)
class Setting:
    """One row of the table of kernels."""

    backend: Backend
    threads: int
    count: int
    pixels: int


def main() -> None:
    """Run one of the three."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(required=True)
    kernels = commands.add_parser("kernels")
    kernels.add_argument("--counts", type=int, nargs="+", default=[2_000, 10_000, 50_000])
    kernels.add_argument("--pixels", type=int, nargs="+", default=[256, 512, 1024])
    kernels.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    kernels.add_argument("--repeats", type=int, default=5)
    kernels.add_argument("--chart", type=Path)
    kernels.set_defaults(run=run_kernels)
    recipes = commands.add_parser("recipes")
    recipes.add_argument("--sample", default="l-bracket")
    recipes.add_argument("--preset", type=Preset, default=Preset.STANDARD)
    recipes.add_argument("--paper-iterations", type=int, default=20)
    recipes.add_argument("--gpu", action="store_true", help="with gsplat, by the clock")
    recipes.add_argument("--scale-down", type=int, default=1, help="of the paper's images")
    recipes.set_defaults(run=run_recipes)
    memory = commands.add_parser("memory")
    memory.add_argument("--count", type=int, default=1_000_000)
    memory.add_argument("--inner", action="store_true", help=argparse.SUPPRESS)
    memory.set_defaults(run=run_memory)
    options = parser.parse_args()
    options.run(options)


def run_kernels(options: argparse.Namespace) -> None:
    """Print the table, and draw it."""
    warm_up()
    problem = cuda_problem()
    if problem:
        print(f"gsplat is left out: {problem}")
    print(f"{'back end':>10}{'threads':>8}{'Gaussians':>10}{'px':>6}{'ms':>10}{'ns a pair':>11}")
    found: dict[Setting, float] = {}
    for count in options.counts:
        gaussians = sphere(count)
        for pixels in options.pixels:
            for setting in settings_for(count, pixels, options.threads, gpu=problem is None):
                seconds, pairs = measure(setting, gaussians, options.repeats)
                found[setting] = seconds
                print(
                    f"{setting.backend.value:>10}{setting.threads:>8}{count:>10}{pixels:>6}"
                    f"{seconds * 1e3:>10.1f}{seconds / pairs * 1e9:>11.2f}",
                    flush=True,
                )
    tell_ratios(found)
    if options.chart:
        draw_kernels(found, options)


def settings_for(count: int, pixels: int, threads: list[int], *, gpu: bool) -> list[Setting]:
    """The rows for one scene."""
    rows = [Setting(Backend.TILES, own, count, pixels) for own in threads]
    if count * pixels**2 <= REFERENCE_LIMIT:
        rows.append(Setting(Backend.REFERENCE, 1, count, pixels))
    return [*rows, Setting(Backend.GSPLAT, 1, count, pixels)] if gpu else rows


def tell_ratios(found: dict[Setting, float]) -> None:
    """How much faster the kernels are than torch, and on more threads than on one."""
    for setting, seconds in found.items():
        alone = found.get(replace(setting, backend=Backend.TILES, threads=1))
        if alone is None or (setting.backend is Backend.TILES and setting.threads == 1):
            continue
        ratio = seconds / alone if setting.backend is Backend.REFERENCE else alone / seconds
        print(
            f"{setting.count} Gaussians at {setting.pixels} px: "
            + (
                f"{ratio:.0f} times as fast as plain torch, both on one thread"
                if setting.backend is Backend.REFERENCE
                else f"{ratio:.2f} times as fast with {setting.backend.value} on "
                f"{setting.threads} thread(s) as tiles on one"
            )
        )


def draw_kernels(found: dict[Setting, float], options: argparse.Namespace) -> None:
    """Milliseconds over the number of Gaussians."""
    lines = []
    for backend in (Backend.TILES, Backend.REFERENCE, Backend.GSPLAT):
        for pixels in options.pixels:
            values = [
                found.get(Setting(backend, 1, count, pixels), float("nan")) * 1e3
                for count in options.counts
            ]
            if np.isfinite(values).any():
                lines.append(Series(f"{backend.value} {pixels} px", values))
    ticks = [f"{count}" for count in options.counts]
    title = "ms, forward + backward of three views, one thread, by Gaussians"
    write_chart(Chart(title, ticks, lines, logarithmic=True), options.chart)


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
    columns = (np.tile(getattr(base, own), (times, 1))[:count] for own in ("means", "quaternions"))
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
    rendering = rasteriser(backend)(parameters, cameras, Optics())
    images = (rendering.colours, rendering.alphas, rendering.depths)
    found = torch.autograd.grad(images, parameters.tensors, upstream)
    if backend is Backend.GSPLAT:
        torch.cuda.synchronize()
    return found


def measure(setting: Setting, gaussians: Gaussians, repeats: int) -> tuple[float, float]:
    """Seconds of forward and backward; pairs of a Gaussian and a pixel of its box."""
    device = setting.backend.device
    parameters = parameters_of(gaussians, device=device)
    cameras = views(setting.pixels)
    work = partial(
        gradients,
        setting.backend,
        parameters,
        cameras.on(device),
        weights(setting.pixels, device),
    )
    alone = setting.threads == 1 and device == "cpu"
    before = numba.get_num_threads(), torch.get_num_threads()
    numba.set_num_threads(min(setting.threads, before[0]))
    torch.set_num_threads(1)
    try:
        times = 1 if setting.backend is Backend.REFERENCE else repeats
        clock = time.process_time if alone else time.perf_counter
        seconds = min(timed(work, clock) for _ in range(times))
    finally:
        numba.set_num_threads(before[0])
        torch.set_num_threads(before[1])
    return seconds, pair_count(gaussians, cameras)


def timed(work: Callable[[], Tensors], clock: Callable[[], float]) -> float:
    """Seconds that a piece of work takes by a clock."""
    start = clock()
    work()
    return clock() - start


def pair_count(gaussians: Gaussians, cameras: CameraBatch) -> float:
    """Pixels in the boxes of all Gaussians in all views."""
    parameters, optics = parameters_of(gaussians), Optics()
    with torch.no_grad():
        splats = project(
            parameters.means,
            parameters.quaternions,
            parameters.log_scales,
            cameras,
            optics.dilation,
        )
        reach = 2.0 * torch.log(torch.sigmoid(parameters.logit_opacities) / optics.smallest_alpha)
        half = torch.sqrt(reach[None, :, None] * splats.covariances[..., [0, 2]])
        return float((2.0 * half).clamp_min(1.0).prod(dim=2).sum())


def run_recipes(options: argparse.Namespace) -> None:
    """Print what the recipes cost and how good they are."""
    mesh = solid_mesh(sample(options.sample).build())
    sheet = views_of(mesh, cases()[0], seed=0)
    warm_up()
    print(f"{options.sample}; distance from the truth in a box of 5")
    spent = {}
    for recipe in Recipe:
        paper = recipe is Recipe.PAPER
        settings = training_settings(recipe, options.preset, options.scale_down if paper else 1)
        whole = settings.iterations
        if paper:
            settings = replace(settings, iterations=options.paper_iterations)
        cameras = training_cameras(recipe, settings, sheet.roles, sheet.size)
        hull = visual_hull(sheet, cameras)
        start = gaussians_on(
            hull,
            Start(
                settings.count,
                thickness=settings.thickness,
                opacity=settings.opacity,
                colour=mean_colour(sheet),
            ),
        )
        targets = targets_of(sheet, cameras)
        clock = time.perf_counter if options.gpu else time.process_time
        if options.gpu:
            settings = replace(settings, backend=Backend.GSPLAT)
        began = clock()
        trained = train(start, cameras, targets, settings, lambda *_: None)
        seconds = (clock() - began) / trained.iterations
        ended = whole if paper else trained.iterations
        spent[recipe] = seconds * ended
        told = f"{seconds * 1e3:.0f} ms an iteration, "
        told += f"{spent[recipe]:.0f} s for {ended}"
        if trained.iterations == ended:
            before, after = (
                measure_mesh(gaussian_surface(own, PoissonSettings()), mesh, sheet.size).p2s
                for own in (start, trained.gaussians)
            )
            told += f"; {before:.4f} from the truth before, {after:.4f} after"
        else:
            told += f", extrapolated from {trained.iterations}"
        print(f"{recipe.value}: {told}", flush=True)
    print(f"ratio {spent[Recipe.PAPER] / spent[Recipe.ORTHOGRAPHIC]:.0f}")


def run_memory(options: argparse.Namespace) -> None:
    """Print the most memory that a process of its own holds."""
    if not options.inner:
        command = [sys.executable, __file__, "memory", "--inner", "--count", str(options.count)]
        subprocess.run(command, check=True)
        return
    warm_up()
    gaussians = sphere(options.count)
    before = peak_memory_mb()
    parameters = parameters_of(gaussians)
    gradients(Backend.TILES, parameters, views(_MEMORY_PX), weights(_MEMORY_PX, "cpu"))
    print(
        f"{options.count} Gaussians, three views of {_MEMORY_PX} px: at most "
        f"{peak_memory_mb():.0f} MB, {before:.0f} MB of it before the first image"
    )


if __name__ == "__main__":
    main()
