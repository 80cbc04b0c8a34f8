"""The models of a drawing: which one explains the most."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakePrism, BRepPrimAPI_MakeRevol
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Vec
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Role
from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.labelling import Labelling
from gaussiancad_core.reasoning.part import PartModel, model_part
from gaussiancad_core.reasoning.work import NEVER, Deadline, Meter
from gaussiancad_core.solid import models, other_models
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.limits import Limits, Work
from gaussiancad_core.solid.models import first_work, labelled
from gaussiancad_core.solid.trace import Journal, ModelKind
from gaussiancad_core.views import Segment


def test_arcs_that_follow_a_curve_are_taken_for_it(
    pin_as_read: DrawnViews,
    sample_solid: Callable[[str], TopoDS_Shape],
    iou: Callable[[TopoDS_Shape, TopoDS_Shape], float],
) -> None:
    result = exact_solid(pin_as_read)
    assert (result.status, result.reasons) == (Status.VERIFIED, ())
    assert iou(result.shape, sample_solid("cross-bored-pin")) > 0.9999


def _first(part: PartModel, views: DrawnViews) -> Work:
    meter = Meter()
    meter.lap("model")
    return first_work(part, views, Limits(), meter, Journal())


def _only_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leaves out models that fulfil all rules, which would be the only ones."""
    monkeypatch.setattr(models, "wider_models", lambda *_: iter(()))


def test_other_models_follow_where_they_give_up_clearly_less(
    pin_as_read: DrawnViews, monkeypatch: pytest.MonkeyPatch
) -> None:
    part = model_part(pin_as_read)
    _only_given_up(monkeypatch)

    def costs() -> list[float]:
        """Of the models, in their order."""
        found = [*labelled(_first(part, pin_as_read), Limits())]
        assert found[0][0].part is part
        return [models._cost(labelling) for _, labelling in found]

    first, *others = costs()
    assert others and all(cost < models._BETTER * first for cost in others)
    monkeypatch.setattr(models, "_BETTER", 0.0)
    assert costs() == [first]
    assert models._cost(Labelling(None, (), False)) == float("inf")


def test_curves_are_followed_where_little_is_given_up_and_nothing_fits(
    pin_as_read: DrawnViews, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An arc that reaches beyond the outline gives up hardly any line, and bounds no solid."""
    _only_given_up(monkeypatch)
    monkeypatch.setattr(models, "_LITTLE", float("inf"))
    assert exact_solid(pin_as_read).status is Status.VERIFIED


def test_no_other_models_follow_where_telling_what_to_give_up_took_long(
    pin_as_read: DrawnViews, monkeypatch: pytest.MonkeyPatch
) -> None:
    part = model_part(pin_as_read)
    _only_given_up(monkeypatch)
    monkeypatch.setattr(models, "_LONG", 0.0)
    ((work, found),) = labelled(_first(part, pin_as_read), Limits())
    assert work.part is part and found.effort > 0.0


def test_values_far_apart_make_no_further_model(
    sample_views: Callable[[str], DrawnViews], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same lines with values closer together as one, or only those, are the same model."""
    views = replace(sample_views("l-bracket"), tolerance=0.2, apart=0.05)
    modelled: list[bool] = []

    def counted(lines: DrawnViews, *, deadline: Deadline, open_ends: bool = False) -> PartModel:
        modelled.append(lines.apart is None)
        return model_part(lines, open_ends=open_ends)

    monkeypatch.setattr(other_models, "model_part", counted)
    found = [*other_models.misread_models(_first(model_part(views), views), views, NEVER)]
    assert modelled == [False, False, True]
    assert [kind for kind, _ in found] == [ModelKind.OPEN_ENDS]


def _sloped_block() -> TopoDS_Shape:
    """A block with a sloping face at its back that ends 1 mm beside the corner of a notch."""
    slope = BRepBuilderAPI_MakePolygon()
    for x, z in ((0.0, 20.0), (70.0, 50.0), (0.0, 50.0)):
        slope.Add(gp_Pnt(x, 20.0, z))
    slope.Close()
    wedge = BRepPrimAPI_MakePrism(
        BRepBuilderAPI_MakeFace(slope.Wire()).Face(), gp_Vec(0.0, 40.0, 0.0)
    )
    notch = BRepPrimAPI_MakeBox(gp_Pnt(69.0, 0.0, 0.0), 31.0, 15.0, 50.0)
    block = BRepPrimAPI_MakeBox(100.0, 60.0, 50.0)
    sloped = BRepAlgoAPI_Cut(block.Shape(), wedge.Shape()).Shape()
    return BRepAlgoAPI_Cut(sloped, notch.Shape()).Shape()


def test_an_end_that_was_led_to_the_line_before_is_found(
    drawn: Callable[[TopoDS_Shape], DrawnViews], iou: Callable[[TopoDS_Shape, TopoDS_Shape], float]
) -> None:
    block = _sloped_block()
    views = drawn(block)
    before = 69.0, 20.0 + 69.0 * 30.0 / 70.0

    def cut(stroke: Segment) -> Segment:
        ends = [
            before if x == pytest.approx(70.0) else (x, z) for x, z in (stroke.start, stroke.end)
        ]
        return replace(stroke, start=ends[0], end=ends[1])

    front = tuple(
        cut(s) if 20.0 < abs(s.start[1] - s.end[1]) < 40.0 else s for s in views.strokes[Role.FRONT]
    )
    assert front != views.strokes[Role.FRONT]
    read = replace(views, strokes={**views.strokes, Role.FRONT: front}, tolerance=0.15, apart=0.05)
    result = exact_solid(read)
    assert (result.status, result.reasons) == (Status.VERIFIED, ())
    assert iou(result.shape, block) > 0.9999


def _chamfered_shaft(leg: float) -> TopoDS_Shape:
    """A step, 30 and 40 mm long, with chamfers at both ends and at the shoulder."""
    profile = [(0.0, 0.0), (0.0, 20.0 - leg), (leg, 20.0), (30.0 - leg, 20.0), (30.0, 20.0 - leg)]
    profile += [(30.0, 12.0), (70.0 - leg, 12.0), (70.0, 12.0 - leg), (70.0, 0.0)]
    outline = BRepBuilderAPI_MakePolygon()
    for along, away in profile:
        outline.Add(gp_Pnt(along, 20.0 + away, 20.0))
    outline.Close()
    axis = gp_Ax1(gp_Pnt(0.0, 20.0, 20.0), gp_Dir(1.0, 0.0, 0.0))
    face = BRepBuilderAPI_MakeFace(outline.Wire()).Face()
    return BRepPrimAPI_MakeRevol(face, axis).Shape()


def test_chamfers_hardly_larger_than_the_tolerance_are_no_corners(
    drawn: Callable[..., DrawnViews], iou: Callable[[TopoDS_Shape, TopoDS_Shape], float]
) -> None:
    shaft = _chamfered_shaft(1.0)
    read = replace(drawn(shaft), tolerance=0.6, apart=0.02, noise=0.01)
    result = exact_solid(read)
    assert [code for code, _ in result.reasons] == ["assumed"]
    assert iou(result.shape, shaft) > 0.9999
