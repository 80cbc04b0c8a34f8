"""What a comparison found, as numbers and as ``comparison.json``."""

import json
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.comparison_options import Alignment, Protocol, ScaleRule
from gaussiancad_core.comparison.deepcad import PROTOCOL as DEEPCAD
from gaussiancad_core.comparison.deepcad import DeepCadResult
from gaussiancad_core.comparison.distances import SampleDistances, VolumeIou
from gaussiancad_core.comparison.engineering import (
    NORMAL_ANGLE,
    DistanceStatistics,
    EngineeringResult,
)
from gaussiancad_core.comparison.engineering import PROTOCOL as ENGINEERING
from gaussiancad_core.comparison.findings import Histogram, WorstPoint
from gaussiancad_core.comparison.normalise import scale_of
from gaussiancad_core.report.report_entries import Remark

SCHEMA = 1

PROTOCOL = "gaussiancad-1: 5-unit boxes at the origin, best of 24 rotations, ICP, seeded samples"
"""Name of the way the numbers are made; another number here means that they do not compare."""


@dataclass(frozen=True)
class ModelFacts:
    """What a compared file holds.

    Attributes:
        extent_mm: (3,) edges of its bounding box.
        triangles: their number, after tessellation of an exact solid.
        watertight: whether it is closed.
        volume_mm3: None where it is not closed; of the exact surfaces where there are.
        area_mm2: of the exact surfaces where there are.
        bounds_mm: lowest and highest coordinates in the file.
        betti: bodies, tunnels and cavities; None where it is not closed.
        valid: whether OpenCASCADE's check finds nothing; None for triangles.
        faces: of an exact solid; None for triangles.
        content: what of an exact file is measured, a value of ``Content``; None for triangles.
    """

    extent_mm: tuple[float, ...]
    triangles: int
    watertight: bool
    volume_mm3: float | None
    area_mm2: float
    bounds_mm: tuple[tuple[float, ...], tuple[float, ...]]
    betti: tuple[int, int, int] | None
    valid: bool | None
    faces: int | None
    content: str | None


@dataclass(frozen=True)
class DeviationFacts:
    """What the coloured mesh of a comparison shows.

    Attributes:
        signed: whether distances have a sign (negative: inside the reference).
        range_mm: end of the colour scale.
        least_mm, greatest_mm: of the vertices.
        scale: of the result; 1 where it is shown in its own size, which differs by 5 % at most.
        histogram: of the surface shown.
        worst: of both directions, the worst first.
    """

    signed: bool
    range_mm: float
    least_mm: float
    greatest_mm: float
    scale: float
    histogram: Histogram
    worst: tuple[WorstPoint, ...]


@dataclass(frozen=True, eq=False)
class Comparison:
    """How far a result is from a reference.

    Attributes:
        distances: CD, HD and EMD between samples of both, units of the 5-unit box.
        floor: the same between two samples of the reference.
        point_to_surface: mean distance to the exact surface, both ways averaged, units.
        volume_iou: common volume over united volume.
        matrix: (4, 4) the result file's coordinates -> the reference file's, mm; a rotation, a
            uniform scale (longest edges become equal) and a shift.
        mirrored: whether a mirror image of the result fits clearly better.
        alignment, scale_rule: how the result was laid over the reference.
        points: surface points a side.
        seed: of the samples.
        unit_mm: mm of the reference per unit.
        deviation: of the result's vertices from the reference.
        result, reference: facts on both files.
        warnings: what to know before believing the numbers.
        unit_factor: by which the result's unit seems to be off, or None.
        protocols: those that were asked for.
        deepcad, engineering: None where they were not.
    """

    distances: SampleDistances
    floor: SampleDistances
    point_to_surface: float
    volume_iou: VolumeIou
    matrix: npt.NDArray[np.float64]
    mirrored: bool
    alignment: Alignment
    scale_rule: ScaleRule
    points: int
    seed: int
    unit_mm: float
    deviation: DeviationFacts
    result: ModelFacts
    reference: ModelFacts
    warnings: tuple[Remark, ...]
    unit_factor: float | None
    protocols: tuple[Protocol, ...]
    deepcad: DeepCadResult | None
    engineering: EngineeringResult | None

    @property
    def name(self) -> str:
        """What the numbers are called: another alignment or scale than the protocol's is named."""
        if (self.alignment, self.scale_rule) == (Alignment.ICP, ScaleRule.FREE):
            return PROTOCOL
        return f"{PROTOCOL}; but registration {self.alignment.value}, scale {self.scale_rule.value}"

    @property
    def emd_method(self) -> str:
        """``exact``, or which points stand for all."""
        matched = self.distances.emd_points
        return "exact" if matched == self.points else f"exact on the first {matched} points a side"


def comparison_dict(comparison: Comparison) -> dict[str, Any]:
    """The JSON object of ``comparison.json``."""
    return {
        "schema": SCHEMA,
        **_paper_dict(comparison),
        "emd_points": comparison.distances.emd_points,
        "unit_mm": comparison.unit_mm,
        "unit_factor": comparison.unit_factor,
        "warnings": [asdict(remark) for remark in comparison.warnings],
        "deviation": asdict(comparison.deviation),
        "result": asdict(comparison.result),
        "reference": asdict(comparison.reference),
        "protocols": protocols_dict(comparison),
    }


def protocols_dict(comparison: Comparison) -> dict[str, dict[str, Any]]:
    """A block for each protocol that was asked for, by its name."""
    blocks: dict[str, dict[str, Any]] = {}
    if Protocol.GAUSSIANCAD in comparison.protocols:
        blocks["gaussiancad"] = _paper_dict(comparison)
    if comparison.deepcad is not None:
        blocks["deepcad"] = _deepcad_dict(comparison.deepcad)
    if comparison.engineering is not None:
        blocks["engineering"] = _engineering_dict(comparison.engineering)
    return blocks


def _paper_dict(comparison: Comparison) -> dict[str, Any]:
    floor = comparison.floor
    return {
        "protocol": comparison.name,
        "chamfer": comparison.distances.chamfer,
        "hausdorff": comparison.distances.hausdorff,
        "emd": comparison.distances.emd,
        "emd_method": comparison.emd_method,
        "point_to_surface": comparison.point_to_surface,
        "floor": {"chamfer": floor.chamfer, "hausdorff": floor.hausdorff, "emd": floor.emd},
        "volume_iou": comparison.volume_iou.value,
        "volume_iou_method": comparison.volume_iou.method.value,
        "registration": {
            "matrix": comparison.matrix.tolist(),
            "mirrored": comparison.mirrored,
            "scale": scale_of(comparison.matrix),
            "mode": comparison.alignment.value,
            "scale_rule": comparison.scale_rule.value,
        },
        "points": comparison.points,
        "seed": comparison.seed,
    }


def _deepcad_dict(found: DeepCadResult) -> dict[str, Any]:
    return {
        "protocol": DEEPCAD,
        "chamfer_x1000": found.chamfer_x1000,
        "floor": {"chamfer_x1000": found.floor_x1000},
        "volume_iou": found.volume_iou.value,
        "volume_iou_method": found.volume_iou.method.value,
        "valid": found.invalid is None,
        "invalid_reason": found.invalid,
        "points": found.points,
        "seed": found.seed,
    }


def _engineering_dict(found: EngineeringResult) -> dict[str, Any]:
    return {
        "protocol": ENGINEERING,
        "result_to_reference": _statistics_dict(found.result_to_reference),
        "reference_to_result": _statistics_dict(found.reference_to_result),
        "agreement": found.agreement,
        "tolerance_mm": found.tolerance_mm,
        "normal_angle_degrees": NORMAL_ANGLE,
        "floor": {"deviation_mm": found.floor_mm},
        "volume_difference_mm3": found.volume_mm3,
        "volume_difference_share": found.volume_share,
        "area_difference_mm2": found.area_mm2,
        "area_difference_share": found.area_share,
        "volume_iou": found.volume_iou.value,
        "volume_iou_method": found.volume_iou.method.value,
        "placed_bounds_mm": found.placed_bounds_mm.tolist(),
        "matrix": found.matrix.tolist(),
        "points": found.points,
        "seed": found.seed,
    }


def _statistics_dict(found: DistanceStatistics) -> dict[str, Any]:
    return {
        "signed": found.signed,
        "mean_mm": found.mean,
        "mean_absolute_mm": found.mean_absolute,
        "rms_mm": found.rms,
        "least_mm": found.least,
        "greatest_mm": found.greatest,
        "percentiles_mm": {str(share): value for share, value in found.percentiles.items()},
        "within_tolerance": found.within,
    }


def comparison_json(comparison: Comparison) -> bytes:
    """The content of ``comparison.json``, UTF-8."""
    text = json.dumps(comparison_dict(comparison), indent=2, allow_nan=False)
    return (text + "\n").encode("utf-8")
