"""The picture of a deviation."""

from collections.abc import Callable

import numpy as np
import pytest

from gaussiancad_core.comparison.deviation import measure_deviation
from gaussiancad_core.comparison.deviation_picture import deviation_picture
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh


def _about_origin(mesh: TriangleMesh) -> TriangleMesh:
    return make_mesh(mesh.vertices - mesh.bounds.mean(axis=0), mesh.triangles)


@pytest.mark.parametrize(("edge", "channel"), [(3.9, 2), (4.1, 0)])
def test_too_small_is_blue_and_too_large_is_red(
    box: Callable[..., TriangleMesh], edge: float, channel: int
) -> None:
    reference = SurfaceQueries(_about_origin(box(4, 4, 4)))
    found = measure_deviation(_about_origin(box(edge, edge, edge)), reference, 10.0)
    picture = deviation_picture(found).astype(int)
    assert picture.shape == (900, 1260, 3)
    middle_of_top = picture[300, 520]
    assert middle_of_top[channel] > middle_of_top[2 - channel] + 40
    # The bar runs from red above to blue below, and is grey between.
    upper, middle, lower = (picture[row, 1050] for row in (155, 450, 745))
    assert upper[0] > upper[2] + 80 and lower[2] > lower[0] + 80
    assert np.ptp(middle) < 12
