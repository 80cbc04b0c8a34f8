"""Centre marks none of whose pieces touches anything."""

from typing import Any

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lone_marks import mark_lone_marks
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

CENTRE = AnnotationKind.CENTRE_LINE
MIDDLE = (100.0, 100.0)
LEVEL, UPRIGHT = Line(MIDDLE, (1.0, 0.0)), Line(MIDDLE, (0.0, 1.0))
WHOLE = [(-10.0, 10.0), (24.0, 34.0), (-34.0, -24.0)]


def _marked(
    sketch: Sketch,
    level: list[tuple[float, float]],
    upright: list[tuple[float, float]],
    ring: float = 20.0,
) -> list[list[AnnotationKind | None]]:
    """What becomes of pieces along both lines through a circle's centre."""
    drawn = sketch(200, 200).arc(MIDDLE, ring, 2.0)
    for start, end in level:
        drawn.line((100 + start, 100), (100 + end, 100), 2.0)
    for start, end in upright:
        drawn.line((100, 100 + start), (100, 100 + end), 2.0)
    circle = Circle(MIDDLE, ring)
    shapes = [
        InkedShape(line, tuple(InkedRun(Run(*sorted(piece)), 2.0) for piece in pieces))
        for line, pieces in ((LEVEL, level), (UPRIGHT, upright))
    ]
    shapes.append(InkedShape(circle, (InkedRun(Run(0.0, circle.around), 2.0),)))
    kinds: list[list[AnnotationKind | None]] = [[None] * len(shape.runs) for shape in shapes]
    mark_lone_marks(shapes, kinds, clean_sheet(drawn.grey).ink, 2.0)
    assert kinds[2] == [None]
    return kinds[:2]


def test_a_mark_with_a_cross_and_arms(sketch: Sketch) -> None:
    assert _marked(sketch, WHOLE, WHOLE) == [[CENTRE] * 3, [CENTRE] * 3]


def test_a_mark_of_which_a_stroke_faded(sketch: Sketch) -> None:
    assert _marked(sketch, WHOLE[1:], WHOLE) == [[CENTRE] * 2, [CENTRE] * 3]


@pytest.mark.parametrize(
    ("level", "upright"),
    [
        # Dashes that follow each other.
        ([(-10.0, 10.0), (24.0, 34.0), (-34.0, -24.0), (40.0, 60.0)], []),
        # A slot's edges end at the circle.
        ([(-19.0, 19.0), (21.0, 34.0), (-34.0, -21.0)], []),
        # One side only.
        ([(-10.0, 10.0), (24.0, 34.0)], [(24.0, 34.0)]),
        # Nothing passes through the centre.
        (WHOLE[1:], WHOLE[1:]),
    ],
)
def test_other_lines_through_a_centre_stay(
    sketch: Sketch, level: list[tuple[float, float]], upright: list[tuple[float, float]]
) -> None:
    marked = _marked(sketch, level, upright)
    assert not any(kind for own in marked for kind in own)
