"""What OpenCASCADE raises."""

from collections.abc import Callable

import pytest
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Edge, TopoDS_Solid

from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

_HERE = gp_Pnt(0.0, 0.0, 0.0)


def _added(edge: TopoDS_Edge) -> None:
    """A solid in an edge, which holds vertices alone."""
    builder, solid = BRep_Builder(), TopoDS_Solid()
    builder.MakeSolid(solid)
    builder.Add(edge, solid)


@pytest.mark.parametrize(
    "operation",
    [
        lambda: gp_Dir(0.0, 0.0, 0.0),
        lambda: BRepBuilderAPI_MakeEdge(_HERE, _HERE).Edge(),
        lambda: BRepPrimAPI_MakeBox(_HERE, 0.0, 1.0, 1.0).Solid(),
        lambda: _added(BRepBuilderAPI_MakeEdge(_HERE, gp_Pnt(1.0, 0.0, 0.0)).Edge()),
        lambda: Bnd_Box().CornerMin(),
    ],
)
def test_what_is_not_done_is_one_of_them(operation: Callable[[], object]) -> None:
    with pytest.raises(KERNEL_FAILURES):
        operation()
