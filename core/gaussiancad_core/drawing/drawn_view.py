"""A view as it stands on a sheet."""

from dataclasses import dataclass, replace

from gaussiancad_core.drawing.view_placing import Placement
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.geometry.similarities import Similarity, turn_about
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role

CURVE_STEP = 1.0
"""px between the points of curves that are cut."""


@dataclass(frozen=True)
class DrawnView:
    """A view on a sheet.

    Attributes:
        role: which view.
        box: (x0, y0, x1, y1) sheet px between the centre lines of the outermost strokes.
        strokes: in sheet px, y down.
        plane_strokes: the same strokes in mm of the view's plane (right, up).
    """

    role: Role
    box: tuple[float, float, float, float]
    strokes: tuple[DrawnStroke, ...]
    plane_strokes: tuple[DrawnStroke, ...]

    def turned(self, angle: float, centre: tuple[float, float]) -> "DrawnView":
        """Turned by ``angle`` radians, from the sheet's right towards its bottom."""
        turn = turn_about(centre, angle)
        strokes = tuple(stroke.mapped(turn) for stroke in self.strokes)
        return replace(self, box=bounds(strokes), strokes=strokes)


def drawn_view(placement: Placement, plane_strokes: tuple[DrawnStroke, ...]) -> DrawnView:
    """The strokes of a view, given in mm of its plane, at its place on the sheet."""
    place = Similarity(scale=placement.scale, offset=placement.offset, flip=True)
    strokes = tuple(stroke.mapped(place) for stroke in plane_strokes)
    return DrawnView(placement.role, bounds(strokes), strokes, plane_strokes)
