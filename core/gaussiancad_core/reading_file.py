"""``reading.json``: what was read on a sheet, in px of the sheet as stored.

Views with their roles, and every stroke with its kind: those of the part, and the lines that were
told from it.
"""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from gaussiancad_core.report import Report
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.reading import ReadView
from gaussiancad_core.sheet.special_views.kinds import SpecialView
from gaussiancad_core.views import Arc, Ellipse, Segment, Stroke

READING_FILE = "reading.json"

SCHEMA = "gaussiancad-reading/1"

_DIGITS = 2
"""Decimals of px: lines are read to a twentieth of one."""

_SPECIAL_ROLES = {
    "section": "section",
    "half-section": "section",
    "partial-section": "section",
    "detail": "detail",
    "auxiliary-view": "auxiliary",
    "pictorial": "pictorial",
}
"""What :class:`SpecialKind` is called among the roles of views; others are ignored."""


def reading_values(
    report: Report,
    drawn: Sequence[ReadView],
    beside: tuple[Sequence[Mark], Sequence[SpecialView]],
    turn: Turn,
) -> dict[str, Any]:
    """What was read, as JSON values.

    Args:
        report: with the sheet's hash, projection, scale and dimensions.
        drawn: the part's views, px of the upright sheet.
        beside: annotations, and drawings that are no plain views, px of the upright sheet.
        turn: of the upright sheet.
    """
    marks, special = beside
    strokes: list[dict[str, Any]] = []
    for view in drawn:
        for stroke in view.strokes:
            entry = {
                "id": f"s{len(strokes) + 1}",
                "view": view.role.value,
                "kind": stroke.linetype.value,
                **_geometry(stroke, turn),
                "confidence": round(stroke.confidence, 3),
                "source": view.source.value,
            }
            strokes.append(entry)
    for mark in marks:
        entry = {"id": f"s{len(strokes) + 1}", "view": None, "kind": mark.kind.value}
        if mark.line is not None:
            entry["line"] = _points(np.array(mark.line), turn)
        entry["box"] = _rounded(turn.box_to_stored(mark.box))
        strokes.append(entry)
    return {
        "schema": SCHEMA,
        "sheet": {"sha256": report.sheet_sha256, "turn": round(float(turn.angle), 6)},
        "projection": {
            "value": report.projection.value,
            "source": report.projection_source,
            "alternatives": [own.value for own in report.projection_alternatives],
        },
        "unit": {"value": "mm", "source": "default"},
        "scale": {"mm_per_px": report.scale_mm_per_pixel, "source": report.scale_source},
        "views": [_view(view, turn) for view in drawn]
        + [_special_view(number, own, turn) for number, own in enumerate(special, start=1)],
        "strokes": strokes,
        "problems": [
            {"code": own.code, "message": own.message}
            for own in (*report.reasons, *report.warnings)
        ],
    }


def write_reading(values: dict[str, Any], folder: Path) -> None:
    """Write ``reading.json`` into a folder."""
    text = json.dumps(values, ensure_ascii=False, separators=(",", ":"))
    (folder / READING_FILE).write_text(text + "\n", encoding="utf-8")


def _view(view: ReadView, turn: Turn) -> dict[str, Any]:
    return {
        "id": view.role.value,
        "role": view.role.value,
        "box": _rounded(view.stored_box(turn)),
        "source": view.source.value,
        "hidden_lines": "drawn" if view.has_hidden_lines else "none",
    }


def _special_view(number: int, view: SpecialView, turn: Turn) -> dict[str, Any]:
    kind = view.kind.value
    return {
        "id": f"{kind}-{number}",
        "role": _SPECIAL_ROLES.get(kind, "ignore"),
        "kind": kind,
        "box": _rounded(turn.box_to_stored(view.box)),
        "used": view.used,
    }


def _geometry(stroke: Stroke, turn: Turn) -> dict[str, Any]:
    """A stroke on the sheet as stored; angles in radians from x (right) towards y (down)."""
    if isinstance(stroke, Segment):
        return {"line": _points(np.array([stroke.start, stroke.end]), turn)}
    (centre,) = _points(np.array([stroke.centre]), turn)
    if isinstance(stroke, Arc):
        start = stroke.start_angle + _turned(stroke, turn)
        arc = (*centre, stroke.radius * turn.scale, start, stroke.sweep)
        return {"arc": [round(float(value), 4) for value in arc]}
    rotation = stroke.rotation + _turned(stroke, turn)
    axes = stroke.semi_major * turn.scale, stroke.semi_minor * turn.scale
    ellipse = (*centre, *axes, rotation, stroke.start, stroke.sweep)
    return {"ellipse": [round(float(value), 4) for value in ellipse]}


def _turned(stroke: Arc | Ellipse, turn: Turn) -> float:
    """Radians by which directions turn from the upright sheet to the sheet as stored."""
    (x0, y0), (x1, y1) = turn.to_stored(np.array(stroke.centre) + np.array([[0, 0], [1, 0]]))
    return float(np.arctan2(y1 - y0, x1 - x0))


def _points(points: np.ndarray, turn: Turn) -> list[list[float]]:
    return np.round(turn.to_stored(points), _DIGITS).tolist()


def _rounded(box: Sequence[float]) -> list[float]:
    return [round(float(value), 1) for value in box]
