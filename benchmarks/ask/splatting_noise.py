"""Does splatting bring the surface nearer to the truth where masks are wrong?

Parts whose hull is exact are seen from three sides, and their masks disturbed: outlines that waver
by 0 to 4 px, views that lie 1 or 2 px beside their place, bites in the outlines.  ``p2s`` is the
mean distance of the surfaces, in a box whose longest edge is 5 (500 px); ``outline`` what the
surface's shadows and the disturbed masks do not share.  The last column says what a run delivers.
"""

import argparse
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.judge.surface_distance import measure_mesh
from benchmarks.methods.trained import started_on, trained_from
from benchmarks.run.charts import Chart, Series, write_chart
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.disturbed_views import Case, cases, solid_mesh, views_of
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.samples import sample
from gaussiancad_core.splatting.settings import (
    TrainingSettings,
    training_cameras,
    training_settings,
)
from gaussiancad_core.surface.mesh_shadows import silhouette_difference
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_protocol.modes import Preset, Recipe

MINUTES = 30

NAMES = ("l-bracket", "stepped-block")
COLUMNS = ("hull", "Poisson before", "after", "after, free")
"""``free``: no anchor, and positions that move five times as fast, as in 3DGS."""

Row = list[tuple[float, float]]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--samples", nargs="*", default=NAMES)
    parser.add_argument("--preset", type=Preset, default=Preset.STANDARD)
    parser.add_argument("--chart", type=Path)


def run(options: argparse.Namespace) -> Outcome:
    """Print the table, and draw it."""
    print(f"{'':18}{'':20}" + "".join(f"{name:>20}" for name in COLUMNS))
    print(f"{'part':18}{'masks':20}" + f"{'p2s':>11}{'outline':>9}" * len(COLUMNS) + "  delivered")
    found: dict[str, list[Row]] = {case.name: [] for case in cases()}
    for name in options.samples:
        mesh = solid_mesh(sample(name).build())
        for case in cases():
            row = measured(mesh, case, options.preset)
            found[case.name].append(row)
            print_row(name, case.name, row)
    means = {name: np.mean(rows, axis=0).tolist() for name, rows in found.items() if rows}
    for name, row in means.items():
        print_row("mean", name, row)
    if options.chart:
        lines = [
            Series(column, [means[case.name][k][0] for case in cases()])
            for k, column in enumerate(COLUMNS)
        ]
        ticks = [case.name.replace(" ", "\n", 1) for case in cases()]
        write_chart(Chart("distance from the truth (box of 5)", ticks, lines), options.chart)
    figures = (
        Figure(f"{name}: {column}", row[k][0], "units of a box of 5")
        for name, row in means.items()
        for k, column in enumerate(COLUMNS)
    )
    return Outcome(tuple(figures))


def print_row(part: str, masks: str, row: Row) -> None:
    """One line of the table."""
    cells = "".join(f"{p2s:11.5f}{outline:9.5f}" for p2s, outline in row)
    taken = "Gaussians" if row[2][1] < row[0][1] else "hull"
    print(f"{part:18}{masks:20}{cells}  {taken}", flush=True)


def measured(mesh: TriangleMesh, case: Case, preset: Preset) -> Row:
    """Distance from the truth and from the masks of all four surfaces."""
    views = views_of(mesh, case, seed=0)
    settings = training_settings(Recipe.ORTHOGRAPHIC, preset)
    rates = replace(settings.rates, position=8e-4, position_end=8e-5)
    hull = visual_hull(
        views, training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
    )
    surfaces: list[Callable[[], TriangleMesh]] = [
        lambda: hull,
        lambda: poisson(hull, views, replace(settings, iterations=0)),
        lambda: poisson(hull, views, settings),
        lambda: poisson(hull, views, replace(settings, anchor=0.0, rates=rates)),
    ]
    row = []
    for make in surfaces:
        surface = make()
        distance = measure_mesh(surface, mesh, views.size).p2s
        row.append((distance, silhouette_difference(surface, views)))
    return row


def poisson(hull: TriangleMesh, views: ViewSet, settings: TrainingSettings) -> TriangleMesh:
    """The Poisson surface of Gaussians that were trained from the hull."""
    cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
    start = started_on(hull, views, settings)
    trained = trained_from(start, views, cameras, settings)
    return gaussian_surface(trained.gaussians, PoissonSettings())
