"""A sheet whose lines cross each other too often is refused before faces are made of them."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.errors import LimitError
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Pen
from gaussiancad_core.structure import crossings
from gaussiancad_core.structure.crossings import MOST_CROSSINGS, check_crossings, meetings

PEN = Pen(0.35, None, "")


def _line(start: tuple[float, float], end: tuple[float, float]) -> PaperStroke:
    return PaperStroke(LineSegment(start, end), PEN)


def _grid(rows: int, columns: int) -> list[PaperStroke]:
    level = [_line((0.0, float(row)), (columns - 1.0, float(row))) for row in range(rows)]
    return level + [_line((float(x), 0.0), (float(x), rows - 1.0)) for x in range(columns)]


@pytest.mark.parametrize("asked", [10_000, 7])
def test_each_pair_that_meets_counts_once(monkeypatch: pytest.MonkeyPatch, asked: int) -> None:
    monkeypatch.setattr(crossings, "_ASKED", asked)
    assert meetings(_grid(20, 20)) == 400.0
    assert meetings([]) == 0.0


def test_a_grating_is_a_drawing_and_a_scribble_is_none() -> None:
    check_crossings(_grid(200, 200))
    points = np.random.default_rng(1).uniform(0.0, 200.0, (1001, 2)).tolist()
    scribble = [_line(tuple(a), tuple(b)) for a, b in pairwise(points)]
    assert meetings(scribble) > MOST_CROSSINGS
    with pytest.raises(LimitError) as caught:
        check_crossings(scribble)
    assert caught.value.code == "too-many-elements"
    assert caught.value.message.args["most"] == MOST_CROSSINGS
