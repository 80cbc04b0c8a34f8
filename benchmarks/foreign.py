"""How like the part is what comes of other people's sheets, and does their size in px matter?

    .venv/bin/python benchmarks/foreign.py --data DIR [--only TEXT ...] [--widths PX ...]
        [--workers N] [--limit S] [--told ARG ...] --json FILE

DIR has SOURCE/NAME.png (or .jpg, .pdf, .dxf) beside SOURCE/NAME.step, the true part.  Each sheet
goes to ``gaussiancad reconstruct --result solid`` with nothing told but what ``--told`` adds.
With ``--widths`` pictures are made so many px wide first, once for each.

The score is that of the public Ortho2CAD sheets: the volumes' intersection over union (IoU) after
both solids are centred on their centres of mass and scaled to a radius of gyration of 1, in the
best of 24 rotations; a sheet without a solid counts 0.  ``sized`` counts the solids whose three
extents are the part's to 0.5 %.  The file has the commit, the table, and a row for each run.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean, median
from typing import Any

import cv2
import numpy as np
import trimesh
from exact_measures import fine_mesh, mesh_iou, rotations
from real_sheets import SAME_IOU, sheets_of
from workers import FIRST, Row, run_all

from gaussiancad_core.kernel.brep import bounding_box, read_shape, read_solid
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.processes.library_behaviour import silence_opencascade

_SAME_EXTENT = 5e-3
"""Share by which an extent may differ from the one that the sheet states."""

_JUDGING_S = 120.0
_SPARE_S = 30.0
_PICTURES = (".png", ".jpg")

_HEAD = ("source", "px", "sheets", "solid", "IoU", "of solids", "exact", "verif.", "false", "sized")
_LINE = "{:16}" + " {:>9}" * len(_HEAD)


@dataclass(frozen=True)
class Task:
    """A sheet at a width.

    Attributes:
        sheet: the file; the part is beside it.
        width: px that the picture is made wide; None as it is.
        told: further arguments.
        limit: s of the clock.
        keep: folder for what comes out; None to keep nothing.
    """

    sheet: Path
    width: int | None
    told: tuple[str, ...]
    limit: float
    keep: Path | None = None

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"source": self.sheet.parent.name, "name": self.sheet.stem, "width": self.width}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: self.limit + _SPARE_S, "judge": _JUDGING_S}


def main() -> int:
    """Run the sheets; print the table, write the file."""
    options = _parser().parse_args()
    tasks = [
        Task(sheet, width, tuple(options.told), options.limit, options.keep)
        for sheet in sheets_of(options.data)
        if not options.only or any(text in str(sheet) for text in options.only)
        for width in (options.widths if sheet.suffix in _PICTURES else None) or [None]
    ]
    rows = []
    for _, row in run_all(tasks, worked, options.workers):
        rows.append(row)
        print(f"{len(rows)}/{len(tasks)} {_told(row)}", file=sys.stderr, flush=True)
    rows.sort(key=lambda row: (row["source"], row["name"], row["width"] or 0))
    told = table(rows)
    print(told)
    result = {"commit": commit(), "told": options.told, "table": told.splitlines(), "rows": rows}
    options.json.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return int(any(is_false(row) for row in rows))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--widths", nargs="*", type=int, help="px")
    parser.add_argument("--told", nargs="*", default=[], help="arguments, such as projection=first")
    parser.add_argument("--limit", type=float, default=120.0, help="seconds for each sheet")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--json", type=Path, required=True)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")
    return parser


def commit() -> str:
    """What the checkout is at, with ``+`` where it was changed since."""
    root = Path(__file__).resolve().parent
    told = [["git", "rev-parse", "--short", "HEAD"], ["git", "status", "--porcelain", "-uno"]]
    name, changed = (
        subprocess.run(own, cwd=root, capture_output=True, text=True, check=False).stdout.strip()
        for own in told
    )
    return name + ("+" if changed else "")


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet."""
    silence_opencascade()
    with tempfile.TemporaryDirectory() as scratch:
        sheet = task.sheet
        if task.width is not None:
            sheet = Path(scratch) / task.sheet.name
            cv2.imwrite(str(sheet), resized(cv2.imread(str(task.sheet), 0), task.width))
        folder = task.keep / task.sheet.parent.name if task.keep else Path(scratch)
        output = folder / f"{task.sheet.stem}-{task.width or 'own'}"
        yield {**_ran(task, sheet, output), "stage": "judge"}
        solid = output / "solid.step"
        if solid.is_file():
            yield judged(solid, task.sheet.with_suffix(".step"))


def resized(grey: np.ndarray, width: int) -> np.ndarray:
    """(h, w) uint8 a picture at a width in px."""
    factor = width / grey.shape[1]
    if factor == 1.0:
        return grey
    way = cv2.INTER_AREA if factor < 1.0 else cv2.INTER_CUBIC
    return cv2.resize(grey, (width, round(grey.shape[0] * factor)), interpolation=way)


def _ran(task: Task, sheet: Path, output: Path) -> Row:
    command = [sys.executable, "-m", "gaussiancad_core", "reconstruct", str(sheet)]
    command += ["--output", str(output), "--result", "solid"]
    for told in task.told:
        name, _, value = told.partition("=")
        command += [f"--{name}", *([value] if value else [])]
    began = time.monotonic()
    try:
        process = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=task.limit
        )
    except subprocess.TimeoutExpired:
        return {"exit_code": None, "seconds": task.limit}
    lines = process.stderr.strip().splitlines()
    error = lines[-1] if process.returncode and lines else ""
    row: Row = {
        "exit_code": process.returncode,
        "error": error.rsplit("[", 1)[-1].rstrip("]") if error.endswith("]") else error,
        "seconds": time.monotonic() - began,
    }
    report = output / "report.json"
    if report.is_file():
        told: dict[str, Any] = json.loads(report.read_text(encoding="utf-8"))
        row["status"] = told["status"]
        row["reasons"] = [reason["code"] for reason in told["reasons"]]
        row["views"] = sorted(told["views"])
        row["projection"] = told["projection"]
        row["scale_source"] = told["scale_source"]
        row["stages"] = told["seconds"]
    return row


def judged(solid: Path, part: Path) -> Row:
    """The score of a solid, and whether its extents are the part's."""
    shape, truth = read_shape(solid), read_solid(part)
    extents = [np.sort(np.ptp(bounding_box(own), axis=0)) for own in (shape, truth)]
    own, true = normalised(fine_mesh(shape)), normalised(fine_mesh(truth))
    scores = [
        mesh_iou(own, make_mesh(true.vertices @ matrix.T, true.triangles)) or 0.0
        for matrix in rotations()
    ]
    return {
        "iou": max(scores),
        "extents": extents[0].tolist(),
        "true_extents": extents[1].tolist(),
        "sized": bool((np.abs(extents[0] / extents[1] - 1.0) <= _SAME_EXTENT).all()),
    }


def normalised(mesh: TriangleMesh) -> TriangleMesh:
    """A solid with its centre of mass at the origin and a radius of gyration of 1."""
    solid = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    about = solid.moment_inertia
    gyration = np.sqrt(0.5 * np.trace(about) / solid.volume)
    return make_mesh((mesh.vertices - solid.center_mass) / gyration, mesh.triangles)


def is_false(row: Row) -> bool:
    """Whether a solid was called verified that is not the part."""
    return row.get("status") == "verified" and row.get("iou", 0.0) < SAME_IOU


def table(rows: Sequence[Row]) -> str:
    """Scores by source and width, then where the sheets without a solid ended."""
    lines = [_LINE.format("", *_HEAD[1:], "s")]
    for source, width in dict.fromkeys((row["source"], row["width"]) for row in rows):
        own = [row for row in rows if (row["source"], row["width"]) == (source, width)]
        lines.append(_counted(source, width, own))
    failed: dict[str, int] = {}
    for row in rows:
        if "iou" not in row:
            code = row.get("error") or row.get("failure") or "over-time"
            failed[code] = failed.get(code, 0) + 1
    lines.append("no solid: " + ", ".join(f"{code} {count}" for code, count in failed.items()))
    return "\n".join(lines)


def _counted(source: str, width: int | None, rows: Sequence[Row]) -> str:
    solids = [row for row in rows if "iou" in row]
    return _LINE.format(
        source,
        width or "own",
        len(rows),
        len(solids),
        f"{mean(row.get('iou', 0.0) for row in rows):.3f}",
        f"{mean(row['iou'] for row in solids):.3f}" if solids else "-",
        sum(row["iou"] >= SAME_IOU for row in solids),
        sum(row.get("status") == "verified" for row in rows),
        sum(is_false(row) for row in rows),
        sum(row["sized"] for row in solids),
        f"{median(row.get('seconds', 0.0) for row in rows):.1f}",
    )


def _told(row: Row) -> str:
    iou = f"IoU {row['iou']:.4f}" if "iou" in row else "no solid"
    why = ", ".join(row.get("reasons", ())) or row.get("error") or row.get("failure", "")
    return f"{row['source']}/{row['name']} {row['width'] or ''}: {row.get('status')}, {iou} ({why})"


if __name__ == "__main__":
    sys.exit(main())
