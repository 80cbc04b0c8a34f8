"""What is drawn twice is taken once."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.files.duplicates import distinct_strokes
from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN

CURVES: list[Curve] = [
    LineSegment((10.0, 10.0), (200.0, 40.0)),
    CircularArc((100.0, 100.0), 30.0, 0.3, 1.7),
    CircularArc((100.0, 100.0), 30.0, 0.0, FULL_TURN),
    EllipticArc((150.0, 90.0), 41.0, 20.5, 0.25, 0.2, 2.0),
    Chain(((0.0, 0.0), (5.0, 9.0), (20.0, 12.0), (31.0, 40.0))),
]


@pytest.mark.parametrize("curve", CURVES)
def test_a_curve_that_is_drawn_again_is_one(curve: Curve) -> None:
    vector_stroke = VectorStroke(curve, 2.0, layer="A")
    assert distinct_strokes([vector_stroke, vector_stroke, vector_stroke]) == (vector_stroke,)
    wider = replace(vector_stroke, width=3.0)
    assert distinct_strokes([vector_stroke, wider]) == (wider,)


def test_a_line_that_is_drawn_back_is_one() -> None:
    there = VectorStroke(LineSegment((10.0, 10.0), (200.0, 40.0)), None)
    back = VectorStroke(LineSegment((200.004, 40.0), (10.0, 9.996)), None)
    assert distinct_strokes([there, back]) == (there,)


@pytest.mark.parametrize(
    "other",
    [
        {"layer": "B"},
        {"role": StrokeRole.HIDDEN},
        {"kind": StrokeKind.DIMENSION},
        {"colour": (255, 0, 0)},
        {"dashes": (5.0, 3.0)},
        {"curve": LineSegment((10.0, 10.1), (200.0, 40.0))},
        {"curve": LineSegment((10.0, 10.0), (150.0, 32.1))},
    ],
)
def test_what_differs_stays(other: dict[str, object]) -> None:
    vector_stroke = VectorStroke(CURVES[0], 2.0, layer="A")
    pair = vector_stroke, replace(vector_stroke, **other)
    assert distinct_strokes(pair) == pair


@pytest.mark.parametrize("waves", [1, 2, 4, 8])
def test_free_curves_with_the_same_ends_middle_and_length_are_told_apart(waves: int) -> None:
    x = np.linspace(0.0, 200.0, 161)
    y = 20.0 * np.sin(waves * FULL_TURN * x / 200.0)
    pair = tuple(
        VectorStroke(Chain(tuple(zip(x.tolist(), (100.0 + item).tolist(), strict=True))), None)
        for item in (y, -y)
    )
    assert distinct_strokes(pair) == pair


def test_a_free_curve_that_is_drawn_back_is_one() -> None:
    points = ((0.0, 0.0), (5.0, 9.0), (20.0, 12.0), (31.0, 40.0))
    there, back = (VectorStroke(Chain(item), None) for item in (points, points[::-1]))
    assert distinct_strokes([there, back]) == (there,)


_HALVES = [CircularArc((50.0, 50.0), 20.0, start, np.pi) for start in (0.0, np.pi)]
_FLAT, _OTHER = ((20.0, 0.0), (24.0, 0.0)), ((20.0, 0.3), (20.0, -0.3))


@pytest.mark.parametrize(
    "curves",
    [
        _HALVES,
        *(
            [EllipticArc((150.0, 90.0), 40.0, minor, tilt, 0.0, FULL_TURN) for minor, tilt in pair]
            for pair in (_FLAT, _OTHER)
        ),
    ],
)
def test_arcs_and_ellipses_with_the_same_ends_are_told_apart(curves: list) -> None:
    pair = tuple(VectorStroke(curve, None) for curve in curves)
    assert distinct_strokes(pair) == pair


@given(
    st.lists(
        st.tuples(*[st.integers(0, 9)] * 4).filter(lambda item: item[:2] != item[2:]), max_size=20
    )
)
def test_each_line_is_there_once_in_the_files_order(ends: list[tuple[int, int, int, int]]) -> None:
    strokes = [VectorStroke(LineSegment((a, b), (c, d)), None) for a, b, c, d in ends]
    seen, first = set(), []
    for stroke, (a, b, c, d) in zip(strokes, ends, strict=True):
        key = frozenset(((a, b), (c, d)))
        if key not in seen:
            seen.add(key)
            first.append(stroke)
    assert distinct_strokes(strokes) == tuple(first)
