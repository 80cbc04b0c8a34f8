"""The content of a PDF page: stroked paths as exact curves, text with boxes.

Forms (reused parts of a page) are walked through with their matrices.  Lengths and dashes are in
the coordinates in which a path was drawn, so they are mapped like its points.
"""

import ctypes
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pypdfium2 as pdfium
from pypdfium2 import raw

from gaussiancad_core.files.beziers import curves_from_path, outlines
from gaussiancad_core.files.content import DEEPEST, MAX_ELEMENTS, PAPER_LEVEL, too_many_elements
from gaussiancad_core.files.file_grid import Strokes, WrittenPath, scale_of, with_steps
from gaussiancad_core.files.file_linetypes import role_by_dashes, role_by_name
from gaussiancad_core.files.pdf_texts import (
    Origins,
    TextPiece,
    address,
    joined_texts,
    letter_origins,
    text_piece,
)
from gaussiancad_core.files.vectors import Colour, StrokeKind, StrokeRole, VectorStroke, VectorText
from gaussiancad_core.geometry.points import Box, Point

Affine = npt.NDArray[np.float64]
"""(2, 3)"""

Pieces = list[npt.NDArray[np.float64]]
"""(2, 2) the ends of lines and (4, 2) Bézier curves."""

_MAX_SEGMENTS = 4 * MAX_ELEMENTS

_CLOSED = 1e-6
"""Units of the path within which it ends where it begins."""


@dataclass(frozen=True)
class PageMap:
    """Where a page's content goes.

    Attributes:
        to_pixels: (2, 3) from points of the page to px of the sheet.
        path: of the file, for messages.
    """

    to_pixels: Affine
    path: Path


@dataclass(frozen=True)
class PageContent:
    """Strokes and texts of a page in px, and boxes of what else it shows."""

    strokes: tuple[VectorStroke, ...]
    texts: tuple[VectorText, ...]
    pictures: tuple[Box, ...]


@dataclass
class _Walk:
    """What was found so far."""

    page: pdfium.PdfPage
    text_page: pdfium.PdfTextPage
    letters: Origins
    path: Path
    paths: list[WrittenPath] = field(default_factory=list)
    texts: list[TextPiece] = field(default_factory=list)
    pictures: list[Box] = field(default_factory=list)
    objects: int = 0
    segments: int = 0
    _maps: dict[tuple[object, ...], Affine] = field(default_factory=dict)

    def map_of(self, item: raw.FPDF_PAGEOBJECT, outer: Affine) -> Affine:
        """The map of an object: one array for all objects that are mapped alike."""
        matrix = raw.FS_MATRIX()
        key: tuple[object, ...] = (outer.tobytes(),)
        if raw.FPDFPageObj_GetMatrix(item, matrix):
            key += (matrix.a, matrix.b, matrix.c, matrix.d, matrix.e, matrix.f)
        if key not in self._maps:
            self._maps[key] = _composed(outer, _matrix(item))
        return self._maps[key]

    def count(self, objects: int, segments: int) -> None:
        """Note work done.

        Raises:
            LimitError: ``too-many-elements``.
        """
        self.objects += objects
        self.segments += segments
        if self.objects > MAX_ELEMENTS or self.segments > _MAX_SEGMENTS:
            raise too_many_elements(self.path)


def page_objects(page: pdfium.PdfPage, target: PageMap) -> PageContent:
    """Everything on a page that has exact geometry.

    Raises:
        LimitError: ``too-many-elements``.
    """
    text_page = page.get_textpage()
    try:
        letters = letter_origins(text_page, target.to_pixels)
        walk = _Walk(page, text_page, letters, target.path)
        count = raw.FPDFPage_CountObjects(page)
        walk.count(count, 0)
        objects = (raw.FPDFPage_GetObject(page, index) for index in range(count))
        _take_all(walk, objects, target.to_pixels, 0)
    finally:
        text_page.close()
    texts = tuple(joined_texts(walk.texts))
    return PageContent(with_steps(walk.paths), texts, tuple(walk.pictures))


def _take_all(
    walk: _Walk, objects: Iterator[raw.FPDF_PAGEOBJECT], outer: Affine, depth: int
) -> None:
    for item in objects:
        kind = raw.FPDFPageObj_GetType(item)
        if kind == raw.FPDF_PAGEOBJ_PATH:
            _take_path(walk, item, outer)
        elif kind == raw.FPDF_PAGEOBJ_TEXT:
            letters = walk.letters.get(address(item))
            piece = text_piece(
                walk.text_page, item, outer, _composed(outer, _matrix(item)), letters
            )
            walk.texts += [piece] if piece else []
        elif kind == raw.FPDF_PAGEOBJ_FORM:
            if depth < DEEPEST:
                count = raw.FPDFFormObj_CountObjects(item)
                walk.count(count, 0)
                parts = (raw.FPDFFormObj_GetObject(item, index) for index in range(count))
                _take_all(walk, parts, _composed(outer, _matrix(item)), depth + 1)
        else:
            walk.pictures.append(_box(item, outer))


def _box(item: raw.FPDF_PAGEOBJECT, outer: Affine) -> Box:
    """px around an object; all of the plane where PDFium does not know."""
    left, bottom, right, top = (ctypes.c_float() for _ in range(4))
    if not raw.FPDFPageObj_GetBounds(item, left, bottom, right, top):
        return -np.inf, -np.inf, np.inf, np.inf
    x, y = (left.value, right.value), (bottom.value, top.value)
    corners = np.array([(u, v) for u in x for v in y]) @ outer[:, :2].T + outer[:, 2]
    (x0, y0), (x1, y1) = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    return x0, y0, x1, y1


def _matrix(item: raw.FPDF_PAGEOBJECT) -> Affine:
    found = raw.FS_MATRIX()
    if not raw.FPDFPageObj_GetMatrix(item, found):
        return np.eye(2, 3)
    return np.array([[found.a, found.c, found.e], [found.b, found.d, found.f]])


def _composed(outer: Affine, inner: Affine) -> Affine:
    """The map that applies ``inner`` first."""
    linear = outer[:, :2] @ inner
    linear[:, 2] += outer[:, 2]
    return linear


def _take_path(walk: _Walk, item: raw.FPDF_PAGEOBJECT, outer: Affine) -> None:
    fill, stroked = ctypes.c_int(), ctypes.c_int()
    if not raw.FPDFPath_GetDrawMode(item, fill, stroked) or not (fill.value or stroked.value):
        return
    matrix = walk.map_of(item, outer)
    subpaths = _subpaths(walk, item)
    scale = scale_of(matrix)
    drawn = [subpath.mapped(matrix).pieces() for subpath in subpaths]
    strokes = _stroked(item, drawn, scale) if stroked.value else _filled(item, drawn)
    # Areas are filled with letters and arrow heads, which are often put on the sheet as they are.
    lines = [subpath.line_ends() for subpath in subpaths] if stroked.value else []
    ends = np.concatenate(lines) if lines else np.zeros((0, 2, 2))
    walk.paths.append(WrittenPath(strokes, ends, matrix))


def _filled(item: raw.FPDF_PAGEOBJECT, subpaths: list[Pieces]) -> Strokes:
    if _is_paper(item):
        return lambda _: []
    colour, layer = _colour(item, raw.FPDFPageObj_GetFillColor), _layer(item)
    found = [
        VectorStroke(outline, None, (), StrokeRole.UNKNOWN, layer, StrokeKind.FILL, colour)
        for outline in outlines(subpaths)
    ]
    return lambda _: found


def _stroked(item: raw.FPDF_PAGEOBJECT, subpaths: list[Pieces], scale: float) -> Strokes:
    dashes = tuple(length * scale for length in _dashes(item))
    width = ctypes.c_float()
    raw.FPDFPageObj_GetStrokeWidth(item, width)
    layer = _layer(item)
    role = role_by_dashes(dashes) if dashes else role_by_name(layer) or StrokeRole.UNKNOWN
    colour = _colour(item, raw.FPDFPageObj_GetStrokeColor)
    return lambda step: [
        VectorStroke(curve, width.value * scale, dashes, role, layer, colour=colour)
        for pieces in subpaths
        for curve in curves_from_path(pieces, step)
    ]


def _is_paper(item: raw.FPDF_PAGEOBJECT) -> bool:
    """Whether an area is filled with white: it only covers what lies under it."""
    colour = _colour(item, raw.FPDFPageObj_GetFillColor)
    return colour is not None and min(colour) >= PAPER_LEVEL


def _colour(item: raw.FPDF_PAGEOBJECT, getter: Callable[..., int]) -> Colour | None:
    """What one of PDFium's functions tells of an object's colours."""
    red, green, blue, alpha = (ctypes.c_uint() for _ in range(4))
    if not getter(item, red, green, blue, alpha):
        return None
    return red.value, green.value, blue.value


@dataclass(frozen=True, eq=False)
class _Subpath:
    """Pieces that join.

    Attributes:
        points: (n, 2) their points; the last one of a piece is the first one of the next.
        firsts, counts: number of each one's first point; 2 points of a line, 4 of a Bézier curve.
    """

    points: npt.NDArray[np.float64]
    firsts: list[int]
    counts: list[int]

    def mapped(self, matrix: Affine) -> "_Subpath":
        """Its image."""
        points = self.points @ matrix[:, :2].T + matrix[:, 2]
        return _Subpath(points, self.firsts, self.counts)

    def line_ends(self) -> npt.NDArray[np.float64]:
        """(n, 2, 2) the ends of its lines."""
        if self.counts == [2]:
            return self.points[None, :2]
        rows = zip(self.firsts, self.counts, strict=True)
        firsts = np.array([first for first, count in rows if count == 2], dtype=np.int64)
        return np.asarray(self.points[firsts[:, None] + (0, 1)])

    def pieces(self) -> Pieces:
        """Its pieces."""
        return [
            self.points[first : first + count]
            for first, count in zip(self.firsts, self.counts, strict=True)
        ]


def _subpaths(walk: _Walk, item: raw.FPDF_PAGEOBJECT) -> list[_Subpath]:
    """Runs of pieces that join, in the coordinates in which the path was drawn."""
    count = raw.FPDFPath_CountSegments(item)
    walk.count(0, count)
    subpaths: list[_Subpath] = []
    points: list[Point] = [(0.0, 0.0)]
    firsts: list[int] = []
    counts: list[int] = []
    controls = 0
    x, y = ctypes.c_float(), ctypes.c_float()
    here = ctypes.byref(x), ctypes.byref(y)
    segment_at, point_of = raw.FPDFPath_GetPathSegment, raw.FPDFPathSegment_GetPoint
    kind_of, is_closed = raw.FPDFPathSegment_GetType, raw.FPDFPathSegment_GetClose

    def finish(start: Point) -> None:
        nonlocal points, firsts, counts, controls
        if firsts:
            subpaths.append(_Subpath(np.array(points), firsts, counts))
        points, firsts, counts, controls = [start], [], [], 0

    for index in range(count):
        segment = segment_at(item, index)
        point_of(segment, *here)
        point = x.value, y.value
        kind = kind_of(segment)
        if kind == raw.FPDF_SEGMENT_MOVETO:
            finish(point)
        elif kind == raw.FPDF_SEGMENT_LINETO:
            firsts.append(len(points) - 1)
            counts.append(2)
            points.append(point)
        elif kind == raw.FPDF_SEGMENT_BEZIERTO:
            points.append(point)
            controls += 1
            if controls == 3:
                firsts.append(len(points) - 4)
                counts.append(4)
                controls = 0
        if is_closed(segment):
            (x0, y0), (x1, y1) = points[0], points[-1]
            if math.hypot(x1 - x0, y1 - y0) > _CLOSED:
                firsts.append(len(points) - 1)
                counts.append(2)
                points.append(points[0])
            finish(points[0])
    finish((0.0, 0.0))
    return subpaths


def _dashes(item: raw.FPDF_PAGEOBJECT) -> tuple[float, ...]:
    count = raw.FPDFPageObj_GetDashCount(item)
    if count <= 0:
        return ()
    values = (ctypes.c_float * count)()
    raw.FPDFPageObj_GetDashArray(item, values, count)
    lengths = tuple(float(value) for value in values)
    if len(lengths) % 2:
        # PDF 32000-1, 8.4.3.6: the array is gone through cyclically.
        lengths += lengths
    return lengths if sum(lengths[1::2]) > 0.0 else ()


def _layer(item: raw.FPDF_PAGEOBJECT) -> str:
    """Name of the optional content group around an object: the layer of a CAD system."""
    for index in range(max(raw.FPDFPageObj_CountMarks(item), 0)):
        mark = raw.FPDFPageObj_GetMark(item, index)
        if _mark_text(raw.FPDFPageObjMark_GetName, mark) == "OC":
            return _mark_text(raw.FPDFPageObjMark_GetParamStringValue, mark, b"Name")
    return ""


def _mark_text(getter: Callable[..., int], *arguments: object) -> str:
    """What one of PDFium's functions writes as UTF-16, asked first how long it is."""
    length = ctypes.c_ulong()
    if not getter(*arguments, None, 0, length) or length.value < 4:
        return ""
    buffer = ctypes.create_string_buffer(length.value)
    as_pointer = ctypes.cast(buffer, ctypes.POINTER(ctypes.c_ushort))
    getter(*arguments, as_pointer, length.value, length)
    return buffer.raw[: length.value].decode("utf-16-le", errors="replace").rstrip("\0")
