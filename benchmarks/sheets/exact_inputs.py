"""The drawing of a part: its exact lines, or what is read of a sheet of them."""

import hashlib
import pickle
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from functools import cache
from pathlib import Path

import numpy as np
from OCP.TopoDS import TopoDS_Shape

import sample_parts
from benchmarks.judge.reading_found import lines_of, picture_of
from benchmarks.parts.exact_cases import Case
from benchmarks.sheets.clean_sheets import ROLES
from benchmarks.sheets.foreign_sheets import Conventions, foreign_sheet
from gaussiancad_core import drawing
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import PartLines, compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.evidence.dimension_evidence import trusted
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.evidence.projected_reading import ProjectedReading, drawn_views
from gaussiancad_core.model.axes import Axis, Projection
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.run.ink_stage import compared_with_ink
from gaussiancad_core.run.solid_judgement import judged_model
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, register_views
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.writing.scale_agreement import Measure
from gaussiancad_core.writing.sheet_scale import find_scale


class InputKind(Enum):
    """How the solver gets a drawing."""

    VECTORS = "vectors"
    CLEAN = "clean"
    SCAN = "scan"
    DIMENSIONED = "dimensioned"
    FOREIGN = "foreign"
    FOREIGN_DIMENSIONED = "foreign-dimensioned"


_FINEST = 2000.0
"""Pixels of the longest extent on a sheet, at most."""


@dataclass(frozen=True)
class Lines:
    """Views of no sheet, as what was read of one.

    Attributes:
        drawn: the views.
    """

    drawn: DrawnViews
    is_alone: bool = False

    @property
    def numbered(self) -> DrawnViews:
        """No numbers tell anything else."""
        return self.drawn

    @property
    def grid(self) -> float:
        """mm of a pixel of a sheet on which the lines would be as exact, at least."""
        return max(self.drawn.tolerance, max(self.drawn.size) / _FINEST)


@dataclass(frozen=True)
class Input:
    """What goes into the solver.

    Attributes:
        views: the strokes.
        source: whether the strokes were fitted to pixels or are those of a file.
        registered: the views on shared axes, where they come from a sheet.
        sheet: that, as stored and upright.
        measures: what its dimensions say.
    """

    views: DrawnViews
    source: str = ""
    registered: RegisteredSheet | None = None
    sheet: OpenedSheet | None = None
    measures: tuple[Measure, ...] = ()

    @property
    def px_mm(self) -> float:
        """mm of a px of the sheet; of exact lines the distance up to which they are known."""
        return self.views.tolerance if self.registered is None else self.registered.mm_per_pixel

    def solved(self) -> ExactResult:
        """The solid: as of a sheet, compared with the ink and judged, where there is one."""
        if self.registered is None or self.sheet is None:
            return find_exact(Lines(self.views), None).result
        reading = ProjectedReading(self.registered, Projection.THIRD, self.measures)
        model = find_exact(reading, None)
        result = compared_with_ink(model.result, self.registered, self.sheet)
        return judged_model(replace(model, result=result), self.sheet).result


def make_input(case: Case, truth: TopoDS_Shape, kind: InputKind, folder: Path) -> Input:
    """The drawing of a case, as exact lines or read from a sheet.

    Args:
        case: the part.
        truth: its solid.
        kind: which way.
        folder: where lines that were drawn are kept.

    Raises:
        GaussianCadError: the sheet cannot be read.
    """
    lines = kept_lines(case, truth, folder)
    if kind is InputKind.VECTORS:
        return Input(exact_views(lines.views, _size(lines)))
    return _drawn_and_read(case, lines, kind)


def kept_lines(case: Case, truth: TopoDS_Shape, folder: Path) -> PartLines:
    """The lines of a part, from the folder if they were drawn before."""
    return _kept(folder, case, lambda: part_lines(truth, ROLES))


def _kept(folder: Path, case: Case, make: Callable[[], PartLines]) -> PartLines:
    source = case.step.read_bytes() if case.step is not None else b""
    key = hashlib.sha256(source + f"{case.level} {_version()}".encode()).hexdigest()[:12]
    path = folder / "exact-lines" / f"{case.group}-{case.name}-{key}.pickle"
    if path.exists():
        return pickle.loads(path.read_bytes())
    made = make()
    path.parent.mkdir(parents=True, exist_ok=True)
    # Workers may draw the same part at the same time.
    with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
        file.write(pickle.dumps(made))
    Path(file.name).replace(path)
    return made


@cache
def _version() -> str:
    """Of the code that makes and draws parts: its change makes kept lines old."""
    digest = hashlib.sha256()
    for package in (drawing, sample_parts):
        for path in sorted(Path(package.__file__).parent.rglob("*.py")):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


def _size(lines: PartLines) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in lines.size)
    return x, y, z


def _drawn_and_read(case: Case, lines: PartLines, kind: InputKind) -> Input:
    """Through a sheet's file; its scale is told as a user would, by the longest extent."""
    longest = int(np.argmax(lines.size))
    length = Axis(longest), float(lines.size[longest])
    quality = 95
    if kind in (InputKind.FOREIGN, InputKind.FOREIGN_DIMENSIONED):
        dimensioned = kind is InputKind.FOREIGN_DIMENSIONED
        sheet = foreign_sheet(lines, Conventions.drawn_by_lot(case.seed, dimensioned=dimensioned))
    else:
        style = parse_style(kind.value)
        quality = style.jpeg_quality
        sheet = compose_sheet(lines, Projection.THIRD, style, case.seed, title=case.name.upper())
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / ("sheet.png" if quality >= 95 else "sheet.jpg")
        write_image(sheet.image, path, quality, sheet.dpi)
        return read_input(path, length)


def read_input(path: Path, length: tuple[Axis, float] | None) -> Input:
    """What the picture of a third-angle sheet has.

    Args:
        path: of the sheet.
        length: the part's extent in mm along an axis, or nothing.

    Raises:
        GaussianCadError: the sheet cannot be read.
    """
    options = ReadingOptions(
        projection=Projection.THIRD, lengths=() if length is None else (length,)
    )
    sheet, lines = lines_of(picture_of(path), options)
    drawn = lines.drawn
    registered = register_views(drawn, options)
    measures = trusted(registered, find_scale(sheet, lines.marks, drawn))
    return Input(
        drawn_views(registered, measures),
        source=registered.source.value,
        registered=registered,
        sheet=sheet,
        measures=measures,
    )
