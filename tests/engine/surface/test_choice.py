"""The surface that is nearer to the masks is taken."""

import numpy as np
import pytest
from scipy.ndimage import binary_erosion

from gaussiancad_core.axes import Role
from gaussiancad_core.meshes import TriangleMesh, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.surface.choice import SurfaceSource, better_surface
from gaussiancad_core.surface.silhouettes import silhouette_difference
from gaussiancad_core.verification.rays import RayCaster, RayGrid
from gaussiancad_core.views import View, ViewSet

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


def few(gaussians: Gaussians) -> Gaussians:
    return Gaussians(*(getattr(gaussians, name)[:3] for name in gaussians.__dataclass_fields__))


def test_a_hull_with_the_outlines_of_the_masks_is_kept_with_its_edges(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    chosen = better_surface(bracket, bracket_gaussians, views_of(bracket))
    assert chosen.source is SurfaceSource.HULL
    assert chosen.differences[SurfaceSource.HULL] < 1e-3
    assert chosen.differences[SurfaceSource.GAUSSIANS] > 5e-3
    assert chosen.mesh.watertight
    assert chosen.mesh.volume == pytest.approx(bracket.volume, rel=1e-6)
    assert len(chosen.mesh.triangles) == 20 < len(bracket.triangles)


def test_gaussians_that_mend_a_hull_are_kept(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    worn = make_mesh(bracket.vertices * 0.9 + 0.8, bracket.triangles)
    views = views_of(bracket)
    chosen = better_surface(worn, bracket_gaussians, views)
    assert chosen.source is SurfaceSource.GAUSSIANS
    assert chosen.mesh.watertight
    assert chosen.differences[SurfaceSource.GAUSSIANS] == silhouette_difference(chosen.mesh, views)
    assert chosen.differences[SurfaceSource.GAUSSIANS] < chosen.differences[SurfaceSource.HULL]


def test_gaussians_that_bound_no_body_leave_the_hull(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    chosen = better_surface(bracket, few(bracket_gaussians), views_of(bracket))
    assert chosen.source is SurfaceSource.HULL
    assert set(chosen.differences) == {SurfaceSource.HULL}


def test_the_difference_is_the_share_of_the_mask(ball: TriangleMesh) -> None:
    centred = make_mesh(ball.vertices + 10.0, ball.triangles)
    assert silhouette_difference(centred, views_of(centred)) == 0.0
    # The shadow has a radius of 10 mm, the mask one of about 9.9.
    ring = silhouette_difference(centred, views_of(centred, worn=1))
    assert ring == pytest.approx(10.0**2 / 9.9**2 - 1.0, rel=0.2)
