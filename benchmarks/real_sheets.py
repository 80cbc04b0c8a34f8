"""How far published drawings come whose parts are known.

    .venv/bin/python benchmarks/real_sheets.py --data DIR [--only TEXT ...] [--limit S]
        [--workers N] [--json FILE] [--resume] [--keep DIR]

DIR has SOURCE/NAME.pdf, .png, .jpg or .dxf beside SOURCE/NAME.step, the true part.  Each sheet is
given to ``gaussiancad reconstruct --result solid`` with nothing told.  The table counts, by source:
sheets that ended within the limit; that came to views; whose strokes are those of the file; whose
views all have the roles under which the true part, drawn from its six sides, shows their lines;
whose visible strokes have precision and recall of 0.97 in the worst view; whose scale is right to
0.2 %; that gave a solid; whose solid is the part at one size (``exact``: IoU of 0.99 at least in
the best of 24 orientations); how many of these are ``verified``, and ``false``: called ``verified``
and not the part.  Seconds are medians, of finding the views and in all.  With ``--keep`` a page
shows what failed, by the first stage that went wrong.  Exit code 1 if any was false.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from exact_measures import closeness, fine_mesh, registered
from real_page import write_page
from real_views import fit_of
from resumable import resumed
from workers import FIRST, Row

from gaussiancad_core.kernel.brep import bounding_box, read_shape, read_solid
from gaussiancad_core.modes import Status
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.readings.reading_files import open_reading

SUFFIXES = (".pdf", ".png", ".jpg", ".dxf")

SAME_IOU = 0.99
"""Volumes of which this share is common are one part, drawn to some hundredths of a millimetre."""

_SAME_SCALE = 2e-3

_STROKES = 0.97
"""Precision and recall of visible lines from which the strokes of a view are right."""

_UNREADABLE = 3
"""Exit code of a file that is no drawing."""

_JUDGING_S = 300.0
_SPARE_S = 30.0

COLUMNS = ("sheets", "ended", "views", "file's", "roles", "strokes", "scale", "solid", "exact")
COLUMNS += ("verif.", "false", "views s", "s")
_LINE = "{:20}" + " {:>7}" * len(COLUMNS)
_HEAD = _LINE.format("", *COLUMNS)


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
        return {FIRST: self.limit + _SPARE_S, "views": _JUDGING_S, "judge": _JUDGING_S}


def main() -> int:
    """Run the sheets; print the table."""
    options = _parser().parse_args()
    chosen = [
        Task(sheet, options.limit, options.keep)
        for sheet in sheets_of(options.data)
        if not options.only or any(text in str(sheet) for text in options.only)
    ]
    rows = []
    for row in resumed(chosen, worked, options.workers, options.json, options.resume):
        rows.append(row)
        print(f"{len(rows)}/{len(chosen)} {told(row)}", file=sys.stderr, flush=True)
    print(table(rows))
    if options.keep:
        write_page(options.keep, rows, failed_at)
    return int(any(is_false(row) for row in rows))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--limit", type=float, default=150.0, help="seconds for each sheet")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--json", type=Path, help="file of a JSON object a line, one a sheet")
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")
    return parser


def sheets_of(folder: Path) -> list[Path]:
    """Sheets that have their part beside them, by source and name."""
    return sorted(
        path
        for path in folder.glob("*/*")
        if path.suffix.lower() in SUFFIXES and path.with_suffix(".step").is_file()
    )


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet, bit by bit."""
    silence_opencascade()
    with tempfile.TemporaryDirectory() as scratch:
        folder = task.keep / task.sheet.parent.name if task.keep else Path(scratch)
        output = folder / task.sheet.stem
        yield ran(task, output)
        yield {**read(output), "stage": "views"}
        yield {**placed(output, task.sheet.with_suffix(".step")), "stage": "judge"}
        solid = output / "solid.step"
        if solid.is_file():
            yield judged(solid, task.sheet.with_suffix(".step"))


def ran(task: Task, output: Path) -> Row:
    """How the run ended."""
    command = [sys.executable, "-m", "gaussiancad_core", "reconstruct", str(task.sheet)]
    command += ["--output", str(output), "--result", "solid"]
    began = time.monotonic()
    try:
        process = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=task.limit
        )
    except subprocess.TimeoutExpired:
        return {"exit_code": None, "seconds": task.limit}
    lines = process.stderr.strip().splitlines()
    error = lines[-1] if process.returncode and lines else ""
    return {
        "exit_code": process.returncode,
        "error": error.rsplit("[", 1)[-1].rstrip("]") if error.endswith("]") else error,
        "seconds": time.monotonic() - began,
    }


def read(output: Path) -> Row:
    """What the run's reading and report have."""
    row: Row = {"views": [], "from_file": False}
    reading, report = _json(output / "reading.json"), _json(output / "report.json")
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
        "fitting": {name: asdict(own) for name, own in fit.views.items()},
    }
    if fit.views:
        row["strokes"] = fit.strokes()
    told = _json(output / "report.json").get("scale_mm_per_pixel")
    if told and fit.mm_per_px:
        row["scale_right"] = abs(told / fit.mm_per_px - 1.0) <= _SAME_SCALE
    return row


def judged(solid: Path, part: Path) -> Row:
    """How like the part a solid is, at one size."""
    shape, truth = read_solid(solid), read_solid(part)
    extents = [np.ptp(bounding_box(own), axis=0) for own in (shape, truth)]
    placed, _ = registered(fine_mesh(shape), truth, tuple(float(each) for each in extents[0]))
    close = closeness(shape, placed)
    return {
        "iou": close.iou,
        "faces": close.faces,
        "true_faces": close.true_faces,
        "scale": float(extents[0].max() / extents[1].max()),
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


def told(row: Row) -> str:
    """A line about a sheet."""
    reasons = ", ".join(row.get("reasons", ())) or row.get("error") or row.get("failure", "")
    iou = f"IoU {row['iou']:.4f}" if "iou" in row else "no solid"
    return f"{row['source']}/{row['name']}: {row.get('status', 'not ended')}, {iou} ({reasons})"


def table(rows: Sequence[Row]) -> str:
    """Counts by source and in all; then the codes of what is not the part."""
    sources = dict.fromkeys(row["source"] for row in rows)
    lines = [_HEAD]
    lines += [_counted(own, [row for row in rows if row["source"] == own]) for own in sources]
    lines += [_counted("all", rows)]
    codes = Counter(code for row in rows if not is_exact(row) for code in _codes(row))
    stages = Counter(stage for row in rows if (stage := failed_at(row)))
    lines += ["", "first wrong at: " + ", ".join(f"{own} {n}" for own, n in stages.most_common())]
    lines += ["not the part: " + ", ".join(f"{code} {n}" for code, n in codes.most_common())]
    return "\n".join(lines)


def _codes(row: Row) -> Iterable[str]:
    if row.get("exit_code", 0) is None or "failure" in row:
        return ["over-time"]
    return dict.fromkeys([*row.get("reasons", ()), *([row["error"]] if row.get("error") else [])])


def _counted(name: str, rows: Sequence[Row]) -> str:
    solids = [row for row in rows if "iou" in row]
    exact = [row for row in solids if is_exact(row)]
    views = [row["stages"]["views"] for row in rows if "views" in row.get("stages", {})]
    return _LINE.format(
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


def _json(path: Path) -> dict[str, Any]:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


if __name__ == "__main__":
    sys.exit(main())
