"""How far do published drawings come whose parts are known?

Each sheet goes through ``gaussiancad reconstruct --result solid`` with nothing said beyond the
sheet; its reading is laid on the true part, drawn from its six sides, and its solid is compared
with the part at one size, in the best of 24 orientations.

DIR has SOURCE/NAME.pdf, .png, .jpg or .dxf beside SOURCE/NAME.step. The table counts, by source:
sheets that ended within the limit; that came to views; whose strokes are those of the file; whose
views all have the roles under which the true part, drawn from its six sides, shows their lines;
whose visible strokes have precision and recall of 0.97 in the worst view; whose scale is right to
0.2 %; that gave a solid; whose solid is the part at one size (``exact``: IoU of 0.99 at least in
the best of 24 orientations); how many of these are ``verified``, and ``false``: called ``verified``
and not the part. Seconds are medians, of finding the views and in all. With ``--keep`` a page shows
what failed, by the first stage that went wrong. Exit code 1 if any was false.
"""

import argparse
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

from benchmarks.judge.exact_measures import (
    closeness_at_one_size,
    size_of,
)
from benchmarks.judge.real_views import fit_of
from benchmarks.run.arguments import add_data, add_running, is_chosen
from benchmarks.run.engine import JUST_ENDED_S, command_for_solid, read_json
from benchmarks.run.outcome import Figure, Outcome, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import FIRST, Row
from benchmarks.sheets.published import SAME_IOU, sheets_of
from benchmarks.tasks.real_page import write_page
from gaussiancad_core.kernel.brep_files import read_shape, read_solid
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.readings.reading_files import open_reading
from gaussiancad_protocol.modes import Status

MINUTES = 45

_SAME_SCALE = 2e-3

_STROKES = 0.97
"""Precision and recall of visible lines from which the strokes of a view are right."""

_UNREADABLE = 3
"""Exit code of a file that is no drawing."""

_JUDGING_S = 300.0

COLUMNS = ("sheets", "ended", "views", "file's", "roles", "strokes", "scale", "solid", "exact")
COLUMNS += ("verif.", "false", "views s", "s")


@dataclass(frozen=True)
class Task:
    """A sheet with its part.

    Attributes:
        sheet: the file; the part is beside it.
        limit: s of the clock.
        keep: folder for what comes out; None to keep nothing.
    """

    sheet: Path
    limit: float
    keep: Path | None = None

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"source": self.sheet.parent.name, "name": self.sheet.stem}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: self.limit + JUST_ENDED_S, "views": _JUDGING_S, "judge": _JUDGING_S}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    add_running(parser, limit_s=150.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")


def run(options: argparse.Namespace) -> Outcome:
    """Run the sheets; print the table."""
    tasks = [
        Task(sheet, options.limit, options.keep)
        for sheet in sheets_of(options.data)
        if is_chosen(sheet, options.only)
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), in_words)
    print(table(rows))
    if options.keep:
        write_page(options.keep, rows, failed_at)
    false = sum(map(is_false, rows))
    figures = (
        share("the part", sum(map(is_exact, rows)), len(rows)),
        share("views", sum(bool(row.get("views")) for row in rows), len(rows)),
        share("solids", sum("iou" in row for row in rows), len(rows)),
        Figure("falsely verified", false),
    )
    return Outcome(figures, wrong=bool(false))


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet, bit by bit."""
    silence_opencascade()
    with tempfile.TemporaryDirectory() as scratch:
        folder = task.keep / task.sheet.parent.name if task.keep else Path(scratch)
        output = folder / task.sheet.stem
        yield command_for_solid(task.sheet, output, task.limit).row
        yield {**read(output), "stage": "views"}
        yield {**placed(output, task.sheet.with_suffix(".step")), "stage": "judge"}
        solid = output / "solid.step"
        if solid.is_file():
            yield judged(solid, task.sheet.with_suffix(".step"))


def read(output: Path) -> Row:
    """What the run's reading and report have."""
    row: Row = {"views": [], "from_file": False}
    reading, report = read_json(output / "reading.json"), read_json(output / "report.json")
    if reading:
        # Sections and details have a box and a name alone.
        views = [view for view in reading["views"] if "source" in view]
        row["views"] = [view["role"] for view in views]
        sources = {view["source"] for view in views}
        row["from_file"] = bool(sources) and "raster" not in sources
    if report:
        row["status"] = report["status"]
        row["reasons"] = [reason["code"] for reason in report["reasons"]]
        row["stages"] = report["seconds"]
    return row


def placed(output: Path, part: Path) -> Row:
    """How the reading lies on the part: roles, strokes, scale."""
    path = output / "reading.json"
    if not path.is_file():
        return {}
    fit = fit_of(open_reading(path), read_shape(part))
    row: Row = {
        "roles": fit.right,
        "fitting": {name: asdict(view) for name, view in fit.views.items()},
    }
    if fit.views:
        row["strokes"] = fit.strokes()
    stated = read_json(output / "report.json").get("scale_mm_per_pixel")
    if stated and fit.mm_per_px:
        row["scale_right"] = abs(stated / fit.mm_per_px - 1.0) <= _SAME_SCALE
    return row


def judged(solid: Path, part: Path) -> Row:
    """How like the part a solid is, at one size."""
    shape, truth = read_solid(solid), read_solid(part)
    close, _ = closeness_at_one_size(shape, truth)
    return {
        "iou": close.iou,
        "faces": close.faces,
        "true_faces": close.true_faces,
        "scale": max(size_of(shape)) / max(size_of(truth)),
    }


def failed_at(row: Row) -> str:
    """The first stage of the funnel at which a sheet went wrong; empty where none did."""
    strokes = row.get("strokes", (0.0, 0.0))
    stages = (
        ("time", row.get("exit_code", 0) is None or "failure" in row),
        ("file", row.get("exit_code") == _UNREADABLE),
        ("views", not row.get("views")),
        ("roles", not row.get("roles")),
        ("strokes", min(strokes) < _STROKES),
        ("scale", not row.get("scale_right")),
        ("solid", "iou" not in row),
        ("part", not is_exact(row)),
    )
    if is_exact(row) and row.get("scale_right", True):
        return ""
    return next((name for name, wrong in stages if wrong), "")


def is_exact(row: Row) -> bool:
    """Whether a row's solid is the part, at one size."""
    return row.get("iou", 0.0) >= SAME_IOU


def is_false(row: Row) -> bool:
    """Whether a solid was called verified that is not the part."""
    return row.get("status") == Status.VERIFIED.value and not is_exact(row)


def in_words(row: Row) -> str:
    """A line about a sheet."""
    reasons = ", ".join(row.get("reasons", ())) or row.get("error") or row.get("failure", "")
    iou = f"IoU {row['iou']:.4f}" if "iou" in row else "no solid"
    return f"{row['source']}/{row['name']}: {row.get('status', 'not ended')}, {iou} ({reasons})"


def table(rows: Sequence[Row]) -> str:
    """Counts by source and in all; then the codes of what is not the part."""
    sources = dict.fromkeys(row["source"] for row in rows)
    groups = [(name, [row for row in rows if row["source"] == name]) for name in sources]
    lines = [as_table(("", *COLUMNS), [_counted(*group) for group in (*groups, ("all", rows))])]
    codes = Counter(code for row in rows if not is_exact(row) for code in _codes(row))
    stages = Counter(stage for row in rows if (stage := failed_at(row)))
    lines += ["", "first wrong at: " + ", ".join(f"{item} {n}" for item, n in stages.most_common())]
    lines += ["not the part: " + ", ".join(f"{code} {n}" for code, n in codes.most_common())]
    return "\n".join(lines)


def _codes(row: Row) -> Iterable[str]:
    if row.get("exit_code", 0) is None or "failure" in row:
        return ["over-time"]
    return dict.fromkeys([*row.get("reasons", ()), *([row["error"]] if row.get("error") else [])])


def _counted(name: str, rows: Sequence[Row]) -> tuple[object, ...]:
    solids = [row for row in rows if "iou" in row]
    exact = [row for row in solids if is_exact(row)]
    views = [row["stages"]["views"] for row in rows if "views" in row.get("stages", {})]
    return (
        name,
        len(rows),
        sum(row.get("exit_code") is not None for row in rows),
        sum(bool(row.get("views")) for row in rows),
        sum(bool(row.get("from_file")) for row in rows),
        sum(bool(row.get("roles")) for row in rows),
        sum(min(row.get("strokes", (0.0, 0.0))) >= _STROKES for row in rows),
        sum(bool(row.get("scale_right")) for row in rows),
        len(solids),
        len(exact),
        sum(row.get("status") == Status.VERIFIED.value for row in exact),
        sum(is_false(row) for row in rows),
        f"{median(views):.1f}" if views else "-",
        f"{median(row.get('seconds', 0.0) for row in rows):.1f}" if rows else "-",
    )
