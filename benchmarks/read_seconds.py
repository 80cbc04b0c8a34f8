"""How many processor seconds does it take to read a drawing that is a PDF of one page?

    .venv/bin/python benchmarks/read_seconds.py --data DIR [--only TEXT ...] [--every N]

DIR has SOURCE/NAME.pdf.  Each is read as ``gaussiancad read`` does, one after another, with all
that it writes.  Counted are the seconds of this process and of the one that opens the file, without
imports: the first sheets are read once before, and what the other process takes for an empty page
is taken off.  The table has the median and the 95th percentile of the sheets whose views all have
the strokes of the file, of those that were read from pixels, of those without views, and of all.
"""

import argparse
import os
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pypdfium2

from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.files.file_kinds import FileKind
from gaussiancad_core.files.isolation import read_isolated
from gaussiancad_core.modes import ResultKind
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.read_run import read_to_file

_WARMING = 3
"""Sheets that are read before any counts: what they import and compile, others need too."""

_EMPTY = 5
"""Times that an empty page is read; the median counts."""

KINDS = ("strokes", "pixels", "no views")

_LINE = "{:10} {:>7} {:>10} {:>10} {:>10}"


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


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--every", type=int, default=1, help="of the sheets that are left")
    options = parser.parse_args()
    named = [
        sheet
        for sheet in sorted(options.data.glob("*/*.pdf"))
        if not options.only or any(text in str(sheet) for text in options.only)
    ]
    sheets = [sheet for sheet in named[:: options.every] if _pages(sheet) == 1]
    rows = []
    with tempfile.TemporaryDirectory(prefix="gaussiancad-seconds-") as folder:
        for row in _read(sheets, Path(folder)):
            rows.append(row)
            told = f"{row.kind:8} {row.seconds:6.2f} {row.engine:6.2f} {row.reader:6.2f}"
            print(f"{len(rows)}/{len(sheets)} {told} {row.name}", file=sys.stderr, flush=True)
    print(table(rows))


def table(rows: Sequence[Read]) -> str:
    """Processor seconds by kind and of all."""
    lines = [_LINE.format("told by", "sheets", "median s", "95 % s", "in all s")]
    for kind in (*KINDS, "all"):
        seconds = [row.seconds for row in rows if kind in (row.kind, "all")]
        if seconds:
            numbers = (np.median(seconds), np.percentile(seconds, 95.0), sum(seconds))
            lines.append(_LINE.format(kind, len(seconds), *(f"{own:.2f}" for own in numbers)))
    return "\n".join(lines)


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


if __name__ == "__main__":
    main()
