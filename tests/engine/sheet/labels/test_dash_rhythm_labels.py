"""Long and short by turns is a centre line; equal dashes are none."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels.dash_rhythm_labels import alternating, rhythm_odds
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.tracing.ink_runs import Run


def _broken(lengths: list[float]) -> InkedShape:
    starts = np.cumsum([0.0, *(length + 4.0 for length in lengths)])
    runs = [Run(a, a + length) for a, length in zip(starts.tolist(), lengths, strict=False)]
    return InkedShape(Line((0.0, 0.0), (1.0, 0.0)), tuple(InkedRun(run, 1.5) for run in runs))


def _log_p(ink: InkClass) -> np.ndarray:
    log_p = np.full((5, len(InkClass)), -8.0)
    log_p[:, ink] = 0.0
    return log_p


@pytest.mark.parametrize("lengths", [[22, 5] * 6, [5, 22] * 6, [22, 5, 22, 30, 5, 22, 5, 22]])
def test_long_and_short_by_turns_is_no_hidden_line(lengths: list[float]) -> None:
    """Also where lines that cross it join two of its dashes."""
    shape = _broken(lengths)
    odds = rhythm_odds(shape, shape.runs[0], _log_p(InkClass.HIDDEN))
    assert (odds < -1.0).all()


@pytest.mark.parametrize("lengths", [[12] * 9, [12, 11, 14, 10, 11, 11, 10, 14], [22, 5, 22], []])
def test_equal_or_few_dashes_tell_nothing(lengths: list[float]) -> None:
    assert alternating(lengths) == 0.0


def test_a_rhythm_says_nothing_of_what_would_be_an_edge() -> None:
    shape = _broken([22, 5] * 6)
    assert rhythm_odds(shape, shape.runs[0], _log_p(InkClass.VISIBLE)) == pytest.approx(
        0.0, abs=0.01
    )
