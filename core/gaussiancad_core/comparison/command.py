"""Compare two model files: what ``gaussiancad compare`` does."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from gaussiancad_core.comparison import distances as measures
from gaussiancad_core.comparison.deviation import Deviation, measure_deviation, ply_bytes
from gaussiancad_core.comparison.models import load_model
from gaussiancad_core.comparison.normalise import (
    BOX,
    Matrix,
    inverse,
    moved_mesh,
    moved_points,
    normalising_matrix,
    scale_of,
)
from gaussiancad_core.comparison.picture import deviation_picture
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.registration import Side, refine, register
from gaussiancad_core.comparison.report import (
    Comparison,
    DeviationFacts,
    ModelFacts,
    comparison_json,
)
from gaussiancad_core.comparison.sampling import RandomState, random_streams, sample_surface
from gaussiancad_core.errors import UsageError
from gaussiancad_core.meshes import TriangleMesh, make_mesh
from gaussiancad_core.outputs import OutputFolder
from gaussiancad_core.verification.preview import png_bytes

DEFAULT_POINTS = 10_000

COMPARISON_FILES = ("comparison.json", "deviation.ply", "deviation.png")
"""What a comparison owns in its output folder."""

_REGISTRATION_POINTS = 2000
_POINT_LIMITS = (100, 1_000_000)

_SAME_SIZE = 0.05
"""Longest edges that differ by less than this share are taken for the same size in mm."""


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
    streams = random_streams(seed, 4)
    first, second = _boxed(result, points, streams[0]), _boxed(reference, points, streams[1])
    again = sample_surface(second.surface.mesh, points, streams[2])
    registration = register(_thinned(first), _thinned(second))
    matrix = inverse(normalising_matrix(reference)) @ registration.pose @ normalising_matrix(result)
    moved = Side(
        SurfaceQueries(moved_mesh(first.surface.mesh, registration.pose)),
        moved_points(first.points, registration.pose),
    )
    deviation = _deviation(first, second, registration.pose, reference, scale_of(matrix))
    comparison = Comparison(
        distances=measures.sample_distances(moved.points, second.points),
        floor=measures.sample_distances(second.points, again),
        point_to_surface=measures.point_to_surface(
            (moved.surface, moved.points), (second.surface, second.points)
        ),
        volume_iou=measures.volume_iou(moved.surface, second.surface, streams[3]),
        matrix=matrix,
        mirrored=registration.mirrored,
        points=points,
        seed=seed,
        unit_mm=_unit(reference),
        deviation=DeviationFacts(
            deviation.signed,
            deviation.limit,
            float(deviation.distances.min()),
            float(deviation.distances.max()),
            deviation.scale,
        ),
        result=_facts(result),
        reference=_facts(reference),
    )
    return comparison, deviation


def _boxed(mesh: TriangleMesh, points: int, stream: RandomState) -> Side:
    """A model in its 5-unit box, with points on it."""
    boxed = moved_mesh(mesh, normalising_matrix(mesh))
    return Side(SurfaceQueries(boxed), sample_surface(boxed, points, stream))


def _thinned(side: Side) -> Side:
    """A side with as many points as registration needs."""
    return Side(side.surface, side.points[:_REGISTRATION_POINTS])


def _unit(reference: TriangleMesh) -> float:
    """mm of the reference per unit of its box."""
    return float(np.ptp(reference.bounds, axis=0).max()) / BOX


def _deviation(
    first: Side, second: Side, pose: Matrix, reference: TriangleMesh, scale: float
) -> Deviation:
    """The result's deviation, at its own size where that is about the reference's.

    The box of the protocol scales a result by the extent of its bounding box, so that one bump
    would shift all of it.  Who compares two models in millimetres wants them as they are.
    """
    if abs(scale - 1.0) > _SAME_SIZE:
        placed = moved_mesh(first.surface.mesh, pose)
    else:
        own = _thinned(first).scaled(1.0 / scale)
        pose, _ = refine(own, _thinned(second), pose)
        placed, scale = moved_mesh(own.surface.mesh, pose), 1.0
    found = measure_deviation(placed, second.surface, _unit(reference))
    mesh = make_mesh(found.mesh.vertices + reference.bounds.mean(axis=0), found.mesh.triangles)
    return replace(found, mesh=mesh, scale=scale)


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
        picture = png_bytes(deviation_picture(deviation))
        (folder.staging / "deviation.png").write_bytes(picture)
        (folder.staging / "comparison.json").write_bytes(comparison_json(comparison))
        folder.commit()
    except BaseException:
        folder.discard()
        raise
