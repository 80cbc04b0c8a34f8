"""How fast and how small is the rasterizer, and what does each recipe cost?

``kernels`` times forward and backward passes by number of Gaussians and pixels, ``recipes`` trains
a part by both recipes, ``memory`` draws and differentiates many Gaussians; each is one run.

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
import time
from dataclasses import replace
from pathlib import Path

from benchmarks.judge.surface_distance import measure_mesh
from benchmarks.methods.trained import started_on, trained_from
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.disturbed_views import cases, solid_mesh, views_of
from benchmarks.tasks.splatting_kernels import run_kernels
from benchmarks.tasks.splatting_scene import gradients, sphere, views, weights
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.report.run_report import peak_memory_mb
from gaussiancad_core.samples import sample
from gaussiancad_core.splatting.rasterizer import (
    Backend,
    parameters_of,
)
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.splatting.tiles import warm_up
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_protocol.modes import Preset, Recipe

MINUTES = 15


_MEMORY_PX = 512


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    commands = parser.add_subparsers(required=True)
    kernels = commands.add_parser("kernels")
    kernels.add_argument("--counts", type=int, nargs="+", default=[2_000, 10_000, 50_000])
    kernels.add_argument("--pixels", type=int, nargs="+", default=[256, 512, 1024])
    kernels.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    kernels.add_argument("--repeats", type=int, default=5)
    kernels.add_argument("--chart", type=Path)
    kernels.set_defaults(ask=run_kernels)
    recipes = commands.add_parser("recipes")
    recipes.add_argument("--sample", default="l-bracket")
    recipes.add_argument("--preset", type=Preset, default=Preset.STANDARD)
    recipes.add_argument("--paper-iterations", type=int, default=20)
    recipes.add_argument("--gpu", action="store_true", help="with gsplat, by the clock")
    recipes.add_argument("--scale-down", type=int, default=1, help="of the paper's images")
    recipes.set_defaults(ask=run_recipes)
    memory = commands.add_parser("memory")
    memory.add_argument("--count", type=int, default=1_000_000)
    memory.set_defaults(ask=run_memory)


def run(options: argparse.Namespace) -> Outcome:
    """Run one of the three."""
    return options.ask(options)


def run_recipes(options: argparse.Namespace) -> Outcome:
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
        start = started_on(hull, sheet, settings)
        clock = time.perf_counter if options.gpu else time.process_time
        if options.gpu:
            settings = replace(settings, backend=Backend.GSPLAT)
        began = clock()
        trained = trained_from(start, sheet, cameras, settings)
        seconds = (clock() - began) / trained.iterations
        ended = whole if paper else trained.iterations
        spent[recipe] = seconds * ended
        stated = f"{seconds * 1e3:.0f} ms an iteration, "
        stated += f"{spent[recipe]:.0f} s for {ended}"
        if trained.iterations == ended:
            before, after = (
                measure_mesh(gaussian_surface(item, PoissonSettings()), mesh, sheet.size).p2s
                for item in (start, trained.gaussians)
            )
            stated += f"; {before:.4f} from the truth before, {after:.4f} after"
        else:
            stated += f", extrapolated from {trained.iterations}"
        print(f"{recipe.value}: {stated}", flush=True)
    ratio = spent[Recipe.PAPER] / spent[Recipe.ORTHOGRAPHIC]
    figures = [Figure(recipe.value, round(seconds, 1), "s") for recipe, seconds in spent.items()]
    return Outcome((Figure("the paper's recipe by the default", round(ratio)), *figures))


def run_memory(options: argparse.Namespace) -> Outcome:
    """Print the most memory that a process holds; what this one held before is part of it."""
    warm_up()
    gaussians = sphere(options.count)
    before = peak_memory_mb()
    parameters = parameters_of(gaussians)
    gradients(Backend.TILES, parameters, views(_MEMORY_PX), weights(_MEMORY_PX, "cpu"))
    about = f"{options.count} Gaussians, three views of {_MEMORY_PX} px"
    figures = (
        Figure(f"{about}: at most", round(peak_memory_mb()), "MB"),
        Figure("before the first image", round(before), "MB"),
    )
    return Outcome(figures)
