"""Poisson surface: closed, close to the solid, the same every time."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.surface.oriented_points import OrientedPoints
from gaussiancad_core.surface.poisson import (
    DENSE,
    PoissonSettings,
    gaussian_surface,
    poisson_surface,
)

SETTINGS = PoissonSettings(depth=7)


def test_surface_is_one_closed_piece_about_the_solid(
    bracket_surface: TriangleMesh, bracket: TriangleMesh
) -> None:
    assert bracket_surface.watertight
    assert len(connected_pieces(bracket_surface)) == 1
    assert bracket_surface.to_trimesh().euler_number == 2
    assert bracket_surface.volume == pytest.approx(bracket.volume, rel=0.01)
    assert bracket_surface.bounds == pytest.approx(bracket.bounds, abs=0.4)


def test_surface_lies_close_to_the_solid_both_ways(
    bracket_surface: TriangleMesh, bracket: TriangleMesh
) -> None:
    there = _mean_distance(bracket_surface, bracket)
    back = _mean_distance(bracket, bracket_surface)
    # In a box whose longest edge is 5 units, as the drawn 20 mm are here.
    assert (there + back) * 5.0 / 20.0 < 0.01


def test_more_points_bring_an_uneven_surface_nearer_and_leave_one_piece(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    few, many = (
        gaussian_surface(bracket_gaussians, replace(settings, flattening=None))
        for settings in (PoissonSettings(), DENSE)
    )
    assert len(connected_pieces(few)) == len(connected_pieces(many)) == 1
    assert many.watertight
    assert _mean_distance(many, bracket) < _mean_distance(few, bracket)


def test_the_gaussians_surface_is_flat_unless_asked_for_otherwise(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    uneven = gaussian_surface(bracket_gaussians, replace(SETTINGS, flattening=None))
    found = gaussian_surface(bracket_gaussians, SETTINGS)
    assert found.watertight
    assert len(found.triangles) < len(uneven.triangles)
    assert _mean_distance(found, bracket) < 0.5 * _mean_distance(uneven, bracket)


@pytest.mark.parametrize("preset", [PoissonSettings(), SETTINGS])
def test_the_surface_hardly_stands_out_of_the_solids_box(
    preset: PoissonSettings, bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    """A ridge along one edge would shift and shrink all of it where boxes are made equal."""
    found = gaussian_surface(bracket_gaussians, preset)
    assert found.bounds == pytest.approx(bracket.bounds, abs=0.005 * 20.0)


def _mean_distance(source: TriangleMesh, target: TriangleMesh) -> float:
    points = trimesh.sample.sample_surface(source.to_trimesh(), 2000, seed=0)[0]
    return float(trimesh.proximity.closest_point(target.to_trimesh(), points)[1].mean())


def test_same_gaussians_same_mesh(
    bracket_surface: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    again = gaussian_surface(bracket_gaussians, SETTINGS)
    assert np.array_equal(again.vertices, bracket_surface.vertices)
    assert np.array_equal(again.triangles, bracket_surface.triangles)


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
