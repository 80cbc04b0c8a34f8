"""Sheets of the benchmark ``reading_stages``: read up to the stages that make strokes, and kept."""

import pickle
import sys
import tempfile
from argparse import Namespace
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from pathlib import Path
from zlib import crc32

from benchmarks.ask.real_pictures import COVERED, Condition, pictured
from benchmarks.ask.real_pictures import Task as RealTask
from benchmarks.judge.reading_found import found_of, lines_of
from benchmarks.judge.stroke_matching import Matched, corners_of, match, nearness
from benchmarks.parts.exact_cases import Case as ClassedCase
from benchmarks.parts.exact_cases import classed_cases
from benchmarks.sheets.clean_sheets import ROLES
from benchmarks.sheets.foreign_sheets import Conventions, foreign_sheet
from benchmarks.sheets.styled_sheets import Job, drawn_in, jobs_of
from benchmarks.sheets.textbook_drawing import textbook_lines
from benchmarks.tasks.textbook_work import FAMILIES
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import Sheet, part_lines
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.recognition.views_and_lines import SheetLines
from gaussiancad_core.samples.classed import PartClass
from gaussiancad_core.sheet import sheet_stages
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.registration.view_registration import view_box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm
from gaussiancad_core.sheet.tracing.line_widths import Pens
from gaussiancad_core.sheet.tracing.view_shapes import ViewShapes
from gaussiancad_core.sheet.views.outside_strokes import without_outside

Shapes = tuple[ViewShapes, Rhythm, Pens]
"""What ``classify_strokes`` is given."""

_REAL_DPI = 200


@dataclass(frozen=True)
class Figures:
    """How like the truth a sheet's strokes are.

    Attributes:
        visible, hidden: lengths in px at working scale.
        corners, corners_found: of the truth, and those with a vertex of the views within 1 px.
        refused: whether the views were refused.
    """

    visible: Matched
    hidden: Matched
    corners: int
    corners_found: int = 0
    refused: bool = False


@dataclass(frozen=True, eq=False)
class Case:
    """A sheet.

    Attributes:
        group: drawn, textbook, classed or real.
        name: of the sheet.
        truth: true strokes, px at working scale of the sheet as it lies.
        covered: px beside a visible line within which a hidden one does not show.
        lines: as they were read.
        turn: of the upright sheet.
        shapes: of each view, in the order of the views.
    """

    group: str
    name: str
    truth: tuple[DrawnStroke, ...]
    covered: float
    lines: SheetLines
    turn: Turn
    shapes: tuple[Shapes, ...]

    def figures(self, strokes: tuple[tuple[Stroke, ...], ...]) -> Figures:
        """Those of other strokes, as ``classify_strokes`` gives them, of each view."""
        views = zip(self.lines.drawn, strokes, strict=True)
        drawn = tuple(_with_strokes(view, item) for view, item in views)
        truth = list(self.truth)
        corners = corners_of(truth, self.covered)
        lines = replace(self.lines, drawn=drawn)
        try:
            found = found_of(lines, self.turn, ReadingOptions())
        except GaussianCadError:
            lost, _, _ = match(truth, [], self.covered)
            return Figures(lost[Linetype.VISIBLE], lost[Linetype.HIDDEN], len(corners), 0, True)
        seen = list(chain.from_iterable(found.strokes.values()))
        lengths, _, _ = match(truth, seen, self.covered)
        near = int(nearness(corners, found.vertices).sum())
        return Figures(lengths[Linetype.VISIBLE], lengths[Linetype.HIDDEN], len(corners), near)


def _with_strokes(view: ReadView, strokes: tuple[Stroke, ...]) -> ReadView:
    if view.outline is None:
        return replace(view, strokes=strokes)
    inside = without_outside(strokes, view.outline)
    return replace(view, strokes=inside, box=view_box(inside, view.outline, exact=False))


@dataclass(frozen=True, eq=False)
class _Sheet:
    """A sheet's file with its truth, in px of the file."""

    path: Path
    truth: tuple[DrawnStroke, ...]
    covered: float


def kept_cases(options: Namespace) -> Iterator[Case]:
    """The sheets that are asked for, each kept in a folder once it was read.

    Args:
        options: those of ``reading_stages``.
    """
    for group, name, make in _asked(options):
        file = options.cases / f"{group}-{name.replace('/', '-')}.pickle"
        if not file.is_file():
            file.parent.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryDirectory() as folder:
                try:
                    case = _read(group, name, make(Path(folder)))
                except GaussianCadError as error:
                    print(f"{group} {name}: {error.code}", file=sys.stderr, flush=True)
                    case = None
            file.write_bytes(pickle.dumps(case))
        case = pickle.loads(file.read_bytes())
        if case is not None:
            yield case


def _asked(options: Namespace) -> Iterator[tuple[str, str, Callable[[Path], _Sheet]]]:
    """Group, name, and what makes the sheet in a folder."""
    for job in jobs_of(options):
        for style in job.styles:
            yield "drawn", f"{job.name}-{style}", partial(_drawn, job, style)
    for family in options.families:
        yield "textbook", family, partial(_textbook, family, options.seed)
    for case in classed_cases(list(PartClass), options.classed, options.seed, 0):
        yield "classed", case.name, partial(_classed, case)
    for path in sorted(options.data.glob("*/*.pdf")) if options.data else ():
        name = f"{path.parent.name}/{path.stem}"
        if any(text in name for text in options.sheets):
            yield "real", name, partial(_real, path)


def _drawn(job: Job, style: str, folder: Path) -> _Sheet:
    drawn = drawn_in(*job.lines(), style, job)
    return _written(drawn.sheet, folder, drawn.quality, drawn.covered)


def _textbook(family: str, seed: int, folder: Path) -> _Sheet:
    lines = textbook_lines(FAMILIES[family].part(seed, False))
    how = Conventions.drawn_by_lot(crc32(family.encode()))
    return _written(foreign_sheet(lines, how), folder, 95, 0.5 * how.visible)


def _classed(case: ClassedCase, folder: Path) -> _Sheet:
    how = Conventions.drawn_by_lot(case.seed)
    sheet = foreign_sheet(part_lines(case.truth(), ROLES), how)
    return _written(sheet, folder, 95, 0.5 * how.visible)


def _real(path: Path, folder: Path) -> _Sheet:
    task = RealTask(path, _REAL_DPI, Condition.CLEAN, 0.0)
    picture, truth = pictured(task, folder)
    return _Sheet(picture, tuple(chain.from_iterable(truth.strokes.values())), COVERED)


def _written(sheet: Sheet, folder: Path, quality: int, covered: float) -> _Sheet:
    path = folder / ("sheet.png" if quality >= 95 else "sheet.jpg")
    write_image(sheet.image, path, quality, sheet.dpi)
    strokes = tuple(stroke for view in sheet.views for stroke in view.strokes)
    return _Sheet(path, strokes, covered)


def _read(group: str, name: str, sheet: _Sheet) -> Case:
    """A sheet, and what its views' strokes were made of."""
    image = read_sheet(sheet.path)
    given: list[Shapes] = []
    classify = sheet_stages.classify_strokes

    def noted(view: ViewShapes, rhythm: Rhythm, pens: Pens) -> tuple[Stroke, ...]:
        given.append((view, rhythm, pens))
        return classify(view, rhythm, pens)

    sheet_stages.classify_strokes = noted
    try:
        clean, lines = lines_of(image, ReadingOptions())
    finally:
        sheet_stages.classify_strokes = classify
    # Sections that stand beside views are read after these.
    shapes = tuple(given[: len(lines.drawn)])
    turn = replace(clean.turn, scale=1.0)
    factor = 1.0 / image.reduction
    truth = tuple(stroke.mapped(Similarity(factor)) for stroke in sheet.truth)
    return Case(group, name, truth, sheet.covered * factor, lines, turn, shapes)
