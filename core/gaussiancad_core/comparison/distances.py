"""How far two registered models are apart: CD, HD, EMD, point to surface, volume IoU.

All lengths are in units of the 5-unit box.  CD is the sum of the two mean nearest distances, not
squared; HD the larger of the two largest; EMD the mean distance under the best assignment of points
to points.  These three compare point samples and are not zero for equal models:
:class:`SampleDistances` of two samplings of the reference is their floor.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.closed_bodies import manifold_of
from gaussiancad_core.comparison.queries import Points, SurfaceQueries
from gaussiancad_core.comparison.sampling import RandomState
from gaussiancad_core.model.meshes import TriangleMesh

EMD_POINTS = 2048
"""Most points a side for the EMD: the best assignment takes the third power of their number."""

OCCUPANCY_POINTS = 200_000
"""Points in the common box where the IoU is estimated."""


@dataclass(frozen=True)
class SampleDistances:
    """Distances between two point samples, in units.

    Attributes:
        chamfer: sum of the two mean nearest distances.
        hausdorff: larger of the two largest nearest distances.
        emd: mean distance of matched points, on the first ``emd_points`` of each sample.
        emd_points: how many points a side were matched.
    """

    chamfer: float
    hausdorff: float
    emd: float
    emd_points: int


class IouMethod(Enum):
    """How the volume IoU was found."""

    BOOLEAN = "boolean"
    OCCUPANCY = "occupancy"
    NONE = "none"


@dataclass(frozen=True)
class VolumeIou:
    """Volume of the intersection over volume of the union.

    Attributes:
        value: 0 to 1, or None where neither model encloses a volume.
        method: exact Boolean of both meshes, seeded points in their common box, or none.
    """

    value: float | None
    method: IouMethod


def sample_distances(first: Points, second: Points) -> SampleDistances:
    """Compare two samples of points, (n, 3) and (m, 3)."""
    from scipy.spatial import cKDTree

    forth, _ = cKDTree(second).query(first)
    back, _ = cKDTree(first).query(second)
    matched = min(EMD_POINTS, len(first), len(second))
    return SampleDistances(
        chamfer=float(forth.mean() + back.mean()),
        hausdorff=float(max(forth.max(), back.max())),
        emd=earth_movers_distance(first[:matched], second[:matched]),
        emd_points=matched,
    )


def earth_movers_distance(first: Points, second: Points) -> float:
    """Mean distance of matched points, two samples of equal size, (n, 3) each.

    It is exact: between samples of equal size whose points weigh the same, the best transport is
    the best assignment of points to points.
    """
    from scipy.optimize import linear_sum_assignment
    from scipy.spatial.distance import cdist

    costs = cdist(first, second)
    return float(costs[linear_sum_assignment(costs)].mean())


def point_to_surface(
    result: tuple[SurfaceQueries, Points], reference: tuple[SurfaceQueries, Points]
) -> float:
    """Mean distance of each side's (n, 3) points to the other's exact surface, both ways averaged.

    Zero for equal surfaces: this measure has no floor.
    """
    there = reference[0].nearest(result[1]).distances.mean()
    back = result[0].nearest(reference[1]).distances.mean()
    return float(there + back) / 2.0


def volume_iou(result: SurfaceQueries, reference: SurfaceQueries, random: RandomState) -> VolumeIou:
    """Compare the enclosed volumes, exactly where both meshes are manifold, else by points."""
    exact = _boolean_iou(result.mesh, reference.mesh)
    if exact is not None:
        return VolumeIou(exact, IouMethod.BOOLEAN)
    low = np.minimum(result.mesh.bounds[0], reference.mesh.bounds[0])
    high = np.maximum(result.mesh.bounds[1], reference.mesh.bounds[1])
    if not (high > low).all():
        return VolumeIou(None, IouMethod.NONE)
    points = random.uniform(low, high, (OCCUPANCY_POINTS, 3))
    in_result, in_reference = _occupied(result, points), _occupied(reference, points)
    union = int((in_result | in_reference).sum())
    if not union:
        return VolumeIou(None, IouMethod.NONE)
    return VolumeIou(int((in_result & in_reference).sum()) / union, IouMethod.OCCUPANCY)


def encloses_volume(mesh: TriangleMesh) -> bool:
    """Whether a closed mesh has a volume that is more than rounding."""
    longest = float(np.ptp(mesh.bounds, axis=0).max())
    return abs(mesh.volume) > 1e-9 * longest**3


def _occupied(surface: SurfaceQueries, points: Points) -> npt.NDArray[np.bool_]:
    if surface.closed and not encloses_volume(surface.mesh):
        # Rays meet the two sides of something flat at once, and may count one.
        return np.zeros(len(points), dtype=bool)
    return surface.inside(points)


def _boolean_iou(first: TriangleMesh, second: TriangleMesh) -> float | None:
    import manifold3d

    one, other = (manifold_of(mesh) for mesh in (first, second))
    if one is None or other is None:
        return None
    both = one ^ other
    if both.status() != manifold3d.Error.NoError:
        return None
    common = both.volume()
    # What is united follows, and a second Boolean of large meshes takes long.
    united = one.volume() + other.volume() - common
    return float(np.clip(common / united, 0.0, 1.0))
