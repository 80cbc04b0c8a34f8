"""Sheets with known parts, read up to views on shared axes and kept: what a solid is made from.

Benchmarks of what follows the reading need no reader then, and see the same lines each time.
"""

import pickle
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.run.arguments import is_chosen
from benchmarks.sheets.published import sheets_of
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.evidence.dimension_constraints import DimensionConstraints
from gaussiancad_core.evidence.dimension_evidence import dimension_constraints
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.processes.events import Progress, Silence
from gaussiancad_core.recognition.load_sheet import open_sheet
from gaussiancad_core.recognition.views_and_lines import with_unseen
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.read_run import STAGES, sheet_lines
from gaussiancad_core.run.registering_stage import registered_lines
from gaussiancad_protocol.modes import ResultKind


@dataclass(frozen=True, eq=False)
class ReadLines:
    """The views of a sheet under a projection.

    Attributes:
        projection: first or third angle.
        views: their lines, as the solver takes them.
        numbers: what dimensions say, mm; None where they say nothing.
        grid: mm of a px.
    """

    projection: Projection
    views: DrawnViews
    numbers: DimensionConstraints | None
    grid: float


@dataclass(frozen=True, eq=False)
class LineCase:
    """A sheet with what was read of it.

    Attributes:
        name: SOURCE/NAME.
        truth: the part's file.
        assumed: its views under the likelier projection; None where nothing was read.
        other: the same under the other projection, where that is possible.
        refused: code of the error that there was instead.
        reasons: codes of what is in doubt about the reading.
        seconds: of the processor, that the reading took.
    """

    name: str
    truth: Path
    assumed: ReadLines | None
    other: ReadLines | None
    refused: str
    reasons: tuple[str, ...]
    seconds: float


def kept_cases(cases: Path, data: Path, only: tuple[str, ...] = ()) -> Iterator[LineCase]:
    """The sheets of a folder, each kept in another one once it was read.

    Args:
        cases: where they are kept.
        data: folder of sources.
        only: parts of paths; all sheets where there are none.
    """
    cases.mkdir(parents=True, exist_ok=True)
    for sheet in sheets_of(data):
        if not is_chosen(sheet, only):
            continue
        file = cases / f"{sheet.parent.name}-{sheet.stem}.pickle"
        if not file.is_file():
            case = _read(sheet)
            file.write_bytes(pickle.dumps(case))
            print(f"{case.name}: {case.refused or 'read'}", file=sys.stderr, flush=True)
        yield pickle.loads(file.read_bytes())


def _read(sheet: Path) -> LineCase:
    began = time.process_time()
    item = other = None
    refused = ""
    with tempfile.TemporaryDirectory() as folder:
        job = Job(sheet, Path(folder) / "out", result=ResultKind.SOLID)
        notes = RunNotes(Report("", job.settings()), Progress(Silence(), len(STAGES)))
        try:
            opened = open_sheet(job, notes)
            lines = with_unseen(sheet_lines(job, opened, notes), notes)
            found = registered_lines(job, lines, opened.turn, notes)
            item, other = (each and _lines(each) for each in (found.assumed, found.other))
        except GaussianCadError as error:
            refused = error.code
    codes = tuple(reason.code for reason in notes.report.reasons)
    spent = time.process_time() - began
    name = f"{sheet.parent.name}/{sheet.stem}"
    return LineCase(name, sheet.with_suffix(".step"), item, other, refused, codes, spent)


def _lines(reading: ProjectedReading) -> ReadLines:
    registered = reading.registered
    numbers = dimension_constraints(registered, reading.measures, 0.0)
    return ReadLines(reading.projection, reading.drawn, numbers, registered.mm_per_pixel)
