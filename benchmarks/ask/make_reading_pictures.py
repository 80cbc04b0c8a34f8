"""What is taken off a dimensioned sheet, and what is read of the rest?

A dimensioned sheet is drawn and read.  ``reading-separated.png`` shows its ink in the colours of
what it was taken for, ``reading-strokes.png`` one view's strokes as they were found.
"""

import argparse
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from benchmarks.run.checkout import IMAGES
from benchmarks.run.outcome import Outcome
from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.recognition.sheet_views import sheet_views
from gaussiancad_core.samples import sample
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views

MINUTES = 0.5

Image = npt.NDArray[np.uint8]
Colour = tuple[int, int, int]

PART = "boss-plate"
STYLE = PRESETS["dimensioned"]

# Okabe and Ito (2008): colour-blind people can tell them apart.
FRAME, WRITING = (140, 140, 140), (204, 121, 167)
DIMENSIONS, CENTRE_LINES = (213, 94, 0), (0, 158, 115)
LINE, ARC, HIDDEN = (0, 114, 178), (213, 94, 0), (0, 158, 115)

COLOURS: dict[AnnotationKind, Colour] = {
    AnnotationKind.FRAME: FRAME,
    AnnotationKind.TITLE_BLOCK: FRAME,
    AnnotationKind.SYMBOL: FRAME,
    AnnotationKind.TEXT: WRITING,
    AnnotationKind.CENTRE_LINE: CENTRE_LINES,
    AnnotationKind.CENTRE_MARK: CENTRE_LINES,
}
"""Of kinds; all others are dimensions."""

ZOOM = 3
"""Pixels of the picture of strokes for one of the sheet."""


def separated_picture(sheet: CleanSheet, separated: SeparatedSheet) -> Image:
    """The ink of a sheet: the part's black, the rest in the colours of its kinds."""
    picture = np.full((*sheet.ink.shape, 3), 255, np.uint8)
    off = sheet.ink & ~separated.part.ink
    # Outside of every mark is the frame with what hangs on it.
    picture[off] = FRAME
    order = [AnnotationKind.FRAME, AnnotationKind.TITLE_BLOCK, AnnotationKind.TEXT]
    marks = sorted(separated.marks, key=lambda mark: mark.kind not in order)
    for mark in marks:
        if mark.kind is AnnotationKind.FRAME:
            continue
        near = np.zeros(off.shape, np.uint8)
        if mark.line is not None:
            ends = np.rint(np.array(mark.line) - 0.5).astype(int).tolist()
            cv2.line(near, tuple(ends[0]), tuple(ends[1]), 1, 17)
        else:
            x0, y0, x1, y1 = (int(value) for value in mark.box)
            near[y0 : y1 + 1, x0 : x1 + 1] = 1
        picture[off & (near > 0)] = COLOURS.get(mark.kind, DIMENSIONS)
    picture[separated.part.ink] = 0
    return picture


def strokes_picture(sheet: CleanSheet, view: ReadView) -> Image:
    """One view's strokes over its faded ink: lines, arcs, hidden ones, and where each ends."""
    x0, y0 = (int(value) - 20 for value in view.box[:2])
    x1, y1 = (int(value) + 20 for value in view.box[2:])
    faded = 255.0 * (1.0 - 0.25 * sheet.weight[y0:y1, x0:x1])
    grey = cv2.resize(np.rint(faded).astype(np.uint8), None, fx=ZOOM, fy=ZOOM)
    picture = np.repeat(grey[..., None], 3, axis=2)
    paths = [((stroke.sample(0.5) - (x0, y0)) * ZOOM, _colour(stroke)) for stroke in view.strokes]
    for path, colour in paths:
        points = np.rint(path * 16 - 8).astype(np.int32)
        cv2.polylines(picture, [points], False, colour, 3, cv2.LINE_AA, 4)
    for path, colour in paths:
        for end in (path[0], path[-1]):
            cv2.circle(picture, tuple(np.rint(end).astype(int).tolist()), 6, colour, 2, cv2.LINE_AA)
    return picture


def _colour(stroke: Stroke) -> Colour:
    if stroke.linetype is Linetype.HIDDEN:
        return HIDDEN
    return LINE if isinstance(stroke, Segment) else ARC


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("folder", nargs="?", type=Path, default=IMAGES)


def run(options: argparse.Namespace) -> Outcome:
    """Write both pictures."""
    folder: Path = options.folder
    drawn = draw_sheet(sample(PART).build(), ROLES, Projection.THIRD, STYLE, title="Boss plate")
    grey = cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)
    opened = OpenedSheet(SheetImage(folder, grey, ""))
    sheet = opened.clean
    seen = sheet_views(opened, projection=Projection.THIRD)
    separated = seen.separated
    views = read_views(separated.part, seen.layout)
    top = next(view for view in views if view.role is Role.TOP)
    folder.mkdir(parents=True, exist_ok=True)
    write_image(separated_picture(sheet, separated), folder / "reading-separated.png")
    write_image(strokes_picture(sheet, top), folder / "reading-strokes.png")
    return Outcome()
