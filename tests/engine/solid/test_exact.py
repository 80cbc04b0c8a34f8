"""The exact solid of exact views, and what becomes of views that are not as they should be."""

import gc
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakePolygon,
    BRepBuilderAPI_Transform,
)
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
    BRepPrimAPI_MakeRevol,
)
from OCP.GeomAbs import GeomAbs_CurveType
from OCP.gp import gp_Ax1, gp_Ax2, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.kernel.brep import bounding_box, moved_to_origin, soundness, subshapes, volume
from gaussiancad_core.labelling.cell_labelling import Effort, Labelling, Others, Search
from gaussiancad_core.labelling.counted_work import Deadline
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid import candidates, exact
from gaussiancad_core.solid.boundary_building import BuiltSolid, build_solid
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.labelled_cells import LabelledComplex
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.verify import verify
from gaussiancad_protocol.modes import Status
from sample_parts.classed import PartClass, classed_part
from sample_parts.modelling import box, cut, cylinder, fuse

Solid = Callable[[str], TopoDS_Shape]
Views = Callable[[str], DrawnViews]
Draw = Callable[[TopoDS_Shape], DrawnViews]
Solved = Callable[[str], ExactResult]
Iou = Callable[[TopoDS_Shape, TopoDS_Shape], float]

_NAMES = (
    "l-bracket",
    "bored-plate",
    "pocket-block",
    "counterbored-block",
    "slotted-link",
    "wedge-block",
    "filleted-block",
    "stepped-shaft",
    "countersunk-plate",
    "chamfered-block",
)

_SMALL = Limits(Effort(hard=4.0, relaxed=4.0, simplest=2.0), alternatives=3, work=10.0)
"""Enough for what follows, and an end to it in any case."""


def _codes(result: ExactResult) -> set[str]:
    return {code for code, _ in result.reasons}


@pytest.mark.parametrize("name", _NAMES)
def test_a_sample_part_comes_back(name: str, sample_solid: Solid, solved: Solved, iou: Iou) -> None:
    truth, result = sample_solid(name), solved(name)
    assert result.status is Status.VERIFIED
    assert result.reasons == () and result.alternatives == ()
    state, expected = soundness(result.shape), soundness(truth)
    assert (state.valid, state.closed, state.solids) == (True, True, 1)
    assert state.faces == expected.faces
    assert bounding_box(result.shape) == pytest.approx(bounding_box(truth), abs=1e-4)
    assert iou(truth, result.shape) == pytest.approx(1.0, abs=1e-6)
    assert result.verification is not None and result.verification.neat


def test_a_groove_that_a_bore_hides_in_one_view_is_found(
    drawn: Callable[..., DrawnViews], iou: Iou
) -> None:
    low = [
        (0.0, 0.0),
        (20.0, 0.0),
        (20.0, 4.0),
        (16.0, 8.0),
        (20.0, 12.0),
        (20.0, 16.0),
        (0.0, 16.0),
    ]
    outline = BRepBuilderAPI_MakePolygon()
    for radius, along in low:
        outline.Add(gp_Pnt(along, radius, 0.0))
    outline.Close()
    face = BRepBuilderAPI_MakeFace(outline.Wire()).Face()
    axis = gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(1.0, 0.0, 0.0))
    pulley = BRepPrimAPI_MakeRevol(face, axis).Shape()
    across = gp_Ax2(gp_Pnt(8.0, -30.0, 0.0), gp_Dir(0.0, 1.0, 0.0))
    bore = BRepPrimAPI_MakeCylinder(across, 5.0, 60.0).Shape()
    part = moved_to_origin(BRepAlgoAPI_Cut(pulley, bore).Shape())
    result = exact_solid(drawn(part))
    assert result.status is Status.VERIFIED, result.reasons
    assert iou(result.shape, part) == pytest.approx(1.0, abs=1e-6)
    assert soundness(result.shape).faces == soundness(part).faces


def test_an_arc_that_follows_an_ellipse_is_no_cylinder(
    drawn: Callable[..., DrawnViews], iou: Iou
) -> None:
    block = cut(box((0, 0, 0), (60, 40, 30)), box((48, -1, 18), (61, 41, 31)))
    rounded = BRepAlgoAPI_Fuse(block, cylinder(Axis.Y, (48, 18), 12, 0, 40)).Shape()
    outline = BRepBuilderAPI_MakePolygon()
    for corner in ((30.0, -1.0), (70.0, 40.2), (70.0, -1.0)):
        outline.Add(gp_Pnt(*corner, -1.0))
    outline.Close()
    face = BRepBuilderAPI_MakeFace(outline.Wire()).Face()
    wedge = BRepPrimAPI_MakePrism(face, gp_Vec(0.0, 0.0, 40.0)).Shape()
    part = moved_to_origin(BRepAlgoAPI_Cut(rounded, wedge).Shape())
    views = drawn(part)
    curved = [s for s in views.strokes[Role.RIGHT] if not isinstance(s, Segment)]
    (curve,) = curved
    points = curve.sample(0.05)
    centre, radius = circle_through(points[[0, len(points) // 2, -1]])
    angles = np.unwrap(np.arctan2(*(points[[0, -1]] - centre).T[::-1]))
    start, sweep = float(angles.min()), float(np.ptp(angles))
    arc = Arc((float(centre[0]), float(centre[1])), radius, start, sweep, curve.linetype)
    assert 1e-3 < np.abs(np.hypot(*(points - centre).T) - radius).max() < 0.05
    strokes = tuple(arc if s is curve else s for s in views.strokes[Role.RIGHT])
    result = exact_solid(replace(views, strokes={**views.strokes, Role.RIGHT: strokes}))
    assert result.shape is not None, result.reasons
    assert iou(result.shape, part) > 0.9999
    assert soundness(result.shape).faces == 8


def test_a_rounded_end_passes_into_its_cylinder_without_a_line(
    drawn: Callable[..., DrawnViews],
) -> None:
    rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), 20.0, 70.0).Shape()
    fillet = BRepFilletAPI_MakeFillet(rod)
    for edge in subshapes(rod, TopAbs_ShapeEnum.TopAbs_EDGE):
        if BRepAdaptor_Curve(TopoDS.Edge(edge)).GetType() == GeomAbs_CurveType.GeomAbs_Circle:
            fillet.Add(7.0, TopoDS.Edge(edge))
    bore = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), 9.0, 40.0).Shape()
    part = moved_to_origin(BRepAlgoAPI_Cut(fillet.Shape(), bore).Shape())
    result = exact_solid(drawn(part))
    assert result.status is Status.VERIFIED, result.reasons
    assert volume(result.shape) == pytest.approx(volume(part), rel=1e-6)
    assert bounding_box(result.shape) == pytest.approx(bounding_box(part), abs=1e-4)


@pytest.mark.parametrize("extent", [3.0, 3000.0])
def test_size_does_not_matter(
    extent: float, sample_solid: Solid, drawn: Callable[..., DrawnViews], iou: Iou
) -> None:
    solid = sample_solid("counterbored-block")
    low, high = bounding_box(solid)
    scaling = gp_Trsf()
    scaling.SetScale(gp_Pnt(*low), extent / float((high - low).max()))
    scaled = BRepBuilderAPI_Transform(solid, scaling, True).Shape()
    result = exact_solid(drawn(scaled))
    assert result.status is Status.VERIFIED
    assert iou(scaled, result.shape) == pytest.approx(1.0, abs=1e-6)
    assert soundness(result.shape).faces == soundness(solid).faces


@pytest.mark.parametrize(
    "roles",
    [
        (Role.REAR, Role.BOTTOM, Role.LEFT),
        (Role.FRONT, Role.REAR, Role.TOP, Role.BOTTOM, Role.RIGHT, Role.LEFT),
    ],
)
def test_opposite_views_tell_the_same_solid(
    roles: tuple[Role, ...], sample_solid: Solid, drawn: Callable[..., DrawnViews], iou: Iou
) -> None:
    solid = sample_solid("wedge-block")
    result = exact_solid(drawn(solid, roles))
    assert result.status is Status.VERIFIED
    assert iou(solid, result.shape) == pytest.approx(1.0, abs=1e-6)


def _box(x: float, y: float, z: float, *size: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), *size).Solid()


def test_two_views_are_solved_and_told(
    sample_solid: Solid, drawn: Callable[..., DrawnViews]
) -> None:
    solid = sample_solid("l-bracket")
    views = drawn(solid, (Role.FRONT, Role.TOP))
    result = exact_solid(views, _SMALL)
    assert result.status is Status.APPROXIMATE and "two-views" in _codes(result)
    assert result.verification is not None and result.verification.neat
    assert soundness(result.shape).valid
    assert bounding_box(result.shape) == pytest.approx(bounding_box(solid), abs=1e-4)


def _mirrored(views: DrawnViews, role: Role) -> DrawnViews:
    """A view drawn the wrong way round: mirrored within its own box."""
    strokes = views.strokes[role]
    assert all(isinstance(stroke, Segment) for stroke in strokes)
    ends = np.array([(stroke.start, stroke.end) for stroke in strokes])
    low, high = ends[..., 0].min(), ends[..., 0].max()
    flipped = tuple(
        replace(
            s, start=(low + high - s.start[0], s.start[1]), end=(low + high - s.end[0], s.end[1])
        )
        for s in strokes
    )
    return replace(views, strokes={**views.strokes, role: flipped})


def _without_verdict(result: ExactResult) -> None:
    """Not verified, told why, and consistent in itself."""
    assert result.status in (Status.APPROXIMATE, Status.FAILED)
    assert result.reasons
    assert (result.shape is None) == (result.status is Status.FAILED)


def test_a_mirrored_view_is_never_verified(sample_views: Views) -> None:
    result = exact_solid(_mirrored(sample_views("l-bracket"), Role.FRONT), _SMALL)
    _without_verdict(result)
    assert _codes(result) & {"lines-unexplained", "no-solid-fits", "no-valid-solid"}


def test_without_relaxing_views_that_contradict_have_no_solid(sample_views: Views) -> None:
    wrong = _mirrored(sample_views("l-bracket"), Role.FRONT)
    result = exact_solid(wrong, replace(_SMALL, relaxed=False))
    assert result.status is Status.FAILED
    assert (result.shape, result.verification, result.alternatives) == (None, None, ())
    assert _codes(result) == {"no-solid-fits"}


def test_swapped_views_are_never_verified(sample_views: Views) -> None:
    views = sample_views("stepped-block")
    strokes = dict(views.strokes)
    strokes[Role.FRONT], strokes[Role.TOP] = strokes[Role.TOP], strokes[Role.FRONT]
    _without_verdict(exact_solid(replace(views, strokes=strokes), _SMALL))


def test_a_missing_line_is_told_with_its_place(sample_views: Views, sample_solid: Solid) -> None:
    views = sample_views("l-bracket")
    inner = [
        s
        for s in views.strokes[Role.TOP]
        if isinstance(s, Segment) and s.linetype is Linetype.VISIBLE and 1.0 < s.start[0] < 79.0
    ]
    gone = max(inner, key=lambda stroke: stroke.length)
    kept = tuple(s for s in views.strokes[Role.TOP] if s is not gone)
    result = exact_solid(replace(views, strokes={**views.strokes, Role.TOP: kept}), _SMALL)
    _without_verdict(result)
    if result.shape is not None:
        assert "lines-unexplained" in _codes(result)
        assert result.verification.flaws[0].length > 1.0


def test_a_spurious_line_through_everything_is_told(sample_views: Views) -> None:
    views = sample_views("l-bracket")
    x, _, z = views.size
    line = Segment((0.0, 0.37 * z), (x, 0.61 * z), Linetype.VISIBLE)
    front = (*views.strokes[Role.FRONT], line)
    result = exact_solid(replace(views, strokes={**views.strokes, Role.FRONT: front}), _SMALL)
    _without_verdict(result)
    if result.shape is not None:
        assert "lines-unexplained" in _codes(result)
        assert {flaw.role for flaw in result.verification.flaws} >= {Role.FRONT}


def test_what_takes_more_work_than_there_may_be_is_told(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    limits = Limits(Effort(hard=0.5, relaxed=0.4, simplest=0.2), alternatives=1, work=0.0)
    result = exact_solid(sample_views("l-bracket"), limits)
    assert result.status is Status.FAILED and _codes(result) == {"search-unfinished"}


def _cube_without(*cells: tuple[int, int, int]) -> TopoDS_Shape:
    """A cube of 30 mm that lacks some of its 27 cells."""
    solid: TopoDS_Shape = _box(0, 0, 0, 30, 30, 30)
    for x, y, z in cells:
        solid = BRepAlgoAPI_Cut(solid, _box(10 * x, 10 * y, 10 * z, 10, 10, 10)).Shape()
    return solid


@pytest.mark.parametrize("lacks_one_more", [False, True])
def test_two_solids_with_the_same_lines_are_both_told(
    lacks_one_more: bool, drawn: Callable[..., DrawnViews]
) -> None:
    # The lines of the cell in doubt all lie under those of others, in every view.
    notches = [(0, 0, 1), (0, 2, 2), (2, 2, 1)]
    truths = [_cube_without(*notches), _cube_without(*notches, (0, 2, 1))]
    views = drawn(truths[lacks_one_more])
    result = exact_solid(views)
    assert result.status is Status.APPROXIMATE and _codes(result) == {"ambiguous"}
    solids = [result.shape, *result.alternatives]
    assert sorted(map(volume, solids)) == pytest.approx([23000.0, 24000.0])
    for truth in truths:
        assert sum(same_solid(truth, solid) for solid in solids) == 1
    for solid in solids:
        assert soundness(solid).valid and verify(solid, views).neat


def test_what_could_not_be_built_may_be_another_solid(
    drawn: Callable[..., DrawnViews], monkeypatch: pytest.MonkeyPatch
) -> None:
    built: list[BuiltSolid] = []

    def first_only(space: LabelledComplex, scale: float, deadline: Deadline) -> BuiltSolid:
        built.append(
            BuiltSolid(None, 1, closed=False) if built else build_solid(space, scale, deadline)
        )
        return built[-1]

    monkeypatch.setattr(candidates, "build_solid", first_only)
    result = exact_solid(drawn(_cube_without((0, 0, 1), (0, 2, 2), (2, 2, 1))))
    assert len(built) == 2 and result.alternatives == ()
    assert result.status is Status.APPROXIMATE and _codes(result) == {"search-unfinished"}


def test_surfaces_that_would_go_on_are_tried_first(
    sample_views: Views, sample_solid: Solid, iou: Iou, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The search leaves one cell wrong, as it does where rules do not tell; no other labels follow.
    fulfilled = Search.fulfilled

    def but_one(search: Search, deadline: Deadline) -> Labelling:
        found = fulfilled(search, deadline)
        cell = max(cell for cell, label in found.labels.items() if label)
        return replace(found, labels={**found.labels, cell: False})

    monkeypatch.setattr(Search, "fulfilled", but_one)
    monkeypatch.setattr(Search, "others", lambda *_, **__: Others((), True))
    result = exact_solid(sample_views("three-axis-block"))
    assert result.verification.explains
    assert iou(result.shape, sample_solid("three-axis-block")) == pytest.approx(1.0, abs=1e-6)


def test_without_alternatives_nothing_is_verified_that_is_ambiguous(
    drawn: Callable[..., DrawnViews],
) -> None:
    views = drawn(_cube_without((0, 0, 1), (0, 2, 2), (2, 2, 1)))
    result = exact_solid(views, replace(_SMALL, alternatives=0))
    assert result.status is Status.APPROXIMATE and _codes(result) == {"search-unfinished"}


def test_without_time_there_is_no_solid_and_the_reason_says_so(
    drawn: Callable[..., DrawnViews],
) -> None:
    # Labels of simpler parts follow before any time is counted.
    limits = Limits(Effort(hard=1e-9, relaxed=1e-9, simplest=1e-9))
    result = exact_solid(drawn(classed_part(PartClass.PLANES, 0, 0)), limits)
    assert result.status is Status.FAILED and _codes(result) == {"search-unfinished"}


def test_the_search_ends_with_the_work(sample_views: Views) -> None:
    result = exact_solid(sample_views("l-bracket"), Limits(work=0.0))
    assert result.status is Status.FAILED and _codes(result) == {"search-unfinished"}


def test_same_views_same_solid(sample_views: Views, solved: Solved) -> None:
    again = exact_solid(sample_views("l-bracket"))
    assert again.status is solved("l-bracket").status
    assert volume(again.shape) == volume(solved("l-bracket").shape)


def test_garbage_is_looked_for_again_afterwards(
    sample_views: Views, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        assert not gc.isenabled()
        raise KeyboardInterrupt

    monkeypatch.setattr(exact, "model_part", interrupted)
    with pytest.raises(KeyboardInterrupt):
        exact_solid(sample_views("l-bracket"))
    assert gc.isenabled()


@pytest.mark.parametrize(
    ("off", "pixel", "sure"),
    [(0.0, 0.05, True), (0.31, 0.05, True), (0.0, 0.12, True), (0.31, 0.12, False)],
)
def test_a_part_designed_in_steps_is_as_large_as_meant(
    off: float, pixel: float, sure: bool, drawn: Draw
) -> None:
    """A picture places every line a tenth of a pixel wrong: round measures tell how large the part
    is.  Where one is not round, another may be near a round one by chance, which has to be little.
    """
    solid = cut(
        box((0, 0, 0), (60, 40, 24)),
        box((0, 0, 16), (22, 40, 24)),
        box((46, -1, 20), (61, 41, 25)),
        box((28, 10 + off, 10), (40, 32, 25)),
        cylinder(Axis.Z, (11, 14), 6, -1, 25),
        cylinder(Axis.Z, (11, 28), 4, -1, 25),
    )
    found = exact_solid(_misplaced(drawn(solid), pixel))
    assert found.verification is not None and found.verification.explains
    assert found.status is Status.VERIFIED
    known = pytest.approx(1e-3)
    assert found.measures.uncertainty == (known if sure and not off else pytest.approx(_BOUND))
    if sure:
        within = 1e-3 if off else 1e-6
        assert volume(found.shape) == pytest.approx(volume(solid), rel=within)


@pytest.mark.parametrize(
    ("odd", "longer", "sure"), [(0.0, 0.0, True), (0.31, 0.0, False), (0.0, 0.36, False)]
)
def test_edges_that_follow_from_round_faces_are_no_odd_measures(
    odd: float, longer: float, sure: bool, drawn: Draw
) -> None:
    """A flat on a bar ends where the bar has it.  Where the longest extent is odd, nothing of that
    is certain: the others may be multiples of a part of it."""
    bar = fuse(
        cylinder(Axis.X, (20, 20), 20, 0, 60),
        cylinder(Axis.X, (20, 20), 14, 60, 84 + longer),
        cylinder(Axis.X, (20, 20), 17, 66, 78),
    )
    solid = cut(bar, box((10, -1, 34 + odd), (40, 41, 41)), cylinder(Axis.X, (20, 20), 6, -1, 90))
    found = exact_solid(_misplaced(drawn(solid), 0.2))
    assert found.status is Status.VERIFIED
    assert found.measures.uncertainty == pytest.approx(1e-3 if sure else _BOUND)
    if sure:
        assert volume(found.shape) == pytest.approx(volume(solid), rel=1e-6)


_BOUND = 0.04


def _misplaced(views: DrawnViews, pixel: float) -> DrawnViews:
    """Lines as a picture places them: a few micrometres beside where they belong."""
    random = np.random.default_rng(3)

    def moved(stroke: Segment | Arc) -> Segment | Arc:
        aside = random.normal(0.0, 0.004, 2)
        if isinstance(stroke, Arc):
            centre = (stroke.centre[0] + aside[0], stroke.centre[1] + aside[1])
            return replace(stroke, centre=centre)
        along = np.subtract(stroke.end, stroke.start)
        normal = np.array([-along[1], along[0]]) / np.hypot(*along)
        start, end = np.array([stroke.start, stroke.end]) + aside[0] * normal
        return replace(stroke, start=tuple(start), end=tuple(end))

    strokes = {role: tuple(map(moved, stroke)) for role, stroke in views.strokes.items()}
    return replace(views, strokes=strokes, tolerance=pixel, apart=0.02, noise=0.01, bound=_BOUND)
