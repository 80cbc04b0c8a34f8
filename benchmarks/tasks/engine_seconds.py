"""Seconds of the engine: of the command, and of reading files without imports."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pypdfium2

from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.files.file_kinds import FileKind
from gaussiancad_core.files.isolation import read_isolated
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.read_run import read_to_file
from gaussiancad_protocol.modes import ResultKind

_WARMING = 3
"""Sheets that are read before any counts: what they import and compile, others need too."""

_EMPTY = 5
"""Times that an empty page is read; the median counts."""


@dataclass(frozen=True)
class Wait:
    """What a run of the command took.

    Attributes:
        solid: s of the clock until the solid is told, or the run ends.
        end: s of the clock until the run ends.
        memory: MB at most; 0 where there is no report.
    """

    solid: float
    end: float
    memory: float


def waited(sheet: Path, output: Path) -> Wait:
    """Reconstruct a sheet in a process of its own, as a user does."""
    command = [sys.executable, "-I", "-m", "gaussiancad_core", "reconstruct", str(sheet)]
    started = time.monotonic()
    process = subprocess.Popen(
        [*command, "--events", "--output", str(output)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        encoding="utf-8",
    )
    assert process.stdout is not None
    solid: float | None = None
    # Standard input stays open: its end would stop the run.
    for line in process.stdout:
        if json.loads(line)["event"] == "solid":
            solid = time.monotonic() - started
    process.wait()
    end = time.monotonic() - started
    report = output / "report.json"
    known = json.loads(report.read_text(encoding="utf-8")) if report.is_file() else {}
    return Wait(end if solid is None else solid, end, float(known.get("peak_memory_mb", 0.0)))


def reading_seconds(sheets: Sequence[Path], folder: Path) -> Iterator[tuple[Path, float]]:
    """PDF files of one page with the processor seconds that reading each takes.

    Counted are those of this process and of the one that opens the file, without imports: some
    sheets are read before any counts, and what the other process takes for an empty page is taken
    off.
    """
    single = [sheet for sheet in sheets if _pages(sheet) == 1]
    for sheet in single[:: max(1, len(single) // _WARMING)][:_WARMING]:
        _seconds(sheet, folder)
    start = float(np.median([_empty_page(folder / "empty.pdf") for _ in range(_EMPTY)]))
    for sheet in single:
        engine, reader = _seconds(sheet, folder)
        yield sheet, engine + max(0.0, reader - start)


def _seconds(sheet: Path, folder: Path) -> tuple[float, float]:
    """Processor s of this process and of its children."""
    before = os.times()
    # Seconds until a sheet is refused count as well.
    with suppress(GaussianCadError):
        read_to_file(Job(sheet=sheet, output=folder, result=ResultKind.SOLID), Silence())
    after = os.times()
    engine = after.user + after.system - before.user - before.system
    reader = after.children_user + after.children_system
    return engine, reader - before.children_user - before.children_system


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
