"""Gaps between the dashes of a sheet."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet
from gaussiancad_core.sheet.image.dash_gaps import dash_gap
from gaussiancad_core.sheet.sheet_stages import read_views
from gaussiancad_core.sheet.views.role_score import Drawings, arrange
from gaussiancad_core.sheet.views.sheet_layout import view_clusters

Sketch = Any
"""The class that the fixture gives."""


@pytest.mark.parametrize(("dash", "gap"), [(12, 6), (24, 15), (50, 25), (30, 30)])
@pytest.mark.parametrize("upright", [False, True])
def test_free_dashes_tell_their_gap(sketch: Sketch, dash: int, gap: int, upright: bool) -> None:
    drawn = sketch(700, 700).lines((10, 10), (690, 10), (690, 690), (10, 690), (10, 10))
    drawn.broken((30, 100), (680, 100), (dash, gap)).broken((30, 300), (680, 300), (dash, gap))
    ink = drawn.weight > 0.5
    assert dash_gap(ink.T if upright else ink, 2.5) == pytest.approx(gap, abs=1.1)


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize("lines", [4, 2])
def test_dashes_that_others_cross_tell_it_too(sketch: Sketch, upright: bool, lines: int) -> None:
    """Through a thin plate one dash is free, the next is crossed, the last one ends at its edge."""
    drawn = sketch(500, 300).lines((50, 100), (450, 100), (450, 168), (50, 168), (50, 100))
    drawn.line((50, 139), (450, 139), 2.0)
    for x in range(100, 100 + 80 * lines, 80):
        for y in (108, 132, 156):
            drawn.line((x, y), (x, min(y + 14, 168)), 2.0)
    ink = drawn.weight > 0.5
    gap = dash_gap(ink.T if upright else ink, 2.5)
    assert gap == (pytest.approx(10, abs=1.1) if lines > 2 else 0.0)


def test_gaps_that_differ_tell_none(sketch: Sketch) -> None:
    """Pieces before an edge, half of them at one distance from it and half at another."""
    drawn = sketch(700, 300).lines((50, 100), (650, 100), (650, 168), (50, 168), (50, 100))
    for k, x in enumerate(range(80, 640, 40)):
        end = 146 if k % 2 else 137
        drawn.line((x, end - 14), (x, end), 2.0).line((x, 155), (x, 168), 2.0)
    assert dash_gap(drawn.weight > 0.5, 2.5) == 0.0


def test_other_lines_tell_none(sketch: Sketch) -> None:
    """Lines of different lengths, and marks beside each other."""
    drawn = sketch(500, 300).lines((10, 10), (490, 10), (490, 290), (10, 290), (10, 10))
    for x, y, length in ((30, 60, 20), (70, 60, 60), (150, 60, 30), (200, 80, 20), (230, 87, 20)):
        drawn.line((x, y), (x + length, y), 2.0)
    assert dash_gap(drawn.weight > 0.5, 2.5) == 0.0


@pytest.mark.parametrize(("dash", "gap"), [(12, 6), (40, 20)])
def test_thin_lines_of_long_dashes_are_one_stroke(sketch: Sketch, dash: int, gap: int) -> None:
    """As CAD programs draw them: a gap is ten times as wide as the line."""
    drawn = sketch(700, 500)
    corners = ((40, 40), (660, 40), (660, 240), (40, 240), (40, 40))
    drawn.lines(*corners, width=2.0).lines(*(np.add(corners, (0, 230))), width=2.0)
    for y in (100.0, 160.0):
        drawn.broken((41, y), (41 + 10 * dash + 9 * gap, y), (dash, gap), 2.0)
    clean = upright_sheet(clean_sheet(drawn.grey))
    given = {Role.FRONT: (0, 0, 700, 255), Role.BOTTOM: (0, 256, 700, 500)}
    layout = arrange(Drawings(view_clusters(clean.ink, 0.0), clean.ink), given, None)
    front = read_views(clean, layout)[0]
    hidden = [stroke for stroke in front.strokes if stroke.linetype is Linetype.HIDDEN]
    assert len(hidden) == 2
    assert all(item.length > 10 * dash + 9 * gap - 2.0 for item in hidden)
