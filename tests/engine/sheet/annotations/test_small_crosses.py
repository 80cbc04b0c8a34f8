"""Crosses too small for lines are taken off; what dashes or edges make stays."""

from typing import Any

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.annotations.small_crosses import mark_small_crosses
from gaussiancad_core.sheet.clean import clean_sheet, upright_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

CENTRE = (200.3, 160.6)


def _plate(sketch: Sketch) -> Sketch:
    sides = [(120.0, 90.0), (280.0, 90.0), (280.0, 230.0), (120.0, 230.0), (120.0, 90.0)]
    return sketch(400, 320).lines(*sides).arc(CENTRE, 40.0)


@pytest.mark.parametrize(("size", "width"), [(8.0, 3.0), (11.0, 4.0), (10.0, 2.0), (9.0, 1.2)])
def test_a_small_cross_goes(sketch: Sketch, size: float, width: float) -> None:
    plain, drawn = _plate(sketch), _plate(sketch)
    x, y = CENTRE
    drawn.line((x - 0.5 * size, y), (x + 0.5 * size, y), width)
    drawn.line((x, y - 0.5 * size), (x, y + 0.5 * size), width)
    separated = separate_annotations(upright_sheet(clean_sheet(drawn.grey)))
    assert {mark.kind for mark in separated.marks} == {AnnotationKind.CENTRE_LINE}
    assert not (separated.part.ink & ~(plain.weight > 0.1)).any()


def test_what_was_found_between_its_arms_goes_too(sketch: Sketch) -> None:
    drawn = _plate(sketch)
    (x, y), half = CENTRE, 5.0
    drawn.line((x - half, y), (x + half, y), 1.5).line((x, y - half), (x, y + half), 1.5)
    shapes = [
        InkedShape(Circle(CENTRE, 40.0), (InkedRun(Run(0.0, 251.0), 3.0),)),
        InkedShape(Circle((x + 1.0, y + 1.0), 2.0), (InkedRun(Run(0.0, 4.0), None),)),
    ]
    for way in ((1.0, 0.0), (0.0, 1.0)):
        shapes.append(InkedShape(Line(CENTRE, way), (InkedRun(Run(-half, half), 1.5),)))
    centre = AnnotationKind.CENTRE_LINE
    kinds = [[None], [None], [centre], [centre]]
    mark_small_crosses(shapes, kinds, upright_sheet(clean_sheet(drawn.grey)))
    assert kinds == [[None], [centre], [centre], [centre]]


@pytest.mark.parametrize("what", ["dashes", "circle", "aside"])
def test_what_is_no_cross_of_its_circle_stays(sketch: Sketch, what: str) -> None:
    drawn = _plate(sketch)
    x, y = CENTRE
    if what == "dashes":
        # Two hidden lines whose dashes cross there.
        for k in range(-5, 6):
            drawn.line((x + 14.0 * k - 4.5, y), (x + 14.0 * k + 4.5, y), 2.0)
            drawn.line((x, y + 14.0 * k - 4.5), (x, y + 14.0 * k + 4.5), 2.0)
    elif what == "circle":
        drawn.arc(CENTRE, 5.0, 2.0)
    else:
        drawn.line((x + 4.0, y + 6.0), (x + 13.0, y + 6.0), 2.0)
        drawn.line((x + 8.5, y + 1.5), (x + 8.5, y + 10.5), 2.0)
    sheet = upright_sheet(clean_sheet(drawn.grey))
    shapes, kinds = [InkedShape(Circle(CENTRE, 40.0), (InkedRun(Run(0.0, 251.0), 3.0),))], [[None]]
    mark_small_crosses(shapes, kinds, sheet)
    assert kinds == [[None]]
