"""Rows of dashes that no shape explains."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm
from gaussiancad_core.sheet.tracing.remaining_dashes import find_remaining_dashes

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = Rhythm(24.0, 12.0)


def _found(drawn: Any, rhythm: Rhythm = RHYTHM) -> list[Any]:  # noqa: ANN401
    sheet = upright_sheet(clean_sheet(drawn.grey))
    return find_remaining_dashes(sheet.ink, sheet, rhythm)


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.2, np.pi / 2])
def test_a_row_is_one_hidden_line(sketch: Sketch, angle: float) -> None:
    along = np.array([np.cos(angle), np.sin(angle)])
    ends = [np.array([60.0, 60.0]) + at * along for at in (0.0, 24.0 * 7 + 12.0 * 6)]
    drawn = sketch(400, 400).broken(tuple(ends[0]), tuple(ends[1]), (24, 12), 2.0)
    ((line, piece),) = _found(drawn)
    assert piece.linetype is Linetype.HIDDEN
    found = line.points_at(np.array([piece.start, piece.end]))
    order = np.argsort(found @ along)
    assert found[order] == pytest.approx(np.array(ends), abs=1.5)
    assert line.distances(np.array(ends)) == pytest.approx([0.0, 0.0], abs=0.1)


def test_a_row_may_lack_dashes_where_lines_cross_it(sketch: Sketch) -> None:
    drawn = sketch(500, 100)
    for k in (0, 1, 4, 5, 6):
        drawn.line((30 + 36 * k, 50), (54 + 36 * k, 50), 2.0)
    ((_, piece),) = _found(drawn)
    assert piece.end - piece.start == pytest.approx(36 * 6 + 24, abs=2.0)


@pytest.mark.parametrize(
    "places",
    [
        (0, 36, 72),  # too few
        (0, 36, 50 + 72, 50 + 108),  # out of step
        (0, 36, 72 + 144, 108 + 144),  # too many lacking
    ],
)
def test_other_pieces_are_no_row(sketch: Sketch, places: tuple[int, ...]) -> None:
    drawn = sketch(500, 100)
    for at in places:
        drawn.line((30 + at, 50), (54 + at, 50), 2.0)
    assert _found(drawn) == []


def test_rungs_beside_each_other_and_longer_lines_are_no_row(sketch: Sketch) -> None:
    drawn = sketch(500, 300)
    for k in range(6):
        drawn.line((40 + 12 * k, 40), (40 + 12 * k, 64), 2.0)
        drawn.line((30 + 70 * k, 150), (86 + 70 * k, 150), 2.0)
        drawn.line((30 + 36 * k, 220 + 6 * (k % 2)), (54 + 36 * k, 220 + 6 * (k % 2)), 2.0)
    assert _found(drawn) == []


@pytest.mark.parametrize("y", [50.0, 50.3, 49.6])
def test_what_another_stroke_took_of_the_dashes_counts_for_their_middle(
    sketch: Sketch, y: float
) -> None:
    drawn = sketch(500, 100).broken((30, y), (30 + 36 * 6 + 24, y), (24, 12), 3.0)
    # A stroke a px below takes most of their ink.
    drawn.line((20, y + 4.2), (280, y + 4.2), 3.0)
    sheet = upright_sheet(clean_sheet(drawn.grey))
    left = sheet.ink.copy()
    left[50:] = False
    ((line, _),) = find_remaining_dashes(left, sheet, RHYTHM)
    assert line.distances(np.array([[30.0, y], [200.0, y]])) == pytest.approx(0.0, abs=0.15)
