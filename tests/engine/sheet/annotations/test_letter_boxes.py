"""Letters in boxes of their own are writing, and the boxes go with them; pockets stay."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.lettering import label
from gaussiancad_core.drawing.style import SheetStyle
from gaussiancad_core.sheet.annotations.letter_boxes import letter_boxes
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.clean import clean_sheet

Sketch = Any
"""The class that the fixture gives."""

WIDTH, HEIGHT, STROKE = 900, 600, 3.0


def _written(text: str, x: float, y: float) -> np.ndarray:
    annotation = Annotation(AnnotationKind.TEXT, 0, label=label(text, (x, y), 24.0, 0.0))
    return ink_annotations((annotation,), SheetStyle(width=WIDTH, height=HEIGHT))


def _square(drawn: Sketch, x: float, y: float, side: float) -> Sketch:
    corners = (x, y), (x + side, y), (x + side, y + side), (x, y + side), (x, y)
    return drawn.lines(*corners, width=STROKE)


@pytest.mark.parametrize("letter", ["A", "B", "D", "F"])
def test_a_datum_that_hangs_on_an_edge_goes_with_its_letter(sketch: Sketch, letter: str) -> None:
    """All lines are of one width; the box is one piece of ink with the part."""
    drawn = sketch(WIDTH, HEIGHT).lines(
        (150, 250), (600, 250), (600, 500), (150, 500), (150, 250), width=STROKE
    )
    _square(drawn, 180, 150, 44).line((202, 194), (202, 250), STROKE)
    drawn.filled((194.0, 249.0), (210.0, 249.0), (202.0, 234.0))
    drawn.weight = np.maximum(drawn.weight, _written(letter, 202, 172))
    drawn.weight = np.maximum(drawn.weight, _written("125 x 40", 750, 300))
    left = separate_annotations(clean_sheet(drawn.grey)).part.ink
    assert not left[140:230].any()
    assert left[250, 160:590].mean() > 0.9
    assert left[500, 160:590].mean() > 0.9


def test_only_a_box_about_as_large_as_its_letter_is_one(sketch: Sketch) -> None:
    drawn = _square(sketch(WIDTH, HEIGHT), 180, 150, 44)
    _square(drawn, 400, 150, 120).arc((700, 200), 24.0, STROKE)
    marks = [
        Mark(AnnotationKind.TEXT, (x - 10.0, y - 12.0, x + 10.0, y + 12.0))
        for x, y in ((202.0, 172.0), (460.0, 210.0), (700.0, 200.0), (300.0, 400.0))
    ]
    boxes = letter_boxes(drawn.weight >= 0.5, marks, STROKE)
    rows, columns = np.nonzero(boxes)
    ends = (columns.min(), rows.min(), columns.max(), rows.max())
    assert ends == pytest.approx((178, 148, 226, 196), abs=2)
    assert boxes.sum() == (ends[2] - ends[0] + 1) * (ends[3] - ends[1] + 1)
