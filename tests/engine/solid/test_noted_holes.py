"""Depths that notes tell, where views draw no hidden lines."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.solid.exact import exact_solid
from sample_parts.modelling import box, cut, cylinder

Iou = Callable[[TopoDS_Shape, TopoDS_Shape], float]

_SIZE = (60.0, 40.0, 30.0)
_BLOCK = box((0.0, 0.0, 0.0), _SIZE)
_AT = (20.0, 15.0)


def _views(shape: TopoDS_Shape, *notes: NotedHole) -> DrawnViews:
    drawing = LineDrawing(shape)
    strokes = {
        role: [item for item in drawing.view(role) if item.linetype is Linetype.VISIBLE]
        for role in (Role.FRONT, Role.TOP, Role.RIGHT)
    }
    return replace(exact_views(strokes, _SIZE), holes=notes)


def _bore(diameter: float, depth: float) -> TopoDS_Shape:
    return cylinder(Axis.Z, _AT, diameter / 2.0, 30.0 - depth, 31.0)


@pytest.mark.parametrize("depth", [7.0, 12.5, 23.25])
def test_a_hole_is_as_deep_as_its_note_says(depth: float, iou: Iou) -> None:
    shape = cut(_BLOCK, _bore(10.0, depth))
    note = NotedHole(Role.TOP, _AT, (HoleStep(10.0, depth),))
    found = exact_solid(_views(shape, note))
    assert found.shape is not None
    assert iou(found.shape, shape) == pytest.approx(1.0, abs=1e-6)


def test_a_counterbore_is_as_deep_as_its_note_says(iou: Iou) -> None:
    shape = cut(_BLOCK, _bore(8.0, 31.0), _bore(16.0, 6.5))
    note = NotedHole(Role.TOP, _AT, (HoleStep(8.0), HoleStep(16.0, 6.5)))
    found = exact_solid(_views(shape, note))
    assert found.shape is not None
    assert iou(found.shape, shape) == pytest.approx(1.0, abs=1e-6)


def test_a_depth_counts_from_the_face_that_the_hole_is_drawn_on(iou: Iou) -> None:
    step = box((35.0, -1.0, 18.0), (61.0, 41.0, 31.0))
    hole = cylinder(Axis.Z, (47.0, 20.0), 4.0, 10.0, 31.0)
    shape = cut(_BLOCK, step, hole)
    note = NotedHole(Role.TOP, (47.0, 20.0), (HoleStep(8.0, 8.0),))
    found = exact_solid(_views(shape, note))
    assert found.shape is not None
    assert iou(found.shape, shape) == pytest.approx(1.0, abs=1e-6)


def test_a_depth_beyond_the_part_changes_nothing(iou: Iou) -> None:
    shape = cut(_BLOCK, _bore(10.0, 31.0))
    note = NotedHole(Role.TOP, _AT, (HoleStep(10.0, 80.0),))
    found = exact_solid(_views(shape, note))
    assert found.shape is not None
    assert iou(found.shape, shape) == pytest.approx(1.0, abs=1e-6)
