"""How near to the truth are the hull, the carved hull and the surface of the Gaussians?

The hull, the hull carved by the exact solid's depths, and the Poisson surface on the latter before
and after splatting are measured side by side.

Each part is drawn, read and reconstructed as ``gaussiancad reconstruct`` does it, and measured
against its own solid in place, without registration: the volumes' intersection over union (IoU),
and ``p2s``, the mean distance between points of either surface and the other surface, the mean of
both ways, where the part's longest edge is 5.
"""

import argparse
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.judge.surface_distance import Measure, measure_mesh
from benchmarks.parts.named_parts import Part, named_classed, named_samples
from benchmarks.run.arguments import tell
from benchmarks.run.outcome import Figure, Outcome, as_table
from benchmarks.sheets.clean_sheets import draw_clean
from benchmarks.tasks.trained import started_on, trained_from
from gaussiancad_core.errors import UsageError
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.hull.space_carving import carved_hull
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.kernel.brep import moved_to_origin, tessellate
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.recognition.picture_layout import Stated, picture_layout
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.colouring import coloured
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, read_views, register_views
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
    found = []
    for part in parts:
        measured, source = measures(part, preset)
        found.append([(item.iou, item.p2s) for item in measured])
        tell(f"{part.name}: {_in_words(found[-1])}, carved by {source}")
    table = np.array(found)
    worst = np.stack([table[..., 0].min(axis=0), table[..., 1].max(axis=0)], axis=1)
    lines = (("median", np.median(table, axis=0)), ("worst", worst))
    head = (f"IoU, p2s of {len(parts)} parts", *names)
    cells = tuple((name, *map(_cell, line)) for name, line in lines)
    print(as_table(head, cells))
    figures = [
        Figure(f"{name}, median IoU", round(float(iou), 4))
        for name, (iou, _) in zip(names, lines[0][1], strict=True)
    ]
    return Outcome(tuple(figures), False, head, cells)


def _cell(measure: Sequence[float]) -> str:
    iou, p2s = measure
    return f"{iou:.4f}, {p2s:.4f}"


def _in_words(measured: Sequence[Sequence[float]]) -> str:
    return "; ".join(map(_cell, measured))


def measures(part: Part, preset: Preset | None) -> tuple[list[Measure], str]:
    """The hull, the carved one, and the surface of the Gaussians before and after training.

    Without a preset the hulls alone; beside them what carved the hull.
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
    return [measure_mesh(surface, truth, views.size) for surface in surfaces], source


def registered_of(part: Part) -> RegisteredSheet:
    """The part's clean sheet, drawn and read."""
    with tempfile.TemporaryDirectory() as folder:
        path = draw_clean(part.build(), Path(folder) / "sheet.png")
        sheet = OpenedSheet(read_sheet(path), 0)
    bare = SeparatedSheet(sheet.clean, ())
    layout = picture_layout(sheet, bare, Stated({}, Projection.THIRD))[1]
    found = register_views(read_views(sheet.clean, layout), ReadingOptions())
    return replace(found, views=coloured(found.views, ReadingOptions().colour))


def truth_of(part: Part, size: tuple[float, float, float]) -> TriangleMesh:
    """The part's solid, scaled to the size of the views."""
    vertices, triangles = tessellate(moved_to_origin(part.build()), 0.01)
    scale = max(size) / float(np.ptp(vertices, axis=0).max())
    return TriangleMesh(vertices * scale, triangles)
