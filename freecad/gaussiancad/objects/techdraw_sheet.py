"""A TechDraw page as a sheet for the engine: an SVG file of its views' edges, visible and hidden,
its dimensions, and notes of its scale, unit and projection.

TechDraw's own exports draw hidden edges as the user's preferences say, solid ones too, and its SVG
export needs a window.  The edges themselves say which they are, and need none.  The notes stand in
the file, so that whoever reads it knows what the document says.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import quoteattr

import FreeCAD
import Part

from freecad.gaussiancad.engine.job import Projection
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.edge_paths import edge_path
from freecad.gaussiancad.objects.techdraw_dimensions import dimension_elements, text_element

PIXELS_PER_MM = 200.0 / 25.4
"""The engine draws SVG files at 200 dpi of their paper."""

_VISIBLE = 'class="visible" stroke-width="0.5"'
_HIDDEN = 'class="hidden" stroke-width="0.35" stroke-dasharray="2 1"'

_SAME = 3
"""Decimals of a millimetre to which two edges are compared."""

_VIEW = "TechDraw::DrawViewPart"

_GROUP = "TechDraw::DrawProjGroup"
_DIMENSION = "TechDraw::DrawViewDimension"

_NOTE_X, _NOTE_Y, _NOTE_STEP = 12.0, 4.0, 5.0
"""mm from the left edge and the nearer border to the first note, and from one note to the next."""

_ROOM = 22.0
"""mm of the page's lower border that the notes need; with less room they stand at the top."""

_NOT_VIEWS = ("TechDraw::DrawViewSection", "TechDraw::DrawViewDetail")
"""Kinds of part views that show something else than the part from one side."""


@dataclass(frozen=True)
class PageExport:
    """A page that was written.

    Attributes:
        path: of the SVG file.
        mm_per_pixel: of the part, at the engine's resolution; None if the views' scales differ.
        projection: of the projection group that has the views; None where none has.
    """

    path: Path
    mm_per_pixel: float | None
    projection: Projection | None = None


@dataclass(frozen=True)
class _PlacedView:
    """A view and its centre on the page, in mm, y up."""

    view: FreeCAD.DocumentObject
    x: float
    y: float


def export_page(page: FreeCAD.DocumentObject, folder: Path) -> PageExport:
    """Write views, dimensions and notes of a page into an SVG file of the page's size.

    Args:
        page: a ``TechDraw::DrawPage``.
        folder: receives the file, which is named after the page.

    Raises:
        WorkbenchError: the page shows no view of a part.
    """
    width, height = _page_size(page)
    views = list(_placed_views(page))
    drawn = [text for placed in views for text in _view_paths(placed, height)]
    if not drawn:
        text = translate(
            "GaussianCAD",
            "The page {name} shows no views of a part. Recompute it, or choose another one.",
        )
        raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(name=page.Label))
    scales = {round(_scale(page, placed.view), 9) for placed in views}
    scale = scales.pop() if len(scales) == 1 else 0.0
    projection = _projection(page, views)
    drawn += _dimensions(page, views, height)
    drawn += _notes(scale, projection, _note_places(views, height))
    path = folder / f"{_file_name(page.Label)}.svg"
    head = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="0 0 {width:g} {height:g}">\n'
        '<g fill="none" stroke="black" stroke-linecap="round">\n'
    )
    path.write_text(head + "\n".join(drawn) + "\n</g></svg>\n", encoding="utf-8")
    mm_per_pixel = 1.0 / (PIXELS_PER_MM * scale) if scale > 0.0 else None
    return PageExport(path, mm_per_pixel, projection)


def _page_size(page: FreeCAD.DocumentObject) -> tuple[float, float]:
    """Width and height in mm."""
    template = page.Template
    if template is None:
        return 297.0, 210.0
    return _number(template.Width), _number(template.Height)


def _placed_views(page: FreeCAD.DocumentObject) -> Iterator[_PlacedView]:
    """The views of parts, those in projection groups too."""
    for view in page.Views:
        if view.isDerivedFrom(_GROUP):
            for item in view.Views:
                x, y = _number(view.X) + _number(item.X), _number(view.Y) + _number(item.Y)
                yield _PlacedView(item, x, y)
        elif view.isDerivedFrom(_VIEW) and not any(map(view.isDerivedFrom, _NOT_VIEWS)):
            yield _PlacedView(view, _number(view.X), _number(view.Y))


def _view_paths(placed: _PlacedView, page_height: float) -> Iterator[str]:
    """Path elements of a view's edges; a hidden edge under a visible one is left out."""
    origin = (placed.x, page_height - placed.y)
    seen: set[tuple[float, ...]] = set()
    name = quoteattr(placed.view.Label)
    groups = ((_VISIBLE, placed.view.getVisibleEdges()), (_HIDDEN, placed.view.getHiddenEdges()))
    for style, edges in groups:
        for edge in edges:
            key = _key(edge)
            data = edge_path(edge, origin)
            if data and key not in seen:
                seen.add(key)
                yield f'<path {style} d="{data}"><title>{name[1:-1]}</title></path>'


def _projection(page: FreeCAD.DocumentObject, views: list[_PlacedView]) -> Projection | None:
    """How the one group that has all views is projected; None where views stand by themselves, or
    in several groups."""
    groups = [view for view in page.Views if view.isDerivedFrom(_GROUP)]
    if len(groups) != 1 or len(views) != len(groups[0].Views):
        return None
    kind = groups[0].ProjectionType  # FreeCAD's versions differ in its capitals
    if kind.lower() == "default":
        kind = getattr(page, "ProjectionType", kind)
    if kind.lower() == "default":
        general = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/TechDraw/General")
        kind = "Third" if general.GetInt("ProjectionAngle", 0) == 1 else "First"
    return Projection.THIRD if kind.lower().startswith("third") else Projection.FIRST


def _dimensions(
    page: FreeCAD.DocumentObject, views: list[_PlacedView], page_height: float
) -> list[str]:
    """The page's dimensions of those views."""
    origins = {placed.view.Name: (placed.x, page_height - placed.y) for placed in views}
    found = []
    for dimension in page.Views:
        if dimension.isDerivedFrom(_DIMENSION) and dimension.References2D:
            origin = origins.get(dimension.References2D[0][0].Name)
            if origin is not None:
                found += dimension_elements(dimension, origin)
    return found


def _note_places(views: list[_PlacedView], page_height: float) -> Iterator[tuple[float, float]]:
    """Where notes stand, one under the other at the page's border: x and y in mm, y down."""
    lowest = max(
        page_height - placed.y + edge.BoundBox.YMax
        for placed in views
        for edge in placed.view.getVisibleEdges()
    )
    is_free = lowest < page_height - _ROOM
    first = page_height - _NOTE_Y - 2 * _NOTE_STEP if is_free else 2 * _NOTE_Y
    return ((_NOTE_X, first + number * _NOTE_STEP) for number in range(3))


def _notes(
    scale: float, projection: Projection | None, places: Iterator[tuple[float, float]]
) -> list[str]:
    """What the document says of the whole page, in words that the engine reads."""
    notes = ["DIMENSIONS IN MM"]
    if scale > 0.0:
        sides = (scale, 1.0) if scale >= 1.0 else (1.0, 1.0 / scale)
        notes.append(f"SCALE {sides[0]:.9g} : {sides[1]:.9g}")
    if projection is not None:
        notes.append(f"{projection.value.upper()} ANGLE PROJECTION")
    return [text_element(note, place) for note, place in zip(notes, places, strict=False)]


def _key(edge: Part.Edge) -> tuple[float, ...]:
    """Numbers that edges at the same place share, whichever way they run."""
    first, last = edge.FirstParameter, edge.LastParameter
    points = [edge.valueAt(value) for value in (first, last)]
    ends = sorted((round(point.x, _SAME), round(point.y, _SAME)) for point in points)
    middle = edge.valueAt((first + last) / 2.0)
    return (*ends[0], *ends[1], round(middle.x, _SAME), round(middle.y, _SAME))


def _scale(page: FreeCAD.DocumentObject, view: FreeCAD.DocumentObject) -> float:
    """The scale at which a view's edges are given."""
    if hasattr(view, "getScale"):
        return float(view.getScale())
    return float(page.Scale if view.ScaleType == "Page" else view.Scale)


def _number(value: object) -> float:
    """A property in mm as a number."""
    return float(getattr(value, "Value", value))


def _file_name(label: str) -> str:
    """A label as the stem of a file's name."""
    return "".join("_" if char in '/\\:*?"<>|\0' else char for char in label).strip() or "page"
