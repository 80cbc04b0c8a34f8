"""Which turn, out of all, lays the result over the reference (``--register global``).

Both models are centred at the middle of their surface and scaled to the same mean square radius,
which a turn does not change.  Thousands of rotations, spread evenly (super-Fibonacci spirals;
Alexa 2022), are tried against distance fields on a grid; the best that differ are refined by ICP,
first roughly, then fully, and the nearest is taken.  Looking everywhere costs two seconds and,
unlike matching of features, does not hang on a lucky draw.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.normalise import moved_mesh, scale_of
from gaussiancad_core.comparison.queries import Points, SurfaceQueries
from gaussiancad_core.comparison.rigid_registration import (
    Fit,
    Side,
    fit_under,
    is_clearly_nearer,
    refine,
)
from gaussiancad_core.comparison.sampling import RandomState, sample_surface
from gaussiancad_core.model.meshes import TriangleMesh

_RADIUS = 2.0
"""Root mean square distance of the surface from its middle, while turns are looked for."""

_ROTATIONS = 6000
"""So many lie about 13 degrees from their neighbours."""

_GRID = 48
_FIELD_POINTS = 300
_ROUGH_POINTS = 400
_FINE_POINTS = 2000
_CANDIDATES = 24
_FINALISTS = 4
_APART = np.radians(15.0)
_ROUGH_ROUNDS = 14

_TIE_UNITS = 1e-4
_TIE_SHARE = 0.05

_FIBONACCI_PSI = 1.533751168755204288118041


@dataclass(frozen=True, eq=False)
class Turn:
    """The turn found.

    Attributes:
        rotation: (3, 3) proper.
        mirrored: whether some turn of the result's mirror image fits clearly better.
        distance: mean distance to the exact surface, in units of half the radius of the part.
    """

    rotation: npt.NDArray[np.float64]
    mirrored: bool
    distance: float


class _DistanceField:
    """Distances from a surface on a grid around the origin."""

    def __init__(self, surface: SurfaceQueries) -> None:
        self._reach = 1.05 * float(np.linalg.norm(surface.mesh.vertices, axis=1).max())
        axis = np.linspace(-self._reach, self._reach, _GRID)
        grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
        self._values = surface.distances(grid.reshape(-1, 3)).astype(np.float32)

    def mean(self, points: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
        """(r,) mean distance of (r, n, 3) points; those outside count as on the border."""
        step = 2.0 * self._reach / (_GRID - 1)
        cells = np.clip(np.rint((points + self._reach) / step), 0, _GRID - 1).astype(np.int32)
        flat = (cells[..., 0] * _GRID + cells[..., 1]) * _GRID + cells[..., 2]
        return self._values[flat].mean(axis=1)


def find_turn(result: TriangleMesh, reference: TriangleMesh, random: RandomState) -> Turn:
    """Look everywhere for the turn of the result that brings it nearest to the reference.

    Of turns that are equally good the smallest is taken, as a symmetric part has several.
    """
    first = _centred(result, random)
    second = _centred(reference, random)
    field = _DistanceField(second.surface)
    rotation, fit = _search(first, second, field)
    if fit.distance <= _TIE_UNITS:
        return Turn(rotation, False, fit.distance)
    _, image = _search(first.mirrored(), second, field)
    return Turn(rotation, is_clearly_nearer(image, fit), fit.distance)


def spread_rotations(count: int) -> npt.NDArray[np.float64]:
    """(count, 3, 3) rotations spread evenly over all (super-Fibonacci spirals)."""
    from scipy.spatial.transform import Rotation

    places = np.arange(count) + 0.5
    shares = places / count
    inner, outer = np.sqrt(shares), np.sqrt(1.0 - shares)
    alpha = 2.0 * np.pi * places / np.sqrt(2.0)
    beta = 2.0 * np.pi * places / _FIBONACCI_PSI
    quaternions = np.stack(
        [
            inner * np.sin(alpha),
            inner * np.cos(alpha),
            outer * np.sin(beta),
            outer * np.cos(beta),
        ],
        axis=1,
    )
    return Rotation.from_quat(quaternions).as_matrix()


def _centred(mesh: TriangleMesh, random: RandomState) -> Side:
    weights = mesh.areas
    middles = mesh.corners.mean(axis=1)
    centre = np.average(middles, axis=0, weights=weights)
    # Exact for each triangle: of the corners and of their middle.
    squares = np.square(mesh.corners - centre).sum(axis=(1, 2)) / 12.0
    squares += 0.75 * np.square(middles - centre).sum(axis=1)
    scale = _RADIUS / float(np.sqrt(np.average(squares, weights=weights)))
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = -scale * centre
    moved = moved_mesh(mesh, matrix)
    return Side(SurfaceQueries(moved), sample_surface(moved, _FINE_POINTS, random))


def _search(
    result: Side, reference: Side, field: _DistanceField
) -> tuple[npt.NDArray[np.float64], Fit]:
    """The best rotation and how it fits after ICP."""
    rotations = spread_rotations(_ROTATIONS)
    back_field = _DistanceField(result.surface)
    scores = _scores(rotations, result.points, field)
    scores += _scores(rotations.transpose(0, 2, 1), reference.points, back_field)
    chosen = _distinct(rotations, np.argsort(scores, kind="stable"))
    rough = result.thinned(_ROUGH_POINTS), reference.thinned(_ROUGH_POINTS)
    found = [refine(*rough, _pose(turn), _ROUGH_ROUNDS) for turn in chosen]
    found.sort(key=lambda each: each[1])
    # What lies right already stays, whatever the symmetries of the part.
    starts = [np.eye(4), *(pose for pose, _ in found[:_FINALISTS])]
    final = [refine(result, reference, pose) for pose in starts]
    nearest = min(distance for _, distance in final)
    limit = nearest + max(_TIE_UNITS, _TIE_SHARE * nearest)
    equal = [(pose, distance) for pose, distance in final if distance <= limit]
    pose, _ = max(equal, key=lambda each: round(float(np.trace(each[0][:3, :3])), 6))
    return pose[:3, :3] / scale_of(pose), fit_under(result, reference, pose)


def _scores(
    rotations: npt.NDArray[np.float64], points: Points, field: _DistanceField
) -> npt.NDArray[np.float64]:
    """(r,) mean distances of the turned points from a field."""
    few = points[:_FIELD_POINTS].astype(np.float32)
    matrices = rotations.astype(np.float32)
    chunks = [
        field.mean(few @ matrices[start : start + 500].transpose(0, 2, 1))
        for start in range(0, len(matrices), 500)
    ]
    return np.concatenate(chunks).astype(np.float64)


def _distinct(
    rotations: npt.NDArray[np.float64], order: npt.NDArray[np.int64]
) -> list[npt.NDArray[np.float64]]:
    """The first few rotations in an order that lie apart from each other."""
    chosen: list[npt.NDArray[np.float64]] = []
    least = 1.0 + 2.0 * np.cos(_APART)
    for index in order:
        turn = rotations[index]
        if all(float((turn * other).sum()) < least for other in chosen):
            chosen.append(turn)
            if len(chosen) == _CANDIDATES:
                break
    return chosen


def _pose(turn: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    pose = np.eye(4)
    pose[:3, :3] = turn
    return pose
