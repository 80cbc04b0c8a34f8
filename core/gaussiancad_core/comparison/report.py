"""What a comparison found, as numbers, as ``comparison.json`` and as text for a terminal."""

import json
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.distances import IouMethod, SampleDistances, VolumeIou
from gaussiancad_core.comparison.normalise import scale_of

SCHEMA = 1

PROTOCOL = "gaussiancad-1: 5-unit boxes at the origin, best of 24 rotations, ICP, seeded samples"
"""Name of the way the numbers are made; another number here means that they do not compare."""

_IOU_NAMES = {
    IouMethod.BOOLEAN: "exact Boolean of the meshes",
    IouMethod.OCCUPANCY: "estimated from points: a mesh is not closed",
    IouMethod.NONE: "no model encloses a volume",
}


@dataclass(frozen=True)
class ModelFacts:
    """What a compared file holds.

    Attributes:
        extent_mm: (3,) edges of its bounding box.
        triangles: their number, after tessellation of an exact solid.
        watertight: whether it is closed.
        volume_mm3: None where it is not closed.
    """

    extent_mm: tuple[float, ...]
    triangles: int
    watertight: bool
    volume_mm3: float | None


@dataclass(frozen=True)
class DeviationFacts:
    """What the coloured mesh of a comparison shows.

    Attributes:
        signed: whether distances have a sign (negative: inside the reference).
        range_mm: end of the colour scale.
        least_mm, greatest_mm: of the vertices.
        scale: of the result; 1 where it is shown in its own size, which differs by 5 % at most.
    """

    signed: bool
    range_mm: float
    least_mm: float
    greatest_mm: float
    scale: float


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
        points: surface points a side.
        seed: of the samples.
        unit_mm: mm of the reference per unit.
        deviation: of the result's vertices from the reference.
        result, reference: facts on both files.
    """

    distances: SampleDistances
    floor: SampleDistances
    point_to_surface: float
    volume_iou: VolumeIou
    matrix: npt.NDArray[np.float64]
    mirrored: bool
    points: int
    seed: int
    unit_mm: float
    deviation: DeviationFacts
    result: ModelFacts
    reference: ModelFacts


def comparison_dict(comparison: Comparison) -> dict[str, Any]:
    """The JSON object of ``comparison.json``."""
    floor = comparison.floor
    return {
        "schema": SCHEMA,
        "protocol": PROTOCOL,
        "chamfer": comparison.distances.chamfer,
        "hausdorff": comparison.distances.hausdorff,
        "emd": comparison.distances.emd,
        "point_to_surface": comparison.point_to_surface,
        "floor": {"chamfer": floor.chamfer, "hausdorff": floor.hausdorff, "emd": floor.emd},
        "volume_iou": comparison.volume_iou.value,
        "volume_iou_method": comparison.volume_iou.method.value,
        "registration": {
            "matrix": comparison.matrix.tolist(),
            "mirrored": comparison.mirrored,
            "scale": scale_of(comparison.matrix),
        },
        "points": comparison.points,
        "emd_points": comparison.distances.emd_points,
        "seed": comparison.seed,
        "unit_mm": comparison.unit_mm,
        "deviation": asdict(comparison.deviation),
        "result": asdict(comparison.result),
        "reference": asdict(comparison.reference),
    }


def comparison_json(comparison: Comparison) -> bytes:
    """The content of ``comparison.json``, UTF-8."""
    text = json.dumps(comparison_dict(comparison), indent=2, allow_nan=False)
    return (text + "\n").encode("utf-8")


def comparison_text(comparison: Comparison) -> str:
    """A table for a terminal: each measure, its floor, and what it means in mm."""
    distances, floor, unit = comparison.distances, comparison.floor, comparison.unit_mm
    rows = [
        ("chamfer", distances.chamfer, floor.chamfer),
        ("hausdorff", distances.hausdorff, floor.hausdorff),
        ("emd", distances.emd, floor.emd),
        ("point to surface", comparison.point_to_surface, 0.0),
    ]
    lines = [f"{'':<18}{'units':>10}{'floor':>10}{'mm':>12}"]
    lines += [
        f"{name:<18}{value:>10.4f}{least:>10.4f}{value * unit:>12.4f}"
        for name, value, least in rows
    ]
    iou = comparison.volume_iou
    value = "-" if iou.value is None else f"{iou.value:.4f}"
    lines.append(f"{'volume IoU':<18}{value:>10}  ({_IOU_NAMES[iou.method]})")
    deviation = comparison.deviation
    sizes = "in its own size" if deviation.scale == 1.0 else "scaled to the reference"
    span = f"{deviation.least_mm:>+10.4f} to {deviation.greatest_mm:+.4f}"
    lines.append(f"{'deviation':<18}{span} mm, {sizes}")
    for name, facts in (("result", comparison.result), ("reference", comparison.reference)):
        size = " x ".join(f"{edge:.6g}" for edge in facts.extent_mm)
        closed = "closed" if facts.watertight else "not closed"
        lines.append(f"{name:<18}{size} mm, {facts.triangles} triangles, {closed}")
    lines.append(f"{'scale':<18}{scale_of(comparison.matrix):.6g}")
    lines.append(
        f"{comparison.points} points a side ({distances.emd_points} for emd), "
        f"seed {comparison.seed}; 1 unit = {unit:.6g} mm: the longest edge is 5 units"
    )
    if comparison.mirrored:
        lines.append("The result looks like a mirror image of the reference: check its views.")
    return "\n".join(lines)
