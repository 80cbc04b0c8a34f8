"""Dashes of centre lines beyond dots that lie on an edge."""

from collections.abc import Sequence

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lines import Weights, kinds_of_runs
from gaussiancad_core.sheet.annotations.swallowed_dots import mark_beyond_swallowed_dots
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

_WIDTH = 1.5
"""px of the centre line's dashes."""

_CENTRE = AnnotationKind.CENTRE_LINE


def _chain(swallowed: Sequence[int], last: float = 24.0) -> list[InkedRun]:
    """Five dashes of 24 px with dots of 5 between, at gaps of 5 px; without some of the dots."""
    runs, at = [], 100.0
    for k in range(9):
        length = (5.0 if k % 2 else 24.0) if k < 8 else last
        if k not in swallowed:
            runs.append(InkedRun(Run(at, at + length), _WIDTH))
        at += length + 5.0
    return runs


def _told(runs: list[InkedRun], stroke_width: float = 2.8) -> list[AnnotationKind | None]:
    line = InkedShape(Line((0.0, 50.0), (1.0, 0.0)), tuple(runs))
    (kinds,) = kinds_of_runs([line], Weights(stroke_width, 0.0), stroke_width)
    return kinds


@pytest.mark.parametrize("swallowed", [(1,), (7,), (1, 7)])
def test_dashes_beyond_a_dot_on_an_edge_are_the_centre_lines(swallowed: tuple[int, ...]) -> None:
    runs = _chain(swallowed)
    assert _told(runs) == [_CENTRE] * len(runs)


@pytest.mark.parametrize("last", [8.0, 24.0])
def test_the_last_dash_may_be_cut(last: float) -> None:
    runs = _chain((7,), last)
    assert _told(runs) == [_CENTRE] * len(runs)


@pytest.mark.parametrize("last", [2.0, 6.0, 9.0])
def test_what_is_left_of_a_dash_behind_a_dot_is_no_dot(last: float) -> None:
    """The arms of a small bore's cross have room for three dashes and the beginning of a fourth."""
    runs, at = [], 100.0
    for k, length in enumerate((24.0, 5.0, 24.0, 5.0, 24.0, 5.0, last)):
        # The bore's circle swallows the first dot.
        if k != 1:
            runs.append(InkedRun(Run(at, at + length), _WIDTH))
        at += length + 5.0
    # With wide strokes gaps as wide as that are within one line of dashes.
    assert _told(runs, 3.6) == [_CENTRE] * len(runs)


@pytest.mark.parametrize(
    ("beyond", "width"),
    [
        # An edge in line with it: longer, or wider.
        (Run(249.0, 349.0), _WIDTH),
        (Run(249.0, 273.0), 3.0),
        # Nearer or farther than a dot leaves room for.
        (Run(242.0, 266.0), _WIDTH),
        (Run(260.0, 284.0), _WIDTH),
    ],
)
def test_other_lines_stay(beyond: Run, width: float) -> None:
    runs = [*_chain((7, 8)), InkedRun(beyond, width)]
    kinds: list[AnnotationKind | None] = [_CENTRE] * (len(runs) - 1) + [None]
    mark_beyond_swallowed_dots(runs, kinds)
    assert kinds[-1] is None


def test_dashes_of_a_hidden_line_that_goes_on_stay() -> None:
    """They are as short as a dash that is cut, but not the last of their row."""
    row = [Run(249.0 + 18.0 * k, 261.0 + 18.0 * k) for k in range(3)]
    runs = [*_chain((7, 8)), *(InkedRun(run, _WIDTH) for run in row)]
    kinds: list[AnnotationKind | None] = [_CENTRE] * (len(runs) - 3) + [None] * 3
    mark_beyond_swallowed_dots(runs, kinds)
    assert kinds[-3:] == [None] * 3
