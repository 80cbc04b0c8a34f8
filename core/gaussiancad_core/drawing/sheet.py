"""A solid on a sheet: lines of each view, placed, drawn."""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.drawing.brep import bounding_box, moved_to_origin
from gaussiancad_core.drawing.hlr import LineDrawing, LineOptions
from gaussiancad_core.drawing.layout import Placement, check_roles, place_views
from gaussiancad_core.drawing.raster import rasterise
from gaussiancad_core.drawing.strokes import DrawnStroke, extent, mapped, turned
from gaussiancad_core.drawing.style import SheetStyle

Image = npt.NDArray[np.uint8]


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


@dataclass(frozen=True)
class Sheet:
    """A drawn sheet.

    Attributes:
        image: (h, w, 3) uint8 RGB.
        mm_per_pixel: scale of all views.
        projection: first or third angle.
        views: in the order they were asked for.
    """

    image: Image
    mm_per_pixel: float
    projection: Projection
    views: tuple[DrawnView, ...]

    def __getitem__(self, role: Role) -> DrawnView:
        return next(view for view in self.views if view.role is role)


def draw_sheet(
    shape: TopoDS_Shape,
    roles: tuple[Role, ...],
    projection: Projection,
    style: SheetStyle,
    seed: int = 0,
) -> Sheet:
    """Draw a solid as a sheet of views.

    Args:
        shape: solid in mm; it is moved so that its bounding box starts at the origin.
        roles: two to six different views.
        projection: decides where the views stand.
        style: the look.
        seed: of the noise, where the style has any.

    Raises:
        UsageError: views or sheet size that cannot be.
    """
    check_roles(roles)
    shape = moved_to_origin(shape)
    drawing = LineDrawing(shape, LineOptions(tangent_edges=style.tangent_edges))
    size = bounding_box(shape)[1]
    placements = place_views(size, roles, projection, style)
    views = tuple(
        _drawn_view(placement, drawing.view(placement.role), style) for placement in placements
    )
    strokes = tuple(stroke for view in views for stroke in view.strokes)
    image = _finish(rasterise(strokes, style), style, seed)
    return Sheet(image, 1.0 / placements[0].scale, projection, views)


def _drawn_view(
    placement: Placement, plane_strokes: tuple[DrawnStroke, ...], style: SheetStyle
) -> DrawnView:
    strokes = tuple(
        mapped(stroke, placement.scale, placement.offset, flip=True) for stroke in plane_strokes
    )
    if style.skew:
        centre = (style.width / 2.0, style.height / 2.0)
        # Counter-clockwise to the eye is clockwise where y points down.
        strokes = tuple(turned(stroke, -np.radians(style.skew), centre) for stroke in strokes)
    (x0, y0), (x1, y1) = extent(strokes)
    box = (float(x0), float(y0), float(x1), float(y1))
    return DrawnView(placement.role, box, strokes, plane_strokes)


def _finish(ink: npt.NDArray[np.float32], style: SheetStyle, seed: int) -> Image:
    """Ink and paper in colour, blurred and noisy as the style asks."""
    if style.blur > 0.0:
        ink = cv2.GaussianBlur(ink, (0, 0), style.blur)
    paper, colour = (np.array(value, dtype=np.float32) for value in (style.paper, style.ink))
    image = paper + ink[..., None] * (colour - paper)
    if style.noise > 0.0:
        noise = np.random.default_rng(seed).standard_normal(ink.shape, dtype=np.float32)
        image += style.noise * noise[..., None]
    return np.clip(np.rint(image), 0.0, 255.0).astype(np.uint8)
