"""How often is the part found where the reading cannot fail, and where its lines lack something?

Parts are drawn anew in three views in third angle, as DXF files whose layers tell the linetypes,
and go through ``gaussiancad reconstruct --result solid``; their solids are compared with the parts
as ``foreign`` does.  A second time a section stands for hidden lines (``two-and-section``), then
coordinates are rounded as in a PDF (``rounded``), three strokes are lost and one has the wrong
linetype (``strokes-lost``), and hidden lines are left out (``no-hidden-lines``).

DIR has SOURCE/NAME.step; parts of more faces than ``--faces`` are left out.  The table counts, for
each of these: parts; runs that ended within the limit; solids; mean IoU; ``exact``: the part at one
size (IoU of 0.99 at least); of these ``verified``; ``false``: called verified and not the part; and
the median and the 95th percentile of the seconds of the stage that finds the solid.
"""

import argparse
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random
from statistics import mean

import numpy as np

from benchmarks.run.arguments import add_data, add_running, is_chosen
from benchmarks.run.outcome import Figure, Outcome, as_cells, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.sheets.dxf_sheets import write_dxf
from benchmarks.sheets.lacking_sheets import Lack, drawn_lacking
from benchmarks.tasks.sheet_solids import Sheet, in_words, is_false, is_the_part, judged, ran
from benchmarks.tasks.sheet_solids import Task as SolidTask
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_protocol.modes import Status

MINUTES = 120

_HEAD = ("lines", "parts", "ended", "solid", "IoU", "exact", "verif.", "false", "s", "s, 95 %")


@dataclass(frozen=True)
class Task(SolidTask):
    """A part to be drawn, solved and judged.

    Attributes:
        lack: what its lines lack.
    """

    lack: Lack = Lack.NOTHING

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {**self.sheet.known, "lack": self.lack.value}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    parser.add_argument("--lacks", nargs="*", default=[lack.value for lack in Lack], metavar="NAME")
    parser.add_argument("--faces", type=int, default=150, help="of a part, at most")
    add_running(parser, limit_s=120.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")


def run(options: argparse.Namespace) -> Outcome:
    """Run the parts; print the table."""
    parts = [
        path
        for path in sorted(options.data.glob("*/*.step"))
        if is_chosen(path, options.only) and len(faces_of(read_solid(path))) <= options.faces
    ]
    tasks = [
        Task(Sheet(path, options.limit, ("--projection", "third")), options.keep, lack)
        for lack in map(Lack, options.lacks)
        for path in parts
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), _in_words)
    cells = as_cells(list(_by_lack(rows)))
    print(as_table(_HEAD, cells))
    figures = [Figure("falsely verified", sum(map(is_false, rows)))]
    for lack in map(Lack, options.lacks):
        these = [row for row in rows if row["lack"] == lack.value]
        figures.append(share(f"exact, {lack.value}", sum(map(is_the_part, these)), len(these)))
    return Outcome(tuple(figures), any(map(is_false, rows)), _HEAD, cells)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a part."""
    silence_opencascade()
    sheet = task.sheet
    with tempfile.TemporaryDirectory() as scratch:
        folder = task.keep / task.lack.value if task.keep else Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        name = f"{sheet.path.parent.name}-{sheet.path.stem}"
        file, output = folder / f"{name}.dxf", folder / name
        made = drawn_lacking(read_solid(sheet.part), task.lack, Random(name))
        write_dxf(made.lines, Projection.THIRD, file, made.hatching)
        yield {**ran(sheet, file, output), "stage": "judge"}
        solid = output / "solid.step"
        if solid.is_file():
            yield judged(solid, sheet.part)


def _in_words(row: Row) -> str:
    return f"{row['lack']} {in_words(row)}"


def _by_lack(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    for lack in dict.fromkeys(row["lack"] for row in rows):
        these = [row for row in rows if row["lack"] == lack]
        solids = [row for row in these if "iou" in row]
        exact = [row for row in solids if is_the_part(row)]
        seconds = [row["stages"]["solid"] for row in these if "solid" in row.get("stages", {})]
        times = np.percentile(seconds, (50, 95)).tolist() if seconds else ()
        yield (
            lack,
            len(these),
            sum(row.get("exit_code") is not None for row in these),
            len(solids),
            f"{mean(row.get('iou', 0.0) for row in these):.3f}",
            len(exact),
            sum(row.get("status") == Status.VERIFIED.value for row in exact),
            sum(map(is_false, these)),
            *(f"{time:.1f}" for time in times),
        )
