"""Chords of a curve are no traces of planes; the edges of a faceted part are."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.coordinates.chords import find_chords
from gaussiancad_core.evidence.drawn_views import exact_views
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment

_SIZE = (40.0, 30.0, 20.0)
_TOLERANCE = 1e-4


def _box(width: float, height: float) -> list[Segment]:
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0)]
    return [Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(corners)]


def _arch(count: int) -> np.ndarray:
    """(count + 1, 2) points along half of an ellipse."""
    angles = np.linspace(0.0, np.pi, count + 1)
    return np.stack([20.0 - 15.0 * np.cos(angles), 4.0 + 11.0 * np.sin(angles)], axis=1)


def _chords(points: np.ndarray, linetype: Linetype = Linetype.HIDDEN) -> list[Segment]:
    return [Segment(tuple(a), tuple(b), linetype) for a, b in pairwise(points.tolist())]


def _views(front: list[Segment], top: list[Segment]) -> dict[Role, list[Segment]]:
    return {
        Role.FRONT: [*_box(40.0, 20.0), *front],
        Role.TOP: [*_box(40.0, 30.0), *top],
        Role.RIGHT: _box(30.0, 20.0),
    }


def test_a_curve_in_chords_is_a_chain() -> None:
    points = _arch(24)
    views = _views(_chords(points), [])
    (run,) = find_chords(views, _TOLERANCE)
    assert (run.role, run.first, run.last) == (Role.FRONT, 4, 27)
    assert run.points == pytest.approx(points)
    carriers = find_carriers(exact_views(views, _SIZE))
    for plane in carriers.planes.values():
        assert all(carrier.curve.axis is not None for carrier in plane.carriers)
    ((role, chain, linetype),) = [c for p in carriers.planes.values() for c in p.chains]
    assert (role, linetype) == (Role.FRONT, Linetype.HIDDEN)
    assert len(chain) == 25


def test_edges_that_another_view_draws_are_no_chords() -> None:
    points = _arch(24)
    across = [Segment((x, 0.0), (x, 30.0), Linetype.HIDDEN) for x in points[1:-1, 0].tolist()]
    views = _views(_chords(points), across)
    assert find_chords(views, _TOLERANCE) == []
    plane = next(p for p in find_carriers(exact_views(views, _SIZE)).planes.values() if p.carriers)
    assert plane.chains == ()


@pytest.mark.parametrize(
    "points",
    [_arch(5), _arch(24)[:3], np.array([(5.0, 5.0), (10.0, 8.0), (15.0, 11.0), (20.0, 14.0)])],
    ids=["polygon", "too few", "straight on"],
)
def test_other_lines_are_no_chords(points: np.ndarray) -> None:
    assert find_chords(_views(_chords(points), []), _TOLERANCE) == []


def test_chords_end_where_the_linetype_changes_or_a_line_is_apart() -> None:
    points = _arch(24)
    changed = [*_chords(points[:9]), *_chords(points[8:], Linetype.VISIBLE)]
    runs = find_chords(_views(changed, []), _TOLERANCE)
    assert [(run.first, run.last) for run in runs] == [(4, 11), (12, 27)]
    apart = [*_chords(points[:9]), *_chords(points[9:])]
    runs = find_chords(_views(apart, []), _TOLERANCE)
    assert [(run.first, run.last) for run in runs] == [(4, 11), (12, 26)]
