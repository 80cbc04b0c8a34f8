"""Groups of strokes that touch, compared with a look at each by itself."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.graph.stroke_groups import EVEN, grouped, within
from gaussiancad_core.sheet.graph.touching_ends import touching

_PLACES = st.tuples(st.integers(0, 6), st.integers(0, 6))


@given(
    st.lists(st.tuples(_PLACES, _PLACES, st.booleans()).filter(lambda item: item[0] != item[1])),
    st.integers(0, 2**32 - 1),
)
def test_what_holds_of_a_group_is_that_of_its_strokes(
    lines: list[tuple[tuple[int, int], tuple[int, int], bool]], seed: int
) -> None:
    touches = touching([LineSegment(a, b) for a, b, _ in lines], 0.1)
    chosen = np.array([item for _, _, item in lines], dtype=bool)
    values = np.random.default_rng(seed).uniform(size=(len(lines), 2))
    groups = grouped(touches, chosen)
    labels = touches.groups(chosen)
    numbers = np.unique(labels[chosen])
    assert len(groups.counts) == len(numbers)
    for place, number in enumerate(numbers):
        entry = labels == number
        boxes = touches.boxes[entry]
        assert groups.members(place).tolist() == np.flatnonzero(entry).tolist()
        assert groups.counts[place] == entry.sum()
        around = [*boxes[:, :2].min(axis=0), *boxes[:, 2:].max(axis=0)]
        assert groups.boxes[place].tolist() == around
        assert np.isclose(groups.means(values[:, 0])[place], values[entry, 0].mean())
        assert groups.most(values)[place].tolist() == values[entry].max(axis=0).tolist()


def test_a_wide_line_may_reach_over_the_box_that_it_lies_within() -> None:
    around = np.array([0.0, 0.0, 100.0, 50.0])
    boxes = np.array(
        [(0.0, 0.0, 100.0 + EVEN, 50.0), (0.0, 0.0, 100.1 + EVEN, 50.0), (-EVEN, 9.0, 9.0, 9.0)]
    )
    assert within(boxes, around).tolist() == [True, False, True]
