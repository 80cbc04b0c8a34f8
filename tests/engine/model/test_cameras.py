import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.hull.colmap import as_pinhole, quaternion, write_cameras
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import (
    PAPER_DISTANCE,
    PAPER_INTRINSICS,
    CameraModel,
    orthographic_camera,
    paper_camera,
    paper_unit,
)

sizes = st.tuples(*[st.floats(1.0, 500.0)] * 3)
fractions = st.tuples(*[st.floats(0.0, 1.0)] * 3)


@settings(max_examples=25, deadline=None)
@given(sizes, fractions)
def test_shared_axes_land_on_the_same_pixels(size: tuple, fraction: tuple) -> None:
    point = np.array([size]) * np.array([fraction])
    front, top, right = (
        orthographic_camera(role, size, 256).project(point)[0]
        for role in (Role.FRONT, Role.TOP, Role.RIGHT)
    )
    assert front[0] == pytest.approx(top[0], abs=1e-9)  # x
    assert front[1] == pytest.approx(right[1], abs=1e-9)  # z
    # y runs up in the top view and to the right in the right view.
    assert 256 - top[1] == pytest.approx(right[0], abs=1e-9)


@settings(max_examples=25, deadline=None)
@given(sizes)
def test_paper_cameras_show_the_whole_part_from_five_units(size: tuple) -> None:
    corners = np.array(np.meshgrid(*[(0.0, s) for s in size])).reshape(3, -1).T
    centre = np.array(size) / 2
    for role in Role:
        camera = paper_camera(role, size)
        assert (camera.fx, camera.fy, camera.cx, camera.cy) == PAPER_INTRINSICS
        distance = np.linalg.norm(camera.position - centre)
        assert distance == pytest.approx(PAPER_DISTANCE * paper_unit(size))
        assert camera.project(centre[None])[0] == pytest.approx([960, 540])
        pixels = camera.project(corners)
        assert (pixels >= 0).all() and (pixels <= [1920, 1080]).all()


@pytest.mark.parametrize("role", Role)
def test_plane_coordinates_are_right_and_up(role: Role) -> None:
    size = (80.0, 50.0, 30.0)
    points = np.random.default_rng(0).random((20, 3)) * size
    frame = role.frame
    expected = np.stack([points @ frame.right, points @ frame.up], 1)
    camera = orthographic_camera(role, size, 128)
    assert camera.plane_coordinates(points) == pytest.approx(expected)
    middle = np.array([size]) / 2
    plane = paper_camera(role, size).plane_coordinates(middle)
    assert plane == pytest.approx(np.stack([middle @ frame.right, middle @ frame.up], 1))


@settings(max_examples=25, deadline=None)
@given(sizes, fractions, st.sampled_from(Role))
def test_far_pinhole_draws_like_the_orthographic_camera(
    size: tuple, fraction: tuple, role: Role
) -> None:
    camera = orthographic_camera(role, size, 1024)
    point = np.array([size]) * np.array([fraction])
    far = as_pinhole(camera, size)
    assert np.abs(far.project(point) - camera.project(point)).max() < 0.5


def test_colmap_files_read_back_to_the_same_projection(tmp_path) -> None:  # noqa: ANN001
    size = (80.0, 50.0, 30.0)
    cameras = tuple(
        as_pinhole(orthographic_camera(role, size, 64), size) for role in (Role.FRONT, Role.LEFT)
    )
    points = np.random.default_rng(1).random((5, 3)) * size
    colours = np.full((5, 3), 200, np.uint8)
    images = np.zeros((2, 3, 64, 64), np.float32)
    write_cameras(tmp_path, cameras, images, images[:, 0], (points, colours))

    def rows(name: str) -> list[list[str]]:
        lines = (tmp_path / name).read_text("utf-8").splitlines()
        return [line.split() for line in lines if line and not line.startswith("#")]

    for camera, intrinsics, pose in zip(
        cameras, rows("cameras.txt"), rows("images.txt"), strict=True
    ):
        assert intrinsics[1] == "PINHOLE"
        fx, fy, cx, cy = map(float, intrinsics[4:])
        w, x, y, z, *translation = map(float, pose[1:8])
        rotation = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        local = points @ rotation.T + np.array(translation)
        pixels = local[:, :2] / local[:, 2:] * [fx, fy] + [cx, cy]
        assert pixels == pytest.approx(camera.project(points), abs=1e-6)
        assert (tmp_path / "images" / pose[9]).exists()
        assert (tmp_path / "masks" / pose[9]).exists()
    assert len(rows("points3D.txt")) == 5


@pytest.mark.parametrize("role", Role)
def test_quaternions_have_a_positive_first_part(role: Role) -> None:
    q = quaternion(role.frame.world_to_camera())
    assert q[0] >= 0 and np.linalg.norm(q) == pytest.approx(1.0)


@pytest.mark.parametrize("model", list(CameraModel))
def test_pixels_lie_on_the_plane_through_the_middle(model: CameraModel) -> None:
    size = (40.0, 30.0, 20.0)
    role = Role.RIGHT
    camera = (
        orthographic_camera(role, size, 200)
        if model is CameraModel.ORTHOGRAPHIC
        else paper_camera(role, size, 0.1)
    )
    middle = np.array(size) / 2.0
    points = middle + np.array([[0.0, 3.0, 4.0], [0.0, -5.0, 1.0]])
    plane = points @ np.array([role.frame.right, role.frame.up], dtype=float).T
    assert camera.on_view_plane(camera.project(points)) == pytest.approx(plane, abs=1e-9)
