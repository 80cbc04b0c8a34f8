"""Two or three narrow dashes between edges stay; extension lines go."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.annotations.short_rows import spare_short_rows
from gaussiancad_core.sheet.clean import clean_sheet, upright_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

PLACES = range(80, 440, 60)


@pytest.mark.parametrize(("dash", "gap", "high"), [(26, 13, 70), (14, 14, 75), (26, 13, 110)])
def test_rows_of_a_thin_plate_stay(sketch: Sketch, dash: int, gap: int, high: int) -> None:
    """No row has more than three dashes, and the last one is at an edge or cut by it."""
    bottom = 60 + high
    drawn = sketch(500, 300).lines(
        (40, 60), (460, 60), (460, bottom), (40, bottom), (40, 60), width=3.0
    )
    plain = drawn.weight.copy()
    for x in PLACES:
        for y in np.arange(60 + 0.5 * gap, bottom, dash + gap):
            drawn.line((x, y), (x, min(y + dash, bottom)), 1.5)
    sheet = upright_sheet(clean_sheet(drawn.grey))
    assert sheet.dash_gap == pytest.approx(gap, abs=1.1)
    part = separate_annotations(sheet).part.weight
    dashes = (drawn.weight > 0.5) & (plain < 0.1)
    assert (part[dashes] > 0.2).mean() > 0.95


@pytest.mark.parametrize(
    ("pieces", "stays"),
    [
        (((5.0, 31.0), (44.0, 70.0)), True),
        (((0.0, 13.0), (26.0, 52.0), (65.0, 70.0)), True),
        # From one edge alone, at another gap, not alike, and one by itself.
        (((0.0, 26.0), (39.0, 50.0)), False),
        (((5.0, 31.0), (52.0, 70.0)), False),
        (((0.0, 10.0), (23.0, 70.0)), False),
        (((0.0, 70.0),), False),
    ],
)
def test_dashes_lead_from_edge_to_edge(pieces: tuple, stays: bool) -> None:
    """Px below the upper one of two edges that are 70 px apart."""
    shapes = [
        InkedShape(Line((0.0, y), (1.0, 0.0)), (InkedRun(Run(-100.0, 100.0), 3.0),))
        for y in (0.0, 70.0)
    ]
    runs = tuple(InkedRun(Run(*piece), 1.5) for piece in pieces)
    shapes.append(InkedShape(Line((0.0, 0.0), (0.0, 1.0)), runs))
    told = AnnotationKind.EXTENSION
    kinds = [[None], [None], [told] * len(runs)]
    spare_short_rows(shapes, kinds, Weights(3.0, 2.2), 13.0, 2.0)
    assert kinds[2] == [None if stays else told] * len(runs)


def test_an_extension_line_that_edges_cut_is_no_row() -> None:
    """Its pieces may be alike, and the ink of an edge as wide as a gap."""
    shapes = [
        InkedShape(Line((0.0, y), (1.0, 0.0)), (InkedRun(Run(-100.0, 100.0), 3.0),))
        for y in (0.0, 75.0, 160.0)
    ]
    runs = (InkedRun(Run(2.0, 70.0), 1.5), InkedRun(Run(82.0, 158.0), 1.5))
    shapes.append(InkedShape(Line((0.0, 0.0), (0.0, 1.0)), runs))
    told = AnnotationKind.EXTENSION
    kinds = [[None], [None], [None], [told] * 2]
    spare_short_rows(shapes, kinds, Weights(3.0, 2.2), 13.0, 2.0)
    assert kinds[3] == [told] * 2
