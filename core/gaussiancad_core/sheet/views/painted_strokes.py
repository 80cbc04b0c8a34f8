"""Views by their strokes alone: the sheet as if nothing else were drawn on it."""

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import Chain
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet, painted_sheet
from gaussiancad_core.sheet.picture_noise import STEP
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.registration.view_masks import find_outline
from gaussiancad_core.sheet.registration.view_registration import view_box
from gaussiancad_core.sheet.sheet_stages import ReadView


def painted(strokes: Iterable[Stroke], clean: CleanSheet) -> CleanSheet:
    """The sheet with the visible ones of some strokes alone, px of the upright sheet."""
    chains = tuple(
        VectorStroke(Chain(tuple(map(tuple, _run_of(stroke, STEP).tolist()))), None)
        for stroke in strokes
        if stroke.linetype is Linetype.VISIBLE
    )
    return painted_sheet(VectorDrawing(chains, ()), clean.ink.shape, clean.turn)


def view_by_strokes(
    role: Role,
    strokes: tuple[Stroke, ...],
    part: CleanSheet,
    supersampling: int,
    source: tuple[StrokesSource, float | None, float],
) -> ReadView:
    """A view with the outline that its strokes enclose.

    Args:
        role: of the view.
        strokes: px of the upright sheet, some of them visible.
        part: the sheet with the strokes.
        supersampling: mask px per sheet px.
        source: where they come from, px up to which a hidden one may be one dash, and px of the
            grid to which the file was rounded.
    """
    bounds = visible_bounds(strokes)
    outline = find_outline(part, bounds, supersampling)
    exact = source[0] is StrokesSource.VECTOR
    box = bounds if outline is None else view_box(strokes, outline, exact=exact)
    return ReadView(role, box, strokes, outline, *source)


def visible_bounds(strokes: Sequence[Stroke]) -> Box:
    """The box around the visible strokes."""
    points = np.concatenate(
        [_run_of(stroke, 1.0) for stroke in strokes if stroke.linetype is Linetype.VISIBLE]
    )
    (x0, y0), (x1, y1) = points.min(0).tolist(), points.max(0).tolist()
    return x0, y0, x1, y1


def _run_of(segment: Stroke, step: float) -> npt.NDArray[np.float64]:
    """(n, 2) points that a stroke runs through: of a straight one its ends tell all."""
    return (
        np.array([segment.start, segment.end])
        if isinstance(segment, Segment)
        else segment.sample(step)
    )
