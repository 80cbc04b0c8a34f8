"""How near to the truth are the hull, the carved hull and the surface of the Gaussians?

The hull, the hull carved by the exact solid's depths, and the Poisson surface on the latter before
and after splatting are measured side by side.

Each part is drawn, read and reconstructed as ``gaussiancad reconstruct`` does it, and measured
against its own solid in place, without registration.  Lengths are in units of a box whose longest
edge is 5.  ``p2s`` is the mean distance between points of either surface and the other surface, the
mean of both ways.  ``CD`` is the Chamfer distance as ``gaussiancad compare`` measures it, but
without registration: each in a box of its own, so that one ridge that stands out shifts and shrinks
all; ``floor`` is that of two samples of the truth.  ``carved`` is the status of the solid whose
depths carved the hull.
"""

import argparse
import tempfile
from dataclasses import astuple, replace
from pathlib import Path

import numpy as np

from benchmarks.judge.surface_distance import BOX, POINTS, Measure, chamfer_floor, measure_mesh
from benchmarks.methods.trained import started_on, trained_from
from benchmarks.parts.named_parts import Part, named_classed, named_samples
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.clean_sheets import draw_clean
from gaussiancad_core.errors import UsageError
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.hull.space_carving import carved_hull
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.kernel.brep import moved_to_origin, tessellate
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.colouring import coloured
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, read_views, register_views
from gaussiancad_core.sheet.views.role_score import Drawings, arrange
from gaussiancad_core.sheet.views.sheet_layout import view_clusters
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_protocol.modes import Preset, Recipe

MINUTES = 20


COLUMNS = ("hull", "carved hull", "Poisson before", "after splatting")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--preset", type=Preset, default=Preset.STANDARD)
    parser.add_argument("--samples", nargs="*", default=[])
    parser.add_argument("--classed", type=int, help="parts of each class instead of the samples")
    parser.add_argument("--hulls", action="store_true", help="leave the Gaussians out")


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    parts = list(
        named_classed(options.classed) if options.classed else named_samples(options.samples)
    )
    if not parts:
        raise UsageError("unknown-sample", f"there is no sample {' '.join(options.samples)}")
    preset = None if options.hulls else options.preset
    names = COLUMNS[:2] if options.hulls else COLUMNS
    print(f"preset {options.preset.value}, {POINTS} points, longest edge = {BOX:g}")
    print(f"{'':20}" + "".join(f"{name:>17}" for name in names))
    print(f"{'part':20}" + f"{'IoU':>9}{'p2s':>8}{'CD':>8}" * len(names) + "   floor  carved")
    rows = []
    for part in parts:
        measured, floor, source = measures(part, preset)
        rows.append([value for measure in measured for value in astuple(measure)] + [floor])
        _print_row(part.name, rows[-1], source)
    table = np.array(rows)
    middle = np.median(table, axis=0)
    _print_row("median", middle.tolist())
    worst = table.max(axis=0)
    worst[:-1:3] = table[:, :-1:3].min(axis=0)
    _print_row("worst", worst.tolist())
    figures = []
    for column, name in enumerate(names):
        losses = table[:, 3 * column + 1] - table[:, 1]
        above = table[:, 3 * column + 2] - table[:, -1]
        print(
            f"{name}: p2s at most {losses.max():+.4f} against the hull's; "
            f"CD above the floor {np.median(above):+.4f}, at most {above.max():+.4f}"
        )
        figures.append(Figure(f"{name}, median IoU", round(middle[3 * column], 4)))
        figures.append(Figure(f"{name}, median p2s", round(middle[3 * column + 1], 4)))
    return Outcome(tuple(figures))


def _print_row(name: str, row: list[float], source: str = "") -> None:
    cells = "".join(
        f"{iou:9.4f}{p2s:8.4f}{chamfer:8.4f}"
        for iou, p2s, chamfer in zip(row[:-1:3], row[1:-1:3], row[2:-1:3], strict=True)
    )
    print(f"{name:20}{cells}{row[-1]:8.4f}  {source}", flush=True)


def measures(part: Part, preset: Preset | None) -> tuple[list[Measure], float, str]:
    """The hull, the carved one, and the surface of the Gaussians before and after training.

    Without a preset the hulls alone; beside them the floor of the Chamfer distance, and what carved
    the hull.
    """
    registered = registered_of(part)
    views = registered.views
    settings = training_settings(Recipe.ORTHOGRAPHIC, preset or Preset.STANDARD)
    cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
    exact = find_exact(ProjectedReading(registered, Projection.THIRD), None)
    carved = carved_hull(views, cameras, exact.result)
    surfaces = [visual_hull(views, cameras), carved.mesh]
    if preset is not None:
        start = started_on(carved.mesh, views, settings)
        trained = trained_from(start, views, cameras, settings)
        surfaces += [
            gaussian_surface(item, PoissonSettings()) for item in (start, trained.gaussians)
        ]
    truth = truth_of(part, views.size)
    source = carved.source.value if carved.source else carved.refused or "-"
    found = [measure_mesh(surface, truth, views.size) for surface in surfaces]
    return found, chamfer_floor(truth), source


def registered_of(part: Part) -> RegisteredSheet:
    """The part's clean sheet, drawn and read."""
    with tempfile.TemporaryDirectory() as folder:
        path = draw_clean(part.build(), Path(folder) / "sheet.png")
        clean = clean_sheet(read_sheet(path).grey)
    layout = arrange(Drawings(view_clusters(clean.ink, 0.0), clean.ink), {}, Projection.THIRD)
    found = register_views(read_views(clean, layout), ReadingOptions())
    return replace(found, views=coloured(found.views, ReadingOptions().colour))


def truth_of(part: Part, size: tuple[float, float, float]) -> TriangleMesh:
    """The part's solid, scaled to the size of the views."""
    vertices, triangles = tessellate(moved_to_origin(part.build()), 0.01)
    scale = max(size) / float(np.ptp(vertices, axis=0).max())
    return TriangleMesh(vertices * scale, triangles)
