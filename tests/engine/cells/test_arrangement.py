"""The regions that drawn lines divide a plane into."""

import itertools
from math import hypot, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.cells.arrangement import CHAIN, OUTSIDE, Arrangement, distinct
from gaussiancad_core.cells.arrangement_kernels import locate, traces
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import (
    Circle,
    LineOrCircle,
    axis_line,
    line_through,
    meetings,
)
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

Point = tuple[float, float]


def _support(curve: LineOrCircle, *stretches: tuple[float, float]) -> Carrier:
    intervals = tuple(Interval(low, high, Linetype.VISIBLE, 1.0) for low, high in stretches)
    return Carrier(curve, {Role.FRONT: intervals})


def _segment(start: Point, end: Point) -> Carrier:
    line = line_through(start, end, 0.0)
    return _support(line, tuple(sorted((line.parameter(start), line.parameter(end)))))


def _ring(*corners: Point) -> list[Carrier]:
    return [_segment(a, b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]


def _circle(x: float, y: float, radius: float) -> Carrier:
    return _support(Circle((x, y), radius), (0.0, FULL_TURN))


def _grid(xs: list[float], ys: list[float]) -> list[Carrier]:
    upright = [_support(axis_line(0, x), (ys[0], ys[-1])) for x in xs]
    return upright + [_support(axis_line(1, y), (xs[0], xs[-1])) for y in ys]


_VALUES = st.lists(st.integers(0, 400), min_size=2, max_size=6, unique=True).map(
    lambda values: [value / 4.0 for value in sorted(values)]
)


@given(_VALUES, _VALUES)
def test_a_grid_has_a_region_for_each_field(xs: list[float], ys: list[float]) -> None:
    arrangement = Arrangement(_grid(xs, ys))
    assert arrangement.regions == (len(xs) - 1) * (len(ys) - 1) + 1
    found = set()
    for x0, x1 in itertools.pairwise(xs):
        for y0, y1 in itertools.pairwise(ys):
            inside = {
                arrangement.locate(x0 + s * (x1 - x0), y0 + t * (y1 - y0))
                for s in (0.01, 0.5, 0.99)
                for t in (0.01, 0.5, 0.99)
            }
            assert len(inside) == 1 and OUTSIDE not in inside
            found |= inside
    assert len(found) == arrangement.regions - 1
    for x, y in ((xs[0] - 1, ys[0]), (xs[-1] + 1, ys[0]), (xs[0], ys[-1] + 1), (xs[0], ys[0] - 1)):
        assert arrangement.locate(x, y) == OUTSIDE


_ROUND = st.tuples(st.integers(0, 60), st.integers(0, 60), st.integers(2, 30))


def _faces_by_euler(circles: list[Circle]) -> int:
    """Faces of circles in general position: E - V + C + 1, each circle at least a vertex."""
    points: list[Point] = []
    on: list[set[int]] = [set() for _ in circles]
    root = list(range(len(circles)))

    def find(item: int) -> int:
        while root[item] != item:
            item = root[item]
        return item

    for i, one in enumerate(circles):
        for j in range(i):
            for point in meetings(one, circles[j]):
                near = [
                    k
                    for k, p in enumerate(points)
                    if hypot(p[0] - point[0], p[1] - point[1]) < 1e-6
                ]
                if not near:
                    points.append(point)
                    near = [len(points) - 1]
                on[i].add(near[0])
                on[j].add(near[0])
                root[find(i)] = find(j)
    vertices = len(points) + sum(not item for item in on)
    edges = sum(max(1, len(item)) for item in on)
    components = len({find(i) for i in range(len(circles))})
    return edges - vertices + components + 1


@settings(max_examples=60)
@given(st.lists(_ROUND, min_size=1, max_size=5, unique=True))
def test_circles_have_as_many_regions_as_euler_says(rows: list[tuple[int, int, int]]) -> None:
    # Factors that no equations tie: circles cross or miss, and never just touch.
    circles = [
        Circle((x * 1.1 + k * 0.0371, y * 1.3 + k * 0.0513), r * 1.07 + k * 0.0297)
        for k, (x, y, r) in enumerate(rows)
    ]
    for i, one in enumerate(circles):
        for other in circles[:i]:
            away = hypot(one.centre[0] - other.centre[0], one.centre[1] - other.centre[1])
            near, far = abs(one.radius - other.radius), one.radius + other.radius
            if min(abs(away - near), abs(away - far)) < 0.01:
                return
    arrangement = Arrangement([_support(circle, (0.0, FULL_TURN)) for circle in circles])
    assert arrangement.regions == _faces_by_euler(circles)
    rng = np.random.default_rng(0)
    seen: dict[int, set[tuple[bool, ...]]] = {}
    for x, y in rng.uniform(-35, 120, (300, 2)):
        if min(circle.distance((x, y)) for circle in circles) < 1e-3:
            continue
        inside = tuple(hypot(x - c.centre[0], y - c.centre[1]) < c.radius for c in circles)
        seen.setdefault(arrangement.locate(x, y), set()).add(inside)
    # A region lies inside of one set of circles; the outside inside of none.
    assert all(len(sets) == 1 for sets in seen.values())
    assert (seen.get(OUTSIDE) or {(False,) * len(circles)}) == {(False,) * len(circles)}


@settings(max_examples=50)
@given(st.lists(st.floats(1.0, 20.0), min_size=3, max_size=9), st.floats(0.0, 1.0))
def test_locate_agrees_with_the_even_odd_test(radii: list[float], turn: float) -> None:
    count = len(radii)
    angles = [(k + turn) * FULL_TURN / count for k in range(count)]
    corners = [
        (30.0 + r * float(np.cos(t)), 30.0 + r * float(np.sin(t)))
        for r, t in zip(radii, angles, strict=True)
    ]
    ring = _ring(*corners)
    arrangement = Arrangement(ring)
    assert arrangement.regions == 2
    for x, y in np.random.default_rng(1).uniform(8.0, 52.0, (50, 2)):
        if min(_off(corners, k, (x, y)) for k in range(count)) < 1e-3:
            continue
        crossings = sum(
            (b0 > y) != (b1 > y) and x < a0 + (y - b0) / (b1 - b0) * (a1 - a0)
            for (a0, b0), (a1, b1) in zip(corners, [*corners[1:], corners[0]], strict=True)
        )
        assert (arrangement.locate(x, y) != OUTSIDE) == bool(crossings % 2)


def _off(corners: list[Point], k: int, point: Point) -> float:
    (a0, b0), (a1, b1) = corners[k - 1], corners[k]
    interval = np.array([a1 - a0, b1 - b0])
    share = np.clip((np.array(point) - (a0, b0)) @ interval / (interval @ interval), 0.0, 1.0)
    return float(np.hypot(*(np.array(point) - (a0, b0) - share * interval)))


_SHEET = [
    *_ring((0, 0), (100, 0), (100, 60), (0, 60)),
    _circle(30, 30, 12),
    _circle(30, 30, 20),
    _circle(50, 30, 12),
    _segment((60, 0), (100, 45)),
    _segment((60, 60), (90, 10)),
    _segment((60, 0), (60, 60)),
    _support(Circle((80, 60), 9.0), (pi, FULL_TURN)),
]


@pytest.fixture(scope="module")
def sheet() -> Arrangement:
    return Arrangement(_SHEET)


def test_a_mixed_sheet_has_as_many_regions_as_euler_says(sheet: Arrangement) -> None:
    vertices: list[Point] = []
    edges = 0
    for place, (index, low, high) in enumerate(sheet.stretches):
        curve = sheet.carriers[index].curve
        opened = not isinstance(curve, Circle) or high - low < FULL_TURN - 1e-9
        apart = [curve.at(low), curve.at(high)] if opened else []
        for other in range(len(sheet.stretches)):
            if other != place:
                apart += _shared(sheet, place, other)
        apart = _apart(apart)
        edges += len(apart) - opened
        vertices = _apart([*vertices, *apart])
    # All of it hangs together.
    assert sheet.regions == edges - len(vertices) + 2


def _shared(sheet: Arrangement, one: int, other: int) -> list[Point]:
    """The points that two drawn stretches share."""
    curves = [sheet.carriers[sheet.stretches[place][0]].curve for place in (one, other)]
    bounds = [sheet.stretches[place][1:] for place in (one, other)]
    return [
        point
        for point in meetings(*curves)
        if all(
            any(
                low - 1e-6 <= curve.parameter(point) + turn <= high + 1e-6 for turn in _turns(curve)
            )
            for curve, (low, high) in zip(curves, bounds, strict=True)
        )
    ]


def _turns(curve: LineOrCircle) -> tuple[float, ...]:
    return (0.0, FULL_TURN) if isinstance(curve, Circle) else (0.0,)


def _apart(points: list[Point]) -> list[Point]:
    kept: list[Point] = []
    for point in points:
        if all(hypot(point[0] - p[0], point[1] - p[1]) > 1e-6 for p in kept):
            kept.append(point)
    return kept


@pytest.mark.parametrize("coordinate", [0, 1])
@given(st.floats(-5.0, 105.0))
def test_traces_agree_with_locate(sheet: Arrangement, coordinate: int, value: float) -> None:
    if min(abs(value - corner[coordinate]) for corner in sheet.corners) < 1e-4:
        return
    trace = sheet.trace(coordinate, value)
    assert len(trace.regions) == len(trace.positions) + 1
    assert len(trace.normals) == len(trace.carriers) == len(trace.positions)
    assert list(trace.positions) == sorted(trace.positions)
    assert trace.regions[0] == trace.regions[-1] == OUTSIDE

    def point(at: float) -> Point:
        return (value, at) if coordinate == 0 else (at, value)

    for at, normal, index in zip(trace.positions, trace.normals, trace.carriers, strict=True):
        curve = sheet.carriers[index].curve
        assert curve.distance(point(at)) < 1e-9
        item = curve.normal(curve.parameter(point(at)))
        assert abs(item[0] * normal[0] + item[1] * normal[1]) == pytest.approx(1.0)
        assert hypot(*normal) == pytest.approx(1.0)
    bounds = [-20.0, *trace.positions, 130.0]
    for low, high, region in zip(bounds, bounds[1:], trace.regions, strict=False):
        if high - low > 1e-3:
            for share in (0.05, 0.5, 0.95):
                assert sheet.locate(*point(low + share * (high - low))) == region
    hits = {
        (index, round(p[1 - coordinate], 6))
        for index, low, high in sheet.stretches
        if sheet.carriers[index].curve.axis != coordinate
        for p in meetings(sheet.carriers[index].curve, axis_line(coordinate, value))
        if low <= sheet.carriers[index].curve.parameter(p) <= high
    }
    stated = {(s, round(p, 6)) for s, p in zip(trace.carriers, trace.positions, strict=True)}
    assert stated == hits


@pytest.mark.parametrize("coordinate", [0, 1])
@given(st.lists(st.integers(-5000, 105000).map(lambda x: x / 1000.0), min_size=1, max_size=5))
def test_the_kernels_tell_the_same_of_many_lines_and_points(
    sheet: Arrangement, coordinate: int, values: list[float]
) -> None:
    found = traces(sheet.table, coordinate, np.array(values))
    assert found.starts[0] == 0 and found.starts[-1] == len(found.positions)
    assert not found.chained.any()
    for number, value in enumerate(values):
        trace, item = sheet.trace(coordinate, value), slice(*found.starts[number : number + 2])
        assert tuple(found.positions[item]) == trace.positions
        assert tuple(map(tuple, found.normals[item])) == trace.normals
        assert tuple(found.carriers[item]) == trace.carriers
        assert (found.first[number], *found.regions[item]) == trace.regions
        for other in values:
            assert locate(sheet.table, value, other) == sheet.locate(value, other)


@given(st.tuples(st.floats(-0.3, 0.3), st.floats(-40.0, 40.0), st.floats(-40.0, 40.0)))
def test_regions_do_not_depend_on_where_the_sheet_lies(move: tuple[float, float, float]) -> None:
    angle, da, db = move
    cosine, sine = float(np.cos(angle)), float(np.sin(angle))

    def moved(a: float, b: float) -> Point:
        return cosine * a - sine * b + da, sine * a + cosine * b + db

    corners = [moved(*corner) for corner in ((0, 0), (60, 0), (60, 40), (0, 40))]
    inner = [moved(*corner) for corner in ((10, 10), (25, 10), (25, 30))]
    carriers = [*_ring(*corners), *_ring(*inner), _circle(*moved(42, 20), 10)]
    carriers.append(_segment(moved(42, 0), moved(42, 40)))
    arrangement = Arrangement(carriers)
    assert arrangement.regions == 6
    places = [(2, 2), (20, 15), (38, 20), (46, 20), (58, 2), (-5, 5)]
    found = [arrangement.locate(*moved(*place)) for place in places]
    assert len(set(found)) == 6 and found[-1] == OUTSIDE


def test_an_open_line_inside_divides_nothing() -> None:
    ring = _ring((0, 0), (10, 0), (10, 10), (0, 10))
    assert Arrangement([*ring, _segment((2, 2), (7, 8))]).regions == 2
    assert Arrangement([*ring, _segment((2, 2), (2, 8))]).regions == 2
    assert Arrangement([*ring, _segment((0, 2), (10, 8))]).regions == 3
    assert Arrangement([_segment((0, 2), (10, 8))]).regions == 1
    assert Arrangement([]).regions == 1
    assert Arrangement([]).locate(1.0, 2.0) == OUTSIDE
    assert Arrangement([]).trace(1, 2.0).regions == (OUTSIDE,)


def test_a_chain_parts_the_outside_from_the_part_and_nothing_else() -> None:
    three = [*_ring((0, 0), (10, 0), (10, 10), (0, 10))[:2], _segment((0, 0), (0, 10))]
    lid = ((0.0, 10.0), (4.0, 12.0), (10.0, 10.0))
    inner = ((0.0, 4.0), (6.0, 6.0), (10.0, 4.0))
    assert Arrangement(three).regions == 1
    closed = Arrangement(three, [lid])
    assert closed.regions == 2
    assert closed.locate(4.0, 11.0) != OUTSIDE and closed.locate(4.0, 12.1) == OUTSIDE
    assert closed.trace(0, 4.0).carriers[-1] == CHAIN
    assert Arrangement(three, [lid, inner]).regions == 2
    crossing = ((0.0, 9.0), (10.0, 12.0))
    both = Arrangement(three, [lid, crossing])
    assert both.locate(1.0, 10.3) != OUTSIDE
    # Between the two chains the space is open at its right side.
    assert both.locate(8.0, 11.2) == OUTSIDE


@pytest.mark.parametrize("lean", [1e-3, 1e-4, 1e-5, 1e-6, 1e-7])
def test_steep_walls_keep_the_outside_out(lean: float) -> None:
    ring = _ring((0, 0), (10, 0), (10 + lean, 50), (lean, 50))
    arrangement = Arrangement([*ring, _segment((5, 0), (5 + lean, 50))])
    assert arrangement.regions == 3
    assert arrangement.locate(2.0, 25.0) != arrangement.locate(8.0, 25.0)
    assert arrangement.locate(-2.0, 25.0) == arrangement.locate(12.0, 25.0) == OUTSIDE


@given(st.lists(st.integers(0, 30), max_size=20), st.floats(0.0, 2.9e-6))
def test_distinct_values_are_clusters_means(values: list[int], spread: float) -> None:
    found = distinct([v + s for v in values for s in (0.0, spread)])
    assert found == pytest.approx(sorted(v + spread / 2.0 for v in set(values)), abs=1e-9)


def test_a_slant_no_wider_than_a_rounding_error_is_upright() -> None:
    """Its ends have one first coordinate, as exact as numbers are."""
    steep = line_through((4.0, 2.0), (4.0 + 1e-5, 9.0), 0.0)
    speck = _support(steep, (1.0, 1.0 + 1e-11))
    plane = Arrangement([*_ring((0, 0), (10, 0), (10, 10), (0, 10)), speck])
    assert plane.regions == 2
