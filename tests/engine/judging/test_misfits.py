"""A solid costs nothing on its own drawing, and what differs is told by kind and place."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.judging.difference_kinds import KINDS, Kind
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import faceted_mesh, faceted_shape
from gaussiancad_core.judging.misfits import Judge, Misfit, total_mm
from gaussiancad_core.kernel.brep import bounding_box, tessellate
from gaussiancad_core.lines.cut_solids import section_view
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.model.section_planes import Cut, CutRegion
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype, Segment
from sample_parts import SAMPLES
from sample_parts.modelling import box, cut, cylinder, edges_along, filleted, fuse

Draw = Callable[..., DrawnViews]

_BLOCK = box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0))
_BORE = cylinder(Axis.Z, (20.0, 15.0), 6.0, -1.0, 31.0)
_BORED = cut(_BLOCK, _BORE)


def _misfit(solid: TopoDS_Shape, views: DrawnViews) -> Misfit:
    return Judge(drawn_sheet(views)).misfit(faceted_shape(solid))


def _kinds(misfit: Misfit) -> set[Kind]:
    return {kind for kind in KINDS if total_mm(misfit, [kind]) > 0.0}


@pytest.mark.parametrize("name", [sample.name for sample in SAMPLES])
def test_a_solid_explains_its_drawing(
    name: str, sample_solid: Callable[[str], TopoDS_Shape], sample_views: Callable[..., DrawnViews]
) -> None:
    assert _misfit(sample_solid(name), sample_views(name)).cost == 0.0


def test_a_hole_that_is_not_there_is_missing_in_every_view(drawn: Draw) -> None:
    misfit = _misfit(_BLOCK, drawn(_BORED))
    top, *sides = (
        next(view for view in misfit.views if view.view.role is role)
        for role in (Role.TOP, Role.FRONT, Role.RIGHT)
    )
    assert _kinds(misfit) == {Kind.MISSING, Kind.MISSING_HIDDEN}
    assert total_mm(Misfit((top,), 1.0), [Kind.MISSING]) == pytest.approx(12.0 * np.pi, rel=1e-3)
    for side in sides:
        assert total_mm(Misfit((side,), 1.0), [Kind.MISSING_HIDDEN]) == pytest.approx(60.0)
    (circle,) = np.flatnonzero(top.share_lost == 1.0).tolist()
    assert top.view.lines[circle].is_circle


def test_a_hole_that_is_not_drawn_is_an_edge_of_the_solid(drawn: Draw) -> None:
    misfit = _misfit(_BORED, drawn(_BLOCK))
    top = next(view for view in misfit.views if view.view.role is Role.TOP)
    rim = top.of(Kind.EXTRA) & (top.edge >= 0)
    assert top.mm[rim].sum() == pytest.approx(12.0 * np.pi, rel=0.05)
    away = np.hypot(*(top.at[rim] - np.array([20.0, 15.0])).T)
    assert away == pytest.approx(6.0, rel=0.01)


def test_hidden_lines_are_not_asked_for_where_a_sheet_draws_none(drawn: Draw) -> None:
    views = drawn(_BLOCK)
    blind = cut(_BLOCK, cylinder(Axis.Z, (20.0, 15.0), 6.0, -1.0, 12.0))
    assert _misfit(blind, views).cost == pytest.approx(0.0)
    # One hidden line tells that the others are drawn, too.
    dashed = Segment((5.0, 5.0), (5.0, 6.0), Linetype.HIDDEN)
    strokes = {role: (*lines, dashed) for role, lines in views.strokes.items()}
    assert total_mm(_misfit(blind, replace(views, strokes=strokes)), [Kind.EXTRA_HIDDEN]) > 20.0


def test_a_line_of_the_other_kind_costs_a_third(drawn: Draw) -> None:
    views = drawn(_BORED)
    turned = {
        role: tuple(replace(stroke, linetype=Linetype.VISIBLE) for stroke in strokes)
        for role, strokes in views.strokes.items()
    }
    misfit = _misfit(_BORED, replace(views, strokes=turned))
    assert _kinds(misfit) == {Kind.LINETYPE}
    assert total_mm(misfit, [Kind.LINETYPE]) == pytest.approx(120.0)
    assert misfit.cost == pytest.approx(0.35 * 120.0)


def test_smooth_edges_may_be_drawn_or_not(drawn: Draw) -> None:
    slot = cut(
        _BLOCK,
        box((20.0, 10.0, -1.0), (40.0, 20.0, 31.0)),
        cylinder(Axis.Z, (20.0, 15.0), 5.0, -1.0, 31.0),
        cylinder(Axis.Z, (40.0, 15.0), 5.0, -1.0, 31.0),
    )
    views = drawn(slot)
    assert _misfit(slot, views).cost == pytest.approx(0.0)
    tangent = Segment((20.0, 0.0), (20.0, 30.0), Linetype.HIDDEN)
    front = (*views.strokes[Role.FRONT], tangent)
    misfit = _misfit(slot, replace(views, strokes={**views.strokes, Role.FRONT: front}))
    assert _kinds(misfit) == {Kind.TANGENT}
    assert total_mm(misfit, [Kind.TANGENT]) == pytest.approx(30.0)


_ROUNDED = filleted(_BLOCK, edges_along(_BLOCK, Axis.Z, [(0.0, 0.0)]), 10.0)
"""The front left corner of the block is round: from the front a smooth edge at 10 mm."""

_SEAM = Segment((10.0, 0.0), (10.0, 30.0), Linetype.VISIBLE)


@pytest.mark.parametrize("policy", list(TangentPolicy))
def test_a_smooth_edge_among_edges_costs_only_where_the_sheet_may_draw_none(
    drawn: Draw, policy: TangentPolicy
) -> None:
    views = replace(drawn(_ROUNDED), tangent_policy=policy)
    assert _misfit(_ROUNDED, views).cost == pytest.approx(0.0)
    front = {**views.strokes, Role.FRONT: (*views.strokes[Role.FRONT], _SEAM)}
    misfit = _misfit(_ROUNDED, replace(views, strokes=front))
    assert misfit.cost == pytest.approx(0.0 if policy.draws else 0.1 * 30.0)


@pytest.mark.parametrize("policy", list(TangentPolicy))
def test_a_tangent_edge_of_the_sheet_is_a_smooth_edge_of_the_solid(
    drawn: Draw, policy: TangentPolicy
) -> None:
    tangents = {Role.FRONT: (_SEAM,)}
    views = replace(drawn(_ROUNDED), tangents=tangents, tangent_policy=policy)
    assert _misfit(_ROUNDED, views).cost == pytest.approx(0.0)
    # The lines of a sheet are those of edges: what is thin adds nothing.
    assert _misfit(_ROUNDED, views).drawn == _misfit(_ROUNDED, drawn(_ROUNDED)).drawn


def test_a_tangent_edge_that_the_solid_lacks_costs_little(drawn: Draw) -> None:
    views = replace(drawn(_BLOCK), tangents={Role.FRONT: (_SEAM,)})
    misfit = _misfit(_BLOCK, views)
    assert _kinds(misfit) == {Kind.TANGENT}
    assert misfit.cost == pytest.approx(0.1 * 30.0)


def test_a_sharp_edge_upon_a_tangent_edge_is_of_another_kind_and_not_undrawn(drawn: Draw) -> None:
    step = cut(_BLOCK, box((-1.0, -1.0, -1.0), (10.0, 5.0, 31.0)))
    views = drawn(step)
    kept = tuple(
        stroke
        for stroke in views.strokes[Role.FRONT]
        if {point[0] for point in (stroke.start, stroke.end)} != {10.0}
    )
    assert len(kept) == len(views.strokes[Role.FRONT]) - 1
    seen = replace(
        views,
        strokes={**views.strokes, Role.FRONT: kept},
        tangents={Role.FRONT: (_SEAM,)},
        tangent_policy=TangentPolicy.THIN,
    )
    misfit = _misfit(step, seen)
    assert _kinds(misfit) == {Kind.LINETYPE}
    assert misfit.cost == pytest.approx(0.35 * 30.0)


def test_faces_on_one_surface_are_one(drawn: Draw) -> None:
    halves = fuse(
        box((0.0, 0.0, 0.0), (30.0, 40.0, 30.0)), box((30.0, 0.0, 0.0), (60.0, 40.0, 30.0))
    )
    assert _misfit(halves, drawn(_BLOCK)).cost == pytest.approx(0.0)


def test_a_mesh_is_judged_as_the_solid_that_it_was_made_of(drawn: Draw) -> None:
    views = drawn(_BORED)
    mesh = faceted_mesh(make_mesh(*tessellate(_BORED, 0.01, 0.1)))
    judge = Judge(drawn_sheet(views))
    assert judge.misfit(mesh).share < 0.002
    filled = faceted_mesh(make_mesh(*tessellate(_BLOCK, 0.01, 0.1)))
    assert judge.misfit(filled).cost == pytest.approx(_misfit(_BLOCK, views).cost, rel=1e-6)


def _cut_views(shape: TopoDS_Shape) -> DrawnViews:
    """A plan, and a section through the bore without hidden lines."""
    low, high = bounding_box(shape)
    size = tuple(float(extent) for extent in high - low)
    opening = CutRegion(15.0)
    section = section_view(shape, Role.FRONT, (opening,))
    strokes = {Role.TOP: LineDrawing(shape).view(Role.TOP), Role.FRONT: section.strokes}
    views = exact_views(strokes, size)
    return replace(views, cuts={Role.FRONT: Cut((opening,), section.areas)})


def test_a_section_shows_what_its_plane_cuts() -> None:
    blind = cut(_BLOCK, cylinder(Axis.Z, (20.0, 15.0), 6.0, 12.0, 31.0))
    views = _cut_views(blind)
    assert _misfit(blind, views).cost == pytest.approx(0.0)
    deeper = cut(_BLOCK, cylinder(Axis.Z, (20.0, 15.0), 6.0, 6.0, 31.0))
    misfit = _misfit(deeper, views)
    assert {Kind.MISSING, Kind.EXTRA, Kind.HATCHING} <= _kinds(misfit)


def test_of_nothing_every_line_is_missing(drawn: Draw) -> None:
    views = drawn(_BLOCK)
    misfit = _misfit(cut(_BLOCK, _BLOCK), views)
    assert _kinds(misfit) == {Kind.MISSING}
    assert misfit.share == pytest.approx(1.0)
