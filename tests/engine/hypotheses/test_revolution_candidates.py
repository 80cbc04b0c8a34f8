"""Which bodies of revolution views speak of."""

import itertools
from collections.abc import Callable
from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.cells.surfaces_of_revolution import ArcProfile, LineProfile
from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.hypotheses.revolution_candidates import find_bodies
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment


def _chain(*points: tuple[float, float]) -> list[Segment]:
    return [Segment(a, b, Linetype.VISIBLE) for a, b in itertools.pairwise(points)]


def _frustum(low: float, high: float, height: float) -> DrawnViews:
    """An upright frustum of a cone with the radii ``low`` and ``high``."""
    wide = max(low, high)
    side = _chain(
        (wide - low, 0.0),
        (wide + low, 0.0),
        (wide + high, height),
        (wide - high, height),
        (wide - low, 0.0),
    )
    rounds = [Arc((wide, wide), r, 0.0, FULL_TURN, Linetype.VISIBLE) for r in (low, high)]
    strokes = {Role.FRONT: side, Role.RIGHT: side, Role.TOP: rounds}
    return exact_views(strokes, (2 * wide, 2 * wide, height))


@settings(max_examples=40)
@given(st.integers(4, 40), st.integers(4, 40), st.integers(5, 60))
def test_a_frustum_is_one_cone(low: int, high: int, height: int) -> None:
    if abs(low - high) < 2:
        return
    views = _frustum(float(low), float(high), float(height))
    carriers = find_carriers(views)
    (body,) = find_bodies(carriers)
    scale = carriers.scale
    assert (body.axis, body.sector) == (Axis.Z, None)
    assert body.centre == pytest.approx((max(low, high) * scale,) * 2, abs=1e-4)
    assert isinstance(body.profile, LineProfile)
    stated = (body.profile.low, body.profile.high, body.profile.at_low, body.profile.at_high)
    assert stated == pytest.approx((0.0, height * scale, low * scale, high * scale), abs=1e-3)


def test_a_slant_that_one_view_lacks_is_no_cone() -> None:
    views = _frustum(20.0, 10.0, 30.0)
    box = _chain((0, 0), (40, 0), (40, 30), (0, 30), (0, 0))
    strokes = {**views.strokes, Role.RIGHT: tuple(box)}
    assert find_bodies(find_carriers(exact_views(strokes, views.size))) == ()


def test_without_a_circle_there_is_no_axis() -> None:
    views = _frustum(20.0, 10.0, 30.0)
    box = tuple(_chain((0, 0), (40, 0), (40, 40), (0, 40), (0, 0)))
    strokes = {**views.strokes, Role.TOP: box}
    assert find_bodies(find_carriers(exact_views(strokes, views.size))) == ()


def test_arcs_as_far_from_another_circle_in_both_views_are_not_about_it() -> None:
    # A dome about (15, 15); a bore about (40, 40) would have a ring as far away in both views.
    outline = _chain((0, 0), (60, 0), (60, 20), (0, 20), (0, 0))
    dome = Arc((15.0, 0.0), 5.0, 0.0, pi, Linetype.HIDDEN)
    rounds = [
        Arc((at, at), radius, 0.0, FULL_TURN, Linetype.HIDDEN)
        for at, radius in ((15.0, 5.0), (40.0, 4.0))
    ]
    top = _chain((0, 0), (60, 0), (60, 60), (0, 60), (0, 0))
    strokes = {
        Role.FRONT: [*outline, dome],
        Role.RIGHT: [*outline, dome],
        Role.TOP: [*top, *rounds],
    }
    carriers = find_carriers(exact_views(strokes, (60.0, 60.0, 20.0)))
    (body,) = find_bodies(carriers)
    assert body.centre == pytest.approx((15.0 * carriers.scale,) * 2)


def _count(views: DrawnViews) -> tuple[int, int, int]:
    """Cones, whole spheres and tori, and sectors."""
    bodies = find_bodies(find_carriers(views))
    cones = sum(isinstance(body.profile, LineProfile) for body in bodies)
    arcs = [body for body in bodies if isinstance(body.profile, ArcProfile)]
    return cones, sum(b.sector is None for b in arcs), sum(b.sector is not None for b in arcs)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("stepped-block", (0, 0, 0)),
        ("counterbored-block", (0, 0, 0)),
        ("countersunk-plate", (2, 0, 0)),
        # A ball looks like a ball along all three axes.
        ("ball-knob", (0, 3, 0)),
        ("rounded-cover", (0, 0, 4)),
    ],
)
def test_sample_parts_have_the_bodies_that_they_have(
    name: str, expected: tuple[int, int, int], sample_views: Callable[[str], DrawnViews]
) -> None:
    assert _count(sample_views(name)) == expected


def test_one_view_is_enough_where_circles_are_drawn_at_both_ends_of_a_slant() -> None:
    views = _frustum(20.0, 10.0, 30.0)
    box = _chain((0, 0), (40, 0), (40, 30), (0, 30), (0, 0))
    strokes = {**views.strokes, Role.RIGHT: tuple(box)}
    carriers = find_carriers(exact_views(strokes, views.size))
    (body,) = find_bodies(carriers, lone=True)
    assert (body.axis, body.sector) == (Axis.Z, None)
    ends = (body.profile.at_low / carriers.scale, body.profile.at_high / carriers.scale)
    assert ends == pytest.approx((20.0, 10.0), abs=1e-3)


def test_a_slant_that_ends_at_one_circle_only_is_no_cone() -> None:
    views = _frustum(20.0, 10.0, 30.0)
    box = _chain((0, 0), (40, 0), (40, 30), (0, 30), (0, 0))
    rounds = views.strokes[Role.TOP][:1]
    strokes = {**views.strokes, Role.RIGHT: tuple(box), Role.TOP: rounds}
    assert find_bodies(find_carriers(exact_views(strokes, views.size)), lone=True) == ()


@pytest.mark.parametrize(("off", "bodies"), [(12.0, 1), (8.0, 0)])
def test_an_arc_that_crosses_the_axis_between_its_ends_is_no_profile(
    off: float, bodies: int
) -> None:
    side = _chain((0, 0), (60, 0), (60, 40), (0, 40), (0, 0))
    waist = Arc((30.0 + off, 20.0), 10.0, pi / 2, pi, Linetype.HIDDEN)
    top = _chain((0, 0), (60, 0), (60, 60), (0, 60), (0, 0))
    strokes = {
        Role.FRONT: [*side, waist],
        Role.RIGHT: [*side, waist],
        Role.TOP: [*top, Arc((30.0, 30.0), off, 0.0, FULL_TURN, Linetype.HIDDEN)],
    }
    found = find_bodies(find_carriers(exact_views(strokes, (60.0, 60.0, 40.0))))
    assert len(found) == bodies


def test_a_fillet_at_which_no_circle_is_drawn_goes_on_from_its_cone() -> None:
    """It passes into the cone and into the flange without an edge."""
    flange = _chain((50, 14), (60, 14), (60, 20), (0, 20), (0, 14), (10, 14))
    cone = _chain((14, 10), (20, 0), (40, 0), (46, 10))
    fillets = [
        Arc((50.0, 10.0), 4.0, pi / 2.0, pi / 2.0, Linetype.VISIBLE),
        Arc((10.0, 10.0), 4.0, 0.0, pi / 2.0, Linetype.VISIBLE),
    ]
    drawn = [*flange, *cone, *fillets]
    rounds = [Arc((30.0, 30.0), r, 0.0, FULL_TURN, Linetype.VISIBLE) for r in (10.0, 30.0)]
    strokes = {Role.FRONT: drawn, Role.RIGHT: drawn, Role.TOP: rounds}
    bodies = find_bodies(find_carriers(exact_views(strokes, (60.0, 60.0, 20.0))))
    below, fillet = sorted((body.profile for body in bodies), key=lambda item: item.low)
    scale = 100.0 / 60.0
    assert isinstance(below, LineProfile) and isinstance(fillet, ArcProfile)
    assert (below.low, below.high) == pytest.approx((0.0, 10.0 * scale), abs=1e-3)
    assert (fillet.low, fillet.high) == pytest.approx((10.0 * scale, 14.0 * scale), abs=1e-3)
    assert (fillet.r, fillet.side) == (pytest.approx(20.0 * scale, abs=1e-3), -1)
