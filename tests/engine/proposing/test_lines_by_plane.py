"""Strokes as surfaces seen edge-on, and the places along an axis that they tell."""

from collections.abc import Callable

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment
from gaussiancad_core.proposing.edge_on_surfaces import SurfaceKind, SurfaceTable
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet, plane_sheet
from sample_parts.modelling import box, cut, cylinder

Draw = Callable[[TopoDS_Shape], DrawnViews]

_PART = cut(
    box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)),
    box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)),
    cylinder(Axis.Z, (15.0, 12.0), 5.0, -1.0, 31.0),
)


def _sheet(views: DrawnViews) -> PlaneSheet:
    return plane_sheet(views, find_places(views, views.tolerance))


def test_levels_are_where_strokes_lie_and_where_circles_end(drawn: Draw) -> None:
    sheet = _sheet(drawn(_PART))
    assert sheet.levels[Axis.Z] == pytest.approx([0.0, 18.0, 30.0])
    assert sheet.levels[Axis.X] == pytest.approx([0.0, 10.0, 20.0, 40.0, 60.0])


def test_one_plane_has_one_number_in_all_views(drawn: Draw) -> None:
    sheet = _sheet(drawn(_PART))
    step = sheet.across(Axis.Z, 18.0)
    views = {view.role for view in sheet.views for line in view.lines if line.surface == step}
    assert views == {Role.FRONT, Role.RIGHT}


def test_surfaces_within_the_tolerance_are_one() -> None:
    table = SurfaceTable(0.01)
    first = table.number(SurfaceKind.CYLINDER, Axis.Z, 5.0, 5.0, 2.0)
    assert table.number(SurfaceKind.CYLINDER, Axis.Z, 5.02, 5.0, 2.0) == first
    assert table.number(SurfaceKind.CYLINDER, Axis.Z, 5.0, 5.0, 2.1) != first
    assert table.number(SurfaceKind.CYLINDER, Axis.X, 5.0, 5.0, 2.0) != first
    for number in range(40):
        table.number(SurfaceKind.ACROSS, Axis.X, float(number))
    assert table.number(SurfaceKind.ACROSS, Axis.X, 39.0) == len(table) - 1


def test_joins_go_to_the_first_of_all() -> None:
    table = SurfaceTable(0.01)
    numbers = [table.number(SurfaceKind.ACROSS, Axis.X, float(value)) for value in range(4)]
    table.join(numbers[3], numbers[2])
    table.join(numbers[2], numbers[1])
    assert table.roots().tolist() == [0, 1, 1, 1]


def test_an_arc_and_its_tangents_are_one_to_the_eye() -> None:
    strokes = (
        Segment((0.0, 0.0), (30.0, 0.0), Linetype.VISIBLE),
        Arc((30.0, 10.0), 10.0, -np.pi / 2.0, np.pi / 2.0, Linetype.VISIBLE),
        Segment((40.0, 10.0), (40.0, 20.0), Linetype.VISIBLE),
        Segment((40.0, 20.0), (0.0, 20.0), Linetype.VISIBLE),
        Segment((0.0, 20.0), (0.0, 0.0), Linetype.VISIBLE),
    )
    sheet = _sheet(exact_views({Role.FRONT: strokes}, (40.0, 10.0, 20.0)))
    roots = sheet.surfaces.roots()
    bottom, arc, side, top, other = (roots[line.surface] for line in sheet.views[0].lines)
    assert bottom == arc == side
    assert len({bottom, top, other}) == 3


def test_a_circle_that_was_read_as_an_ellipse_is_a_circle() -> None:
    ellipse = Ellipse((10.0, 10.0), 5.001, 4.999, 0.3, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
    slim = Ellipse((30.0, 10.0), 5.0, 3.0, 0.3, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
    views = exact_views({Role.TOP: (ellipse, slim)}, (40.0, 20.0, 5.0))
    sheet = _sheet(DrawnViews(views.strokes, views.size, 0.01))
    circle, free = (sheet.surfaces[line.surface] for line in sheet.views[0].lines)
    assert circle.kind is SurfaceKind.CYLINDER
    assert circle.values == pytest.approx((10.0, 10.0, 5.0))
    assert free.kind is SurfaceKind.FREE
