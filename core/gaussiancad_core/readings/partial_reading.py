"""What can be told of a sheet whose views were not found: its lines, and where views may be."""

from gaussiancad_core.files.vectors import StrokeRole
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.recognition.labelled_file import strokes_of_file
from gaussiancad_core.recognition.views_and_lines import SheetLines, in_worked_px
from gaussiancad_core.report.job import Job
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.tracing.file_strokes import stroke_along
from gaussiancad_core.sheet.views.sheet_layout import (
    Layout,
    ProjectionSource,
    find_clusters,
    may_be_views,
)


def partial_lines(job: Job, sheet: OpenedSheet) -> SheetLines:
    """The lines of a sheet without views.

    Args:
        job: with what the user says of the sheet.
        sheet: as stored and upright.
    """
    options = in_worked_px(job.reading, sheet.turn)
    projection = options.projection or Projection.THIRD
    source: ProjectionSource = "given" if options.projection else "default"
    alternatives = () if options.projection else (projection.other,)
    boxes = tuple(may_be_views(find_clusters(sheet.clean.ink)))
    layout = Layout({}, projection, source, alternatives, boxes)
    return SheetLines(layout, (), (), None, options, loose=_file_strokes(sheet))


def _file_strokes(sheet: OpenedSheet) -> tuple[Stroke, ...]:
    """The lines of the part, where the file tells them."""
    file = strokes_of_file(sheet)
    if file is None:
        return ()
    strokes = [
        stroke_along(
            stroke.curve,
            Linetype.HIDDEN if stroke.role is StrokeRole.HIDDEN else Linetype.VISIBLE,
        )
        for stroke in file.part.strokes
    ]
    return tuple(stroke for stroke in strokes if stroke is not None)
