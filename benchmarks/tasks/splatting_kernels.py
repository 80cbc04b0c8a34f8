"""Forward and backward passes of the rasterizers side by side: by Gaussians, pixels and threads."""

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numba
import numpy as np
import torch

from benchmarks.run.charts import Chart, Series, write_chart
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.tasks.splatting_scene import Tensors, gradients, sphere, views, weights
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.projection import CameraBatch, project
from gaussiancad_core.splatting.rasterizer import (
    Backend,
    RasterSettings,
    parameters_of,
)
from gaussiancad_core.splatting.tiles import warm_up
from gaussiancad_core.splatting.torch_devices import cuda_problem

MINUTES = 15

REFERENCE_LIMIT = 10_000 * 256**2
"""Gaussians times pixels of a view up to which plain torch is run."""


@dataclass(frozen=True)
class Setting:
    """One row of the table of kernels."""

    backend: Backend
    threads: int
    count: int
    pixels: int


def settings_for(count: int, pixels: int, threads: list[int], *, gpu: bool) -> list[Setting]:
    """The rows for one scene."""
    rows = [Setting(Backend.TILES, thread, count, pixels) for thread in threads]
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
    parameters, optics = parameters_of(gaussians), RasterSettings()
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


def run_kernels(options: argparse.Namespace) -> Outcome:
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
    figures = (
        Figure(
            f"{setting.backend.value}, {setting.threads} threads, {setting.count} Gaussians, "
            f"{setting.pixels} px",
            round(seconds * 1e3, 1),
            "ms",
        )
        for setting, seconds in found.items()
    )
    return Outcome(tuple(figures))
