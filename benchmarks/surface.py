"""Surface against truth: the hull, the hull carved by the exact solid's depths, and the Poisson
surface on the latter before and after splatting, side by side: the surface that a run weighs
against the carved hull.

Each part is drawn, read and reconstructed as ``gaussiancad reconstruct`` does it, and measured
against its own solid in place, without registration.  Lengths are in units of a box whose longest
edge is 5.  ``p2s`` is the mean distance between points of either surface and the other surface, the
mean of both ways.  ``CD`` is the Chamfer distance as ``gaussiancad compare`` measures it, but
without registration: each in a box of its own, so that one ridge that stands out shifts and shrinks
all; ``floor`` is that of two samples of the truth.  ``carved`` is the status of the solid whose
depths carved the hull.

    .venv/bin/python benchmarks/surface.py [--preset standard] [--samples NAME ...]
    .venv/bin/python benchmarks/surface.py --classed N [--hulls]
"""

import argparse
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import astuple, dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from OCP.TopoDS import TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.comparison.distances import point_to_surface, volume_iou
from gaussiancad_core.comparison.normalise import moved_mesh, normalising_matrix
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.evidence.projected_reading import Reading
from gaussiancad_core.hull.space_carving import carved_hull
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.kernel.brep import moved_to_origin, tessellate
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.modes import Preset, Recipe
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.samples import SAMPLES
from gaussiancad_core.samples.classed import PartClass, classed_part
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.colouring import coloured
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, read_views, register_views
from gaussiancad_core.sheet.views.role_score import Drawings, arrange
from gaussiancad_core.sheet.views.sheet_layout import view_clusters
from gaussiancad_core.splatting.gaussian_training import train
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.splatting.targets import mean_colour, targets_of
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface

POINTS = 10_000
BOX = 5.0
LEVELS = 4


@dataclass(frozen=True)
class Measure:
    """A surface against the truth.

    Attributes:
        iou: of the volumes.
        p2s: point-to-surface distance, in place.
        chamfer: distance of samples, each surface in a box of its own.
    """

    iou: float
    p2s: float
    chamfer: float


@dataclass(frozen=True)
class Part:
    """What is measured.

    Attributes:
        name: of the row.
        build: makes the solid, mm.
    """

    name: str
    build: Callable[[], TopoDS_Shape]


COLUMNS = ("hull", "carved hull", "Poisson before", "after splatting")


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--preset", type=Preset, default=Preset.STANDARD)
    parser.add_argument("--samples", nargs="*", default=[])
    parser.add_argument("--classed", type=int, help="parts of each class instead of the samples")
    parser.add_argument("--hulls", action="store_true", help="leave the Gaussians out")
    options = parser.parse_args()
    parts = list(_classed(options.classed) if options.classed else _samples(options.samples))
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
    _print_row("median", np.median(table, axis=0).tolist())
    worst = table.max(axis=0)
    worst[:-1:3] = table[:, :-1:3].min(axis=0)
    _print_row("worst", worst.tolist())
    for column, name in enumerate(names):
        losses = table[:, 3 * column + 1] - table[:, 1]
        above = table[:, 3 * column + 2] - table[:, -1]
        print(
            f"{name}: p2s at most {losses.max():+.4f} against the hull's; "
            f"CD above the floor {np.median(above):+.4f}, at most {above.max():+.4f}"
        )


def _print_row(name: str, row: list[float], source: str = "") -> None:
    cells = "".join(
        f"{iou:9.4f}{p2s:8.4f}{chamfer:8.4f}"
        for iou, p2s, chamfer in zip(row[:-1:3], row[1:-1:3], row[2:-1:3], strict=True)
    )
    print(f"{name:20}{cells}{row[-1]:8.4f}  {source}", flush=True)


def _samples(names: list[str]) -> Iterator[Part]:
    for part in SAMPLES:
        if not names or part.name in names:
            yield Part(part.name, part.build)


def _classed(count: int) -> Iterator[Part]:
    """Parts of 8 to 48 faces."""
    for kind in PartClass:
        for seed in range(count):
            yield Part(f"{kind.value}-{seed}", partial(classed_part, kind, seed, seed % LEVELS))


def measures(part: Part, preset: Preset | None) -> tuple[list[Measure], float, str]:
    """The hull, the carved one, and the surface of the Gaussians before and after training.

    Without a preset the hulls alone; beside them the floor of the Chamfer distance, and what carved
    the hull.
    """
    registered = registered_of(part)
    views = registered.views
    settings = training_settings(Recipe.ORTHOGRAPHIC, preset or Preset.STANDARD)
    cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
    exact = find_exact(Reading(registered, Projection.THIRD), None)
    carved = carved_hull(views, cameras, exact.result)
    surfaces = [visual_hull(views, cameras), carved.mesh]
    if preset is not None:
        start = gaussians_on(
            carved.mesh,
            Start(
                count=settings.count,
                thickness=settings.thickness,
                opacity=settings.opacity,
                colour=mean_colour(views),
            ),
        )
        trained = train(start, cameras, targets_of(views, cameras), settings, lambda *_: None)
        surfaces += [gaussian_surface(own, PoissonSettings()) for own in (start, trained.gaussians)]
    truth = truth_of(part, views.size)
    source = carved.source.value if carved.source else carved.refused or "-"
    found = [measure_mesh(surface, truth, views.size) for surface in surfaces]
    return found, chamfer_floor(truth), source


def registered_of(part: Part) -> RegisteredSheet:
    """The part's clean sheet, drawn and read."""
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    sheet = draw_sheet(part.build(), roles, Projection.THIRD, parse_style("clean"))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sheet.png"
        write_image(sheet.image, path)
        clean = clean_sheet(read_sheet(path).grey)
    layout = arrange(Drawings(view_clusters(clean.ink, 0.0), clean.ink), {}, Projection.THIRD)
    found = register_views(read_views(clean, layout), ReadingOptions())
    return replace(found, views=coloured(found.views, ReadingOptions().colour))


def truth_of(part: Part, size: tuple[float, float, float]) -> TriangleMesh:
    """The part's solid, scaled to the size of the views."""
    vertices, triangles = tessellate(moved_to_origin(part.build()), 0.01)
    scale = max(size) / float(np.ptp(vertices, axis=0).max())
    return TriangleMesh(vertices * scale, triangles)


def measure_mesh(
    surface: TriangleMesh, truth: TriangleMesh, size: tuple[float, float, float]
) -> Measure:
    """A surface against the truth, both in mm; ``size`` is the part's extent in mm."""
    unit = BOX / max(size)
    scaled = [TriangleMesh(mesh.vertices * unit, mesh.triangles) for mesh in (surface, truth)]
    streams = random_streams(0, 3)
    sides = [
        (SurfaceQueries(mesh), sample_surface(mesh, POINTS, stream))
        for mesh, stream in zip(scaled, streams, strict=False)
    ]
    iou = volume_iou(sides[0][0], sides[1][0], streams[2]).value
    p2s = point_to_surface(*sides)
    return Measure(float("nan") if iou is None else iou, p2s, chamfer(surface, truth))


def chamfer(surface: TriangleMesh, truth: TriangleMesh) -> float:
    """Chamfer distance of two meshes, each in a box of its own."""
    own, first, _ = _samples_in_box(surface, truth)
    return _chamfer(own, first)


def chamfer_floor(truth: TriangleMesh) -> float:
    """Chamfer distance of two samples of one mesh in its box."""
    _, first, second = _samples_in_box(truth, truth)
    return _chamfer(first, second)


def _samples_in_box(surface: TriangleMesh, truth: TriangleMesh) -> list[np.ndarray]:
    """Three samples (n, 3): one of a surface, two of the truth."""
    boxed = [moved_mesh(mesh, normalising_matrix(mesh, BOX)) for mesh in (surface, truth, truth)]
    return [
        sample_surface(mesh, POINTS, stream)
        for mesh, stream in zip(boxed, random_streams(0, 3), strict=True)
    ]


def _chamfer(first: np.ndarray, second: np.ndarray) -> float:
    there, back = cKDTree(second).query(first)[0], cKDTree(first).query(second)[0]
    return float(there.mean() + back.mean())


if __name__ == "__main__":
    main()
