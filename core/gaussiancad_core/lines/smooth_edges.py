"""The tangent edges of a solid in its views: where its surface passes smoothly from face to face.

A part of a tangent edge that runs along a sharp edge or a silhouette is that, and no tangent edge.
"""

from collections.abc import Iterable
from dataclasses import replace

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.solid_edges import edge_facts
from gaussiancad_core.lines.coverage import StrokeIndex, uncovered
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype


def smooth_edges(
    shape: TopoDS_Shape,
    views: dict[Role, tuple[DrawnStroke, ...]],
    options: LineOptions | None = None,
) -> dict[Role, tuple[DrawnStroke, ...]]:
    """The tangent edges that each view shows, visible ones and hidden ones.

    Args:
        shape: solid in mm; its position is kept.
        views: role -> the other lines of the solid in that view, mm of its plane (right, up).
        options: how exactly.

    Returns:
        role -> strokes in mm of the view's plane; nothing of a solid without tangent edges.
    """
    if not any(facts.smooth and not facts.seam for facts in edge_facts(shape)):
        return {role: () for role in views}
    options = replace(options or LineOptions(), tangent_edges=True)
    low, high = bounding_box(shape)
    precision = options.precision(float((high - low).max()))
    drawing = LineDrawing(shape, options)
    return {
        role: tuple(_without(drawing.view(role), strokes, precision))
        for role, strokes in views.items()
    }


def _without(
    strokes: Iterable[DrawnStroke], others: Iterable[DrawnStroke], precision: Precision
) -> Iterable[DrawnStroke]:
    """What of strokes runs along no other of its linetype, and no visible one."""
    known = tuple(others)
    visible = [stroke for stroke in known if stroke.linetype is Linetype.VISIBLE]
    covering = {Linetype.VISIBLE: StrokeIndex(visible), Linetype.HIDDEN: StrokeIndex(known)}
    for stroke in strokes:
        near = covering[stroke.linetype].near(stroke, precision.cover)
        yield from uncovered(stroke, near, precision)
