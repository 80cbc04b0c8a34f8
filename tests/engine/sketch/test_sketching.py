"""Slabs of regions: parts that are made of them come out exactly, be lines untrue or missing."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.dimension_constraints import DimensionConstraints, LengthDimension
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.kernel.brep import soundness, volume
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sketch.sketching import sketch

GRID = 0.1
"""mm of a step of the sheet's coordinates."""

Views = Callable[[str], DrawnViews]
Solids = Callable[[str], TopoDS_Shape]


def _iou(one: TopoDS_Shape, other: TopoDS_Shape) -> float:
    common = volume(BRepAlgoAPI_Common(one, other).Shape())
    return common / (volume(one) + volume(other) - common)


@pytest.mark.parametrize(
    "name",
    [
        "bored-plate",
        "stepped-block",
        "pocket-block",
        "t-slot-block",
        "counterbored-block",
        "slotted-link",
        "boss-plate",
        "vee-block",
        "filleted-block",
        "stepped-shaft",
    ],
)
def test_stacks_of_slabs_are_exact(sample_views: Views, sample_solid: Solids, name: str) -> None:
    found = sketch(sample_views(name), GRID)
    facts = soundness(found.shape)
    assert facts.valid
    assert facts.closed
    assert facts.solids == 1
    assert _iou(found.shape, sample_solid(name)) > 0.99999
    assert found.choice.is_proven


def _changed(views: DrawnViews, role: Role, strokes: tuple[Segment, ...]) -> DrawnViews:
    return replace(views, strokes={**views.strokes, role: strokes})


def test_an_untrue_line_makes_no_other_part(sample_views: Views, sample_solid: Solids) -> None:
    views = sample_views("counterbored-block")
    wide, deep, high = views.size
    for role, far in ((Role.FRONT, high), (Role.TOP, deep)):
        line = Segment((0.31 * wide, 0.0), (0.31 * wide, far), Linetype.VISIBLE)
        found = sketch(_changed(views, role, (*views.strokes[role], line)), GRID)
        assert _iou(found.shape, sample_solid("counterbored-block")) > 0.99999


def test_a_lost_line_fills_no_hole(sample_views: Views, sample_solid: Solids) -> None:
    views = sample_views("bored-plate")
    kept = tuple(item for item in views.strokes[Role.FRONT] if item.linetype is not Linetype.HIDDEN)
    assert len(kept) < len(views.strokes[Role.FRONT])
    found = sketch(_changed(views, Role.FRONT, kept), GRID)
    assert _iou(found.shape, sample_solid("bored-plate")) > 0.99999


def test_the_projection_is_that_whose_part_explains_more(
    sample_views: Views, sample_solid: Solids
) -> None:
    views = sample_views("pocket-block")
    deep = views.size[1]

    def moved(role: Role, by: tuple[float, float]) -> tuple[object, ...]:
        return tuple(item.mapped(Similarity(offset=by)) for item in views.strokes[role])

    wrong = {
        Role.FRONT: views.strokes[Role.FRONT],
        Role.BOTTOM: moved(Role.TOP, (0.0, -deep)),
        Role.LEFT: moved(Role.RIGHT, (-deep, 0.0)),
    }
    right, other = sketch(views, GRID), sketch(replace(views, strokes=wrong), GRID)
    assert right.energy < 0.8 * other.energy
    assert _iou(right.shape, sample_solid("pocket-block")) > 0.99999


def test_a_number_tells_how_thick_a_plate_is(sample_views: Views) -> None:
    views = sample_views("bored-plate")
    high = views.size[2]
    stated = DimensionConstraints((LengthDimension(Axis.Z, 0.0, high, high + 0.04),), 0.05, 0.01)
    rough = replace(views, tolerance=0.1, apart=0.03, dimensions=stated)
    found = sketch(rough, GRID)
    assert found.slabs[-1].high == pytest.approx(high + 0.04, abs=1e-6)


def test_views_without_an_outline_are_no_part(sample_views: Views) -> None:
    views = sample_views("bored-plate")
    assert sketch(replace(views, strokes={Role.FRONT: (), Role.TOP: ()}), GRID) is None
