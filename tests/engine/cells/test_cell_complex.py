"""Cells along lines of sight."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.cells.cell_complex import BODY, CellComplex, parallel
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import axis_line
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted
from gaussiancad_core.model.views import Linetype

_NAMES = ("stepped-block", "counterbored-block", "wedge-block", "countersunk-plate", "ball-knob")
_SHARE = st.floats(-0.02, 1.02)


@pytest.fixture(scope="module", params=_NAMES)
def space(request: pytest.FixtureRequest, sample_views: Callable[[str], DrawnViews]) -> CellComplex:
    return model_part(sample_views(request.param)).space


@given(st.tuples(_SHARE, _SHARE, _SHARE))
def test_columns_of_all_axes_tell_the_cell_of_a_point(
    space: CellComplex, shares: tuple[float, float, float]
) -> None:
    ends = [space.values[axis] for axis in Axis]
    point = tuple(end[0] + s * (end[-1] - end[0]) for end, s in zip(ends, shares, strict=True))
    expected = space.cell_at(point)
    for normal in Axis:
        first, second = IN_PLANE[normal]
        column = space.column(normal, point[first], point[second])
        depth = point[normal.value]
        if any(abs(depth - crossing.depth) < 1e-4 for crossing in column):
            continue
        if any(abs(p - v) < 1e-4 for p, end in zip(point, ends, strict=True) for v in end):
            continue
        before = [crossing for crossing in column if crossing.depth < depth]
        assert (before[-1].after if before else None) == expected


@pytest.mark.parametrize("normal", Axis)
@given(_SHARE, _SHARE)
def test_a_column_goes_from_void_to_void_step_by_step(
    space: CellComplex, normal: Axis, one: float, other: float
) -> None:
    ends = [space.values[Axis(index)] for index in IN_PLANE[normal]]
    a, b = (
        end[0] + share * (end[-1] - end[0]) for end, share in zip(ends, (one, other), strict=True)
    )
    # What lies on a line may be told as either of its sides.
    if any(abs(p - v) < 1e-4 for p, end in zip((a, b), ends, strict=True) for v in end):
        return
    column = space.column(normal, a, b)
    if not column:
        return
    assert column[0].before is None and column[-1].after is None
    for crossing, following in pairwise(column):
        assert crossing.after == following.before
        assert crossing.depth <= following.depth
    for crossing in column:
        assert crossing.before != crossing.after
        assert np.linalg.norm(crossing.normal) == pytest.approx(1.0)
        # A surface seen edge-on in a plane has no normal along that plane's own axis.
        plane, _ = crossing.surface
        if plane != BODY:
            assert crossing.normal[plane] == 0.0 and plane != normal.value
    for crossing, following in pairwise(column):
        if following.depth - crossing.depth > 1e-3:
            middle = lifted(normal, a, b, (crossing.depth + following.depth) / 2.0)
            assert space.cell_at(middle) == crossing.after
    assert column is space.column(normal, a, b)


def test_values_are_ascending_and_start_at_the_origin(space: CellComplex) -> None:
    for axis in Axis:
        values = space.values[axis]
        assert values == sorted(values) and values[0] == pytest.approx(0.0, abs=1e-6)
        assert all(low + 1e-6 < high for low, high in pairwise(values))


def test_nothing_is_outside_of_the_box(space: CellComplex) -> None:
    for axis in Axis:
        for value in (space.values[axis][0] - 0.5, space.values[axis][-1] + 0.5):
            point = [10.0, 10.0, 10.0]
            point[axis.value] = value
            assert space.cell_at(tuple(point)) is None


def test_thickness_is_the_longest_stretch_in_the_thinnest_direction(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    planes = model_part(sample_views("stepped-block")).space.planes
    fresh = CellComplex(planes)
    assert fresh.thickness() == {}
    rng = np.random.default_rng(2)
    longest: dict[tuple[int, ...], dict[Axis, float]] = {}
    for a, b in rng.uniform(0.0, 60.0, (60, 2)):
        for normal in Axis:
            for crossing, following in pairwise(fresh.column(normal, a, b)):
                if crossing.after is not None:
                    length = following.depth - crossing.depth
                    item = longest.setdefault(crossing.after, {})
                    item[normal] = max(item.get(normal, 0.0), length)
    assert longest
    assert fresh.thickness() == {cell: min(entry.values()) for cell, entry in longest.items()}


def _drawn(role: Role, *sides: tuple[int, float, float, float]) -> list[Carrier]:
    """Lines on which a coordinate has a value, and between which values of the other one."""
    return [
        Carrier(axis_line(along, value), {role: (Interval(low, high, Linetype.VISIBLE, 1.0),)})
        for along, value, low, high in sides
    ]


def test_beside_the_corner_at_which_a_chain_ends_is_no_sliver_of_the_outside() -> None:
    # Seen from the right: under a bar the outline is a curve from the bar's lower side to the foot.
    lines = _drawn(
        Role.RIGHT,
        (1, 0.0, 0.0, 10.0),
        (0, 10.0, 0.0, 15.0),
        (1, 15.0, 0.0, 10.0),
        (0, 0.0, 10.0, 15.0),
        (1, 10.0, 0.0, 2.0),
    )
    chain = ((2.0, 10.0), (1.4, 5.0), (0.0, 0.0))
    box = ((0, 0.0, 0.0, 15.0), (0, 10.0, 0.0, 15.0), (1, 0.0, 0.0, 10.0), (1, 15.0, 0.0, 10.0))
    square = ((0, 0.0, 0.0, 10.0), (0, 10.0, 0.0, 10.0), (1, 0.0, 0.0, 10.0), (1, 10.0, 0.0, 10.0))
    space = CellComplex(
        {
            Axis.X: Arrangement(lines, [chain]),
            Axis.Y: Arrangement(_drawn(Role.FRONT, *box)),
            Axis.Z: Arrangement(_drawn(Role.TOP, *square)),
        }
    )
    inside = space.column(Axis.Z, 5.0, 2.5)
    neighbour = space.column(Axis.Z, 5.0, 2.0 - 2e-5)
    assert [round(crossing.depth, 6) for crossing in inside] == [0.0, 15.0]
    assert neighbour[0].depth == pytest.approx(0.0) and neighbour[-1].depth == pytest.approx(15.0)
    assert space.cell_at((5.0, 2.0 - 2e-5, 12.0)) in {crossing.after for crossing in neighbour}
    assert all(
        one.after is not None and one.after == two.before for one, two in pairwise(neighbour)
    )


def test_normals_are_parallel_either_way() -> None:
    assert parallel((0.0, 0.6, 0.8), (0.0, -0.6, -0.8))
    assert not parallel((0.0, 0.6, 0.8), (0.0, 0.8, 0.6))
