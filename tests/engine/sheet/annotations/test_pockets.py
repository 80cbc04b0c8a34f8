"""Rectangles are pockets, however small; letters are none."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.lettering import label
from gaussiancad_core.drawing.style import SheetStyle
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.annotations.pockets import is_rectangle

Sketch = Any
"""The class that the fixture gives."""


def _cut(ink: Mask) -> Mask:
    rows, columns = np.nonzero(ink)
    return ink[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]


@pytest.mark.parametrize("size", [(13, 20), (9, 12), (30, 14)])
@pytest.mark.parametrize("width", [1.0, 2.0, 3.0])
def test_the_outline_of_a_pocket(sketch: Sketch, size: tuple[int, int], width: float) -> None:
    x, y = size
    drawn = sketch(80, 60).lines(
        (20.3, 20.2), (20.3 + x, 20.2), (20.3 + x, 20.2 + y), (20.3, 20.2 + y), (20.3, 20.2),
        width=width,
    )  # fmt: skip
    assert is_rectangle(_cut(drawn.weight >= 0.4), width)


@pytest.mark.parametrize("text", ["0", "D", "O", "8", "B", "6", "E", "H"])
@pytest.mark.parametrize("width", [2.0, 3.0])
def test_letters_are_no_rectangles(text: str, width: float) -> None:
    annotation = Annotation(AnnotationKind.TEXT, 0, label=label(text, (100, 50), 24.0, 0.0))
    ink = ink_annotations((annotation,), SheetStyle(width=200, height=100)) >= 0.5
    assert not is_rectangle(_cut(ink), width)


def test_a_blot_is_none() -> None:
    assert not is_rectangle(np.ones((12, 12), dtype=bool), 2.0)
    assert not is_rectangle(np.ones((4, 12), dtype=bool), 2.0)
