"""How exactly published drawings are read from their pixels alone.

    .venv/bin/python benchmarks/real_pictures.py --data DIR [--only TEXT ...] [--skip TEXT ...]
        [--dpi N ...] [--conditions clean scan] [--workers N] [--limit S] [--seen SOURCE ...]
        --json FILE [--resume]

DIR has SOURCE/NAME.pdf.  The truth is the strokes that the engine takes from the file itself; a
sheet is skipped, and told, where these are not all of the file.  Then the page's picture is read,
as drawn or as scanned (turned, blurred, noisy, a JPEG file), with nothing told.

The table has, by source and of all: sheets, those refused, the share of views with their right
names, precision and recall of visible and hidden lines (shares of length: a point counts where a
stroke of the same linetype passes in the same direction within 1 px of the picture at working
scale), the median error, and seconds of processor time.  What is refused counts as lost.
``unseen`` are the sources that the network that labels ink did not learn from.  The JSON file has a
row a line, with the commit: rows of another one do not count when a run goes on.
"""

import argparse
import sys
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
from foreign import commit
from reading_found import Found, found_of, lines_of, read
from resumable import resumed
from sheet_pictures import painted_pdf, scanned
from stroke_matching import Matched, match, overlap
from workers import FIRST, Row

from gaussiancad_core.errors import GaussianCadError, NoModelError
from gaussiancad_core.lines.strokes import DrawnStroke, turned
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.registration.view_registration import scaled

SEEN = ("openeai-arm", "odri", "darkstar", "vzbot-xbeam")
"""Sources of sheets that the shipped network learned from."""

COVERED = 1.0
"""px beside a visible line within which a hidden one does not show."""

_SAME_VIEW = 0.5
"""Share that two boxes of one view have in common at least."""

_FILE_S = 90.0
_HEAD = ("sheets", "refused", "views", "vis P", "vis R", "hid P", "hid R", "med px", "CPU s")
_LINE = "{:26}" + " {:>7}" * len(_HEAD)


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


def main() -> None:
    """Read the pictures; print the table."""
    options = _parser().parse_args()
    tasks = [
        Task(sheet, dpi, Condition(condition), options.limit)
        for dpi, condition in product(options.dpi, options.conditions)
        for sheet in sorted(options.data.glob("*/*.pdf"))
        if not options.only or any(text in str(sheet) for text in options.only)
        if not any(text in str(sheet) for text in options.skip)
    ]
    rows = []
    for row in resumed(tasks, worked, options.workers, options.json, options.resume):
        rows.append(row)
        print(f"{len(rows)}/{len(tasks)} {told(row)}", file=sys.stderr, flush=True)
    print("\n".join(table(rows, options.seen)))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--skip", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--dpi", nargs="*", type=int, default=[150, 200, 300])
    names = [condition.value for condition in Condition]
    parser.add_argument("--conditions", nargs="*", choices=names, default=names)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--limit", type=float, default=240.0, help="seconds for each picture")
    parser.add_argument("--seen", nargs="*", default=SEEN, metavar="SOURCE")
    parser.add_argument("--json", type=Path, required=True)
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    return parser


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
    strokes = {
        role: tuple(turned(own, turn.angle, turn.centre) for own in scaled(view, turn.scale))
        for role, view in truth.strokes.items()
    }
    own = replace(turn, scale=1.0)
    boxes = {
        role: own.box_to_stored(tuple(turn.scale * value for value in box))
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
    lost, _, _ = match(drawn, [], COVERED)
    about = {"commit": commit(), "views": len(truth.boxes), "named": 0}
    yield {**_lengths(lost), **about, "failure": "over-time"}
    try:
        clean, lines = lines_of(image, ReadingOptions())
        spent = time.process_time() - began
        turn = replace(clean.turn, scale=image.reduction)
        found = found_of(lines, turn, ReadingOptions())
    except GaussianCadError as error:
        yield {"failure": error.code, "seconds": time.process_time() - began}
        return
    lengths, errors, _ = match(drawn, _at_working_scale(found, image.reduction), COVERED)
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
    return list(scaled(tuple(chain.from_iterable(found.strokes.values())), 1.0 / reduction))


def _lengths(lengths: dict[Linetype, Matched]) -> Row:
    return {kind.value: asdict(own) for kind, own in lengths.items()}


def told(row: Row) -> str:
    """A line about a picture."""
    name = f"{row['source']}/{row['name']} {row['dpi']} {row['condition']}:"
    if "visible" not in row:
        return f"{name} skipped, {row.get('skipped') or row.get('failure')}"
    shares = " ".join(
        f"{kind.value} {own.precision:.3f}/{own.recall:.3f}"
        for kind in Linetype
        for own in [Matched(**row[kind.value])]
    )
    seconds = row.get("seconds", float("nan"))
    views = f"views {row['named']}/{row['views']}"
    return f"{name} {shares} {views} {seconds:.1f} s {row.get('failure', '')}"


def table(rows: Sequence[Row], seen: Sequence[str]) -> list[str]:
    """Figures by kind of picture and source; then refusals and what was skipped, by code."""
    read_rows = [row for row in rows if "visible" in row]
    lines = ["commit " + ", ".join(dict.fromkeys(row["commit"] for row in read_rows))]
    lines.append(_LINE.format("", *_HEAD))
    for dpi, condition in dict.fromkeys((row["dpi"], row["condition"]) for row in rows):
        own = [row for row in read_rows if (row["dpi"], row["condition"]) == (dpi, condition)]
        lines.append(f"{dpi} dpi, {condition}")
        groups = {source: [r for r in own if r["source"] == source] for source in _sources(own)}
        groups["unseen"] = [row for row in own if row["source"] not in seen]
        groups["all"] = own
        lines += [_LINE.format(name, *_cells(group)) for name, group in groups.items() if group]
    refused = Counter(row["failure"] for row in read_rows if row.get("failure"))
    skipped = Counter(
        row.get("skipped") or row.get("failure") for row in rows if "visible" not in row
    )
    for name, codes in (("refused", refused), ("skipped", skipped)):
        lines.append(f"{name}: " + ", ".join(f"{code} {n}" for code, n in codes.most_common()))
    return lines


def _sources(rows: Sequence[Row]) -> list[str]:
    return sorted({row["source"] for row in rows})


def _cells(rows: Sequence[Row]) -> Iterator[str]:
    yield str(len(rows))
    yield str(sum(bool(row.get("failure")) for row in rows))
    yield f"{sum(row['named'] for row in rows) / sum(row['views'] for row in rows):.3f}"
    for kind in Linetype:
        parts = [Matched(**row[kind.value]) for row in rows]
        total = Matched(*(sum(getattr(part, name) for part in parts) for name in asdict(parts[0])))
        yield f"{total.precision:.4f}"
        yield f"{total.recall:.4f}"
    medians = [row["median_px"] for row in rows if row.get("median_px") is not None]
    yield f"{np.median(medians):.3f}" if medians else "-"
    seconds = [row["seconds"] for row in rows if "seconds" in row]
    yield f"{np.mean(seconds):.1f}" if seconds else "-"


if __name__ == "__main__":
    main()
