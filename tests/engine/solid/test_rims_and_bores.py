"""Rounded corners with bores at their centres, whose rims are rounded or chamfered."""

from collections.abc import Callable

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.same import same_solid
from sample_parts.modelling import (
    box,
    chamfered,
    cut,
    cylinder,
    edges_along,
    edges_where,
    filleted,
    fuse,
)

Broken = Callable[[TopoDS_Shape, list[TopoDS_Shape], float], TopoDS_Shape]


def _with_rim(solid: TopoDS_Shape, height: float, broken: Broken) -> TopoDS_Shape:
    """The solid with the edges of its upper side broken by 2."""
    edges = edges_where(solid, lambda start, end: min(start[2], end[2]) > height - 1e-6)
    return broken(solid, edges, 2.0)


def _plate(broken: Broken) -> TopoDS_Shape:
    corners = [(0, 0), (80, 0), (0, 50), (80, 50)]
    block = box((0, 0, 0), (80, 50, 12))
    plate = _with_rim(filleted(block, edges_along(block, Axis.Z, corners), 9), 12.0, broken)
    bores = [cylinder(Axis.Z, (x, y), 4, -1, 13) for x in (9, 71) for y in (9, 41)]
    return cut(plate, *bores)


def _eye(broken: Broken) -> TopoDS_Shape:
    bar = fuse(cylinder(Axis.Z, (15, 15), 15, 0, 10), box((15, 0, 0), (60, 30, 10)))
    return cut(_with_rim(bar, 10.0, broken), cylinder(Axis.Z, (15, 15), 7, -1, 11))


@pytest.mark.parametrize(
    ("part", "broken"), [(_plate, filleted), (_eye, filleted), (_eye, chamfered)]
)
def test_a_bore_in_a_rounded_corner_says_nothing_of_its_rim(
    part: Callable[[Broken], TopoDS_Shape],
    broken: Broken,
    drawn: Callable[[TopoDS_Shape], DrawnViews],
) -> None:
    solid = part(broken)
    result = exact_solid(drawn(solid))
    assert result.explains
    assert {code for code, _ in result.reasons} <= {"assumed"}
    assert same_solid(result.shape, solid)
