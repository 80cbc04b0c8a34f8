"""Runs of ink along shapes, how wide they are."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.annotations.inked_shapes import InkedShape, inked_shape, points_along
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Run, ink_field
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_shapes

Sketch = Any
"""The class that the fixture gives."""


def _widest(drawn: Sketch, y: float) -> InkedShape:
    """The shape with most ink whose middle is at a height."""
    sheet = clean_sheet(drawn.grey)
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    grown = grow_shapes(ridges, GrowthRules.of_width(sheet.stroke_width))
    at = np.array([[100.0, y]])
    return max(
        (inked_shape(sheet, ink_field(sheet), ridges, item) for item in grown
         if item.geometry.distances(at).max() < 0.5),
        key=lambda shape: sum(run.run.length for run in shape.runs),
    )  # fmt: skip


def test_points_along_a_line_and_a_circle() -> None:
    level, circle = Line((10.0, 20.0), (1.0, 0.0)), Circle((50.0, 60.0), 20.0)
    points = points_along(level, Run(-5.0, 15.0), 1.0)
    assert points == pytest.approx(np.stack([np.arange(5.0, 26.0), np.full(21, 20.0)], axis=1))
    # Both ends are there, however far apart the points may be.
    ends = points_along(level, Run(-5.0, 15.0), 1e9)
    assert ends == pytest.approx(np.array([[5.0, 20.0], [25.0, 20.0]]))
    points = points_along(circle, Run(-10.0, 30.0), 0.5)
    assert circle.distances(points) == pytest.approx(0.0, abs=1e-9)
    assert np.hypot(*np.diff(points, axis=0).T) == pytest.approx(0.5, abs=0.01)
    assert points[0] == pytest.approx((50.0 + 20.0 * np.cos(-0.5), 60.0 + 20.0 * np.sin(-0.5)))


@pytest.mark.parametrize(
    ("width", "lift"), [(1.0, 0.0), (1.5, 40.0), (2.0, 93.0), (5.0, 40.0), (8.0, 0.0)]
)
def test_a_run_is_as_wide_as_it_was_drawn(sketch: Sketch, width: float, lift: float) -> None:
    # Another line, full of ink, for the darkness of what is thinner than a pixel.
    drawn = sketch().line((20.0, 150.0), (180.0, 150.0), 4.0)
    drawn.line((20.0, 30.3), (180.0, 30.3 + lift), width)
    (run,) = _widest(drawn, 30.3 + lift / 2.0).runs
    assert run.width == pytest.approx(width, abs=0.25)
    assert run.run.length == pytest.approx(np.hypot(160.0, lift), abs=2.5)


def test_the_width_of_a_circle(sketch: Sketch) -> None:
    (run,) = _widest(sketch().arc((100, 80), 50.0, 2.5), 30.0).runs
    assert run.width == pytest.approx(2.5, abs=0.15)
    assert run.run.length == pytest.approx(2 * np.pi * 50.0, abs=1.5)


def test_every_dash_is_a_run(sketch: Sketch) -> None:
    shape = _widest(sketch().broken((20, 60), (180, 60), (12, 6), 2.0), 60.0)
    starts = [points_along(shape.geometry, run.run, 1e9)[0][0] for run in shape.runs]
    assert starts == pytest.approx([20 + 18 * k for k in range(9)], abs=0.75)
    assert [run.run.length for run in shape.runs] == pytest.approx([12.0] * 9, abs=1.0)
    assert [run.width for run in shape.runs] == pytest.approx([2.0] * 9, abs=0.25)


@pytest.mark.parametrize("gap", [6.0, 12.0])
def test_what_crosses_or_runs_beside_does_not_widen(sketch: Sketch, gap: float) -> None:
    drawn = sketch().line((20, 60), (180, 60), 2.0).line((20, 60 + gap), (180, 60 + gap), 3.0)
    for x in range(35, 180, 15):
        drawn.line((x, 20), (x, 60), 3.0)
    for y, width in ((60.0, 2.0), (60.0 + gap, 3.0)):
        widths = [run.width for run in _widest(drawn, y).runs]
        assert widths == pytest.approx([width], abs=0.25)
