"""What no slab is: sunk rims, and edges that are broken."""

from collections.abc import Callable

import pytest
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Shape
from sketch_checks import GRID, check, drawn

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import bounding_box, faces_of, soundness, subshapes
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.modelling import box, cut, cylinder, fuse


def broken_top(
    shape: TopoDS_Shape, maker: BRepFilletAPI_MakeChamfer | BRepFilletAPI_MakeFillet, size: float
) -> TopoDS_Shape:
    """A shape with all edges of its highest face broken."""
    top = max(faces_of(shape), key=lambda face: bounding_box(face)[0, 2])
    for edge in subshapes(top, TopAbs_ShapeEnum.TopAbs_EDGE):
        maker.Add(size, TopoDS.Edge(edge))
    return maker.Shape()


def bored() -> TopoDS_Shape:
    plate = box((0, 0, 0), (60, 40, 8))
    return cut(plate, cylinder(Axis.Z, (20, 20), 4, -1, 9))


@pytest.mark.parametrize("hidden", [False, True])
def test_a_ring_around_a_hole_of_which_nothing_tells_a_depth_is_a_countersink(hidden: bool) -> None:
    sink = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(20, 20, 5), gp_Dir(0, 0, 1)), 4.0, 7.0, 3.0).Shape()
    truth = cut(bored(), sink)
    views = drawn(truth, hidden=False)
    found = sketch(views, GRID)
    (rim,) = found.choice.sunk
    assert (rim.is_top, rim.ring.outer, rim.ring.inner) == (
        True,
        pytest.approx(7.0, rel=1e-3),
        pytest.approx(4.0, rel=1e-3),
    )
    check(found, truth)
    if hidden:
        # A depth that is drawn makes the same ring a counterbore.
        deep = cut(bored(), cylinder(Axis.Z, (20, 20), 7, 5, 9))
        stepped = sketch(drawn(deep, hidden=True), GRID)
        assert not stepped.choice.sunk
        check(stepped, deep)


@pytest.mark.parametrize("kind", ["chamfer", "rounding"])
def test_broken_edges_of_a_face_are_put_on_last(kind: str) -> None:
    block = fuse(box((0, 0, 0), (60, 40, 8)), box((20, 10, 8), (44, 30, 20)))
    make = BRepFilletAPI_MakeChamfer if kind == "chamfer" else BRepFilletAPI_MakeFillet
    truth = broken_top(block, make(block), 1.5)
    found = sketch(drawn(truth, hidden=False), GRID)
    assert found.axis is Axis.Z
    assert [slab.high for slab in found.slabs] == pytest.approx([8, 20])
    assert {this_break.is_round for this_break in found.breaks} == {kind == "rounding"}
    assert all(this_break.width == pytest.approx(1.5, abs=1e-3) for this_break in found.breaks)
    check(found, truth)


def test_a_rim_along_a_band_of_the_plan_is_broken_as_the_outline_is() -> None:
    plate = bored()
    truth = broken_top(plate, BRepFilletAPI_MakeChamfer(plate), 1.0)
    check(sketch(drawn(truth, hidden=False), GRID), truth)


def test_a_body_beside_the_part_is_paid_for(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    two = fuse(box((0, 0, 0), (20, 20, 10)), box((30, 0, 0), (50, 20, 10)))
    assert soundness(sketch(drawn(two, hidden=True), GRID).shape).solids == 2
    one = sketch(sample_views("counterbored-block"), GRID)
    assert soundness(one.shape).solids == 1
