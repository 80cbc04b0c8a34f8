"""Runs of ink along shapes, how wide they are."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.annotations.inked_shapes import (
    InkedShape,
    inked_shape,
    points_along,
)
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Run, ink_field
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_shapes

Sketch = Any
"""The class that the fixture gives."""

LEVEL = Line((10.0, 20.0), (1.0, 0.0))


def _inked(drawn: Sketch) -> tuple[CleanSheet, list[InkedShape]]:
    sheet = clean_sheet(drawn.grey)
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    grown = grow_shapes(ridges, GrowthRules.of_width(sheet.stroke_width))
    field = ink_field(sheet)
    return sheet, [inked_shape(sheet, field, ridges, item) for item in grown]


def _only(drawn: Sketch) -> tuple[CleanSheet, InkedShape]:
    sheet, shapes = _inked(drawn)
    assert len(shapes) == 1
    return sheet, shapes[0]


def _level(shapes: list[InkedShape], y: float) -> InkedShape:
    """The line at a height."""
    ends = np.array([[20.0, y], [180.0, y]])
    near = [
        shape
        for shape in shapes
        if isinstance(shape.geometry, Line) and shape.geometry.distances(ends).max() < 0.5
    ]
    assert len(near) == 1
    return near[0]


def test_points_of_a_line() -> None:
    run = Run(-5.0, 15.0)
    points = points_along(LEVEL, run, 1.0)
    assert points == pytest.approx(np.stack([np.arange(5.0, 26.0), np.full(21, 20.0)], axis=1))
    # Both ends are there, however far apart the points may be.
    assert points_along(LEVEL, run, 1e9) == pytest.approx(np.array([[5.0, 20.0], [25.0, 20.0]]))


def test_points_of_a_circle() -> None:
    circle = Circle((50.0, 60.0), 20.0)
    run = Run(-10.0, 30.0)
    points = points_along(circle, run, 0.5)
    assert circle.distances(points) == pytest.approx(0.0, abs=1e-9)
    steps = np.hypot(*np.diff(points, axis=0).T)
    assert steps == pytest.approx(0.5, abs=0.01)
    first = (50.0 + 20.0 * np.cos(-0.5), 60.0 + 20.0 * np.sin(-0.5))
    assert points[0] == pytest.approx(first)


@pytest.mark.parametrize("width", [1.0, 1.5, 2.0, 3.0, 5.0, 8.0])
@pytest.mark.parametrize("lift", [0.0, 40.0, 93.0])
def test_a_run_is_as_wide_as_it_was_drawn(sketch: Sketch, width: float, lift: float) -> None:
    # Another line, full of ink, for the darkness of what is thinner than a pixel.
    drawn = sketch().line((20.0, 150.0), (180.0, 150.0), 4.0)
    _, shapes = _inked(drawn.line((20.0, 30.3), (180.0, 30.3 + lift), width))
    shape = next(shape for shape in shapes if shape.geometry.point[1] < 120.0)
    assert len(shape.runs) == 1
    assert shape.runs[0].width == pytest.approx(width, abs=0.25)
    assert shape.runs[0].run.length == pytest.approx(np.hypot(160.0, lift), abs=2.5)


def test_the_width_of_a_circle(sketch: Sketch) -> None:
    _, shape = _only(sketch().arc((100, 80), 50.0, 2.5))
    assert len(shape.runs) == 1
    assert shape.runs[0].width == pytest.approx(2.5, abs=0.15)
    assert shape.runs[0].run.length == pytest.approx(2 * np.pi * 50.0, abs=1.5)


def test_every_dash_is_a_run(sketch: Sketch) -> None:
    _, shape = _only(sketch().broken((20, 60), (180, 60), (12, 6), 2.0))
    assert len(shape.runs) == 9
    starts = [points_along(shape.geometry, run.run, 1e9)[0][0] for run in shape.runs]
    assert starts == pytest.approx([20 + 18 * k for k in range(9)], abs=0.75)
    assert [run.run.length for run in shape.runs] == pytest.approx([12.0] * 9, abs=1.0)
    assert [run.width for run in shape.runs] == pytest.approx([2.0] * 9, abs=0.25)


def test_crossings_do_not_widen(sketch: Sketch) -> None:
    drawn = sketch().line((20, 60), (180, 60), 2.0)
    for x in range(35, 180, 15):
        drawn.line((x, 20), (x, 140), 3.0)
    _, shapes = _inked(drawn)
    assert [run.width for run in _level(shapes, 60.0).runs] == pytest.approx([2.0], abs=0.2)


@pytest.mark.parametrize("gap", [6.0, 8.0, 12.0])
def test_a_line_beside_does_not_widen(sketch: Sketch, gap: float) -> None:
    drawn = sketch().line((20, 60), (180, 60), 2.0).line((20, 60 + gap), (180, 60 + gap), 3.0)
    _, shapes = _inked(drawn)
    assert [run.width for run in _level(shapes, 60.0).runs] == pytest.approx([2.0], abs=0.2)
    assert [run.width for run in _level(shapes, 60.0 + gap).runs] == pytest.approx([3.0], abs=0.2)
