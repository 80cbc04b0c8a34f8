"""``report.json`` (schema 2): what a run made, how sure it is, and what it cost."""

import json
import platform
import sys
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

import psutil

from gaussiancad_core import __version__
from gaussiancad_core.messages import event_fields
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.report.explanation import explained, has_measure_bound, is_size_known, verdict
from gaussiancad_core.report.report_entries import (
    AlternativeReport,
    Assumption,
    ConflictReport,
    Disagreement,
    GaussiansReport,
    HullReport,
    MeasuresReport,
    NoteReport,
    Remark,
    SectionReport,
    SolidReport,
    SurfaceReport,
    Unused,
    ViewReport,
)
from gaussiancad_core.sheet.special_views.tangent_policy import UNKNOWN_TANGENTS, SheetTangents
from gaussiancad_core.sheet.special_views.view_kinds import SpecialView
from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions
from gaussiancad_core.writing.scale_agreement import ReadDimension
from gaussiancad_protocol.modes import Status

SCHEMA = 2


@dataclass(frozen=True)
class Report:
    """Everything that is known about a run, filled in stage by stage with ``replace``.

    Attributes:
        sheet_sha256: of the sheet's file.
        settings: of the job, JSON values.
        stage: the last stage that was begun.
        projection, projection_source, projection_alternatives: reading of the arrangement.
        tangent_edges: what the sheet does with tangent edges.
        views: by role.
        scale_mm_per_pixel, scale_source: of sheet pixels.
        dimensions: that were read from the sheet; boxes in px of it.
        annotations: boxes in sheet px of what is not the part, by kind.
        strokes_source: ``vector`` if all views have the strokes of the file, else ``raster``.
        residuals_px: axis -> (median, largest) distance of what the views show from the coordinates
            that they share, for axes that two views show.
        special_views: drawings that are no plain principal views; boxes in sheet px.
        sections: those that the sheet names.
        notes: what texts say of features.
        unused: what else is on the sheet and was not used.
        assumptions: what the result rests on that no line says.
        measures: how well the places of the solid's faces are known.
        disagreements: where the solid's lines and the sheet's differ, the longest first.
        trace: what was tried for the solid, in order, JSON values.
        tolerance_px: within which lines were matched.
        alternatives: other solids, best first.
        conflict: lines that contradict each other, the suspects first.
        device: where the Gaussians were trained, ``cpu`` or ``cuda``.
        files: all others that the run wrote, with size and SHA-256, by their path in the folder.
    """

    sheet_sha256: str
    settings: dict[str, Any]
    status: Status = Status.FAILED
    stage: str = ""
    reasons: tuple[Remark, ...] = ()
    warnings: tuple[Remark, ...] = ()
    projection: Projection = Projection.THIRD
    projection_source: str = "default"
    projection_alternatives: tuple[Projection, ...] = ()
    tangent_edges: SheetTangents = UNKNOWN_TANGENTS
    views: dict[Role, ViewReport] = field(default_factory=dict)
    annotations: dict[str, list[tuple[float, float, float, float]]] = field(default_factory=dict)
    strokes_source: str = "raster"
    residuals_px: dict[str, tuple[float, float]] = field(default_factory=dict)
    special_views: tuple[SpecialView, ...] = ()
    sections: tuple[SectionReport, ...] = ()
    notes: tuple[NoteReport, ...] = ()
    unused: tuple[Unused, ...] = ()
    assumptions: tuple[Assumption, ...] = ()
    measures: MeasuresReport | None = None
    disagreements: tuple[Disagreement, ...] = ()
    trace: tuple[dict[str, Any], ...] = ()
    tolerance_px: float = 0.0
    scale_mm_per_pixel: float | None = None
    scale_source: str = "default"
    dimensions: tuple[ReadDimension, ...] = ()
    bounding_box_mm: tuple[float, float, float] | None = None
    solid: SolidReport | None = None
    alternatives: tuple[AlternativeReport, ...] = ()
    conflict: tuple[ConflictReport, ...] = ()
    hull: HullReport | None = None
    surface: SurfaceReport | None = None
    gaussians: GaussiansReport | None = None
    device: str = "cpu"
    seconds: dict[str, float] = field(default_factory=dict)
    files: dict[str, dict[str, Any]] = field(default_factory=dict)

    def warned(self, code: str, message: str) -> "Report":
        """The report with one more warning."""
        return replace(self, warnings=(*self.warnings, Remark(code, message)))

    def doubted(self, code: str, message: str) -> "Report":
        """The report with one more reason why the result is not verified; each counts once."""
        remark = Remark(code, message)
        if remark in self.reasons:
            return self
        return replace(self, reasons=(*self.reasons, remark))

    @property
    def size_known(self) -> bool:
        """Whether anything tells how large the part is."""
        return is_size_known(self._values())

    @property
    def has_measure_bound(self) -> bool:
        """Whether a bound of the measures can be stated."""
        return self.size_known and has_measure_bound(self._values())

    @property
    def verdict(self) -> str:
        """What is known of the part, in one line."""
        return verdict(self._values())

    def as_json(self) -> dict[str, Any]:
        """The report as JSON values, as the schema has them."""
        values = self._values()
        return {**values, "verdict": verdict(values), "explanation": explained(values)}

    def _values(self) -> dict[str, Any]:
        return {
            "schema": SCHEMA,
            "status": self.status.value,
            "reasons": [event_fields(reason.code, reason.message) for reason in self.reasons],
            "warnings": [event_fields(warning.code, warning.message) for warning in self.warnings],
            "stage": self.stage,
            "projection": self.projection.value,
            "projection_source": self.projection_source,
            "projection_alternatives": [p.value for p in self.projection_alternatives],
            "tangent_edges": self.tangent_edges.policy.value,
            "views": {role.value: view.as_json() for role, view in self.views.items()},
            "annotations": {
                kind: [[round(value, 1) for value in box] for box in boxes]
                for kind, boxes in self.annotations.items()
            },
            "strokes_source": self.strokes_source,
            "residuals_px": {
                axis: {"median": round(median, 4), "max": round(largest, 4)}
                for axis, (median, largest) in self.residuals_px.items()
            },
            "special_views": [
                {
                    "kind": view.kind.value,
                    "box": [round(value, 1) for value in view.box],
                    "used": view.used,
                }
                for view in self.special_views
            ],
            "sections": [_with_box(asdict(section), "box") for section in self.sections],
            "notes": [_with_box(asdict(note), "at") for note in self.notes],
            "unused": [_with_box(asdict(unused), "box") for unused in self.unused],
            "assumptions": [
                {
                    **_with_box(asdict(assumption), "at"),
                    **event_fields(assumption.code, assumption.message),
                }
                for assumption in self.assumptions
            ],
            "tolerance_px": self.tolerance_px,
            "scale_mm_per_pixel": self.scale_mm_per_pixel,
            "scale_source": self.scale_source,
            "dimensions": [
                {
                    "text": dimension.text,
                    "type": dimension.sign.value or "linear",
                    "value_mm": dimension.value_mm,
                    "box": [round(value, 1) for value in dimension.box],
                    "mm_per_pixel": dimension.mm_per_pixel,
                    "used": dimension.used,
                }
                for dimension in self.dimensions
            ],
            "bounding_box_mm": self.bounding_box_mm,
            "measures": asdict(self.measures) if self.measures else None,
            "solid": asdict(self.solid) if self.solid else None,
            "alternatives": [asdict(other) for other in self.alternatives],
            "conflict": [
                {**asdict(line), "box": [round(value, 1) for value in line.box]}
                for line in self.conflict
            ],
            "disagreements": [
                {**asdict(disagreement), "length_mm": round(disagreement.length_mm, 2)}
                for disagreement in self.disagreements
            ],
            "hull": asdict(self.hull) if self.hull else None,
            "surface": asdict(self.surface) if self.surface else None,
            "gaussians": asdict(self.gaussians) if self.gaussians else None,
            "trace": list(self.trace),
            "seconds": self.seconds,
            "peak_memory_mb": peak_memory_mb(),
            "files": self.files,
            "settings": self.settings,
            "engine": engine_facts(self.settings, self.sheet_sha256, self.device),
        }

    def write(self, path: Path) -> None:
        """Write the report as UTF-8 JSON."""
        text = json.dumps(self.as_json(), indent=2, ensure_ascii=False)
        path.write_text(text + "\n", encoding="utf-8")


def _with_box(entry: dict[str, Any], name: str) -> dict[str, Any]:
    """An entry with a box in rounded px, if there is one."""
    box = entry[name]
    return {**entry, name: None if box is None else [round(value, 1) for value in box]}


def engine_facts(
    settings: dict[str, Any], sheet_sha256: str, device: str = "cpu"
) -> dict[str, Any]:
    """Versions, device, seed and the sheet's hash: what a repetition needs."""
    return {
        "version": __version__,
        "python": platform.python_version(),
        "platform": sys.platform,
        "packages": installed_versions(ENGINE_PACKAGES),
        "device": device,
        "seed": settings.get("seed"),
        "sheet_sha256": sheet_sha256,
    }


def peak_memory_mb() -> float:
    """Largest resident memory of this process so far."""
    memory = psutil.Process().memory_info()
    if hasattr(memory, "peak_wset"):
        return round(memory.peak_wset / 1e6, 1)
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    # Linux counts in KiB, macOS in bytes.
    return round(peak * (1.0 if sys.platform == "darwin" else 1024.0) / 1e6, 1)
