"""What the strokes of small made-up files are taken for."""

from collections.abc import Sequence

import numpy as np
import shapely

from gaussiancad_core.file_reading.paper_of_file import paper_of_file
from gaussiancad_core.files.vectors import StrokeKind, VectorDrawing, VectorStroke, VectorText
from gaussiancad_core.recognition.stroke_reading import StrokeReading, read_strokes
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.structure.arrowheads import Head, arrowheads

SIZE = (1000, 700)
"""px of the sheets."""


def reading_of(
    strokes: Sequence[VectorStroke], *texts: VectorText, has_paper: bool = True
) -> tuple[StrokeReading, float]:
    """The reading of a sheet of 1000 x 700 px at 200 dpi, and its px per mm."""
    drawing = VectorDrawing(tuple(strokes), texts, has_paper=has_paper)
    paper = paper_of_file(drawing, SIZE[::-1], 200.0)
    scale = paper.px_per_mm
    heads = [
        Head((head.tip[0] / scale, head.tip[1] / scale), head.way, head.length / scale)
        for head in arrowheads(strokes)
    ]
    return read_strokes(paper, heads), scale


def labels_of(
    strokes: Sequence[VectorStroke], *texts: VectorText, has_paper: bool = True
) -> list[Label]:
    """What each of some strokes is taken for, or the stroke of which it is a piece."""
    reading, scale = reading_of(strokes, *texts, has_paper=has_paper)
    known = [
        (stroke.line, label)
        for stroke, label in zip(reading.labelled.strokes, reading.labelled.labels, strict=True)
        if label is not Label.DASH
    ]
    tree = shapely.STRtree([line for line, _ in known])
    found = []
    for stroke in strokes:
        if stroke.kind is StrokeKind.FILL:
            continue
        points = stroke.curve.points_at(stroke.curve.length * np.array([0.3, 0.6])) / scale
        middle = shapely.LineString(points)
        along = [
            (index, line.intersection(middle.buffer(_BESIDE)).length)
            for index in tree.query(middle, "dwithin", _BESIDE).tolist()
            for line in [known[index][0]]
        ]
        best = max(along, key=lambda pair: pair[1], default=None)
        found.append(Label.OPEN if best is None else known[best[0]][1])
    return found


_BESIDE = 0.1
"""mm by which a piece lies beside its stroke at most."""
