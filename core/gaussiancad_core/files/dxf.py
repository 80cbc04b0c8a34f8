"""DXF files: model space or a paper layout as exact curves, drawn at 200 dpi.

Pages are model space, if anything is drawn there, and then the paper layouts that show anything,
in the order of their tabs.  The sheet is the drawing's limits where the file has believable ones,
or else the drawing with a margin.
"""

import logging
import mmap
import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from ezdxf import recover
from ezdxf.document import Drawing
from ezdxf.entities.viewport import Viewport
from ezdxf.filemanagement import readfile
from ezdxf.layouts.layout import Layout, Modelspace, Paperspace

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.files.content import (
    MAX_ELEMENTS,
    FileContent,
    check_pixels,
    page_missing,
    too_many_elements,
)
from gaussiancad_core.files.dxf_entities import DrawnCurve, Exploder, Explosion
from gaussiancad_core.files.dxf_faults import BROKEN, left_out
from gaussiancad_core.files.dxf_paper import drawing_box, paper_box
from gaussiancad_core.files.dxf_placing import placed_drawing
from gaussiancad_core.files.far_strokes import far_strokes_left_out, near_numbers
from gaussiancad_core.files.painting import paint
from gaussiancad_core.files.sizing import (
    MILLIMETRE,
    Sizing,
    notes_on,
    size_drawing,
    size_without_unit,
)
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.geometry.points import Box
from gaussiancad_protocol.codes import Code

_MAX_BYTES = 256_000_000

_INCHES = {
    1: 1.0,
    2: 12.0,
    4: MILLIMETRE,
    5: 10.0 * MILLIMETRE,
    6: 1000.0 * MILLIMETRE,
    8: 1e-6,
    9: 1e-3,
    10: 36.0,
    13: 1e-3 * MILLIMETRE,
    14: 100.0 * MILLIMETRE,
}
"""Value of $INSUNITS -> inches, for the units that papers may be given in (DXF reference)."""

_MOST_METRES = 10.0
"""Longest side of a drawing whose unit is the metre: what is larger was drawn in millimetres by a
program that leaves the unit at its library's default, as writers with ezdxf do."""

_ENTITY = re.compile(rb"\n[ \t]*0[ \t]*\r?\n[ \t]*[A-Z]")
"""The start of an entity or table entry in a text file."""


@dataclass(frozen=True)
class _Page:
    """A page in units of the drawing, y up.

    Attributes:
        found: its curves and texts.
        limits: (x0, y0, x1, y1) of its paper as the file says, or None.
        inches_per_unit: as the file says, or None.
        pages: of the file.
        is_model: whether it is model space, whose unit is the part's own.
        brought_together: the one page that shows parts of model space through several windows.
    """

    found: Explosion
    limits: Box | None
    inches_per_unit: float | None
    pages: int
    is_model: bool = False
    brought_together: int | None = None


def read_dxf(path: Path, page: int) -> FileContent:
    """Read a page of a DXF file, text or binary, of any version; broken ones as far as possible.

    Raises:
        UnreadableError: ``damaged-dxf``, ``empty-drawing``, ``page-missing``,
            ``image-too-large``.
        LimitError: ``too-many-elements``, ``drawing-file-too-large``.
    """
    _check_size(path)
    doc = _load(path)
    content = _page(doc, path, page)
    drawn = content.found.curves
    near = near_numbers([one.curve for one in drawn])
    far = len(drawn) - len(near)
    content.found.curves = [drawn[number] for number in near.tolist()]
    curves = [one.curve for one in content.found.curves]
    box = bounds(curves) if curves else (0.0, 0.0, 0.0, 0.0)
    if max(box[2] - box[0], box[3] - box[1]) <= 0.0:
        raise UnreadableError(
            Code.EMPTY_DRAWING,
            "{path} has no lines on page {page}: choose another page or file",
            path=path,
            page=page,
        )
    paper = paper_box(box, content.limits)
    sheet = paper or drawing_box(box, content.found.texts)
    width, height = sheet[2] - sheet[0], sheet[3] - sheet[1]
    inches_per_unit = content.inches_per_unit
    if inches_per_unit == 1000.0 * MILLIMETRE and max(width, height) > _MOST_METRES:
        inches_per_unit = None
    sizing = _sizing(doc, width, height, inches_per_unit)
    size = tuple(int(np.ceil(side * sizing.scale - 1e-6)) for side in (width, height))
    check_pixels(path, *size)
    vectors = placed_drawing(content.found, sheet, sizing)
    unit_mm = None if inches_per_unit is None else inches_per_unit / MILLIMETRE
    dpi = sizing.pixels_per_inch
    vectors = replace(
        vectors,
        has_paper=paper is not None,
        unit_mm=unit_mm if content.is_model else None,
        unit_px=None if dpi else sizing.scale,
    )
    notes = (
        *left_out(path, content.found.unread),
        *far_strokes_left_out(path, far),
        *notes_on(path, sizing),
    )
    picture = paint(vectors, *size)
    return FileContent(
        picture,
        dpi,
        vectors,
        notes,
        pages=content.pages,
        brought_together=content.brought_together,
    )


def _check_size(path: Path) -> None:
    """Refuse files that would take too long, before they are parsed."""
    size = path.stat().st_size
    if size > _MAX_BYTES:
        raise LimitError(
            Code.DRAWING_FILE_TOO_LARGE,
            "{path} has {size} MB, {most} are read: save only the views, or export it as PNG",
            path=path,
            size=size // 1_000_000,
            most=_MAX_BYTES // 1_000_000,
        )
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        for count, _ in enumerate(_ENTITY.finditer(data)):
            if count > MAX_ELEMENTS:
                raise too_many_elements(path)


def _load(path: Path) -> Drawing:
    logging.getLogger("ezdxf").setLevel(logging.CRITICAL)
    try:
        return readfile(path)
    except BROKEN:
        return _recovered(path)


def _recovered(path: Path) -> Drawing:
    """What the lenient parser makes of a file that the strict one stumbled over."""
    try:
        return recover.readfile(path)[0]
    except BROKEN as error:
        raise UnreadableError(
            Code.DAMAGED_DXF,
            "{path} is no DXF file, or is damaged ({reason}): save it again",
            path=path,
            reason=error,
        ) from error


def _page(doc: Drawing, path: Path, page: int) -> _Page:
    model = doc.modelspace()
    layouts: list[Layout] = [model] if len(model) else []
    names = [name for name in doc.layout_names_in_taborder() if name != model.name]
    layouts += [doc.layout(name) for name in names if _shows_anything(doc.layout(name), model)]
    if not layouts:
        layouts = [model]
    if not 1 <= page <= len(layouts):
        raise page_missing(path, len(layouts), page)
    layout = layouts[page - 1]
    exploder = Exploder(doc, path)
    if isinstance(layout, Modelspace):
        found, inches = exploder.explode(layout), _inches_per_unit(doc)
        together = [
            number
            for number, this_layout in enumerate(layouts, start=1)
            if not isinstance(this_layout, Modelspace) and len(_views_of_model(this_layout)) > 1
        ]
        return _Page(
            found,
            _model_limits(doc),
            inches,
            len(layouts),
            is_model=True,
            brought_together=together[0] if len(together) == 1 else None,
        )
    found = exploder.explode(entity for entity in layout if not isinstance(entity, Viewport))
    for viewport in _views_of_model(layout):
        shown = exploder.explode(model, viewport.get_transformation_matrix())
        low, high = viewport.clipping_rect()
        found.curves += [
            drawn for drawn in shown.curves if _lies_in(drawn, (low.x, low.y, high.x, high.y))
        ]
        found.complete &= shown.complete
        found.unread += shown.unread
    inches = 1.0 if layout.dxf.get("plot_paper_units", 1) == 0 else MILLIMETRE
    assert isinstance(layout, Paperspace)
    low, high = layout.get_paper_limits()
    return _Page(found, (low.x, low.y, high.x, high.y), inches, len(layouts))


def _shows_anything(layout: Layout, model: Layout) -> bool:
    if any(not isinstance(entity, Viewport) for entity in layout):
        return True
    return bool(len(model)) and bool(_views_of_model(layout))


def _views_of_model(layout: Layout) -> list[Viewport]:
    """The windows of a paper layout that show model space from above; the first is the paper."""
    return [
        viewport
        for viewport in layout.query("VIEWPORT")
        if isinstance(viewport, Viewport)
        and viewport.dxf.get("id", 0) != 1
        and viewport.dxf.get("status", 0) != 0
        and viewport.is_top_view
        and viewport.get_scale() > 0.0
    ]


def _lies_in(drawn: DrawnCurve, window: Box) -> bool:
    """Whether the middle of a curve is seen through a window."""
    points = drawn.curve.vertices(np.inf)
    x, y = points[len(points) // 2] if len(points) % 2 else points.mean(axis=0)
    return bool(window[0] <= x <= window[2] and window[1] <= y <= window[3])


def _model_limits(doc: Drawing) -> Box | None:
    try:
        low, high = (doc.header[name] for name in ("$LIMMIN", "$LIMMAX"))
        limits = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
    except (KeyError, TypeError, ValueError, IndexError):
        return None
    return limits


def _inches_per_unit(doc: Drawing) -> float | None:
    """Of model space; None where the file does not say."""
    try:
        return _INCHES.get(int(doc.header.get("$INSUNITS", 0)))
    except (ValueError, TypeError):
        return None


def _sizing(doc: Drawing, width: float, height: float, inches_per_unit: float | None) -> Sizing:
    """By the unit that the file names; else by that of its system of measurement, as a guess."""
    if inches_per_unit is not None:
        return size_drawing(width, height, inches_per_unit)
    guesses = (1.0, MILLIMETRE) if doc.header.get("$MEASUREMENT", 1) == 0 else (MILLIMETRE, 1.0)
    return size_without_unit(width, height, guesses)
