import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert, BRepBuilderAPI_Transform
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone, BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_surfaces import unsupported
from benchmarks.tasks.exact_tables import tables
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import box, cut, cylinder


def _turned(shape: TopoDS_Shape, degrees: float) -> TopoDS_Shape:
    motion = gp_Trsf()
    motion.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), float(np.radians(degrees)))
    return BRepBuilderAPI_Transform(shape, motion, True).Shape()


@pytest.mark.parametrize("degrees", [0.0, 90.0, 31.0])
def test_round_surfaces_that_lean_are_counted(degrees: float) -> None:
    leans = degrees == 31.0
    bored = cut(box((0, 0, 0), (60, 40, 30)), cylinder(Axis.Z, (45, 12), 5, -1, 31))
    assert unsupported(_turned(bored, degrees)) == ({"leaning cylinder": 1} if leans else {})
    cone = BRepPrimAPI_MakeCone(9.0, 4.0, 12.0).Shape()
    assert unsupported(_turned(cone, degrees)) == ({"leaning cone": 1} if leans else {})
    torus = BRepPrimAPI_MakeTorus(20.0, 4.0).Shape()
    assert unsupported(_turned(torus, degrees)) == ({"leaning torus": 1} if leans else {})
    assert unsupported(_turned(BRepPrimAPI_MakeSphere(7.0).Shape(), degrees)) == {}


def test_free_form_surfaces_are_counted() -> None:
    shape = BRepBuilderAPI_NurbsConvert(cylinder(Axis.Z, (0, 0), 5, 0, 10)).Shape()
    assert unsupported(shape) == {"free-form": 3}


def test_the_table_tells_how_the_others_do() -> None:
    known = {"group": "g", "input": "dxf-vectors", "true_faces": 6, "processor": 2.0}
    rows = [
        {**known, "name": "a", "unsupported": {}, "exact": True, "faces": 6, "status": "verified"},
        {**known, "name": "b", "unsupported": {}, "status": "failed"},
        {**known, "name": "c", "unsupported": {"free-form": 2, "leaning cone": 1}},
    ]
    stated = tables(rows)
    assert "1 of 3 parts (free-form 1, leaning cone 1); of the 2 others 1 are exact" in stated
    assert "processor s of those that ended: median 2.00" in stated
    assert "do not express" not in tables(rows[:2])
