"""What does the distance of the cameras cost the GaussianCAD paper's recipe?

With the images and K as they are, a camera that is said to stand farther away only makes the model
larger: ``size`` is the longest edge of the result in the paper's units, ``shape`` its distance from
the truth once both are brought to a box of 5.  With a longer lens at each distance instead, so that
the part keeps its size, the rays become parallel: ``lens`` is that distance for the same part.
``parallel`` is the same training with orthographic cameras.
"""

import argparse
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from benchmarks.judge.surface_distance import measure_mesh
from benchmarks.methods.trained import started_on, trained_from
from benchmarks.run.charts import Chart, Series, write_chart
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.disturbed_views import cases, solid_mesh, views_of
from gaussiancad_core.hull.visual_hull import visual_hull
from gaussiancad_core.model.cameras import PAPER_DISTANCE, Camera, orthographic_camera
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.samples import sample
from gaussiancad_core.splatting.settings import (
    TrainingSettings,
    training_cameras,
    training_settings,
)
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_protocol.modes import Preset, Recipe

MINUTES = 15

DISTANCES = (3.0, 4.0, 5.0, 7.0, 10.0, 20.0)


@dataclass(frozen=True, eq=False)
class Scene:
    """A part, its undisturbed views, and how it is trained."""

    truth: TriangleMesh
    views: ViewSet
    settings: TrainingSettings


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--sample", default="three-axis-block")
    parser.add_argument("--distances", type=float, nargs="+", default=DISTANCES)
    parser.add_argument("--iterations", type=int, default=300)
    parser.add_argument("--chart", type=Path)


def run(options: argparse.Namespace) -> Outcome:
    """Print the table, and draw it."""
    scene = scene_of(options.sample, options.iterations)
    straight = parallel_error(scene)
    print(f"{'distance':>9}{'size':>9}{'shape':>9}{'lens':>9}{'parallel':>9}")
    rows = []
    for distance in options.distances:
        rows.append((*errors_at(scene, distance), straight))
        print(f"{distance:9.1f}" + "".join(f"{value:9.4f}" for value in rows[-1]), flush=True)
    if options.chart:
        names = ("size in units / 100", "shape", "lens", "parallel")
        columns = np.array(rows).T
        columns[0] /= 100.0
        lines = [Series(name, list(values)) for name, values in zip(names, columns, strict=True)]
        ticks = [f"{distance:g}" for distance in options.distances]
        write_chart(
            Chart("distance from the truth by camera distance", ticks, lines), options.chart
        )
    shapes = (
        Figure(f"distance from the truth at {distance:g}", row[1], "units of a box of 5")
        for distance, row in zip(options.distances, rows, strict=True)
    )
    return Outcome((*shapes, Figure("with parallel rays", straight, "units of a box of 5")))


def scene_of(name: str, iterations: int) -> Scene:
    """A sample part and the paper's recipe for it, scaled down as the preset ``draft`` is."""
    truth = solid_mesh(sample(name).build())
    views = views_of(truth, cases()[0], seed=0)
    settings = training_settings(Recipe.PAPER, Preset.DRAFT)
    settings = replace(settings, iterations=iterations)
    return Scene(truth, views, settings)


def parallel_error(scene: Scene) -> float:
    """Distance from the truth of the same training with orthographic cameras."""
    views = scene.views
    parallel = tuple(
        orthographic_camera(role, views.size, scene.settings.pixels) for role in views.roles
    )
    return reconstructed(views, parallel, scene.settings, scene.truth)[1]


def errors_at(scene: Scene, distance: float) -> tuple[float, float, float]:
    """``size``, ``shape`` and ``lens`` of cameras at a distance in the paper's units."""
    views, settings, truth = scene.views, scene.settings, scene.truth
    this_training_cameras = training_cameras(Recipe.PAPER, settings, views.roles, views.size)
    unit = this_training_cameras[0].reference_depth / PAPER_DISTANCE
    factor = distance / PAPER_DISTANCE
    larger = scaled(views, factor)
    said = tuple(
        moved(camera, distance, unit, 1.0)
        for camera in relocated(this_training_cameras, views, factor)
    )
    size, shape = reconstructed(larger, said, settings, truth)
    lens = tuple(moved(camera, distance, unit, factor) for camera in this_training_cameras)
    _, error = reconstructed(views, lens, settings, truth)
    return size / unit, shape, error


def scaled(views: ViewSet, factor: float) -> ViewSet:
    """The same images of a part that is ``factor`` times as large."""
    return ViewSet(
        tuple(
            replace(
                view,
                origin=(view.origin[0] * factor, view.origin[1] * factor),
                mm_per_pixel=view.mm_per_pixel * factor,
            )
            for view in views.views
        ),
        tuple(extent * factor for extent in views.size),
    )


def relocated(cameras: tuple[Camera, ...], views: ViewSet, factor: float) -> tuple[Camera, ...]:
    """Cameras that look at the middle of the part that is ``factor`` times as large."""
    middle = np.array(views.size) / 2.0
    return tuple(
        replace(
            camera,
            translation=camera.translation - camera.rotation @ ((factor - 1.0) * middle),
        )
        for camera in cameras
    )


def moved(camera: Camera, distance: float, unit: float, zoom: float) -> Camera:
    """A camera at another distance, in the paper's units, with another focal length."""
    translation = camera.translation.copy()
    translation[2] += distance * unit - camera.reference_depth
    return replace(
        camera,
        translation=translation,
        reference_depth=distance * unit,
        fx=camera.fx * zoom,
        fy=camera.fy * zoom,
    )


def reconstructed(
    views: ViewSet, cameras: tuple[Camera, ...], settings: TrainingSettings, truth: TriangleMesh
) -> tuple[float, float]:
    """Longest edge of the surface in mm, and its distance from the truth in a box of 5."""
    start = started_on(visual_hull(views, cameras), views, settings)
    trained = trained_from(start, views, cameras, settings)
    surface = gaussian_surface(trained.gaussians, PoissonSettings())
    factor = float(np.max(truth.bounds[1])) / max(views.size)
    triangle_mesh = TriangleMesh(surface.vertices * factor, surface.triangles)
    longest = float(np.ptp(surface.bounds, axis=0).max())
    size = tuple(float(extent) for extent in truth.bounds[1])
    return longest, measure_mesh(triangle_mesh, truth, size).p2s
