"""The protocol ``deepcad``: as generative CAD models are measured since DeepCAD (Wu et al., 2021).

Each model is moved and scaled so that its bounding box is centred at the origin and its longest
edge is 1.  8,192 points are drawn on each surface.  The distance is the mean of the squared nearest
distances, summed over both ways, times 1000.  Nothing is registered: a turned result is a wrong
one.  A set of pairs is told by mean and median of the valid ones and the share of the invalid ones.

DeepCAD's own script takes 2,000 points, does not scale the truth (which lies in a cube of edge 2)
and scales a result only where it leaves that cube; CAD-Recode (Rukhovich et al., 2024) and others
take the unit cube and 8,192 points, which is what is done here.
"""

from dataclasses import dataclass

import numpy as np

from gaussiancad_core.comparison.distances import VolumeIou, encloses_volume, volume_iou
from gaussiancad_core.comparison.model_files import Content, Model
from gaussiancad_core.comparison.normalise import moved_mesh, normalising_matrix
from gaussiancad_core.comparison.queries import Points, SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface

PROTOCOL = (
    "deepcad-1: unit cubes at the origin, 8192 seeded points, mean squared nearest distances "
    "summed both ways times 1000, no registration"
)

POINTS = 8192


@dataclass(frozen=True)
class DeepCadResult:
    """One pair under the protocol ``deepcad``.

    Attributes:
        chamfer_x1000: squared distances, unit cube, times 1000.
        floor_x1000: the same between two samples of the reference.
        volume_iou: of the models in their unit cubes.
        invalid: why the result does not count as a solid, or None.
        points: on each side.
        seed: of the samples.
    """

    chamfer_x1000: float
    floor_x1000: float
    volume_iou: VolumeIou
    invalid: str | None
    points: int
    seed: int


def measure_deepcad(result: Model, reference: Model, seed: int) -> DeepCadResult:
    """Measure one pair."""
    # Streams of its own, so that other protocols' options do not change these numbers.
    streams = random_streams(seed, 4)
    first, second = (_unit_queries(model) for model in (result, reference))
    sample = sample_surface(first.mesh, POINTS, streams[0])
    truth = sample_surface(second.mesh, POINTS, streams[1])
    again = sample_surface(second.mesh, POINTS, streams[2])
    return DeepCadResult(
        squared_chamfer(sample, truth) * 1000.0,
        squared_chamfer(truth, again) * 1000.0,
        volume_iou(first, second, streams[3]),
        invalidity(result),
        POINTS,
        seed,
    )


def squared_chamfer(first: Points, second: Points) -> float:
    """Mean squared nearest distances of two samples, summed over both ways."""
    from scipy.spatial import cKDTree

    forth, _ = cKDTree(second).query(first)
    back, _ = cKDTree(first).query(second)
    return float(np.square(forth).mean() + np.square(back).mean())


def invalidity(model: Model) -> str | None:
    """Why a model is no valid solid, or None.

    A B-Rep is valid if OpenCASCADE's check finds nothing, and a mesh if it is closed; both must
    enclose a volume.
    """
    if model.exact is not None and model.exact.content is Content.SURFACES:
        return "it holds surfaces and no solid"
    if model.exact is not None:
        return None if model.exact.valid else "OpenCASCADE's check refuses the solid"
    if not model.closed:
        return "the mesh is not closed"
    return None if encloses_volume(model.mesh) else "it encloses no volume"


def _unit_queries(model: Model) -> SurfaceQueries:
    return SurfaceQueries(moved_mesh(model.mesh, normalising_matrix(model.mesh, 1.0)))
