"""The strokes of a sheet's file: in mm of paper, what each stands for, and the part's in px."""

import re
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gaussiancad_core.file_reading.paper_of_file import paper_of_file
from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.recognition.drawn_layout import scaled_box, third_angle_odds
from gaussiancad_core.recognition.stroke_reading import StrokeReading, read_strokes
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.vector_views.stroke_chains import with_whole_edges
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke
from gaussiancad_core.structure.arrowheads import Head, arrowheads

_HABIT = 2.5
"""Log-odds for the projection of the standard by which a program names its layers."""

_ISO, _ANSI = re.compile(r"\((?:ISO|DIN)\)"), re.compile(r"\(ANSI\)")


@dataclass(frozen=True, eq=False)
class FileStrokes:
    """A file, and what its strokes stand for.

    Attributes:
        drawing: of the file, px of the upright sheet.
        sheet: that.
        reading: mm of paper.
        scale: px per mm.
        third: log-odds for third angle by what the user and the sheet say.
    """

    drawing: VectorDrawing
    sheet: OpenedSheet
    reading: StrokeReading
    scale: float
    third: float = 0.0

    @cached_property
    def part(self) -> VectorDrawing:
        """The part's strokes, px: whole visible edges, and hidden ones."""
        labelled, to_px = self.reading.labelled, Similarity(self.scale)
        edges = [_in_px(stroke, to_px, self.scale) for stroke in labelled.of(Label.EDGE)]
        hidden = [_in_px(stroke, to_px, self.scale) for stroke in labelled.of(Label.HIDDEN)]
        return VectorDrawing((*with_whole_edges(edges), *hidden), ())


def strokes_of_file(
    sheet: OpenedSheet,
    projection: Projection | None = None,
    symbol: ProjectionSymbol | None = None,
) -> FileStrokes | None:
    """What the strokes of a sheet's file stand for; None of a picture.

    Args:
        sheet: as stored and upright.
        projection: as told by the user, or nothing.
        symbol: of the sheet, where it has one.
    """
    if sheet.image.vectors is None:
        return None
    drawing = _upright(sheet.image.vectors, sheet.turn)
    paper = _paper(drawing, sheet)
    scale = paper.px_per_mm
    heads = [
        Head((head.tip[0] / scale, head.tip[1] / scale), head.way, head.length / scale)
        for head in (arrowheads(drawing.strokes) if sheet.turn.angle else sheet.heads)
    ]
    third = third_angle_odds(projection, symbol, _usual(drawing))
    signs = [scaled_box(symbol.mark.box, 1.0 / scale)] if symbol is not None else []
    return FileStrokes(drawing, sheet, read_strokes(paper, heads, third, signs), scale, third)


def _upright(drawing: VectorDrawing, turn: Turn) -> VectorDrawing:
    """A drawing turned with its sheet."""
    if not turn.angle:
        return drawing
    stored = turn.scale * turn.centre[0], turn.scale * turn.centre[1]
    level = Similarity(1.0 / turn.scale, -turn.angle, origin=stored, offset=turn.centre)
    return replace(
        drawing,
        strokes=tuple(replace(one, curve=one.curve.mapped(level)) for one in drawing.strokes),
        texts=tuple(replace(one, box=turn.box_to_upright(one.box)) for one in drawing.texts),
        pictures=tuple(turn.box_to_upright(box) for box in drawing.pictures),
    )


def _paper(drawing: VectorDrawing, sheet: OpenedSheet) -> PaperSheet:
    """The sheet; without its picture where that does not lie as the strokes do."""
    grey = sheet.image.grey
    paper = paper_of_file(drawing, sheet.shape, sheet.image.pixels_per_inch)
    if sheet.turn.angle:
        return paper

    def paint(box: Box) -> npt.NDArray[np.uint8]:
        x0, y0, x1, y1 = (max(0, round(value * paper.px_per_mm)) for value in box)
        return grey[y0:y1, x0:x1]

    return replace(paper, paint=paint)


def _usual(drawing: VectorDrawing) -> float:
    """Log-odds for third angle by the standards after which its program names layers."""
    layers = " ".join({stroke.layer for stroke in drawing.strokes})
    if _ISO.search(layers):
        return -_HABIT
    return _HABIT if _ANSI.search(layers) else 0.0


def _in_px(stroke: PaperStroke, to_px: Similarity, scale: float) -> VectorStroke:
    pen = stroke.pen
    return VectorStroke(
        stroke.curve.mapped(to_px),
        pen.width * scale or None,
        tuple(length * scale for length in stroke.dashes),
        stroke.role,
        pen.layer,
        stroke.kind,
        pen.colour,
        stroke.step * scale,
    )
