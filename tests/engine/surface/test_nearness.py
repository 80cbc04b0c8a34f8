"""Which of a surface and the hull that it came from is nearer to the masks."""

import numpy as np
import pytest
from scipy.ndimage import binary_erosion

from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import View, ViewSet
from gaussiancad_core.surface.mesh_shadows import silhouette_difference
from gaussiancad_core.surface.nearness import Nearer, weighed

PITCH = 0.1


def views_of(mesh: TriangleMesh, worn: int = 0) -> ViewSet:
    """Three views with the mesh's own shadows as masks, ``worn`` px smaller all round."""
    caster = RayCaster(mesh)
    found = []
    for role in (Role.FRONT, Role.TOP, Role.RIGHT):
        flat = mesh.vertices @ np.array([role.frame.right, role.frame.up], dtype=float).T
        (left, low), (right, high) = flat.min(axis=0) - 0.53, flat.max(axis=0) + 0.53
        grid = RayGrid.of_view(role, (left, low, right, high), PITCH)
        mask = caster.first_hits(grid).triangle >= 0
        mask = binary_erosion(mask, iterations=worn) if worn else mask
        colour = np.zeros((*mask.shape, 3), np.uint8)
        place = (grid.left, grid.top)
        found.append(View(role, (0, 0, 1, 1), (), mask, colour, place, PITCH))
    return ViewSet(tuple(found), tuple(float(extent) for extent in mesh.bounds[1]))


def test_a_hull_with_the_outlines_of_the_masks_is_nearer_and_loses_no_edge(
    bracket: TriangleMesh, bracket_surface: TriangleMesh
) -> None:
    found = weighed(bracket_surface, bracket, views_of(bracket))
    assert found.nearer is Nearer.HULL
    assert found.differences[Nearer.HULL] < found.differences[Nearer.GAUSSIANS] < 1e-3
    assert found.mesh is bracket_surface
    assert found.hull.watertight
    assert found.hull.volume == pytest.approx(bracket.volume, rel=1e-6)
    assert len(found.hull.triangles) == 20 < len(bracket.triangles)


def test_gaussians_that_mend_a_hull_are_nearer(
    bracket: TriangleMesh, bracket_surface: TriangleMesh
) -> None:
    worn = make_mesh(bracket.vertices * 0.9 + 0.8, bracket.triangles)
    views = views_of(bracket)
    found = weighed(bracket_surface, worn, views)
    assert found.nearer is Nearer.GAUSSIANS
    assert found.differences == {
        Nearer.GAUSSIANS: silhouette_difference(bracket_surface, views),
        Nearer.HULL: silhouette_difference(found.hull, views),
    }


def test_without_a_surface_the_hull_is_what_there_is(bracket: TriangleMesh) -> None:
    found = weighed(None, bracket, views_of(bracket))
    assert found.nearer is Nearer.HULL
    assert set(found.differences) == {Nearer.HULL}


def test_a_hull_that_is_open_is_weighed_as_it_is(bracket: TriangleMesh) -> None:
    broken = make_mesh(bracket.vertices, bracket.triangles[:-1])
    assert weighed(None, broken, views_of(bracket)).hull is broken


def test_the_difference_is_the_share_of_the_mask(ball: TriangleMesh) -> None:
    centred = make_mesh(ball.vertices + 10.0, ball.triangles)
    assert silhouette_difference(centred, views_of(centred)) == 0.0
    # The shadow has a radius of 10 mm, the mask one of about 9.9.
    ring = silhouette_difference(centred, views_of(centred, worn=1))
    assert ring == pytest.approx(10.0**2 / 9.9**2 - 1.0, rel=0.2)
