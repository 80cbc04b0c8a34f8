"""How far do published drawings come whose parts are known: reading, lines, part and size?

Each sheet goes through ``gaussiancad reconstruct --result solid`` with nothing said beyond the
sheet; its reading is laid on the true part, drawn from its six sides, and its solid is compared
with the part as ``foreign`` does.

DIR has SOURCE/NAME.pdf, .png, .jpg or .dxf beside SOURCE/NAME.step. The table counts, by source:
sheets that ended within the limit; that came to views; whose strokes are those of the file; whose
views all have the roles under which the true part, drawn from its six sides, shows their lines;
whose visible strokes have precision and recall of 0.97 in the worst view; whose scale is right to
0.2 %; that gave a solid; whose solid is the part at one size (``exact``: IoU of 0.99 at least); how
many of these are ``verified``, and ``false``: called ``verified`` and not the part; whose three
extents are the part's to 0.5 % (``sized``). Seconds are medians, of finding the views and in all.
The last lines tell at which stage sheets first went wrong. Exit code 1 if any was false.
"""

import argparse
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from statistics import median

from benchmarks.judge.real_views import fit_of
from benchmarks.run.arguments import add_data, add_running, is_chosen
from benchmarks.run.engine import read_json
from benchmarks.run.outcome import Outcome, as_cells, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.sheets.published import sheets_of
from benchmarks.tasks.sheet_solids import (
    Sheet,
    Task,
    counted,
    in_words,
    is_false,
    is_the_part,
    judged,
    ran,
    why,
)
from gaussiancad_core.kernel.brep_files import read_shape
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.readings.reading_files import open_reading

MINUTES = 60

_SAME_SCALE = 2e-3

_STROKES = 0.97
"""Precision and recall of visible lines from which the strokes of a view are right."""

_UNREADABLE = 3
"""Exit code of a file that is no drawing."""

COLUMNS = ("sheets", "ended", "views", "file's", "roles", "strokes", "scale", "solid", "exact")
COLUMNS += ("verif.", "false", "sized", "views s", "s")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    add_running(parser, limit_s=150.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")


def run(options: argparse.Namespace) -> Outcome:
    """Run the sheets; print the table."""
    tasks = [
        Task(Sheet(sheet, options.limit), options.keep)
        for sheet in sheets_of(options.data)
        if is_chosen(sheet, options.only)
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), in_words)
    head, cells = ("", *COLUMNS), as_cells(list(by_source(rows)))
    print("\n".join([as_table(head, cells), "", *reasons(rows)]))
    read = [
        share("all views have their roles", sum(bool(row.get("roles")) for row in rows), len(rows)),
        share("lines are the part's", sum(map(_has_lines, rows)), len(rows)),
        share("scale right", sum(bool(row.get("scale_right")) for row in rows), len(rows)),
    ]
    return Outcome((*counted(rows), *read), any(map(is_false, rows)), head, cells)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet, bit by bit."""
    silence_opencascade()
    sheet = task.sheet
    with tempfile.TemporaryDirectory() as scratch:
        folder = task.keep / sheet.path.parent.name if task.keep else Path(scratch)
        output = folder / sheet.path.stem
        row = ran(sheet, sheet.path, output)
        yield row
        yield {**_read(output), "stage": "views"}
        yield {**_placed(output, sheet.part, row.get("scale_mm_per_px")), "stage": "judge"}
        solid = output / "solid.step"
        if solid.is_file():
            yield judged(solid, sheet.part)


def _read(output: Path) -> Row:
    """What the run's reading has."""
    reading = read_json(output / "reading.json")
    # Sections and details have a box and a name alone.
    views = [view for view in reading.get("views", ()) if "source" in view]
    sources = {view["source"] for view in views}
    return {
        "views": [view["role"] for view in views],
        "from_file": bool(sources) and "raster" not in sources,
    }


def _placed(output: Path, part: Path, mm_per_px: float | None) -> Row:
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
    if mm_per_px and fit.mm_per_px:
        row["scale_right"] = abs(mm_per_px / fit.mm_per_px - 1.0) <= _SAME_SCALE
    return row


def _has_lines(row: Row) -> bool:
    return min(row.get("strokes", (0.0, 0.0))) >= _STROKES


def failed_at(row: Row) -> str:
    """The first stage of the funnel at which a sheet went wrong; empty where none did."""
    stages = (
        ("time", row.get("exit_code", 0) is None or "failure" in row),
        ("file", row.get("exit_code") == _UNREADABLE),
        ("views", not row.get("views")),
        ("roles", not row.get("roles")),
        ("strokes", not _has_lines(row)),
        ("scale", not row.get("scale_right")),
        ("solid", "iou" not in row),
        ("part", not is_the_part(row)),
    )
    if is_the_part(row) and row.get("scale_right", True):
        return ""
    return next((name for name, wrong in stages if wrong), "")


def by_source(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    """The cells of :data:`COLUMNS` for each source and in all."""
    for source in dict.fromkeys(row["source"] for row in rows):
        yield _counted(source, [row for row in rows if row["source"] == source])
    yield _counted("all", rows)


def reasons(rows: Sequence[Row]) -> list[str]:
    """Where sheets first went wrong, and the codes of what is not the part."""
    stages = Counter(stage for row in rows if (stage := failed_at(row)))
    codes = Counter(code for row in rows if not is_the_part(row) for code in why(row))
    return [
        "first wrong at: " + ", ".join(f"{item} {n}" for item, n in stages.most_common()),
        "not the part: " + ", ".join(f"{code} {n}" for code, n in codes.most_common()),
    ]


def _counted(name: str, rows: Sequence[Row]) -> tuple[object, ...]:
    solids = [row for row in rows if "iou" in row]
    exact = [row for row in solids if is_the_part(row)]
    views = [row["stages"]["views"] for row in rows if "views" in row.get("stages", {})]
    return (
        name,
        len(rows),
        sum(row.get("exit_code") is not None for row in rows),
        sum(bool(row.get("views")) for row in rows),
        sum(bool(row.get("from_file")) for row in rows),
        sum(bool(row.get("roles")) for row in rows),
        sum(map(_has_lines, rows)),
        sum(bool(row.get("scale_right")) for row in rows),
        len(solids),
        len(exact),
        sum(row.get("status") == "verified" for row in exact),
        sum(map(is_false, rows)),
        sum(row["sized"] for row in solids),
        f"{median(views):.1f}" if views else "-",
        f"{median(row.get('seconds', 0.0) for row in rows):.1f}" if rows else "-",
    )
