"""A solid on a sheet: lines of each view, placed, annotated, drawn."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.annotating import annotate, reserved_corner, sheet_dpi
from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.breaks import break_view
from gaussiancad_core.drawing.degrade import Image, finished
from gaussiancad_core.drawing.drawn_halves import halve_view
from gaussiancad_core.drawing.drawn_threads import draw_threads
from gaussiancad_core.drawing.drawn_view import DrawnView, drawn_view
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.insets import draw_inset
from gaussiancad_core.drawing.isometric_picture import ISOMETRIC, draw_picture
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.drawing.view_placing import Placement, check_roles, place_views
from gaussiancad_core.errors import UsageError
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.kernel.brep import bounding_box, moved_to_origin
from gaussiancad_core.lines.cut_solids import SectionView, openings_of, section_view
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions
from gaussiancad_core.lines.smooth_edges import smooth_edges
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype
from gaussiancad_protocol.codes import Code


@dataclass(frozen=True)
class PartLines:
    """The lines of a solid, which sheets of any style can be made of.

    Attributes:
        size: (3,) extent in mm of the part; its bounding box starts at the origin.
        views: role -> strokes in mm of the view's plane (right, up), in the order asked for.
        picture: strokes of the isometric picture in mm of its plane; empty without one.
        sections: views that are cut open instead, for styles that ask for it.
        thin: role -> visible smooth edges that are drawn thin, mm of the view's plane.
    """

    size: npt.NDArray[np.float64]
    views: dict[Role, tuple[DrawnStroke, ...]]
    picture: tuple[DrawnStroke, ...] = ()
    sections: dict[tuple[Role, SectionKind], SectionView] = field(default_factory=dict)
    thin: dict[Role, tuple[DrawnStroke, ...]] = field(default_factory=dict)


@dataclass(frozen=True)
class Sheet:
    """A drawn sheet.

    Attributes:
        image: (h, w, 3) uint8 RGB.
        mm_per_pixel: scale of all views.
        projection: first or third angle.
        views: in the order they were asked for.
        annotations: what was drawn beside the part's lines, in sheet px; empty without any.
        dpi: resolution at which the sheet's scale note is true; None if there is none.
    """

    image: Image
    mm_per_pixel: float
    projection: Projection
    views: tuple[DrawnView, ...]
    annotations: tuple[Annotation, ...] = ()
    dpi: float | None = None

    def __getitem__(self, role: Role) -> DrawnView:
        return next(view for view in self.views if view.role is role)


def part_lines(
    shape: TopoDS_Shape,
    roles: tuple[Role, ...],
    *,
    tangent_edges: TangentPolicy = TangentPolicy.LEFT_OUT,
    picture: bool = False,
    sections: tuple[tuple[Role, SectionKind], ...] = (),
) -> PartLines:
    """The lines of a solid in several views: the slow part of drawing a sheet.

    Args:
        shape: solid in mm; it is moved so that its bounding box starts at the origin.
        roles: two to six different views.
        tangent_edges: what becomes of smooth edges; what the style says of them counts no more.
        picture: draw the isometric picture as well, for styles that ask for it.
        sections: cut these views open as well, for styles that ask for it.

    Raises:
        UsageError: ``views-count``, ``views-repeat``.
    """
    check_roles(roles)
    shape = moved_to_origin(shape)
    options = LineOptions(tangent_edges=tangent_edges is TangentPolicy.DRAWN)
    drawing = LineDrawing(shape, options)
    views = {role: drawing.view(role) for role in roles}
    seen = drawing.seen(ISOMETRIC) if picture else ()
    cut = {
        (role, kind): section_view(shape, role, openings_of(shape, role, kind), options)
        for role, kind in sections
    }
    thin = _thin(shape, views) if tangent_edges is TangentPolicy.THIN else {}
    return PartLines(bounding_box(shape)[1], views, seen, cut, thin)


def _thin(
    shape: TopoDS_Shape, views: dict[Role, tuple[DrawnStroke, ...]]
) -> dict[Role, tuple[DrawnStroke, ...]]:
    """The smooth edges that views show; thin lines show none that are hidden (ISO 128-3)."""
    return {
        role: tuple(stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE)
        for role, strokes in smooth_edges(shape, views).items()
    }


def draw_sheet(
    shape: TopoDS_Shape,
    roles: tuple[Role, ...],
    projection: Projection,
    style: SheetStyle,
    seed: int = 0,
    *,
    title: str = "PART",
) -> Sheet:
    """Draw a solid as a sheet of views.

    Args:
        shape: solid in mm; it is moved so that its bounding box starts at the origin.
        roles: two to six different views.
        projection: decides where the views stand.
        style: the look.
        seed: of the defects, where the style has any.
        title: of the title block, where the style has one.

    Raises:
        UsageError: views or sheet size that cannot be.
    """
    lines = part_lines(
        shape,
        roles,
        tangent_edges=style.tangent_edges,
        picture=style.picture,
        sections=((style.section, style.section_kind),) if style.section else (),
    )
    return compose_sheet(lines, projection, style, seed, title=title)


def compose_sheet(
    lines: PartLines,
    projection: Projection,
    style: SheetStyle,
    seed: int = 0,
    *,
    title: str = "PART",
) -> Sheet:
    """Place the lines of a solid on a sheet, annotate and draw them.

    Args:
        lines: of the solid, each view.
        projection: decides where the views stand.
        style: the look.
        seed: of the defects, where the style has any.
        title: of the title block, where the style has one.

    Raises:
        UsageError: ``sheet-too-small``; ``style-value-bad``, the section is none of the views.
    """
    placements = place_views(
        lines.size, tuple(lines.views), projection, style, reserved_corner(style)
    )
    cut = lines.sections.get((style.section, style.section_kind)) if style.section else None
    if style.section and (cut is None or style.section not in lines.views):
        raise UsageError(
            Code.STYLE_VALUE_BAD,
            f"style section={style.section.value}: name one of the views that are drawn",
        )
    plain = dict(lines.views)
    if cut is not None and style.section is not None:
        plain[style.section] = cut.strokes
    views = tuple(drawn_view(place, _shown(plain[place.role], style)) for place in placements)
    scale = 1.0 / placements[0].scale
    symmetry: list[Annotation] = []
    if style.half is not None:
        halved = {view.role: view for view in views}
        if style.half in halved:
            halved[style.half], symmetry = halve_view(halved[style.half], style)
            views = tuple(halved.values())
    whole = tuple(view for view in views if view.role is not style.half)
    annotations = annotate(whole, projection, scale, style, title) + tuple(symmetry)
    if style.picture:
        annotations += tuple(draw_picture(lines.picture, views, annotations, style))
    if style.broken is not None:
        kept = {view.role: view for view in views}
        if style.broken in kept:
            kept[style.broken], note = break_view(kept[style.broken], style)
            views = tuple(kept.values())
            annotations += (note,)
    if style.threads:
        annotations += tuple(draw_threads(views, style))
    if style.inset is not None:
        annotations += tuple(draw_inset(views, annotations, style))
    if cut is not None:
        place = next(place for place in placements if place.role is style.section)
        annotations += _hatching(cut, place, style)
    annotations += _thin_lines(lines, placements, style)
    if style.skew:
        # Counter-clockwise to the eye is clockwise where y points down.
        angle, centre = -float(np.radians(style.skew)), (style.width / 2.0, style.height / 2.0)
        views = tuple(view.turned(angle, centre) for view in views)
        annotations = tuple(annotation.turned(angle, centre) for annotation in annotations)
    ink = rasterise(tuple(stroke for view in views for stroke in view.strokes), style)
    if annotations:
        ink = np.maximum(ink, ink_annotations(annotations, style))
    dpi = sheet_dpi(scale) if style.frame else None
    return Sheet(finished(ink, style, seed), scale, projection, views, annotations, dpi)


def _thin_lines(
    lines: PartLines, placements: Sequence[Placement], style: SheetStyle
) -> tuple[Annotation, ...]:
    """The smooth edges of whole views as thin lines; cut, halved and broken ones have none."""
    changed = (style.section, style.half, style.broken)
    found = []
    for place in placements:
        strokes = lines.thin.get(place.role, ())
        if strokes and place.role not in changed:
            down = Similarity(scale=place.scale, offset=place.offset, flip=True)
            mapped = tuple(stroke.mapped(down) for stroke in strokes)
            found.append(Annotation(AnnotationKind.TANGENT_EDGE, 0, mapped, style.annotation_width))
    return tuple(found)


def _shown(strokes: tuple[DrawnStroke, ...], style: SheetStyle) -> tuple[DrawnStroke, ...]:
    """The strokes of a view that a style draws."""
    if style.hidden:
        return strokes
    return tuple(stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE)


def _hatching(cut: SectionView, place: Placement, style: SheetStyle) -> tuple[Annotation, ...]:
    down = Similarity(scale=place.scale, offset=place.offset, flip=True)
    lines = tuple(line.mapped(down) for line in cut.hatching(style.hatch_pitch / place.scale))
    if not lines:
        return ()
    return (Annotation(AnnotationKind.HATCHING, 0, lines, style.annotation_width),)
