"""Labelled cells as a B-Rep."""

from collections.abc import Callable
from itertools import pairwise
from math import asin, pi

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeSolid,
    BRepBuilderAPI_Sewing,
)
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakeTorus,
)
from OCP.gp import gp_Ax2, gp_Ax3, gp_Cylinder, gp_Dir, gp_Pnt, gp_Sphere
from OCP.TopoDS import TopoDS, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.cells.surfaces_of_revolution import ArcProfile, SurfaceOfRevolution
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.kernel.brep import bounding_box, faces_of, soundness, volume
from gaussiancad_core.labelling.cell_labelling import Effort, Search
from gaussiancad_core.labelling.counted_work import OVER
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.solid import boundary_building
from gaussiancad_core.solid.boundary_building import BuiltSolid, build_solid
from gaussiancad_core.solid.extra_faces import revolved_face
from gaussiancad_core.solid.face_patches import Patch, PlanePatch, find_patches
from gaussiancad_core.solid.labelled_cells import LabelledComplex

Labelled = Callable[[str], tuple[PartModel, LabelledComplex]]
Draw = Callable[..., DrawnViews]

_CURVED = ("counterbored-block", "filleted-block", "slotted-link", "stepped-shaft", "ball-knob")


@pytest.mark.parametrize("name", ["pocket-block", "dovetail-block", *_CURVED])
def test_the_part_is_built_with_its_faces_and_volume(
    name: str, labelled: Labelled, sample_solid: Callable[[str], TopoDS_Shape]
) -> None:
    part, space = labelled(name)
    built = build_solid(space, part.carriers.scale)
    truth = soundness(sample_solid(name))
    assert built.bodies == 1 and built.shape is not None
    state = soundness(built.shape)
    assert (state.valid, state.closed, state.solids) == (True, True, 1)
    assert state.faces == truth.faces
    assert state.volume_mm3 == pytest.approx(truth.volume_mm3, rel=1e-7)


def _box(x: float, y: float, z: float, *size: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), *size).Solid()


def _built(solid: TopoDS_Shape, drawn: Draw) -> BuiltSolid:
    part = model_part(drawn(solid))
    labels = Search(part.rules, Effort()).best(relaxed=False).labels
    assert labels is not None
    return build_solid(LabelledComplex(part.space, labels), part.carriers.scale)


def test_a_cavity_is_a_second_shell(drawn: Draw) -> None:
    hollow = BRepAlgoAPI_Cut(_box(0, 0, 0, 40, 30, 20), _box(10, 5, 4, 12, 11, 9)).Shape()
    built = _built(hollow, drawn)
    assert built.bodies == 1 and built.shape is not None
    state = soundness(built.shape)
    assert (state.valid, state.closed, state.solids, state.faces) == (True, True, 1, 12)
    assert state.volume_mm3 == pytest.approx(40 * 30 * 20 - 12 * 11 * 9)


def test_separate_bodies_are_counted_and_make_no_solid_but_the_largest_is_told(
    drawn: Draw,
) -> None:
    apart = BRepAlgoAPI_Fuse(_box(0, 0, 0, 10, 30, 20), _box(25, 0, 0, 15, 30, 20)).Shape()
    hollow = BRepAlgoAPI_Cut(apart, _box(30, 5, 4, 5, 11, 9)).Shape()
    built = _built(hollow, drawn)
    assert built == BuiltSolid(None, 2, largest=built.largest)
    assert built.largest is not None
    assert soundness(built.largest).valid
    assert volume(built.largest) == pytest.approx(15 * 30 * 20 - 5 * 11 * 9)
    assert bounding_box(built.largest) == pytest.approx(np.array([[25, 0, 0], [40, 30, 20]]))


def test_no_material_no_solid(labelled: Labelled) -> None:
    part, space = labelled("stepped-block")
    void = LabelledComplex(part.space, dict.fromkeys(space.labels, False))
    assert build_solid(void, part.carriers.scale).shape is None


def test_all_material_is_the_space_that_the_outlines_leave(labelled: Labelled) -> None:
    part, space = labelled("pocket-block")
    full = LabelledComplex(part.space, dict.fromkeys(space.labels, True))
    built = build_solid(full, part.carriers.scale)
    assert built.shape is not None
    low, high = bounding_box(built.shape)
    assert soundness(built.shape).faces == 6
    assert volume(built.shape) == pytest.approx(float((high - low).prod()))


def test_stretches_are_the_material_along_a_line(labelled: Labelled) -> None:
    part, space = labelled("pocket-block")
    values = part.space.values
    for normal in values:
        first, second = (values[axis][-1] for axis in values if axis is not normal)
        for low, high in space.stretches(normal, 0.31 * first, 0.47 * second):
            assert low < high
            for share in (0.01, 0.5, 0.99):
                point = [0.31 * first, 0.47 * second]
                point.insert(normal.value, low + share * (high - low))
                assert space.is_material(tuple(point))


def _low_step(height: float) -> tuple[PartModel, LabelledComplex]:
    """A plate, its left half higher; the front view does not show where the step is."""

    def rectangle(width: float, top: float) -> list[Segment]:
        corners = [(0.0, 0.0), (width, 0.0), (width, top), (0.0, top), (0.0, 0.0)]
        return [Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(corners)]

    top = 30.0 + height
    level = {x: Segment((0.0, 30.0), (x, 30.0), Linetype.VISIBLE) for x in (100.0, 60.0)}
    strokes = {
        Role.FRONT: [*rectangle(100.0, top), level[100.0]],
        Role.TOP: [*rectangle(100.0, 60.0), Segment((50.0, 0.0), (50.0, 60.0), Linetype.VISIBLE)],
        Role.RIGHT: [*rectangle(60.0, top), level[60.0]],
    }
    part = model_part(exact_views(strokes, (100.0, 60.0, top)))
    places = [(x, 30.0, z) for x in (25.0, 75.0) for z in (15.0, 30.0 + height / 2.0)]
    labels = {part.space.cell_at(place): place[0] < 50.0 or place[2] < 30.0 for place in places}
    return part, LabelledComplex(part.space, labels)


def test_where_faces_do_not_close_narrower_ones_are_taken_along_if_there_is_time() -> None:
    height = 0.04
    part, space = _low_step(height)
    still_open = build_solid(space, part.carriers.scale, OVER)
    assert not still_open.closed and still_open.open_at
    built = build_solid(space, part.carriers.scale)
    assert built.shape is not None and soundness(built.shape).faces == 8
    assert volume(built.shape) == pytest.approx(60 * (100 * 30 + 50 * height), rel=1e-9)


@pytest.mark.parametrize("attempt", ["first", "forced"])
def test_what_was_forced_together_counts_if_it_is_sound(
    monkeypatch: pytest.MonkeyPatch, attempt: str
) -> None:
    """An open box called a solid: as the first attempt gave it, or a coarser one."""
    faces = faces_of(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape())[:-1]
    sewing = BRepBuilderAPI_Sewing()
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    broken = BRepBuilderAPI_MakeSolid(TopoDS.Shell(sewing.SewedShape())).Solid()
    assert not BRepCheck_Analyzer(broken).IsValid()
    attempts = iter([BuiltSolid(None, 0, closed=False)] if attempt == "forced" else [])
    monkeypatch.setattr(
        boundary_building, "_built", lambda *_: next(attempts, BuiltSolid(broken, 1))
    )
    found = boundary_building.build_solid(None, 1.0)
    assert (found.shape is None) == (attempt == "forced")
    assert found.closed == (attempt == "first")


def _round_groove(x: float, y: float, radius: float) -> TopoDS_Shape:
    """A ring 1 mm to both sides of a circle: 1 mm straight up from the ground, then half round."""
    ground, top = (gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)) for z in (0.0, 1.0))
    outer, inner = (
        BRepPrimAPI_MakeCylinder(ground, radius + way, 1.0).Solid() for way in (1.0, -1.0)
    )
    wall = BRepAlgoAPI_Cut(outer, inner).Shape()
    return BRepAlgoAPI_Fuse(wall, BRepPrimAPI_MakeTorus(top, radius, 1.0).Solid()).Shape()


def test_a_face_that_only_touches_others_does_not_keep_them_open(
    drawn: Draw, monkeypatch: pytest.MonkeyPatch
) -> None:
    block = BRepAlgoAPI_Cut(_box(0, 0, 0, 94, 60, 22), _round_groove(38, 30, 15)).Shape()
    part = model_part(drawn(block))
    units = part.carriers.scale
    touching = PlanePatch(Axis.Z, 2.0 * units, (36 * units, 39.2 * units, 15 * units, 16 * units))

    def with_touching(space: LabelledComplex, narrow: float) -> list[Patch]:
        return [*find_patches(space, narrow), touching]

    monkeypatch.setattr(boundary_building, "_FITS", boundary_building._FITS[:1])
    monkeypatch.setattr(boundary_building, "find_patches", with_touching)
    built = _built(block, drawn)
    assert built.shape is not None
    assert BRepCheck_Analyzer(built.shape).IsValid()
    assert volume(built.shape) == pytest.approx(volume(block), rel=1e-7)


class _Rod:
    """A round rod of radius 10 and height 10 on the ground, with a dome."""

    strip = 2e-5

    def is_material(self, point: tuple[float, float, float]) -> bool:
        x, y, z = point
        return z > 0.0 and x * x + y * y + max(0.0, z - 10.0) ** 2 < 100.0

    def faces(self) -> list[TopoDS_Face]:
        """Where the dome touches the wall, both go on along each other for a strip."""
        wall = gp_Cylinder(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 10.0)
        dome = gp_Sphere(gp_Ax3(gp_Pnt(0, 0, 10), gp_Dir(0, 0, 1)), 10.0)
        angle = asin(self.strip / 10.0)
        (ground,) = (
            face
            for face in faces_of(BRepPrimAPI_MakeCylinder(10.0, 10.0).Solid())
            if bounding_box(face)[1][2] < 1.0
        )
        swept = [
            (wall, 0.0, 10.0),
            (wall, 10.0, 10.0 + self.strip),
            (dome, 0.0, angle),
            (dome, angle, pi / 2.0),
        ]
        return [
            ground,
            *(BRepBuilderAPI_MakeFace(item, 0.0, 2.0 * pi, *ends).Face() for item, *ends in swept),
        ]


def test_faces_that_the_kernel_cannot_make_do_not_close(
    labelled: Labelled, monkeypatch: pytest.MonkeyPatch
) -> None:
    part, space = labelled("pocket-block")
    # Its profile crosses the axis that it turns about.
    crossing = SurfaceOfRevolution(Axis.Z, (20.0, 20.0), ArcProfile(5.0, 25.0, 15.0, 8.0, 10.0, -1))
    monkeypatch.setattr(boundary_building, "_face", lambda patch: revolved_face(crossing))
    assert build_solid(space, part.carriers.scale) == BuiltSolid(None, 0, closed=False)


def test_strips_narrower_than_seams_do_not_part_a_body() -> None:
    rod = _Rod()
    sewn = boundary_building._sewn_best(boundary_building._Sides(rod), rod.faces(), 1e-4)
    assert sewn.closed and sewn.count == 1
    assert volume(sewn.solid) == pytest.approx(pi * (1000.0 + 2000.0 / 3.0), rel=1e-4)
