"""How often does ``--register global`` find the pose of a part that was turned at random?

Twenty random parts whose axes tell them apart (no turn by quarters comes near to mapping one onto
itself), ten random poses each.  Found is a pose within 0.5 degrees and 0.2 % of the longest edge.
With ``--mirrored`` the parts are mirrored as well, and counted is how often that is told.
"""

import argparse
import time

import numpy as np
from scipy.spatial.transform import Rotation

from benchmarks.run.outcome import Figure, Outcome, share
from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import Alignment, CompareOptions
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.comparison.normalise import moved_mesh, normalising_matrix
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.rigid_registration import (
    Side,
    axis_mirrors,
    axis_rotations,
    distance_under,
)
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.kernel.brep import bounding_box, tessellate
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.samples.random_parts import random_part

MINUTES = 15

DEGREES = 0.5
SHIFT_SHARE = 0.002
DISTINCT = 0.01
"""Units of the 5-unit box by which every turned or mirrored copy must lie beside the part."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--parts", type=int, default=20)
    parser.add_argument("--poses", type=int, default=10)
    parser.add_argument("--mirrored", action="store_true")


def run(options: argparse.Namespace) -> Outcome:
    """Print the poses that were missed."""
    random = np.random.default_rng(1)
    found, tried, seconds = 0, 0, []
    for seed, mesh in asymmetric_parts(options.parts):
        for number in range(options.poses):
            pose = random_pose(random, float(np.ptp(mesh.bounds, axis=0).max()))
            moved = moved_mesh(mesh, pose)
            if options.mirrored:
                moved = make_mesh(moved.vertices * [-1, 1, 1], moved.triangles).flipped()
            started = time.process_time()
            ask = CompareOptions(points=1000, alignment=Alignment.GLOBAL)
            comparison, _ = compare_models(Model(moved), Model(mesh), ask)
            seconds.append(time.process_time() - started)
            right = comparison.mirrored if options.mirrored else _right(comparison.matrix, pose)
            right = right and comparison.mirrored == options.mirrored
            found, tried = found + right, tried + 1
            if not right:
                print(f"part {seed}, pose {number}: missed, mirrored {comparison.mirrored}")
    spent = round(float(np.median(seconds)), 1)
    return Outcome((share("poses found", found, tried), Figure("a comparison", spent, "CPU s")))


def asymmetric_parts(count: int) -> list[tuple[int, TriangleMesh]]:
    """The first random parts that no turn by quarters and no mirror maps onto themselves."""
    parts: list[tuple[int, TriangleMesh]] = []
    seed = 0
    while len(parts) < count:
        shape = random_part(seed, 5)
        longest = float(np.ptp(bounding_box(shape), axis=0).max())
        mesh = make_mesh(*tessellate(shape, 1e-3 * longest))
        if _asymmetric(mesh):
            parts.append((seed, mesh))
        seed += 1
    return parts


def random_pose(random: np.random.Generator, longest: float) -> np.ndarray:
    """(4, 4) any turn, and a shift by up to three lengths of the part."""
    pose = np.eye(4)
    pose[:3, :3] = Rotation.random(rng=random).as_matrix()
    pose[:3, 3] = random.uniform(-3.0, 3.0, 3) * longest
    return pose


def _asymmetric(mesh: TriangleMesh) -> bool:
    boxed = moved_mesh(mesh, normalising_matrix(mesh))
    side = Side(SurfaceQueries(boxed), sample_surface(boxed, 1000, random_streams(0, 1)[0]))
    others = [*axis_rotations()[1:], *axis_mirrors()]
    for turn in others:
        pose = np.eye(4)
        pose[:3, :3] = turn
        if distance_under(side, side, pose) < DISTINCT:
            return False
    return True


def _right(matrix: np.ndarray, pose: np.ndarray) -> bool:
    """Whether a matrix undoes a pose."""
    rest = matrix @ pose
    scale = float(np.linalg.norm(rest[:3, 0]))
    angle = Rotation.from_matrix(rest[:3, :3] / scale).magnitude()
    return bool(
        np.degrees(angle) < DEGREES
        and abs(scale - 1.0) < SHIFT_SHARE
        and np.linalg.norm(rest[:3, 3]) < SHIFT_SHARE * np.linalg.norm(pose[:3, 3]) + 0.1
    )
