from collections.abc import Callable

import numpy as np
import trimesh

from gaussiancad_core.lines.tessellation_quality import is_rounded, triangle_normals
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.surface.repair import simplified


def test_poisson_is_rounded_and_a_solid_is_not(
    blind_hole: TriangleMesh, rounded_block: TriangleMesh
) -> None:
    assert not is_rounded(blind_hole)
    assert is_rounded(rounded_block)


def test_a_finely_split_solid_is_sharp(box: Callable[..., TriangleMesh]) -> None:
    solid = box((0, 0, 0), (4, 3, 2)).to_trimesh().subdivide_to_size(0.05)
    assert not is_rounded(make_mesh(solid.vertices, solid.faces))


def test_what_is_simplified_stays_rounded(rounded_block: TriangleMesh) -> None:
    fewer = simplified(rounded_block, 0.01)
    assert fewer is not None and fewer.watertight
    # Large flat faces are left, which is what makes this case hard.
    assert np.sort(fewer.areas)[-2:].sum() > 8 * np.sort(rounded_block.areas)[-2:].sum()
    assert is_rounded(fewer)


def test_smoothing_lowers_the_noise_of_a_ball() -> None:
    ball = trimesh.creation.icosphere(4)
    rough = ball.vertices * np.random.default_rng(0).normal(1.0, 0.004, (len(ball.vertices), 1))
    mesh = make_mesh(rough, ball.faces)
    outward = ball.triangles_center / np.linalg.norm(ball.triangles_center, axis=1, keepdims=True)
    errors = [
        np.arccos(np.clip((triangle_normals(mesh, smooth) * outward).sum(axis=1), -1, 1)).mean()
        for smooth in (False, True)
    ]
    assert errors[1] < 0.5 * errors[0]
