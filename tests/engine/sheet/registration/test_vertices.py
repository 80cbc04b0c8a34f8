"""Ends of strokes where what they lie on meets."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.registration.stroke_carriers import AxisLine, Round, Slant, supports_of
from gaussiancad_core.sheet.registration.stroke_precision import FROM_PIXELS
from gaussiancad_core.sheet.registration.vertices import Grid, settled_strokes

GRID = Grid((np.array([0.0, 60.0, 200.0]), np.array([0.0, 80.0])), FROM_PIXELS)


def line(*ends: float, kind: Linetype = Linetype.VISIBLE) -> Segment:
    """From x0, y0 to x1, y1."""
    return Segment((ends[0], ends[1]), (ends[2], ends[3]), kind)


def settled(*strokes: Stroke) -> tuple[Stroke, ...]:
    """Strokes whose lines along the axes lie at the grid's coordinates."""
    this_supports = supports_of(strokes, FROM_PIXELS)
    supports = tuple(
        replace(s, at=GRID.snapped(s.fixed, s.at)) if isinstance(s, AxisLine) else s
        for s in this_supports.supports
    )
    return settled_strokes(replace(this_supports, supports=supports), GRID)


def test_strokes_are_told_by_what_they_lie_on() -> None:
    supports = supports_of(
        (
            line(0, 0, 100, 0.3),
            line(0.1, 0, 0, 50),
            line(0, 0, 40, 30),
            line(80, 60, 120, 90.1, kind=Linetype.HIDDEN),
            line(0, 20, 40, 50),
            Arc((50.0, 50.0), 20.0, 0.0, 1.0, Linetype.VISIBLE),
            Arc((50.1, 50.0), 20.1, 2.0, 1.0, Linetype.HIDDEN),
            Arc((50.0, 50.0), 30.0, 0.0, 1.0, Linetype.VISIBLE),
            Ellipse((0.0, 0.0), 3.0, 2.0, 0.0, 0.0, 1.0, Linetype.VISIBLE),
        ),
        FROM_PIXELS,
    )
    assert supports.of == (0, 1, 2, 2, 3, 4, 4, 5, None)
    kinds = [type(support) for support in supports.supports]
    assert kinds == [AxisLine, AxisLine, Slant, Slant, Round, Round]
    assert (supports.supports[0].fixed, supports.supports[1].fixed) == (1, 0)
    # A line that leans is known less well than its length says.
    assert supports.supports[0].weight < supports.supports[1].weight


def test_slanted_lines_meet_in_their_crossing() -> None:
    first, second = settled(line(10, 10, 50, 50.2), line(49.6, 50.1, 90, 10))
    assert first.end == second.start
    (x, y), (dx, dy) = np.subtract(first.end, (10, 10)), (40.0, 40.2)
    assert x * dy - y * dx == pytest.approx(0.0, abs=1e-6)


def test_circles_that_touch_share_the_point_between_them() -> None:
    first = Arc((40.0, 20.0), 20.0, np.pi, np.pi - 0.02, Linetype.VISIBLE)
    second = Arc((90.0, 20.0), 30.0, 0.0, np.pi + 0.01, Linetype.VISIBLE)
    one, other = settled(first, second)
    joint = np.array([60.0, 20.0])
    assert one.sample(1e9)[-1] == pytest.approx(joint, abs=1e-9)
    assert other.sample(1e9)[-1] == pytest.approx(joint, abs=1e-9)


def test_free_ends_stay_and_ellipses_too() -> None:
    ellipse = Ellipse((30.0, 40.0), 9.0, 5.0, 0.3, 0.0, 2.0, Linetype.VISIBLE)
    alone, kept = settled(line(20, 20, 45, 60), ellipse)
    assert (*alone.start, *alone.end) == pytest.approx((20.0, 20.0, 45.0, 60.0), abs=1e-9)
    assert kept == ellipse


def test_a_short_stroke_does_not_vanish_between_its_vertices() -> None:
    # Both its ends are near the same coordinate.
    base, bump = settled(line(0, 0, 200, 0), line(59.4, 40.0, 60.9, 40.0))
    assert base.length == 200.0
    assert bump.start[1] == bump.end[1]
    assert bump.end[0] - bump.start[0] == pytest.approx(1.5)
