"""Parts of ``verified`` on sheets in files, through the whole engine.

A family's variant, or a part of a class, is drawn under a policy, as another program draws it: as
a picture, as a scan of one, or as a DXF file where that has the front, top and right view.
"""

import json
import tempfile
from collections.abc import Iterator
from dataclasses import asdict, replace
from enum import Enum
from pathlib import Path
from random import Random

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.verified_judging import judgement
from benchmarks.parts.twin_parts import FAMILIES, twins
from benchmarks.run.workers import Row
from benchmarks.sheets.dxf_sheets import write_dxf
from benchmarks.sheets.foreign_sheets import Conventions, foreign_sheet
from benchmarks.sheets.sheet_policies import POLICIES
from benchmarks.tasks.verified_sources import Page, part_shape
from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import PartLines
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.pipeline import REPORT_FILE, reconstruct
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_protocol.modes import ResultKind, Status

_DXF_ROLES = {Role.FRONT, Role.TOP, Role.RIGHT}

_FIRST_ANGLE = 0.35
"""Share of the sheets that are in first angle."""


class File(Enum):
    """What the sheet is."""

    PICTURE = "picture"
    DIMENSIONED = "dimensioned"
    SCAN = "scan"
    DXF = "dxf"


def sheet_cases(kind: str, seed: int) -> Iterator[Row]:
    """A family's part, or one of a class, on a sheet under a policy by lot."""
    lot = Random(f"{kind} {seed} sheets")
    shapes = twins(kind, seed) if kind in FAMILIES else [part_shape(kind, seed)]
    pages = [Page(shape) for shape in shapes]
    number = lot.randrange(len(pages))
    policy = POLICIES[0] if lot.random() < 0.5 else lot.choice(POLICIES[1:])
    files = [item for item in File if item is not File.DXF or set(policy.roles) <= _DXF_ROLES]
    file = lot.choice(files)
    page = pages[number]
    alike = [
        index
        for index, other in enumerate(pages)
        if index != number and page.looks_like(other, policy)
    ]
    row: Row = {
        "policy": f"{file.value}: {policy.name}",
        "member": number,
        "alike": alike,
        "unique": not alike,
    }
    angle = Projection.FIRST if lot.random() < _FIRST_ANGLE else Projection.THIRD
    row["first"] = angle is Projection.FIRST
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        lines = PartLines(np.array(page.size), dict(page.drawn(policy)))
        sheet = _draw(lines, file, angle, seed, folder)
        longest = max(Axis, key=lambda axis: page.size[axis.value])
        stated = ReadingOptions(
            projection=angle if policy.stated else None,
            lengths=((longest, page.size[longest.value]),),
        )
        job = Job(sheet, folder / "out", stated, result=ResultKind.SOLID)
        yield row | _reconstructed(job, page.shape, unique=not alike)


def _reconstructed(job: Job, truth: TopoDS_Shape, *, unique: bool) -> Row:
    """What the engine says of a sheet, and whether it is right."""
    try:
        reconstruct(job, Silence())
    except GaussianCadError as error:
        return {"status": Status.FAILED.value, "reasons": [error.code]}
    report = json.loads((job.output / REPORT_FILE).read_text(encoding="utf-8"))
    row: Row = {
        "status": report["status"],
        "reasons": [item["code"] for item in report["reasons"]],
        "seconds": sum(report["seconds"].values()),
    }
    if report["status"] != Status.VERIFIED.value:
        return row
    shape = read_solid(job.output / "solid.step")
    bound = float(report["measures"]["uncertainty_mm"])
    return row | asdict(judgement(shape, truth, bound, unique=unique))


def _draw(lines: PartLines, file: File, angle: Projection, seed: int, folder: Path) -> Path:
    if file is File.DXF:
        path = folder / "sheet.dxf"
        write_dxf(lines, angle, path)
        return path
    how = Conventions.drawn_by_lot(seed, dimensioned=file is File.DIMENSIONED)
    if file is not File.SCAN:
        path = folder / "sheet.png"
        write_image(foreign_sheet(lines, how, angle).image, path)
        return path
    style = PRESETS["scan"]
    askew = style.skew * Random(f"{seed} askew").uniform(-1.0, 1.0)
    sheet = foreign_sheet(lines, replace(how, grey=0), angle, askew)
    ink = 1.0 - sheet.image[..., 0].astype(np.float32) / 255.0
    path = folder / "sheet.jpg"
    write_image(finished(ink, style, seed), path, style.jpeg_quality)
    return path
