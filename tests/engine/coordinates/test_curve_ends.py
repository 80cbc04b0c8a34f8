"""Curves in place of strokes, and the lines that end where they do."""

import numpy as np
import pytest

from gaussiancad_core.coordinates.curve_ends import with_common_ends
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.views import Linetype, Segment

_VISIBLE = Linetype.VISIBLE
_TOLERANCE = 0.1


def _parabola(low: float, high: float) -> Polyline:
    """z = x**2 / 20 between two x."""
    x = np.linspace(low, high, 41)
    return Polyline(tuple(zip(x.tolist(), (x**2 / 20.0).tolist(), strict=True)), _VISIBLE)


def _chord(low: float, high: float) -> Segment:
    return Segment((low, low**2 / 20.0), (high, high**2 / 20.0), _VISIBLE)


def test_a_line_ends_where_the_curve_does() -> None:
    stroke, edge = _chord(2.0, 10.1), Segment((20.0, 5.0), (10.15, 5.02), _VISIBLE)
    curve = _parabola(2.0, 10.0)
    ended, kept = with_common_ends([edge, stroke], [edge, curve], _TOLERANCE)
    assert isinstance(ended, Segment) and kept == curve
    assert ended.start == edge.start
    assert ended.end == pytest.approx((10.0, 5.0), abs=0.03)
    # Along its own way.
    way, old = (np.subtract(line.end, line.start) for line in (ended, edge))
    assert way[0] * old[1] == pytest.approx(way[1] * old[0], abs=1e-9)


@pytest.mark.parametrize(
    "edge",
    [
        Segment((20.0, 5.0), (12.0, 5.0), _VISIBLE),
        Segment((10.1, 0.0), (10.1, 5.1), _VISIBLE),
    ],
)
def test_a_line_that_goes_elsewhere_stays(edge: Segment) -> None:
    """It ends somewhere else, or runs past the curve's end."""
    strokes, curves = [edge, _chord(2.0, 10.1)], [edge, _parabola(2.0, 10.0)]
    assert next(iter(with_common_ends(strokes, curves, _TOLERANCE))) == edge


def test_what_two_strokes_have_of_one_curve_is_there_once() -> None:
    strokes = [_chord(2.0, 7.0), _chord(6.0, 10.0), _chord(3.0, 5.0)]
    curves = [_parabola(2.0, 7.0), _parabola(6.0, 10.0), _parabola(3.0, 5.0)]
    first, second = with_common_ends(strokes, curves, _TOLERANCE)
    assert first == curves[0]
    assert isinstance(second, Polyline)
    assert second.points[0] == first.points[-1]
    assert second.points[-1] == curves[1].points[-1]
    assert all(x > 6.99 for x, _ in second.points)
