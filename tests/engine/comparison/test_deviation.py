"""The coloured mesh of deviations, and its picture."""

from collections.abc import Callable

import numpy as np
import pytest
import trimesh

from gaussiancad_core.comparison.deviation import (
    diverging_colours,
    measure_deviation,
    ply_bytes,
    split_long_edges,
)
from gaussiancad_core.comparison.deviation_picture import deviation_picture
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh


def _about_origin(mesh: TriangleMesh) -> TriangleMesh:
    return make_mesh(mesh.vertices - mesh.bounds.mean(axis=0), mesh.triangles)


def test_inside_is_negative_and_outside_positive(box: Callable[..., TriangleMesh]) -> None:
    reference = SurfaceQueries(_about_origin(box(4, 4, 4)))
    inner = measure_deviation(_about_origin(box(3.8, 3.8, 3.8)), reference, 2.0)
    outer = measure_deviation(_about_origin(box(4.2, 4.2, 4.2)), reference, 2.0)
    assert inner.signed
    assert inner.distances == pytest.approx(np.full(len(inner.distances), -0.2))
    # 0.1 units of 2 mm on the faces, and sqrt(3) times as much at the corners.
    assert outer.distances.min() == pytest.approx(0.2)
    assert outer.distances.max() == pytest.approx(0.2 * np.sqrt(3))
    assert np.ptp(inner.mesh.bounds, axis=0) == pytest.approx([7.6] * 3)


def test_an_open_reference_gives_no_sign(box: Callable[..., TriangleMesh]) -> None:
    cube = _about_origin(box(4, 4, 4))
    opened = SurfaceQueries(make_mesh(cube.vertices, cube.triangles[1:]))
    found = measure_deviation(_about_origin(box(3.8, 3.8, 3.8)), opened, 1.0)
    assert not found.signed
    assert found.distances.min() >= 0.1 - 1e-9


def test_a_pocket_missing_in_a_large_face_shows(box: Callable[..., TriangleMesh]) -> None:
    """The result's few corners alone would not see what happens in the middle of a face."""
    cut = trimesh.creation.box((2, 2, 1))
    cut.apply_translation((0, 0, 0.5))
    block = _about_origin(box(4, 4, 2)).to_trimesh()
    pocketed = trimesh.boolean.difference([block, cut])
    reference = SurfaceQueries(make_mesh(pocketed.vertices, pocketed.faces))
    found = measure_deviation(_about_origin(box(4, 4, 2)), reference, 1.0)
    assert found.distances.max() == pytest.approx(1.0, abs=0.03)
    assert 0.25 <= found.limit <= 1.0


@pytest.mark.parametrize("longest", [3.0, 0.4, 0.07])
def test_splitting_keeps_the_surface_closed(bracket: TriangleMesh, longest: float) -> None:
    small = make_mesh(bracket.vertices / 10, bracket.triangles)
    fine = split_long_edges(small, longest, 10**6)
    sides = fine.vertices[fine.triangles] - fine.vertices[np.roll(fine.triangles, -1, axis=1)]
    assert np.linalg.norm(sides, axis=-1).max() <= longest
    assert fine.watertight
    assert fine.volume == pytest.approx(small.volume)
    assert fine.area == pytest.approx(small.area)


def test_splitting_stops_at_the_limit(unit_cube: TriangleMesh) -> None:
    fine = split_long_edges(unit_cube, 1e-6, 1000)
    assert 1000 <= len(fine.triangles) <= 4000


def test_a_small_bump_does_not_leave_the_scale_far(box: Callable[..., TriangleMesh]) -> None:
    bump = trimesh.creation.box((0.1, 0.1, 2.8))
    block = _about_origin(box(4, 4, 2))
    union = trimesh.boolean.union([block.to_trimesh(), bump])
    found = measure_deviation(make_mesh(union.vertices, union.faces), SurfaceQueries(block), 1.0)
    assert found.distances.max() == pytest.approx(0.4, abs=1e-6)
    assert found.limit == pytest.approx(0.1)


def test_the_scale_is_symmetric_about_grey() -> None:
    colours = diverging_colours(np.array([-9.0, -1.0, 0.0, 1.0, 9.0]))
    assert (colours[0] == colours[1]).all() and (colours[3] == colours[4]).all()
    assert len(set(colours[2].tolist())) == 1
    assert colours[1][2] > colours[1][0] and colours[3][0] > colours[3][2]


def test_the_ply_can_be_read_by_others(bracket: TriangleMesh) -> None:
    boxed = _about_origin(make_mesh(bracket.vertices / 8, bracket.triangles))
    found = measure_deviation(boxed, SurfaceQueries(boxed), 8.0)
    content = ply_bytes(found)
    import io

    read = trimesh.load(io.BytesIO(content), file_type="ply", process=False)
    assert (read.faces == found.mesh.triangles).all()
    assert read.vertices == pytest.approx(found.mesh.vertices, abs=1e-5)
    assert (read.visual.vertex_colors[:, :3] == found.colours).all()
    stored = read.metadata["_ply_raw"]["vertex"]["data"]["deviation"]
    assert np.ravel(stored) == pytest.approx(found.distances, abs=1e-6)


def test_the_ply_has_the_documented_layout(unit_cube: TriangleMesh) -> None:
    found = measure_deviation(unit_cube, SurfaceQueries(unit_cube), 1.0)
    header, body = ply_bytes(found).split(b"end_header\n", 1)
    lines = header.decode("ascii").splitlines()
    assert "comment unit mm" in lines and "comment signed 1" in lines
    assert f"comment range {found.limit:.9g}" in lines
    assert len(body) == 19 * len(found.mesh.vertices) + 13 * len(found.mesh.triangles)


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
