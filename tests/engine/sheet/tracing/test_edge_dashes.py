"""Hidden lines whose dashes melt into the ink of an edge."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.edge_dashes import with_edge_dashes
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.twin_lines import with_twins
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = (12.0, 6.0)
HIDDEN = [50.0, 70.0, 90.0, 190.0]
"""y of hidden lines that tell the pen."""

Levels = dict[Linetype, list[float]]


def _plate(sketch: Sketch, wide: float, narrow: float) -> Sketch:
    corners = (20, 20), (300, 20), (300, 220), (20, 220), (20, 20)
    drawn = sketch(320, 240).lines(*corners, width=wide)
    for y in HIDDEN:
        drawn.broken((22, y), (298, y), RHYTHM, narrow)
    return drawn


def _levels(drawn: Sketch) -> Levels:
    """y of the long level lines of a sheet, px; centres of pixels at integers."""
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, (20.0, 20.0, 300.0, 220.0))
    rhythm = view_rhythm([view], sheet.stroke_width)
    views = with_edge_dashes(with_twins([view], rhythm), rhythm)
    strokes = classify_strokes(views[0], rhythm, view_pens(views, rhythm))
    found: Levels = {Linetype.VISIBLE: [], Linetype.HIDDEN: []}
    for stroke in strokes:
        ends = stroke.sample(1e9)[[0, -1]]
        if abs(ends[0, 0] - ends[1, 0]) > 150.0:
            found[stroke.linetype].append(float(ends[:, 1].mean()) - 0.5)
    return {kind: sorted(levels) for kind, levels in found.items()}


@pytest.mark.parametrize(
    ("wide", "narrow", "aparts"),
    [
        (3.0, 1.8, (1.6, 2.0, 2.4, 2.8, 3.2, 3.6)),
        (2.6, 2.0, (1.6, 2.0, 2.4, 2.8, 3.2, 3.6)),
        (2.0, 2.0, (1.6, 2.0, 2.4, 2.8, 3.2)),
        (4.0, 2.0, (2.4, 2.8, 3.2, 3.6, 4.0)),
    ],
)
@pytest.mark.parametrize("edge", [140.0, 220.0])
def test_a_hidden_line_beside_an_edge(
    sketch: Sketch, wide: float, narrow: float, aparts: tuple[float, ...], edge: float
) -> None:
    for apart in aparts:
        drawn = _plate(sketch, wide, narrow).line((20, edge), (300, edge), wide)
        drawn.broken((22, edge - apart), (298, edge - apart), RHYTHM, narrow)
        found = _levels(drawn)
        assert found[Linetype.HIDDEN] == pytest.approx(sorted([*HIDDEN, edge - apart]), abs=0.3), (
            apart
        )
        assert found[Linetype.VISIBLE] == pytest.approx(sorted({20.0, edge, 220.0}), abs=0.3), apart


def test_lines_that_cross_cover_some_of_the_dashes(sketch: Sketch) -> None:
    drawn = _plate(sketch, 3.0, 1.8).line((20, 140), (300, 140), 3.0)
    for x in (81.0, 160.0, 233.0):
        drawn.line((x, 20), (x, 220), 3.0)
    drawn.broken((22, 137.6), (298, 137.6), RHYTHM, 1.8)
    assert _levels(drawn)[Linetype.HIDDEN][3] == pytest.approx(137.6, abs=0.3)


def test_a_part_of_an_edge_may_have_a_hidden_line_beside_it(sketch: Sketch) -> None:
    drawn = _plate(sketch, 3.0, 1.8).line((20, 140), (300, 140), 3.0)
    drawn.broken((60, 137.6), (216, 137.6), RHYTHM, 1.8)
    found = _levels(drawn)
    assert found[Linetype.HIDDEN] == pytest.approx([50.0, 70.0, 90.0, 137.6, 190.0], abs=0.3)
    assert found[Linetype.VISIBLE] == pytest.approx([20.0, 140.0, 220.0], abs=0.3)


def test_what_goes_on_hidden_where_the_edge_ends_stays(sketch: Sketch) -> None:
    drawn = _plate(sketch, 3.0, 1.8).line((20, 140), (130, 140), 3.0)
    drawn.line((130, 20), (130, 140), 3.0).broken((136, 140), (298, 140), RHYTHM, 1.8)
    drawn.broken((22, 137.6), (128, 137.6), RHYTHM, 1.8)
    assert _levels(drawn)[Linetype.HIDDEN] == pytest.approx(
        [50.0, 70.0, 90.0, 140.0, 190.0], abs=0.3
    )


def test_where_all_gaps_are_crossed_nothing_is_told(sketch: Sketch) -> None:
    drawn = _plate(sketch, 3.0, 1.8).line((20, 140), (300, 140), 3.0)
    drawn.broken((22, 137.6), (298, 137.6), RHYTHM, 1.8)
    for x in np.arange(37.0, 290.0, 18.0):
        drawn.line((x, 118), (x, 162), 5.0)
    assert len(_levels(drawn)[Linetype.VISIBLE]) == 3


@pytest.mark.parametrize(
    "rough",
    [
        # Two or three dashes may be anything, and so may what is in no rhythm, or of any width.
        [(60.0, 12.0, 1.5), (78.0, 12.0, 1.5), (96.0, 12.0, 1.5)],
        [(40.0 + 30.0 * k, 5.0, 1.5) for k in range(8)],
        [(40.0, 12.0, 1.5), (58.0, 30.0, 1.5), (96.0, 12.0, 1.5), (140.0, 12.0, 1.5)],
        [(40.0 + 18.0 * k, 12.0, 1.0 + 0.35 * (k % 3)) for k in range(10)],
    ],
)
def test_an_edge_of_uneven_width_has_none(
    sketch: Sketch, rough: list[tuple[float, float, float]]
) -> None:
    drawn = _plate(sketch, 3.0, 1.8).line((20, 140), (300, 140), 3.0)
    for x, length, aside in rough:
        drawn.line((x, 140 - aside), (x + length, 140 - aside), 1.8)
    assert _levels(drawn)[Linetype.HIDDEN] == pytest.approx(HIDDEN, abs=0.3)
