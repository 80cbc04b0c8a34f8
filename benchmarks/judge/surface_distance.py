"""How near a surface is to the truth: overlap, and distance in place."""

from dataclasses import dataclass

from gaussiancad_core.comparison.distances import point_to_surface, volume_iou
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.model.meshes import TriangleMesh

POINTS = 10_000
"""Surface points a side, as the GaussianCAD paper samples them."""

BOX = 5.0
"""Longest edge of the box in which distances are told, as in the GaussianCAD paper."""


@dataclass(frozen=True)
class Measure:
    """A surface against the truth.

    Attributes:
        iou: of the volumes.
        p2s: point-to-surface distance, in place.
    """

    iou: float
    p2s: float


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
    return Measure(float("nan") if iou is None else iou, p2s)
