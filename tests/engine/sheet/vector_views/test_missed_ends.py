"""How far ends that meet miss each other, where no grid is left in the numbers of a file."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.vector_views.missed_ends import missed_px

CORNERS = np.array([(0, 0), (90, 0), (90, 40), (60, 70), (60, 110), (20, 110), (20, 60), (0, 40)])


def chain(neighbour: np.ndarray) -> list[LineSegment]:
    """Lines around a polygon, the ends of each moved by (n, 2, 2) px."""
    places = np.concatenate([CORNERS, CORNERS[:1]]).astype(float)
    return [
        LineSegment(tuple(a + off[0]), tuple(b + off[1]))
        for (a, b), off in zip(pairwise(places), neighbour, strict=True)
    ]


def test_lines_that_meet_miss_nothing() -> None:
    exact = chain(np.zeros((8, 2, 2)))
    assert missed_px(exact) == 0.0
    assert missed_px([*exact, CircularArc((30.0, 30.0), 9.0, 0.0, 2.0 * np.pi)]) == 0.0


@given(seed=st.integers(0, 2**32 - 1), size=st.floats(0.02, 0.1))
def test_ends_that_were_moved_tell_by_how_much(seed: int, size: float) -> None:
    lot = np.random.default_rng(seed)
    moved = lot.choice([-1.0, 1.0], size=(8, 2, 2)) * lot.uniform(0.5, 1.0, size=(8, 2, 2)) * size
    found = missed_px(chain(moved))
    # Both ends at a corner move: none by more than twice a diagonal.
    assert found == 0.0 or 0.005 < found <= 2.0 * np.sqrt(2.0) * size


def test_half_of_the_ends_moved_across_is_a_rule() -> None:
    neighbour = np.zeros((8, 2, 2))
    neighbour[::2, :, 1] = 0.1
    assert missed_px(chain(neighbour)) == pytest.approx(0.1)
    # A single line beside the others is none.
    neighbour[2:] = 0.0
    assert missed_px(chain(neighbour)) == 0.0


def test_few_lines_tell_nothing() -> None:
    neighbour = np.zeros((8, 2, 2))
    neighbour[::2, :, 1] = 0.1
    assert missed_px(chain(neighbour)[:6]) == 0.0
