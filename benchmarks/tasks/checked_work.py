"""A sheet against its true part, what was made of it, and parts with one thing wrong."""

import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.parts.wrong_parts import wrong_parts
from benchmarks.run.workers import FIRST, Row
from gaussiancad_core.judging.faceted_solids import FacetedSolid, faceted_shape
from gaussiancad_core.judging.sheet_judgement import SheetJudgement
from gaussiancad_core.kernel.booleans import unified
from gaussiancad_core.kernel.brep import moved_to_origin
from gaussiancad_core.kernel.brep_files import read_shape
from gaussiancad_core.processes.events import Progress, Silence
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.sheet_check import (
    STAGES,
    CheckedModel,
    ReadSheet,
    checked_on,
    read_for_check,
)

TRUTH, MADE = "truth", "made"

_ALIKE = 1e-3
"""Share of the lines within which two models explain a sheet alike."""


@dataclass(frozen=True)
class Task:
    """A sheet to check models against.

    Attributes:
        sheet: the file; its part is beside it.
        made: the solid that a run made of it; None where there is none.
        limit: s of the clock.
    """

    sheet: Path
    made: Path | None
    limit: float

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"source": self.sheet.parent.name, "name": self.sheet.stem}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: self.limit, "models": self.limit}


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet, bit by bit."""
    silence_opencascade()
    job = Job(task.sheet, task.sheet.parent)
    read = read_for_check(job, RunNotes(Report("", {}), Progress(Silence(), len(STAGES))))
    yield {"read": bool(read.readings), "shaded": read.is_shaded, "stage": "models"}
    part = unified(moved_to_origin(read_shape(task.sheet.with_suffix(".step"))))
    models: dict[str, Row] = {TRUTH: _judged(read, faceted_shape(part))}
    yield {"models": models}
    if task.made is not None:
        models[MADE] = _judged(read, faceted_shape(read_shape(task.made)))
        yield {"models": models}
    truth = models[TRUTH]
    for kind, solid in wrong_parts(part):
        row = _judged(read, solid)
        # A mirror image that explains the sheet as well is the part itself, or looks like it.
        if kind != "mirrored" or row["share"] is None or not _alike(row, truth):
            models[kind] = row
            yield {"models": models}


def _alike(row: Row, other: Row) -> bool:
    return other["share"] is not None and abs(row["share"] - other["share"]) <= _ALIKE


def _judged(read: ReadSheet, solid: FacetedSolid) -> Row:
    began = time.process_time()
    found: SheetJudgement = checked_on(read, CheckedModel(solid))
    return {
        "verdict": found.judgement.verdict.value,
        "reasons": [reason.code for reason in found.judgement.reasons],
        "share": None if found.laid is None else found.laid.misfit.share,
        "edits": [(edit.what, edit.mm) for edit in found.edits[:3]],
        "seconds": time.process_time() - began,
    }
