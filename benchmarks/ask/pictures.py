"""How exactly are published drawings read from their pixels alone, and their ink labelled?

The truth is the strokes that the engine takes from the file itself; a sheet is skipped, and named,
where these are not all of the file. The page's picture is read, as drawn or as scanned (turned,
blurred, noisy, a JPEG file), with nothing said beyond it. With ``--labelled`` each pixel of ink of
other pictures is compared with what it is known to be.

DIR has SOURCE/NAME.pdf. The table has, by source and of all: sheets, those refused, the share of
views with their right names, precision and recall of visible and hidden lines (shares of length: a
point counts where a stroke of the same linetype passes in the same direction within 1 px of the
picture at working scale), the median error, and seconds of processor time. What is refused counts
as lost. ``unseen`` are the sources that the network that labels ink did not learn from. Pictures
whose ink is known are told of in :mod:`benchmarks.tasks.labelled_pictures`.
"""

import argparse
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from enum import Enum
from itertools import chain, product
from pathlib import Path
from zlib import crc32

import cv2
import numpy as np

from benchmarks.judge.reading_found import Found, found_of, lines_of, read
from benchmarks.judge.stroke_matching import Matched, match, overlap, total
from benchmarks.run.arguments import add_data, add_running, existing_folder, is_chosen
from benchmarks.run.outcome import Figure, Outcome, as_cells, as_table
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import FIRST, Row
from benchmarks.sheets.sheet_pictures import painted_pdf, scanned
from benchmarks.tasks.labelled_pictures import labelled_figures
from gaussiancad_core.errors import GaussianCadError, NoModelError
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions

MINUTES = 20

SEEN = ("openeai-arm", "odri", "darkstar", "vzbot-xbeam")
"""Sources of sheets that the shipped network learned from."""

COVERED = 1.0
"""px beside a visible line within which a hidden one does not show."""

_SAME_VIEW = 0.5
"""Share that two boxes of one view have in common at least."""

_FILE_S = 90.0
_HEAD = ("sheets", "refused", "views", "vis P", "vis R", "hid P", "hid R", "med px", "CPU s")


class Condition(Enum):
    """What became of a picture."""

    CLEAN = "clean"
    SCAN = "scan"


@dataclass(frozen=True)
class Task:
    """A sheet's picture.

    Attributes:
        sheet: the PDF.
        dpi: of its picture.
        condition: of its picture.
        limit: s for reading it.
    """

    sheet: Path
    dpi: int
    condition: Condition
    limit: float

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {
            "source": self.sheet.parent.name,
            "name": self.sheet.stem,
            "dpi": self.dpi,
            "condition": self.condition.value,
        }

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _FILE_S, "picture": self.limit}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    parser.add_argument("--skip", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--dpi", nargs="*", type=int, default=[200])
    parser.add_argument("--labelled", type=existing_folder, help="pictures whose ink is known")
    names = [condition.value for condition in Condition]
    parser.add_argument("--conditions", nargs="*", choices=names, default=names)
    add_running(parser, limit_s=240.0)
    parser.add_argument("--seen", nargs="*", default=SEEN, metavar="SOURCE")


def run(options: argparse.Namespace) -> Outcome:
    """Read the pictures; print the table."""
    tasks = [
        Task(sheet, dpi, Condition(condition), options.limit)
        for dpi, condition in product(options.dpi, options.conditions)
        for sheet in sorted(options.data.glob("*/*.pdf"))
        if is_chosen(sheet, options.only) and not any(text in str(sheet) for text in options.skip)
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), in_words)
    head, recorded = ("", *_HEAD), as_cells(list(by_source(rows, options.seen)))
    print("\n".join([as_table(head, recorded), *left_out(rows)]))
    read_rows = [row for row in rows if "visible" in row]
    figures: tuple[Figure, ...] = ()
    if read_rows:
        cells = zip(_HEAD, _cells(read_rows), strict=True)
        figures = tuple(Figure(name, value) for name, value in cells)
    if options.labelled is not None:
        figures += labelled_figures(options.labelled)
    return Outcome(figures, head=head, rows=recorded)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a picture, bit by bit."""
    cv2.setNumThreads(1)
    with tempfile.TemporaryDirectory() as folder:
        try:
            path, truth = pictured(task, Path(folder))
        except GaussianCadError as error:
            yield {"skipped": error.code}
            return
        yield {"stage": "picture"}
        yield from compared(path, truth)


def pictured(task: Task, folder: Path) -> tuple[Path, Found]:
    """The file of a sheet's picture in a folder, and what the sheet's own file has, in px of it.

    Raises:
        GaussianCadError: the sheet cannot be read; ``not-the-file's-lines``.
    """
    image = read_sheet(task.sheet)
    truth = read(task.sheet, ReadingOptions())
    if image.pixels_per_inch is None or truth.direct_views < len(truth.strokes):
        raise NoModelError("not-the-file's-lines", "not all lines are the file's own")
    grey = painted_pdf(task.sheet, task.dpi)
    turn = Turn(0.0, (grey.shape[1] / 2, grey.shape[0] / 2), task.dpi / image.pixels_per_inch)
    path = folder / f"{task.sheet.stem}.png"
    if task.condition is Condition.SCAN:
        path = path.with_suffix(".jpg")
        turn = scanned(grey, crc32(task.sheet.stem.encode()), turn, path)
    else:
        cv2.imwrite(str(path), grey)
    return path, in_picture(truth, turn)


def in_picture(truth: Found, turn: Turn) -> Found:
    """What the file has, in px of the picture.

    Args:
        truth: in px of the file's own picture.
        turn: how much larger the picture is, and then by what it is turned.
    """
    centre = turn.centre
    origin = centre[0] / turn.scale, centre[1] / turn.scale
    to_picture = Similarity(turn.scale, turn.angle, origin=origin, offset=centre)
    strokes = {
        role: tuple(item.mapped(to_picture) for item in view)
        for role, view in truth.strokes.items()
    }
    entry = replace(turn, scale=1.0)
    boxes = {
        role: entry.box_to_stored(tuple(turn.scale * value for value in box))
        for role, box in truth.boxes.items()
    }
    return replace(truth, strokes=strokes, boxes=boxes)


def compared(path: Path, truth: Found) -> Iterator[Row]:
    """The figures of a picture, first as if nothing were read.

    Args:
        path: of the picture.
        truth: in px of it.
    """
    began = time.process_time()
    image = read_sheet(path)
    drawn = _at_working_scale(truth, image.reduction)
    lost, _ = match(drawn, [], COVERED)
    about = {"views": len(truth.boxes), "named": 0}
    yield {**_lengths(lost), **about, "failure": "over-time"}
    try:
        clean, lines = lines_of(image, ReadingOptions())
        spent = time.process_time() - began
        turn = replace(clean.turn, scale=image.reduction)
        found = found_of(lines, turn, ReadingOptions())
    except GaussianCadError as error:
        yield {"failure": error.code, "seconds": time.process_time() - began}
        return
    lengths, errors = match(drawn, _at_working_scale(found, image.reduction), COVERED)
    named = [
        role
        for role, box in truth.boxes.items()
        if role in found.boxes and overlap(box, found.boxes[role]) > _SAME_VIEW
    ]
    yield {
        **_lengths(lengths),
        "named": len(named),
        "median_px": float(np.median(errors)) if len(errors) else None,
        "seconds": spent,
        "failure": "",
    }


def _at_working_scale(found: Found, reduction: float) -> list[DrawnStroke]:
    smaller = Similarity(1.0 / reduction)
    return [item.mapped(smaller) for item in chain.from_iterable(found.strokes.values())]


def _lengths(lengths: dict[Linetype, Matched]) -> Row:
    return {kind.value: asdict(length) for kind, length in lengths.items()}


def in_words(row: Row) -> str:
    """A line about a picture."""
    name = f"{row['source']}/{row['name']} {row['dpi']} {row['condition']}:"
    if "visible" not in row:
        return f"{name} skipped, {row.get('skipped') or row.get('failure')}"
    shares = " ".join(
        f"{kind.value} {item.precision:.3f}/{item.recall:.3f}"
        for kind in Linetype
        for item in [Matched(**row[kind.value])]
    )
    seconds = row.get("seconds", float("nan"))
    views = f"views {row['named']}/{row['views']}"
    return f"{name} {shares} {views} {seconds:.1f} s {row.get('failure', '')}"


def by_source(rows: Sequence[Row], seen: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """The cells of :data:`_HEAD` by kind of picture and source."""
    known = [row for row in rows if "visible" in row]
    for dpi, condition in dict.fromkeys((row["dpi"], row["condition"]) for row in known):
        these = [row for row in known if (row["dpi"], row["condition"]) == (dpi, condition)]
        groups = {name: [r for r in these if r["source"] == name] for name in _sources(these)}
        groups["unseen"] = [row for row in these if row["source"] not in seen]
        groups["all"] = these
        for name, group in groups.items():
            if group:
                yield f"{name}, {dpi} dpi, {condition}", *_cells(group)


def left_out(rows: Sequence[Row]) -> Iterator[str]:
    """What was refused and what was skipped, by code."""
    refused = Counter(row["failure"] for row in rows if "visible" in row and row.get("failure"))
    skipped = Counter(
        row.get("skipped") or row.get("failure") for row in rows if "visible" not in row
    )
    for name, codes in (("refused", refused), ("skipped", skipped)):
        yield f"{name}: " + ", ".join(f"{code} {n}" for code, n in codes.most_common())


def _sources(rows: Sequence[Row]) -> list[str]:
    return sorted({row["source"] for row in rows})


def _cells(rows: Sequence[Row]) -> Iterator[str]:
    yield str(len(rows))
    yield str(sum(bool(row.get("failure")) for row in rows))
    yield f"{sum(row['named'] for row in rows) / sum(row['views'] for row in rows):.3f}"
    for kind in Linetype:
        lengths = total([Matched(**row[kind.value]) for row in rows])
        yield f"{lengths.precision:.4f}"
        yield f"{lengths.recall:.4f}"
    medians = [row["median_px"] for row in rows if row.get("median_px") is not None]
    yield f"{np.median(medians):.3f}" if medians else "-"
    seconds = [row["seconds"] for row in rows if "seconds" in row]
    yield f"{np.mean(seconds):.1f}" if seconds else "-"
