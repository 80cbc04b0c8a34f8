"""Closed areas of a plane: outlines that close, regions, and the surfaces behind their edges."""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet, plane_sheet
from gaussiancad_core.proposing.loop_places import prisms_of
from gaussiancad_core.proposing.loop_shapes import loops_of
from gaussiancad_core.proposing.plane_loops import LoopKind, PlaneLoops, plane_loops
from sample_parts.modelling import box, cut, cylinder

Draw = Callable[[TopoDS_Shape], DrawnViews]
Point = tuple[float, float]


def _sheet(views: DrawnViews) -> PlaneSheet:
    return plane_sheet(views, find_places(views, views.tolerance))


def _front(strokes: Sequence[Segment | Arc], tolerance: float = 0.01) -> PlaneSheet:
    return _sheet(DrawnViews({Role.FRONT: tuple(strokes)}, (40.0, 10.0, 20.0), tolerance))


def _chain(*corners: Point) -> list[Segment]:
    return [Segment(start, end, Linetype.VISIBLE) for start, end in pairwise(corners)]


def _loops(sheet: PlaneSheet) -> PlaneLoops:
    found = plane_loops(sheet, Axis.Y)
    assert found is not None
    return found


def test_a_rectangle_is_its_outline() -> None:
    found = _loops(_front(_chain((0, 0), (40, 0), (40, 20), (0, 20), (0, 0))))
    assert found.is_closed
    assert found.outline.area == pytest.approx(800.0)
    assert len(found.regions) == 1


@pytest.mark.parametrize("gap", [0.015, 0.05, 3.0])
def test_an_outline_with_a_gap_is_closed_all_the_same(gap: float) -> None:
    # By ends that are one, by longer lines, and by a bridge.
    strokes = _chain((0, 0), (40, 0), (40, 20), (0, 20), (0, gap))
    found = _loops(_front(strokes))
    assert found.is_closed
    assert found.outline.area == pytest.approx(800.0, rel=1e-3)


def test_ends_that_pass_each_other_smoothly_are_one() -> None:
    # Lengthened along themselves an arc and its tangent would never meet.
    strokes = [
        *_chain((0, 0), (30.0, 0.004)),
        Arc((30.0, 10.0), 10.0, -np.pi / 2.0, np.pi / 2.0, Linetype.VISIBLE),
        *_chain((40.0, 10.0), (40, 20), (0, 20), (0, 0)),
    ]
    found = _loops(_front(strokes))
    assert found.is_closed
    assert found.outline.area == pytest.approx(800.0 - 100.0 + 25.0 * np.pi, rel=1e-3)


def test_what_no_line_encloses_is_nothing() -> None:
    assert plane_loops(_front(_chain((0, 0), (40, 0))), Axis.Y) is None


def test_the_shapes_of_a_plate_with_a_hole(drawn: Draw) -> None:
    plate = cut(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 10.0)),
        cylinder(Axis.Z, (15.0, 12.0), 5.0, -1.0, 11.0),
    )
    sheet = _sheet(drawn(plate))
    plane = plane_loops(sheet, Axis.Z)
    assert plane is not None
    loops = loops_of(sheet, plane)
    kinds = {loop.kind: loop.polygon.area for loop in loops if loop.kind is not LoopKind.REGION}
    assert kinds[LoopKind.OUTLINE] == pytest.approx(2400.0, rel=1e-4)
    areas = sorted(loop.polygon.area for loop in loops if loop.kind is LoopKind.REGION)
    assert areas == pytest.approx([78.5, 2321.5], rel=2e-3)
    # The disc is its region, and the region filled is the outline: each is there once.
    assert LoopKind.CIRCLE not in kinds
    assert LoopKind.FILLED not in kinds


def test_edges_have_the_surfaces_of_the_lines_that_they_lie_on(drawn: Draw) -> None:
    sheet = _sheet(drawn(box((0.0, 0.0, 0.0), (60.0, 40.0, 10.0))))
    plane = plane_loops(sheet, Axis.Z)
    assert plane is not None
    loop = loops_of(sheet, plane)[0]
    sides = {(Axis.X, 0.0), (Axis.X, 60.0), (Axis.Y, 0.0), (Axis.Y, 40.0)}
    behind = [sheet.surfaces[number] for number in loop.surfaces.tolist()]
    found = {(surface.axis, surface.values[0]) for surface in behind}
    assert found == sides


def test_a_prism_ends_where_other_views_show_lines(drawn: Draw) -> None:
    part = cut(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)),
        box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)),
    )
    sheet = _sheet(drawn(part))
    plane = plane_loops(sheet, Axis.Z)
    assert plane is not None
    step = min(loops_of(sheet, plane), key=lambda loop: loop.polygon.area)
    spans = {(prism.low, prism.high) for prism in prisms_of(sheet, step)}
    assert spans == {(0.0, 18.0), (0.0, 30.0), (18.0, 30.0)}
