"""What is cut is told by its hatching, as far as the edges and centre lines around it."""

import itertools

import numpy as np
import pytest

from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.special_views.cut_areas import cut_areas

_EDGES = [(20, 20), (180, 20), (180, 60), (20, 60), (20, 20)]
"""A bar."""


def _ink(*chains: list[tuple[int, int]]) -> np.ndarray:
    ink = np.zeros((120, 220), dtype=bool)
    for chain in chains:
        for (x0, y0), (x1, y1) in itertools.pairwise(chain):
            ink[min(y0, y1) : max(y0, y1) + 1, min(x0, x1) : max(x0, x1) + 1] = True
    return ink


def _hatching(low: float, high: float) -> list[VectorStroke]:
    """Lines at 45 degrees that fill the bar between two columns."""
    lines = []
    for at in np.arange(low - 35.0, high, 10.0):
        start, end = max(at, low), min(at + 40.0, high)
        lines.append(
            VectorStroke(LineSegment((start, 60.0 - start + at), (end, 60.0 - end + at)), 1.0)
        )
    return lines


@pytest.mark.parametrize("is_half", [False, True])
def test_hatching_fills_what_edges_enclose_up_to_a_centre_line(is_half: bool) -> None:
    centre = VectorStroke(LineSegment((100.0, 5.0), (100.0, 75.0)), 1.0)
    hatching = _hatching(20.0, 100.0 if is_half else 180.0)
    area = cut_areas(hatching, [centre], _ink(_EDGES))
    assert area is not None
    assert area[25:55, 25:95].all()
    assert area[25:55, 105:175].any() is np.bool_(not is_half)
    assert not area[:19].any() and not area[62:].any()


def test_a_half_that_is_open_at_the_centre_line_does_not_leak_out_of_the_view() -> None:
    left = [(100, 20), (20, 20), (20, 60), (100, 60)]
    centre = VectorStroke(LineSegment((100.0, 5.0), (100.0, 75.0)), 1.0)
    area = cut_areas(_hatching(20.0, 100.0), [centre], _ink(left))
    assert area is not None
    assert area[25:55, 25:95].all() and not area[:, 101:].any()
    assert not cut_areas(_hatching(20.0, 100.0), [], _ink(left)).any()


def test_without_hatching_nothing_is_cut() -> None:
    assert cut_areas([], [], _ink(_EDGES)) is None
