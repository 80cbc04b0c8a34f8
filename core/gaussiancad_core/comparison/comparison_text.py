"""A comparison as text for a terminal."""

from gaussiancad_core.comparison.comparison_report import Comparison, ModelFacts
from gaussiancad_core.comparison.deepcad import DeepCadResult
from gaussiancad_core.comparison.distances import IouMethod, VolumeIou
from gaussiancad_core.comparison.engineering import (
    NORMAL_ANGLE,
    DistanceStatistics,
    EngineeringResult,
)
from gaussiancad_core.comparison.model_files import Content
from gaussiancad_core.comparison.normalise import scale_of

_IOU_NAMES = {
    IouMethod.BOOLEAN: "exact Boolean of the meshes",
    IouMethod.OCCUPANCY: "estimated from points: a mesh is not closed",
    IouMethod.NONE: "no model encloses a volume",
}

_ROUNDING = 1e-12
"""Smaller shares of volumes and areas are what double precision leaves of equal ones."""


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
    lines.append(_iou_line(comparison.volume_iou))
    deviation = comparison.deviation
    sizes = "in its own size" if deviation.scale == 1.0 else "scaled to the reference"
    # Where nothing is left but rounding, a sign would say something.
    least, greatest = (round(mm, 4) + 0.0 for mm in (deviation.least_mm, deviation.greatest_mm))
    span = f"{least:>+10.4f} to {greatest:+.4f}"
    lines.append(f"{'deviation':<18}{span} mm, {sizes}")
    lines.append(_facts_line("result", comparison.result))
    lines.append(_facts_line("reference", comparison.reference))
    lines.append(f"{'scale':<18}{scale_of(comparison.matrix):.6g}")
    lines.append(
        f"{comparison.points} points a side ({distances.emd_points} for emd), "
        f"seed {comparison.seed}; 1 unit = {unit:.6g} mm: the longest edge is 5 units"
    )
    if comparison.deepcad is not None:
        lines += ["", *_deepcad_lines(comparison.deepcad)]
    if comparison.engineering is not None:
        lines += ["", *_engineering_lines(comparison.engineering)]
    lines += [f"warning: {remark.message} [{remark.code}]" for remark in comparison.warnings]
    return "\n".join(lines)


def _iou_line(iou: VolumeIou) -> str:
    value = "-" if iou.value is None else f"{iou.value:.4f}"
    return f"{'volume IoU':<18}{value:>10}  ({_IOU_NAMES[iou.method]})"


def _facts_line(name: str, facts: ModelFacts) -> str:
    size = " x ".join(f"{edge:.6g}" for edge in facts.extent_mm)
    parts = [f"{size} mm", _counted(facts.triangles, "triangle")]
    if facts.content == Content.SURFACES.value:
        parts.append(f"{_counted(facts.faces or 0, 'surface')}, no solid")
    elif facts.faces is not None:
        parts.append(f"{_counted(facts.faces, 'face')}, {'valid' if facts.valid else 'INVALID'}")
    parts.append("closed" if facts.watertight else "not closed")
    if facts.betti is not None:
        parts.append("b0 b1 b2 = {} {} {}".format(*facts.betti))
    return f"{name:<18}{', '.join(parts)}"


def _counted(count: int, name: str) -> str:
    return f"{count} {name}" if count == 1 else f"{count} {name}s"


def _difference(value: float, share: float, unit: str) -> str:
    """A difference and its share; none where only rounding is left."""
    stated = value if abs(share) >= _ROUNDING else 0.0
    return f"{stated:+.6g} {unit} ({round(100.0 * share, 4) + 0.0:+.4f} %)"


def _deepcad_lines(found: DeepCadResult) -> list[str]:
    invalid = "" if found.invalid is None else f"; INVALID: {found.invalid}"
    return [
        f"deepcad: {found.points} points, unit cube, seed {found.seed}{invalid}",
        f"{'chamfer x1000':<18}{found.chamfer_x1000:>10.4f}{found.floor_x1000:>10.4f}",
        _iou_line(found.volume_iou),
    ]


def _engineering_lines(found: EngineeringResult) -> list[str]:
    forth, back = found.result_to_reference, found.reference_to_result
    rows = [
        ("mean, mm", forth.mean, back.mean),
        ("rms, mm", forth.rms, back.rms),
        ("farthest in, mm", _inward(forth), _inward(back)),
        ("farthest out, mm", forth.greatest, back.greatest),
        *(
            (f"{each} % below, mm", forth.percentiles[each], back.percentiles[each])
            for each in forth.percentiles
        ),
        ("agreeing share", forth.within, back.within),
    ]
    lines = [f"{'engineering':<18}{'result':>12}{'reference':>12}"]
    lines += [f"{name:<18}{one:>12.5f}{other:>12.5f}" for name, one, other in rows]
    lines.append(
        f"agreeing: within {found.tolerance_mm:.4g} mm, normals within {NORMAL_ANGLE:g} degrees; "
        f"triangles are at most {found.floor_mm:.2g} mm off the exact surfaces"
    )
    volume = "-"
    if found.volume_mm3 is not None and found.volume_share is not None:
        volume = _difference(found.volume_mm3, found.volume_share, "mm3")
    lines.append(f"{'volume':<18}{volume}")
    lines.append(f"{'area':<18}{_difference(found.area_mm2, found.area_share, 'mm2')}")
    lines.append(_iou_line(found.volume_iou))
    return lines


def _inward(found: DistanceStatistics) -> float:
    return min(found.least, 0.0)
