"""PDF files: a page drawn by PDFium, at 200 dpi or less, and the exact curves of its content.

The page's box is widened to whole pixels before it is drawn, as PDFium would stretch the page
instead.  Comments and form fields are no part of the drawing and stay away.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pypdfium2 as pdfium
from pypdfium2 import raw

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.content import (
    MAX_PAGES,
    VECTOR_DPI,
    FileContent,
    Grey,
    check_pixels,
    page_missing,
    too_many_pages,
)
from gaussiancad_core.files.pdf_objects import PageMap, page_objects
from gaussiancad_core.files.shown import shown_strokes
from gaussiancad_core.files.sizing import Sizing, notes_on, paper_dpi
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_protocol.codes import Code

_POINTS = 72.0
"""An inch has so many."""


@dataclass(frozen=True)
class _Geometry:
    """A page's box (left, bottom, right, top) in points, and its quarter turns clockwise."""

    box: tuple[float, float, float, float]
    turns: int

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in points as the page is shown."""
        width, height = self.box[2] - self.box[0], self.box[3] - self.box[1]
        return (height, width) if self.turns % 2 else (width, height)

    def widened(self, width: float, height: float) -> "_Geometry":
        """The same with another size as shown; the upper left corner stays."""
        left, bottom, right, top = self.box
        if self.turns % 2:
            width, height = height, width
        # Which of the box's sides are the left and the upper one on the screen.
        box = (
            (left, top - height, left + width, top),
            (left, bottom, left + width, bottom + height),
            (right - width, bottom, right, bottom + height),
            (right - width, top - height, right, top),
        )[self.turns]
        return _Geometry(box, self.turns)

    def to_pixels(self, scale: float) -> npt.NDArray[np.float64]:
        """(2, 3) matrix from points of the page to px, of which ``scale`` are a point."""
        left, bottom, right, top = self.box
        matrix = (
            [[1.0, 0.0, -left], [0.0, -1.0, top]],
            [[0.0, 1.0, -bottom], [1.0, 0.0, -left]],
            [[-1.0, 0.0, right], [0.0, 1.0, -bottom]],
            [[0.0, -1.0, top], [-1.0, 0.0, right]],
        )[self.turns]
        return np.array(matrix) * scale


def read_pdf(path: Path, page: int) -> FileContent:
    """Read a page of a PDF file.

    Raises:
        UnreadableError: ``damaged-pdf``, ``encrypted-pdf``, ``too-many-pages``, ``page-missing``,
            ``image-too-large``, ``image-too-small``.
        LimitError: ``too-many-elements``.
    """
    with _open(path) as document:
        count = len(document)
        if count > MAX_PAGES:
            raise too_many_pages(path, count)
        if not 1 <= page <= count:
            raise page_missing(path, count, page)
        try:
            return _read_page(document, path, page - 1)
        except pdfium.PdfiumError as error:
            raise _damaged(path, error) from error


def _open(path: Path) -> pdfium.PdfDocument:
    try:
        return pdfium.PdfDocument(path)
    except pdfium.PdfiumError as error:
        code = getattr(error, "err_code", None)
        if code in (raw.FPDF_ERR_PASSWORD, raw.FPDF_ERR_SECURITY):
            raise UnreadableError(
                Code.ENCRYPTED_PDF,
                "{path} is protected by a password: save it without one",
                path=path,
            ) from error
        raise _damaged(path, error) from error
    except OSError as error:
        raise _damaged(path, error) from error


def _damaged(path: Path, error: Exception) -> UnreadableError:
    return UnreadableError(
        Code.DAMAGED_PDF,
        "{path} is no PDF file, or is damaged ({reason}): export the drawing again",
        path=path,
        reason=error,
    )


def _read_page(document: pdfium.PdfDocument, path: Path, index: int) -> FileContent:
    geometry = _geometry(document, index)
    inches = [side / _POINTS for side in geometry.size]
    check_pixels(path, *(side * VECTOR_DPI for side in inches))
    dpi = paper_dpi(*inches)
    scale = dpi / _POINTS
    width, height = (int(np.ceil(side * dpi - 1e-3)) for side in inches)
    geometry = geometry.widened(width / scale, height / scale)
    page = document[index]
    page.set_mediabox(*geometry.box)
    page.set_cropbox(*geometry.box)
    page.close()
    # PDFium reads a page's boxes when it loads the page.
    page = document[index]
    content = page_objects(page, PageMap(geometry.to_pixels(scale), path))
    grey = _render(page, width, height)
    strokes = shown_strokes(content.strokes, grey)
    page.close()
    vectors = VectorDrawing(strokes, content.texts, not content.pictures, pictures=content.pictures)
    shown = vectors if strokes or content.texts else None
    notes = notes_on(path, Sizing(scale, dpi, on_paper=True))
    return FileContent(grey, dpi, shown, notes, pages=len(document))


def _geometry(document: pdfium.PdfDocument, index: int) -> _Geometry:
    page = document[index]
    try:
        # What PDFium shows is the crop box within the media box.
        media, crop = page.get_mediabox(), page.get_cropbox()
        turns = page.get_rotation() // 90 % 4
    finally:
        page.close()
    box = (
        max(media[0], crop[0]),
        max(media[1], crop[1]),
        min(media[2], crop[2]),
        min(media[3], crop[3]),
    )
    if box[0] >= box[2] or box[1] >= box[3]:
        box = media
    return _Geometry(box, turns)


def _render(page: pdfium.PdfPage, width: int, height: int) -> Grey:
    """(height, width) grey picture of a page, without its comments."""
    bitmap = pdfium.PdfBitmap.new_native(width, height, raw.FPDFBitmap_Gray)
    try:
        bitmap.fill_rect((255, 255, 255, 255), 0, 0, width, height)
        raw.FPDF_RenderPageBitmap(bitmap, page, 0, 0, width, height, 0, raw.FPDF_GRAYSCALE)
        return bitmap.to_numpy().reshape(height, width).copy()
    finally:
        bitmap.close()
