"""What do point density, depth, screening and sharp edges do to the Poisson surface?

Gaussians as they start on a hull of exact masks that is carved by the true solid, so that neither
reading nor splatting plays a part; the surface through their discs, uncut.  Measured are

* ``CD``: Chamfer distance from the true solid as ``gaussiancad compare`` measures it, but without
  registration: each in a box whose longest edge is 5, 10,000 points, less the distance of two
  samples of the truth;
* ``p2s``: mean distance from the hull in that box, both ways: what Poisson adds;
* seconds of processor time.

Parts are all samples and parts made by class, which no setting was chosen by.
"""

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.surface_distance import chamfer, chamfer_floor, measure_mesh
from benchmarks.parts.named_parts import Part, named_classed, named_samples
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.disturbed_views import cases, solid_mesh, views_of
from gaussiancad_core.hull.depth_maps import CastSolid, depth_map_of
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.kernel.brep import moved_to_origin
from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.samples import SAMPLES
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.surface.discs import DiscSampling
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_protocol.modes import Preset, Recipe

MINUTES = 30

DEFAULT = PoissonSettings()

VARIANTS = {
    "default": DEFAULT,
    "round": replace(DEFAULT, sharpening=None),
    "uneven": replace(DEFAULT, flattening=None),
    "points-3": replace(DEFAULT, sampling=DiscSampling(per_disc=3)),
    "points-12": replace(DEFAULT, sampling=DiscSampling(per_disc=12)),
    "depth-7": replace(DEFAULT, depth=7),
    "depth-9": replace(DEFAULT, depth=9),
    "weight-1": replace(DEFAULT, point_weight=1.0),
    "weight-10": replace(DEFAULT, point_weight=10.0),
    "weight-30": replace(DEFAULT, point_weight=30.0),
}

SEED = 301
"""Of the first part of each class: none that a setting was chosen by."""


@dataclass(frozen=True)
class Row:
    """One surface.

    Attributes:
        chamfer: above the floor of the truth.
        p2s: from the hull.
        seconds: of the processor.
        triangles: of the surface.
        closed: whether it is watertight and has as many pieces as the hull.
    """

    chamfer: float
    p2s: float
    seconds: float
    triangles: int
    closed: bool


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--samples", nargs="*", default=[part.name for part in SAMPLES])
    parser.add_argument("--classed", type=int, default=0, help="parts of each class beside them")
    parser.add_argument("--variants", nargs="*", choices=VARIANTS, default=list(VARIANTS))


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    found: dict[str, list[Row]] = {name: [] for name in ("hull", *options.variants)}
    print(f"{'part':20}{'':12}{'CD':>9}{'p2s':>9}{'s':>7}{'triangles':>11}")
    for part in (*named_samples(options.samples), *named_classed(options.classed, SEED)):
        for name, row in measured(part, options.variants):
            found[name].append(row)
            print(_line(part.name, name, row), flush=True)
    figures = []
    for name, rows in found.items():
        values = np.array([(row.chamfer, row.p2s, row.seconds, row.triangles) for row in rows])
        whole = sum(row.closed for row in rows)
        medians = np.median(values, axis=0)
        for kind, one in (("median", medians), ("worst", values.max(axis=0))):
            print(_line(kind, name, Row(*one[:3], int(one[3]), whole == len(rows))))
        print(f"{'':20}{name:12}{whole} of {len(rows)} watertight with the hull's pieces")
        figures.append(Figure(f"{name}, median Chamfer distance above its floor", medians[0]))
    return Outcome(tuple(figures))


def _line(part: str, name: str, row: Row) -> str:
    stated = "" if row.closed else "  not whole"
    return (
        f"{part:20}{name:12}{row.chamfer:+9.4f}{row.p2s:9.5f}{row.seconds:7.1f}"
        f"{row.triangles:11}{stated}"
    )


def measured(part: Part, variants: list[str]) -> Iterator[tuple[str, Row]]:
    """The hull of a part, and the surfaces on it."""
    shape = moved_to_origin(part.build())
    truth = solid_mesh(shape)
    views = views_of(truth, cases()[0], seed=0)
    settings = training_settings(Recipe.ORTHOGRAPHIC, Preset.STANDARD)
    hull = true_hull(shape, views)
    pieces = len(connected_pieces(hull))
    start = gaussians_on(hull, Start(settings.count, thickness=settings.thickness))
    yield "hull", Row(chamfer_above_floor(hull, truth), 0.0, 0.0, len(hull.triangles), True)
    for name in variants:
        began = time.process_time()
        surface = gaussian_surface(start, VARIANTS[name])
        seconds = time.process_time() - began
        whole = surface.watertight and len(connected_pieces(surface)) == pieces
        yield (
            name,
            Row(
                chamfer_above_floor(surface, truth),
                measure_mesh(surface, hull, views.size).p2s,
                seconds,
                len(surface.triangles),
                whole,
            ),
        )


def true_hull(shape: TopoDS_Shape, views: ViewSet) -> TriangleMesh:
    """The hull of the views, carved by the true solid's depths from all their sides."""
    settings = training_settings(Recipe.ORTHOGRAPHIC, Preset.STANDARD)
    cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
    solid = [CastSolid(shape, views.size)]
    depth_maps = [
        depth_map_of(solid, view, behind) for view in views.views for behind in (False, True)
    ]
    return visual_hull(views, cameras, tuple(depth_maps))


def chamfer_above_floor(surface: TriangleMesh, truth: TriangleMesh) -> float:
    """Chamfer distance, each mesh in its own box, less that of two samples of the truth."""
    return chamfer(surface, truth) - chamfer_floor(truth)
