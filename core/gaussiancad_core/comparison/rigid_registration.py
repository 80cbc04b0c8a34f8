"""Which rigid motion lays the result over the reference.

First the best of the 24 rotations that map the axes onto each other, then iterated closest points
(ICP; Chen & Medioni 1992, here towards the exact surfaces and from both sides).  What is minimised
is the mean distance to the exact surface, both ways averaged: it is zero for equal models, where
distances between two samplings would have a floor.  Turns that are none of the 24 are looked for
beforehand, see :mod:`gaussiancad_core.comparison.global_registration`.
"""

from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.comparison_options import Alignment
from gaussiancad_core.comparison.normalise import Matrix, inverse, moved_points, scale_of
from gaussiancad_core.comparison.queries import Nearest, Points, SurfaceQueries
from gaussiancad_core.model.meshes import make_mesh

_TIE_SHARE = 0.01
_TIE_UNITS = 1e-5
"""A rotation must beat a smaller turn by more than these to be taken (share; units of the box)."""

_MIRROR_SHARE = 0.8
_MIRROR_UNITS = 1e-3
"""A mirrored pose is reported if its distance is below this share, and smaller by these units."""

_MIRROR_ERRORS = 3.0
"""It must also be nearer by so many standard errors: few points find a small difference by luck."""

_IMAGE = np.array([-1.0, 1.0, 1.0])

_ICP_ROUNDS = 40

_WIDE, _NARROWING = 3.0, 0.6
"""Points beyond so many root mean squares count little at first; each round narrows that."""

_NARROW, _NARROWEST = 3.0, 1e-4
"""In the end those beyond so many medians do; never less than so many units."""

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

    def thinned(self, count: int) -> "Side":
        """The same side with its first points only."""
        return Side(self.surface, self.points[:count])

    def mirrored(self) -> "Side":
        """The mirror image in the plane x = 0."""
        mesh = self.surface.mesh
        image = make_mesh(mesh.vertices * _IMAGE, mesh.triangles).flipped()
        return Side(SurfaceQueries(image), self.points * _IMAGE)


@dataclass(frozen=True)
class Fit:
    """How near one side lies to the other.

    Attributes:
        distance: mean distance to the exact surface, both ways averaged, units.
        error: its standard error, as points are a matter of chance.
    """

    distance: float
    error: float


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


def register(result: Side, reference: Side, alignment: Alignment = Alignment.ICP) -> Registration:
    """Find the motion of the result that brings it nearest to the reference.

    Both sides must have the same number of points.  Deterministic; of poses that are equally good
    the smallest turn is taken.  Whatever the alignment, all turns and mirror images are looked at,
    so that a mirror image is told even where nothing may be moved.

    Args:
        result, reference: in their boxes.
        alignment: ``NONE`` leaves the result as it is; ``GLOBAL`` is the same as ``ICP`` here.
    """
    rotations = axis_rotations()
    scores = np.array([distance_under(result, reference, _pose(turn)) for turn in rotations])
    limit = float(scores.min())
    limit += max(_TIE_UNITS, _TIE_SHARE * limit)
    first = int(np.flatnonzero(scores <= limit)[0])

    pose, distance = _pose(rotations[first]), float(scores[first])
    if alignment in (Alignment.ICP, Alignment.GLOBAL):
        pose, distance = refine(result, reference, pose)
    mirrored = _mirror_fits(result, reference, pose)
    if alignment is Alignment.NONE:
        pose, distance = np.eye(4), float(scores[0])
    return Registration(pose, mirrored, distance)


def _mirror_fits(result: Side, reference: Side, pose: Matrix) -> bool:
    """Whether some mirror image of the result lies clearly nearer than the result in a pose."""
    this_fit = fit_under(result, reference, pose)
    if this_fit.distance <= _MIRROR_UNITS:
        return False
    fits = [fit_under(result, reference, _pose(turn)) for turn in axis_mirrors()]
    best = int(np.argmin([fit.distance for fit in fits]))
    if is_clearly_nearer(fits[best], this_fit):
        return True
    image = result.mirrored()
    image_pose, _ = refine(image, reference, _pose(axis_mirrors()[best] * _IMAGE))
    fit = fit_under(image, reference, image_pose)
    if not is_clearly_nearer(fit, this_fit):
        return False
    # The image was moved by ICP, and the result perhaps not yet.
    refined, _ = refine(result, reference, pose)
    return is_clearly_nearer(fit, fit_under(result, reference, refined))


def is_clearly_nearer(mirrored: Fit, fit: Fit) -> bool:
    """Whether a mirror image's fit says that it is the one that is meant."""
    gain = fit.distance - mirrored.distance
    certain = gain > _MIRROR_ERRORS * float(np.hypot(fit.error, mirrored.error))
    return certain and gain > _MIRROR_UNITS and mirrored.distance < _MIRROR_SHARE * fit.distance


def refine(
    result: Side, reference: Side, start: Matrix, rounds: int = _ICP_ROUNDS, scaling: bool = False
) -> tuple[Matrix, float]:
    """ICP from a start; the best pose seen, which may be the start, and its distance.

    What lies far off pulls less, at first only what lies very far off: else nothing would pull a
    part whose sides fit along the way in which its top and bottom do not.

    Args:
        result, reference: with as many points each.
        start: (4, 4) motion of the result; a similarity if ``scaling``.
        rounds: at most.
        scaling: whether the result may become larger or smaller as well.
    """
    best, best_distance = start, distance_under(result, reference, start)
    if best_distance < _TIE_UNITS:
        return best, best_distance
    threshold = best_distance * (1.0 - _ICP_GAIN) - _TIE_UNITS
    pose, wide = start, 0.0
    for number in range(rounds):
        there = reference.surface.nearest(moved_points(result.points, pose))
        back = result.surface.nearest(moved_points(reference.points, inverse(pose)))
        behind = back.distances.mean() * scale_of(pose)
        distance = float(there.distances.mean() + behind) / 2.0
        if distance < min(best_distance, threshold):
            best, best_distance = pose, distance
        sizes = np.concatenate([there.distances, back.distances * scale_of(pose)])
        wide = wide or _WIDE * float(np.sqrt(np.square(sizes).mean()))
        narrow = max(_NARROW * float(np.median(sizes)), _NARROWEST)
        width = max(narrow, wide * _NARROWING**number)
        step = _step((result, reference), pose, (there, back), (width, scaling))
        pose = step @ pose
        if width <= narrow and np.abs(step - np.eye(4)).max() < 1e-8:
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


def distance_under(result: Side, reference: Side, pose: Matrix) -> float:
    """Mean distance to the exact surface, both ways averaged; the pose may mirror or scale."""
    return fit_under(result, reference, pose).distance


def fit_under(result: Side, reference: Side, pose: Matrix) -> Fit:
    """The same distance, and how far chance may have it off."""
    there = reference.surface.distances(moved_points(result.points, pose))
    back = result.surface.distances(moved_points(reference.points, inverse(pose)))
    back *= scale_of(pose)
    errors = [values.std() / np.sqrt(len(values)) for values in (there, back)]
    return Fit(float(there.mean() + back.mean()) / 2.0, float(np.hypot(*errors)) / 2.0)


def _step(
    sides: tuple[Side, Side],
    pose: Matrix,
    nearest: tuple[Nearest, Nearest],
    how: tuple[float, bool],
) -> Matrix:
    """The small motion that the linearised, robustly weighted distances ask for.

    Args:
        sides: result and reference.
        pose: of the result.
        nearest: points on the reference to those of the result, and the other way round.
        how: the distance at which a point's weight is a quarter; whether sizes may change.
    """
    (result, reference), (width, scaling) = sides, how
    there, back = nearest
    # Rows of both directions speak of a point x of the moved result and a point q of the reference.
    moving = np.concatenate([moved_points(result.points, pose), moved_points(back.points, pose)])
    fixed = np.concatenate([there.points, reference.points])
    turned = pose[:3, :3].T / scale_of(pose)
    flat = np.concatenate(
        [
            surface_normals(reference.surface, there.triangles),
            surface_normals(result.surface, back.triangles) @ turned,
        ]
    )
    gap = moving - fixed
    size = np.linalg.norm(gap, axis=1)
    apart = size > 1e-9
    normals = np.where(apart[:, None], gap / np.where(apart, size, 1.0)[:, None], flat)

    # Geman-McClure: what the result misses or adds must not pull at what fits.
    weights = 1.0 / (1.0 + (size / width) ** 2) ** 2
    rows = np.hstack([np.cross(moving, normals), normals])
    if scaling:
        rows = np.hstack([rows, (moving * normals).sum(axis=1, keepdims=True)])
    normal_matrix = rows.T @ (rows * weights[:, None])
    # The damping holds still what the shape leaves free, such as a turn of a cylinder.
    normal_matrix += np.eye(rows.shape[1]) * (1e-6 * np.trace(normal_matrix) + 1e-12)
    motion = -np.linalg.solve(normal_matrix, rows.T @ (weights * size))
    step = _rigid(motion[:3], motion[3:6])
    if scaling:
        # About the origin, as the row was taken; small steps only, or the result could vanish.
        step[:3, :3] *= 1.0 + float(np.clip(motion[6], -0.2, 0.2))
    return step


def _rigid(turn: npt.NDArray[np.float64], shift: npt.NDArray[np.float64]) -> Matrix:
    from scipy.spatial.transform import Rotation

    step = np.eye(4)
    step[:3, :3] = Rotation.from_rotvec(turn).as_matrix()
    step[:3, 3] = shift
    return step


def surface_normals(
    surface: SurfaceQueries, triangles: npt.NDArray[np.int64]
) -> npt.NDArray[np.float64]:
    """(n, 3) unit normals of triangles by their numbers; zero where one has no area."""
    vectors = surface.mesh.area_vectors[triangles]
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)
