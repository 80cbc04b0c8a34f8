"""Surface against truth for the sample parts: the hull, its Poisson surface before and after
splatting, side by side.

Each sample is drawn, read and reconstructed as ``gaussiancad reconstruct`` does it, and measured
against its own solid in place, without registration.  Lengths are in units of a box whose longest
edge is 5.  ``p2s`` is the mean distance between points of either surface and the other surface, the
mean of both ways.

    .venv/bin/python benchmarks/surface.py [--preset standard] [--samples NAME ...]
"""

import argparse
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.comparison.distances import point_to_surface, volume_iou
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.drawing.brep import moved_to_origin, tessellate
from gaussiancad_core.drawing.command import write_image
from gaussiancad_core.drawing.sheet import draw_sheet
from gaussiancad_core.drawing.style import parse_style
from gaussiancad_core.hull import visual_hull
from gaussiancad_core.meshes import TriangleMesh
from gaussiancad_core.modes import Preset, Recipe
from gaussiancad_core.samples import SAMPLES, SamplePart
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.layout import find_layout
from gaussiancad_core.sheet.options import ReadingOptions
from gaussiancad_core.sheet.read import read_sheet
from gaussiancad_core.sheet.reading import read_views, register_views
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.splatting.targets import mean_colour, targets_of
from gaussiancad_core.splatting.training import train
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_core.views import ViewSet

POINTS = 10_000
BOX = 5.0


@dataclass(frozen=True)
class Measure:
    """Volume IoU and point-to-surface distance of a surface against the truth."""

    iou: float
    p2s: float


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--preset", type=Preset, default=Preset.STANDARD)
    parser.add_argument("--samples", nargs="*", default=[])
    options = parser.parse_args()
    chosen = [s for s in SAMPLES if not options.samples or s.name in options.samples]
    print(f"preset {options.preset.value}, {POINTS} points, longest edge = {BOX:g}")
    print(f"{'':20} {'hull':>15} {'Poisson before':>17} {'after splatting':>17}  after - hull")
    print(f"{'sample':20}" + f"{'IoU':>8} {'p2s':>8}" * 3 + f"{'p2s':>9}")
    rows = []
    for sample in chosen:
        hull, before, after = measures(sample, options.preset)
        rows.append([hull.iou, hull.p2s, before.iou, before.p2s, after.iou, after.p2s])
        _print_row(sample.name, rows[-1])
    _print_row("median", list(np.median(rows, axis=0)))
    worst = max(row[5] - row[1] for row in rows)
    print(
        f"largest loss against the hull {worst:+.4f}, against Poisson before splatting "
        f"{max(row[5] - row[3] for row in rows):+.4f}"
    )


def _print_row(name: str, row: list[float]) -> None:
    cells = "".join(f"{iou:8.4f} {p2s:8.4f}" for iou, p2s in zip(row[::2], row[1::2], strict=True))
    print(f"{name:20}{cells}{row[5] - row[1]:+9.4f}", flush=True)


def measures(sample: SamplePart, preset: Preset) -> tuple[Measure, Measure, Measure]:
    """The hull, and the Poisson surface of the Gaussians before and after training."""
    views = views_of(sample)
    settings = training_settings(Recipe.ORTHOGRAPHIC, preset)
    cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
    hull = visual_hull(views, cameras)
    start = gaussians_on(
        hull,
        Start(
            count=settings.count,
            thickness=settings.thickness,
            opacity=settings.opacity,
            colour=mean_colour(views),
        ),
    )
    trained = train(start, cameras, targets_of(views, cameras), settings, lambda *_: None)
    truth = truth_of(sample, views.size)
    surfaces = (
        hull,
        gaussian_surface(start, PoissonSettings(), hull),
        gaussian_surface(trained.gaussians, PoissonSettings(), hull),
    )
    return tuple(_measure(surface, truth, views.size) for surface in surfaces)


def views_of(sample: SamplePart) -> ViewSet:
    """The sample's clean sheet, drawn and read."""
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    sheet = draw_sheet(sample.build(), roles, Projection.THIRD, parse_style("clean"))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sheet.png"
        write_image(sheet.image, path)
        clean = clean_sheet(read_sheet(path).grey)
    layout = find_layout(clean.ink, {}, Projection.THIRD)
    return register_views(read_views(clean, layout), ReadingOptions()).views


def truth_of(sample: SamplePart, size: tuple[float, float, float]) -> TriangleMesh:
    """The sample's solid, scaled to the size of the views."""
    vertices, triangles = tessellate(moved_to_origin(sample.build()), 0.01)
    scale = max(size) / float(np.ptp(vertices, axis=0).max())
    return TriangleMesh(vertices * scale, triangles)


def _measure(
    surface: TriangleMesh, truth: TriangleMesh, size: tuple[float, float, float]
) -> Measure:
    unit = BOX / max(size)
    scaled = [TriangleMesh(mesh.vertices * unit, mesh.triangles) for mesh in (surface, truth)]
    streams = random_streams(0, 3)
    sides = [
        (SurfaceQueries(mesh), sample_surface(mesh, POINTS, stream))
        for mesh, stream in zip(scaled, streams, strict=False)
    ]
    iou = volume_iou(sides[0][0], sides[1][0], streams[2]).value
    return Measure(float("nan") if iou is None else iou, point_to_surface(*sides))


if __name__ == "__main__":
    main()
