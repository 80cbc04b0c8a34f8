"""The hull of drawn solids: volumes, closure, the box, carving."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.hull.visual_hull import DepthMap, visual_hull
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import orthographic_camera, paper_camera
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import View, ViewSet

Shape = Callable[[np.ndarray, np.ndarray], np.ndarray]
Size = tuple[float, float, float]
THREE = (Role.FRONT, Role.TOP, Role.RIGHT)
PIXEL = 0.125


def pixel_centres(view: View) -> tuple[np.ndarray, np.ndarray]:
    rows, columns = np.mgrid[: view.mask.shape[0], : view.mask.shape[1]]
    return (
        view.origin[0] + (columns + 0.5) * view.mm_per_pixel,
        view.origin[1] - (rows + 0.5) * view.mm_per_pixel,
    )


def view(role: Role, size: Size, shape: Shape | None = None, shift: float = 0.4) -> View:
    """A view of the box, or of the points (right, up) of it for which ``shape`` holds.

    The pixels lie askew to the box by a share of one.
    """
    (across, sign_x), (upward, sign_y) = role.frame.right_axis, role.frame.up_axis
    low_x, high_x = sorted((0.0, sign_x * size[across.value]))
    low_y, high_y = sorted((0.0, sign_y * size[upward.value]))
    width, height = (
        int((high - low) / PIXEL) + 6 for high, low in ((high_x, low_x), (high_y, low_y))
    )
    blank = View(
        role,
        (0, 0, 1, 1),
        (),
        np.zeros((height, width), bool),
        np.zeros((height, width, 3), np.uint8),
        (low_x - (2 + shift) * PIXEL, high_y + (3 - shift) * PIXEL),
        PIXEL,
    )
    right, up = pixel_centres(blank)
    mask = (right > low_x) & (right < high_x) & (up > low_y) & (up < high_y)
    if shape is not None:
        mask &= shape(right, up)
    return View(role, blank.box, (), mask, blank.colour, blank.origin, PIXEL)


def hull_of(
    size: Size,
    shapes: dict[Role, Shape],
    roles: tuple[Role, ...] = THREE,
    depth_maps: tuple[DepthMap, ...] = (),
) -> TriangleMesh:
    views = ViewSet(tuple(view(role, size, shapes.get(role)) for role in roles), size)
    cameras = tuple(orthographic_camera(role, size, 64) for role in roles)
    return visual_hull(views, cameras, depth_maps, cells=64)


def bracket(right: np.ndarray, up: np.ndarray) -> np.ndarray:
    return (right < 8.0) | (up < 6.0)


def test_a_box_is_itself() -> None:
    hull = hull_of((30.0, 20.0, 10.0), {})
    assert hull.watertight
    assert hull.volume == pytest.approx(6000.0, rel=1e-4)
    assert hull.bounds.tolist() == [[0.0, 0.0, 0.0], [30.0, 20.0, 10.0]]


@settings(max_examples=10, deadline=None)
@given(st.tuples(*[st.floats(4.0, 30.0)] * 3), st.floats(0.0, 1.0))
def test_the_hull_of_any_box_ends_exactly_in_it_however_the_pixels_lie(
    size: Size, shift: float
) -> None:
    views = ViewSet(tuple(view(role, size, shift=shift) for role in THREE), size)
    cameras = tuple(orthographic_camera(role, size, 64) for role in THREE)
    hull = visual_hull(views, cameras, cells=24)
    assert hull.watertight
    assert hull.bounds.tolist() == [[0.0, 0.0, 0.0], list(size)]
    assert hull.volume == pytest.approx(np.prod(size), rel=1e-3)


def test_an_l_bracket_has_its_volume_and_one_piece() -> None:
    hull = hull_of((30.0, 20.0, 24.0), {Role.FRONT: bracket})
    exact = 20.0 * (8.0 * 24.0 + 22.0 * 6.0)
    assert hull.watertight
    # The two inner faces, 22 and 18 wide, may be off by half a pixel.
    assert hull.volume == pytest.approx(exact, abs=20.0 * 40.0 * PIXEL / 2)
    assert hull.bounds.tolist() == [[0.0, 0.0, 0.0], [30.0, 20.0, 24.0]]
    assert hull.to_trimesh().euler_number == 2


def test_a_through_hole_makes_a_torus() -> None:
    def plate(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return np.hypot(right - 15.0, up - 10.0) > 5.0

    hull = hull_of((30.0, 20.0, 8.0), {Role.TOP: plate})
    assert hull.watertight
    assert hull.volume == pytest.approx((600.0 - np.pi * 25.0) * 8.0, rel=0.003)
    assert hull.to_trimesh().euler_number == 0


@pytest.mark.parametrize("roles", [(Role.TOP, Role.FRONT), THREE])
def test_a_cylinder_has_its_volume_with_two_views_and_with_three(roles: tuple[Role, ...]) -> None:
    def disc(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return np.hypot(right - 10.0, up - 10.0) < 10.0

    hull = hull_of((20.0, 20.0, 30.0), {Role.TOP: disc}, roles)
    assert hull.watertight
    assert hull.volume == pytest.approx(np.pi * 100.0 * 30.0, rel=0.003)
    radii = np.hypot(*(hull.vertices[:, :2] - 10.0).T)
    assert radii.max() < 10.0 + PIXEL


def test_all_roles_see_the_same_part() -> None:
    size = (30.0, 20.0, 24.0)
    plain = hull_of(size, {Role.FRONT: bracket})
    mirrored = hull_of(
        size,
        {Role.REAR: lambda right, up: bracket(-right, up)},
        (Role.REAR, Role.LEFT, Role.BOTTOM),
    )
    assert mirrored.volume == pytest.approx(plain.volume, abs=20.0 * 40.0 * PIXEL)
    assert mirrored.to_trimesh().center_mass == pytest.approx(
        plain.to_trimesh().center_mass, abs=PIXEL
    )


def test_six_views_carve_as_three_do() -> None:
    size = (30.0, 20.0, 24.0)
    shapes = {Role.FRONT: bracket, Role.REAR: lambda right, up: bracket(-right, up)}
    six = hull_of(size, shapes, tuple(Role))
    assert six.watertight
    assert six.volume == pytest.approx(hull_of(size, shapes).volume, rel=1e-3)


@settings(max_examples=10, deadline=None)
@given(st.floats(2.0, 28.0), st.floats(2.0, 18.0))
def test_the_hull_projects_into_every_mask(corner_x: float, corner_z: float) -> None:
    size = (30.0, 10.0, 20.0)

    def slanted(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return right / corner_x + up / corner_z < 1.7

    hull = hull_of(size, {Role.FRONT: slanted})
    gradient = np.hypot(1.0 / corner_x, 1.0 / corner_z)
    over = (hull.vertices[:, 0] / corner_x + hull.vertices[:, 2] / corner_z - 1.7) / gradient
    assert over.max() < PIXEL


def test_a_pinhole_sees_a_narrower_part_behind_the_same_mask() -> None:
    size = (20.0, 20.0, 20.0)
    views = ViewSet(tuple(view(role, size) for role in THREE), size)
    cameras = tuple(paper_camera(role, size) for role in THREE)
    hull = visual_hull(views, cameras, cells=48)
    assert hull.watertight
    assert (hull.bounds[0] >= 0.0).all()
    assert (hull.bounds[1] <= 20.0).all()
    # What all three cones and the box have in common is less than the box.
    assert 0.5 * 8000.0 < hull.volume < 0.95 * 8000.0
    half = hull.vertices - 10.0
    for camera in cameras:
        seen = camera.plane_coordinates(half + 10.0)
        centre = camera.plane_coordinates(np.full((1, 3), 10.0))
        assert np.abs(seen - centre).max() < 10.0 + 2 * PIXEL


def test_views_without_a_common_part_say_so() -> None:
    shapes = {
        Role.FRONT: lambda right, up: up < 8.0,
        Role.RIGHT: lambda right, up: up > 12.0,
    }
    with pytest.raises(NoModelError) as caught:
        hull_of((20.0, 20.0, 20.0), shapes)
    assert caught.value.code == "empty-hull"


def depth_map(role: Role, size: Size, depth: Shape, region: Shape | None = None) -> DepthMap:
    base = view(role, size)
    right, up = pixel_centres(base)
    numbers = base.mask.astype(np.int32)
    if region is not None:
        numbers += base.mask & region(right, up)
    return DepthMap(role, numbers, np.where(base.mask, depth(right, up), 0.0).astype(np.float32))


def test_a_known_depth_carves_a_blind_pocket() -> None:
    size = (30.0, 20.0, 10.0)

    def pocket(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return (abs(right - 15.0) < 8.0) & (abs(up - 10.0) < 5.0)

    top = depth_map(Role.TOP, size, lambda right, up: np.where(pocket(right, up), 6.0, 0.0), pocket)
    hull = hull_of(size, {}, depth_maps=(top,))
    assert hull.watertight
    assert hull.volume == pytest.approx(6000.0 - 16.0 * 10.0 * 6.0, rel=0.004)
    floor = hull.vertices[np.hypot(hull.vertices[:, 0] - 15.0, hull.vertices[:, 1] - 10.0) < 3.0]
    assert set(np.round(floor[:, 2], 3)) == {0.0, 4.0}


def test_a_depth_from_behind_carves_the_far_side() -> None:
    size = (30.0, 20.0, 10.0)

    def pocket(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return (abs(right - 15.0) < 8.0) & (abs(up - 10.0) < 5.0)

    depths = depth_map(
        Role.TOP, size, lambda right, up: np.where(pocket(right, up), 6.0, 0.0), pocket
    )
    hull = hull_of(size, {}, depth_maps=(replace(depths, behind=True),))
    assert hull.watertight
    assert hull.volume == pytest.approx(6000.0 - 16.0 * 10.0 * 6.0, rel=0.004)
    roof = hull.vertices[np.hypot(hull.vertices[:, 0] - 15.0, hull.vertices[:, 1] - 10.0) < 3.0]
    assert set(np.round(roof[:, 2], 3)) == {6.0, 10.0}


def test_only_chosen_regions_are_carved() -> None:
    size = (30.0, 20.0, 10.0)

    def left(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return right < 15.0

    top = depth_map(Role.TOP, size, lambda right, up: np.where(left(right, up), 4.0, 0.0), left)
    for chosen, carved in ((None, True), ({2}, True), ({1}, False), (set(), False)):
        numbers = None if chosen is None else frozenset(chosen)
        hull = hull_of(size, {}, depth_maps=(replace(top, chosen=numbers),))
        assert hull.watertight
        assert hull.volume == pytest.approx(6000.0 - 1200.0 * carved, rel=0.004)


def test_a_known_depth_makes_a_boss_round() -> None:
    size = (20.0, 20.0, 20.0)

    def boss(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return np.hypot(right - 10.0, up - 10.0) < 6.0

    def side(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return (up < 8.0) | (abs(right - 10.0) < 6.0)

    top = depth_map(Role.TOP, size, lambda right, up: np.where(boss(right, up), 0.0, 12.0), boss)
    shapes = {Role.FRONT: side, Role.RIGHT: side}
    exact = 400.0 * 8.0 + np.pi * 36.0 * 12.0
    assert hull_of(size, shapes).volume > exact * 1.05
    hull = hull_of(size, shapes, depth_maps=(top,))
    assert hull.watertight
    assert hull.volume == pytest.approx(exact, rel=0.004)


def test_a_depth_that_the_hull_has_anyway_changes_nothing() -> None:
    size = (30.0, 20.0, 10.0)
    flat = depth_map(Role.TOP, size, lambda right, up: np.full_like(right, 0.05))
    assert hull_of(size, {}, depth_maps=(flat,)).volume == pytest.approx(6000.0, rel=1e-4)


def test_regions_side_by_side_leave_no_skin_between_them() -> None:
    size = (20.0, 20.0, 10.0)

    def half(right: np.ndarray, up: np.ndarray) -> np.ndarray:
        return right > 10.0

    deep = depth_map(Role.TOP, size, lambda right, up: np.full_like(right, 7.0), half)
    hull = hull_of(size, {}, depth_maps=(deep,))
    assert hull.watertight
    assert hull.volume == pytest.approx(400.0 * 3.0, rel=1e-3)
    assert hull.bounds[1, 2] == pytest.approx(3.0, abs=1e-3)
