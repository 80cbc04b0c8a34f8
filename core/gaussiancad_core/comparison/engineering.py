"""The protocol ``engineering``: millimetres, signs, tolerances, volumes, areas and topology.

Nothing is scaled unless asked for.  The result is laid over the reference (by default by ICP in
its own size), and points are drawn on both surfaces, uniform by area.  A distance is that to the
other's exact triangles; its sign is negative where a point lies inside the other model and positive
where it lies outside.  The extremes also regard every vertex.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.distances import VolumeIou, volume_iou
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.comparison.normalise import Matrix, moved_mesh
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.rigid_registration import surface_normals
from gaussiancad_core.comparison.sampling import RandomState, sample_triangles

PROTOCOL = (
    "engineering-1: millimetres, seeded points uniform by area against the other's exact "
    "triangles, negative inside the other model"
)

PERCENTILES = (50, 90, 95, 99)

NORMAL_ANGLE = 20.0
"""Degrees by which normals may differ where surfaces agree."""

_TOLERANCE_SHARE = 1e-3
_TOUCHING = 1e-9
"""Share of the longest edge below which a point has no side."""


@dataclass(frozen=True)
class DistanceStatistics:
    """Distances of one model's surface from the other, mm.

    Attributes:
        signed: whether the other model is closed, so that distances have a sign.
        mean: signed mean (unsigned where there is no sign).
        mean_absolute, rms: of the sizes.
        least, greatest: extremes, points and vertices; the largest way in and out.
        percentiles: of the sizes, by per cent.
        within: share of the surface within the tolerance, its normal within 20 degrees.
    """

    signed: bool
    mean: float
    mean_absolute: float
    rms: float
    least: float
    greatest: float
    percentiles: dict[int, float]
    within: float


@dataclass(frozen=True, eq=False)
class EngineeringResult:
    """One pair under the protocol ``engineering``.

    Attributes:
        result_to_reference: how far the result's surface leaves the reference.
        reference_to_result: how far the reference's surface is from the result: what is missing.
        agreement: the smaller share within the tolerance of both ways.
        tolerance_mm: of that share.
        floor_mm: what the triangles of curved surfaces alone may be off, both files together.
        volume_mm3, area_mm2: differences, result minus reference; the volume is None where a model
            is not closed.
        volume_share, area_share: the same over the reference's.
        volume_iou: as placed.
        placed_bounds_mm: (2, 3) of the result as placed.
        matrix: (4, 4) result file -> reference file, mm.
        points: a side.
        seed: of the samples.
    """

    result_to_reference: DistanceStatistics
    reference_to_result: DistanceStatistics
    agreement: float
    tolerance_mm: float
    floor_mm: float
    volume_mm3: float | None
    volume_share: float | None
    area_mm2: float
    area_share: float
    volume_iou: VolumeIou
    placed_bounds_mm: npt.NDArray[np.float64]
    matrix: Matrix
    points: int
    seed: int


@dataclass(frozen=True)
class EngineeringAsk:
    """How much is drawn, and what counts as the same.

    Attributes:
        points: a side.
        seed: told in the result.
        tolerance_mm: None takes 1/1000 of the reference's longest edge.
    """

    points: int
    seed: int
    tolerance_mm: float | None = None


def measure_engineering(
    pair: tuple[Model, Model],
    placement: tuple[Matrix, Matrix],
    ask: EngineeringAsk,
    streams: list[RandomState],
) -> EngineeringResult:
    """Measure a placed pair.

    Args:
        pair: result and reference, in their files' mm.
        placement: result file -> units, and reference file -> units: both near the origin, with
            the same scale unless the result is scaled on purpose.
        ask: points and tolerance.
        streams: three, for both samples and the IoU.
    """
    result, reference = pair
    first = SurfaceQueries(moved_mesh(result.mesh, placement[0]))
    second = SurfaceQueries(moved_mesh(reference.mesh, placement[1]))
    back = np.linalg.inv(placement[1])
    matrix = back @ placement[0]
    unit = float(np.linalg.norm(back[:3, 0]))
    longest = float(np.ptp(reference.mesh.bounds, axis=0).max())
    tolerance = ask.tolerance_mm or longest * _TOLERANCE_SHARE
    forth = _statistics((first, second), ask.points, (unit, tolerance), streams[0])
    home = _statistics((second, first), ask.points, (unit, tolerance), streams[1])
    scale = float(np.linalg.norm(matrix[:3, 0]))
    own_volume, own_area = _measures(result, scale)
    true_volume, true_area = _measures(reference, 1.0)
    volume = share = None
    if own_volume is not None and true_volume is not None:
        volume = own_volume - true_volume
        share = volume / true_volume if true_volume else None
    return EngineeringResult(
        forth,
        home,
        min(forth.within, home.within),
        tolerance,
        sum(
            model.exact.deflection_mm * factor
            for model, factor in ((result, scale), (reference, 1.0))
            if model.exact is not None
        ),
        volume,
        share,
        own_area - true_area,
        (own_area - true_area) / true_area,
        volume_iou(first, second, streams[2]),
        moved_mesh(result.mesh, matrix).bounds,
        matrix,
        ask.points,
        ask.seed,
    )


def signed_distances(
    surface: SurfaceQueries, points: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """(n,) distances of (n, 3) points; negative inside a closed surface, in its own unit."""
    return _with_signs(surface, points, surface.nearest(points).distances)


def volume_of(model: Model) -> float | None:
    """mm3, of the exact surfaces where there are; None where the model is not closed."""
    if model.exact is not None:
        return model.exact.volume_mm3 if model.exact.closed else None
    return model.mesh.volume if model.closed else None


def area_of(model: Model) -> float:
    """mm2, of the exact surfaces where there are."""
    return model.exact.area_mm2 if model.exact is not None else model.mesh.area


def _measures(model: Model, scale: float) -> tuple[float | None, float]:
    volume = volume_of(model)
    return None if volume is None else volume * scale**3, area_of(model) * scale**2


def _statistics(
    surfaces: tuple[SurfaceQueries, SurfaceQueries],
    points: int,
    unit_and_tolerance: tuple[float, float],
    random: RandomState,
) -> DistanceStatistics:
    """Of points on the first surface, from the second."""
    queries, other = surfaces
    unit, tolerance = unit_and_tolerance
    sample = sample_triangles(queries.mesh, points, random)
    nearest = other.nearest(sample.points)
    sizes = nearest.distances * unit
    signed = other.closed
    distances = _with_signs(other, sample.points, nearest.distances) * unit
    corners = signed_distances(other, queries.mesh.vertices) * unit
    normals = surface_normals(queries, sample.triangles) * surface_normals(other, nearest.triangles)
    cosines = normals.sum(axis=1)
    if not (queries.closed and other.closed):
        # What is open has no outside: which way its triangles face says nothing.
        cosines = np.abs(cosines)
    along = cosines >= np.cos(np.radians(NORMAL_ANGLE))
    return DistanceStatistics(
        signed,
        float(distances.mean()),
        float(sizes.mean()),
        float(np.sqrt(np.square(sizes).mean())),
        float(min(distances.min(), corners.min())),
        float(max(distances.max(), corners.max())),
        {share: float(np.percentile(sizes, share)) for share in PERCENTILES},
        float(((sizes <= tolerance) & along).mean()),
    )


def _with_signs(
    surface: SurfaceQueries,
    points: npt.NDArray[np.float64],
    distances: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    if not surface.closed:
        return distances
    # What touches the surface has no side.
    longest = float(np.ptp(surface.mesh.bounds, axis=0).max())
    inner = surface.inside(points) & (distances > _TOUCHING * longest)
    return np.where(inner, -distances, distances)
