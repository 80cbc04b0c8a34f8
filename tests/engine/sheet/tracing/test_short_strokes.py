"""Short strokes between two others that are neither a line nor an arc to growth."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

ABOVE, BELOW = 80.0, 97.0


def _between(drawn: Sketch) -> list[Stroke]:
    """The visible strokes with both ends on the two level lines."""
    return [
        item
        for item in _visible(drawn)
        if np.ptp(item.sample(0.5)[:, 1]) == pytest.approx(BELOW - ABOVE, abs=1.0)
    ]


def _visible(drawn: Sketch) -> list[Stroke]:
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, (10.0, 10.0, 250.0, 170.0))
    strokes = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    return [stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE]


def _frame(sketch: Sketch) -> Sketch:
    drawn = sketch(260, 180).lines((12, 12), (248, 12), (248, 168), (12, 168), (12, 12))
    return drawn.line((12, ABOVE), (248, ABOVE)).line((12, BELOW), (248, BELOW))


@pytest.mark.parametrize(
    ("turn", "radius"), [(25.0, 50.0), (25.0, 60.0), (30.0, 50.0), (35.0, 50.0), (35.0, 70.0)]
)
def test_a_flat_arc_from_edge_to_edge(sketch: Sketch, turn: float, radius: float) -> None:
    """It leaves the lower line and bends by a pixel on its way to the upper one."""
    first = np.radians(180.0 + turn)
    centre = (120.0 - radius * np.cos(first), BELOW - radius * np.sin(first))
    last = np.arcsin((centre[1] - ABOVE) / radius)
    sweep = np.pi + last - first
    drawn = _frame(sketch).arc(centre, radius, 3.0, float(first), float(sweep))
    (found,) = _between(drawn)
    points = found.sample(0.5) - 0.5
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    assert away.max() < 0.8
    assert points[:, 1].min() == pytest.approx(ABOVE, abs=0.5)
    assert points[:, 1].max() == pytest.approx(BELOW, abs=0.5)


@pytest.mark.parametrize("leg", [10.25, 11.5, 12.75, 14.0])
def test_a_cut_beside_a_corner_is_straight(sketch: Sketch, leg: float) -> None:
    """The ink of the corner's lines draws both of its ends to one side."""
    drawn = _frame(sketch).line((12.0, ABOVE + leg), (12.0 + leg, ABOVE), 2.8)
    cut = [
        item for item in _visible(drawn) if 0.8 * leg < np.ptp(item.sample(0.5)[:, 0]) < 1.2 * leg
    ]
    points = np.concatenate([item.sample(0.5) for item in cut]) - 0.5
    away = np.abs(points.sum(axis=1) - 12.0 - leg - ABOVE) / np.sqrt(2.0)
    assert isinstance(cut[0], Segment)
    assert len(cut) == 1
    assert away.max() < 0.4


def test_a_blot_between_edges_is_none(sketch: Sketch) -> None:
    drawn = _frame(sketch).line((120.0, 86.0), (124.0, 92.0), 4.0)
    assert not _between(drawn)
