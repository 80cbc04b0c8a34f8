"""Smooth edges, not drawn, at which other lines end."""

from collections.abc import Callable
from math import sqrt

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
)
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt, gp_Vec
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import axis_line
from gaussiancad_core.hypotheses.undrawn_smooth_edges import with_smooth_edges
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.labelling.cell_labelling import Effort, Search
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.solid.boundary_building import build_solid
from gaussiancad_core.solid.labelled_cells import LabelledComplex

Draw = Callable[..., DrawnViews]


def _box(x: float, y: float, z: float, *size: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), *size).Solid()


def _padded(low: float, high: float) -> TopoDS_Shape:
    """A block of 40 x 20 x 30 mm, its lower front edge rounded by 10 mm but from low to high."""
    edge = gp_Ax2(gp_Pnt(0, 10, 10), gp_Dir(1, 0, 0))
    quarter = BRepAlgoAPI_Common(
        BRepPrimAPI_MakeCylinder(edge, 10.0, 40.0).Solid(), _box(0, 0, 0, 40, 10, 10)
    ).Shape()
    rounded = BRepAlgoAPI_Cut(_box(0, 0, 0, 40, 20, 30), _box(0, 0, 0, 40, 10, 10)).Shape()
    rounded = BRepAlgoAPI_Fuse(rounded, quarter).Shape()
    solid = BRepAlgoAPI_Fuse(rounded, _box(low, 0, 0, high - low, 10, 10)).Shape()
    unifier = ShapeUpgrade_UnifySameDomain(solid, True, True, False)
    unifier.Build()
    return unifier.Shape()


def test_a_pad_that_passes_smoothly_into_a_face_is_found(drawn: Draw) -> None:
    solid = _padded(15.0, 25.0)
    part = model_part(drawn(solid))
    labels = Search(part.rules, Effort()).best(relaxed=False).labels
    assert labels is not None
    built = build_solid(LabelledComplex(part.space, labels), part.carriers.scale)
    assert built.shape is not None
    assert volume(built.shape) == pytest.approx(volume(solid), rel=1e-7)


def _arm(upper: float, lower: float) -> TopoDS_Shape:
    """A web of 8 mm that touches two bosses, 50 mm apart, of 20 and 14 mm height."""
    bosses = [
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 20, 0), gp_Dir(0, 0, 1)), radius, high).Solid()
        for x, radius, high in ((20.0, upper, 20.0), (70.0, lower, 14.0))
    ]
    # The outline touches both circles at the same angle.
    cosine = (upper - lower) / 50.0
    sine = sqrt(1.0 - cosine**2)
    outline = BRepBuilderAPI_MakePolygon()
    for x, radius, side in (
        (20.0, upper, 1),
        (70.0, lower, 1),
        (70.0, lower, -1),
        (20.0, upper, -1),
    ):
        outline.Add(gp_Pnt(x + radius * cosine, 20.0 + side * radius * sine, 0.0))
    outline.Close()
    web = BRepBuilderAPI_MakeFace(outline.Wire(), True).Face()
    solid = BRepPrimAPI_MakePrism(web, gp_Vec(0, 0, 8)).Shape()
    for boss in bosses:
        solid = BRepAlgoAPI_Fuse(solid, boss).Shape()
    unifier = ShapeUpgrade_UnifySameDomain(solid, True, True, False)
    unifier.Build()
    return unifier.Shape()


@pytest.mark.parametrize("lower", [10.0, 13.0])
def test_a_web_that_touches_its_bosses_is_found(drawn: Draw, lower: float) -> None:
    solid = _arm(16.0, lower)
    part = model_part(drawn(solid))
    labels = Search(part.rules, Effort()).best(relaxed=True).labels
    assert labels is not None
    built = build_solid(LabelledComplex(part.space, labels), part.carriers.scale)
    assert built.shape is not None
    assert volume(built.shape) == pytest.approx(volume(solid), rel=1e-7)


def test_the_edge_between_two_open_ends_may_be_drawn_or_not(drawn: Draw) -> None:
    carriers = find_carriers(drawn(_padded(15.0, 25.0)))
    units = carriers.scale
    front = with_smooth_edges(carriers).planes[Axis.Y]
    (added,) = (s for s in front.carriers if s.curve == axis_line(1, 10.0 * units))
    (interval,) = added.intervals[Role.FRONT]
    assert (interval.low, interval.high) == pytest.approx((15.0 * units, 25.0 * units))
    assert interval.confidence == 0.0


def test_beyond_one_open_end_the_edge_goes_on_both_ways(drawn: Draw) -> None:
    carriers = find_carriers(drawn(_padded(0.0, 25.0)))
    units = carriers.scale
    front = with_smooth_edges(carriers).planes[Axis.Y]
    (added,) = (s for s in front.carriers if s.curve == axis_line(1, 10.0 * units))
    ends = sorted((interval.low, interval.high) for interval in added.intervals[Role.FRONT])
    assert [end for pair in ends for end in pair] == pytest.approx(
        [0.0, 25.0 * units, 25.0 * units, 40.0 * units]
    )


@pytest.mark.parametrize("name", ["l-bracket", "filleted-block", "slotted-link", "ball-knob"])
def test_nothing_is_added_where_no_line_ends_in_the_open(
    name: str, sample_views: Callable[[str], DrawnViews]
) -> None:
    plain = find_carriers(sample_views(name))
    assert with_smooth_edges(plain) == plain
