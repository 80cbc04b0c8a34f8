"""Marks that are dashed from end to end go; edges and hidden lines stay."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.centre_marks import mark_centre_marks
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.annotations.uneven_marks import uneven_mark
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

CENTRE = (200.0, 160.0)
OUTER, INNER = 40.0, 18.0

DASHED = ((-60.0, 34.0), (44.0, 54.0))
"""px from the centre along a line: the last dash leaves off before its end."""


def _circles(sketch: Sketch, side: float) -> Sketch:
    """Two circles in a square plate whose sides are some px from their centre."""
    x, y = CENTRE
    corners = [(x + a * side, y + b * side) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    drawn = sketch(400, 320).lines(*corners, corners[0])
    return drawn.arc(CENTRE, OUTER).arc(CENTRE, INNER)


def _line(drawn: Sketch, turn: int, pieces: tuple[tuple[float, float], ...]) -> Sketch:
    """Pieces of a line through the centre, in a direction in quarter turns."""
    way = np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][turn])
    for near, far in pieces:
        drawn.line(tuple(CENTRE + near * way), tuple(CENTRE + far * way))
    return drawn


@pytest.mark.parametrize("side", [90.0, 60.0])
@pytest.mark.parametrize("turns", [(0, 1), (2, 1), (0, 3)])
def test_it_begins_alike_on_two_sides(sketch: Sketch, side: float, turns: tuple) -> None:
    """In the paper, or at edges."""
    plain, drawn = _circles(sketch, side), _circles(sketch, side)
    for turn in turns:
        _line(drawn, turn, DASHED)
    separated = separate_annotations(clean_sheet(drawn.grey))
    assert {mark.kind for mark in separated.marks} == {AnnotationKind.CENTRE_LINE}
    left, wanted = separated.part.weight > 0.5, plain.weight > 0.5
    # A dot stays where the lines meet, and what lies in the fringe of circles and sides.
    assert (left & ~wanted).sum() <= 90
    assert (left & wanted).sum() > 0.99 * wanted.sum()


@pytest.mark.parametrize(
    ("level", "upright", "end"),
    [
        (DASHED, DASHED, 60.0),
        # No crosses: one line alone, or one that is longer than the other.
        (DASHED, (), None),
        (DASHED, ((-50.0, 34.0), (44.0, 48.0)), None),
        # Within the circle.
        (((-36.0, 36.0),), ((-36.0, 36.0),), None),
    ],
)
def test_its_ends_are_told(sketch: Sketch, level: tuple, upright: tuple, end: float | None) -> None:
    drawn = _line(_line(_circles(sketch, 120.0), 0, level), 1, upright)
    found = uneven_mark(Circle(CENTRE, OUTER), (1.0, 0.0), clean_sheet(drawn.grey))
    assert (found is None) == (end is None)
    assert end is None or found == pytest.approx(end, abs=1.5)


@pytest.mark.parametrize(
    "pieces", [((-60.0, 60.0),), tuple((k, k + 12.0) for k in range(-60, 60, 18))]
)
def test_edges_and_hidden_lines_stay(sketch: Sketch, pieces: tuple) -> None:
    """Edges end at the plate's sides, and hidden lines a gap before them."""
    drawn = _circles(sketch, 60.0)
    for turn in (0, 1):
        _line(drawn, turn, pieces)
    sheet = clean_sheet(drawn.grey)
    assert uneven_mark(Circle(CENTRE, OUTER), (1.0, 0.0), sheet) is None


@pytest.mark.parametrize("even", [False, True])
def test_a_hidden_line_on_its_way_tells_none(sketch: Sketch, even: bool) -> None:
    """Its dashes are as long as each other, those of a mark are not."""
    inner = ((-10.0, -2.0), (2.0, 10.0), (14.0, 22.0), (26.0, 34.0)) if even else ((-10.0, 34.0),)
    level = (-60.0, -14.0), *inner, (44.0, 54.0)
    drawn = _line(_line(_circles(sketch, 90.0), 0, level), 1, DASHED)
    shapes = [
        InkedShape(Circle(CENTRE, OUTER), (InkedRun(Run(0.0, 251.0), 3.0),)),
        InkedShape(Line(CENTRE, (1.0, 0.0)), tuple(InkedRun(Run(*own), 3.0) for own in level)),
        InkedShape(Line(CENTRE, (0.0, 1.0)), tuple(InkedRun(Run(*own), 3.0) for own in DASHED)),
    ]
    kinds = [[None] * len(shape.runs) for shape in shapes]
    mark_centre_marks(shapes, kinds, clean_sheet(drawn.grey))
    told = None if even else AnnotationKind.CENTRE_LINE
    assert kinds == [[None], [told] * len(level), [told] * len(DASHED)]
