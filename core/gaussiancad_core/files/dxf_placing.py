"""A DXF page's curves and texts where they lie on the sheet, px."""

import numpy as np

from gaussiancad_core.files.dxf_entities import DrawnCurve, Explosion
from gaussiancad_core.files.dxf_text import PlacedText
from gaussiancad_core.files.file_curves import placed
from gaussiancad_core.files.file_grid import WrittenPath, line_ends, with_steps
from gaussiancad_core.files.fitting import curve_along, thinned
from gaussiancad_core.files.sizing import MILLIMETRE, Sizing
from gaussiancad_core.files.vectors import StrokeKind, VectorDrawing, VectorStroke, VectorText
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.points import Box


def placed_drawing(found: Explosion, sheet: Box, sizing: Sizing) -> VectorDrawing:
    """Curves and texts of a page, px.

    Args:
        found: units of the drawing, y up.
        sheet: (x0, y0, x1, y1) of the paper in the same.
        sizing: of the paper.
    """
    left, top = sheet[0], sheet[3]
    strokes = with_steps([_path(drawn, left, top, sizing) for drawn in found.curves])
    texts = tuple(_text(text, left, top, sizing.scale) for text in found.texts)
    return VectorDrawing(strokes, texts, found.complete)


def _path(drawn: DrawnCurve, left: float, top: float, sizing: Sizing) -> WrittenPath:
    curve = drawn.curve
    lines = [np.array([curve.start, curve.end])] if isinstance(curve, LineSegment) else []
    stroke = _stroke(drawn, left, top, sizing)
    return WrittenPath(lambda _: (stroke,), line_ends(lines), sizing.scale * np.eye(2, 3))


def _stroke(drawn: DrawnCurve, left: float, top: float, sizing: Sizing) -> VectorStroke:
    curve = placed(drawn.curve, sizing.scale, left, top)
    look = drawn.look
    if isinstance(curve, Chain) and look.kind is not StrokeKind.FILL:
        curve = thinned(curve_along(np.array(curve.points)))
    if drawn.width is not None:
        width: float | None = drawn.width * sizing.scale
    elif look.weight is not None and sizing.on_paper and sizing.pixels_per_inch is not None:
        width = look.weight * MILLIMETRE * sizing.pixels_per_inch
    else:
        width = None
    dashes = tuple(value * sizing.scale for value in look.dashes)
    return VectorStroke(curve, width, dashes, look.role, look.layer, look.kind, look.colour)


def _text(text: PlacedText, left: float, top: float, scale: float) -> VectorText:
    x, y = (text.centre[0] - left) * scale, (top - text.centre[1]) * scale
    c, s = abs(np.cos(text.angle)), abs(np.sin(text.angle))
    half_width = float(text.length * c + text.height * s) * scale / 2.0
    half_height = float(text.length * s + text.height * c) * scale / 2.0
    box = (x - half_width, y - half_height, x + half_width, y + half_height)
    return VectorText(text.text, box, -text.angle)
