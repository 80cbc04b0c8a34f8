"""Discs of Gaussians, and the creases in which they meet."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on, quaternions_to
from gaussiancad_core.surface.discs import Creases, Discs, DiscSampling, creases_of, discs_of

SAMPLING = DiscSampling()


@pytest.fixture(scope="module")
def creases(bracket_gaussians: Gaussians) -> Creases:
    return creases_of(discs_of(bracket_gaussians, SAMPLING), SAMPLING)


def test_a_disc_that_faces_as_none_around_it_is_left_out(bracket_gaussians: Gaussians) -> None:
    """Such as starts on the bevel along a hull's edge."""
    turned = bracket_gaussians.normals.copy()
    quaternions = bracket_gaussians.quaternions.copy()
    turned[7] = np.array([1.0, 1.0, 1.0], np.float32) / np.float32(np.sqrt(3.0))
    quaternions[7] = quaternions_to(turned[7:8].astype(np.float64))[0]
    odd = replace(bracket_gaussians, normals=turned, quaternions=quaternions)
    discs = discs_of(odd, SAMPLING)
    assert len(discs) == len(odd) - 1
    assert not (discs.centres == odd.means[7]).all(axis=1).any()


def test_creases_lie_on_the_edges_and_know_their_planes(creases: Creases) -> None:
    points = creases.points
    # Of the six edges along Y of the bracket, five stand out and one is the inner corner.
    inner = np.linalg.norm(points[:, [0, 2]] - (6.0, 5.0), axis=1) < 1e-3
    along = np.abs((creases.normals * creases.others)[:, 1]) < 1e-6
    assert inner.any()
    assert not creases.convex[inner & along].any()
    # Discs of two faces that do not touch may be neighbours round a corner.
    assert creases.convex[~inner].mean() > 0.99
    assert np.abs((creases.normals * creases.others).sum(axis=1)).max() < 1e-5
    # At the corners discs face in three directions.
    assert set(creases.bends.round()) == {0.0, 90.0}
    assert len(creases.between_planes(1.0)) > 0.8 * len(creases)


def test_beside_the_rims_of_a_thin_pin_the_surface_bends() -> None:
    pin = trimesh.creation.cylinder(radius=2.0, height=20.0, sections=256)
    gaussians = gaussians_on(make_mesh(pin.vertices, pin.faces), Start(count=500))
    rims = creases_of(discs_of(gaussians, SAMPLING), SAMPLING)
    assert len(rims) > 50
    assert np.median(rims.bends) > 3.0
    assert len(rims.between_planes(3.0)) < 0.2 * len(rims)


def bevelled_box(bevel: float) -> TriangleMesh:
    """A box of 20 x 12 x 16 mm whose upper edge along Y is cut by ``bevel`` mm on either face."""
    corners = np.array([(0, 0), (20, 0), (20, 16 - bevel), (20 - bevel, 16), (0, 16)], float)
    outline = np.column_stack([corners[:, 0], np.zeros(5), corners[:, 1]])
    both = np.concatenate([outline, outline + np.array([0.0, 12.0, 0.0])])
    hull = trimesh.convex.convex_hull(both)
    return make_mesh(hull.vertices, hull.faces)


def slanted(discs: Discs) -> np.ndarray:
    """(n,) whether discs face as the bevel does."""
    return (discs.normals[:, 0] > 0.5) & (discs.normals[:, 2] > 0.5)


@pytest.mark.parametrize("bevel", [0.06, 0.12])
def test_bevels_of_the_hulls_grid_carry_no_discs(bevel: float) -> None:
    """Though several of them are neighbours."""
    # A cell of the hull's grid is 0.125 mm here.
    gaussians = gaussians_on(bevelled_box(bevel), Start(count=20_000))
    starts = (gaussians.normals[:, 0] > 0.5) & (gaussians.normals[:, 2] > 0.5)
    assert starts.sum() > 10
    kept = discs_of(gaussians, SAMPLING)
    assert not slanted(kept).any()
    # Nothing else goes but a few at the corners.
    assert len(kept) > len(gaussians) - starts.sum() - 20


def test_chamfers_and_fillets_keep_their_discs(ball: TriangleMesh) -> None:
    gaussians = gaussians_on(bevelled_box(1.0), Start(count=5_000))
    starts = (gaussians.normals[:, 0] > 0.5) & (gaussians.normals[:, 2] > 0.5)
    assert slanted(discs_of(gaussians, SAMPLING)).sum() == starts.sum()
    # On a ball each lies between others near whose planes it is, but these make no flat faces.
    round_ones = gaussians_on(ball, Start(count=500))
    loose = replace(SAMPLING, crease=15.0, bevel=20.0)
    assert len(discs_of(round_ones, replace(loose, face=5.0))) == 500
    assert len(discs_of(round_ones, replace(loose, face=90.0))) < 100
