"""Strokes become lines and circles with drawn stretches."""

import itertools
from collections.abc import Callable
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.carriers import PlaneCarriers, find_carriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval, merged_intervals
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import UNITS
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment

_VISIBLE, _HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
_SIZE = (50.0, 30.0, 20.0)
_SCALE = UNITS / 50.0

Point = tuple[float, float]


def _chain(*points: Point, linetype: Linetype = _VISIBLE) -> list[Segment]:
    return [Segment(a, b, linetype) for a, b in itertools.pairwise(points)]


def _box(width: float, height: float) -> list[Segment]:
    return _chain((0, 0), (width, 0), (width, height), (0, height), (0, 0))


def _front(strokes: list[DrawnStroke], tolerance: float | None = None) -> PlaneCarriers:
    views = exact_views({Role.FRONT: strokes}, _SIZE)
    if tolerance:
        views = DrawnViews(views.strokes, _SIZE, tolerance)
    return find_carriers(views).planes[Axis.Y]


_INTERVAL = st.tuples(st.integers(0, 60), st.integers(1, 20)).map(lambda p: (p[0], p[0] + p[1]))


@given(st.lists(_INTERVAL, max_size=10), st.sampled_from([0.0, 0.5, 2.5]))
def test_merged_stretches_cover_the_same_and_lie_apart(
    stretches: list[tuple[int, int]], slack: float
) -> None:
    merged = merged_intervals(stretches, slack)
    assert all(low[1] + slack < high[0] for low, high in itertools.pairwise(merged))
    for at in np.arange(-0.75, 82.0, 0.5):
        inside = any(low < at < high for low, high in merged)
        drawn = any(low < at < high for low, high in stretches)
        gap = any(
            0 <= high[0] - low[1] <= slack and low[1] <= at <= high[0]
            for low in stretches
            for high in stretches
        )
        assert drawn <= inside <= (drawn or gap or slack > 1)


def test_a_rectangle_is_four_supports_drawn_from_corner_to_corner() -> None:
    plane = _front(_box(50, 20))
    assert (plane.normal, plane.roles, plane.chains) == (Axis.Y, (Role.FRONT,), ())
    ends = {
        frozenset((round(a, 9), round(b, 9)) for a, b in (s.curve.at(low), s.curve.at(high)))
        for s in plane.carriers
        for low, high in s.drawn()
    }
    corners = [(0.0, 0.0), (100.0, 0.0), (100.0, 40.0), (0.0, 40.0)]
    assert ends == {frozenset((corners[k - 1], corners[k])) for k in range(4)}


@pytest.mark.parametrize(("tolerance", "tells"), [(None, True), (0.05, True), (0.1, False)])
def test_a_slant_of_a_few_pixels_is_a_line(tolerance: float | None, tells: bool) -> None:
    """A chamfer of 1 mm on a shaft of 300 mm is a third of a unit long, as exact as any line."""
    cut = _chain((0, 0), (50, 0), (50, 20), (0.12, 20), (0, 19.88), (0, 0))
    plane = _front(cut, tolerance)
    slants = [s for s in plane.carriers if s.curve.axis is None]
    assert (len(slants), len(plane.chains)) == ((1, 0) if tells else (0, 1))


@given(st.permutations(range(5)), st.lists(st.booleans(), min_size=5, max_size=5))
def test_collinear_strokes_are_one_support_in_any_order(
    order: list[int], flips: list[bool]
) -> None:
    at = [0.0, 12.0, 20.0, 31.0, 44.0, 50.0]
    pieces = []
    for k in order:
        ends = [(at[k], 20.0), (at[k + 1], 20.0)]
        pieces += _chain(*(reversed(ends) if flips[k] else ends))
    plane = _front([*_box(50, 20)[:2], *pieces, *_box(50, 20)[3:]])
    assert len(plane.carriers) == 4
    (top,) = (s for s in plane.carriers if s.curve == Line((0.0, 40.0), (1.0, 0.0)))
    assert top.drawn() == [(0.0, pytest.approx(100.0))]


def test_visible_lines_cover_hidden_ones_and_gaps_are_blank() -> None:
    intervals = (Interval(0.0, 30.0, _HIDDEN, 1.0), Interval(20.0, 50.0, _VISIBLE, 1.0))
    carrier = Carrier(Line((0.0, 0.0), (1.0, 0.0)), {Role.FRONT: intervals})
    linetypes = [carrier.linetype_at(Role.FRONT, at) for at in (10.0, 25.0, 40.0, 60.0)]
    assert linetypes == [_HIDDEN, _VISIBLE, _VISIBLE, None]
    assert carrier.linetype_at(Role.REAR, 25.0) is None
    assert carrier.drawn() == [(0.0, 50.0)]


def test_a_dashed_line_behind_a_visible_one_is_one_support() -> None:
    hidden = Segment((0.0, 8.0), (50.0, 8.0), _HIDDEN)
    visible = Segment((10.0, 8.0), (20.0, 8.0), _VISIBLE)
    plane = _front([*_box(50, 20), hidden, visible])
    (carrier,) = (s for s in plane.carriers if s.curve == Line((0.0, 16.0), (1.0, 0.0)))
    linetypes = [carrier.linetype_at(Role.FRONT, at) for at in (10.0, 30.0, 60.0)]
    assert linetypes == [_HIDDEN, _VISIBLE, _HIDDEN]


_OPPOSITE = [(Role.FRONT, Role.REAR), (Role.RIGHT, Role.LEFT), (Role.TOP, Role.BOTTOM)]


@pytest.mark.parametrize(("role", "opposite"), _OPPOSITE)
@given(
    st.tuples(st.floats(5.0, 45.0), st.floats(5.0, 15.0)),
    st.floats(0.0, FULL_TURN, exclude_max=True),
    st.floats(0.5, 6.0),
)
def test_opposite_views_tell_the_same_curves(
    role: Role, opposite: Role, at: Point, start: float, sweep: float
) -> None:
    a, b = at
    frame, other = role.frame, opposite.frame
    flip = -1 if np.dot(frame.right, other.right) < 0 else 1
    rise = -1 if np.dot(frame.up, other.up) < 0 else 1
    arc = Arc((a, b), 4.0, start, sweep, _VISIBLE)
    line = Segment((a, b), (a + 3.0, b + 7.0), _HIDDEN)
    # Seen from behind: mirrored along one coordinate, so that angles run the other way.
    first = np.arctan2(rise * np.sin(start + sweep), flip * np.cos(start + sweep))
    mirrored = Arc((flip * a, rise * b), 4.0, float(first), sweep, _VISIBLE)
    ends = (flip * a, rise * b), (flip * (a + 3.0), rise * (b + 7.0))
    planes = []
    for seen, strokes in ((role, [arc, line]), (opposite, [mirrored, Segment(*ends, _HIDDEN)])):
        ((_, plane),) = find_carriers(
            exact_views({seen: strokes}, (60.0, 60.0, 60.0))
        ).planes.items()
        planes.append(plane)
    assert planes[0].normal is planes[1].normal
    for one, two in zip(planes[0].carriers, planes[1].carriers, strict=True):
        assert np.ravel(one.curve.at(1.0)) == pytest.approx(np.ravel(two.curve.at(1.0)), abs=1e-6)
        drawn, again = np.array(one.drawn()), np.array(two.drawn())
        assert drawn == pytest.approx(again, abs=1e-6)
        kinds = [
            {s.linetype for intervals in o.intervals.values() for s in intervals}
            for o in (one, two)
        ]
        assert kinds[0] == kinds[1]


@given(st.floats(0.0, FULL_TURN, exclude_max=True), st.floats(0.3, 6.2))
def test_an_arc_is_drawn_where_it_is(start: float, sweep: float) -> None:
    (carrier,) = _front([Arc((25.0, 10.0), 8.0, start, sweep, _VISIBLE)]).carriers
    assert isinstance(carrier.curve, Circle)
    assert carrier.curve.centre == pytest.approx((50.0, 20.0), abs=1e-9)
    assert carrier.curve.radius == pytest.approx(16.0, abs=1e-6)
    intervals = carrier.intervals[Role.FRONT]
    assert all(0.0 <= interval.low < interval.high <= FULL_TURN for interval in intervals)
    assert sum(interval.high - interval.low for interval in intervals) == pytest.approx(
        sweep, abs=1e-2
    )
    for share in (0.05, 0.5, 0.95):
        at = (start + share * sweep) % FULL_TURN
        assert carrier.linetype_at(Role.FRONT, at) is _VISIBLE
    if sweep < 5.5:
        assert carrier.linetype_at(Role.FRONT, (start + sweep + 0.3) % FULL_TURN) is None


def test_both_halves_of_a_circle_are_one_whole_circle() -> None:
    halves = [Arc((25.0, 10.0), 5.0, k * pi, pi, _VISIBLE) for k in range(2)]
    (carrier,) = _front(halves).carriers
    assert carrier.drawn() == [(0.0, pytest.approx(FULL_TURN))]


@given(st.lists(st.floats(-0.02, 0.02), min_size=40, max_size=40))
def test_jitter_within_the_tolerance_leaves_no_gap(errors: list[float]) -> None:
    exact = [*_box(50, 20), *_chain((10, 20), (10, 8), (35, 8), (35, 20))]
    exact += _chain((35, 8), (50, 2))
    off = iter(errors)
    strokes = [
        Segment(
            (s.start[0] + next(off), s.start[1] + next(off)),
            (s.end[0] + next(off), s.end[1] + next(off)),
            _VISIBLE,
        )
        for s in exact
    ]
    plane = _front(strokes, tolerance=0.06)
    assert len(plane.carriers) == 8
    for carrier in plane.carriers:
        for low, high in carrier.drawn():
            for end in (carrier.curve.at(low), carrier.curve.at(high)):
                others = [o for o in plane.carriers if o is not carrier]
                assert min(other.curve.distance(end) for other in others) < 1e-8


def test_collinear_slants_are_one_line_through_the_values_of_their_ends() -> None:
    slants = [*_chain((10, 0), (22, 6)), *_chain((30.02, 10), (50, 20))]
    plane = _front([*_box(50, 20), *_chain((10, 0), (10, 20)), *slants], tolerance=0.06)
    (slant,) = (s for s in plane.carriers if s.curve.axis is None)
    assert slant.curve.distance((20.0, 0.0)) < 1e-9
    assert slant.curve.distance((100.0, 40.0)) < 1e-9
    assert len(slant.drawn()) == 2


def test_a_slant_that_touches_circles_is_their_tangent() -> None:
    # A link: two rounds of 8 and 4 mm, and the tangent over them read half a pixel too low.
    arcs = [Arc((10, 10), 8, 0.0, FULL_TURN, _VISIBLE), Arc((42, 10), 4, 0.0, FULL_TURN, _VISIBLE)]
    lean = np.arcsin(4 / 32)
    ends = [
        (10 + 8 * np.sin(lean), 10 + 8 * np.cos(lean)),
        (42 + 4 * np.sin(lean), 10 + 4 * np.cos(lean)),
    ]
    read = [(float(x), float(y) - 0.03) for x, y in ends]
    plane = _front([*arcs, *_chain(*read)], tolerance=0.06)
    (slant,) = (s for s in plane.carriers if isinstance(s.curve, Line))
    assert slant.curve.distance((20.0, 20.0)) == pytest.approx(16.0, abs=1e-6)
    assert slant.curve.distance((84.0, 20.0)) == pytest.approx(8.0, abs=1e-6)


def test_other_curves_are_chains_and_specks_are_nothing() -> None:
    ellipse = Ellipse((25.0, 10.0), 8.0, 3.0, 0.4, 0.0, 2.0, _HIDDEN)
    speck = Segment((5.0, 5.0), (5.00005, 5.00005), _VISIBLE)
    short = Segment((8.0, 8.0), (8.05, 8.05), _VISIBLE)
    plane = _front([*_box(50, 20), ellipse, speck, short])
    assert len(plane.carriers) == 4
    assert [(role, linetype) for role, _, linetype in plane.chains] == [
        (Role.FRONT, _HIDDEN),
        (Role.FRONT, _VISIBLE),
    ]
    chain = np.array(plane.chains[0][1])
    assert chain[[0, -1]] == pytest.approx(ellipse.extremes()[:2] * _SCALE)


def test_values_are_shared_by_the_planes(sample_views: Callable[[str], DrawnViews]) -> None:
    carriers = find_carriers(sample_views("stepped-block"))
    assert set(carriers.planes) == set(Axis)
    assert max(carriers.size) == pytest.approx(UNITS)
    for axis in Axis:
        values = carriers.values[axis]
        assert values[0] == pytest.approx(0.0, abs=1e-9)
        assert values[-1] == pytest.approx(carriers.size[axis.value], abs=1e-9)
        for normal, plane in carriers.planes.items():
            for carrier in plane.carriers:
                if carrier.curve.axis is None or normal is axis:
                    continue
                axes = [other for other in Axis if other is not normal]
                if axes[carrier.curve.axis] is axis:
                    assert carrier.curve.point[carrier.curve.axis] in values


@pytest.mark.parametrize(
    ("arc", "is_given"),
    [
        # Sharply bent quarters between lines along the axes are rounded corners.
        (Arc((1.0, 19.0), 1.0, pi / 2.0, pi / 2.0, _VISIBLE), True),
        (Arc((1.0, 19.0), 1.0, pi / 2.0 + 0.1, pi / 2.0 - 0.2, _VISIBLE), True),
        # Other flat arcs may be any curve, and the smallest quarters a slip.
        (Arc((1.0, 19.0), 1.0, pi / 4.0, pi / 2.0, _VISIBLE), False),
        (Arc((1.0, 19.0), 1.0, pi / 2.0, pi / 4.0, _VISIBLE), False),
        (Arc((0.5, 19.5), 0.5, pi / 2.0, pi / 2.0, _VISIBLE), False),
    ],
)
def test_flat_quarters_between_the_axes_tell_their_circle(arc: Arc, is_given: bool) -> None:
    plane = _front([*_box(50, 20), arc], tolerance=0.2)
    circles = [s for s in plane.carriers if isinstance(s.curve, Circle)]
    assert (len(circles), len(plane.chains)) == ((1, 0) if is_given else (0, 1))


@pytest.mark.parametrize("known", [None, Axis.Z])
def test_an_extent_that_was_told_scales_a_design_step(known: Axis | None) -> None:
    """A ribbed plate of 50 x 30 x 20 mm, in whole millimetres, of which the width was read 0.01 mm
    too long; its height was told."""
    long = 1.0002

    def box(wide: float, high: float, ribs: list[int], factor: float) -> list[Segment]:
        chain = _chain((0, 0), (wide * factor, 0), (wide * factor, high), (0, high), (0, 0))
        lines = [_chain((x * factor, 0), (x * factor, high)) for x in ribs]
        return chain + [line for pair in lines for line in pair]

    front = box(50, 20, [3, 7, 12, 18, 23, 29, 34, 41, 47], long)
    right = box(30, 20, [2, 5, 9, 13, 16, 22, 28], 1.0)
    strokes = {Role.FRONT: tuple(front), Role.RIGHT: tuple(right)}
    views = DrawnViews(strokes, (50.0 * long, 30.0, 20.0), 0.05, 0.015, known=known)
    found = find_carriers(views)
    assert found.step is not None
    off = found.step.length / found.scale - 1.0
    assert off == pytest.approx(0.0 if known else long - 1.0, abs=1e-9)


@pytest.mark.parametrize("known", [None, Axis.Z])
def test_few_measures_are_round_where_the_scale_is_known(known: Axis | None) -> None:
    """A rod of 20 mm, read a sixth of a pixel too thick."""
    wide = 20.01
    box = _chain((0, 0), (wide, 0), (wide, 50), (0, 50), (0, 0))
    rod = Arc((wide / 2, wide / 2), wide / 2, 0.0, 2.0 * pi, _VISIBLE)
    strokes = {Role.FRONT: tuple(box), Role.TOP: (rod,), Role.RIGHT: tuple(box)}
    views = DrawnViews(strokes, (wide, wide, 50.0), 0.06, 0.02, 0.003, likely=True, known=known)
    found = find_carriers(views)
    radius = next(s.curve.radius for s in found.planes[Axis.Z].carriers) / found.scale
    assert radius == pytest.approx(10.0 if known else wide / 2, abs=1e-6)
