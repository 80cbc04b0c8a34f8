"""Pictures of vector files at any number of pixels, as drawn or as scanned."""

from dataclasses import replace
from pathlib import Path
from random import Random

import cv2
import numpy as np
import numpy.typing as npt
import pypdfium2 as pdfium
from pypdfium2 import raw

from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.sheet.image.deskew import Turn

_POINTS = 72.0
"""Of a PDF file, in an inch."""


def painted_pdf(path: Path, dpi: float) -> npt.NDArray[np.uint8]:
    """(h, w) uint8, the first page of a PDF file."""
    document = pdfium.PdfDocument(path)
    try:
        page = document[0]
        scale = dpi / _POINTS
        width, height = (int(np.ceil(side * scale - 1e-3)) for side in page.get_size())
        bitmap = pdfium.PdfBitmap.new_native(width, height, raw.FPDFBitmap_Gray)
        bitmap.fill_rect((255, 255, 255, 255), 0, 0, width, height)
        # A page that is drawn to whole pixels otherwise is stretched to them.
        matrix = raw.FS_MATRIX(scale, 0.0, 0.0, scale, 0.0, 0.0)
        whole = raw.FS_RECTF(0.0, 0.0, float(width), float(height))
        raw.FPDF_RenderPageBitmapWithMatrix(bitmap, page, matrix, whole, raw.FPDF_GRAYSCALE)
        return bitmap.to_numpy().reshape(height, width).copy()
    finally:
        document.close()


def scanned(grey: npt.NDArray[np.uint8], seed: int, turn: Turn, path: Path) -> Turn:
    """Write a picture as a scanner gives it, a JPEG file; its turn with the angle by which it lies.

    Args:
        grey: (h, w) uint8.
        seed: of all chance.
        turn: about the picture's middle.
        path: of the file.
    """
    style = PRESETS["scan"]
    lies = replace(turn, angle=float(np.radians(style.skew * Random(seed).uniform(-1.0, 1.0))))
    ink = 1.0 - grey.astype(np.float32) / 255.0
    # What turns a sheet level turns a level one the other way.
    ink = replace(lies, angle=-lies.angle).upright(ink)
    image = cv2.cvtColor(finished(ink, style, seed), cv2.COLOR_RGB2GRAY)
    write_image(np.repeat(image[..., None], 3, axis=2), path, style.jpeg_quality)
    return lies
