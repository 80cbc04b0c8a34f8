"""Half spaces: what lies below them, and where lines of sight meet them."""

import itertools

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gaussiancad_core.cells.half_spaces import HalfSpace
from gaussiancad_core.cells.revolution_kernels import MOST, crossings
from gaussiancad_core.cells.sight_lines import body_table
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.axes import Axis, Vector
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted

_PART = st.floats(-1.0, 1.0).filter(lambda x: abs(x) > 0.05)
_COORDINATE = st.floats(-100.0, 100.0)


@st.composite
def _half_spaces(draw: st.DrawFn) -> HalfSpace:
    normal = np.array([draw(_PART) for _ in range(3)])
    x, y, z = (normal / np.linalg.norm(normal)).tolist()
    return HalfSpace((x, y, z), draw(st.floats(-100.0, 100.0)), ())


@given(_half_spaces(), st.sampled_from(Axis), _COORDINATE, _COORDINATE, st.floats(-900.0, 900.0))
def test_crossings_tell_what_lies_below(
    body: HalfSpace, normal: Axis, a: float, b: float, depth: float
) -> None:
    assume(abs(body.depth(normal, a, b)) < 990.0)
    assume(abs(depth - body.depth(normal, a, b)) > 1e-6)
    crossings = body.crossings(normal, a, b)
    assert [at for at, _ in crossings] == sorted(at for at, _ in crossings)
    before = sum(at < depth for at, _ in crossings)
    # One end of the half space is far away, so that a line starts outside of it.
    assert (before % 2 == 1) == body.holds(lifted(normal, a, b, depth))
    assert all(direction == body.normal for _, direction in crossings)


@given(_half_spaces(), st.sampled_from(Axis), _COORDINATE, _COORDINATE)
def test_the_kernel_meets_them_at_the_same_places(
    body: HalfSpace, normal: Axis, a: float, b: float
) -> None:
    depths, normals = np.empty(MOST), np.empty((MOST, 3))
    (row,) = body_table([body])
    count = crossings(row, normal.value, (a, b), (depths, normals))
    expected = body.crossings(normal, a, b)
    assert count == len(expected) == 2
    assert depths[:2].tolist() == pytest.approx([depth for depth, _ in expected])
    assert normals[:2].tolist() == [list(direction) for _, direction in expected]


@given(_half_spaces(), st.sampled_from(Axis), _COORDINATE, _COORDINATE)
def test_the_plane_is_met_on_it(body: HalfSpace, normal: Axis, a: float, b: float) -> None:
    point = np.array(lifted(normal, a, b, body.depth(normal, a, b)))
    assert point @ np.array(body.normal) == pytest.approx(body.offset, abs=1e-9 * abs(point).max())


_CORNERS: tuple[Vector, ...] = ((20.0, 0.0, 0.0), (0.0, 10.0, 0.0), (0.0, 0.0, 5.0))
_SLANTED: tuple[Vector, Vector] = ((10.0, 5.0, 0.0), (0.0, 0.0, 5.0))
_LEVEL: tuple[Vector, Vector] = ((10.0, 0.0, 2.5), (0.0, 5.0, 2.5))


def test_views_see_the_hulls_by_two_coordinates() -> None:
    body = HalfSpace((1 / 21**0.5, 2 / 21**0.5, 4 / 21**0.5), 20 / 21**0.5, (_CORNERS,))
    for normal in Axis:
        (outline,) = body.outlines(normal)
        first, second = IN_PLANE[normal]
        assert outline == tuple((p[first], p[second]) for p in _CORNERS)


def test_rims_are_the_creases_that_a_view_sees_slanted() -> None:
    body = HalfSpace((1.0, 1.0, 1.0), 0.0, (_CORNERS,), (_SLANTED, _LEVEL))
    assert {normal: len(body.rims(normal)) for normal in Axis} == {Axis.X: 1, Axis.Y: 1, Axis.Z: 2}
    for normal, crease in itertools.product(Axis, (_SLANTED, _LEVEL)):
        first, second = IN_PLANE[normal]
        ends = {(p[first], p[second]) for p in crease}
        if len({a for a, _ in ends}) == 1 or len({b for _, b in ends}) == 1:
            continue
        found = []
        for curve, (low, high) in body.rims(normal):
            assert isinstance(curve, Line) and curve.axis is None
            found.append({tuple(np.round(curve.at(t), 9).tolist()) for t in (low, high)})
        assert ends in found
