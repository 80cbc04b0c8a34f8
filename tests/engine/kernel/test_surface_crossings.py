import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_NurbsConvert
from OCP.BRepPrimAPI import BRepPrimAPI_MakeTorus
from OCP.Geom import Geom_ToroidalSurface
from OCP.gp import gp_Ax2, gp_Ax3, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Face

from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.surface_crossings import Crossings, surface_of
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import cone, cylinder, leaning_cylinder, sphere

LOOK = np.array([0.0, 1.0, 0.0])
AXES = [np.array(axis, dtype=float) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, -1))]


def _curved(shape: object) -> TopoDS_Face:
    return faces_of(shape)[0]


def _torus(major: float, minor: float, direction: tuple[float, float, float]) -> TopoDS_Face:
    frame = gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(*direction))
    return _curved(BRepPrimAPI_MakeTorus(frame, major, minor).Shape())


SHAPES = {
    "cylinder": (
        _curved(leaning_cylinder((1, 2, 3), (1, 2, -1), 5, 40)),
        lambda p, n: _from_axis(p, (1, 2, 3), (1, 2, -1)) - 5,
    ),
    "sphere": (_curved(sphere((1, 2, 3), 6)), lambda p, n: np.linalg.norm(p - [1, 2, 3]) - 6),
    "cone": (
        _curved(cone(Axis.Z, (1, 2), (3, 9), 0, 12)),
        lambda p, n: np.hypot(p[0] - 1, p[1] - 2) - abs(3 + p[2] / 2),
    ),
    "torus": (
        _torus(9, 3, (1, 1, 1)),
        lambda p, n: (
            np.hypot(_from_axis(p, (1, 2, 3), (1, 1, 1)) - 9, _along(p, (1, 2, 3), (1, 1, 1))) - 3
        ),
    ),
}


def _along(p: np.ndarray, origin: tuple, axis: tuple) -> float:
    return float((p - np.array(origin)) @ np.array(axis) / np.linalg.norm(axis))


def _from_axis(p: np.ndarray, origin: tuple, axis: tuple) -> float:
    offset = p - np.array(origin)
    return float(np.sqrt(max(0.0, offset @ offset - _along(p, origin, axis) ** 2)))


def _points(found: Crossings, origins: np.ndarray, look: np.ndarray) -> np.ndarray:
    return origins[found.line] + found.depth[:, None] * look


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("look", AXES, ids=("x", "y", "-z"))
def test_crossings_lie_on_the_surface_and_know_its_normal_and_parameters(
    name: str, look: np.ndarray
) -> None:
    face, residual = SHAPES[name]
    origins = np.random.default_rng(3).uniform(-9.0, 12.0, (60, 3))
    found = surface_of(face, 1e-7).crossings(origins, look)
    assert len(found.line) > 10
    adaptor = BRepAdaptor_Surface(face)
    points = _points(found, origins, look)
    for point, normal, (u, v) in zip(points, found.normal, found.parameters.tolist(), strict=True):
        assert abs(residual(point, normal)) < 1e-7
        back = adaptor.Value(u, v)
        np.testing.assert_allclose([back.X(), back.Y(), back.Z()], point, atol=1e-7)
        assert np.linalg.norm(normal) == pytest.approx(1.0)
        step = 1e-5
        neighbour = adaptor.Value(u + step, v)
        tangent = (np.array([neighbour.X(), neighbour.Y(), neighbour.Z()]) - point) / step
        assert abs(normal @ tangent) < 1e-3 * max(1.0, np.linalg.norm(tangent))


@pytest.mark.parametrize(("major", "minor"), [(4.0, 5.0), (2.0, 9.0)])
def test_a_torus_wider_than_its_ring_is_met_on_both_of_its_sheets(
    major: float, minor: float
) -> None:
    surface = Geom_ToroidalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), major, minor)
    face = BRepBuilderAPI_MakeFace(surface, 1e-9).Face()
    origins = np.random.default_rng(1).uniform(-major - minor, major + minor, (200, 3))
    found = surface_of(face, 1e-7).crossings(origins, LOOK)
    points = _points(found, origins, LOOK)
    radial = np.hypot(points[:, 0], points[:, 1])
    outer = np.abs(np.hypot(radial - major, points[:, 2]) - minor) < 1e-6
    inner = np.abs(np.hypot(radial + major, points[:, 2]) - minor) < 1e-6
    assert np.all(outer | inner)
    assert outer.sum() > 50
    assert inner.sum() > 8
    for point, (u, v) in zip(points, found.parameters.tolist(), strict=True):
        back = surface.Value(u, v)
        np.testing.assert_allclose([back.X(), back.Y(), back.Z()], point, atol=1e-6)


@settings(max_examples=25, deadline=None)
@given(st.sampled_from(sorted(SHAPES)), st.integers(0, 2), st.integers(0, 10_000))
def test_closed_forms_agree_with_the_general_intersector(name: str, axis: int, seed: int) -> None:
    face = SHAPES[name][0]
    spline = faces_of(BRepBuilderAPI_NurbsConvert(face).Shape())[0]
    look = np.eye(3)[axis]
    origins = np.random.default_rng(seed).uniform(-8.0, 12.0, (6, 3))
    exact = surface_of(face, 1e-7).crossings(origins, look)
    general = surface_of(spline, 1e-7).crossings(origins, look)
    inside = _inside(face, exact)
    for line in range(len(origins)):
        mine = np.sort(exact.depth[inside & (exact.line == line)])
        theirs = np.sort(general.depth[general.line == line])
        if len(mine) == len(theirs):
            np.testing.assert_allclose(mine, theirs, atol=1e-4)
        else:
            # Only a line that grazes the surface may be met once more or less.
            grazing = np.abs(exact.normal[exact.line == line] @ look)
            assert grazing.min(initial=0.0) < 0.05 or _near_border(face, exact, line)


def _inside(face: TopoDS_Face, found: Crossings) -> np.ndarray:
    surface = BRepAdaptor_Surface(face)
    if surface.IsVPeriodic():
        return np.ones(len(found.line), bool)
    v = found.parameters[:, 1]
    return (v >= surface.FirstVParameter()) & (v <= surface.LastVParameter())


def _near_border(face: TopoDS_Face, found: Crossings, line: int) -> bool:
    surface = BRepAdaptor_Surface(face)
    v = found.parameters[found.line == line, 1]
    ends = np.array([surface.FirstVParameter(), surface.LastVParameter()])
    return bool(len(v)) and bool(np.abs(v[:, None] - ends).min() < 1e-3)


def test_a_plane_seen_edge_on_is_not_met() -> None:
    rod = cylinder(Axis.Z, (0, 0), 5, 0, 10)
    origins = np.zeros((3, 3))
    flat = [surface_of(face, 1e-7) for face in faces_of(rod)[1:]]
    for surface in flat:
        assert len(surface.crossings(origins, np.array([1.0, 0.0, 0.0])).line) == 0
        along = surface.crossings(origins, np.array([0.0, 0.0, 1.0]))
        assert along.depth.tolist() in ([0.0] * 3, [10.0] * 3)
