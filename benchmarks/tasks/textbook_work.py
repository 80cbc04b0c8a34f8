"""One part of a textbook, one kind of sheet: model, draw, reconstruct, measure."""

import tempfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from enum import Enum
from pathlib import Path
from random import Random
from zlib import crc32

import numpy as np

from benchmarks.judge.exact_measures import closeness, mirrored_alike
from benchmarks.parts.textbook_blocks import BLOCKS
from benchmarks.parts.textbook_brackets import BRACKETS
from benchmarks.parts.textbook_levers import LEVERS
from benchmarks.parts.textbook_turned import TURNED
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.foreign_sheets import Conventions, foreign_sheet
from benchmarks.sheets.textbook_drawing import textbook_lines
from benchmarks.sheets.textbook_dxf import write_dxf
from benchmarks.tasks.sheet_runs import projection_of, solved_sheet
from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import PartLines
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Axis, Projection
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.sheet.reading_options import ReadingOptions

FAMILIES = {family.name: family for family in (*TURNED, *LEVERS, *BRACKETS, *BLOCKS)}

_DRAWING_S = 120.0
_MEASURING_S = 120.0


class SheetKind(Enum):
    """What the engine gets: lines of a file, or a picture, without or with dimensions, or on paper.

    What was on paper has black lines, is turned, blurred and noisy, and is a JPEG file.
    """

    DXF = "dxf"
    PICTURE = "picture"
    DIMENSIONED = "dimensioned"
    SCAN = "scan"
    PHOTOCOPY = "photocopy"

    @property
    def on_paper(self) -> bool:
        """Whether it came through a scanner."""
        return self in (SheetKind.SCAN, SheetKind.PHOTOCOPY)


@dataclass(frozen=True)
class Task:
    """A sheet of a part, which is told by the family's name, the seed and the kind of measures.

    Attributes:
        family: its name.
        seed: of measures, of the sheet's look and of first or third angle.
        odd: whether measures are hundredths of a millimetre.
        kind: of the sheet.
        stated: whether the engine is told first or third angle.
        limit: s for reading and solving.
        kept: folder for sheets, solids and results; None if nobody wants to look at them.
    """

    family: str
    seed: int
    odd: bool
    kind: SheetKind
    stated: bool
    limit: float
    kept: Path | None = None

    @property
    def name(self) -> str:
        """Of the part."""
        return f"{self.family}-{self.seed}{'-odd' if self.odd else ''}"

    @property
    def known(self) -> Row:
        """What its row begins with."""
        group = FAMILIES[self.family].group
        return {"group": group, "name": self.name, "input": self.kind.value}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _DRAWING_S, SOLVE: self.limit, "measure": _MEASURING_S}

    @property
    def projection(self) -> Projection:
        """First or third angle."""
        return projection_of(self.name)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a task, bit by bit; each bit tells the stage that comes next."""
    silence_opencascade()
    truth = FAMILIES[task.family].part(task.seed, task.odd)
    lines = textbook_lines(truth)
    yield {"true_faces": len(faces_of(truth))}
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) if task.kept is None else task.kept / task.kind.value / task.name
        folder.mkdir(parents=True, exist_ok=True)
        sheet = draw(task, lines, folder)
        longest = max(Axis, key=lambda axis: float(lines.size[axis.value]))
        options = ReadingOptions(
            projection=task.projection if task.stated else None,
            lengths=((longest, float(lines.size[longest.value])),),
        )
        yield {"stage": SOLVE}
        yield {**solved_sheet(sheet, folder, options, task.projection), "stage": "measure"}
        path = folder / "solid.step"
        if path.is_file():
            solid = read_solid(path)
            close = closeness(solid, truth)
            yield {**asdict(close), "exact": close.exact}
            if not close.exact:
                yield {"mirrored": mirrored_alike(solid, truth)}


def draw(task: Task, lines: PartLines, folder: Path) -> Path:
    """The file of a sheet, in a folder."""
    if task.kind is SheetKind.DXF:
        path = folder / "sheet.dxf"
        write_dxf(lines, task.projection, path)
        return path
    seed = crc32(task.name.encode())
    dimensioned = task.kind is SheetKind.DIMENSIONED
    how = Conventions.drawn_by_lot(seed, dimensioned=dimensioned)
    if task.kind.on_paper:
        style = PRESETS[task.kind.value]
        askew = style.skew * Random(f"{task.name} askew").uniform(-1.0, 1.0)
        sheet = foreign_sheet(lines, replace(how, grey=0), task.projection, askew)
        ink = 1.0 - sheet.image[..., 0].astype(np.float32) / 255.0
        path = folder / "sheet.jpg"
        write_image(finished(ink, style, seed), path, style.jpeg_quality)
        return path
    path = folder / "sheet.png"
    write_image(foreign_sheet(lines, how, task.projection).image, path)
    return path
