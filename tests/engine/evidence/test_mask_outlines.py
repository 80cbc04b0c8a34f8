"""Outlines of masks: distances and straight parts."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.evidence.mask_outlines import (
    PAD_PX,
    padded_mask,
    plane_field,
    signed_distance,
    straight_parts,
)
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import View


def view_of(
    mask: np.ndarray, role: Role = Role.FRONT, origin: tuple[float, float] = (0.0, 0.0)
) -> View:
    colour = np.zeros((*mask.shape, 3), np.uint8)
    return View(role, (0, 0, 1, 1), (), mask, colour, origin, 0.5)


def test_distance_to_a_straight_outline_is_that_of_the_centres() -> None:
    mask = np.zeros((20, 20), bool)
    mask[:, 7:] = True
    distances = signed_distance(mask, 0.5)
    assert np.allclose(distances, np.broadcast_to((6.5 - np.arange(20)) * 0.5, (20, 20)))


def test_distance_to_a_disc_is_within_a_pixel_of_the_truth_everywhere() -> None:
    y, x = np.mgrid[:101, :101]
    radius = np.hypot(x - 50.0, y - 50.0)
    assert np.abs(signed_distance(radius < 30.0, 1.0) - (radius - 30.0)).max() < 0.75


def test_a_mask_without_an_outline_is_far_from_it() -> None:
    assert (signed_distance(np.ones((5, 8), bool), 1.0) < -9.0).all()
    assert (signed_distance(np.zeros((5, 8), bool), 1.0) > 9.0).all()


@given(st.floats(-5.0, 30.0), st.floats(-30.0, 5.0))
def test_a_linear_field_is_interpolated_exactly_and_held_beyond_its_border(
    right: float, up: float
) -> None:
    view = view_of(np.zeros((32, 32), bool))
    rows, columns = np.mgrid[:40, :40]
    field = plane_field((2.0 * columns - rows).astype(np.float32), view)
    x = np.clip(right / 0.5 + PAD_PX - 0.5, 0, 39)
    y = np.clip(-up / 0.5 + PAD_PX - 0.5, 0, 39)
    assert field.at(np.array([[right, up]]))[0] == pytest.approx(2.0 * x - y, abs=1e-4)


def test_a_mask_that_nearly_reaches_the_box_goes_on_beyond_it() -> None:
    # 20 x 10 mm of half a millimetre, its left and upper side short of the box by 0.4 pixels.
    mask = np.zeros((30, 50), bool)
    mask[5:25, 5:45] = True
    view = view_of(mask, origin=(-2.3, 12.3))
    padded = padded_mask(view, (20.0, 1.0, 10.0), to_box=True)
    assert padded.shape == (38, 58)
    assert padded.all()
    assert np.array_equal(padded_mask(view, (20.0, 1.0, 10.0), to_box=False), np.pad(mask, PAD_PX))


@pytest.mark.parametrize("rounding", [-1e-5, 1e-5])
def test_a_mask_a_pixel_short_goes_on_whatever_rounding_makes_of_it(rounding: float) -> None:
    mask = np.zeros((30, 50), bool)
    mask[5:25, 5:45] = True
    view = view_of(mask, origin=(-2.0 + rounding, 12.5))
    assert padded_mask(view, (20.5, 1.0, 10.0), to_box=True).all()


def test_a_mask_that_ends_inside_the_box_is_left_as_it_is() -> None:
    mask = np.zeros((30, 50), bool)
    mask[5:25, 5:45] = True
    padded = padded_mask(view_of(mask, origin=(-2.5, 12.5)), (30.0, 1.0, 20.0), to_box=True)
    # It stands on the box's left and lower side and ends far from the others.
    assert padded[20, 0]
    assert padded[-1, 20]
    assert not padded[20, -1]
    assert not padded[0, 20]


@pytest.mark.parametrize(
    ("role", "axis", "expected"),
    [
        (Role.FRONT, Axis.X, {2.0, 12.0}),
        (Role.FRONT, Axis.Z, {-11.0, -3.0}),
        (Role.FRONT, Axis.Y, set()),
        (Role.LEFT, Axis.Y, {-2.0, -12.0}),
        (Role.BOTTOM, Axis.Y, {11.0, 3.0}),
    ],
)
def test_straight_parts_are_found_on_the_axes_that_the_view_shows(
    role: Role, axis: Axis, expected: set[float]
) -> None:
    mask = np.zeros((40, 40), bool)
    mask[6:22, 4:24] = True
    assert set(straight_parts(np.pad(mask, PAD_PX), view_of(mask, role), axis)) == expected
