"""A sheet of a known part through the whole engine, in the process of the task."""

import json
from pathlib import Path
from random import Random

from benchmarks.run.workers import Row
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.pipeline import REPORT_FILE, reconstruct
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_protocol.modes import ResultKind

_FIRST_ANGLE = 0.35
"""Share of the sheets that are in first angle."""


def projection_of(name: str) -> Projection:
    """First or third angle, by lot for each part."""
    first = Random(name).random() < _FIRST_ANGLE
    return Projection.FIRST if first else Projection.THIRD


def solved_sheet(sheet: Path, folder: Path, options: ReadingOptions, projection: Projection) -> Row:
    """What the report says of the solid of a sheet that is drawn in a projection."""
    reconstruct(Job(sheet, folder, options, result=ResultKind.SOLID), Silence())
    report = json.loads((folder / REPORT_FILE).read_text(encoding="utf-8"))
    return {
        "status": report["status"],
        "reasons": [reason["code"] for reason in report["reasons"]],
        "message": report["reasons"][0]["message"] if report["reasons"] else "",
        "alternatives": report["solid"]["alternatives"] if report["solid"] else 0,
        "mistaken": report["projection"] != projection.value,
        "seconds": sum(report["seconds"].values()),
    }
