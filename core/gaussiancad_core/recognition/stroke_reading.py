"""A sheet by its strokes alone: what each stands for, the drawings that they are, and their roles.

The order matters.  Letters are folded and curves made whole first, as neither says anything of the
part alone.  The frame is told before dimensions, whose arrowheads seed what pens stand for; edges
come last, as whatever is left, in the pens that draw outlines.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import shapely
from shapely import Polygon

from gaussiancad_core.file_reading.dashed_lines import with_dashed_lines
from gaussiancad_core.file_reading.diameter_signs import diameter_signs_apart
from gaussiancad_core.file_reading.drawn_letters import drawn_words, folded_letters
from gaussiancad_core.file_reading.joined_chords import once, with_whole_curves
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.structure.centre_strokes import centre_lines_apart
from gaussiancad_core.structure.crossings import check_crossings
from gaussiancad_core.structure.dimension_dots import dots_apart
from gaussiancad_core.structure.dimension_lines import dimensions_apart
from gaussiancad_core.structure.drawing_area import (
    DrawingArea,
    drawing_area,
    frame_apart,
    whole_sheet,
)
from gaussiancad_core.structure.edges import with_edges
from gaussiancad_core.structure.hatching import hatching_apart
from gaussiancad_core.structure.ruled_tables import tables_apart
from gaussiancad_core.structure.shaded_pictures import with_picture_outlines
from gaussiancad_core.views.drawing_kinds import with_kinds
from gaussiancad_core.views.drawing_titles import with_titles
from gaussiancad_core.views.drawn_groups import DrawnView, drawn_views
from gaussiancad_core.views.framed_views import Surety, surety_of_views
from gaussiancad_core.views.role_search import Ranking, arranged_views


@dataclass(frozen=True, eq=False)
class StrokeReading:
    """What the strokes of a sheet tell.

    Attributes:
        labelled: all strokes, each with what it stands for.
        area: in which the views lie.
        tables: ruled tables in it, mm.
        words: boxes of what is written, mm.
        families: of hatching.
        views: drawings, the largest first.
        ranking: their roles; None where no drawing can have one.
    """

    labelled: LabelledStrokes
    area: DrawingArea
    tables: tuple[Polygon, ...]
    words: tuple[Box, ...]
    families: tuple[tuple[PaperStroke, ...], ...]
    views: tuple[DrawnView, ...]
    ranking: Ranking | None


def read_strokes(
    sheet: PaperSheet,
    heads: Sequence[Head],
    third_angle: float = 0.0,
    symbols: Sequence[Box] = (),
) -> StrokeReading:
    """Read a sheet by its strokes.

    Args:
        sheet: mm of paper.
        heads: its arrowheads, mm.
        third_angle: log-odds for third angle by what it says of its projection.
        symbols: boxes of signs that are known, such as that of the projection, mm.

    Raises:
        LimitError: as of :func:`.check_crossings`.
    """
    labelled, rows = _with_whole_strokes(sheet)
    labelled = _without_symbols(labelled, symbols)
    check_crossings(labelled.of(Label.OPEN))
    labelled, words, letters = folded_letters(sheet, labelled)
    words = [*words, *rows]
    written = _Written(sheet, words, letters, heads, third_angle)
    area = drawing_area(sheet, labelled, words)
    framed = _read(labelled, area, written)
    if area.is_certain:
        return framed
    surety = surety_of_views(framed.views, area.polygon)
    if surety is Surety.NONE or _has_notes_beside(sheet, area):
        return _read(labelled, whole_sheet(sheet), written)
    return replace(framed, area=replace(area, is_certain=surety is Surety.CERTAIN))


def _has_notes_beside(sheet: PaperSheet, area: DrawingArea) -> bool:
    """Whether anything is written beside an area: a frame goes around all that is."""
    outer = area.polygon.envelope
    return any(not outer.intersects(shapely.box(*text.box)) for text in sheet.texts)


def _with_whole_strokes(sheet: PaperSheet) -> tuple[LabelledStrokes, list[Box]]:
    """The strokes, each once and curves whole, and the boxes of words: those of drawn letters are
    left as they are, as they are most of a sheet and show nothing of the part."""
    strokes = once(sheet.strokes)
    rows, members = drawn_words(strokes)
    is_letter = set(members)
    rest = [stroke for number, stroke in enumerate(strokes) if number not in is_letter]
    labelled = LabelledStrokes.open([strokes[n] for n in members] + with_whole_curves(rest))
    return labelled.with_label(range(len(members)), Label.TEXT, "row of drawn letters"), rows


def _without_symbols(labelled: LabelledStrokes, symbols: Sequence[Box]) -> LabelledStrokes:
    """The strokes, those of signs told."""
    inside = [
        number
        for number, stroke in enumerate(labelled.strokes)
        if any(_is_within(stroke.box, box) for box in symbols)
    ]
    return labelled.with_label(inside, Label.OTHER, "of a sign")


def _is_within(box: Box, around: Box) -> bool:
    starts = box[0] >= around[0] - _AROUND and box[1] >= around[1] - _AROUND
    return starts and box[2] <= around[2] + _AROUND and box[3] <= around[3] + _AROUND


_AROUND = 1.0
"""mm around a sign that belong to it."""


@dataclass(frozen=True, eq=False)
class _Written:
    """A sheet, what is written on it, and what that says.

    Attributes:
        sheet: mm of paper.
        words: boxes of what is written, mm.
        letters: numbers of fills that are letters.
        heads: arrowheads, mm.
        third_angle: log-odds.
    """

    sheet: PaperSheet
    words: Sequence[Box]
    letters: set[int]
    heads: Sequence[Head]
    third_angle: float


def _read(labelled: LabelledStrokes, area: DrawingArea, written: _Written) -> StrokeReading:
    """The reading of a sheet whose views lie in an area."""
    sheet = written.sheet
    if area.is_framed:
        labelled = frame_apart(labelled, area)
    labelled, dots = dots_apart(labelled)
    labelled = dimensions_apart(labelled, [*written.heads, *dots])
    labelled = diameter_signs_apart(labelled)
    labelled, tables = tables_apart(labelled, area.polygon, written.words)
    labelled = with_dashed_lines(labelled)
    labelled = centre_lines_apart(labelled)
    labelled, families = hatching_apart(labelled)
    labelled = with_edges(labelled)
    labelled = with_picture_outlines(sheet, labelled, area.polygon)
    views = drawn_views(
        labelled.of(Label.EDGE), labelled.of(Label.HIDDEN), families, labelled.of(Label.OTHER)
    )
    fills = [fill for number, fill in enumerate(sheet.fills) if number not in written.letters]
    views = with_titles(with_kinds(views, fills), sheet.texts)
    return StrokeReading(
        labelled,
        area,
        tuple(tables),
        tuple(written.words),
        tuple(tuple(family) for family in families),
        tuple(views),
        arranged_views(views, written.third_angle),
    )
