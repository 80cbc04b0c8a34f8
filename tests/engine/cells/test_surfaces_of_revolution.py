"""Bodies of revolution: what lies in them, and where lines of sight meet them."""

from math import cos, hypot, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.cells.revolution_kernels import MOST, crossings
from gaussiancad_core.cells.sight_lines import body_table
from gaussiancad_core.cells.surfaces_of_revolution import (
    ArcProfile,
    LineProfile,
    Profile,
    SurfaceOfRevolution,
)
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted

_COUNT = 161


@st.composite
def _lines(draw: st.DrawFn) -> LineProfile:
    low, length = draw(st.integers(0, 40)), draw(st.integers(2, 40))
    one = draw(st.integers(0, 30))
    other = draw(st.integers(0, 30).filter(lambda r: r != one))
    return LineProfile(float(low), float(low + length), float(one), float(other))


@st.composite
def _arcs(draw: st.DrawFn) -> ArcProfile:
    """Parts of spheres, and outer and inner parts of tori."""
    side = draw(st.sampled_from([1, -1]))
    radius = float(draw(st.integers(3, 20)))
    away = radius + draw(st.integers(1, 20)) if side < 0 else draw(st.integers(0, 30))
    middle = float(draw(st.integers(20, 60)))
    ends = sorted(draw(st.lists(st.integers(-10, 10), min_size=2, max_size=2, unique=True)))
    return ArcProfile(
        middle + ends[0] / 10.0 * radius,
        middle + ends[1] / 10.0 * radius,
        middle,
        float(away),
        radius,
        side,
    )


_SECTOR = st.tuples(st.floats(0.0, FULL_TURN), st.floats(0.2, pi))
_BODY = st.builds(
    SurfaceOfRevolution,
    st.sampled_from(Axis),
    st.tuples(st.floats(20.0, 60.0), st.floats(20.0, 60.0)),
    st.one_of(_lines(), _arcs()),
    st.one_of(st.none(), _SECTOR),
)


def _space(body: SurfaceOfRevolution, point: tuple[float, ...]) -> tuple[float, float, float]:
    """(angle-wise first and second of the axis's plane relative to the axis, z) of a point."""
    first, second = IN_PLANE[body.axis]
    return (
        point[first] - body.centre[0],
        point[second] - body.centre[1],
        point[body.axis.value],
    )


def _holds(body: SurfaceOfRevolution, point: tuple[float, ...]) -> bool:
    """The definition of a body in polar coordinates."""
    a, b, z = _space(body, point)
    if not body.profile.low < z < body.profile.high:
        return False
    below = hypot(a, b) < body.profile.radius(z)
    if body.sector is None:
        return below != _rounds_a_cylinder(body.profile)
    start, sweep = body.sector
    turned = (np.arctan2(b, a) - start) % FULL_TURN
    towards_axis = isinstance(body.profile, ArcProfile) and body.profile.side < 0
    return bool(turned < sweep and below == towards_axis)


def _rounds_a_cylinder(profile: Profile) -> bool:
    """Whether a profile is widest at one of its ends, and smooth there."""
    return (
        isinstance(profile, ArcProfile)
        and profile.side > 0
        and profile.z in (profile.low, profile.high)
    )


@pytest.mark.parametrize("normal", Axis)
@given(_BODY, st.floats(0.0, 80.0), st.floats(0.0, 80.0))
def test_crossings_part_what_is_held_from_what_is_not(
    normal: Axis, body: SurfaceOfRevolution, a: float, b: float
) -> None:
    depths = sorted(depth for depth, _ in body.crossings(normal, a, b))
    assert len(depths) % 2 == 0
    for depth in np.linspace(-30.0, 130.0, _COUNT) + 0.0137:
        if depths and min(abs(depth - at) for at in depths) < 1e-6:
            continue
        point = lifted(normal, a, b, float(depth))
        if _near_border(body, point):
            continue
        inside = sum(at < depth for at in depths) % 2 == 1
        assert inside == body.holds(point) == _holds(body, point)


@pytest.mark.parametrize("normal", Axis)
@given(_BODY, st.floats(0.0, 80.0), st.floats(0.0, 80.0))
def test_the_kernel_meets_them_at_the_same_places(
    normal: Axis, body: SurfaceOfRevolution, a: float, b: float
) -> None:
    depths, normals = np.empty(MOST), np.empty((MOST, 3))
    (row,) = body_table([body])
    count = crossings(row, normal.value, (a, b), (depths, normals))
    expected = sorted(body.crossings(normal, a, b))
    assert count == len(expected)
    found = sorted(zip(depths[:count].tolist(), map(tuple, normals.tolist()), strict=False))
    assert np.array([d for d, _ in found]) == pytest.approx(np.array([d for d, _ in expected]))
    for (_, item), (_, other) in zip(found, expected, strict=True):
        assert item == pytest.approx(other)


def _near_border(body: SurfaceOfRevolution, point: tuple[float, ...]) -> bool:
    """Whether rounding may decide on which side of the border a point lies."""
    a, b, z = _space(body, point)
    profile = body.profile
    if min(abs(z - profile.low), abs(z - profile.high)) < 1e-6:
        return True
    if profile.low < z < profile.high and abs(hypot(a, b) - profile.radius(z)) < 1e-6:
        return True
    angles = () if body.sector is None else (body.sector[0], sum(body.sector))
    return any(abs(a * sin(t) - b * cos(t)) < 1e-6 for t in angles)


@pytest.mark.parametrize("normal", Axis)
@given(_BODY, st.floats(0.0, 80.0), st.floats(0.0, 80.0))
def test_normals_are_those_of_the_border(
    normal: Axis, body: SurfaceOfRevolution, a: float, b: float
) -> None:
    profile = body.profile
    for depth, direction in body.crossings(normal, a, b):
        x, y, z = _space(body, lifted(normal, a, b, depth))
        r = hypot(x, y)
        if r < 1e-6:
            # An apex has no normal.
            continue
        assert np.hypot(np.hypot(*direction[:2]), direction[2]) == pytest.approx(1.0)
        if r < 0.1 or not profile.low + 0.01 < z < profile.high - 0.01:
            continue
        if abs(r - profile.radius(z)) > 1e-6:
            continue
        slope = (profile.radius(z + 1e-6) - profile.radius(z - 1e-6)) / 2e-6
        if abs(slope) > 1e3:
            continue
        expected = np.array([x / r, y / r, -slope]) / hypot(1.0, slope)
        flat = IN_PLANE[body.axis]
        found = np.array([direction[flat[0]], direction[flat[1]], direction[body.axis.value]])
        off_side = body.sector is not None and any(
            abs(x * sin(t) - y * cos(t)) < 1e-3 for t in (body.sector[0], sum(body.sector))
        )
        assert abs(found @ expected) == pytest.approx(1.0, abs=1e-5) or off_side


@given(st.one_of(_lines(), _arcs()), st.floats(0.01, 0.99))
def test_a_profile_has_its_radius_at_its_heights(profile: Profile, share: float) -> None:
    z = profile.low + share * (profile.high - profile.low)
    r = profile.radius(z)
    heights = profile.heights(r)
    if isinstance(profile, LineProfile) or abs(z - profile.z) < 0.99 * profile.radius_of_arc:
        assert min(abs(height - z) for height in heights) < 1e-6
    for height in heights:
        assert profile.low < height < profile.high
        assert profile.radius(height) == pytest.approx(r, abs=1e-6)
    assert profile.heights(r + 100.0) == []


@pytest.mark.parametrize("normal", Axis)
@given(_BODY)
def test_rims_are_the_outlines(normal: Axis, body: SurfaceOfRevolution) -> None:
    profile = body.profile
    rims = body.rims(normal)
    if normal is body.axis:
        radii = {profile.radius(profile.low), profile.radius(profile.high)}
        assert {curve.radius for curve, _ in rims} == {r for r in radii if r > 1e-3}
        for curve, (low, high) in rims:
            assert curve.centre == body.centre
            assert 0.0 <= low < high <= FULL_TURN + 1e-12
        sweep = FULL_TURN if body.sector is None else body.sector[1]
        stated = sum(high - low for _, (low, high) in rims)
        rounds = sum(profile.radius(z) > 1e-3 for z in (profile.low, profile.high))
        assert stated == pytest.approx(sweep * rounds)
        return
    if body.sector:
        assert rims == []
        return
    along = IN_PLANE[normal].index(body.axis.value)
    other = IN_PLANE[normal][1 - along]
    middle = body.centre[IN_PLANE[body.axis].index(other)]
    sides: dict[bool, list[float]] = {True: [], False: []}
    for curve, (low, high) in rims:
        for at in np.linspace(low, high, 21):
            point = curve.at(float(at))
            z, off = point[along], point[1 - along] - middle
            assert profile.low - 1e-6 <= z <= profile.high + 1e-6
            # Near its turning points an arc's radius changes without end.
            steep = not isinstance(profile, LineProfile) and (
                abs(z - profile.z) > 0.98 * profile.radius_of_arc
            )
            if not steep:
                assert abs(off) == pytest.approx(profile.radius(z), abs=1e-6)
            sides[off >= 0.0].append(z)
    if profile.radius(profile.low) > 1e-3 and profile.radius(profile.high) > 1e-3:
        for heights in sides.values():
            assert min(heights) == pytest.approx(profile.low, abs=1e-6)
            assert max(heights) == pytest.approx(profile.high, abs=1e-6)
