"""Cutting lines in steps are followed from end to end."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.writing.cutting_line_steps import stepped_path

_CORNERS = ((100.0, 500.0), (300.0, 500.0), (300.0, 420.0), (520.0, 420.0), (520.0, 610.0))
_END = (700.0, 610.0)


def _lines(dash: float) -> list[tuple[np.ndarray, np.ndarray]]:
    """The legs of the line, in dashes with gaps of a quarter of their length."""
    found = []
    corners = [np.array(item) for item in (*_CORNERS, _END)]
    for start, end in pairwise(corners):
        length = float(np.hypot(*(end - start)))
        way = (end - start) / length
        for at in np.arange(0.0, length, 1.25 * dash):
            found.append((start + at * way, start + min(at + dash, length) * way))
    return found


@pytest.mark.parametrize("dash", [1e4, 40.0, 16.0])
@pytest.mark.parametrize("turned", [False, True])
def test_a_line_in_steps_has_its_corners(dash: float, turned: bool) -> None:
    ends = (_CORNERS[0], _END)
    path = stepped_path(ends[::-1] if turned else ends, (0.0, -1.0), _lines(dash))
    expected = [*_CORNERS, _END]
    found = np.array(path[::-1] if turned else path)
    assert found == pytest.approx(np.array(expected), abs=dash if dash < 1e3 else 1e-6)


def test_where_lines_end_there_is_no_path() -> None:
    ends = (_CORNERS[0], _END)
    assert stepped_path(ends, (0.0, -1.0), _lines(1e4)[:2]) == ()
