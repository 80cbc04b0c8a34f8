"""Gaps in outlines."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.hypotheses.open_outlines import find_gaps, with_closed_outlines
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_L = [(0.0, 0.0), (40.0, 0.0), (40.0, 12.0), (15.0, 12.0), (15.0, 30.0), (0.0, 30.0)]


def _outline(corners: list[tuple[float, float]]) -> list[Segment]:
    return [Segment(corners[k - 1], corners[k], Linetype.VISIBLE) for k in range(len(corners))]


def _views(strokes: list[Segment | Arc]) -> DrawnViews:
    return DrawnViews({Role.FRONT: tuple(strokes)}, (40.0, 20.0, 30.0), 1e-4)


def test_closed_outlines_have_none() -> None:
    circle = Arc((8.0, 20.0), 4.0, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
    inner = Segment((20.0, 0.0), (20.0, 12.0), Linetype.VISIBLE)
    assert find_gaps(_views([*_outline(_L), circle, inner])) == ()


@pytest.mark.parametrize("lost", range(6))
@pytest.mark.parametrize("slant", [0.0, 3.0])
def test_each_missing_side_is_the_gap(lost: int, slant: float) -> None:
    corners = [(x + slant * y / 30.0, y) for x, y in _L]
    strokes = _outline(corners)
    gone = strokes.pop(lost)
    (gap,) = find_gaps(_views(strokes))
    assert gap.role is Role.FRONT
    found = [{tuple(np.round(point, 3)) for point in ends} for ends in gap.closing]
    assert {tuple(np.round(point, 3)) for point in (gone.start, gone.end)} in found


def test_a_gap_may_end_on_a_line() -> None:
    # The right side is missing; its upper end is on a line that goes on.
    strokes = _outline([(0.0, 0.0), (30.0, 0.0), (30.0, 20.0), (0.0, 20.0)])
    strokes = [s for s in strokes if not (s.start[0] == s.end[0] == 30.0)]
    tower = _outline([(0.0, 20.0), (40.0, 20.0), (40.0, 30.0), (0.0, 30.0)])
    (gap,) = find_gaps(_views([*strokes, *tower]))
    assert {tuple(np.round(p, 3)) for p in gap.closing[0]} == {(30.0, 0.0), (30.0, 20.0)}


def test_hidden_lines_close_nothing_and_need_not_be_closed() -> None:
    hidden = Segment((5.0, 5.0), (20.0, 5.0), Linetype.HIDDEN)
    assert find_gaps(_views([*_outline(_L), hidden])) == ()
    strokes = _outline(_L)
    strokes[1] = replace(strokes[1], linetype=Linetype.HIDDEN)
    assert len(find_gaps(_views(strokes))) == 1


def test_what_one_line_does_not_close_has_no_gap() -> None:
    strokes = _outline(_L)
    del strokes[4], strokes[1]
    assert find_gaps(_views(strokes)) == ()


def test_each_view_is_looked_at(drawn: Callable[..., DrawnViews], sample_solid: Callable) -> None:
    views = drawn(sample_solid("l-bracket"))
    assert find_gaps(views) == ()
    kept = {role: strokes[1:] for role, strokes in views.strokes.items()}
    assert {gap.role for gap in find_gaps(replace(views, strokes=kept))} == set(views.roles)


def test_views_of_very_many_lines_are_not_looked_at() -> None:
    strokes = _outline(_L)
    del strokes[1]
    inner = [Segment((1.0, 0.1 * k), (14.0, 0.1 * k), Linetype.VISIBLE) for k in range(1, 250)]
    assert len(find_gaps(_views(strokes))) == 1
    assert find_gaps(_views([*strokes, *inner])) == ()


@pytest.mark.parametrize("lost", range(6))
def test_a_line_that_may_be_drawn_or_not_closes_the_outline(lost: int) -> None:
    strokes = _outline(_L)
    gone = strokes.pop(lost)
    views = _views(strokes)
    closed = with_closed_outlines(views)
    assert closed is not None and find_gaps(closed) == ()
    *kept, added = closed.strokes[Role.FRONT]
    assert kept == strokes and added.confidence == 0.0
    (gap,) = find_gaps(views)
    assert {added.start, added.end} == set(map(tuple, gap.closing[0].tolist()))
    if lost not in (2, 3):
        # One of the two lines of the step could go on straight as well.
        assert {added.start, added.end} == {gone.start, gone.end}


def test_closed_views_stay_as_they_are() -> None:
    assert with_closed_outlines(_views(_outline(_L))) is None
