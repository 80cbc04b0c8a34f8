"""Every drawn line and circle is found once, as what it is, to a tenth of a pixel."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.tracing import shape_growth
from gaussiancad_core.sheet.tracing.ridges import RidgePoints, ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import Grown, GrowthRules, grow_shapes, warm_up

Sketch = Any
"""The class that the fixture gives."""

FULL = 2.0 * np.pi


def _grown(drawn: Sketch, width: float = 3.0) -> tuple[RidgePoints, list[Grown]]:
    ridges = ridge_points(drawn.weight, width)
    return ridges, grow_shapes(ridges, GrowthRules.of_width(width))


def _shapes(drawn: Sketch, width: float = 3.0) -> tuple[list[Line], list[Circle]]:
    geometries = [grown.geometry for grown in _grown(drawn, width)[1]]
    lines = [shape for shape in geometries if isinstance(shape, Line)]
    return lines, [shape for shape in geometries if isinstance(shape, Circle)]


def _away(line: Line, *points: tuple[float, float]) -> float:
    """The largest distance of some points from a line."""
    return float(line.distances(np.array(points, float)).max())


def _matched(circles: list[Circle], drawn: list[tuple[tuple[float, float], float]]) -> float:
    """The largest error of circles, found in any order, in px."""
    assert len(circles) == len(drawn)
    found = sorted(circles, key=lambda circle: circle.radius)
    true = sorted(drawn, key=lambda pair: pair[1])
    return max(
        max(*np.abs(np.array(circle.centre) - centre), abs(circle.radius - radius))
        for circle, (centre, radius) in zip(found, true, strict=True)
    )


@settings(max_examples=30, deadline=None)
@given(st.floats(0.0, np.pi), st.floats(-15.0, 15.0), st.floats(1.0, 8.0), st.floats(15.0, 60.0))
def test_a_line_is_found_once(
    sketch: Sketch, angle: float, shift: float, width: float, half: float
) -> None:
    way, normal = (
        np.array([np.cos(angle), np.sin(angle)]),
        np.array([-np.sin(angle), np.cos(angle)]),
    )
    middle = 80.0 + shift * normal
    half = max(half, 4.0 * width)
    start, end = tuple(middle - half * way), tuple(middle + half * way)
    lines, circles = _shapes(sketch(160, 160).line(start, end, width), width)
    assert (len(lines), len(circles)) == (1, 0)
    assert _away(lines[0], start, end) < 0.1
    assert np.hypot(*lines[0].direction) == pytest.approx(1.0)


@settings(max_examples=20, deadline=None)
@given(st.floats(0.0, np.pi), st.floats(1.0, 3.0), st.floats(6.0, 14.0), st.floats(3.0, 6.0))
def test_a_dashed_line_is_one(
    sketch: Sketch, angle: float, width: float, dash: float, gap: float
) -> None:
    way = np.array([np.cos(angle), np.sin(angle)])
    start, end = tuple(80.0 - 60.0 * way), tuple(80.0 + 60.0 * way)
    ridges, grown = _grown(sketch(160, 160).broken(start, end, (dash, gap), width), width)
    assert len(grown) == 1
    # The ridge of a dash bends at its ends, which it has many of.
    assert _away(grown[0].geometry, start, end) < 0.3
    # All of its dashes, from the first to the last.
    along, _ = grown[0].geometry.coordinates(ridges.points[grown[0].members])
    assert np.ptp(along) > 120.0 - dash - gap - 4.0
    assert len(grown[0].members) > 0.95 * len(ridges.points)


def test_a_gap_wider_than_the_rules_is_not_crossed(sketch: Sketch) -> None:
    for gap, found in ((12.0, 1), (20.0, 2)):
        drawn = sketch().line((20, 60), (80, 60)).line((80 + gap, 60), (180, 60))
        ridges = ridge_points(drawn.weight, 3.0)
        grown = grow_shapes(ridges, GrowthRules())
        long = [item for item in grown if len(item.members) < 110]
        assert len(grown) == found
        assert len(long) == (2 if found == 2 else 0)


@pytest.mark.parametrize("angle", [0.0, 12.0, 33.0, 90.0, 131.0])
@pytest.mark.parametrize("gap", [4.0, 5.0, 8.0])
def test_lines_side_by_side_are_two(sketch: Sketch, angle: float, gap: float) -> None:
    way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    normal = np.array([-way[1], way[0]])
    ends = [
        [tuple(80.0 + side * gap / 2 * normal + along * way) for along in (-60.0, 60.0)]
        for side in (-1, 1)
    ]
    drawn = sketch(160, 160).line(*ends[0], 2.0).line(*ends[1], 2.0)
    lines, circles = _shapes(drawn, 2.0)
    assert (len(lines), len(circles)) == (2, 0)
    # Smoothing draws them towards each other by as much as they share.
    most = 0.3 if gap < 5.0 else 0.1
    errors = [[_away(line, *pair) for line in lines] for pair in ends]
    assert [min(row) for row in errors] == pytest.approx([0.0, 0.0], abs=most)
    assert np.argmin(errors[0]) != np.argmin(errors[1])


@settings(max_examples=25, deadline=None)
@given(st.floats(75.0, 85.0), st.floats(75.0, 85.0), st.floats(6.0, 65.0), st.floats(1.0, 3.0))
def test_a_circle_is_found_once(
    sketch: Sketch, x: float, y: float, radius: float, width: float
) -> None:
    lines, circles = _shapes(sketch(160, 160).arc((x, y), radius, width), width)
    assert (len(lines), len(circles)) == (0, 1)
    assert circles[0].centre == pytest.approx((x, y), abs=0.05)
    # A bent stroke's ridge lies inside of its middle.
    sigma = max(1.1, 0.42 * width)
    assert circles[0].radius + sigma**2 / (2 * circles[0].radius) == pytest.approx(radius, abs=0.05)


@pytest.mark.parametrize(
    ("radius", "dash", "gap"), [(50, 12, 6), (30, 9, 4), (20, 8, 4), (60, 6, 6)]
)
def test_a_dashed_circle_is_one(sketch: Sketch, radius: float, dash: float, gap: float) -> None:
    drawn = sketch(160, 160)
    count = round(FULL * radius / (dash + gap))
    for k in range(count):
        drawn.arc((80.3, 79.7), radius, 2.0, k * FULL / count, FULL / count * dash / (dash + gap))
    lines, circles = _shapes(drawn, 2.0)
    assert lines == []
    assert _matched(circles, [((80.3, 79.7), radius)]) < 0.1


def test_concentric_circles(sketch: Sketch) -> None:
    centre = (90.3, 80.6)
    drawn = sketch()
    radii = (8.0, 14.0, 30.0, 44.0, 50.0, 70.0)
    for radius in radii:
        drawn.arc(centre, radius, 2.0)
    lines, circles = _shapes(drawn, 2.0)
    assert lines == []
    assert _matched(circles, [(centre, radius) for radius in radii]) < 0.12


@pytest.mark.parametrize("sweep", [40, 60, 90, 135, 180, 270])
@pytest.mark.parametrize("radius", [25.0, 40.0, 70.0])
def test_an_arc_is_its_circle(sketch: Sketch, radius: float, sweep: float) -> None:
    angles = np.radians(25.0 + np.linspace(0.0, sweep, 50))
    points = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    middle = np.array([100.0, 80.0]) - points.mean(0)
    drawn = sketch().arc(tuple(middle), radius, 2.0, angles[0], np.radians(sweep))
    _, circles = _shapes(drawn, 2.0)
    assert len(circles) == 1
    assert circles[0].distances(middle + points).max() < 0.2
    if sweep >= 90:
        # What turns less says little of its radius.
        assert circles[0].centre == pytest.approx(tuple(middle), abs=0.3)
        assert circles[0].radius == pytest.approx(radius, abs=0.3)


def test_the_corners_of_a_box_bend_no_line(sketch: Sketch) -> None:
    corners = ((30.0, 30.0), (160.0, 30.0), (160.0, 120.0), (30.0, 120.0))
    lines, circles = _shapes(sketch().lines(*corners, corners[0]))
    assert circles == []
    assert len(lines) == 4
    for k in range(4):
        side = (corners[k], corners[(k + 1) % 4])
        assert min(_away(line, *side) for line in lines) < 0.1


def test_crossings_bend_no_line(sketch: Sketch) -> None:
    """Two solid lines, a dashed one and a circle across each other."""
    drawn = sketch().line((20, 30), (180, 90)).line((100, 10), (60, 150))
    drawn.broken((10, 80), (190, 80), (12, 6), 3.0).arc((110, 75), 40.0)
    lines, circles = _shapes(drawn)
    assert len(lines) == 3
    for ends in (((20, 30), (180, 90)), ((100, 10), (60, 150)), ((10, 80), (190, 80))):
        assert min(_away(line, *ends) for line in lines) < 0.1
    # Where three strokes cross, the blot may look like a small arc: the ink decides that later.
    large = [circle for circle in circles if circle.radius > 8.0]
    assert _matched(large, [((110, 75), 40.0)]) < 0.1


def test_a_slot_is_two_lines_and_two_arcs(sketch: Sketch) -> None:
    quarter = np.pi / 2
    drawn = sketch().line((60, 50), (140, 50)).line((60, 110), (140, 110))
    drawn.arc((60, 80), 30, 3.0, quarter, np.pi).arc((140, 80), 30, 3.0, -quarter, np.pi)
    lines, circles = _shapes(drawn)
    assert len(lines) == 2
    assert min(_away(line, (60, 50), (140, 50)) for line in lines) < 0.1
    assert min(_away(line, (60, 110), (140, 110)) for line in lines) < 0.1
    # The first px of a tangent are as near to the arc as to the tangent.
    assert sorted(circle.centre[0] for circle in circles) == pytest.approx([60, 140], abs=0.25)
    assert [circle.radius for circle in circles] == pytest.approx([30, 30], abs=0.15)


def _rounded(sketch: Sketch, radius: float) -> Sketch:
    """A box of 180 x 140 px with rounded corners."""
    x0, y0, x1, y1, r = 30.0, 30.0, 210.0, 170.0, radius
    drawn = sketch(240, 200)
    drawn.line((x0 + r, y0), (x1 - r, y0)).line((x0 + r, y1), (x1 - r, y1))
    drawn.line((x0, y0 + r), (x0, y1 - r)).line((x1, y0 + r), (x1, y1 - r))
    for k, corner in enumerate(((x1, y1), (x0, y1), (x0, y0), (x1, y0))):
        centre = (min(max(corner[0], x0 + r), x1 - r), min(max(corner[1], y0 + r), y1 - r))
        drawn.arc(centre, r, 3.0, k * np.pi / 2, np.pi / 2)
    return drawn


def test_rounded_corners(sketch: Sketch) -> None:
    """Lines exactly; an arc between two tangents, whose first px follow it as well, roughly."""
    radius = 30.0
    lines, circles = _shapes(_rounded(sketch, radius))
    assert len(lines) == 4
    sides = (((90, 30), (150, 30)), ((90, 170), (150, 170)), ((30, 90), (30, 110)))
    for ends in (*sides, ((210, 90), (210, 110))):
        assert min(_away(line, *ends) for line in lines) < 0.1
    assert len(circles) == 4
    for centre in (
        (x, y) for x in (30 + radius, 210 - radius) for y in (30 + radius, 170 - radius)
    ):
        errors = [np.hypot(*np.subtract(circle.centre, centre)) for circle in circles]
        assert min(errors) < 1.8
        assert circles[int(np.argmin(errors))].radius == pytest.approx(radius, abs=1.5)


def test_every_shape_has_points_of_its_own_near_it(sketch: Sketch) -> None:
    drawn = sketch().lines((30, 30), (160, 30), (160, 120), (30, 120), (30, 30)).arc((95, 75), 30)
    ridges, grown = _grown(drawn)
    rules = GrowthRules.of_width(3.0)
    for item in grown:
        assert len(np.unique(item.members)) == len(item.members) >= rules.shortest
        assert item.geometry.distances(ridges.points[item.members]).max() < 1.4
    explained = np.unique(np.concatenate([entry.members for entry in grown]))
    assert len(explained) > 0.97 * len(ridges.points)


def test_growth_is_the_same_every_time(sketch: Sketch) -> None:
    drawn = sketch().line((20, 30), (180, 90)).arc((110, 75), 40.0).arc((60, 110), 12.0, 2.0)
    noise = np.random.default_rng(1).normal(0.0, 0.05, drawn.weight.shape)
    drawn.weight = np.clip(drawn.weight + noise, 0.0, 1.0).astype(np.float32)
    (_, first), (_, second) = _grown(drawn), _grown(drawn)
    assert [item.geometry for item in first] == [item.geometry for item in second]
    for one, other in zip(first, second, strict=True):
        assert np.array_equal(one.members, other.members)
    sizes = {Line: 0, Circle: 0}
    for entry in first:
        if len(entry.members) > 40:
            sizes[type(entry.geometry)] += 1
    assert sizes == {Line: 1, Circle: 2}


def test_the_strongest_come_first(sketch: Sketch) -> None:
    drawn = sketch().line((20, 30), (180, 30)).line((20, 60), (90, 60)).line((20, 90), (50, 90))
    grown = _grown(drawn)[1]
    assert [round(item.geometry.point[1]) for item in grown] == [30, 60, 90]


def test_no_points_no_shapes(sketch: Sketch) -> None:
    assert _grown(sketch())[1] == []
    warm_up()
    dot = sketch()
    dot.weight[50, 50] = 1.0
    assert _grown(dot)[1] == []


def test_rules_follow_the_width() -> None:
    assert GrowthRules.of_width(2.0) == GrowthRules()
    wide = GrowthRules.of_width(8.0)
    assert (wide.gap, wide.band) == pytest.approx((40.0, 1.6))


@pytest.mark.parametrize("radius", [122.6, 150.9, 284.0, 291.0])
def test_dashes_of_a_large_circle_are_no_chords(sketch: Sketch, radius: float) -> None:
    """A line along one dash explains ends of its neighbours, too; it is still no line."""
    dash, gap, middle = 17.25, 9.75, radius + 20.0
    count = round(FULL * radius / (dash + gap))
    drawn = sketch(int(2 * middle), int(2 * middle))
    for k in range(count):
        start, sweep = FULL * k / count, FULL / count * dash / (dash + gap)
        drawn.arc((middle, middle), radius, 3.0, start, sweep)
    lines, circles = _shapes(drawn)
    assert lines == []
    assert _matched(circles, [((middle, middle), radius)]) < 0.1


def test_a_line_that_an_arrowhead_bends_is_straight(sketch: Sketch) -> None:
    """The tip beside the end of a short extension line moves a few points of its ridge."""
    drawn = sketch(120, 120).line((80.0, 40.0), (80.0, 72.0), 1.5)
    drawn.line((20.0, 45.0), (80.0, 45.0), 1.5)
    for half in np.arange(0.2, 2.2, 0.2).tolist():
        drawn.line((80.0 - 5.0 * half, 45.0 - half), (80.0 - 5.0 * half, 45.0 + half), 1.5)
    lines, _ = _shapes(drawn, 2.0)
    upright = [line for line in lines if abs(line.direction[1]) > 0.99]
    assert len(upright) == 1
    assert _away(upright[0], (80.0, 60.0), (80.0, 70.0)) < 0.3


def test_a_dashed_line_that_runs_into_tangents_is_no_arc(sketch: Sketch) -> None:
    """At both ends round edges bend away to the same side; the true radii are found as well."""
    drawn = sketch(360, 160).broken((104.0, 120.0), (275.0, 120.0), (12.0, 6.5), 2.0)
    drawn.arc((70.0, -10.0), 130.0, 2.0, 0.5 * np.pi - 0.4, 0.3)
    drawn.arc((288.0, -10.0), 130.0, 3.0, 0.5 * np.pi - 0.25, 0.55)
    lines, circles = _shapes(drawn, 2.2)
    assert any(_away(line, (120.0, 120.0), (260.0, 120.0)) < 0.5 for line in lines)
    assert [circle.radius for circle in circles] == pytest.approx([130.0] * len(circles), abs=2.0)


@pytest.mark.parametrize("step", [0.45, 0.55])
def test_an_edge_and_its_extension_line_half_a_pixel_apart_are_straight(
    sketch: Sketch, step: float
) -> None:
    drawn = sketch(900, 100).line((20, 50), (700, 50), 5.0)
    drawn.line((700, 50 + step), (880, 50 + step), 5.0)
    lines, circles = _shapes(drawn, 5.0)
    assert not circles
    assert lines
    ridges, grown = _grown(drawn, 5.0)
    on_lines = np.unique(np.concatenate([one.members for one in grown]))
    assert len(on_lines) > 0.95 * len(ridges.points)


@pytest.mark.parametrize(("radius", "length"), [(34.0, 30.0), (82.0, 30.0), (160.0, 41.0)])
def test_a_short_line_between_a_corner_and_an_arc_that_it_touches_is_found(
    sketch: Sketch, radius: float, length: float
) -> None:
    low, left = 230.0, 30.0
    middle = left + length, low - radius
    drawn = sketch(280, 260).line((left, 20.0), (left, low), 2.0)
    drawn = drawn.line((left, low), (left + length, low), 2.0)
    drawn = drawn.arc(middle, radius, 2.0, 0.0, np.pi / 2.0)
    lines, circles = _shapes(drawn, 2.0)
    aways = [_away(line, (left + 4.0, low), (left + length - 4.0, low)) for line in lines]
    assert min(aways) < 0.3
    assert min(abs(circle.radius - radius) for circle in circles) < 0.02 * radius
    assert len(lines) == 2


def test_an_arc_that_is_left_without_points_is_none(
    sketch: Sketch, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On blurred copies the points of an arc may all be too far off once it is fitted."""
    found = np.array([[50.0, 50.0, 30.0]]), np.array([0, 0]), np.empty(0, dtype=np.int64)
    monkeypatch.setattr(shape_growth, "grow_arcs", lambda *_: found)
    lines, circles = _shapes(sketch().line((20, 50), (180, 50), 3.0))
    assert len(lines) == 1
    assert not circles


@pytest.mark.parametrize("off", [0.0, 0.25, 0.5, 0.75])
def test_a_line_between_flat_meetings_is_found(sketch: Sketch, off: float) -> None:
    """It is followed into a level line at one end and into a steeper one at the other."""
    low, high, corner = (20.0, 120.0 + off), (120.0, 107.5 + off), (220.0, 120.0 + off)
    drawn = sketch(260, 140).lines(low, high, corner, low, width=2.6)
    drawn.line(corner, (corner[0], 20.0), 2.6).lines(
        (33.0, 70.0 + off), high, (207.0, 70.0 + off), corner, width=2.6
    )
    lines, _ = _shapes(drawn, 2.6)
    for end in (low, corner):
        assert [_away(line, end, high) < 0.8 for line in lines].count(True) == 1


def test_more_lines_than_any_drawing_has_end_the_growth(
    sketch: Sketch, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = sketch(160, 160)
    for at in range(10, 150, 10):
        drawn = drawn.line((10.0, float(at)), (150.0, float(at)), 3.0)
    lines, _ = _shapes(drawn)
    assert len(lines) == 14
    for name, most in (("_MOST_LINES", 13), ("_MOST_MEMBERS", 1_000)):
        with monkeypatch.context() as context:
            context.setattr(shape_growth, name, most)
            with pytest.raises(NoModelError, match="too many") as stated:
                _shapes(drawn)
            assert stated.value.code == "part-too-complex"


def test_members_of_lines_count_as_those_of_other_shapes(sketch: Sketch) -> None:
    drawn = sketch(160, 160).line((10.0, 20.0), (150.0, 60.0), 3.0)
    drawn = drawn.line((10.0, 60.0), (150.0, 20.0), 3.0)
    ridges, shapes = _grown(drawn)
    for shape, worth in zip(shapes, shape_growth._worth(shapes, ridges.points), strict=True):
        away = shape.geometry.distances(ridges.points[shape.members])
        assert np.allclose(worth, shape_growth._closeness(away))
