"""How like the part is what comes of other people's sheets, whatever their size in px?

Each sheet that lies beside its true part goes through ``gaussiancad reconstruct --result solid``
with nothing said beyond the sheet. The score is that of the public Ortho2CAD sheets: the volumes'
intersection over union (IoU) after both solids are centred on their centres of mass and scaled to a
radius of gyration of 1, in the best of 24 rotations; a sheet without a solid counts 0.

DIR has SOURCE/NAME.png (or .jpg, .pdf, .dxf) beside SOURCE/NAME.step, the true part. ``--told``
adds options to the command. With ``--widths`` pictures are made so many px wide first, once for
each.

``sized`` counts the solids whose three extents are the part's to 0.5 %.
"""

import argparse
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import mean, median

import cv2
import numpy as np

from benchmarks.run.arguments import add_data, add_running, is_chosen
from benchmarks.run.outcome import Outcome, as_cells, as_table
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
from gaussiancad_core.processes.library_behaviour import silence_opencascade

MINUTES = 15

_PICTURES = (".png", ".jpg")

_HEAD = ("source", "px", "sheets", "solid", "IoU", "of solids", "exact", "verif.", "false", "sized")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    parser.add_argument("--widths", nargs="*", type=int, help="px")
    parser.add_argument("--told", nargs="*", default=[], help="options, such as projection=first")
    add_running(parser, limit_s=120.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")


def run(options: argparse.Namespace) -> Outcome:
    """Run the sheets; print the table."""
    given = [text.partition("=") for text in options.told]
    added = tuple(word for name, _, value in given for word in (f"--{name}", value))
    tasks = [
        Task(Sheet(sheet, options.limit, added, width), options.keep)
        for sheet in sheets_of(options.data)
        if is_chosen(sheet, options.only)
        for width in (options.widths if sheet.suffix in _PICTURES else None) or [None]
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), in_words)
    head, cells = (*_HEAD, "s"), as_cells(list(by_source(rows)))
    print(as_table(head, cells))
    failed = Counter(code for row in rows if "iou" not in row for code in why(row)[:1])
    print("no solid: " + ", ".join(f"{code} {n}" for code, n in failed.most_common()))
    return Outcome(counted(rows), any(map(is_false, rows)), head, cells)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet."""
    silence_opencascade()
    sheet = task.sheet
    with tempfile.TemporaryDirectory() as scratch:
        file = sheet.path
        if sheet.width is not None:
            file = Path(scratch) / file.name
            cv2.imwrite(str(file), resized(cv2.imread(str(sheet.path), 0), sheet.width))
        folder = task.keep / sheet.path.parent.name if task.keep else Path(scratch)
        output = folder / f"{sheet.path.stem}-{sheet.width or 'own'}"
        yield {**ran(sheet, file, output), "stage": "judge"}
        solid = output / "solid.step"
        if solid.is_file():
            yield judged(solid, sheet.part)


def resized(grey: np.ndarray, width: int) -> np.ndarray:
    """(h, w) uint8 a picture at a width in px."""
    factor = width / grey.shape[1]
    if factor == 1.0:
        return grey
    way = cv2.INTER_AREA if factor < 1.0 else cv2.INTER_CUBIC
    return cv2.resize(grey, (width, round(grey.shape[0] * factor)), interpolation=way)


def by_source(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    """The cells of :data:`_HEAD` for each source and width, and for all."""
    for source, width in dict.fromkeys((row["source"], row["width"]) for row in rows):
        these = [row for row in rows if (row["source"], row["width"]) == (source, width)]
        yield _counted(source, width, these)
    yield _counted("all", None, rows)


def _counted(source: str, width: int | None, rows: Sequence[Row]) -> tuple[object, ...]:
    solids = [row for row in rows if "iou" in row]
    return (
        source,
        width or "own",
        len(rows),
        len(solids),
        f"{mean(row.get('iou', 0.0) for row in rows):.3f}",
        f"{mean(row['iou'] for row in solids):.3f}" if solids else "-",
        sum(map(is_the_part, rows)),
        sum(row.get("status") == "verified" for row in rows),
        sum(map(is_false, rows)),
        sum(row["sized"] for row in solids),
        f"{median(row.get('seconds', 0.0) for row in rows):.1f}",
    )
