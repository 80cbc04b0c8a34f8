from collections.abc import Callable

import cv2
import numpy as np
import pytest

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.pictures.png_pictures import png_bytes
from gaussiancad_core.pictures.preview import (
    PreviewSize,
    render_preview,
    smooth_corner_normals,
)

_SMALL = PreviewSize(300, 240)
_COLOUR = (100, 150, 200)


def test_a_cube_shows_top_front_and_right(box: Callable[..., TriangleMesh]) -> None:
    image = render_preview(box((0, 0, 0), (1, 1, 1)), _COLOUR, _SMALL).astype(int)
    assert image.shape == (240, 300, 3)
    assert (image[0, 0] == image[-1, -1]).all() and image[0, 0].min() > 240
    top, front, right = image[75, 150], image[150, 105], image[150, 195]
    assert top.sum() > front.sum() > right.sum()
    for face in (top, front, right):
        assert face / face.max() == pytest.approx(np.array(_COLOUR) / 200, abs=0.02)


def test_axes_lie_as_promised(box: Callable[..., TriangleMesh]) -> None:
    """Red grows with x, green with y, blue with z: each colour is where its axis points."""
    mesh = box((0, 0, 0), (1, 1, 1))
    image = render_preview(mesh, (mesh.vertices * 255).astype(np.uint8), _SMALL).astype(int)
    part = np.nonzero(image.sum(axis=2) < 700)
    left, right = part[1].min() + 6, part[1].max() - 6
    lowest = part[0].max() - 8
    # Left is the edge x = 0, y = 0, right the edge x = 1, y = 1, lowest the corner x = 1, y = 0.
    assert image[120, left, :2].max() < 40
    assert image[120, right, :2].min() > 140
    assert image[lowest, 150, 0] > 140 and image[lowest, 150, 1:].max() < 60
    assert image[80, left, 2] > image[160, left, 2]


def test_edges_are_darker_than_faces(box: Callable[..., TriangleMesh]) -> None:
    image = render_preview(box((0, 0, 0), (1, 1, 1)), _COLOUR, _SMALL).astype(int)
    upright_edge = image[170, 140:160].sum(axis=1)
    assert upright_edge.min() < 0.6 * np.median(upright_edge)


def test_a_black_part_keeps_visible_edges(box: Callable[..., TriangleMesh]) -> None:
    image = render_preview(box((0, 0, 0), (1, 1, 1)), (0, 0, 0), _SMALL).astype(int)
    assert image[170, 140:160].max() > 50


@pytest.mark.parametrize("edges", [(100, 1, 1), (1, 1, 100), (1, 80, 2)])
def test_every_shape_fits_the_picture(
    box: Callable[..., TriangleMesh], edges: tuple[float, float, float]
) -> None:
    image = render_preview(box((0, 0, 0), edges), _COLOUR, _SMALL).astype(int)
    part = np.abs(image - image[0, 0]).sum(axis=2) > 30
    assert part.any()
    border = np.ones_like(part)
    border[12:-12, 12:-12] = False
    assert not part[border].any()
    rows, columns = np.nonzero(part)
    assert max(np.ptp(rows) / 240, np.ptp(columns) / 300) > 0.8


def test_normals_are_smooth_on_a_ball_and_sharp_on_a_cube(
    box: Callable[..., TriangleMesh],
) -> None:
    import trimesh

    from gaussiancad_core.model.meshes import make_mesh

    ball = trimesh.creation.icosphere(3)
    normals = smooth_corner_normals(make_mesh(ball.vertices, ball.faces))
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    assert normals == pytest.approx(ball.vertices[ball.faces], abs=0.02)
    cube = box((0, 0, 0), (1, 1, 1))
    sharp = smooth_corner_normals(cube)
    sharp /= np.linalg.norm(sharp, axis=-1, keepdims=True)
    flat = cube.area_vectors / cube.areas[:, None]
    assert sharp == pytest.approx(np.repeat(flat[:, None], 3, axis=1))


def test_the_same_mesh_gives_the_same_picture(rounded_block: TriangleMesh) -> None:
    first, second = (render_preview(rounded_block, _COLOUR, _SMALL) for _ in range(2))
    assert (first == second).all()


def test_png_keeps_the_colours() -> None:
    image = np.random.default_rng(0).integers(0, 255, (7, 9, 3)).astype(np.uint8)
    read = cv2.imdecode(np.frombuffer(png_bytes(image), np.uint8), cv2.IMREAD_COLOR)
    assert (read[..., ::-1] == image).all()
