import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.lines.coverage import StrokeIndex
from gaussiancad_core.lines.stroke_meetings import junctions
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment

V = Linetype.VISIBLE
number = st.floats(-20.0, 20.0)
point = st.tuples(number, number)
segments = (
    st.tuples(point, point)
    .filter(lambda ends: np.hypot(*np.subtract(*ends)) > 1.0)
    .map(lambda ends: Segment(*ends, V))
)
arcs = st.builds(
    Arc, point, st.floats(2.0, 20.0), st.floats(0.0, 6.28), st.floats(0.5, 2 * np.pi), st.just(V)
)
chains = st.lists(
    st.tuples(st.integers(-20, 20), st.integers(-20, 20)), min_size=3, max_size=6, unique=True
).map(lambda points: Polyline(tuple(points), V))
strokes = st.one_of(segments, arcs, chains)


def _at(stroke: DrawnStroke, other: DrawnStroke) -> list[float]:
    return junctions(stroke, StrokeIndex([stroke, other]), 1e-6).tolist()


@given(strokes, strokes)
def test_junctions_lie_on_both_strokes_and_are_found_from_both_sides(
    one: DrawnStroke, other: DrawnStroke
) -> None:
    for first, second in ((one, other), (other, one)):
        at = junctions(first, StrokeIndex([first, second]), 1e-6)
        assert np.all(at[1:] > at[:-1])
        if len(at):
            inside = np.clip(at, 0.0, first.length)
            assert second.distances(first.points_at(inside)).max() < 1e-4


@given(segments, strokes)
def test_no_proper_crossing_is_missed(one: Segment, other: DrawnStroke) -> None:
    samples = other.sample(0.02)
    way = np.subtract(one.end, one.start) / one.length
    across = (samples - one.start) @ [-way[1], way[0]]
    along = (samples - one.start) @ way
    change = np.flatnonzero(across[:-1] * across[1:] < 0.0)
    found = np.array(_at(one, other))
    for index in change:
        at = along[index]
        if 0.05 < at < one.length - 0.05 and abs(across[index] - across[index + 1]) > 1e-3:
            assert len(found)
            assert np.abs(found - at).min() < 0.05


def test_positions_are_exact() -> None:
    line = Segment((0.0, 0.0), (10.0, 0.0), V)
    assert _at(line, Segment((3.0, -1.0), (3.0, 5.0), V)) == pytest.approx([3.0])
    assert _at(line, Arc((5.0, 0.0), 2.0, 0.0, 2 * np.pi, V)) == pytest.approx([3.0, 7.0])
    assert _at(line, Arc((5.0, 0.0), 2.0, 0.1, 1.0, V)) == []
    circle = Arc((0.0, 0.0), 5.0, 0.0, 2 * np.pi, V)
    assert _at(circle, Arc((6.0, 0.0), 5.0, 0.0, 2 * np.pi, V)) == pytest.approx(
        [5 * np.arccos(0.6), 5 * (2 * np.pi - np.arccos(0.6))]
    )


def test_touching_ends_and_tangents_count_and_parallels_do_not() -> None:
    line = Segment((0.0, 0.0), (10.0, 0.0), V)
    assert _at(line, Segment((4.0, 0.0), (4.0, 3.0), V)) == pytest.approx([4.0])
    assert _at(line, Arc((5.0, 2.0), 2.0, 0.0, 2 * np.pi, V)) == pytest.approx([5.0], abs=1e-3)
    assert _at(line, Segment((2.0, 0.0), (8.0, 0.0), V)) == []
    assert _at(line, Segment((2.0, 1.0), (8.0, 1.0), V)) == []
