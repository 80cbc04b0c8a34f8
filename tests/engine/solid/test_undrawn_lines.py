"""Sheets that leave hidden lines out: what is drawn is explained, and what was assumed is said."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.modes import Status

Draw = Callable[[TopoDS_Shape], DrawnViews]


def _plate(*holes: tuple[float, float, float, float]) -> TopoDS_Shape:
    """A plate of 60 x 40 x 10 mm with holes from above: x, y, radius, depth."""
    shape = BRepPrimAPI_MakeBox(60.0, 40.0, 10.0).Shape()
    for x, y, radius, depth in holes:
        axis = gp_Ax2(gp_Pnt(x, y, 10.0 - depth), gp_Dir(0.0, 0.0, 1.0))
        tool = BRepPrimAPI_MakeCylinder(axis, radius, depth).Shape()
        shape = BRepAlgoAPI_Cut(shape, tool).Shape()
    return shape


def _stepped() -> TopoDS_Shape:
    """The plate with a step, so that a hole might end at its height."""
    tool = BRepPrimAPI_MakeBox(gp_Pnt(40.0, 0.0, 6.0), 20.0, 40.0, 4.0).Shape()
    return BRepAlgoAPI_Cut(_plate((20.0, 20.0, 5.0, 10.0)), tool).Shape()


def _without(views: DrawnViews, *roles: Role) -> DrawnViews:
    """The views, some of which draw no hidden lines."""
    strokes = {
        role: tuple(s for s in stroke if role not in roles or s.linetype is Linetype.VISIBLE)
        for role, stroke in views.strokes.items()
    }
    return replace(views, strokes=strokes)


@pytest.mark.parametrize(
    "shape",
    [
        pytest.param(_plate((15.0, 20.0, 4.0, 10.0)), id="a hole"),
        pytest.param(_plate((15.0, 20.0, 4.0, 10.0), (45.0, 20.0, 6.0, 10.0)), id="two holes"),
        pytest.param(_stepped(), id="a hole and a step"),
    ],
)
def test_holes_go_through_where_nothing_else_is_told(drawn: Draw, shape: TopoDS_Shape) -> None:
    views = drawn(shape)
    result = exact_solid(_without(views, *views.roles))
    assert result.status is Status.APPROXIMATE
    assert "assumed" in [code for code, _ in result.reasons]
    assert result.explains
    assert same_solid(result.shape, shape)


def test_a_view_that_has_none_where_others_have_some_may_have_left_them_out(drawn: Draw) -> None:
    shape = _plate((15.0, 20.0, 4.0, 10.0), (45.0, 20.0, 6.0, 6.0))
    result = exact_solid(_without(drawn(shape), Role.FRONT))
    assert result.status is Status.APPROXIMATE
    assert "assumed" in [code for code, _ in result.reasons]
    assert same_solid(result.shape, shape)


def test_what_is_drawn_needs_no_assumption(drawn: Draw) -> None:
    shape = _plate((15.0, 20.0, 4.0, 6.0))
    result = exact_solid(drawn(shape))
    assert (result.status, result.reasons) == (Status.VERIFIED, ())
    assert same_solid(result.shape, shape)


def test_a_line_that_no_view_shows_is_no_part_of_the_solid(drawn: Draw) -> None:
    """A block without holes, and without hidden lines, is a block."""
    shape = BRepPrimAPI_MakeBox(60.0, 40.0, 10.0).Shape()
    result = exact_solid(drawn(shape))
    assert [code for code, _ in result.reasons] == ["assumed"]
    assert soundness(result.shape).faces == 6
