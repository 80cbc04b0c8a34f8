"""Compare two model files: what ``gaussiancad compare`` does."""

from pathlib import Path

import numpy as np

from gaussiancad_core.comparison import distances as measures
from gaussiancad_core.comparison.deviation import Deviation, measure_deviation, ply_bytes
from gaussiancad_core.comparison.models import load_model
from gaussiancad_core.comparison.normalise import (
    BOX,
    inverse,
    moved_mesh,
    normalising_matrix,
)
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.registration import Side, register
from gaussiancad_core.comparison.report import Comparison, ModelFacts, comparison_json
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.errors import UsageError
from gaussiancad_core.meshes import TriangleMesh, make_mesh
from gaussiancad_core.outputs import OutputFolder

DEFAULT_POINTS = 10_000

COMPARISON_FILES = ("comparison.json", "deviation.ply", "deviation.png")
"""What a comparison owns in its output folder."""

_REGISTRATION_POINTS = 2000
_POINT_LIMITS = (100, 1_000_000)


def compare_files(
    result: Path,
    reference: Path,
    output: Path | None = None,
    points: int = DEFAULT_POINTS,
    seed: int = 0,
) -> Comparison:
    """Compare a result with a reference, each STEP, BREP, STL, PLY or OBJ.

    Args:
        result, reference: the files.
        output: folder for ``comparison.json``, ``deviation.ply`` (see
            :mod:`gaussiancad_core.comparison.deviation`) and ``deviation.png``; None writes none.
        points: surface points a side, 100 to 1,000,000.
        seed: not negative; same seed, same numbers.

    Raises:
        UnreadableError: a file is no model; see :func:`load_model`.
        UsageError: ``points-out-of-range``, ``seed-negative``, or the folder cannot be written.
        LimitError: the disk is full.
    """
    _check(points, seed)
    comparison, deviation = compare_meshes(load_model(result), load_model(reference), points, seed)
    if output is not None:
        _write(comparison, deviation, output)
    return comparison


def compare_meshes(
    result: TriangleMesh, reference: TriangleMesh, points: int = DEFAULT_POINTS, seed: int = 0
) -> tuple[Comparison, Deviation]:
    """Compare two meshes with an extent; the deviation is in the reference's coordinates, mm."""
    to_box, from_box = normalising_matrix(result), inverse(normalising_matrix(reference))
    boxed_result = moved_mesh(result, to_box)
    boxed_reference = moved_mesh(reference, normalising_matrix(reference))
    streams = random_streams(seed, 4)
    result_points = sample_surface(boxed_result, points, streams[0])
    reference_points, again = (
        sample_surface(boxed_reference, points, stream) for stream in streams[1:3]
    )

    reference_surface = SurfaceQueries(boxed_reference)
    registration = register(
        Side(SurfaceQueries(boxed_result), result_points[:_REGISTRATION_POINTS]),
        Side(reference_surface, reference_points[:_REGISTRATION_POINTS]),
    )
    moved = moved_mesh(boxed_result, registration.pose)
    moved_surface = SurfaceQueries(moved)
    moved_points = result_points @ registration.pose[:3, :3].T + registration.pose[:3, 3]

    unit = float(np.ptp(reference.bounds, axis=0).max()) / BOX
    deviation = measure_deviation(moved, reference_surface, unit)
    placed = make_mesh(
        deviation.mesh.vertices + reference.bounds.mean(axis=0), deviation.mesh.triangles
    )
    deviation = Deviation(placed, deviation.distances, deviation.signed, deviation.limit)
    comparison = Comparison(
        distances=measures.sample_distances(moved_points, reference_points),
        floor=measures.sample_distances(reference_points, again),
        point_to_surface=measures.point_to_surface(
            (moved_surface, moved_points), (reference_surface, reference_points)
        ),
        volume_iou=measures.volume_iou(moved_surface, reference_surface, streams[3]),
        matrix=from_box @ registration.pose @ to_box,
        mirrored=registration.mirrored,
        points=points,
        seed=seed,
        unit_mm=unit,
        deviation_signed=deviation.signed,
        deviation_limit_mm=deviation.limit,
        deviation_mm=(float(deviation.distances.min()), float(deviation.distances.max())),
        result=_facts(result),
        reference=_facts(reference),
    )
    return comparison, deviation


def _facts(mesh: TriangleMesh) -> ModelFacts:
    watertight = mesh.watertight
    extent = tuple(float(value) for value in np.ptp(mesh.bounds, axis=0))
    return ModelFacts(extent, len(mesh.triangles), watertight, mesh.volume if watertight else None)


def _check(points: int, seed: int) -> None:
    low, high = _POINT_LIMITS
    if not low <= points <= high:
        raise UsageError(
            "points-out-of-range", f"{points} points cannot be compared: use {low} to {high:,}"
        )
    if seed < 0:
        raise UsageError("seed-negative", f"the seed {seed} is negative: use 0 or more")


def _write(comparison: Comparison, deviation: Deviation, output: Path) -> None:
    folder = OutputFolder(output, COMPARISON_FILES, "comparison.json")
    try:
        (folder.staging / "deviation.ply").write_bytes(ply_bytes(deviation))
        (folder.staging / "comparison.json").write_bytes(comparison_json(comparison))
        folder.commit()
    except BaseException:
        folder.discard()
        raise
