"""Lines that nearly meet, meet where their curves do."""

from math import pi

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sketch.closing_outlines import tidied
from gaussiancad_core.sketch.plan_regions import MOST_CELLS, OUTSIDE, find_regions
from gaussiancad_core.sketch.plane_lines import PlaneLine, arc_between, whole_circle


def _line(*points: tuple[float, float], visible: bool = True) -> PlaneLine:
    return PlaneLine(np.array(points, dtype=float), visible)


def _rectangle(gap: float) -> list[PlaneLine]:
    """Four sides of 20 x 10 that end so far before each corner."""
    corners = np.array([(0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0)])
    sides = zip(corners, np.roll(corners, -1, axis=0), strict=True)
    return [
        _line(*(one + gap * way, other - gap * way))
        for one, other in sides
        for way in [(other - one) / np.hypot(*(other - one))]
    ]


@pytest.mark.parametrize("gap", [0.0, 0.3, 0.9, -0.6])
def test_corners_close_where_sides_cross(gap: float) -> None:
    (item,) = find_regions(_rectangle(gap), [], 1.0).polygons
    assert item.area == pytest.approx(200.0, rel=1e-6)
    assert item.bounds == pytest.approx((0.0, 0.0, 20.0, 10.0), abs=1e-6)


def test_a_line_is_led_on_to_what_it_ends_before() -> None:
    across = _line((8.0, 0.7), (8.0, 9.2))
    first, second = find_regions([*_rectangle(0.2), across], [], 1.0).polygons
    assert sorted((first.area, second.area)) == pytest.approx([80.0, 120.0], rel=1e-3)


def test_three_quarters_about_one_centre_are_a_circle() -> None:
    circle = Circle((5.0, 5.0), 3.0)
    arcs = [
        PlaneLine(
            arc_between(circle, tuple(np.array(circle.at(at)) for at in (low, low + 1.9)), 1.9),
            True,
            circle,
        )
        for low in (0.0, 2.0, 4.0)
    ]
    (item,) = tidied(arcs, 0.1)
    assert item.is_closed
    assert item.circle.radius == pytest.approx(3.0)


def test_the_longer_way_round_an_arc_stays() -> None:
    circle = Circle((0.0, 0.0), 1.0)
    ends = np.array([1.0, 0.0]), np.array([0.0, 1.0])
    short, long = (arc_between(circle, ends, sweep) for sweep in (0.5 * pi, -1.5 * pi))
    assert short[len(short) // 2] == pytest.approx(np.array([1.0, 1.0]) / np.sqrt(2.0), abs=0.1)
    assert long[len(long) // 2] == pytest.approx(-np.array([1.0, 1.0]) / np.sqrt(2.0), abs=0.1)


def test_borders_know_how_they_are_drawn() -> None:
    hole = whole_circle(Circle((10.0, 5.0), 2.0), False)
    regions = find_regions([*_rectangle(0.0), hole], [], 0.1)
    between = next(border for border in regions.borders if border.other != OUTSIDE)
    assert between.length == pytest.approx(4.0 * pi, rel=1e-2)
    assert between.hidden == pytest.approx(between.length)
    assert between.visible == 0.0
    around = [border for border in regions.borders if border.other == OUTSIDE]
    assert sum(item.visible for item in around) == pytest.approx(60.0, rel=1e-2)
    assert regions.is_round.sum() == 1
    assert regions.is_inner.sum() == 1


def test_of_more_regions_than_are_chosen_from_none_are_told() -> None:
    def grid(count: int) -> list[PlaneLine]:
        inner = [20.0 * at / count for at in range(1, count)]
        return [*_rectangle(0.0), *(_line((at, 0.0), (at, 10.0)) for at in inner)]

    assert len(find_regions(grid(MOST_CELLS), [], 0.01).polygons) == MOST_CELLS
    assert find_regions(grid(MOST_CELLS + 1), [], 0.01) is None
