"""Short slanted lines that two views tell."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.hypotheses.suppressed_slants import with_suppressed_slants
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment

_TOLERANCE = 0.1


def _cut_corner(leg: tuple[float, float, float], roles: tuple[Role, ...]) -> DrawnViews:
    """A block of 40 mm whose lower left front corner is cut off; its edges in some views."""
    x, y, z = leg
    cuts = {
        Role.FRONT: ((x, 0.0), (0.0, z)),
        Role.TOP: ((x, 0.0), (0.0, y)),
        Role.RIGHT: ((y, 0.0), (0.0, z)),
    }
    corners = ((0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0), (0.0, 0.0))
    outline = tuple(Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(corners))
    strokes = {
        role: (*outline, Segment(*cuts[role], Linetype.HIDDEN)) if role in roles else outline
        for role in cuts
    }
    return DrawnViews(strokes, (40.0, 40.0, 40.0), _TOLERANCE)


def _slants(views: DrawnViews) -> int:
    plane = with_suppressed_slants(find_carriers(views)).planes[Axis.X]
    return sum(carrier.curve.axis is None for carrier in plane.carriers)


def _edge(y: float, z: float) -> DrawnViews:
    """An edge from the origin to (1.5, y, z) in the front and top view."""
    views = _cut_corner((1.5, y, z), (Role.FRONT, Role.TOP))
    front = [*views.strokes[Role.FRONT][:-1], Segment((0.0, 0.0), (1.5, z), Linetype.HIDDEN)]
    top = [*views.strokes[Role.TOP][:-1], Segment((0.0, 0.0), (1.5, y), Linetype.HIDDEN)]
    strokes = {**views.strokes, Role.FRONT: tuple(front), Role.TOP: tuple(top)}
    return replace(views, strokes=strokes)


@settings(max_examples=25, deadline=None)
@given(st.integers(6, 15), st.integers(6, 15))
def test_an_edge_of_two_views_may_be_drawn_in_the_third(y: int, z: int) -> None:
    y, z = y / 10.0, z / 10.0
    carriers = with_suppressed_slants(find_carriers(_edge(y, z)))
    found = [s for s in carriers.planes[Axis.X].carriers if s.curve.axis is None]
    assert len(found) == 1
    (interval,) = found[0].intervals[Role.RIGHT]
    assert interval.confidence == 0.0
    ends = [found[0].curve.at(at) for at in (interval.low, interval.high)]
    stated = sorted((a / carriers.scale, b / carriers.scale) for a, b in ends)
    assert stated[0] == pytest.approx((0.0, 0.0), abs=1e-6)
    assert stated[1] == pytest.approx((y, z), abs=1e-6)
    middle = (interval.low + interval.high) / 2.0
    assert found[0].linetype_at(Role.RIGHT, middle) is None
    assert found[0].is_open_at(Role.RIGHT, middle)


def test_a_long_edge_would_have_been_read() -> None:
    assert _slants(_edge(10.0, 12.0)) == 0


def test_a_line_that_is_drawn_stays_as_it_is() -> None:
    views = _edge(1.0, 1.2)
    drawn = Segment((0.0, 0.0), (1.0, 1.2), Linetype.HIDDEN)
    strokes = {**views.strokes, Role.RIGHT: (*views.strokes[Role.RIGHT], drawn)}
    views = replace(views, strokes=strokes)
    plane = with_suppressed_slants(find_carriers(views)).planes[Axis.X]
    (slant,) = (s for s in plane.carriers if s.curve.axis is None)
    assert [interval.confidence for interval in slant.intervals[Role.RIGHT]] == [1.0]


def test_one_view_alone_tells_nothing() -> None:
    assert _slants(_cut_corner((1.5, 1.0, 1.2), (Role.FRONT,))) == 0


def test_an_edge_whose_ends_are_one_corner_is_no_line() -> None:
    views = _edge(0.25, 0.3)
    # A third line crosses within reach of both ends.
    right = (*views.strokes[Role.RIGHT], Segment((0.35, 0.0), (0.0, 0.35), Linetype.HIDDEN))
    views = replace(views, strokes={**views.strokes, Role.RIGHT: right})
    plane = with_suppressed_slants(find_carriers(views)).planes[Axis.X]
    intervals = [
        interval for carrier in plane.carriers for interval in carrier.intervals[Role.RIGHT]
    ]
    assert all(interval.high - interval.low > _TOLERANCE for interval in intervals)


def test_where_ends_agree_by_chance_nothing_is_added() -> None:
    random = np.random.default_rng(0)
    views = _cut_corner((1.5, 1.0, 1.2), ())
    strokes = {}
    for role, outline in views.strokes.items():
        starts = random.uniform(0.0, 40.0, (150, 2))
        ends = np.clip(starts + random.normal(0.0, 4.0, (150, 2)), 0.0, 40.0)
        scribble = zip(starts.tolist(), ends.tolist(), strict=True)
        lines = (Segment(tuple(a), tuple(b), Linetype.VISIBLE) for a, b in scribble)
        strokes[role] = (*outline, *lines)
    carriers = find_carriers(replace(views, strokes=strokes))
    found = with_suppressed_slants(carriers)
    for axis, plane in carriers.planes.items():
        assert len(found.planes[axis].carriers) - len(plane.carriers) <= 12
