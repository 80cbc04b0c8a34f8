"""What was made from notes, compared with them."""

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCone, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.report.noted_results import keeps_thickness, kept_notes

_AT = (20.0, 15.0)
_BORE, _WIDE = (0.0, 0.0, 1.0, 1.0), (0.0, 2.0, 1.0, 3.0)
_TOP = gp_Ax2(gp_Pnt(*_AT, 12.0), gp_Dir(0, 0, -1))


def _plate(*tools: TopoDS_Shape) -> TopoDS_Shape:
    """40 x 30 x 12 mm, bored from above."""
    shape = BRepPrimAPI_MakeBox(40.0, 30.0, 12.0).Shape()
    for tool in tools:
        shape = BRepAlgoAPI_Cut(shape, tool).Shape()
    return shape


def _cylinder(diameter: float, depth: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeCylinder(_TOP, diameter / 2.0, depth).Shape()


def _noted(bore: float | None, wide: float = 5.7) -> NotedHole:
    steps = HoleStep(6.0, bore, (_BORE,)), HoleStep(10.0, wide, (_WIDE,))
    return NotedHole(Role.TOP, _AT, steps)


@pytest.mark.parametrize(
    ("hole", "kept"),
    [
        (_noted(None), {_BORE, _WIDE}),
        (_noted(None, 6.5), {_BORE}),
        (_noted(9.0), {_WIDE}),
        (_noted(9.0, 3.0), set()),
    ],
)
def test_a_note_is_kept_where_the_solid_is_as_it_says(hole: NotedHole, kept: set[object]) -> None:
    shape = _plate(_cylinder(6.0, 12.0), _cylinder(10.0, 5.7))
    assert kept_notes([hole], shape) == kept


def test_a_sink_in_the_place_of_a_counterbore_keeps_its_hole_alone() -> None:
    cone = BRepPrimAPI_MakeCone(_TOP, 5.0, 3.0, 2.0).Shape()
    assert kept_notes([_noted(None)], _plate(_cylinder(6.0, 12.0), cone)) == {_BORE}


def test_nothing_is_kept_where_there_is_no_hole() -> None:
    assert not kept_notes([_noted(None), _noted(5.0)], _plate())
    assert not kept_notes([_noted(8.0)], _plate(_cylinder(20.0, 8.0)))


def test_one_hole_that_is_otherwise_breaks_the_note_of_many() -> None:
    elsewhere = NotedHole(Role.TOP, (35.0, 25.0), _noted(None).steps)
    shape = _plate(_cylinder(6.0, 12.0), _cylinder(10.0, 5.7))
    assert not kept_notes([_noted(None), elsewhere], shape)


def test_a_thickness_is_kept_along_the_axis_that_no_view_shows() -> None:
    assert keeps_thickness(12.0, Unseen(Axis.Z, 12.0), _plate())
    assert not keeps_thickness(13.0, Unseen(Axis.Z, 12.0), _plate())
    assert not keeps_thickness(12.0, None, _plate())
