"""Which rigid motion lays the result over the reference.

First the best of the 24 rotations that map the axes onto each other, then iterated closest points
(ICP; Chen & Medioni 1992, here towards the exact surfaces and from both sides).  What is minimised
is the mean distance to the exact surface, both ways averaged: it is zero for equal models, where
distances between two samplings would have a floor.
"""

from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.normalise import Matrix, inverse, moved_points
from gaussiancad_core.comparison.queries import Nearest, Points, SurfaceQueries
from gaussiancad_core.meshes import make_mesh

_TIE_SHARE = 0.01
_TIE_UNITS = 1e-5
"""A rotation must beat a smaller turn by more than these to be taken (share; units of the box)."""

_MIRROR_SHARE = 0.8
_MIRROR_UNITS = 1e-3
"""A mirrored pose is reported if its distance is below this share, and smaller by these units."""

_ICP_ROUNDS = 40
_ICP_GAIN = 0.02
"""ICP must lower the distance by this share, or the start is kept: less is a matter of samples."""


@dataclass(frozen=True, eq=False)
class Side:
    """One of the two models, in its own 5-unit box.

    Attributes:
        surface: for exact distances.
        points: (n, 3) seeded points on it.
    """

    surface: SurfaceQueries
    points: Points

    def scaled(self, factor: float) -> "Side":
        """The same side, larger or smaller about the origin."""
        mesh = self.surface.mesh
        larger = make_mesh(mesh.vertices * factor, mesh.triangles)
        return Side(SurfaceQueries(larger), self.points * factor)


@dataclass(frozen=True, eq=False)
class Registration:
    """How the result lies over the reference.

    Attributes:
        pose: (4, 4) rigid motion, result's box -> reference's box; always a proper rotation.
        mirrored: whether a mirror image of the result fits clearly better.
        distance: mean distance to the exact surface under ``pose``, both ways averaged, units.
    """

    pose: Matrix
    mirrored: bool
    distance: float


def axis_rotations() -> list[npt.NDArray[np.float64]]:
    """The 24 proper (3, 3) rotations that map axes to axes, identity first, then by angle."""
    found = [matrix for matrix in _signed_permutations() if np.linalg.det(matrix) > 0]
    return sorted(found, key=lambda matrix: (-np.trace(matrix), *(-matrix.ravel())))


def axis_mirrors() -> list[npt.NDArray[np.float64]]:
    """The 24 improper (3, 3) matrices that map axes to axes."""
    return [-matrix for matrix in axis_rotations()]


def register(result: Side, reference: Side) -> Registration:
    """Find the motion of the result that brings it nearest to the reference.

    Both sides must have the same number of points.  Deterministic; of poses that are equally good
    the smallest turn is taken.
    """
    rotations = axis_rotations()
    scores = np.array([_distance(result, reference, _pose(turn)) for turn in rotations])
    mirror_scores = [_distance(result, reference, _pose(turn)) for turn in axis_mirrors()]
    limit = float(scores.min())
    limit += max(_TIE_UNITS, _TIE_SHARE * limit)
    first = int(np.flatnonzero(scores <= limit)[0])

    pose, distance = refine(result, reference, _pose(rotations[first]))
    best_mirror = min(mirror_scores)
    mirrored = best_mirror < _MIRROR_SHARE * distance and best_mirror < distance - _MIRROR_UNITS
    return Registration(pose, bool(mirrored), distance)


def refine(result: Side, reference: Side, start: Matrix) -> tuple[Matrix, float]:
    """ICP from a start; the best pose seen, which may be the start, and its distance."""
    best, best_distance = start, _distance(result, reference, start)
    if best_distance < _TIE_UNITS:
        return best, best_distance
    threshold = best_distance * (1.0 - _ICP_GAIN) - _TIE_UNITS
    pose = start
    for _ in range(_ICP_ROUNDS):
        there = reference.surface.nearest(moved_points(result.points, pose))
        back = result.surface.nearest(moved_points(reference.points, inverse(pose)))
        distance = float(there.distances.mean() + back.distances.mean()) / 2.0
        if distance < min(best_distance, threshold):
            best, best_distance = pose, distance
        step = _step(result, reference, pose, (there, back))
        pose = step @ pose
        if np.abs(step - np.eye(4)).max() < 1e-8:
            break
    return best, best_distance


def _signed_permutations() -> list[npt.NDArray[np.float64]]:
    found = []
    for order, signs in product(permutations(range(3)), product((1.0, -1.0), repeat=3)):
        matrix = np.zeros((3, 3))
        matrix[range(3), order] = signs
        found.append(matrix)
    return found


def _pose(turn: npt.NDArray[np.float64]) -> Matrix:
    pose = np.eye(4)
    pose[:3, :3] = turn
    return pose


def _distance(result: Side, reference: Side, pose: Matrix) -> float:
    """Mean distance to the exact surface, both ways averaged; the pose may mirror."""
    there = reference.surface.distances(moved_points(result.points, pose))
    back = result.surface.distances(moved_points(reference.points, inverse(pose)))
    return float(there.mean() + back.mean()) / 2.0


def _step(result: Side, reference: Side, pose: Matrix, nearest: tuple[Nearest, Nearest]) -> Matrix:
    """The small motion that the linearised, robustly weighted distances ask for."""
    there, back = nearest
    # Rows of both directions speak of a point x of the moved result and a point q of the reference.
    moving = np.concatenate([moved_points(result.points, pose), moved_points(back.points, pose)])
    fixed = np.concatenate([there.points, reference.points])
    flat = np.concatenate(
        [
            _normals(reference.surface, there.triangles),
            _normals(result.surface, back.triangles) @ pose[:3, :3].T,
        ]
    )
    gap = moving - fixed
    size = np.linalg.norm(gap, axis=1)
    apart = size > 1e-9
    normals = np.where(apart[:, None], gap / np.where(apart, size, 1.0)[:, None], flat)

    # Geman-McClure: what the result misses or adds must not pull at what fits.
    width = max(3.0 * float(np.median(size)), 1e-4)
    weights = 1.0 / (1.0 + (size / width) ** 2) ** 2
    rows = np.hstack([np.cross(moving, normals), normals])
    normal_matrix = rows.T @ (rows * weights[:, None])
    # The damping holds still what the shape leaves free, such as a turn of a cylinder.
    normal_matrix += np.eye(6) * (1e-6 * np.trace(normal_matrix) + 1e-12)
    motion = -np.linalg.solve(normal_matrix, rows.T @ (weights * size))
    return _rigid(motion[:3], motion[3:])


def _rigid(turn: npt.NDArray[np.float64], shift: npt.NDArray[np.float64]) -> Matrix:
    from scipy.spatial.transform import Rotation

    step = np.eye(4)
    step[:3, :3] = Rotation.from_rotvec(turn).as_matrix()
    step[:3, 3] = shift
    return step


def _normals(surface: SurfaceQueries, triangles: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
    vectors = surface.mesh.area_vectors[triangles]
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)
