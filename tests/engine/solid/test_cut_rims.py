"""Ends and rims of rods that flats, walls or slanted planes cut."""

from collections.abc import Callable
from math import radians, tan

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import moved_to_origin
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import (
    box,
    cut,
    cylinder,
    edges_where,
    filleted,
    fuse,
    prism,
)


def _rod() -> TopoDS_Shape:
    """Upright, with the radius 10 and rims rounded by 2."""
    rod = cylinder(Axis.Z, (0, 0), 10, 0, 30)
    return filleted(rod, edges_where(rod, lambda start, end: abs(start[2] - end[2]) < 1.0), 2.0)


def _slice() -> TopoDS_Shape:
    """A rod between two flats: four arcs of its rims, none of which passes into a flat."""
    return cut(_rod(), box((-20, -20, -1), (20, -3, 31)), box((-20, 5, -1), (20, 20, 31)))


def _boss() -> TopoDS_Shape:
    """The smaller part of a rod on a wall."""
    half = cut(_rod(), box((-20, -20, -1), (20, 2, 31)))
    return fuse(half, box((-20, -8, -5), (20, 2, 35)))


@pytest.mark.parametrize("part", [_slice, _boss])
def test_a_rounded_rim_is_found_where_it_is_cut(
    part: Callable[[], TopoDS_Shape], drawn: Callable[[TopoDS_Shape], DrawnViews]
) -> None:
    solid = moved_to_origin(part())
    result = exact_solid(drawn(solid))
    assert result.status is Status.VERIFIED
    assert result.shape is not None
    assert same_solid(result.shape, solid)


@pytest.mark.parametrize("degrees", [-70, -50, -30, 50])
def test_a_slanted_end_is_seen_as_an_ellipse(
    degrees: float, drawn: Callable[[TopoDS_Shape], DrawnViews]
) -> None:
    # Half of the ellipse is outline; the plane's other half lies before or behind the rod.
    slope = tan(radians(degrees))
    low, high = 60.0 - 20.0 * slope, 60.0 + 20.0 * slope
    beyond = [(-20.0, low), (20.0, high), (20.0, 200.0), (-20.0, 200.0)]
    rod = cut(cylinder(Axis.Y, (0, 0), 10, 0, 100), prism(Axis.Z, beyond, -20, 20))
    solid = moved_to_origin(rod)
    result = exact_solid(drawn(solid))
    # Seen from above the slope faces the viewer: no line is hidden then.
    assert {code for code, _ in result.reasons} == ({"assumed"} if degrees < 0.0 else set())
    assert result.shape is not None
    assert same_solid(result.shape, solid)
