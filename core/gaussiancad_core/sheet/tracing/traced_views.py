"""The strokes of the views of a sheet that are told by its pixels, traced for all of them at once:
dashes and pens of one view tell those of another."""

from collections.abc import Callable, Mapping

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Stroke
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.twin_lines import with_twins
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

_ALONE = 0.6
"""Gaps by which a line may be longer than its only dash: lines at its ends cover the rest."""


def traced_views(
    sheet: CleanSheet, boxes: Mapping[Role, Box], progress: Callable[[float], None]
) -> tuple[dict[Role, tuple[Stroke, ...]], float | None]:
    """The strokes of each view, and px up to which a hidden one may be one dash; None where the
    pens tell linetypes.

    Args:
        sheet: the ink.
        boxes: of the views, px.
        progress: told the fraction done.
    """
    shapes = []
    for index, box in enumerate(boxes.values(), start=1):
        shapes.append(find_shapes(sheet, box))
        progress(index / (len(boxes) + 1))
    rhythm = view_rhythm(shapes, sheet.stroke_width)
    shapes = with_twins(shapes, rhythm)
    pens = view_pens(shapes, rhythm)
    strokes = [classify_strokes(view, rhythm, pens) for view in shapes]
    dash = None if pens.distinct else rhythm.dash + _ALONE * rhythm.gap
    return dict(zip(boxes, strokes, strict=True)), dash
