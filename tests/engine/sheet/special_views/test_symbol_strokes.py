"""A file's strokes show its projection symbol, however they are drawn, and nothing else does."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.sheet.special_views.symbol_shape import largest_symbol
from gaussiancad_core.sheet.special_views.symbol_strokes import stroke_symbol

_LARGEST = largest_symbol((1654, 2339), 200.0)
_CENTRE = np.array([1200.0, 700.0])
_RADIUS = 40.0
_NEAR, _FAR = 1.6, 3.6
"""Ends of the cone, in radii from the circles' centre."""


def _ring(radius: float, drawn: str) -> list[Curve]:
    centre = (float(_CENTRE[0]), float(_CENTRE[1]))
    if drawn == "halves":
        return [CircularArc(centre, radius, start, np.pi) for start in (0.3, 0.3 + np.pi)]
    if drawn == "chain":
        points = CircularArc(centre, radius, 0.0, FULL_TURN).sample(radius / 6.0)
        return [Chain(tuple(map(tuple, points.tolist())))]
    if drawn == "ellipse":
        return [EllipticArc(centre, radius, 0.995 * radius, 0.0, 0.0, FULL_TURN)]
    return [CircularArc(centre, radius, 0.0, FULL_TURN)]


def _symbol(
    projection: Projection, turns: int = 0, drawn: str = "whole", beyond: float = 0.0
) -> list[Curve]:
    """Circles, and a cone a number of quarter turns from right of them."""
    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    turned = np.linalg.matrix_power(quarter, turns)
    near, far = (0.5, 1.0) if projection is Projection.THIRD else (1.0, 0.5)

    def line(*ends: tuple[float, float]) -> LineSegment:
        start, end = (turned @ (_RADIUS * np.array(this_end)) + _CENTRE for this_end in ends)
        return LineSegment((float(start[0]), float(start[1])), (float(end[0]), float(end[1])))

    cone = [
        line((_NEAR, -near), (_FAR, -far)),
        line((_FAR, far), (_NEAR, near)),
        line((_NEAR, -near - beyond), (_NEAR, near + beyond)),
        line((_FAR, -far), (_FAR, 0.0)),
        line((_FAR, 0.0), (_FAR, far)),
    ]
    return [*_ring(_RADIUS, drawn), *_ring(_RADIUS / 2.0, drawn), *cone]


def _drawing(curves: list[Curve], **look: object) -> VectorDrawing:
    return VectorDrawing(tuple(VectorStroke(curve, 2.0, **look) for curve in curves), ())


@pytest.mark.parametrize("projection", Projection)
@pytest.mark.parametrize("turns", range(4))
@pytest.mark.parametrize("drawn", ["whole", "halves", "chain", "ellipse"])
@pytest.mark.parametrize("axis", [False, True])
def test_circles_beside_a_cone_tell_the_projection(
    projection: Projection, turns: int, drawn: str, axis: bool
) -> None:
    curves = _symbol(projection, turns, drawn)
    x, y = _CENTRE.tolist()
    if axis:
        curves += [
            LineSegment((x - 200.0, y), (x + 200.0, y)),
            LineSegment((x, y - 200.0), (x, y + 200.0)),
        ]
    found = stroke_symbol(_drawing(curves), _LARGEST)
    assert found is not None
    assert found.projection is projection
    low, high = -_RADIUS, _FAR * _RADIUS
    along = {0: (0, low, high), 1: (1, low, high), 2: (0, -high, -low), 3: (1, -high, -low)}
    index, first, last = along[turns]
    corners = np.array([_CENTRE - _RADIUS, _CENTRE + _RADIUS])
    corners[:, index] = _CENTRE[index] + first, _CENTRE[index] + last
    assert found.mark.box == pytest.approx(corners.ravel(), abs=0.5)


def test_dashed_lines_are_no_symbol() -> None:
    curves = _symbol(Projection.FIRST)
    assert stroke_symbol(_drawing(curves, dashes=(8.0, 4.0)), _LARGEST) is None


def test_a_taper_on_a_base_is_no_symbol() -> None:
    assert stroke_symbol(_drawing(_symbol(Projection.FIRST, beyond=1.0)), _LARGEST) is None


def test_an_open_cone_is_no_symbol() -> None:
    assert stroke_symbol(_drawing(_symbol(Projection.FIRST)[:-1]), _LARGEST) is None


@pytest.mark.parametrize("factor", [0.1, 4.0])
def test_what_is_larger_or_smaller_than_a_symbol_on_paper_is_none(factor: float) -> None:
    assert stroke_symbol(_drawing(_symbol(Projection.FIRST)), _LARGEST / factor) is None


def test_symbols_that_disagree_tell_nothing() -> None:
    drawing = _drawing(_symbol(Projection.FIRST, 0) + _symbol(Projection.THIRD, 2))
    assert stroke_symbol(drawing, _LARGEST) is None
    alike = _drawing(_symbol(Projection.FIRST, 0) + _symbol(Projection.FIRST, 2))
    assert stroke_symbol(alike, _LARGEST).projection is Projection.FIRST


def test_a_sheet_without_strokes_has_no_symbol() -> None:
    assert stroke_symbol(VectorDrawing((), ()), _LARGEST) is None
    lines = _drawing(_symbol(Projection.FIRST)[2:])
    assert stroke_symbol(replace(lines, complete=False), _LARGEST) is None
