"""Chamfers around faces are taken off the views, and put on the sketch again."""

from collections.abc import Callable

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.sketch.sketch_check import checked
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.modelling import box, chamfered, cut, cylinder, edges_where, filleted

Draw = Callable[[TopoDS_Shape, tuple[Role, ...]], DrawnViews]
Iou = Callable[[TopoDS_Shape, TopoDS_Shape], float]

_GRID = 0.05
_TWO = (Role.FRONT, Role.TOP)
_THREE = (Role.FRONT, Role.TOP, Role.RIGHT)


def _plate(radius: float = 0.0) -> TopoDS_Shape:
    plate = box((0.0, 0.0, 0.0), (60.0, 40.0, 8.0))
    if not radius:
        return plate
    return filleted(plate, edges_where(plate, lambda a, b: abs(a[2] - b[2]) > 1.0), radius)


def _broken(plate: TopoDS_Shape, *heights: float) -> TopoDS_Shape:
    """With chamfers of a millimetre around the faces at some heights."""
    for height in heights:
        at = edges_where(plate, lambda a, b, z=height: max(abs(a[2] - z), abs(b[2] - z)) < 0.1)
        plate = chamfered(plate, at, 1.0)
    return plate


def _bored(plate: TopoDS_Shape) -> TopoDS_Shape:
    bores = (cylinder(Axis.Z, (x, 20.0), r, -1.0, 9.0) for x, r in ((12.0, 3.0), (35.0, 8.0)))
    return cut(plate, *bores)


_PARTS = {
    "sharp corners": _broken(_plate(), 8.0),
    "round corners": _broken(_plate(10.0), 8.0),
    "both sides": _broken(_plate(10.0), 8.0, 0.0),
    "bores": _bored(_broken(_plate(10.0), 8.0)),
}


@pytest.mark.parametrize("roles", [_TWO, _THREE], ids=["two views", "three"])
@pytest.mark.parametrize("name", _PARTS)
def test_a_chamfered_plate_comes_back(
    name: str, roles: tuple[Role, ...], drawn: Draw, iou: Iou
) -> None:
    part = _PARTS[name]
    views = drawn(part, roles)
    found = checked(sketch(views, _GRID), views)
    assert found.explains
    assert iou(found.shape, part) == pytest.approx(1.0, abs=1e-6)
    assert soundness(found.shape).faces == soundness(part).faces


@pytest.mark.parametrize("name", _PARTS)
def test_the_chamfers_are_measured(name: str, drawn: Draw) -> None:
    breaks = sketch(drawn(_PARTS[name], _TWO), _GRID).breaks
    assert breaks
    assert {round(this_break.width, 6) for this_break in breaks} == {1.0}


@pytest.mark.parametrize("part", [_plate(), _bored(_plate(10.0))], ids=["plain", "bored"])
def test_a_part_without_chamfers_has_none(part: TopoDS_Shape, drawn: Draw) -> None:
    assert not sketch(drawn(part, _THREE), _GRID).breaks
