"""A planned part before the judge: what an edit is said to change is what it changes."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
import shapely
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.misfits import solid_misfit
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.section_planes import Cut, CutRegion
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.feature_tables import tables_of
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet, plane_sheet
from gaussiancad_core.proposing.loop_places import places_of, prism, whole_prism
from gaussiancad_core.proposing.loop_shapes import loops_of
from gaussiancad_core.proposing.part_changes import improved
from gaussiancad_core.proposing.part_features import Feature, Pattern, Prism
from gaussiancad_core.proposing.plane_loops import Loop, LoopKind, PlaneLoops, plane_loops
from gaussiancad_core.proposing.planned_part import PlannedJudge, PlannedPart
from gaussiancad_core.proposing.planned_views import planned_views
from gaussiancad_core.proposing.turned_profiles import turned_of
from sample_parts.modelling import box, cone, cut, cylinder

Draw = Callable[[TopoDS_Shape], DrawnViews]

_BLOCK = box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0))
_STEP = box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0))


def _bore(x: float) -> TopoDS_Shape:
    return cylinder(Axis.Z, (x, 12.0), 5.0, -1.0, 31.0)


class _Plan:
    """A sheet with its loops, its judge, and the outlines met."""

    def __init__(self, views: DrawnViews) -> None:
        self.sheet: PlaneSheet = plane_sheet(views, find_places(views, views.tolerance))
        self.planes: dict[Axis, PlaneLoops] = {}
        for axis in Axis:
            found = plane_loops(self.sheet, axis)
            if found is not None:
                self.planes[axis] = found
        self.loops = {axis: loops_of(self.sheet, each) for axis, each in self.planes.items()}
        self.turned = list(turned_of(self.sheet, self.planes, self.loops))
        self.judge = PlannedJudge(
            self.sheet, tuple(planned_views(views, self.sheet, self.planes.values()))
        )

    def outlines(self) -> PlannedPart:
        part = PlannedPart(self.judge)
        for number, loops in enumerate(self.loops.values()):
            outline = next(loop for loop in loops if loop.kind is LoopKind.OUTLINE)
            part.do(Operation.ADD if number == 0 else Operation.MEET, self.whole(outline))
        return part

    def whole(self, loop: Loop) -> Prism:
        return whole_prism(self.sheet, loop)

    def discs(self) -> list[Loop]:
        return [loop for loop in self.loops[Axis.Z] if 70.0 < loop.polygon.area < 80.0]


def _plan(drawn: Draw, *tools: TopoDS_Shape) -> _Plan:
    return _Plan(drawn(cut(_BLOCK, _STEP, *tools)))


def test_outlines_met_are_a_part_without_holes(drawn: Draw) -> None:
    assert _plan(drawn).outlines().share == pytest.approx(0.0, abs=1e-9)


def test_a_gain_is_what_the_edit_then_changes(drawn: Draw) -> None:
    plan = _plan(drawn, _bore(15.0), _bore(30.0))
    part = plan.outlines()
    one, other = (plan.whole(disc) for disc in plan.discs())
    edits: list[tuple[Operation, Feature]] = [
        (Operation.CUT, one),
        (Operation.ADD, one),
        (Operation.CUT, Pattern((one, other))),
        (Operation.CUT, prism(plan.sheet, one.loop, 0.0, 18.0)),
    ]
    for operation, feature in edits:
        gain, before = part.gain(operation, feature), part.cost
        changed = part.copy().do(operation, feature)
        assert changed.cost - before == pytest.approx(gain.mm, abs=1e-9)
        assert part.cost == before
    both = part.copy().do(Operation.CUT, Pattern((one, other)))
    assert both.share == pytest.approx(0.0, abs=1e-9)


def test_a_slab_costs_what_it_is_said_to(drawn: Draw) -> None:
    plan = _plan(drawn, _bore(15.0))
    part = plan.outlines()
    (loop,) = (
        each
        for each in plan.loops[Axis.Z]
        if each.kind is LoopKind.REGION and each.polygon.interiors
    )
    for low, high in ((0.0, 18.0), (18.0, 30.0), (0.0, 30.0)):
        slab = prism(plan.sheet, loop, low, high)
        gain, before = part.slab_gain(slab), part.cost
        assert part.copy().set_slab(slab).cost - before == pytest.approx(gain, abs=1e-9)
    # All of a part made a slab is that slab alone.
    alone = PlannedPart(plan.judge).do(Operation.ADD, plan.whole(loop))
    assert part.set_slab(plan.whole(loop)).cost == pytest.approx(alone.cost, abs=1e-9)


def test_what_is_planned_costs_what_its_solid_does(drawn: Draw) -> None:
    views = drawn(cut(_BLOCK, _STEP, _bore(15.0)))
    part = _Plan(views).outlines()
    solid = solid_misfit(cut(_BLOCK, _STEP), views)
    assert part.share == pytest.approx(solid.share, rel=0.05)


def test_a_cone_is_proposed_by_a_leaning_line_between_radii(drawn: Draw) -> None:
    sunk = cut(_BLOCK, _bore(15.0), cone(Axis.Z, (15.0, 12.0), (5.0, 9.0), 26.0, 30.0))
    plan = _Plan(drawn(sunk))
    part = plan.outlines().do(Operation.CUT, plan.whole(plan.discs()[0]))
    gains = [part.gain(Operation.CUT, each).mm for each in plan.turned]
    best = plan.turned[gains.index(min(gains))]
    assert (best.low, best.high, best.radius) == pytest.approx((26.0, 30.0, 9.0))
    assert part.do(Operation.CUT, best).share == pytest.approx(0.0, abs=1e-9)


def test_nothing_lies_beyond_a_closed_outline(drawn: Draw) -> None:
    plan = _plan(drawn)
    part = plan.outlines()
    outside = plan.planes[Axis.Z].loop(shapely.box(5.0, 45.0, 55.0, 50.0), LoopKind.BOX)
    # No line of sight beside a stroke meets it, and the raster ends with the sheet's box.
    assert part.gain(Operation.ADD, plan.whole(outside)).mm >= 0.0
    notched = plan.planes[Axis.Y].loop(shapely.box(40.0, 18.0, 60.0, 30.0), LoopKind.BOX)
    assert part.gain(Operation.ADD, plan.whole(notched)).mm > 10.0


def test_a_section_shows_what_is_behind_its_plane(drawn: Draw) -> None:
    # A blind bore from the front, through which only the section along its middle shows.
    blind = cut(_BLOCK, cylinder(Axis.Z, (15.0, 12.0), 5.0, 10.0, 31.0))
    half = cut(blind, box((-1.0, -1.0, -1.0), (61.0, 12.0, 31.0)))
    whole, opened = drawn(blind), drawn(half)
    section = Cut((CutRegion(12.0),))
    views = replace(
        whole,
        strokes={Role.FRONT: opened.strokes[Role.FRONT], Role.TOP: whole.strokes[Role.TOP]},
        cuts={Role.FRONT: section},
    )
    plan = _Plan(views)
    part = plan.outlines()
    (disc,) = plan.discs()
    floors = [(0.0, 30.0), (10.0, 30.0)]
    through, to_floor = (
        part.gain(Operation.CUT, prism(plan.sheet, disc, *floor)).mm for floor in floors
    )
    assert to_floor < through
    found = part.do(Operation.CUT, prism(plan.sheet, disc, 10.0, 30.0))
    assert found.share == pytest.approx(0.0, abs=1e-9)


def test_all_edits_at_once_change_what_each_does(drawn: Draw) -> None:
    plan = _plan(drawn, _bore(15.0), _bore(30.0))
    part = plan.outlines()
    one, other = (plan.whole(disc) for disc in plan.discs())
    pool: list[Feature] = [
        one,
        prism(plan.sheet, one.loop, 0.0, 18.0),
        Pattern((one, other)),
        *plan.turned[:2],
        plan.whole(plan.loops[Axis.X][0]),
    ]
    for view, sights in enumerate(each.sights for each in plan.judge.views):
        gains = part.gains_in(view, tables_of(pool, sights), np.arange(len(pool)))
        for number, feature in enumerate(pool):
            for operation in (Operation.ADD, Operation.CUT):
                gain = part.gain_in(view, operation, feature)
                known = gain.mm, gain.broken, gain.changed
                assert gains[number, operation] == pytest.approx(known, abs=1e-9)


def test_a_rough_judge_says_about_what_the_whole_one_does(drawn: Draw) -> None:
    plan = _plan(drawn, _bore(15.0), _bore(30.0))
    part, rough = plan.outlines(), PlannedPart(plan.judge.rough(4))
    rough = rough.followed_by(part.features)
    assert sum(len(view.one) for view in rough.judge.views) < 0.3 * sum(
        len(view.one) for view in part.judge.views
    )
    for disc in plan.discs():
        exact = part.gain(Operation.CUT, plan.whole(disc)).mm
        assert rough.gain(Operation.CUT, plan.whole(disc)).mm == pytest.approx(exact, rel=0.3)


def test_a_change_moves_an_end_or_takes_a_feature_out(drawn: Draw) -> None:
    plan = _plan(drawn, cylinder(Axis.Z, (15.0, 12.0), 5.0, 18.0, 31.0))
    (disc,) = plan.discs()
    right = plan.outlines().do(Operation.CUT, prism(plan.sheet, disc, 18.0, 30.0))
    assert right.share == pytest.approx(0.0, abs=1e-9)

    def free(_operation: Operation, _feature: Feature) -> float:
        return 0.0

    through = plan.outlines().do(Operation.CUT, plan.whole(disc))
    for wrong in (through, right.copy().do(Operation.ADD, prism(plan.sheet, disc, 18.0, 30.0))):
        before = wrong.cost
        found = improved(wrong, free, 1.0, np.inf)
        assert found is not None
        assert found.share == pytest.approx(0.0, abs=1e-9)
        assert wrong.cost == before > 0.0
    assert improved(right, free, 1.0, np.inf) is None


def test_a_hole_is_as_deep_as_its_note_says(drawn: Draw) -> None:
    views = drawn(cut(_BLOCK, _bore(15.0)))
    visible = {
        role: tuple(each for each in strokes if each.linetype is Linetype.VISIBLE)
        for role, strokes in views.strokes.items()
    }
    silent = replace(views, strokes=visible, undrawn=tuple(visible))
    note = NotedHole(Role.TOP, (15.0, 12.0), (HoleStep(10.0, 12.0),))
    for holes, costs in (((), (0.0, 0.0)), ((note,), (17.7, 0.0))):
        plan = _Plan(replace(silent, holes=holes))
        (disc,) = plan.discs()
        parts = [
            plan.outlines().do(Operation.CUT, each)
            for each in (plan.whole(disc), prism(plan.sheet, disc, 18.0, 30.0))
        ]
        assert [part.cost for part in parts] == pytest.approx(costs, abs=0.1)
        assert (18.0 in places_of(plan.sheet, disc)) == bool(holes)


def test_pieces_of_a_part_and_its_hollows_are_unusual(drawn: Draw) -> None:
    plan = _plan(drawn, _bore(15.0))
    habits, part = plan.judge.habits, plan.outlines()
    (disc,) = plan.discs()
    assert habits.of_pieces(part.features) == 0.0
    bored = part.copy().do(Operation.CUT, plan.whole(disc))
    assert habits.of_pieces(bored.features) == 0.0
    assert habits.unusual(bored.features) > habits.unusual(part.features)
    plug = shapely.affinity.scale(disc.polygon, 0.5, 0.5)
    core = plan.whole(plan.planes[Axis.Z].loop(plug, LoopKind.REGION))
    assert habits.of_pieces(bored.do(Operation.ADD, core).features) > 0.0
