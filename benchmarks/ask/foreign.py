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
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean, median

import cv2
import numpy as np
import trimesh

from benchmarks.judge.exact_measures import fine_mesh, mesh_iou, rotations
from benchmarks.run.arguments import add_data, add_running, is_chosen
from benchmarks.run.engine import JUST_ENDED_S, part_of, read_json
from benchmarks.run.outcome import Figure, Outcome, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import FIRST, Row
from benchmarks.sheets.published import SAME_IOU, sheets_of
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.brep_files import read_shape, read_solid
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.processes.library_behaviour import silence_opencascade

MINUTES = 30

_SAME_EXTENT = 5e-3
"""Share by which an extent may differ from the one that the sheet states."""

_JUDGING_S = 120.0
_PICTURES = (".png", ".jpg")

_HEAD = ("source", "px", "sheets", "solid", "IoU", "of solids", "exact", "verif.", "false", "sized")


@dataclass(frozen=True)
class Task:
    """A sheet at a width.

    Attributes:
        sheet: the file; the part is beside it.
        width: px that the picture is made wide; None as it is.
        given: further arguments.
        limit: s of the clock.
        keep: folder for what comes out; None to keep nothing.
    """

    sheet: Path
    width: int | None
    given: tuple[str, ...]
    limit: float
    keep: Path | None = None

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"source": self.sheet.parent.name, "name": self.sheet.stem, "width": self.width}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: self.limit + JUST_ENDED_S, "judge": _JUDGING_S}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    parser.add_argument("--widths", nargs="*", type=int, help="px")
    parser.add_argument("--told", nargs="*", default=[], help="arguments, such as projection=first")
    add_running(parser, limit_s=120.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for results")


def run(options: argparse.Namespace) -> Outcome:
    """Run the sheets; print the table."""
    tasks = [
        Task(sheet, width, tuple(options.told), options.limit, options.keep)
        for sheet in sheets_of(options.data)
        if is_chosen(sheet, options.only)
        for width in (options.widths if sheet.suffix in _PICTURES else None) or [None]
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), _line)
    print(table(rows))
    solids = [row["iou"] for row in rows if "iou" in row]
    false = sum(is_false(row) for row in rows)
    figures = (
        Figure("mean IoU", round(sum(solids) / max(1, len(rows)), 3)),
        share("solids", len(solids), len(rows)),
        share("IoU of 0.99 at least", sum(iou >= SAME_IOU for iou in solids), len(rows)),
        Figure("falsely verified", false),
    )
    return Outcome(figures, wrong=bool(false))


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
    known = (option.partition("=") for option in task.given)
    given = {name.replace("-", "_"): value for name, _, value in known}
    row = part_of(sheet, output, limit_s=task.limit, **given).row
    report = read_json(output / "report.json")
    if report:
        row["status"] = report["status"]
        row["reasons"] = [reason["code"] for reason in report["reasons"]]
        row["views"] = sorted(report["views"])
        row["projection"] = report["projection"]
        row["scale_source"] = report["scale_source"]
        row["stages"] = report["seconds"]
    return row


def judged(solid: Path, part: Path) -> Row:
    """The score of a solid, and whether its extents are the part's."""
    shape, truth = read_shape(solid), read_solid(part)
    extents = [np.sort(np.ptp(bounding_box(item), axis=0)) for item in (shape, truth)]
    entry, true = normalised(fine_mesh(shape)), normalised(fine_mesh(truth))
    scores = [
        mesh_iou(entry, make_mesh(true.vertices @ matrix.T, true.triangles)) or 0.0
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
    cells = []
    for source, width in dict.fromkeys((row["source"], row["width"]) for row in rows):
        this_rows = [row for row in rows if (row["source"], row["width"]) == (source, width)]
        cells.append(_counted(source, width, this_rows))
    lines = [as_table((*_HEAD, "s"), cells)]
    failed: dict[str, int] = {}
    for row in rows:
        if "iou" not in row:
            code = row.get("error") or row.get("failure") or "over-time"
            failed[code] = failed.get(code, 0) + 1
    lines.append("no solid: " + ", ".join(f"{code} {count}" for code, count in failed.items()))
    return "\n".join(lines)


def _counted(source: str, width: int | None, rows: Sequence[Row]) -> tuple[object, ...]:
    solids = [row for row in rows if "iou" in row]
    return (
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


def _line(row: Row) -> str:
    iou = f"IoU {row['iou']:.4f}" if "iou" in row else "no solid"
    why = ", ".join(row.get("reasons", ())) or row.get("error") or row.get("failure", "")
    return f"{row['source']}/{row['name']} {row['width'] or ''}: {row.get('status')}, {iou} ({why})"
