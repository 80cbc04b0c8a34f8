import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.lines.strokes import Polyline, as_plain_strokes
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment

VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
TURN = 2.0 * np.pi
number = st.floats(-50.0, 50.0)
point = st.tuples(number, number)
segments = st.tuples(point, point).map(lambda ends: Segment(*ends, VISIBLE))
arcs = st.builds(
    Arc, point, st.floats(0.5, 40.0), st.floats(0.0, 6.28), st.floats(0.01, TURN), st.just(HIDDEN)
)
ellipses = st.builds(
    lambda centre, major, ratio, *turns: Ellipse(centre, major, ratio * major, *turns, HIDDEN),
    point,
    st.floats(0.5, 40.0),
    st.floats(0.1, 1.0),
    st.floats(-3.0, 3.0),
    st.floats(0.0, 6.28),
    st.floats(0.1, TURN),
)
ZIGZAG = Polyline(((0.0, 0.0), (3.0, 4.0), (3.0, 10.0), (9.0, 2.0)), HIDDEN)
SQUARE = Polyline(((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)), VISIBLE)


def test_plain_strokes_are_the_chords() -> None:
    arc = Arc((0.0, 0.0), 1.0, 0.0, 1.0, VISIBLE)
    plain = as_plain_strokes((arc, ZIGZAG))
    assert plain[0] is arc
    assert [stroke.start for stroke in plain[1:]] == list(ZIGZAG.points[:-1])
    assert {stroke.linetype for stroke in plain[1:]} == {HIDDEN}


@given(ellipses)
def test_the_chain_along_an_ellipse_is_that_ellipse(ellipse: Ellipse) -> None:
    points = ellipse.chords(1e-4 * ellipse.semi_major)
    chain = Polyline(tuple(map(tuple, points.tolist())), ellipse.linetype)
    assert chain.length == pytest.approx(ellipse.length, rel=2e-3)
    plain = as_plain_strokes((chain,))
    # Of a short piece, or a nearly round one, other curves may be told as well.
    if ellipse.sweep > 1.5:
        (found,) = plain
        assert isinstance(found, Ellipse)
        assert found.linetype is HIDDEN
        ends, known = ellipse.sample(1e9)[[0, -1]], found.sample(1e9)[[0, -1]]
        away = min(np.abs(ends - known).max(), np.abs(ends - known[::-1]).max())
        assert away < 1e-6 * ellipse.semi_major
        assert found.length == pytest.approx(ellipse.length, rel=1e-6)
