"""Ellipses as strokes: what their parameters and lengths say about each other."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.views import Arc, Ellipse, Linetype

FULL = 2 * np.pi

ellipses = st.builds(
    lambda x, y, major, ratio, rotation, start, sweep: Ellipse(
        (x, y), major, ratio * major, rotation, start, sweep, Linetype.VISIBLE
    ),
    *[st.floats(-50.0, 50.0)] * 2,
    st.floats(1.0, 80.0),
    st.floats(0.05, 1.0),
    st.floats(-4.0, 4.0),
    st.floats(-7.0, 7.0),
    st.floats(0.05, FULL),
)


@given(ellipses)
def test_samples_are_even_and_lie_on_the_ellipse(ellipse: Ellipse) -> None:
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
    ends = ellipse.whole.at(np.array([ellipse.start, ellipse.start + ellipse.sweep]))
    assert points[[0, -1]] == pytest.approx(ends, abs=1e-9)


@given(ellipses, st.floats(0.0, 1.0))
def test_a_length_has_its_parameter(ellipse: Ellipse, share: float) -> None:
    parameter = float(ellipse.parameters(np.array([share * ellipse.length]))[0])
    assert -1e-6 <= parameter - ellipse.start <= ellipse.sweep + 1e-6
    before = Ellipse(
        ellipse.centre,
        ellipse.semi_major,
        ellipse.semi_minor,
        ellipse.rotation,
        ellipse.start,
        parameter - ellipse.start,
        ellipse.linetype,
    )
    assert before.length == pytest.approx(share * ellipse.length, abs=1e-6 * ellipse.semi_major)


@given(ellipses)
def test_extremes_span_the_stroke(ellipse: Ellipse) -> None:
    extremes, points = ellipse.extremes(), ellipse.sample(ellipse.length / 3000.0)
    slack = 1e-4 * ellipse.semi_major
    assert extremes.min(0) == pytest.approx(points.min(0), abs=slack)
    assert extremes.max(0) == pytest.approx(points.max(0), abs=slack)


def test_a_round_ellipse_is_the_circle() -> None:
    ellipse = Ellipse((3.0, 4.0), 5.0, 5.0, 0.7, 0.2, 1.5, Linetype.HIDDEN)
    arc = Arc((3.0, 4.0), 5.0, 0.9, 1.5, Linetype.HIDDEN)
    assert ellipse.length == pytest.approx(arc.length)
    assert ellipse.sample(0.1) == pytest.approx(arc.sample(0.1))
