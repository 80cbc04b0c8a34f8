"""What is taken for usual: solid unless seen, holes that go through."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.kernel.brep import bounding_box, moved_to_origin, soundness, volume
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import box, chamfered, cut, cylinder, edges_where

_VIEWS = (
    (Role.FRONT, Role.TOP),
    (Role.TOP, Role.RIGHT),
    (Role.FRONT, Role.TOP, Role.RIGHT),
)

_BORES = ((25.0, 8.0), (10.0, 33.0), (40.0, 33.0), (25.0, 25.0))


def _disc() -> TopoDS_Shape:
    """With a chamfer, whose edge ends bores as well as any other depth would."""
    disc = cylinder(Axis.Z, (25.0, 25.0), 25.0, 0.0, 10.0)
    rim = edges_where(disc, lambda one, other: min(one[2], other[2]) > 9.9)
    return chamfered(disc, rim, 1.0)


def _bored(radius: float, low: float) -> TopoDS_Shape:
    return cut(_disc(), *(cylinder(Axis.Z, at, radius, low, 11.0) for at in _BORES))


def _without_hidden(shape: TopoDS_Shape, roles: tuple[Role, ...]) -> DrawnViews:
    low, high = bounding_box(shape)
    drawing = LineDrawing(shape)
    strokes = {
        role: [item for item in drawing.view(role) if item.linetype is Linetype.VISIBLE]
        for role in roles
    }
    return exact_views(strokes, tuple(float(item) for item in high - low))


@pytest.mark.parametrize("roles", _VIEWS)
def test_bores_without_a_depth_go_through(roles: tuple[Role, ...]) -> None:
    shape = moved_to_origin(_bored(2.0, -1.0))
    found = exact_solid(_without_hidden(shape, roles))
    assert found.status is Status.APPROXIMATE
    assert found.shape is not None
    assert soundness(found.shape).faces == 8
    assert volume(found.shape) == pytest.approx(volume(shape), rel=1e-6)


@pytest.mark.parametrize("roles", [_VIEWS[0], _VIEWS[-1]])
def test_a_counterbore_leaves_most_of_the_part_and_its_bore_goes_through(
    roles: tuple[Role, ...], iou: Callable[[TopoDS_Shape, TopoDS_Shape], float]
) -> None:
    wide = [cylinder(Axis.Z, at, 3.5, 9.0, 11.0) for at in _BORES[:3]]
    shape = moved_to_origin(cut(_bored(2.0, -1.0), *wide))
    found = exact_solid(_without_hidden(shape, roles))
    assert found.shape is not None
    assert found.explains
    assert iou(found.shape, shape) == pytest.approx(1.0, abs=1e-6)


def test_a_hole_knows_what_stands_in_it() -> None:
    block = box((0.0, 0.0, 0.0), (40.0, 30.0, 10.0))
    ring = cut(block, cylinder(Axis.Z, (20.0, 15.0), 8.0, 4.0, 11.0))
    shape = cut(ring, cylinder(Axis.Z, (20.0, 15.0), 3.0, -1.0, 11.0))
    roles = (Role.FRONT, Role.TOP)
    views = _without_hidden(shape, roles)
    part = model_part(replace(views, undrawn=roles))
    assert part.usual is not None
    inner = {hole for hole in part.usual.holes if not hole.within}
    (outer,) = (hole for hole in part.usual.holes if hole.within)
    assert [hole.cells for hole in inner] == [outer.within]
    assert set(part.usual.bulks) >= {*outer.cells, *outer.within}
    assert model_part(views).usual is None


def test_what_is_removed_is_a_small_share_of_what_the_sheet_leaves_open() -> None:
    """Nothing is hollowed out that no view shows."""
    shape = moved_to_origin(_bored(2.0, -1.0))
    found = exact_solid(_without_hidden(shape, (Role.FRONT, Role.TOP)))
    for other in (found.shape, *found.alternatives):
        shared = abs(volume(BRepAlgoAPI_Common(other, shape).Shape()))
        assert shared > 0.85 * volume(shape)
