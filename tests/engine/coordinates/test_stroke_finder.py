"""Which stroke runs through a place."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.stroke_finder import StrokeFinder
from gaussiancad_core.model.views import Arc, Linetype, Segment

_STROKES = [
    Segment((0.0, 0.0), (10.0, 0.0), Linetype.VISIBLE),
    Segment((0.0, 0.0), (0.0, 10.0), Linetype.HIDDEN),
    Arc((5.0, 5.0), 2.0, 0.0, 2.0 * np.pi, Linetype.VISIBLE),
    Segment((3.0, 3.0), (3.0, 3.0), Linetype.VISIBLE),
]


@given(st.floats(0.01, 0.99), st.sampled_from([0, 1, 2]))
def test_a_place_on_a_stroke_is_that_strokes(share: float, index: int) -> None:
    stroke = _STROKES[index]
    points = stroke.sample(stroke.length / 100.0)
    place = points[round(share * (len(points) - 1))]
    assert StrokeFinder(_STROKES).nearest(place, stroke.linetype) == index


def test_linetypes_are_apart() -> None:
    place = np.array([0.0, 5.0])
    assert StrokeFinder(_STROKES).nearest(place, Linetype.HIDDEN) == 1
    assert StrokeFinder(_STROKES).nearest(place, Linetype.VISIBLE) == 2


def test_there_may_be_none() -> None:
    assert StrokeFinder([]).nearest(np.zeros(2), Linetype.VISIBLE) is None
    assert StrokeFinder(_STROKES[:1]).nearest(np.zeros(2), Linetype.HIDDEN) is None
