"""How do sheets come out that leave hidden lines out, as practice does?

Parts of six classes with measures by lot, each drawn as a section in place of the front view, one
beside it, a half section, an offset section, three views or two with notes at the holes, and, of
turned parts, in one view.  PDF files with dimensions, in first or third angle; the engine is told
nothing.

``exact``: a valid solid whose volume IoU with the truth is .999 at least, in the best of 24
orientations, at its size.
``assumed right`` and ``wrong``: of those that rest on assumptions; ``false``: called verified and
not exact.  With ``--dpi`` the engine gets a picture of the sheet.  Exit code 1 if any was false.
"""

import argparse
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import product
from pathlib import Path

import numpy as np
import pypdfium2

from benchmarks.judge.exact_measures import (
    closeness_at_one_size,
    mirrored_alike,
    size_of,
)
from benchmarks.parts.practice_parts import CLASSES, Lot
from benchmarks.run.arguments import add_running
from benchmarks.run.outcome import Outcome, as_cells, as_table
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.practice_sheets import Practice, write_sheet
from benchmarks.tasks.exact_work import counted, falsely_verified, in_words, solved
from benchmarks.tasks.sheet_runs import projection_of, solved_sheet
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.sheet.reading_options import ReadingOptions

MINUTES = 10

_HEAD = (
    "", "sheets", "exact", "verified", "false", "assumed right", "wrong", "failed", "median s",
    "95 % s",
)  # fmt: skip

_DRAWING_S = _MEASURING_S = 120.0
_INCH = 72.0

_SAME_SIZE = 1e-3
"""Share by which the size of an exact solid may differ."""


@dataclass(frozen=True)
class Task:
    """A part, told by its class and seed, on a sheet of a kind.

    Attributes:
        model: name of the class.
        seed: of measures.
        how: it is drawn.
        dpi: of the picture that the engine gets; 0 for the PDF file itself.
        limit: s for reading and solving.
        kept: folder for sheets and results; None if nobody wants to look at them.
    """

    model: str
    seed: int
    how: Practice
    dpi: int
    limit: float
    kept: Path | None = None

    @property
    def name(self) -> str:
        """Of the part."""
        return f"{self.model}-{self.seed}"

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"group": self.model, "name": self.name, "input": self.how.value}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _DRAWING_S, SOLVE: self.limit, "measure": _MEASURING_S}

    @property
    def projection(self) -> Projection:
        """First or third angle."""
        return projection_of(self.name)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a task, bit by bit; each bit tells the stage that comes next."""
    silence_opencascade()
    part = CLASSES[task.model](Lot(task.model, task.seed))
    yield {"true_faces": len(faces_of(part.shape))}
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) if task.kept is None else task.kept / task.how.value / task.name
        folder.mkdir(parents=True, exist_ok=True)
        sheet = folder / "sheet.pdf"
        write_sheet(part, task.how, task.projection, task.seed, sheet)
        if task.dpi:
            page = pypdfium2.PdfDocument(sheet)[0]
            sheet = folder / "sheet.png"
            page.render(scale=task.dpi / _INCH).to_pil().save(sheet, dpi=(task.dpi, task.dpi))
        yield {"stage": SOLVE}
        row = solved_sheet(sheet, folder, ReadingOptions(), task.projection)
        yield {**row, "stage": "measure"}
        path = folder / "solid.step"
        if path.is_file():
            shape = read_solid(path)
            # First and third angle may be one part, turned.
            close, placed = closeness_at_one_size(shape, part.shape)
            scale = max(size_of(shape)) / max(size_of(part.shape))
            right = abs(scale - 1.0) <= _SAME_SIZE
            yield {**asdict(close), "exact": close.exact and right, "scale": scale}
            if not close.exact:
                yield {"mirrored": mirrored_alike(shape, placed)}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    kinds = [kind.value for kind in Practice]
    parser.add_argument("--classes", nargs="*", default=list(CLASSES), choices=list(CLASSES))
    parser.add_argument("--kinds", nargs="*", default=kinds, choices=kinds, metavar="KIND")
    parser.add_argument("--seeds", type=int, default=4, help="parts of each class")
    parser.add_argument("--first", type=int, default=0, help="seed to begin with")
    parser.add_argument("--dpi", type=int, default=0, help="give a picture; 0 gives the PDF")
    add_running(parser, limit_s=60.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for sheets and results")


def run(options: argparse.Namespace) -> Outcome:
    """Draw and reconstruct what is asked for; print the table."""
    rows = rows_of(list(_tasks(options)), worked, Running.of(options), in_words)
    cells = as_cells(list(_by_kind(rows)))
    print(as_table(_HEAD, cells))
    codes = Counter(code for row in rows if not solved(row) for code in _causes(row))
    print("not exact: " + ", ".join(f"{code} {count}" for code, count in codes.most_common()))
    return Outcome(counted(rows), any(map(falsely_verified, rows)), _HEAD, cells)


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    seeds = range(options.first, options.first + options.seeds)
    for seed, model, kind in product(seeds, options.classes, options.kinds):
        how = Practice(kind)
        if how.draws(CLASSES[model](Lot(model, seed))):
            yield Task(model, seed, how, options.dpi, options.limit, options.keep)


def _by_kind(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    """The cells of :data:`_HEAD` for each kind of sheet and in all."""
    for kind in (*(kind.value for kind in Practice), "all"):
        these = [row for row in rows if kind in (row["input"], "all")]
        if these:
            yield _figures(kind, these)


def _figures(kind: str, rows: Sequence[Row]) -> tuple[object, ...]:
    exact = sum(map(solved, rows))
    assumed = [row for row in rows if "assumed" in row.get("reasons", ())]
    right = sum(map(solved, assumed))
    counts = (
        len(rows),
        exact,
        sum(row.get("status") == "verified" for row in rows),
        sum(map(falsely_verified, rows)),
        right,
        len(assumed) - right,
        sum(row.get("status", "failed") == "failed" for row in rows),
    )
    seconds = [row["seconds"] for row in rows if "seconds" in row] or [float("nan")]
    times = (float(np.median(seconds)), float(np.percentile(seconds, 95)))
    return kind, *counts, *(f"{seconds:.1f}" for seconds in times)


def _causes(row: Row) -> list[str]:
    return list(row.get("reasons") or [row.get("failure", "time")])
