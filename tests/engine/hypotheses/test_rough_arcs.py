"""Arcs that only follow a curve are told from the traces of cylinders."""

from itertools import pairwise
from math import pi

import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.hypotheses.rough_arcs import without_rough_arcs
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_SIZE = (40.0, 30.0, 20.0)
_HIDDEN = Linetype.HIDDEN


def _lines(*points: tuple[float, float]) -> list[Segment]:
    return [Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(points)]


def _views(front: list, top: list | None = None, right: list | None = None) -> DrawnViews:
    def box(width: float, height: float) -> list[Segment]:
        return _lines((0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0))

    strokes = {
        Role.FRONT: [*box(40.0, 20.0), *front],
        Role.TOP: [*box(40.0, 30.0), *(top or [])],
        Role.RIGHT: [*box(30.0, 20.0), *(right or [])],
    }
    return exact_views(strokes, _SIZE)


def _arc(centre: tuple[float, float], radius: float = 5.0, sweep: float = 1.2) -> Arc:
    return Arc(centre, radius, 0.3, sweep, _HIDDEN)


def test_an_arc_that_nothing_speaks_for_becomes_a_curve() -> None:
    arc = _arc((17.3, 8.1))
    smooth = without_rough_arcs(_views([arc]))
    assert smooth is not None
    *others, curve = smooth.strokes[Role.FRONT]
    assert isinstance(curve, Polyline)
    assert curve.linetype is _HIDDEN
    assert curve.length == pytest.approx(arc.length, rel=1e-3)
    assert curve.points[0] == pytest.approx(tuple(arc.sample(arc.length)[0]))
    assert all(isinstance(stroke, Segment) for stroke in others)
    assert smooth.strokes[Role.TOP] == _views([arc]).strokes[Role.TOP]


def test_arcs_with_a_reason_stay() -> None:
    seam = _arc((17.3, 8.1))
    end = tuple(seam.sample(seam.length)[0])
    along = (-(end[1] - 8.1), end[0] - 17.3)
    tangent = Segment(end, (end[0] - along[0], end[1] - along[1]), Linetype.VISIBLE)
    across = [
        Segment((17.3, 0.0), (17.3, 30.0), _HIDDEN),
        Segment((0.0, 8.1), (30.0, 8.1), _HIDDEN),
    ]
    for views in (
        _views([tangent, seam]),
        _views([seam, _arc((17.3, 8.1), 3.0)]),
        _views([_arc((17.3, 8.1), sweep=1.5 * pi)]),
        _views([seam], top=[across[0]], right=[across[1]]),
        _views([seam], top=[_arc((17.3, 21.0))]),
    ):
        smooth = without_rough_arcs(views)
        front = views.strokes[Role.FRONT] if smooth is None else smooth.strokes[Role.FRONT]
        assert front == views.strokes[Role.FRONT]


def test_the_same_radius_elsewhere_on_the_shared_axis_is_no_reason() -> None:
    smooth = without_rough_arcs(_views([_arc((17.3, 8.1))], top=[_arc((12.9, 21.0))]))
    assert smooth is not None
    assert isinstance(smooth.strokes[Role.FRONT][-1], Polyline)


def test_views_without_rough_arcs_are_left_alone() -> None:
    assert without_rough_arcs(_views([Arc((20.0, 9.0), 4.0, 0.0, 2.0 * pi, _HIDDEN)])) is None
