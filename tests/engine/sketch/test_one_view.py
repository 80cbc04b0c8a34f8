"""Sheets of one view: plates of a thickness, and what is turned about an axis of the view."""

from dataclasses import replace

import pytest
import shapely
from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Shape
from sketch_checks import GRID, check, drawn

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.lines.cut_solids import section_view
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.section_planes import Cut, CutRegion
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.modelling import box, cut, cylinder, fuse, revolved

MIDDLE = (20.0, 20.0)


def plate() -> TopoDS_Shape:
    """6 mm thick, with a round end, a slot and two holes."""
    body = fuse(box((0, 0, 0), (60, 6, 40)), cylinder(Axis.Y, (60, 20), 20, 0, 6))
    slot = fuse(
        box((20, -1, 17), (40, 7, 23)),
        cylinder(Axis.Y, (20, 20), 3, -1, 7),
        cylinder(Axis.Y, (40, 20), 3, -1, 7),
    )
    holes = [cylinder(Axis.Y, (10, at), 4, -1, 7) for at in (8, 32)]
    return cut(body, slot, *holes)


def shaft() -> TopoDS_Shape:
    """Shoulders, a slope and a rounded end."""
    profile = [(0, 0), (0, 8), (20, 8), (20, 20), (35, 20), (50, 12), (80, 12), (80, 0)]
    return revolved(profile, Axis.X, MIDDLE)


def bush() -> TopoDS_Shape:
    """A flange, and a bore in steps with a chamfer at its end."""
    profile = [(0, 14), (0, 20), (8, 20), (8, 16), (60, 16), (60, 11), (58, 9), (20, 9), (20, 14)]
    return revolved([*profile, (0, 14)], Axis.X, MIDDLE)


def turned(shape: TopoDS_Shape, *, hidden: bool) -> DrawnViews:
    return replace(drawn(shape, (Role.FRONT,), hidden=hidden), about=Axis.X)


@pytest.mark.parametrize("role", [Role.FRONT, Role.REAR])
def test_a_plate_is_as_thick_as_is_known(role: Role) -> None:
    truth = plate()
    found = sketch(drawn(truth, (role,), hidden=False), GRID)
    assert [(slab.low, slab.high) for slab in found.slabs] == [(0.0, 6.0)]
    check(found, truth)


def test_a_ring_of_a_plate_is_a_countersink() -> None:
    sink = revolved([(-1, 0), (-1, 9), (4, 4), (4, 0)], Axis.Y, (20, 20))
    truth = cut(box((0, 0, 0), (60, 6, 40)), cylinder(Axis.Y, (20, 20), 4, -1, 7), sink)
    check(sketch(drawn(truth, (Role.FRONT,), hidden=False), GRID), truth)


def test_a_note_tells_how_deep_a_hole_of_a_plate_is() -> None:
    truth = cut(plate(), cylinder(Axis.Y, (60, 20), 7, -1, 2.5))
    views = drawn(truth, (Role.FRONT,), hidden=False)
    noted = NotedHole(Role.FRONT, (60.0, 20.0), (HoleStep(14.0, 2.5),))
    check(sketch(replace(views, holes=(noted,)), GRID), truth)


@pytest.mark.parametrize("hidden", [False, True])
def test_a_shaft_is_turned_about_the_axis(hidden: bool) -> None:
    truth = shaft()
    found = sketch(turned(truth, hidden=hidden), GRID)
    assert found.axis is Axis.X
    check(found, truth)


def test_a_view_that_is_turned_about_an_upright_axis() -> None:
    profile = [(0, 0), (0, 8), (20, 8), (20, 20), (40, 20), (50, 12), (80, 12), (80, 0)]
    truth = revolved(profile, Axis.Z, MIDDLE)
    views = replace(drawn(truth, (Role.FRONT,), hidden=True), about=Axis.Z)
    check(sketch(views, GRID), truth)


def test_hidden_lines_of_a_shaft_are_its_bores() -> None:
    drill = revolved([(81, 0), (81, 6), (60, 6), (57, 0)], Axis.X, MIDDLE)
    truth = cut(shaft(), drill, cylinder(Axis.X, MIDDLE, 5, -1, 15))
    check(sketch(turned(truth, hidden=True), GRID), truth)


def test_a_note_tells_a_bore_that_is_not_drawn() -> None:
    truth = cut(shaft(), cylinder(Axis.X, MIDDLE, 4, -1, 81))
    noted = NotedHole(Role.RIGHT, MIDDLE, (HoleStep(8.0, None),))
    check(sketch(replace(turned(truth, hidden=False), holes=(noted,)), GRID), truth)


def test_a_circle_of_a_shaft_is_a_hole_across_it() -> None:
    truth = cut(shaft(), cylinder(Axis.Y, (65, 20), 4, -1, 41))
    noted = NotedHole(Role.FRONT, (65.0, 20.0), (HoleStep(8.0, None),))
    check(sketch(replace(turned(truth, hidden=False), holes=(noted,)), GRID), truth)


@pytest.mark.parametrize("half", [False, True])
def test_a_section_of_a_bush_tells_its_bore(half: bool) -> None:
    truth = bush()
    upper = shapely.box(-1e3, 20.0, 1e3, 1e3) if half else None
    openings = (CutRegion(20.0, upper),)
    section = section_view(truth, Role.FRONT, openings)
    views = turned(truth, hidden=False)
    found = sketch(
        replace(
            views,
            strokes={Role.FRONT: tuple(section.strokes)},
            cuts={Role.FRONT: Cut(openings, section.areas)},
        ),
        GRID,
    )
    check(found, truth)
    (slope,) = found.slopes
    assert slope.is_bore
    assert sorted([tuple(slope.small), tuple(slope.large)]) == [
        pytest.approx((58, 9)),
        pytest.approx((60, 11)),
    ]


def test_a_bore_that_slopes_is_turned_out_of_three_views() -> None:
    cone = revolved([(-1, 0), (-1, 7), (25, 5), (25, 0)], Axis.X, MIDDLE)
    truth = cut(shaft(), cylinder(Axis.X, MIDDLE, 5, -1, 81), cone)
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    check(sketch(drawn(truth, roles, hidden=True), GRID), truth)


@pytest.mark.parametrize("tip", [0, 5])
def test_a_bore_ends_in_a_tip_or_in_a_dome(tip: int) -> None:
    bore = cylinder(Axis.X, MIDDLE, 5, 60, 81)
    if tip:
        bore = fuse(bore, BRepPrimAPI_MakeSphere(gp_Pnt(60, 20, 20), tip).Shape())
    else:
        bore = fuse(bore, revolved([(60, 0), (60, 5), (57, 0)], Axis.X, MIDDLE))
    truth = cut(shaft(), bore)
    check(sketch(turned(truth, hidden=True), GRID), truth)
