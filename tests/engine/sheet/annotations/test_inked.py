"""Runs of ink along shapes, how wide they are, and where they change their width."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.annotations.inked import (
    InkedShape,
    inked_shape,
    normals_along,
    points_along,
    split_by_width,
)
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.growth import GrowthRules, grow_shapes
from gaussiancad_core.sheet.ridges import ridge_points
from gaussiancad_core.sheet.runs import Run, ink_field

Sketch = Any
"""The class that the fixture gives."""

LEVEL = Line((10.0, 20.0), (1.0, 0.0))


def _inked(drawn: Sketch) -> tuple[CleanSheet, list[InkedShape]]:
    sheet = clean_sheet(drawn.grey)
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    grown = grow_shapes(ridges, GrowthRules.of_width(sheet.stroke_width))
    field = ink_field(sheet)
    return sheet, [inked_shape(sheet, field, ridges, own) for own in grown]


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


def test_points_and_normals_of_a_line() -> None:
    run = Run(-5.0, 15.0)
    points = points_along(LEVEL, run, 1.0)
    assert points == pytest.approx(np.stack([np.arange(5.0, 26.0), np.full(21, 20.0)], axis=1))
    assert np.abs(normals_along(LEVEL, run, 1.0)) == pytest.approx(np.array([[0.0, 1.0]] * 21))
    # Both ends are there, however far apart the points may be.
    assert points_along(LEVEL, run, 1e9) == pytest.approx(np.array([[5.0, 20.0], [25.0, 20.0]]))


def test_points_and_normals_of_a_circle() -> None:
    circle = Circle((50.0, 60.0), 20.0)
    run = Run(-10.0, 30.0)
    points = points_along(circle, run, 0.5)
    assert circle.distances(points) == pytest.approx(0.0, abs=1e-9)
    steps = np.hypot(*np.diff(points, axis=0).T)
    assert steps == pytest.approx(0.5, abs=0.01)
    radial = points - np.array(circle.centre)
    assert normals_along(circle, run, 0.5) * 20.0 == pytest.approx(radial)
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
    starts = [points_along(shape.geometry, own.run, 1e9)[0][0] for own in shape.runs]
    assert starts == pytest.approx([20 + 18 * k for k in range(9)], abs=0.75)
    assert [own.run.length for own in shape.runs] == pytest.approx([12.0] * 9, abs=1.0)
    assert [own.width for own in shape.runs] == pytest.approx([2.0] * 9, abs=0.25)


def test_crossings_do_not_widen(sketch: Sketch) -> None:
    drawn = sketch().line((20, 60), (180, 60), 2.0)
    for x in range(35, 180, 15):
        drawn.line((x, 20), (x, 140), 3.0)
    _, shapes = _inked(drawn)
    assert [own.width for own in _level(shapes, 60.0).runs] == pytest.approx([2.0], abs=0.2)


@pytest.mark.parametrize("gap", [6.0, 8.0, 12.0])
def test_a_line_beside_does_not_widen(sketch: Sketch, gap: float) -> None:
    drawn = sketch().line((20, 60), (180, 60), 2.0).line((20, 60 + gap), (180, 60 + gap), 3.0)
    _, shapes = _inked(drawn)
    assert [own.width for own in _level(shapes, 60.0).runs] == pytest.approx([2.0], abs=0.2)
    assert [own.width for own in _level(shapes, 60.0 + gap).runs] == pytest.approx([3.0], abs=0.2)


@pytest.mark.parametrize("place", [60.0, 80.5, 130.0])
def test_an_extension_line_that_goes_on_as_an_edge_is_cut(sketch: Sketch, place: float) -> None:
    sheet, shape = _only(
        sketch().line((20, 60), (place, 60), 1.5).line((place, 60), (180, 60), 3.0)
    )
    assert len(shape.runs) == 1
    cut = split_by_width(sheet, shape, 2.2, 3.0)
    assert cut.geometry == shape.geometry
    assert len(cut.runs) == 2
    ends = sorted(
        (points_along(shape.geometry, own.run, 1e9)[:, 0].min(), own.width) for own in cut.runs
    )
    assert [width for _, width in ends] == pytest.approx([1.5, 3.0], abs=0.2)
    assert ends[1][0] == pytest.approx(place, abs=2.0)
    # The parts are the whole.
    assert sum(own.run.length for own in cut.runs) == pytest.approx(shape.runs[0].run.length)
    assert cut.runs[0].run.start == shape.runs[0].run.start
    assert cut.runs[0].run.end == cut.runs[1].run.start


@pytest.mark.parametrize("length", [60, 15])
def test_an_edge_between_two_extension_lines(sketch: Sketch, length: int) -> None:
    """A short one is no arrowhead: it is as wide as edges all along."""
    drawn = sketch().line((20, 60), (70, 60), 1.5).line((70, 60), (70 + length, 60), 3.0)
    sheet, shape = _only(drawn.line((70 + length, 60), (180, 60), 1.5))
    cut = split_by_width(sheet, shape, 2.2, 3.0)
    assert [own.width for own in cut.runs] == pytest.approx([1.5, 3.0, 1.5], abs=0.2)
    assert [own.run.length for own in cut.runs] == pytest.approx([50, length, 110 - length], abs=3)


def test_arrowheads_stay_with_their_line(sketch: Sketch) -> None:
    drawn = sketch().line((20, 60), (180, 60), 1.5)
    drawn.filled((20, 60), (32, 57.5), (32, 62.5)).filled((180, 60), (168, 57.5), (168, 62.5))
    # The sheet's other lines: without them the arrows would be as wide as its strokes.
    drawn.line((20, 110), (180, 110), 3.0).line((20, 130), (180, 130), 3.0)
    sheet, shapes = _inked(drawn)
    cut = split_by_width(sheet, _level(shapes, 60.0), 2.2, 3.0)
    assert len(cut.runs) == 1
    assert cut.runs[0].width == pytest.approx(1.5, abs=0.25)


def test_a_large_wide_arrowhead_is_no_edge(sketch: Sketch) -> None:
    """It is longer than a short edge, and twice as wide."""
    drawn = sketch().line((20, 60), (180, 60), 1.0).filled((180, 60), (158, 53), (158, 67))
    for y in (90, 100, 110, 120, 130):
        drawn.line((20, y), (180, y), 2.0)
    sheet, shapes = _inked(drawn)
    cut = split_by_width(sheet, _level(shapes, 60.0), 1.4, 2.0)
    assert len(cut.runs) == 1


def test_lines_of_one_width_stay_whole(sketch: Sketch) -> None:
    for width in (1.5, 3.0):
        drawn = sketch().line((20, 60), (180, 60), width).line((90, 20), (90, 140), 3.0)
        sheet, shapes = _inked(drawn)
        shape = _level(shapes, 60.0)
        cut = split_by_width(sheet, shape, 2.2, 3.0)
        assert [own.run for own in cut.runs] == [own.run for own in shape.runs]
