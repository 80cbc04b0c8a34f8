"""A sheet of other people through the command, and how like its true part the solid is."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh

from benchmarks.judge.exact_measures import fine_mesh, mesh_iou, rotations
from benchmarks.run.engine import JUST_ENDED_S, command_for_solid, read_json
from benchmarks.run.outcome import Figure, share
from benchmarks.run.workers import FIRST, Row
from benchmarks.sheets.published import SAME_IOU
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.brep_files import read_shape, read_solid
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_protocol.modes import Status

JUDGING_S = 300.0
"""Seconds for comparing a solid with its part."""

_SAME_EXTENT = 5e-3
"""Share by which an extent may differ from the part's."""


@dataclass(frozen=True)
class Sheet:
    """A sheet with its part.

    Attributes:
        path: the file; the part is beside it.
        limit: s of the clock.
        options: further ones of the command.
        width: px that its picture was made wide; None as it is.
    """

    path: Path
    limit: float
    options: tuple[str, ...] = ()
    width: int | None = None

    @property
    def part(self) -> Path:
        """The true part."""
        return self.path.with_suffix(".step")

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"source": self.path.parent.name, "name": self.path.stem, "width": self.width}


@dataclass(frozen=True)
class Task:
    """A sheet to be run and judged.

    Attributes:
        sheet: with its part.
        keep: folder for what comes out; None to keep nothing.
    """

    sheet: Sheet
    keep: Path | None = None

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return self.sheet.known

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {
            FIRST: self.sheet.limit + JUST_ENDED_S,
            "views": JUDGING_S,
            "judge": JUDGING_S,
        }


def ran(sheet: Sheet, file: Path, output: Path) -> Row:
    """Run the command on a sheet's file; how it ended, and what its report says."""
    row = command_for_solid(file, output, *sheet.options, limit_s=sheet.limit).row
    report = read_json(output / "report.json")
    if report:
        row["status"] = report["status"]
        row["reasons"] = [reason["code"] for reason in report["reasons"]]
        row["stages"] = report["seconds"]
        row["scale_mm_per_px"] = report["scale_mm_per_pixel"]
    return row


def judged(solid: Path, part: Path) -> Row:
    """How like the part a solid is, whatever its size, and whether its extents are the part's.

    The score is that of the public Ortho2CAD sheets: volume IoU once both have their centre of mass
    at the origin and a radius of gyration of 1, in the best of 24 rotations.
    """
    shape, truth = read_shape(solid), read_solid(part)
    extents = [np.sort(np.ptp(bounding_box(item), axis=0)) for item in (shape, truth)]
    entry, true = _normalised(fine_mesh(shape)), _normalised(fine_mesh(truth))
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


def _normalised(mesh: TriangleMesh) -> TriangleMesh:
    solid = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    gyration = np.sqrt(0.5 * np.trace(solid.moment_inertia) / solid.volume)
    return make_mesh((mesh.vertices - solid.center_mass) / gyration, mesh.triangles)


def is_the_part(row: Row) -> bool:
    """Whether a row's solid is the part, at one size."""
    return row.get("iou", 0.0) >= SAME_IOU


def is_false(row: Row) -> bool:
    """Whether a solid was called verified that is not the part."""
    return row.get("status") == Status.VERIFIED.value and not is_the_part(row)


def why(row: Row) -> list[str]:
    """The codes of what is wrong with a sheet, or open."""
    if row.get("exit_code", 0) is None or "failure" in row:
        return ["over-time"]
    return list(dict.fromkeys([*row.get("reasons", ()), *filter(None, [row.get("error")])]))


def in_words(row: Row) -> str:
    """A line about a sheet."""
    iou = f"IoU {row['iou']:.4f}" if "iou" in row else "no solid"
    name = f"{row['source']}/{row['name']} {row['width'] or ''}".rstrip()
    return f"{name}: {row.get('status', 'not ended')}, {iou} ({', '.join(why(row))})"


def counted(rows: Sequence[Row]) -> tuple[Figure, ...]:
    """The headline figures."""
    solids = [row for row in rows if "iou" in row]
    verified = sum(row.get("status") == Status.VERIFIED.value for row in rows)
    return (
        Figure("mean IoU", round(sum(row["iou"] for row in solids) / max(1, len(rows)), 3)),
        share("solids", len(solids), len(rows)),
        share("the part (IoU 0.99 at least)", sum(map(is_the_part, rows)), len(rows)),
        share("extents as the part's", sum(row["sized"] for row in solids), len(rows)),
        share("verified", verified, len(rows)),
        Figure("falsely verified", sum(map(is_false, rows))),
    )
