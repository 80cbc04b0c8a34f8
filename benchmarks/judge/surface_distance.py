"""How near a surface is to the truth: overlap, distance in place, Chamfer distance."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.comparison.distances import point_to_surface, volume_iou
from gaussiancad_core.comparison.normalise import moved_mesh, normalising_matrix
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
        chamfer: distance of samples, each surface in a box of its own.
    """

    iou: float
    p2s: float
    chamfer: float


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
    item, first, _ = _samples_in_box(surface, truth)
    return _chamfer(item, first)


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
