"""Cells of a plane, and the outlines of regions of them."""

from itertools import pairwise
from math import hypot, pi

import numpy as np
import pytest

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.features.loops import loops_of
from gaussiancad_core.features.plane_curves import Stretch, segment, supports_of
from gaussiancad_core.features.sketch_cells import Cells, edge_count
from gaussiancad_core.geometry.outline_edges import enclosed_area
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.whole_curves import Circle


def _polygon(*corners: Point) -> list[Stretch]:
    sides = [segment(*ends) for ends in pairwise([*corners, corners[0]])]
    return [side for side in sides if side is not None]


def _circle(centre: Point, radius: float) -> list[Stretch]:
    return [Stretch(Circle(centre, radius), 0.0, FULL_TURN)]


def _box(width: float, height: float) -> list[Stretch]:
    return _polygon((0.0, 0.0), (width, 0.0), (width, height), (0.0, height))


def _cells(stretches: list[Stretch]) -> Cells:
    return Cells(Arrangement(supports_of(stretches)))


def _area(cells: Cells, region: set[int]) -> float:
    return sum(enclosed_area(loop) for loop in loops_of(cells, region))


def _random_cells(seed: int) -> Cells:
    """A box of 60 by 40 with lines across it and circles in it."""
    lot = np.random.default_rng(seed)
    stretches = _box(60.0, 40.0)
    for low, high in lot.uniform(2.0, 58.0, (3, 2)):
        stretches += [line for line in [segment((low, 0.0), (high, 40.0))] if line is not None]
    for x, y, radius in lot.uniform((14.0, 14.0, 3.0), (46.0, 26.0, 12.0), (3, 3)):
        stretches += _circle((float(x), float(y)), float(radius))
    return _cells(stretches)


@pytest.mark.parametrize("seed", range(8))
def test_outlines_enclose_the_area_of_their_region(seed: int) -> None:
    cells = _random_cells(seed)
    inside = sorted(set(range(cells.count)) - {OUTSIDE})
    single = {cell: _area(cells, {cell}) for cell in inside}
    assert sum(single.values()) == pytest.approx(2400.0)
    lot = np.random.default_rng(seed)
    for _ in range(5):
        region = {cell for cell in inside if lot.random() < 0.5}
        assert _area(cells, region) == pytest.approx(sum(single[cell] for cell in region))
    points = lot.uniform((0.0, 0.0), (60.0, 40.0), (3000, 2))
    shares = np.bincount(cells.locate(points), minlength=cells.count) / len(points)
    for cell, area in single.items():
        assert shares[cell] == pytest.approx(area / 2400.0, abs=0.04)


@pytest.mark.parametrize("seed", range(8))
def test_outlines_are_closed_chains_of_edges(seed: int) -> None:
    cells = _random_cells(seed)
    for cell in set(range(cells.count)) - {OUTSIDE}:
        for loop in loops_of(cells, {cell}):
            for edge, after in zip(loop, [*loop[1:], loop[0]], strict=True):
                assert edge.end == after.start
                if edge.circle is not None:
                    for x, y in (edge.start, edge.end):
                        apart = hypot(x - edge.circle.centre[0], y - edge.circle.centre[1])
                        assert apart == pytest.approx(edge.circle.radius, abs=1e-6)


def test_the_outer_outline_is_counterclockwise_and_a_circle_is_one_edge() -> None:
    cells = _cells(_box(40.0, 20.0) + _circle((12.0, 10.0), 4.0) + _circle((28.0, 10.0), 5.0))
    plate = int(cells.locate(np.array([[1.0, 1.0]]))[0])
    outer, *holes = loops_of(cells, {plate})
    assert len(outer) == 4
    assert enclosed_area(outer) == pytest.approx(800.0)
    # The larger ones first.
    assert [hole[0].circle.radius for hole in holes] == [5.0, 4.0]
    for hole in holes:
        (edge,) = hole
        assert edge.is_circle and not edge.is_ccw
        assert enclosed_area(hole) == pytest.approx(-pi * edge.circle.radius**2)


def test_outlines_that_touch_in_a_corner_are_two() -> None:
    stretches = _box(10.0, 10.0) + _polygon((10.0, 10.0), (20.0, 10.0), (20.0, 20.0), (10.0, 20.0))
    cells = _cells(stretches)
    region = {int(cell) for cell in cells.locate(np.array([[5.0, 5.0], [15.0, 15.0]]))}
    assert [len(loop) for loop in loops_of(cells, region)] == [4, 4]
    assert _area(cells, region) == pytest.approx(200.0)


def test_pieces_that_go_on_in_each_other_are_one_edge() -> None:
    half = segment((20.0, 0.0), (20.0, 20.0))
    assert half is not None
    cells = _cells([*_box(40.0, 20.0), half])
    both = set(cells.locate(np.array([[10.0, 10.0], [30.0, 10.0]])).tolist())
    (loop,) = loops_of(cells, both)
    assert len(both) == 2
    assert len(loop) == edge_count(cells.border(both)) == 4


def test_what_is_enclosed_fills_a_ring() -> None:
    cells = _cells(_circle((0.0, 0.0), 10.0) + _circle((0.0, 0.0), 6.0))
    ring, core = cells.locate(np.array([[8.0, 0.0], [0.0, 0.0]])).tolist()
    assert cells.filled(frozenset({ring})) == {ring, core}
    assert cells.components({ring, core}) == [{ring, core}]
    assert _area(cells, {ring, core}) == pytest.approx(100.0 * pi)
