"""How many processor seconds does it take to read a drawing that is a PDF of one page?

Each is read as ``gaussiancad read`` does, one after another, with all that it writes. Counted are
the seconds of this process and of the one that opens the file, without imports: the first sheets
are read once before, and what the other process takes for an empty page is taken off.

DIR has SOURCE/NAME.pdf. The table has the median and the 95th percentile of the sheets whose views
all have the strokes of the file, of those that were read from pixels, of those without views, and
of all.
"""

import argparse
import os
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pypdfium2

from benchmarks.run.arguments import add_data, is_chosen, tell
from benchmarks.run.outcome import Figure, Outcome, as_table
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.files.file_kinds import FileKind
from gaussiancad_core.files.isolation import read_isolated
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.read_run import read_to_file
from gaussiancad_protocol.modes import ResultKind

MINUTES = 3

_WARMING = 3
"""Sheets that are read before any counts: what they import and compile, others need too."""

_EMPTY = 5
"""Times that an empty page is read; the median counts."""

KINDS = ("strokes", "pixels", "no views")


@dataclass(frozen=True)
class Read:
    """A sheet that was read.

    Attributes:
        name: with its source.
        kind: by what its views are told, of :data:`KINDS`.
        engine: processor s of the process that reads.
        reader: of the one that opens the file.
    """

    name: str
    kind: str
    engine: float
    reader: float

    @property
    def seconds(self) -> float:
        """Processor s in all."""
        return self.engine + self.reader


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    parser.add_argument("--every", type=int, default=1, help="of the sheets that are left")


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    named = [
        sheet for sheet in sorted(options.data.glob("*/*.pdf")) if is_chosen(sheet, options.only)
    ]
    sheets = [sheet for sheet in named[:: options.every] if _pages(sheet) == 1]
    rows = []
    with tempfile.TemporaryDirectory(prefix="gaussiancad-seconds-") as folder:
        for row in _read(sheets, Path(folder)):
            rows.append(row)
            seconds = f"{row.kind:8} {row.seconds:6.2f} {row.engine:6.2f} {row.reader:6.2f}"
            tell(f"{len(rows)}/{len(sheets)} {seconds} {row.name}")
    print(table(rows))
    if not rows:
        return Outcome()
    middle, most = np.percentile([row.seconds for row in rows], (50.0, 95.0))
    figures = Figure("median", round(middle, 2), "CPU s"), Figure("95 %", round(most, 2), "CPU s")
    return Outcome(figures)


def table(rows: Sequence[Read]) -> str:
    """Processor seconds by kind and of all."""
    cells = []
    for kind in (*KINDS, "all"):
        seconds = [row.seconds for row in rows if kind in (row.kind, "all")]
        if seconds:
            numbers = (np.median(seconds), np.percentile(seconds, 95.0), sum(seconds))
            cells.append((kind, len(seconds), *(f"{number:.2f}" for number in numbers)))
    return as_table(("views by", "sheets", "median s", "95 % s", "in all s"), cells)


def _read(sheets: Sequence[Path], folder: Path) -> Iterator[Read]:
    """Each sheet with its seconds."""
    for sheet in sheets[:: max(1, len(sheets) // _WARMING)][:_WARMING]:
        _seconds(sheet, folder)
    start = float(np.median([_empty_page(folder / "empty.pdf") for _ in range(_EMPTY)]))
    for sheet in sheets:
        kind, engine, reader = _seconds(sheet, folder)
        name = f"{sheet.parent.name}/{sheet.stem}"
        yield Read(name, kind, engine, max(0.0, reader - start))


def _seconds(sheet: Path, folder: Path) -> tuple[str, float, float]:
    """What tells a sheet's views, and processor s of this process and of its children."""
    before = os.times()
    try:
        read = read_to_file(Job(sheet=sheet, output=folder, result=ResultKind.SOLID), Silence())
        kind = _kind(read)
    except GaussianCadError:
        kind = "no views"
    after = os.times()
    engine = after.user + after.system - before.user - before.system
    reader = after.children_user + after.children_system
    return kind, engine, reader - before.children_user - before.children_system


def _kind(read: SheetReading) -> str:
    # Sections and other views that are not used have none.
    sources = {view.source for view in read.views if view.source}
    if not sources:
        return "no views"
    return "strokes" if sources == {"vector"} else "pixels"


def _empty_page(path: Path) -> float:
    """Processor s of the process that opens a file, for an empty page."""
    if not path.exists():
        document = pypdfium2.PdfDocument.new()
        document.new_page(100.0, 100.0)
        document.save(path)
    before = os.times()
    read_isolated(FileKind.PDF, path, 1)
    after = os.times()
    return (
        after.children_user + after.children_system - before.children_user - before.children_system
    )


def _pages(sheet: Path) -> int:
    with pypdfium2.PdfDocument(sheet) as document:
        return len(document)
