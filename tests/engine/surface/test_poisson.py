"""Poisson surface: closed, close to the solid, the same every time."""

import numpy as np
import pytest
import trimesh

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.meshes import TriangleMesh, connected_pieces, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.surface import poisson
from gaussiancad_core.surface.points import OrientedPoints
from gaussiancad_core.surface.poisson import (
    DENSE,
    PoissonSettings,
    gaussian_surface,
    poisson_surface,
)
from gaussiancad_core.surface.repair import intersection

SETTINGS = PoissonSettings(depth=7)


@pytest.fixture(scope="module")
def surface(bracket_gaussians: Gaussians) -> TriangleMesh:
    return gaussian_surface(bracket_gaussians, SETTINGS)


def test_surface_is_one_closed_piece_about_the_solid(
    surface: TriangleMesh, bracket: TriangleMesh
) -> None:
    assert surface.watertight
    assert len(connected_pieces(surface)) == 1
    assert surface.to_trimesh().euler_number == 2
    assert surface.volume == pytest.approx(bracket.volume, rel=0.01)
    assert surface.bounds == pytest.approx(bracket.bounds, abs=0.4)


def test_surface_lies_close_to_the_solid_both_ways(
    surface: TriangleMesh, bracket: TriangleMesh
) -> None:
    there = _mean_distance(surface, bracket)
    back = _mean_distance(bracket, surface)
    # In a box whose longest edge is 5 units, as the drawn 20 mm are here.
    assert (there + back) * 5.0 / 20.0 < 0.01


def test_more_points_bring_the_surface_nearer_and_leave_one_piece(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    few, many = (
        gaussian_surface(bracket_gaussians, settings) for settings in (PoissonSettings(), DENSE)
    )
    assert len(connected_pieces(few)) == len(connected_pieces(many)) == 1
    assert many.watertight
    assert _mean_distance(many, bracket) < _mean_distance(few, bracket)


def test_what_lies_outside_the_hull_is_cut_off(
    surface: TriangleMesh, bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    cut = gaussian_surface(bracket_gaussians, SETTINGS, within=bracket)
    assert cut.watertight
    assert cut.bounds == pytest.approx(bracket.bounds, abs=1e-6)
    assert cut.volume < min(surface.volume, bracket.volume)
    assert cut.volume == pytest.approx(bracket.volume, rel=0.01)
    far = make_mesh(bracket.vertices + 100.0, bracket.triangles)
    with pytest.raises(NoModelError):
        gaussian_surface(bracket_gaussians, SETTINGS, within=far)


def test_where_sharp_edges_cannot_be_cut_round_ones_are(
    bracket: TriangleMesh, bracket_gaussians: Gaussians, monkeypatch: pytest.MonkeyPatch
) -> None:
    bodies = []

    def refuse_once(body: TriangleMesh, *others: object) -> TriangleMesh | None:
        bodies.append(body)
        return intersection(body, *others) if len(bodies) > 1 else None

    monkeypatch.setattr(poisson, "intersection", refuse_once)
    assert gaussian_surface(bracket_gaussians, SETTINGS, within=bracket).watertight
    sharp, rounded = bodies
    assert _mean_distance(sharp, bracket) < _mean_distance(rounded, bracket)


def _mean_distance(source: TriangleMesh, target: TriangleMesh) -> float:
    points = trimesh.sample.sample_surface(source.to_trimesh(), 2000, seed=0)[0]
    return float(trimesh.proximity.closest_point(target.to_trimesh(), points)[1].mean())


def test_same_gaussians_same_mesh(surface: TriangleMesh, bracket_gaussians: Gaussians) -> None:
    again = gaussian_surface(bracket_gaussians, SETTINGS)
    assert np.array_equal(again.vertices, surface.vertices)
    assert np.array_equal(again.triangles, surface.triangles)


def test_a_hole_stays_a_hole() -> None:
    ring = trimesh.creation.torus(major_radius=10.0, minor_radius=3.0)
    mesh = TriangleMesh(np.asarray(ring.vertices), np.asarray(ring.faces))
    found = gaussian_surface(gaussians_on(mesh, Start(count=1500)), SETTINGS)
    assert found.watertight
    assert found.to_trimesh().euler_number == 0
    assert found.volume == pytest.approx(mesh.volume, rel=0.02)


def test_two_bodies_stay_two_and_crumbs_go() -> None:
    def ball(radius: float, at: float, count: int) -> Gaussians:
        mesh = trimesh.creation.icosphere(subdivisions=3, radius=radius)
        mesh.apply_translation((at, 0, 0))
        surface = TriangleMesh(np.asarray(mesh.vertices), np.asarray(mesh.faces))
        return gaussians_on(surface, Start(count=count))

    names = ("means", "quaternions", "log_scales", "logit_opacities", "colours", "normals")
    parts = [ball(10.0, 0.0, 1000), ball(6.0, 25.0, 400), ball(0.8, -20.0, 60)]
    all_three = Gaussians(*(np.concatenate([getattr(g, name) for g in parts]) for name in names))
    pieces = connected_pieces(gaussian_surface(all_three, SETTINGS))
    volumes = [piece.volume for piece in pieces]
    assert volumes == [pytest.approx(4 / 3 * np.pi * radius**3, rel=0.05) for radius in (10.0, 6.0)]


def test_nothing_to_go_by_is_told() -> None:
    with pytest.raises(NoModelError) as caught:
        poisson_surface(OrientedPoints(np.zeros((0, 3)), np.zeros((0, 3))), SETTINGS)
    assert caught.value.code == "no-surface"


def test_a_surface_turned_inside_out_bounds_no_body(ball: TriangleMesh) -> None:
    points = ball.vertices
    inward = OrientedPoints(points, -points / np.linalg.norm(points, axis=1, keepdims=True))
    with pytest.raises(NoModelError):
        poisson_surface(inward, SETTINGS)
