"""Views of lines along the sheet, in mm."""

from collections.abc import Sequence

import shapely

from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Pen
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView

PEN = Pen(0.35, None, "")


def drawn(
    at: tuple[float, float],
    size: tuple[float, float],
    *edges: Sequence[float],
    kind: DrawingKind = DrawingKind.PLAIN,
    rough: float = 0.0,
) -> DrawnView:
    """A view: its outline, upright lines, level lines."""
    (x, y), (width, height), (upright, level) = at, size, edges
    lines = [((x + c, y), (x + c, y + height)) for c in (0.0, width, *upright)]
    lines += [((x, y + r), (x + width, y + r)) for r in (0.0, height, *level)]
    strokes = tuple(PaperStroke(LineSegment(a, b), PEN) for a, b in lines)
    box = x, y, x + width, y + height
    return DrawnView(box, strokes, shapely.box(*box), kind=kind, rough=rough)
