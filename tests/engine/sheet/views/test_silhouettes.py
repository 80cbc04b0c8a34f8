"""Figures of views, without what sticks out of them."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.views.silhouettes import side_strips, without_stickouts

Sketch = Any
"""The class that the fixture gives."""

_BLOCK = ((40, 40), (160, 40), (160, 120), (40, 120), (40, 40))


def _found(drawn: Sketch, box: tuple[float, ...]) -> np.ndarray:
    (found,) = without_stickouts([box], drawn.weight > 0.5, 3.0)
    return np.array(found)


def test_lines_that_end_free_do_not_count(sketch: Sketch) -> None:
    """Two extension lines side by side on the right, a dimension line on the left, and a digit."""
    drawn = sketch(240, 160).lines(*_BLOCK)
    drawn.line((160, 40), (205, 40)).line((160, 45), (205, 45)).line((10, 120), (40, 120))
    drawn.lines((20, 70), (28, 70), (28, 80), (20, 80), (20, 70), width=2.0)
    assert _found(drawn, (10, 39, 206, 122)) == pytest.approx([39, 39, 162, 122], abs=1.0)


def test_points_of_a_figure_count(sketch: Sketch) -> None:
    drawn = sketch(240, 160).lines((40, 40), (200, 80), (40, 120), (40, 40))
    assert _found(drawn, (39, 38, 204, 122)) == pytest.approx([39, 38, 204, 122])


def test_a_figure_that_is_open_keeps_its_box(sketch: Sketch) -> None:
    drawn = sketch(240, 160).lines(*_BLOCK[:4]).line((160, 40), (205, 40))
    drawn.lines((170, 60), (185, 60), (185, 70), (170, 70), (170, 60))
    box = (39.0, 39.0, 206.0, 122.0)
    assert _found(drawn, box) == pytest.approx(box)


def test_what_is_beside_a_figure() -> None:
    assert side_strips((0, 0, 10, 10), (0, 0, 10, 10)) == []
    assert side_strips((0, 0, 10, 10), (2, 0, 10, 9)) == [(0, 0, 2, 10), (0, 9, 10, 10)]
