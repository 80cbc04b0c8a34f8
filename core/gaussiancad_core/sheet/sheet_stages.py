"""The sheet's stages in order: image -> named views with strokes -> views on shared axes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.points import box_around
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.length_units import LONGEST_MM, SHORTEST_MM
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Linetype, Stroke, ViewSet
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.labels.label_evidence import NO_LABELS, SheetLabels
from gaussiancad_core.sheet.picture_noise import ON_LINE
from gaussiancad_core.sheet.reading_options import Box, ReadingOptions
from gaussiancad_core.sheet.registration.face_outlines import (
    outline_as_if_closed,
    outline_of_strokes,
)
from gaussiancad_core.sheet.registration.seen_coordinates import PlaneView
from gaussiancad_core.sheet.registration.shared_axes import share_axes
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource, precision_of
from gaussiancad_core.sheet.registration.through_holes import Extent, ViewEvidence, is_through
from gaussiancad_core.sheet.registration.view_masks import (
    Outline,
    Region,
    find_outline,
    supersampling_for,
)
from gaussiancad_core.sheet.registration.view_registration import (
    DEFAULT_LONGEST_MM,
    AxisExtents,
    Placement,
    axis_extents,
    make_view,
    placement,
    shared_placement,
    strokes_in_plane,
    view_box,
)
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet, vector_views
from gaussiancad_core.sheet.views.outside_strokes import without_outside
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_protocol.codes import Code

_MOST_STROKES = 3000
"""Of a view: each is looked at beside the others, and parts have some hundred."""

_CHORD = 1.5
"""px of the chords that stand for a curve at most."""

Ring = tuple[tuple[float, float], ...]
"""Corners of a polygon."""


@dataclass(frozen=True)
class ReadView:
    """A named view with its strokes, in px of the upright sheet.

    Attributes:
        role: of the view.
        box: between the centre lines of the outermost strokes.
        strokes: visible and hidden.
        outline: its filled contour and blank regions; None where it is open, or encloses nothing.
        source: where its strokes come from.
        dash: px up to which a hidden stroke may be one dash, as solid as a visible one; None where
            the pens or the file tell linetypes.
        step: px of the grid to which its file was rounded; 0 of exact files, and of pictures.
        hatched: of a section the outlines of what is cut: an odd number of them surrounds it.
        opened: corners of the region that is cut open; empty where that is all of the view.
        labels: what the lines of its ink were taken for; nothing where no labels told it.
        tangents: lines that were taken off, for faces meet smoothly there.
    """

    role: Role
    box: Box
    strokes: tuple[Stroke, ...]
    outline: Outline | None
    source: StrokesSource = StrokesSource.RASTER
    dash: float | None = None
    step: float = 0.0
    hatched: tuple[Ring, ...] = ()
    opened: Ring = ()
    labels: SheetLabels = NO_LABELS
    tangents: tuple[Stroke, ...] = ()

    @property
    def closed(self) -> Outline:
        """The outline of a view that has one, as :func:`register_views` demands."""
        if self.outline is None:
            raise ValueError("the outline is open")
        return self.outline

    @property
    def has_hidden_lines(self) -> bool:
        """Whether it has any."""
        return any(stroke.linetype is Linetype.HIDDEN for stroke in self.strokes)

    def stored_box(self, turn: Turn) -> Box:
        """The view's box in px of the sheet as stored, before it was turned."""
        solid = [s for s in self.strokes if s.linetype is Linetype.VISIBLE]
        if not turn.angle or not solid:
            return turn.box_to_stored(self.box)
        points = turn.to_stored(np.concatenate([stroke.sample(1.0) for stroke in solid]))
        low, high = points.min(0), points.max(0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])


@dataclass(frozen=True)
class RegisteredSheet:
    """Views on shared axes, and how they lie on the sheet.

    Attributes:
        views: in mm.
        placements: sheet px -> plane mm of each view.
        drawn: the views as they were read.
        mm_per_pixel: mean over the axes, of sheet px.
        extents: of the axes in sheet px.
        opened: number of through holes opened in the masks.
        given_axis: the axis whose extent was told; None where none was, or the scale.
        unseen: what is known of the axis that the only view does not show; None of several views.
        gaps: views whose outline is not closed, and was taken to be straight there.
    """

    views: ViewSet
    placements: dict[Role, Placement]
    drawn: tuple[ReadView, ...]
    mm_per_pixel: float
    extents: AxisExtents
    opened: int
    given_axis: Axis | None = None
    unseen: Unseen | None = None
    gaps: tuple[ReadView, ...] = ()

    @property
    def source(self) -> StrokesSource:
        """Where the strokes come from: the file only if it has those of every view."""
        exact = all(view.source is not StrokesSource.RASTER for view in self.drawn)
        return StrokesSource.VECTOR if exact else StrokesSource.RASTER


def read_views(
    sheet: CleanSheet,
    layout: Layout,
    progress: Callable[[float], None] = lambda _: None,
    vectors: VectorSheet | None = None,
) -> tuple[ReadView, ...]:
    """Strokes and outlines of the views of a layout.

    The exact lines of a file are taken for the views whose ink they explain.

    Args:
        sheet: the ink.
        layout: where the views are.
        progress: told the fraction done.
        vectors: of a file that has exact lines.

    Returns:
        The views; those whose outline is open without one.
    """
    exact = vector_views(vectors, sheet, layout) if vectors is not None else {}
    traced: dict[Role, tuple[Stroke, ...]] = {}
    dash = None
    rest = {role: box for role, box in layout.boxes.items() if role not in exact}
    if rest:
        # What follows pixels is compiled: a sheet whose strokes are known waits for none of it.
        from gaussiancad_core.sheet.tracing.traced_views import traced_views

        traced, dash = traced_views(sheet, rest, progress)
    largest = max(max(x1 - x0, y1 - y0) for x0, y0, x1, y1 in layout.boxes.values())
    supersampling = supersampling_for(largest)
    drawn = []
    for role, box in layout.boxes.items():
        step, source = 0.0, StrokesSource.RASTER
        if role in exact:
            (strokes, step), source = exact[role], StrokesSource.VECTOR
        else:
            strokes = traced[role]
        if source is StrokesSource.VECTOR:
            outline = _outline_of(strokes, supersampling)
        else:
            outline = find_outline(sheet, box, supersampling)
        this_view_box = box
        if outline is not None:
            if source is StrokesSource.RASTER:
                strokes = without_outside(strokes, outline)
            this_view_box = view_box(strokes, outline, exact=source is StrokesSource.VECTOR)
        this_dash = dash if source is StrokesSource.RASTER else None
        drawn.append(ReadView(role, this_view_box, strokes, outline, source, this_dash, step))
    return tuple(drawn)


def _outline_of(strokes: Sequence[Stroke], supersampling: int) -> Outline | None:
    """What the visible strokes of a file enclose; None where that is open."""
    curves = [stroke.vertices(_CHORD) for stroke in strokes if stroke.linetype is Linetype.VISIBLE]
    return outline_of_strokes(curves, box_around(np.concatenate(curves)), supersampling)


def _with_outline(view: ReadView) -> ReadView:
    """A view with the outline that it has if what is missing of it is straight.

    Raises:
        NoModelError: ``open-outline`` where it encloses nothing.
    """
    x0, y0, x1, y1 = view.box
    if min(x1 - x0, y1 - y0) < ON_LINE:
        # Two edges that melted into one line are closed, and bound nothing.
        fault = "encloses nothing, its edges are one line: export the sheet with more pixels"
        raise _open(view, fault, "thin")
    if view.outline is not None:
        return view
    visible = [stroke for stroke in view.strokes if stroke.linetype is Linetype.VISIBLE]
    curves = [stroke.vertices(_CHORD) for stroke in visible or view.strokes]
    closed = outline_as_if_closed(curves, view.box, supersampling_for(max(x1 - x0, y1 - y0)))
    if closed is None:
        raise _open(view, "encloses nothing: draw its visible edges without gaps", "gap")
    box = view_box(view.strokes, closed, exact=view.source is StrokesSource.VECTOR)
    return replace(view, outline=closed, box=box)


def _open(view: ReadView, fault: str, case: str) -> NoModelError:
    x0, y0, x1, y1 = view.box
    return NoModelError(
        Code.OPEN_OUTLINE,
        "the outline of the {view} view at {place} px {fault}",
        boxes=[view.box],
        view=view.role,
        place=f"({x0:.0f}, {y0:.0f})-({x1:.0f}, {y1:.0f})",
        case=case,
        fault=fault,
    )


def register_views(
    drawn: tuple[ReadView, ...], options: ReadingOptions, unseen: Unseen | None = None
) -> RegisteredSheet:
    """Bring views onto shared axes in mm.

    Args:
        drawn: the views, px of the upright sheet.
        options: with the scale, if it is known.
        unseen: of the axis that a view alone does not show.

    Raises:
        NoModelError: ``open-outline`` if a view encloses nothing; ``part-too-complex``;
            ``size-out-of-range``; the views contradict each other.
    """
    for view in drawn:
        check_amount(view)
    gaps = tuple(view for view in drawn if view.outline is None)
    drawn = tuple(map(_with_outline, drawn))
    hidden_axis = unseen.axis if unseen is not None else None
    extents = axis_extents({view.role: view.box for view in drawn}, hidden_axis)
    plain = [_unscaled_placement(view) for view in drawn]
    shared = share_axes(
        [_in_own_plane(view, place) for view, place in zip(drawn, plain, strict=True)]
    )
    scale = _scale(shared.extents, options)
    along = dict(shared.extents)
    if unseen is not None:
        along[unseen.axis] = unseen.extent(shared.extents, scale)
    extents = replace(extents, extents=along, residuals=shared.residuals)
    width, depth, height = (along[axis] for axis in Axis)
    pixels = width, depth, height
    size = width * scale, depth * scale, height * scale
    _check_size(max(size))
    placements = {}
    strokes = {}
    for place, view_map, moved in zip(plain, shared.maps, shared.strokes, strict=True):
        box = shared_placement(place, view_map, pixels).box
        placements[place.role] = placement(place.role, box, size)
        strokes[place.role] = tuple(stroke.mapped(Similarity(scale)) for stroke in moved)
    views = []
    opened = 0
    for view in drawn:
        holes = _through_holes(view, drawn) if options.open_holes else ()
        opened += len(holes)
        this_view_map = make_view(
            placements[view.role],
            strokes[view.role],
            view.closed.without(holes),
            view.closed,
            scale / view.closed.supersampling,
        )
        views.append(this_view_map)
    stated = _scaling(shared.extents, options)
    found = ViewSet(tuple(views), size)
    return RegisteredSheet(
        found, placements, drawn, scale, extents, opened, stated and stated[0], unseen, gaps
    )


def check_amount(view: ReadView) -> None:
    """Refuse a view of more lines than any part has.

    Raises:
        NoModelError: ``part-too-complex``.
    """
    if len(view.strokes) > _MOST_STROKES:
        raise NoModelError(
            Code.PART_TOO_COMPLEX,
            "the {view} view has {count:,} lines, more than the {most:,} that a part is made from: "
            "draw less in one sheet",
            boxes=[view.box],
            view=view.role,
            count=len(view.strokes),
            most=_MOST_STROKES,
        )


def _check_size(longest: float) -> None:
    if not SHORTEST_MM <= longest <= LONGEST_MM:
        raise NoModelError(
            Code.SIZE_OUT_OF_RANGE,
            "by its scale the part is {longest:.3g} mm long, and parts of {least:g} to {most:g} mm "
            "are built: pass its true size with --length AXIS=MM",
            longest=longest,
            least=SHORTEST_MM,
            most=LONGEST_MM,
        )


def _unscaled_placement(view: ReadView) -> Placement:
    """The view's box in its plane, in px and with its own extents."""
    x0, y0, x1, y1 = view.box
    frame = view.role.frame
    size = [0.0, 0.0, 0.0]
    size[frame.right_axis[0].value], size[frame.up_axis[0].value] = x1 - x0, y1 - y0
    return placement(view.role, view.box, (size[0], size[1], size[2]))


def _in_own_plane(view: ReadView, place: Placement) -> PlaneView:
    x0, y0, x1, y1 = view.box
    strokes = strokes_in_plane(view.strokes, place)
    return PlaneView(view.role, strokes, (x1 - x0, y1 - y0), precision_of(view.source, view.step))


def _scale(extents: dict[Axis, float], options: ReadingOptions) -> float:
    """mm per sheet px, for a part whose extents are so many."""
    if options.mm_per_pixel is not None:
        return options.mm_per_pixel
    if stated := _scaling(extents, options):
        axis, length = stated
        return length / extents[axis]
    return DEFAULT_LONGEST_MM / max(extents.values())


def _scaling(extents: dict[Axis, float], options: ReadingOptions) -> tuple[Axis, float] | None:
    """The length that the scale is taken from."""
    return options.scaling_length(extents) if options.mm_per_pixel is None else None


def _through_holes(view: ReadView, drawn: tuple[ReadView, ...]) -> tuple[Region, ...]:
    """Regions of a view that the other views prove to be through holes."""
    others = [
        ViewEvidence(
            other.role,
            other.strokes,
            other.box,
            other.closed.mask,
            float(other.closed.supersampling),
            other.closed.offset,
        )
        for other in drawn
        if other.role is not view.role
    ]
    regions = view.closed.regions
    interior = [index for index, region in enumerate(regions) if not _on_outline(region, view)]
    found = []
    for index in interior:
        around = [_extent(regions[p], view) for p in regions[index].parents if p in interior]
        extent = _extent(regions[index], view)
        if is_through(view.role, extent, around, others, tolerance=2.0):
            found.append(regions[index])
    return tuple(found)


def _on_outline(region: Region, view: ReadView) -> bool:
    """Whether a region reaches the view's own outline: then it is no hole."""
    x, y = region.corner
    height, width = region.mask.shape
    depth = view.closed.depth[y : y + height, x : x + width]
    return bool((region.mask & (depth < 2.0)).any())


def _extent(region: Region, view: ReadView) -> Extent:
    """Interval of a region on the axes of its view, as fractions of the part's size."""
    frame = view.role.frame
    factor = view.closed.supersampling
    ox, oy = view.closed.offset
    x0, y0, x1, y1 = (value / factor for value in region.box)
    bx0, by0, bx1, by1 = view.box
    right = ((x0 + ox - bx0) / (bx1 - bx0), (x1 + ox - bx0) / (bx1 - bx0))
    up = ((by1 - y1 - oy) / (by1 - by0), (by1 - y0 - oy) / (by1 - by0))
    return {
        axis: interval if sign > 0 else (1.0 - interval[1], 1.0 - interval[0])
        for (axis, sign), interval in ((frame.right_axis, right), (frame.up_axis, up))
    }
