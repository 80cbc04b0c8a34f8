"""How many sheets does a core-hour of ``gaussiancad batch`` solve, and does it keep its pace?

Small parts of the classes are drawn as sheets, all different, and put through batches with one
worker, two, and so on.  The table has seconds and sheets per core-hour, how many times as fast as
one worker that is, the seconds of a sheet at the median in the first and the last tenth of the
batch, and the memory of the batch's own process then (MB); ``start`` is what a sheet takes before
it is read, by the seconds that its report does not account for.  Last the seconds of ``--resume``
of the finished batch.  Exit code 1 if a batch lost a sheet, or resuming did one again.
"""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import psutil

from benchmarks.parts.exact_cases import classed_cases
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples.classed import PartClass

MINUTES = 10

_CLASSES = (PartClass.PLANES, PartClass.HOLES, PartClass.SLANTS, PartClass.FILLETS)
_LINE = "{:>7} {:>9} {:>12} {:>7} {:>12} {:>12} {:>9} {:>9} {:>7}"
_HEAD = _LINE.format(
    "workers",
    "seconds",
    "core-hour",
    "times",
    "first s",
    "last s",
    "first MB",
    "last MB",
    "start s",
)


@dataclass(frozen=True)
class Told:
    """What one sheet's event told, and when.

    Attributes:
        seconds: of the sheet's process.
        memory: MB of the batch's own process.
        start: s that the sheet's report does not account for.
    """

    seconds: float
    memory: float
    start: float


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--sheets", type=int, default=40)
    parser.add_argument("--workers", type=int, nargs="*", default=[1, 2])
    parser.add_argument("--result", default="solid", choices=["solid", "surface", "both"])
    parser.add_argument("--seed", type=int, default=0)


def run(options: argparse.Namespace) -> Outcome:
    """Draw the sheets, run the batches, print the table."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "sheets"
        draw_sheets(folder, options.sheets, options.seed)
        print(f"{options.sheets} sheets, --result {options.result}\n\n{_HEAD}", flush=True)
        first, lost, figures = 0.0, False, []
        for workers in options.workers:
            output = Path(scratch) / f"out{workers}"
            seconds, events = batch(folder, output, workers, options.result)
            first = first or seconds
            lost |= len(events) != options.sheets or len(rows(output)) != options.sheets
            print(line(workers, seconds, first, events), flush=True)
            pace = 3600.0 * len(events) / seconds / workers
            figures.append(Figure(f"with {workers} workers", round(pace), "sheets a core-hour"))
        before = {path: path.stat().st_mtime_ns for path in output.glob("*/report.json")}
        seconds, _ = batch(folder, output, options.workers[-1], options.result, "--resume")
        lost |= before != {path: path.stat().st_mtime_ns for path in output.glob("*/report.json")}
        print(f"\n{'sheets were lost, or done again' if lost else 'no sheet was lost'}")
    return Outcome((*figures, Figure("resumed in", round(seconds, 1), "s")), wrong=lost)


def draw_sheets(folder: Path, count: int, seed: int) -> None:
    """Put so many different sheets into a folder."""
    folder.mkdir(parents=True)
    each = -(-count // len(_CLASSES))
    for number, case in enumerate(list(classed_cases(_CLASSES, each, 0, seed))[:count]):
        sheet = draw_sheet(case.truth(), ROLES, Projection.THIRD, parse_style("clean"), number)
        write_image(sheet.image, folder / f"{number:04}.png", 95, sheet.dpi)


def batch(
    folder: Path, output: Path, workers: int, result: str, *more: str
) -> tuple[float, list[Told]]:
    """Seconds of a batch, and what was told of its sheets as they ended."""
    command = [sys.executable, "-m", "gaussiancad_core", "batch", str(folder), "--events"]
    command += ["--output", str(output), "--workers", str(workers), "--result", result, *more]
    began = time.monotonic()
    found = []
    streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen(command, text=True, **streams) as process:
        this_process = psutil.Process(process.pid)
        for text in process.stdout:
            event = json.loads(text)
            if event["event"] == "sheet":
                memory = this_process.memory_info().rss / 2**20
                found.append(Told(event["seconds"], memory, _start(event)))
    return time.monotonic() - began, found


def _start(event: dict) -> float:
    path = Path(event["folder"]) / "report.json"
    if not path.is_file():
        return 0.0
    spent = json.loads(path.read_text(encoding="utf-8"))["seconds"]
    return event["seconds"] - sum(spent.values())


def rows(output: Path) -> list[dict[str, str]]:
    """The lines of a batch's report."""
    with (output / "report.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def line(workers: int, seconds: float, first: float, stated: Sequence[Told]) -> str:
    """A line of the table."""
    tenth = max(1, len(stated) // 10)
    ends = stated[:tenth], stated[-tenth:]
    return _LINE.format(
        workers,
        f"{seconds:.1f}",
        f"{3600.0 * len(stated) / seconds / workers:.0f}",
        f"{first / seconds:.2f}",
        *(f"{median(item.seconds for item in part):.1f}" for part in ends),
        *(f"{median(item.memory for item in part):.0f}" for part in ends),
        f"{median(item.start for item in stated):.1f}",
    )
