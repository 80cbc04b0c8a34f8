from collections.abc import Callable

import numpy as np

from gaussiancad_core.lines.tessellation_quality import is_rounded
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.surface.repair import simplified


def test_a_finely_split_solid_is_sharp(box: Callable[..., TriangleMesh]) -> None:
    solid = box((0, 0, 0), (4, 3, 2)).to_trimesh().subdivide_to_size(0.05)
    assert not is_rounded(make_mesh(solid.vertices, solid.faces))


def test_what_is_simplified_stays_rounded(rounded_block: TriangleMesh) -> None:
    fewer = simplified(rounded_block, 0.01)
    assert fewer is not None and fewer.watertight
    # Large flat faces are left, which is what makes this case hard.
    assert np.sort(fewer.areas)[-2:].sum() > 8 * np.sort(rounded_block.areas)[-2:].sum()
    assert is_rounded(fewer)
