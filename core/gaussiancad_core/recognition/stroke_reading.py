"""A sheet by its strokes alone: what each stands for, the drawings that they are, and their roles.

The order matters.  Curves are made whole and letters folded first, as neither says anything of the
part alone.  The frame is told before dimensions, whose arrowheads seed what pens stand for; edges
come last, as whatever is left, in the pens that draw outlines.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from shapely import Polygon

from gaussiancad_core.file_reading.dashed_lines import with_dashed_lines
from gaussiancad_core.file_reading.drawn_letters import folded_letters
from gaussiancad_core.file_reading.whole_curves import once, with_whole_curves
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.structure.centre_lines import centre_lines_apart
from gaussiancad_core.structure.dimension_lines import dimensions_apart
from gaussiancad_core.structure.drawing_area import frame_apart
from gaussiancad_core.structure.edges import with_edges
from gaussiancad_core.structure.hatching import hatching_apart
from gaussiancad_core.structure.ruled_tables import tables_apart
from gaussiancad_core.structure.shaded_pictures import with_picture_outlines
from gaussiancad_core.views.drawing_kinds import with_kinds
from gaussiancad_core.views.drawing_titles import with_titles
from gaussiancad_core.views.drawn_views import DrawnView, drawn_views
from gaussiancad_core.views.role_search import Ranking, arranged_views


@dataclass(frozen=True, eq=False)
class StrokeReading:
    """What the strokes of a sheet tell.

    Attributes:
        labelled: all strokes, each with what it stands for.
        area: in which the views lie, mm.
        tables: ruled tables in it, mm.
        words: boxes of what is written, mm.
        families: of hatching.
        views: drawings, the largest first.
        ranking: their roles; None where no drawing can have one.
    """

    labelled: LabelledStrokes
    area: Polygon
    tables: tuple[Polygon, ...]
    words: tuple[Box, ...]
    families: tuple[tuple[PaperStroke, ...], ...]
    views: tuple[DrawnView, ...]
    ranking: Ranking | None


def read_strokes(
    sheet: PaperSheet, heads: Sequence[Head], third_angle: float = 0.0
) -> StrokeReading:
    """Read a sheet by its strokes.

    Args:
        sheet: mm of paper.
        heads: its arrowheads, mm.
        third_angle: log-odds for third angle by what it says of its projection.
    """
    labelled = LabelledStrokes.open(with_whole_curves(once(sheet.strokes)))
    labelled, words, letters = folded_letters(sheet, labelled)
    labelled, area = frame_apart(sheet, labelled)
    labelled = dimensions_apart(labelled, heads)
    labelled, tables = tables_apart(labelled, area, words)
    labelled = with_dashed_lines(labelled)
    labelled = centre_lines_apart(labelled)
    labelled, families = hatching_apart(labelled)
    labelled = with_edges(labelled)
    labelled = with_picture_outlines(sheet, labelled, area)
    views = drawn_views(labelled.of(Label.EDGE), labelled.of(Label.HIDDEN), families)
    fills = [fill for number, fill in enumerate(sheet.fills) if number not in letters]
    views = with_titles(with_kinds(views, fills), sheet.texts)
    return StrokeReading(
        labelled,
        area,
        tuple(tables),
        tuple(words),
        tuple(tuple(family) for family in families),
        tuple(views),
        arranged_views(views, third_angle),
    )
