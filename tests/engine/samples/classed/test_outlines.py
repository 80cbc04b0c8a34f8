import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse

from gaussiancad_core.kernel.brep import bounding_box, soundness, volume
from gaussiancad_core.model.axes import Axis
from sample_parts.classed.outlines import (
    combined,
    convex,
    extruded,
    frustum,
    rectangle,
    regular,
    sampled,
    sharp,
    turned,
)
from sample_parts.classed.surfaces import SurfaceKind, surface_kinds
from sample_parts.modelling import box


@pytest.mark.parametrize("axis", list(Axis))
def test_rounded_corners_are_quarters_of_circles(axis: Axis) -> None:
    solid = extruded(axis, rectangle((0, 0), (40, 30), 5.0), 2.0, 12.0)
    assert volume(solid) == pytest.approx(10.0 * (1200.0 - (4.0 - np.pi) * 25.0))
    assert soundness(solid).faces == 10
    assert bounding_box(solid)[:, axis.value] == pytest.approx([2.0, 12.0])


def test_an_inner_corner_gets_a_fillet() -> None:
    angle = [(0, 0, 0), (30, 0, 0), (30, 10, 0), (10, 10, 4), (10, 30, 0), (0, 30, 0)]
    area = 500.0 + (1.0 - np.pi / 4.0) * 16.0
    assert volume(extruded(Axis.Y, angle, 0.0, 1.0)) == pytest.approx(area)


@pytest.mark.parametrize(
    ("profile", "expected", "kind"),
    [
        ([(0, 0, 0), (0, 6, 0), (9, 6, 0), (9, 0, 0)], 36 * 9 * np.pi, SurfaceKind.CYLINDER),
        ([(0, 0, 0), (0, 6, 0), (9, 0, 0)], 36 * 3 * np.pi, SurfaceKind.CONE),
        ([(0, 0, 0), (0, 6, 0), (6, 6, 6), (6, 0, 0)], 144 * np.pi, SurfaceKind.SPHERE),
        (
            [(0, 0, 0), (0, 6, 0), (6, 6, 2), (6, 0, 0)],
            # A square's corner beyond a quarter of a disc, turned around (Pappus and Guldinus).
            216 * np.pi - 2 * np.pi * (4 * 5 - (np.pi * 4 + 8 / 3)),
            SurfaceKind.TORUS,
        ),
    ],
)
def test_profiles_turn_into_exact_surfaces(
    profile: list, expected: float, kind: SurfaceKind
) -> None:
    solid = turned(Axis.Z, (10.0, 10.0), profile)
    assert soundness(solid).valid
    assert kind in surface_kinds(solid)
    assert volume(solid) == pytest.approx(expected)


def test_a_hull_has_a_face_for_each_plane() -> None:
    corners = [(x, y, z) for x in (0, 3) for y in (0, 4) for z in (0, 5)]
    cube = convex([*corners, (1, 2, 0), (1, 1, 5)])
    assert (soundness(cube).faces, volume(cube)) == (6, pytest.approx(60.0))
    assert soundness(cube).valid


def test_a_frustum_tapers() -> None:
    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    upper = [(2, 2), (8, 2), (8, 8), (2, 8)]
    solid = frustum(Axis.X, square, upper, (0.0, 6.0))
    assert volume(solid) == pytest.approx(6.0 / 3.0 * (100.0 + 36.0 + 60.0))
    assert surface_kinds(solid) == {SurfaceKind.PLANE, SurfaceKind.SLANT}
    hexagons = [[point[:2] for point in regular((0, 0), radius, 6)] for radius in (9, 6)]
    assert SurfaceKind.OBLIQUE in surface_kinds(frustum(Axis.Z, *hexagons, (0.0, 6.0)))


def test_many_tools_at_once() -> None:
    plate = box((0, 0, 0), (50, 10, 4))
    tools = [box((x, 2, -1), (x + 4, 8, 5)) for x in (2, 5, 20, 30)]
    assert volume(combined(BRepAlgoAPI_Cut, plate, tools)) == pytest.approx(2000 - 4 * 6 * 15)
    upright = [box((x, 2, 2), (x + 4, 8, 9)) for x in (2, 20)]
    assert volume(combined(BRepAlgoAPI_Fuse, plate, upright)) == pytest.approx(2000 + 2 * 120)


def test_samples_lie_on_the_outline() -> None:
    points = sampled(rectangle((0, 0), (20, 12), 6.0))
    assert points[:, 1].min() == pytest.approx(0.0, abs=1e-9)
    ends = points[points[:, 0] < 6.0] - (6.0, 6.0)
    np.testing.assert_allclose(np.hypot(*ends.T), 6.0)
    np.testing.assert_array_equal(
        sampled(sharp([(0, 0), (4, 0), (0, 3)])), [[0, 0], [4, 0], [0, 3]]
    )
