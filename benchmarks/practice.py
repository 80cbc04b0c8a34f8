"""How sheets come out that leave hidden lines out, as practice does.

Parts of six classes with measures by lot, each drawn as a section in place of the front view, one
beside it, a half section, an offset section, three views or two with notes at the holes, and, of
turned parts, in one view.  PDF files with dimensions, in first or third angle; the engine is told
nothing.

    .venv/bin/python benchmarks/practice.py [--classes NAME ...] [--kinds KIND ...] [--seeds N]
        [--first N] [--dpi N] [--limit S] [--workers N] [--json FILE] [--resume] [--keep DIR]

``exact``: a valid solid whose volume IoU with the truth is .999 at least, in the best of 24
orientations, at its size.
``assumed right`` and ``wrong``: of those that rest on assumptions; ``false``: called verified and
not exact.  With ``--dpi`` the engine gets a picture of the sheet.  Exit code 1 if any was false.
"""

import argparse
import json
import os
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import product
from pathlib import Path
from random import Random

import numpy as np
import pypdfium2
from exact_measures import closeness, fine_mesh, mirrored_alike, registered
from exact_work import falsely_verified, solved
from practice_parts import CLASSES
from practice_sheets import Practice, write_sheet
from resumable import resumed, tell
from textbook_modelling import Lot
from workers import FIRST, SOLVE, Row

from gaussiancad_core.kernel.brep import bounding_box, faces_of, read_solid
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.modes import ResultKind
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.pipeline import REPORT_FILE, reconstruct
from gaussiancad_core.sheet.reading_options import ReadingOptions

_FIRST_ANGLE = 0.35
"""Share of the sheets that are in first angle."""

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
        first = Random(self.name).random() < _FIRST_ANGLE
        return Projection.FIRST if first else Projection.THIRD


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
        job = Job(sheet, folder, ReadingOptions(), result=ResultKind.SOLID)
        reconstruct(job, Silence())
        report = json.loads((folder / REPORT_FILE).read_text(encoding="utf-8"))
        yield {
            "status": report["status"],
            "reasons": [reason["code"] for reason in report["reasons"]],
            "message": report["reasons"][0]["message"] if report["reasons"] else "",
            "mistaken": report["projection"] != task.projection.value,
            "seconds": sum(report["seconds"].values()),
            "stage": "measure",
        }
        path = folder / "solid.step"
        if path.is_file():
            shape = read_solid(path)
            extents = np.ptp(bounding_box(shape), axis=0)
            size = tuple(float(own) for own in extents)
            # First and third angle may be one part, turned.
            placed, _ = registered(fine_mesh(shape), part.shape, size)
            close = closeness(shape, placed)
            true = float(np.ptp(bounding_box(part.shape), axis=0).max())
            right = abs(max(size) / true - 1.0) <= _SAME_SIZE
            yield {**asdict(close), "exact": close.exact and right, "scale": max(size) / true}
            if not close.exact:
                yield {"mirrored": mirrored_alike(shape, placed)}


def main() -> None:
    """Draw and reconstruct what is asked for; print the table."""
    options = _parser().parse_args()
    # Many small problems side by side: threads of one would only slow down the others.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    tasks = list(_tasks(options))
    rows = []
    for row in resumed(tasks, worked, options.workers, options.json, options.resume):
        rows.append(row)
        tell(row, len(rows), len(tasks))
    print(_table(rows))
    sys.exit(any(map(falsely_verified, rows)))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    kinds = [kind.value for kind in Practice]
    parser.add_argument("--classes", nargs="*", default=list(CLASSES), choices=list(CLASSES))
    parser.add_argument("--kinds", nargs="*", default=kinds, choices=kinds, metavar="KIND")
    parser.add_argument("--seeds", type=int, default=4, help="parts of each class")
    parser.add_argument("--first", type=int, default=0, help="seed to begin with")
    parser.add_argument("--dpi", type=int, default=0, help="give a picture; 0 gives the PDF")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds for each sheet")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--json", type=Path, help="file of a JSON object a line, one a sheet")
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for sheets and results")
    return parser


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    seeds = range(options.first, options.first + options.seeds)
    for seed, model, kind in product(seeds, options.classes, options.kinds):
        how = Practice(kind)
        if how.draws(CLASSES[model](Lot(model, seed))):
            yield Task(model, seed, how, options.dpi, options.limit, options.keep)


def _table(rows: Sequence[Row]) -> str:
    names = ("sheets", "exact", "verified", "false", "right", "wrong", "failed", "med. s", "95% s")
    lines = [f"{'':20}" + "".join(f"{name:>9}" for name in names)]
    kinds = [kind.value for kind in Practice]
    for kind in (*kinds, "all"):
        own = [row for row in rows if kind in (row["input"], "all")]
        if own:
            lines.append(_figures(kind, own))
    codes = Counter(code for row in rows if not solved(row) for code in _causes(row))
    lines.append("not exact: " + ", ".join(f"{code} {n}" for code, n in codes.most_common()))
    return "\n".join(lines)


def _figures(kind: str, rows: Sequence[Row]) -> str:
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
    return (
        f"{kind:20}"
        + "".join(f"{value:9}" for value in counts)
        + "".join(f"{value:9.1f}" for value in times)
    )


def _causes(row: Row) -> list[str]:
    return list(row.get("reasons") or [row.get("failure", "time")])


if __name__ == "__main__":
    main()
