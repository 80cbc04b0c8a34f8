import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_NurbsConvert
from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Elips, gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Edge

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.lines.edge_projection import project_edge
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

PRECISION = Precision(1e-4, 1e-3, 1e-2, 2e-2)
V = Linetype.VISIBLE


def _line(start: tuple, end: tuple) -> TopoDS_Edge:
    return BRepBuilderAPI_MakeEdge(gp_Pnt(*start), gp_Pnt(*end)).Edge()


def _circle(normal: tuple, *limits: float) -> TopoDS_Edge:
    circle = gp_Circ(gp_Ax2(gp_Pnt(10, 20, 30), gp_Dir(*normal)), 8.0)
    return BRepBuilderAPI_MakeEdge(circle, *limits).Edge()


def _splined(edge: TopoDS_Edge) -> TopoDS_Edge:
    shape = BRepBuilderAPI_NurbsConvert(edge).Shape()
    return TopoDS.Edge(subshapes(shape, TopAbs_ShapeEnum.TopAbs_EDGE)[0])


@given(st.lists(st.floats(-40, 40), min_size=6, max_size=6), st.sampled_from(Role))
def test_a_line_is_the_segment_between_its_projected_ends(values: list, role: Role) -> None:
    start, end = tuple(values[:3]), tuple(values[3:])
    if np.hypot(*(np.subtract(start, end)[:2])) < 1e-3:
        return
    stroke = project_edge(_line(start, end), role.frame, Linetype.HIDDEN, PRECISION)
    plane = np.array([role.frame.right, role.frame.up], dtype=float)
    expected = [plane @ start, plane @ end]
    if np.abs(expected[0] - expected[1]).max() < PRECISION.fit:
        assert stroke is None
        return
    assert stroke.linetype is Linetype.HIDDEN
    np.testing.assert_allclose([stroke.start, stroke.end], expected, atol=1e-9)


def test_a_line_towards_the_viewer_is_nothing() -> None:
    assert project_edge(_line((1, 2, 3), (1, 9, 3)), Role.FRONT.frame, V, PRECISION) is None


@pytest.mark.parametrize("splined", [False, True])
def test_a_circle_faced_is_a_circle_even_if_it_is_a_spline(splined: bool) -> None:
    edge = _circle((0, 0, 1))
    stroke = project_edge(_splined(edge) if splined else edge, Role.BOTTOM.frame, V, PRECISION)
    assert isinstance(stroke, Arc)
    assert stroke.centre == pytest.approx((10.0, -20.0), abs=1e-6)
    assert (stroke.radius, stroke.sweep) == pytest.approx((8.0, 2 * np.pi), abs=1e-6)


@settings(max_examples=30)
@given(st.floats(0.0, 6.2), st.floats(0.3, 6.2), st.booleans(), st.sampled_from(Role))
def test_part_of_a_circle_seen_edge_on_reaches_to_its_furthest_points(
    first: float, sweep: float, splined: bool, role: Role
) -> None:
    normal = {Role.FRONT: (1, 0, 0), Role.TOP: (0, 1, 0)}.get(role, (0, 0, 1))
    if np.dot(normal, role.frame.look):
        normal = (1, 0, 0)
    edge = _circle(normal, first, first + sweep)
    stroke = project_edge(_splined(edge) if splined else edge, role.frame, V, PRECISION)
    curve = BRepAdaptor_Curve(edge)
    points = [curve.Value(at) for at in np.linspace(first, first + sweep, 4001)]
    flat = (
        np.array([(p.X(), p.Y(), p.Z()) for p in points])
        @ np.array([role.frame.right, role.frame.up], dtype=float).T
    )
    assert isinstance(stroke, Segment)
    np.testing.assert_allclose(stroke.box, [*flat.min(axis=0), *flat.max(axis=0)], atol=2e-5)


def test_an_arc_keeps_its_angles() -> None:
    stroke = project_edge(_circle((0, 0, 1), 0.5, 2.0), Role.TOP.frame, V, PRECISION)
    assert (stroke.start_angle, stroke.sweep) == pytest.approx((0.5, 1.5))
    mirrored = project_edge(_circle((0, 0, 1), 0.5, 2.0), Role.BOTTOM.frame, V, PRECISION)
    assert (mirrored.start_angle, mirrored.sweep) == pytest.approx((2 * np.pi - 2.0, 1.5))


def test_a_leaning_circle_is_a_chain_on_its_ellipse() -> None:
    stroke = project_edge(_circle((0, 3, 4)), Role.TOP.frame, V, PRECISION)
    assert isinstance(stroke, Polyline)
    points = (np.array(stroke.points) - [10, 20]) / [8.0, 8.0 * 0.8]
    np.testing.assert_allclose(np.hypot(*points.T), 1.0, atol=1e-9)
    middles = (points[1:] + points[:-1]) / 2.0
    assert np.abs(np.hypot(*middles.T) - 1.0).max() * 8.0 <= PRECISION.chord


def test_an_ellipse_seen_so_that_it_is_round_is_a_circle() -> None:
    ellipse = gp_Elips(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 3, 4), gp_Dir(0, 4, -3)), 10.0, 8.0)
    stroke = project_edge(BRepBuilderAPI_MakeEdge(ellipse).Edge(), Role.TOP.frame, V, PRECISION)
    assert isinstance(stroke, Arc)
    assert stroke.radius == pytest.approx(8.0, abs=1e-6)
