"""What the benchmark of disturbed masks does to them."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from benchmarks.run.charts import Chart, Series, write_chart
from benchmarks.sheets.clean_sheets import ROLES
from benchmarks.sheets.disturbed_views import cases, views_of
from gaussiancad_core.evidence.mask_outlines import signed_distance
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.samples.modelling import box
from gaussiancad_core.surface.mesh_shadows import silhouette_difference

BY_NAME = {case.name: case for case in cases()}


@pytest.fixture(scope="module")
def block() -> TriangleMesh:
    from benchmarks.sheets.disturbed_views import solid_mesh

    return solid_mesh(box((5, 5, 5), (55, 35, 25)))


def test_undisturbed_masks_are_the_shadows(block: TriangleMesh) -> None:
    views = views_of(block, BY_NAME["noise 0 px"], seed=0)
    assert views.roles == ROLES
    assert views.size == pytest.approx((50.0, 30.0, 20.0))
    assert silhouette_difference(block, views) == 0.0


@pytest.mark.parametrize("pixels", [1, 2, 4])
def test_outlines_waver_by_as_much_as_is_said(block: TriangleMesh, pixels: int) -> None:
    plain = views_of(block, BY_NAME["noise 0 px"], seed=0).views[0]
    noisy = views_of(block, BY_NAME[f"noise {pixels} px"], seed=0).views[0]
    away = signed_distance(plain.mask, 1.0)[noisy.mask != plain.mask]
    # Half of the outline moves out and half in; a normal deviation is on average 0.8 of its width,
    # and the pixels in between lie evenly up to there.
    assert np.abs(away).mean() == pytest.approx(0.6 * pixels, rel=0.4)
    assert abs((away > 0).mean() - 0.5) < 0.15


@pytest.mark.parametrize("pixels", [1, 2])
def test_views_move_as_a_whole(block: TriangleMesh, pixels: int) -> None:
    plain = views_of(block, BY_NAME["noise 0 px"], seed=3)
    moved = views_of(block, BY_NAME[f"views off by {pixels} px"], seed=3)
    for one, other in zip(plain.views, moved.views, strict=True):
        assert one.mask.sum() == other.mask.sum()
        steps = [
            abs(np.flatnonzero(a.any(axis=axis))[0] - np.flatnonzero(b.any(axis=axis))[0])
            for axis in (0, 1)
            for a, b in [(one.mask, other.mask)]
        ]
        assert max(steps) == pixels and set(steps) <= {0, pixels}


def test_outlines_are_bitten_both_ways_and_repeat(block: TriangleMesh) -> None:
    plain = views_of(block, BY_NAME["noise 0 px"], seed=0)
    bitten, again = (views_of(block, BY_NAME["broken outlines"], seed=0) for _ in range(2))
    for one, other, same in zip(plain.views, bitten.views, again.views, strict=True):
        assert (one.mask & ~other.mask).any() and (other.mask & ~one.mask).any()
        assert np.array_equal(other.mask, same.mask)


def test_charts_of_nothing_but_zero_can_be_drawn(tmp_path: Path) -> None:
    path = tmp_path / "chart.png"
    write_chart(Chart("title", ["a", "b"], [Series("none", [0.0, 0.0])]), path)
    image = cv2.imread(str(path))
    # The line lies on the lower edge of the frame.
    assert (180, 119, 31) in {tuple(colour) for colour in image[395:405].reshape(-1, 3).tolist()}


@pytest.mark.parametrize("logarithmic", [False, True])
def test_charts_show_their_lines(tmp_path: Path, logarithmic: bool) -> None:
    lines = [Series("one", [1.0, 10.0, 1000.0]), Series("two", [2.0, float("nan"), 5.0])]
    path = tmp_path / "chart.png"
    write_chart(Chart("title", ["a", "b\nb", "c"], lines, logarithmic), path)
    image = cv2.imread(str(path))
    assert image.shape == (460, 760, 3)
    colours = {tuple(colour) for colour in image.reshape(-1, 3).tolist()}
    # OpenCV has blue first.
    assert {(180, 119, 31), (40, 39, 214)} <= colours


def test_a_mesh_of_the_same_place_is_its_own_shadow(block: TriangleMesh) -> None:
    moved = make_mesh(block.vertices + np.array([1.0, 0.0, 0.0]), block.triangles)
    views = views_of(block, BY_NAME["noise 0 px"], seed=0)
    # A millimetre of fifty is missing on one side and too much on the other, in two of three views.
    assert silhouette_difference(moved, views) == pytest.approx(2 / 50 * 2 / 3, rel=0.1)
