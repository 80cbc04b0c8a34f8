"""What other programs' readers find in the files for them: pycolmap, Open3D, trimesh."""

import json
from pathlib import Path

import numpy as np
import pycolmap
import pytest
import trimesh

from gaussiancad_core.hull.colmap import as_pinhole, write_cameras
from gaussiancad_core.hull.nerfstudio import write_transforms
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera, orthographic_camera, paper_camera
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on, rotation_matrices
from gaussiancad_core.splatting.ply import write_gaussians

SIZE = (80.0, 50.0, 30.0)
ROLES = (Role.FRONT, Role.LEFT, Role.BOTTOM)
POINTS = np.random.default_rng(1).random((40, 3)) * SIZE
RGB = np.random.default_rng(2).integers(0, 256, (40, 3), dtype=np.uint8)
HARMONIC = 0.5 / np.sqrt(np.pi)


@pytest.fixture(params=["orthographic", "paper"])
def cameras(request: pytest.FixtureRequest) -> tuple[Camera, ...]:
    if request.param == "paper":
        return tuple(paper_camera(role, SIZE, 0.05) for role in ROLES)
    return tuple(as_pinhole(orthographic_camera(role, SIZE, 64), SIZE) for role in ROLES)


@pytest.fixture
def folder(cameras: tuple[Camera, ...], tmp_path: Path) -> Path:
    height, width = cameras[0].height, cameras[0].width
    images = np.random.default_rng(0).random((3, 3, height, width)).astype(np.float32)
    write_cameras(tmp_path, cameras, images, images[:, 0], (POINTS, RGB))
    write_transforms(tmp_path, cameras, (POINTS, RGB))
    return tmp_path


def test_colmap_reads_cameras_poses_and_points(folder: Path, cameras: tuple[Camera, ...]) -> None:
    model = pycolmap.Reconstruction()
    model.read_text(folder)
    assert model.num_cameras() == model.num_images() == len(ROLES)
    assert model.num_reg_images() == len(ROLES)
    by_name = {image.name: image for image in model.images.values()}
    for camera in cameras:
        image = by_name[f"{camera.role.value}.png"]
        this_camera = model.cameras[image.camera_id]
        assert this_camera.model == pycolmap.CameraModelId.PINHOLE
        assert (this_camera.width, this_camera.height) == (camera.width, camera.height)
        assert (folder / "images" / image.name).is_file()
        for point, pixel in zip(POINTS, camera.project(POINTS), strict=True):
            assert this_camera.img_from_cam(image.cam_from_world() * point) == pytest.approx(
                pixel, abs=1e-5
            )
        assert image.projection_center() == pytest.approx(camera.position, rel=1e-9)
    found = model.points3D
    assert len(found) == len(POINTS)
    places = np.array([found[index].xyz for index in sorted(found)])
    assert places == pytest.approx(POINTS, abs=1e-6)
    assert np.array_equal([found[index].color for index in sorted(found)], RGB)


def test_colmap_writes_again_what_it_read(folder: Path, tmp_path_factory: object) -> None:
    first, again = pycolmap.Reconstruction(), pycolmap.Reconstruction()
    first.read_text(folder)
    other = tmp_path_factory.mktemp("binary")
    first.write_binary(other)
    again.read_binary(other)
    for index, image in first.images.items():
        matrix = image.cam_from_world().matrix()
        assert again.images[index].cam_from_world().matrix() == pytest.approx(matrix, rel=1e-12)


def test_nerfstudio_finds_the_same_pictures_from_the_same_places(
    folder: Path, cameras: tuple[Camera, ...]
) -> None:
    content = json.loads((folder / "transforms.json").read_text("utf-8"))
    assert content["camera_model"] == "PINHOLE"
    assert len(content["frames"]) == len(cameras)
    for frame, camera in zip(content["frames"], cameras, strict=True):
        assert (folder / frame["file_path"]).is_file()
        assert (frame["w"], frame["h"]) == (camera.width, camera.height)
        # A camera of OpenGL looks along its own -z, and its y points up.
        local = np.linalg.inv(frame["transform_matrix"]) @ np.column_stack([POINTS, np.ones(40)]).T
        x, y, z, _ = local
        assert (z < 0.0).all()
        pixels = np.stack(
            [frame["cx"] + frame["fl_x"] * x / -z, frame["cy"] - frame["fl_y"] * y / -z], axis=1
        )
        assert pixels == pytest.approx(camera.project(POINTS), abs=1e-5)
    cloud = trimesh.load(folder / content["ply_file_path"])
    assert np.asarray(cloud.vertices) == pytest.approx(POINTS, abs=1e-4)
    assert np.array_equal(np.asarray(cloud.colors)[:, :3], RGB)


@pytest.fixture
def gaussians() -> Gaussians:
    ball = trimesh.creation.icosphere(subdivisions=3, radius=20.0)
    from gaussiancad_core.model.meshes import make_mesh

    found = gaussians_on(make_mesh(ball.vertices, ball.faces), Start(300, colour=(0.9, 0.3, 0.1)))
    found.colours[:, 0] = np.linspace(0.0, 1.0, 300)
    return found


def test_gaussians_are_in_the_units_of_the_reference_format(
    gaussians: Gaussians, tmp_path: Path
) -> None:
    """Logarithms of scales, logits of opacities, w first, colours as the constant harmonic."""
    path = tmp_path / "gaussians.ply"
    write_gaussians(gaussians, path)
    assert path.read_bytes().startswith(b"ply\nformat binary_little_endian 1.0\n")
    content = trimesh.load(path).metadata["_ply_raw"]
    assert list(content) == ["vertex"]
    vertex = content["vertex"]["data"]
    assert len(vertex) == 300
    # In this order, less f_rest, which spherical harmonics of degree 0 do not have.
    assert list(vertex.dtype.names) == [
        *("x", "y", "z", "nx", "ny", "nz"),
        *(f"f_dc_{k}" for k in range(3)),
        "opacity",
        *(f"scale_{k}" for k in range(3)),
        *(f"rot_{k}" for k in range(4)),
    ]
    assert {vertex.dtype[name] for name in vertex.dtype.names} == {np.dtype("<f4")}

    def columns(name: str, count: int) -> np.ndarray:
        return np.stack([vertex[f"{name}_{k}"] for k in range(count)], axis=1).astype(float)

    assert 1.0 / (1.0 + np.exp(-vertex["opacity"])) == pytest.approx(gaussians.opacities)
    assert 0.5 + HARMONIC * columns("f_dc", 3) == pytest.approx(gaussians.colours, abs=1e-6)
    scales, rotations = np.exp(columns("scale", 3)), rotation_matrices(columns("rot", 4))
    # On a ball about the origin the thin third axis points outward.
    places = np.stack([vertex[axis] for axis in "xyz"], axis=1)
    outward = places / np.linalg.norm(places, axis=1, keepdims=True)
    assert (rotations[:, :, 2] * outward).sum(axis=1) == pytest.approx(np.ones(300), abs=0.02)
    assert scales[:, 2] == pytest.approx(0.04 * scales[:, 0], rel=1e-5)
    spacing = np.sqrt(4.0 * np.pi * 20.0**2 / 300)
    assert scales[:, 0] == pytest.approx(np.full(300, 0.6 * spacing), rel=0.02)


def test_loaders_of_points_read_the_places(gaussians: Gaussians, tmp_path: Path) -> None:
    from gaussiancad_core.kernel.bare_open3d import open3d

    path = tmp_path / "gaussians.ply"
    write_gaussians(gaussians, path)
    cloud = open3d.io.read_point_cloud(str(path))
    assert np.asarray(cloud.points) == pytest.approx(gaussians.means, abs=1e-6)
    assert np.asarray(cloud.normals) == pytest.approx(gaussians.normals, abs=1e-6)
    splats = open3d.t.io.read_point_cloud(str(path))
    assert splats.point["positions"].numpy() == pytest.approx(gaussians.means, abs=1e-6)
    assert np.asarray(trimesh.load(path).vertices) == pytest.approx(gaussians.means, abs=1e-6)
