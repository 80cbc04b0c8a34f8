import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.lines.strokes import (
    Polyline,
    as_chain,
    as_plain_strokes,
    extent,
    is_closed,
    mapped,
    part,
    turned,
)
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


def test_a_chain_knows_its_length_and_samples_itself_evenly() -> None:
    assert ZIGZAG.length == pytest.approx(5.0 + 6.0 + 10.0)
    samples = ZIGZAG.sample(0.5)
    assert len(samples) == 43
    np.testing.assert_allclose(samples[[0, -1]], [(0.0, 0.0), (9.0, 2.0)])
    assert np.hypot(*np.diff(samples, axis=0).T).max() <= 0.5 + 1e-12


def test_plain_strokes_are_the_chords() -> None:
    arc = Arc((0.0, 0.0), 1.0, 0.0, 1.0, VISIBLE)
    plain = as_plain_strokes((arc, ZIGZAG))
    assert plain[0] is arc
    assert [stroke.start for stroke in plain[1:]] == list(ZIGZAG.points[:-1])
    assert {stroke.linetype for stroke in plain[1:]} == {HIDDEN}


@given(ellipses)
def test_the_chain_along_an_ellipse_is_that_ellipse(ellipse: Ellipse) -> None:
    chain = as_chain(ellipse, 1e-4 * ellipse.semi_major)
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


@given(arcs)
def test_the_extent_of_an_arc_is_that_of_its_points(arc: Arc) -> None:
    samples = arc.sample(arc.radius / 200.0)
    low, high = extent((arc,))
    np.testing.assert_allclose(low, samples.min(axis=0), atol=arc.radius * 2e-5)
    np.testing.assert_allclose(high, samples.max(axis=0), atol=arc.radius * 2e-5)
    assert np.all(low <= samples.min(axis=0) + 1e-9)
    assert np.all(high >= samples.max(axis=0) - 1e-9)


@given(
    st.one_of(segments, arcs, ellipses, st.just(ZIGZAG)),
    st.floats(0.1, 20.0),
    point,
    st.booleans(),
)
def test_mapping_a_stroke_maps_its_points(
    stroke: Segment | Arc, scale: float, offset: tuple[float, float], flip: bool
) -> None:
    image = mapped(stroke, scale, offset, flip)
    assert image.length == pytest.approx(scale * stroke.length)
    assert image.linetype is stroke.linetype
    expected = stroke.sample(1.0) * (scale, -scale if flip else scale) + np.array(offset)
    found = image.sample(scale * 1.0)
    if flip and isinstance(stroke, Arc | Ellipse):
        expected = expected[::-1]
    if len(found) == len(expected):
        np.testing.assert_allclose(found, expected, atol=1e-9 * scale * 100)


@given(st.one_of(segments, arcs, ellipses), st.floats(-3.0, 3.0), point)
def test_turning_there_and_back_changes_nothing(
    stroke: Segment | Arc, angle: float, centre: tuple[float, float]
) -> None:
    back = turned(turned(stroke, angle, centre), -angle, centre)
    # A whole number of steps could come out as one more by the last digit of the length.
    step = max(stroke.length, 1e-3) / 7.5
    np.testing.assert_allclose(back.sample(step), stroke.sample(step), atol=1e-9)


@given(st.one_of(arcs, ellipses, st.just(ZIGZAG)), st.floats(0.0, 0.45), st.floats(0.55, 1.0))
def test_a_part_has_its_length_and_its_ends(stroke: Arc, low: float, high: float) -> None:
    cut = part(stroke, low * stroke.length, high * stroke.length)
    assert cut.length == pytest.approx((high - low) * stroke.length)
    dense = stroke.sample(stroke.length / 2000.0)
    for share, end in ((low, 0), (high, -1)):
        np.testing.assert_allclose(
            cut.sample(1.0)[end], dense[round(share * 2000)], atol=stroke.length / 1000.0
        )


def test_parts_of_open_strokes_may_be_prolonged() -> None:
    prolonged = part(ZIGZAG, -2.5, ZIGZAG.length + 5.0)
    np.testing.assert_allclose(prolonged.points[0], (-1.5, -2.0))
    np.testing.assert_allclose(prolonged.points[-1], (12.0, -2.0))
    segment = part(Segment((0.0, 0.0), (2.0, 0.0), VISIBLE), -1.0, 3.0)
    assert (segment.start, segment.end) == ((-1.0, 0.0), (3.0, 0.0))


def test_parts_of_closed_chains_may_go_over_the_start() -> None:
    corner = part(SQUARE, -2.0, 1.0)
    np.testing.assert_allclose(corner.points, [(0.0, 2.0), (0.0, 0.0), (1.0, 0.0)], atol=1e-12)


def test_closed_strokes_are_known() -> None:
    assert is_closed(SQUARE)
    assert is_closed(Arc((0.0, 0.0), 1.0, 0.3, TURN, VISIBLE))
    assert not is_closed(ZIGZAG)
    assert not is_closed(Arc((0.0, 0.0), 1.0, 0.3, 6.0, VISIBLE))
