"""Short visible edges from corner to corner, most of whose ink is that of the strokes they join."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.strokes import classify_strokes
from gaussiancad_core.sheet.view_shapes import find_shapes, view_rhythm
from gaussiancad_core.views import Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

Point = tuple[float, float]

_PEN = 2.7


def _read(drawn: Sketch, box: tuple[float, float, float, float]) -> list[np.ndarray]:
    """Ends of the strokes of a view, (2, 2) px each; all of them are straight and visible."""
    sheet = clean_sheet(drawn.grey)
    shapes = find_shapes(sheet, box)
    strokes = classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width))
    assert all(isinstance(own, Segment) and own.linetype is Linetype.VISIBLE for own in strokes)
    return [np.array([own.start, own.end]) - 0.5 for own in strokes]


def _has(found: list[np.ndarray], start: Point, end: Point) -> bool:
    wanted = np.array([start, end])
    return any(min(np.abs(own - w).max() for w in (wanted, wanted[::-1])) < 0.6 for own in found)


def _rims(sketch: Sketch, wide: float, high: float) -> tuple[Sketch, list[Point], list[Point]]:
    """A rectangle in another one, so many px beside it, and the corners of both."""
    outer = [(40.3, 30.6), (160.3, 30.6), (160.3, 130.6), (40.3, 130.6)]
    signs = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    inner = [(x + a * wide, y + b * high) for (x, y), (a, b) in zip(outer, signs, strict=True)]
    drawn = sketch(200, 160)
    for rim in (outer, inner):
        drawn.lines(*rim, rim[0], width=_PEN)
    return drawn, outer, inner


@pytest.mark.parametrize(("wide", "high"), [(8.5, 8.5), (7.4, 7.4), (10.3, 8.0), (9.2, 12.1)])
def test_the_edges_of_a_tapered_pocket(sketch: Sketch, wide: float, high: float) -> None:
    drawn, outer, inner = _rims(sketch, wide, high)
    for one, other in zip(outer, inner, strict=True):
        drawn.line(one, other, _PEN)
    found = _read(drawn, (38.0, 28.0, 163.0, 133.0))
    assert all(_has(found, *edge) for edge in zip(outer, inner, strict=True))
    assert len(found) == 12


@pytest.mark.parametrize("beside", [6.3, 7.4, 8.5])
@pytest.mark.parametrize("drawn_there", [True, False])
def test_the_corner_of_a_chamfer_ends_on_an_edge_that_goes_on(
    sketch: Sketch, beside: float, drawn_there: bool
) -> None:
    """As of the stem of a tee, chamfered all around: its outer rim ends on the tee's edge."""
    outer, inner = (60.3, 50.6), (60.3 + beside, 50.6 + beside)
    drawn = sketch(200, 160)
    drawn.lines(
        (60.3, 20.4), (160.7, 20.4), (160.7, 130.2), (60.3, 130.2), (60.3, 20.4), width=_PEN
    )
    drawn.line(outer, (160.7, 50.6), _PEN).lines(
        (160.7, inner[1]), inner, (inner[0], 130.2), width=_PEN
    )
    if drawn_there:
        drawn.line(outer, inner, _PEN)
    found = _read(drawn, (58.0, 18.0, 163.0, 133.0))
    assert _has(found, outer, inner) == drawn_there
    assert len(found) == 7 + drawn_there


@pytest.mark.parametrize("beside", [7.4, 8.5, 10.3])
def test_a_pocket_with_a_step_has_none(sketch: Sketch, beside: float) -> None:
    drawn, _, _ = _rims(sketch, beside, beside)
    assert len(_read(drawn, (38.0, 28.0, 163.0, 133.0))) == 8


@pytest.mark.parametrize("high", [12.8, 13.2, 13.6])
def test_a_step_of_an_outline_between_slanted_edges(sketch: Sketch, high: float) -> None:
    step = [(82.4, 55.8), (82.4, 55.8 + high)]
    far = (160.3, 55.8 + high - 62.3)
    corners = [(40.0, 70.0), *step, far, (160.3, 120.4), (40.0, 120.4)]
    drawn = sketch(200, 150).lines(*corners, corners[0], width=_PEN)
    found = _read(drawn, (38.0, far[1] - 2.0, 163.0, 123.0))
    assert _has(found, *step)
    assert len(found) == 6
