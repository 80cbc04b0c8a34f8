"""What point density, octree depth and screening do to the Poisson surface.

Gaussians as they start on the hull of exact masks; the surface through their discs, uncut, against
that hull, so that only what Poisson adds is measured: ``p2s`` in a box whose longest edge is 5, and
seconds of processor time.

    .venv/bin/python benchmarks/poisson_settings.py [--samples NAME ...]
"""

import argparse
import time

import numpy as np
from disturbed_views import cases, solid_mesh, views_of
from surface import measure_mesh

from gaussiancad_core.hull import visual_hull
from gaussiancad_core.meshes import connected_pieces
from gaussiancad_core.modes import Preset, Recipe
from gaussiancad_core.samples import SAMPLES
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.surface.points import DiscSampling
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface

VARIANTS = {
    "depth 8, 6 points, weight 4": PoissonSettings(),
    "3 points": PoissonSettings(sampling=DiscSampling(per_disc=3)),
    "12 points": PoissonSettings(sampling=DiscSampling(per_disc=12)),
    "depth 7": PoissonSettings(depth=7),
    "depth 9": PoissonSettings(depth=9),
    "weight 1": PoissonSettings(point_weight=1.0),
    "weight 10": PoissonSettings(point_weight=10.0),
    "weight 30": PoissonSettings(point_weight=30.0),
}


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--samples", nargs="*", default=[part.name for part in SAMPLES])
    options = parser.parse_args()
    settings = training_settings(Recipe.ORTHOGRAPHIC, Preset.STANDARD)
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in VARIANTS}
    for part in SAMPLES:
        if part.name not in options.samples:
            continue
        views = views_of(solid_mesh(part.build()), cases()[0], seed=0)
        cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, views.roles, views.size)
        hull = visual_hull(views, cameras)
        pieces = len(connected_pieces(hull))
        start = gaussians_on(hull, Start(settings.count, thickness=settings.thickness))
        for name, variant in VARIANTS.items():
            began = time.process_time()
            surface = gaussian_surface(start, variant)
            seconds = time.process_time() - began
            distance = measure_mesh(surface, hull, views.size).p2s
            found[name].append((distance, seconds))
            own = len(connected_pieces(surface))
            print(
                f"{part.name:20}{name:30}{distance:9.5f}{seconds:7.1f} s{len(surface.triangles):9}"
                f" triangles, {own} of {pieces} pieces, watertight {surface.watertight}",
                flush=True,
            )
    for name, rows in found.items():
        median, worst = np.median(rows, axis=0), np.max(rows, axis=0)
        print(f"{name:30}p2s {median[0]:.5f} median, {worst[0]:.5f} worst; {median[1]:.1f} s")


if __name__ == "__main__":
    main()
