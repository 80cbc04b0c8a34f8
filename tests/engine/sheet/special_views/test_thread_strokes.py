"""Thread symbols of a file, in all views."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.thread_symbols import without_threads
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind

_FRONT, _TOP = (100.0, 300.0, 300.0, 400.0), (100.0, 100.0, 300.0, 200.0)
_THIN, _RIM = 10.0, 8.2
_CENTRE = (150.0, 350.0)

VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN


def _arc(radius: float, share: float, linetype: Linetype = VISIBLE) -> Arc:
    return Arc(_CENTRE, radius, 0.4, 2.0 * np.pi * share, linetype)


def _view(role: Role, box: tuple, *strokes: Stroke) -> ReadView:
    (x0, y0, x1, y1) = box
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    sides = [Segment(corners[k], corners[(k + 1) % 4], VISIBLE) for k in range(4)]
    return ReadView(role, box, (*sides, *strokes), None, StrokesSource.VECTOR)


def _upright(at: float, low: float, high: float, linetype: Linetype = HIDDEN) -> Segment:
    return Segment((at, low), (at, high), linetype)


def _sides(low: float, high: float) -> list[Segment]:
    """Of the thread from above: its axis runs up the top view."""
    x = _CENTRE[0]
    return [_upright(x + sign * r, low, high) for r in (_THIN, _RIM) for sign in (-1.0, 1.0)]


@pytest.mark.parametrize("adjacent", [True, False])
def test_the_thin_circle_and_its_lines_go_and_the_bore_stays(adjacent: bool) -> None:
    arc = _arc(_THIN, 0.75)
    front = _view(Role.FRONT, _FRONT, _arc(_RIM, 1.0), *([] if adjacent else [arc]))
    top = _view(Role.TOP, _TOP, *_sides(100.0, 200.0))
    (item, above), special = without_threads([front, top], [arc] if adjacent else [])
    assert [s.radius for s in item.strokes if isinstance(s, Arc)] == [_RIM]
    left = sorted(s.start[0] for s in above.strokes if s.linetype is HIDDEN)
    assert left == [_CENTRE[0] - _RIM, _CENTRE[0] + _RIM]
    (stated,) = special
    assert stated.kind is SpecialKind.THREAD and stated.box[0] == _CENTRE[0] - _THIN


def test_an_edge_where_a_threads_line_would_be_stays_where_no_bore_runs_beside_it() -> None:
    arc = _arc(_THIN, 0.75)
    edge = _upright(_CENTRE[0] + _THIN, 100.0, 140.0, VISIBLE)
    bore = [_upright(_CENTRE[0] + sign * _RIM, 150.0, 200.0) for sign in (-1.0, 1.0)]
    views = [
        _view(Role.FRONT, _FRONT, _arc(_RIM, 1.0)),
        _view(Role.TOP, _TOP, edge, *bore),
    ]
    (_, above), special = without_threads(views, [arc])
    assert len(special) == 1 and edge in above.strokes


@pytest.mark.parametrize(
    ("thin", "rim"),
    [
        (_arc(_THIN, 1.0), _arc(_RIM, 1.0)),
        (_arc(_THIN, 0.4), _arc(_RIM, 1.0)),
        (_arc(_THIN, 0.75), _arc(_RIM, 0.75)),
        (_arc(20.0, 0.75), _arc(_RIM, 1.0)),
        (_arc(_THIN, 0.75), Arc((153.0, 350.0), _RIM, 0.0, 2.0 * np.pi, VISIBLE)),
    ],
    ids=["two whole circles", "a short arc", "no whole circle", "far apart", "beside each other"],
)
def test_other_arcs_about_circles_are_edges(thin: Arc, rim: Arc) -> None:
    views = [_view(Role.FRONT, _FRONT, thin, rim), _view(Role.TOP, _TOP, *_sides(100.0, 200.0))]
    found, special = without_threads(views, [])
    assert list(found) == views and special == ()


def test_from_behind_the_thin_circle_is_hidden_and_goes_too() -> None:
    arc = _arc(_THIN, 0.75)
    mirrored = Arc((250.0, 650.0), _THIN, 0.0, 4.6, HIDDEN)
    bore = Arc((250.0, 650.0), _RIM, 0.0, 2.0 * np.pi, HIDDEN)
    views = [
        _view(Role.FRONT, _FRONT, _arc(_RIM, 1.0)),
        _view(Role.REAR, (100.0, 600.0, 300.0, 700.0), mirrored, bore),
    ]
    (_, rear), _ = without_threads(views, [arc])
    assert bore in rear.strokes and mirrored not in rear.strokes


_X = _CENTRE[0]


def _across(y: float, *ends: float) -> list[Segment]:
    """Level lines from offset to offset from the thread's axis."""
    return [Segment((_X + a, y), (_X + b, y), HIDDEN) for a, b in pairwise(ends)]


def _blind(depth: float, bore: float, *more: Segment) -> list[Segment]:
    """A thread that ends at a depth in a bore that ends at another one, from above."""
    lines = [_upright(_X + sign * _THIN, 100.0, 100.0 + depth) for sign in (-1.0, 1.0)]
    lines += [_upright(_X + sign * _RIM, 100.0, 100.0 + bore) for sign in (-1.0, 1.0)]
    return [*lines, *_across(100.0 + bore, -_RIM, _RIM), *more]


def _left(top: list[Segment], thin: float = _THIN, rim: float = _RIM) -> list[Stroke]:
    """What is left of the lines of a view from above."""
    views = [_view(Role.FRONT, _FRONT, _arc(rim, 1.0)), _view(Role.TOP, _TOP, *top)]
    (_, above), _ = without_threads(views, [_arc(thin, 0.75)])
    return list(above.strokes[4:])


@pytest.mark.parametrize(
    "ends",
    [(-_THIN, _THIN), (-_THIN, -_RIM, _RIM, _THIN), (-_RIM, _RIM), (-_THIN, 0.0, _THIN)],
    ids=["whole", "in pieces", "within the bore", "in halves"],
)
def test_the_line_at_the_depth_of_a_thread_is_no_edge(ends: tuple[float, ...]) -> None:
    plain = _blind(40.0, 60.0)
    assert _left([*plain, *_across(140.0, *ends)]) == plain[2:]


def test_the_floor_of_a_bore_stays_where_its_thread_ends_with_it() -> None:
    floors = _blind(60.0, 60.0)
    assert _left(floors) == floors[2:]
    one_line = [*floors[:-1], *_across(160.0, -_THIN, _THIN)]
    assert _left(one_line) == floors[2:]


def test_an_edge_that_is_wider_than_a_thread_stays_at_its_end() -> None:
    edge = _across(140.0, -_THIN - 8.0, _THIN)
    assert _left(_blind(40.0, 60.0, *edge)) == [*_blind(40.0, 60.0)[2:], *edge]


def test_the_line_at_the_end_of_a_shafts_thread_is_no_edge() -> None:
    shaft = [_upright(_X + sign * _THIN, 100.0, 200.0, VISIBLE) for sign in (-1.0, 1.0)]
    thread = [_upright(_X + sign * _RIM, 100.0, 140.0, VISIBLE) for sign in (-1.0, 1.0)]
    end = Segment((_X - _THIN, 140.0), (_X + _THIN, 140.0), VISIBLE)
    assert _left([*shaft, *thread, end], thin=_RIM, rim=_THIN) == shaft


def test_an_outline_around_a_bore_is_no_thread() -> None:
    arc = _arc(_THIN, 0.75)
    first, last = arc.sample(np.inf)[[0, -1]].tolist()
    handle = [Segment(tuple(end), (400.0, 350.0), VISIBLE) for end in (first, last)]
    front = _view(Role.FRONT, _FRONT, _arc(_RIM, 1.0), arc, *handle)
    (found,), special = without_threads([front], [arc])
    assert found.strokes == front.strokes and not special
