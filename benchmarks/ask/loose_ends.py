"""How far may the ends of lines be off until the solid is not exact?

Parts of six classes are drawn on clean sheets of 1920 px, the ends of all their lines moved along
them by up to so many px (as in the paper's robustness test), read from the picture and solved.

A row for each strength: sheets that were read, solids that are exact (valid, volume IoU .999 at
least), that are called verified, and false ones: called verified, yet not exact.
"""

import argparse
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.judge.exact_measures import closeness
from benchmarks.parts.exact_cases import Case, classed_cases
from benchmarks.run.arguments import add_running
from benchmarks.run.outcome import Figure, Outcome, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.benchmark_parts import Part, SheetKind, make_sheet
from benchmarks.sheets.exact_inputs import read_input
from benchmarks.tasks.exact_work import falsely_verified, solved
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.samples.classed import PartClass
from gaussiancad_protocol.modes import Status

MINUTES = 20

_STRENGTHS = (
    SheetKind.CLEAN,
    SheetKind.ENDS_1,
    SheetKind.ENDS_2,
    SheetKind.ENDS_3,
    SheetKind.ENDS_5,
    SheetKind.ENDS_8,
)

_LIMIT_S = 600.0
"""s for reading a sheet, and for solving it: what takes longer hangs."""


@dataclass(frozen=True)
class Task:
    """A part whose sheet is of a kind."""

    case: Case
    kind: SheetKind

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"name": self.case.name, "input": self.kind.value}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _LIMIT_S, SOLVE: _LIMIT_S}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--parts", type=int, default=3, help="of each class")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each class")
    add_running(parser)


def run(options: argparse.Namespace) -> Outcome:
    """Solve all sheets; print the table."""
    cases = list(classed_cases(list(PartClass), options.parts, options.seed, 0))
    tasks = [Task(case, kind) for kind in _STRENGTHS for case in cases]
    rows = rows_of(tasks, worked, Running.of(options), lambda row: f"{row['name']} {row['input']}")
    print(_table(rows))
    figures = (
        share(f"exact, {kind.value}", sum(map(solved, some)), len(some))
        for kind in _STRENGTHS
        for some in [[row for row in rows if row["input"] == kind.value]]
    )
    return Outcome((*figures, Figure("falsely verified", sum(map(falsely_verified, rows)))))


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet, bit by bit."""
    silence_opencascade()
    truth = task.case.truth()
    extents = np.ptp(np.array(bounding_box(truth)), axis=0)
    longest = int(np.argmax(extents))
    with tempfile.TemporaryDirectory() as folder:
        path = make_sheet(Part(task.case), truth, task.kind, Path(folder), Path("build"))
        given = read_input(path, (Axis(longest), float(extents[longest])))
    yield {"read": True, "stage": SOLVE}
    result = given.solved()
    exact = result.shape is not None and closeness(result.shape, truth).exact
    yield {"exact": exact, "status": result.status.value}


def _table(rows: list[Row]) -> str:
    cells = []
    for kind in _STRENGTHS:
        some = [row for row in rows if row["input"] == kind.value]
        verified = sum(row.get("status") == Status.VERIFIED.value for row in some)
        false = [row["name"] for row in some if falsely_verified(row)]
        counts = (len(some), sum("read" in row for row in some), sum(map(solved, some)), verified)
        cells.append((kind.value, *counts, len(false), " ".join(false)))
    return as_table(("sheet", "sheets", "read", "exact", "verified", "false", ""), cells)
