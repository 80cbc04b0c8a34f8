"""Strokes that follow the curve in which two surfaces meet are told, and led onto it."""

from collections.abc import Callable
from dataclasses import replace
from math import asin, hypot, pi, sqrt

import numpy as np
import pytest

from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.hypotheses.intersection_curves import with_followed_curves
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

Views = Callable[[str], DrawnViews]

_VISIBLE = Linetype.VISIBLE

_PIXEL = 0.1
"""mm, the tolerance of views that are read from a picture."""


def test_arcs_that_follow_a_curve_of_two_cylinders_become_that_curve(
    pin_as_read: DrawnViews,
) -> None:
    views = pin_as_read
    followed = with_followed_curves(views, find_carriers(views))
    assert followed is not None
    *others, low, high = followed.strokes[Role.FRONT]
    assert others == list(views.strokes[Role.FRONT][:-2])
    assert followed.strokes[Role.RIGHT] == views.strokes[Role.RIGHT]
    for curve, way in ((low, 1.0), (high, -1.0)):
        assert isinstance(curve, Polyline) and curve.linetype is Linetype.VISIBLE
        x, z = np.array(curve.points).T
        rise = 22.0 - np.sqrt(22.0**2 - 12.0**2 + (x - 30.0) ** 2)
        assert way * (z - 22.0) + 22.0 == pytest.approx(rise, abs=1e-4)
        # It ends where the surfaces do, not where the arc was read to.
        assert sorted((x[0], x[-1])) == pytest.approx([18.0, 42.0], abs=0.5)
        assert np.abs(x - 30.0).max() <= 12.0 + 1e-9


@pytest.mark.parametrize("name", ["wedge-block", "filleted-block", "dovetail-block", "ball-knob"])
def test_traces_of_planes_cylinders_and_bodies_stay(name: str, sample_views: Views) -> None:
    views = replace(sample_views(name), tolerance=_PIXEL)
    followed = with_followed_curves(views, find_carriers(views))
    for role, this_stroke in (followed or views).strokes.items():
        for stroke, drawn in zip(this_stroke, views.strokes[role], strict=True):
            assert stroke == drawn or not isinstance(drawn, Segment | Arc)


def test_a_straight_stroke_along_a_bent_curve_is_none_of_a_plane(pin_as_read: DrawnViews) -> None:
    views = pin_as_read
    start, middle = (18.6, 22.0 - sqrt(340.0 + 11.4**2)), (24.0, 22.0 - sqrt(340.0 + 6.0**2))
    chord = Segment(start, middle, Linetype.VISIBLE)
    front = (*views.strokes[Role.FRONT][:-2], chord)
    views = replace(views, strokes={**views.strokes, Role.FRONT: front})
    followed = with_followed_curves(views, find_carriers(views))
    assert followed is not None
    curve = followed.strokes[Role.FRONT][-1]
    assert isinstance(curve, Polyline)
    a, b = curve.points[len(curve.points) // 2]
    assert b == pytest.approx(22.0 - sqrt(340.0 + (a - 30.0) ** 2), abs=1e-4)
    assert hypot(a - 21.3, b - 1.58) < 0.3


def test_a_stroke_along_which_nothing_is_met_stays(pin_as_read: DrawnViews) -> None:
    """Where all else is free-form, no other view has a line or circle there."""
    views = pin_as_read
    front = (*views.strokes[Role.FRONT], Arc((200.0, 200.0), 5.0, 0.2, 1.0, Linetype.VISIBLE))
    lone = replace(views, strokes={**views.strokes, Role.FRONT: front})
    followed = with_followed_curves(lone, find_carriers(views))
    assert followed is not None
    assert followed.strokes[Role.FRONT][-1] == front[-1]


def _saddle() -> DrawnViews:
    """A rod of radius 12 that stood on one of radius 20, along x, its foot read as two arcs."""
    low = 20.0 - sqrt(20.0**2 - 12.0**2)
    box = [((0.0, low), (0.0, 40.0)), ((0.0, 40.0), (24.0, 40.0)), ((24.0, 40.0), (24.0, low))]
    feet = (
        Arc((14.5, 26.0), 26.3, 4.128, 0.45, _VISIBLE),
        Arc((9.5, 26.0), 26.3, 4.845, 0.45, _VISIBLE),
    )
    front = [*(Segment(a, b, _VISIBLE) for a, b in box), *feet]
    front.append(Segment((0.0, low), (24.0, low), Linetype.HIDDEN))
    walls = [((0.0, 0.0), (0.0, 40.0)), ((0.0, 40.0), (24.0, 40.0)), ((24.0, 40.0), (24.0, 0.0))]
    half = asin(12.0 / 20.0)
    arch = Arc((12.0, low - 20.0), 20.0, pi / 2.0 - half, 2.0 * half, _VISIBLE)
    right = [*(Segment(a, b, _VISIBLE) for a, b in walls), arch]
    rod = Arc((12.0, 12.0), 12.0, 0.0, 2.0 * pi, _VISIBLE)
    strokes = {Role.FRONT: tuple(front), Role.TOP: (rod,), Role.RIGHT: tuple(right)}
    return DrawnViews(strokes, (24.0, 24.0, 40.0), 0.06, 0.02)


def test_an_arc_whose_outline_another_view_draws_is_a_cylinders() -> None:
    """Either the arch is a cylinder and the feet follow the curve, or the other way round."""
    views = _saddle()
    followed = with_followed_curves(views, find_carriers(views))
    assert followed is not None
    assert followed.strokes[Role.RIGHT] == views.strokes[Role.RIGHT]
    feet = followed.strokes[Role.FRONT][3:5]
    for foot in feet:
        assert isinstance(foot, Polyline)
        x, z = np.array(foot.points).T
        depth = np.sqrt(12.0**2 - (x - 12.0) ** 2)
        assert z == pytest.approx(np.sqrt(20.0**2 - depth**2) - 16.0, abs=1e-3)


def test_a_curve_reaches_as_far_as_both_surfaces(pin_as_read: DrawnViews) -> None:
    followed = with_followed_curves(pin_as_read, find_carriers(pin_as_read))
    assert followed is not None
    for curve in followed.strokes[Role.FRONT][-2:]:
        assert isinstance(curve, Polyline)
        ends = sorted((curve.points[0][0], curve.points[-1][0]))
        # A link of the curve is four times as long.
        assert ends == pytest.approx([18.0, 42.0], abs=0.06)
