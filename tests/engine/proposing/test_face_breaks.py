"""Edge breaks around faces: taken off before a part is looked for, and put on its solid."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.booleans import common
from gaussiancad_core.kernel.brep import bounding_box, faces_of, soundness, subshapes, volume
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.proposing.face_breaks import without_breaks
from gaussiancad_core.proposing.proposed_part import proposed_part
from sample_parts.modelling import box, cut, cylinder, fuse

Draw = Callable[..., DrawnViews]

_WORK = 1e8
_KINDS = {"chamfer": BRepFilletAPI_MakeChamfer, "rounding": BRepFilletAPI_MakeFillet}


def _iou(one: TopoDS_Shape, other: TopoDS_Shape) -> float:
    both = volume(common(one, other))
    return both / (volume(one) + volume(other) - both)


def _plate() -> TopoDS_Shape:
    return cut(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 8.0)), cylinder(Axis.Z, (20.0, 20.0), 4.0, -1.0, 9.0)
    )


def _boss() -> TopoDS_Shape:
    return fuse(box((0.0, 0.0, 0.0), (60.0, 40.0, 8.0)), box((20.0, 10.0, 8.0), (44.0, 30.0, 20.0)))


def _broken(shape: TopoDS_Shape, kind: str, size: float) -> TopoDS_Shape:
    """A shape with all edges of its highest face broken."""
    maker = _KINDS[kind](shape)
    top = max(faces_of(shape), key=lambda face: bounding_box(face)[0, 2])
    for edge in subshapes(top, TopAbs_ShapeEnum.TopAbs_EDGE):
        maker.Add(size, TopoDS.Edge(edge))
    return maker.Shape()


def _visible(views: DrawnViews) -> DrawnViews:
    """Views whose sheet draws no hidden lines."""
    strokes = {
        role: tuple(each for each in drawn if each.linetype is Linetype.VISIBLE)
        for role, drawn in views.strokes.items()
    }
    return replace(views, strokes=strokes, undrawn=tuple(strokes))


@pytest.mark.parametrize(
    ("made", "kind"), [(_plate, "chamfer"), (_boss, "chamfer"), (_boss, "rounding")]
)
@pytest.mark.parametrize("hidden", [True, False])
def test_what_is_broken_around_a_face_is_made_sharp_and_broken_at_the_end(
    made: Callable[[], TopoDS_Shape], kind: str, hidden: bool, drawn: Draw
) -> None:
    truth = _broken(made(), kind, 1.5)
    views = drawn(truth) if hidden else _visible(drawn(truth))
    found = proposed_part(views, views.tolerance, _WORK)
    assert found is not None
    assert found.shape is not None
    assert soundness(found.shape).valid
    assert _iou(found.shape, truth) > 0.9999
    if hidden:
        # Where hidden lines show all of it, it may be put together of features as well.
        return
    (edge_break,) = dict.fromkeys(replace(each, across=Axis.X, place=0.0) for each in found.breaks)
    assert (edge_break.axis, edge_break.is_round) == (Axis.Z, kind == "rounding")
    assert edge_break.width == pytest.approx(1.5, abs=1e-3)


def test_a_corner_that_one_view_shows_is_a_profile_s_own(drawn: Draw) -> None:
    # The ridge runs through: seen from the right it has no corner.
    truth = cut(box((0, 0, 0), (60, 40, 20)))
    maker = BRepFilletAPI_MakeChamfer(truth)
    along = [
        edge
        for edge in subshapes(truth, TopAbs_ShapeEnum.TopAbs_EDGE)
        if bounding_box(edge)[0].tolist() == pytest.approx([0.0, 0.0, 20.0])
        and bounding_box(edge)[1].tolist() == pytest.approx([0.0, 40.0, 20.0])
    ]
    maker.Add(1.5, TopoDS.Edge(along[0]))
    views = drawn(maker.Shape())
    sharp, breaks = without_breaks(views)
    assert not breaks.each
    assert sharp.strokes == views.strokes


def test_a_break_s_lines_are_gone_and_its_corners_sharp(drawn: Draw) -> None:
    sharp, breaks = without_breaks(_visible(drawn(_broken(_plate(), "chamfer", 1.5))))
    plain = _visible(drawn(_plate()))
    for role in (Role.FRONT, Role.TOP, Role.RIGHT):
        assert len(sharp.strokes[role]) == len(plain.strokes[role])
        assert sum(each.length for each in sharp.strokes[role]) == pytest.approx(
            sum(each.length for each in plain.strokes[role]), rel=1e-6
        )
    (rim,) = breaks.rims[Axis.Z]
    assert rim.bounds == pytest.approx((16.0, 16.0, 24.0, 24.0), abs=0.02)
