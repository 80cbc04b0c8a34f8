"""Pieces of curves, and strokes, which are such pieces with a linetype."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment

number = st.floats(-50.0, 50.0)
point = st.tuples(number, number)
segments = st.builds(LineSegment, point, point)
arcs = st.builds(
    CircularArc, point, st.floats(0.5, 40.0), st.floats(-7.0, 7.0), st.floats(0.01, FULL_TURN)
)
ellipses = st.builds(
    lambda centre, major, ratio, *turns: EllipticArc(centre, major, ratio * major, *turns),
    point,
    st.floats(0.5, 40.0),
    st.floats(0.05, 1.0),
    st.floats(-4.0, 4.0),
    st.floats(-7.0, 7.0),
    st.floats(0.1, FULL_TURN),
)
ZIGZAG = Chain(((0.0, 0.0), (3.0, 4.0), (3.0, 10.0), (9.0, 2.0)))
SQUARE = Chain(((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)))
similarities = st.builds(
    Similarity, st.floats(0.1, 20.0), st.floats(-3.0, 3.0), st.booleans(), point, point
)
curves = st.one_of(segments, arcs, ellipses, st.just(ZIGZAG), st.just(SQUARE))


@pytest.mark.parametrize(
    ("curve", "length"),
    [
        (LineSegment((0, 0), (30, 40)), 50.0),
        (CircularArc((5, 5), 10, 1.0, 2.0), 20.0),
        (EllipticArc((5, 5), 10, 10, 0.9, 1.0, 2.0), 20.0),
        (Chain(((0, 0), (3, 4), (3, 14))), 15.0),
    ],
)
def test_samples_and_vertices_follow_the_curve(curve: Curve, length: float) -> None:
    assert curve.length == pytest.approx(length)
    for points in (curve.sample(0.5), curve.vertices(0.5)):
        steps = np.hypot(*np.diff(points, axis=0).T)
        assert steps.max() <= 0.5 + 1e-9
        assert steps.sum() == pytest.approx(length, rel=1e-3)


@given(ellipses)
def test_samples_of_an_ellipse_are_even_and_lie_on_it(ellipse: EllipticArc) -> None:
    points = ellipse.sample(ellipse.length / 500.0)
    steps = np.hypot(*np.diff(points, axis=0).T)
    assert steps.sum() == pytest.approx(ellipse.length, rel=1e-3)
    # A chord is shorter than its arc at a thin ellipse's ends alone.
    assert steps.max() <= ellipse.length / 500.0 * (1 + 1e-6)
    assert np.median(steps) == pytest.approx(steps.mean(), rel=1e-3)
    offset = points - np.array(ellipse.centre)
    major = np.array([np.cos(ellipse.rotation), np.sin(ellipse.rotation)])
    u = offset @ major / ellipse.semi_major
    v = offset @ np.array([-major[1], major[0]]) / ellipse.semi_minor
    assert u**2 + v**2 == pytest.approx(1.0, abs=1e-9)
    ends = ellipse.carrier.at(np.array([ellipse.start, ellipse.start + ellipse.sweep]))
    assert points[[0, -1]] == pytest.approx(ends, abs=1e-9)
    assert ellipse.vertices(ellipse.length)[[0, -1]] == pytest.approx(ends, abs=1e-9)


@given(st.one_of(arcs, ellipses, st.just(ZIGZAG)))
def test_a_box_holds_the_samples_and_touches_them(curve: Curve) -> None:
    samples = curve.vertices(curve.length / 3000.0)
    low, high = np.array(curve.box).reshape(2, 2)
    slack = 1e-4 * np.ptp(samples, axis=0).max()
    np.testing.assert_allclose(low, samples.min(axis=0), atol=slack)
    np.testing.assert_allclose(high, samples.max(axis=0), atol=slack)
    assert np.all(low <= samples.min(axis=0) + 1e-9)
    assert np.all(high >= samples.max(axis=0) - 1e-9)


@given(curves, similarities)
def test_the_image_of_a_curve_has_the_images_of_its_points(curve: Curve, by: Similarity) -> None:
    image = curve.mapped(by)
    assert image.length == pytest.approx(by.scale * curve.length)
    cosine, sine = np.cos(by.angle), np.sin(by.angle)
    points = (curve.vertices(np.inf) - by.origin) * (1.0, -1.0 if by.flip else 1.0)
    expected = by.offset + by.scale * points @ np.array([[cosine, sine], [-sine, cosine]])
    if by.flip and isinstance(curve, CircularArc | EllipticArc):
        expected = expected[::-1]
    np.testing.assert_allclose(image.vertices(np.inf), expected, atol=1e-7 * by.scale)


@given(st.one_of(arcs, ellipses, st.just(ZIGZAG)), st.floats(0.0, 0.45), st.floats(0.55, 1.0))
def test_a_part_has_its_length_and_its_ends(curve: Curve, low: float, high: float) -> None:
    cut = curve.part(low * curve.length, high * curve.length)
    assert cut.length == pytest.approx((high - low) * curve.length)
    ends = curve.points_at(np.array([low, high]) * curve.length)
    np.testing.assert_allclose(cut.vertices(np.inf)[[0, -1]], ends, atol=1e-6 * curve.length)


def test_parts_of_open_curves_may_be_prolonged() -> None:
    prolonged = ZIGZAG.part(-2.5, ZIGZAG.length + 5.0)
    np.testing.assert_allclose(prolonged.points[0], (-1.5, -2.0))
    np.testing.assert_allclose(prolonged.points[-1], (12.0, -2.0))
    assert LineSegment((0.0, 0.0), (2.0, 0.0)).part(-1.0, 3.0) == LineSegment(
        (-1.0, 0.0), (3.0, 0.0)
    )


def test_parts_of_closed_chains_may_go_over_the_start() -> None:
    corner = SQUARE.part(-2.0, 1.0)
    np.testing.assert_allclose(corner.points, [(0.0, 2.0), (0.0, 0.0), (1.0, 0.0)], atol=1e-12)


@given(st.one_of(segments, arcs, ellipses, st.just(ZIGZAG)), point)
def test_distances_are_those_of_the_nearest_place(curve: Curve, probe: tuple) -> None:
    points = np.array([probe])
    step = max(curve.length, 1e-3) / 2000.0
    nearest = np.hypot(*(curve.vertices(step) - points).T).min()
    assert curve.distances(points)[0] == pytest.approx(nearest, abs=step)


@given(st.one_of(arcs, ellipses, st.just(SQUARE)))
def test_points_at_lengths_are_evenly_spaced(curve: Curve) -> None:
    points = curve.points_at(np.linspace(0.0, curve.length, 1001))
    steps = np.hypot(*np.diff(points, axis=0).T)
    np.testing.assert_allclose(steps, curve.length / 1000.0, rtol=5e-2)


@pytest.mark.parametrize(
    "stroke",
    [
        Segment((0.0, 0.0), (3.0, 4.0), Linetype.HIDDEN, 0.5),
        Arc((0.0, 0.0), 1.0, 0.0, 1.0, Linetype.HIDDEN, 0.5),
        Ellipse((0.0, 0.0), 2.0, 1.0, 0.0, 0.0, 1.0, Linetype.HIDDEN, 0.5),
        Polyline(ZIGZAG.points, Linetype.HIDDEN, 0.5),
    ],
)
def test_strokes_keep_how_they_are_drawn(stroke: Segment | Arc | Ellipse | Polyline) -> None:
    for made in (stroke.part(0.1, 0.2), stroke.mapped(Similarity(2.0, 0.3, flip=True))):
        assert type(made) is type(stroke)
        assert (made.linetype, made.confidence) == (Linetype.HIDDEN, 0.5)


def test_a_circle_that_was_read_may_have_a_gap() -> None:
    assert Arc((0.0, 0.0), 1.0, 0.3, 6.25, Linetype.VISIBLE).is_full
    assert not Arc((0.0, 0.0), 1.0, 0.3, 6.0, Linetype.VISIBLE).is_full
