"""What a deviation shows: how much of the surface lies how far, and where it is worst."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.deviation import Deviation
from gaussiancad_core.comparison.queries import Points
from gaussiancad_core.model.meshes import TriangleMesh

BINS = 40
WORST = 10

_APART_SHARE = 0.08
"""Worst points lie apart by this share of the longest edge: one bump is told once."""

_NOTHING_SHARE = 1e-6


@dataclass(frozen=True)
class Histogram:
    """Share of the result's surface by its deviation.

    Attributes:
        edges_mm: ``BINS + 1`` values from one end of the colour scale to the other.
        shares: ``BINS`` shares of the area.
        below, above: shares beyond the ends.
    """

    edges_mm: tuple[float, ...]
    shares: tuple[float, ...]
    below: float
    above: float


@dataclass(frozen=True)
class WorstPoint:
    """A place where the models are far apart.

    Attributes:
        of: ``result`` where the result's surface leaves the reference, ``reference`` where the
            reference's surface is far from the result, as where something is missing.
        point_mm: (3,) in the reference's coordinates.
        deviation_mm: negative inside the other model.
    """

    of: str
    point_mm: tuple[float, float, float]
    deviation_mm: float


def histogram_of(deviation: Deviation) -> Histogram:
    """Weigh the deviation of every vertex by the area around it."""
    weights = _vertex_areas(deviation.mesh)
    total = float(weights.sum())
    low = -deviation.limit if deviation.signed else 0.0
    edges = np.linspace(low, deviation.limit, BINS + 1)
    counts, _ = np.histogram(deviation.distances, edges, weights=weights)
    below = float(weights[deviation.distances < low].sum())
    above = float(weights[deviation.distances > deviation.limit].sum())
    return Histogram(
        tuple(float(edge) for edge in edges),
        tuple(float(count) / total for count in counts),
        below / total,
        above / total,
    )


def worst_points(
    points: Points, distances: npt.NDArray[np.float64], of: str, longest: float
) -> tuple[WorstPoint, ...]:
    """The farthest of (n, 3) points that lie apart from each other, the worst first.

    Args:
        points: in the reference's coordinates, mm.
        distances: (n,) signed, mm.
        of: whose points they are.
        longest: edge of the reference, mm.
    """
    left = np.abs(distances)
    found: list[WorstPoint] = []
    while len(found) < WORST:
        index = int(left.argmax())
        if left[index] <= _NOTHING_SHARE * longest:
            break
        place = points[index]
        x, y, z = (float(value) for value in place)
        found.append(WorstPoint(of, (x, y, z), float(distances[index])))
        near = np.square(points - place).sum(axis=1) < (_APART_SHARE * longest) ** 2
        left = np.where(near, 0.0, left)
    return tuple(found)


def _vertex_areas(mesh: TriangleMesh) -> npt.NDArray[np.float64]:
    """(n,) a third of the area of the triangles around each vertex."""
    thirds = np.repeat(mesh.areas / 3.0, 3)
    sums = np.bincount(mesh.triangles.ravel(), weights=thirds, minlength=len(mesh.vertices))
    return np.asarray(sums, dtype=np.float64)
