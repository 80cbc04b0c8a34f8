"""The strokes of a file in mm of paper, without what nobody sees."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import Colour, StrokeKind, VectorDrawing, VectorStroke
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke, PaperText, Pen

_WHITE = 250
"""Grey level from which a colour is the paper's."""

_DOT = 0.01
"""mm up to which a stroke is a dot, and has no direction."""

_A4_MM, _USUAL_DPI = 297.0, 200.0
"""Longer side of the sheet that a drawing without paper is thought to fill, as letters and
arrowheads have no size otherwise; px of an inch where nothing is said."""

Paint = Callable[[Box], npt.NDArray[np.uint8]]


def paper_of_file(
    drawing: VectorDrawing,
    shape: tuple[int, int],
    pixels_per_inch: float | None,
    paint: Paint | None = None,
) -> PaperSheet:
    """A sheet in mm.

    Args:
        drawing: of the file, px of the sheet as stored.
        shape: height and width of that, px.
        pixels_per_inch: of it; None where nobody knows.
        paint: grey levels within a box in mm.
    """
    mm = 25.4 / (pixels_per_inch or _USUAL_DPI)
    if not drawing.has_paper:
        mm = _A4_MM / max(shape)
    strokes, fills = [], []
    to_mm = Similarity(mm)
    pens: dict[tuple[float | None, Colour | None, str], Pen] = {}
    for stroke in drawing.strokes:
        if stroke.colour is not None and min(stroke.colour) >= _WHITE:
            continue
        look = stroke.width, stroke.colour, stroke.layer
        if look not in pens:
            pens[look] = Pen(round((stroke.width or 0.0) * mm, 2), stroke.colour, stroke.layer)
        of_paper = _on_paper(stroke, pens[look], to_mm)
        if stroke.kind is StrokeKind.FILL:
            fills.append(of_paper)
        elif of_paper.length >= _DOT:
            strokes.append(of_paper)
    return PaperSheet(
        (shape[1] * mm, shape[0] * mm),
        tuple(strokes),
        tuple(PaperText(text.text, _scaled(text.box, mm), text.angle) for text in drawing.texts),
        tuple(fills),
        tuple(_scaled(box, mm) for box in drawing.pictures if np.isfinite(box).all()),
        drawing.has_paper,
        1.0 / mm,
        paint,
    )


def _on_paper(stroke: VectorStroke, pen: Pen, to_mm: Similarity) -> PaperStroke:
    mm = to_mm.scale
    dashes = tuple(length * mm for length in stroke.dashes)
    curve = stroke.curve.mapped(to_mm)
    return PaperStroke(curve, pen, dashes, stroke.role, stroke.kind, stroke.step * mm)


def _scaled(box: Box, by: float) -> Box:
    x0, y0, x1, y1 = box
    return x0 * by, y0 * by, x1 * by, y1 * by
