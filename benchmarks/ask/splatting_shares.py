"""Where does the time of the tile kernels go, and how much of it can threads share?

Forward and backward of three views of Gaussians on a sphere, on one thread, processor time, the
least of some repeats.  A pair is a Gaussian in a tile; ``tested`` are the pixels that its lines in
the tile have, ``blended`` those where it is not too faint and something is left to cover.
``serial`` is the share of the time outside of the kernels that threads share out, and ``bound`` how
many times as fast two threads can be for it (Amdahl 1967).
"""

import argparse
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any

import numba
import numpy as np
import torch

from benchmarks.run.outcome import Figure, Outcome
from benchmarks.tasks.splatting_scene import gradients, sphere, views, weights
from gaussiancad_core.splatting import projection_kernels, tile_kernels, tile_sorting
from gaussiancad_core.splatting.rasterizer import Backend, parameters_of
from gaussiancad_core.splatting.tiles import warm_up

MINUTES = 5

KERNELS: tuple[tuple[ModuleType, str], ...] = (
    (projection_kernels, "project_forward"),
    (tile_sorting, "find_boxes"),
    (tile_sorting, "fill_records"),
    (tile_sorting, "_radix_order"),
    (tile_sorting, "count_tiles"),
    (tile_sorting, "fill_tiles"),
    (tile_kernels, "composite_forward"),
    (tile_kernels, "composite_backward"),
    (tile_kernels, "add_pairs"),
    (projection_kernels, "project_backward"),
)
"""All whose loops threads share out."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--counts", type=int, nargs="+", default=[2_000, 10_000, 50_000])
    parser.add_argument("--pixels", type=int, nargs="+", default=[256, 1024])
    parser.add_argument("--repeats", type=int, default=7)


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    numba.set_num_threads(1)
    torch.set_num_threads(1)
    warm_up()
    figures = []
    for count in options.counts:
        gaussians = sphere(count)
        for pixels in options.pixels:
            parameters = parameters_of(gaussians)
            arguments = (Backend.TILES, parameters, views(pixels), weights(pixels, "cpu"))
            seconds, last = shares(lambda given=arguments: gradients(*given), options.repeats)
            print_shares(count, pixels, seconds, last)
            about = f"{count} Gaussians, {pixels} px"
            figures.append(Figure(about, round(seconds["whole"] * 1e3, 1), "ms"))
    return Outcome(tuple(figures))


def shares(work: Callable[[], object], repeats: int) -> tuple[dict[str, float], tuple[Any, ...]]:
    """Least seconds of each kernel and of the whole; what compositing was called with last."""
    least: dict[str, float] = {}
    for _ in range(repeats):
        with watched() as (spent, calls):
            began = time.process_time()
            work()
            spent["whole"] = time.process_time() - began
        for name, seconds in spent.items():
            least[name] = min(seconds, least.get(name, np.inf))
    return least, calls["composite_forward"]


@contextmanager
def watched() -> Iterator[tuple[dict[str, float], dict[str, tuple[Any, ...]]]]:
    """Time all kernels while the context lasts, and keep what they are called with."""
    spent: dict[str, float] = {}
    calls: dict[str, tuple[Any, ...]] = {}
    plain = {name: getattr(module, name) for module, name in KERNELS}

    def watch(name: str) -> Callable[..., None]:
        def call(*arguments: object) -> None:
            began = time.process_time()
            plain[name](*arguments)
            spent[name] = spent.get(name, 0.0) + time.process_time() - began
            calls[name] = arguments

        return call

    try:
        for module, name in KERNELS:
            setattr(module, name, watch(name))
        yield spent, calls
    finally:
        for module, name in KERNELS:
            setattr(module, name, plain[name])


def print_shares(count: int, pixels: int, seconds: dict[str, float], call: tuple[Any, ...]) -> None:
    """Print one setting."""
    _, grid, (starts, members, _), records, limits, spans, _ = call
    tested = 8 * int((spans[:, 1].astype(np.int64) - spans[:, 0]).clip(0).sum())
    drawn = int(blended(grid[1], grid[0] * grid[1], starts, members, records, limits, spans))
    whole = seconds["whole"]
    serial = 1.0 - sum(second for name, second in seconds.items() if name != "whole") / whole
    bound = 1.0 / (serial + (1.0 - serial) / 2.0)
    print(
        f"{count} Gaussians, {pixels} px: {whole * 1e3:.1f} ms; {len(members)} pairs, "
        f"{whole / len(members) * 1e9:.0f} ns each; {tested} pixels tested, "
        f"{whole / tested * 1e9:.1f} ns; {drawn} blended, {whole / drawn * 1e9:.1f} ns; "
        f"serial {serial:.3f}, bound {bound:.2f}"
    )
    rows = sorted(seconds.items(), key=lambda row: -row[1])
    print("   " + ", ".join(f"{name} {item * 1e3:.1f}" for name, item in rows[1:]), flush=True)


@numba.njit
def blended(columns, per_view, starts, members, records, limits, spans):  # noqa: ANN001, ANN201, PLR0917
    """Number of pixels to which a Gaussian adds something."""
    total = 0
    for index in range(len(starts) - 1):
        place = index % per_view
        x0, y0 = place % columns * 8 + 0.5, place // columns * 16 + 0.5
        left = np.ones((16, 8))
        for pair in range(starts[index], starts[index + 1]):
            record = records[members[pair]]
            for line in range(spans[pair, 0], spans[pair, 1]):
                for column in range(8):
                    dx, dy = x0 + column - record[0], y0 + line - record[1]
                    power = (record[2] * dx + record[3] * dy) * dx + record[4] * dy * dy
                    alpha = min(record[5] * np.exp(-power), limits[1])
                    if alpha >= limits[0] and left[line, column] > limits[2]:
                        left[line, column] *= 1.0 - alpha
                        total += 1
    return total
