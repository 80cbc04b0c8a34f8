"""Structural similarity: known values, and the fast version against the plain one."""

import cv2
import numba
import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from skimage.metrics import structural_similarity

from gaussiancad_core.splatting.ssim import FastSsim, TorchSsim, plain_ssim


def images(seed: int, height: int = 24, width: int = 31) -> tuple[torch.Tensor, torch.Tensor]:
    random = np.random.default_rng(seed)
    stacks = random.random((2, 2, 3, height, width)).astype(np.float32)
    smooth = [cv2.GaussianBlur(stack.reshape(-1, width), (7, 7), 2.0) for stack in stacks]
    return tuple(torch.from_numpy(stack.reshape(2, 3, height, width)) for stack in smooth)


def test_black_and_white_are_as_unlike_as_the_constants_allow() -> None:
    black, white = torch.zeros(1, 1, 64, 64), torch.ones(1, 1, 64, 64)
    similarity = float(plain_ssim(black, white))
    # Far from the border only the luminance differs; there white fades, which is a contrast too.
    assert 0.0 < similarity <= 1e-4 / (1.0 + 1e-4)


def test_plain_version_agrees_with_another_implementation() -> None:
    one, other = images(1, 60, 70)
    # That one mirrors the images at their borders, so both get a black margin.
    for stack in (one, other):
        blank = torch.zeros_like(stack)
        blank[..., 12:-12, 12:-12] = stack[..., 12:-12, 12:-12]
        stack.copy_(blank)
    expected = structural_similarity(
        one[0, 0].numpy().astype(np.float64),
        other[0, 0].numpy().astype(np.float64),
        gaussian_weights=True,
        sigma=1.5,
        use_sample_covariance=False,
        data_range=1.0,
        full=True,
    )[1].mean()
    found = plain_ssim(one[:1, :1].double(), other[:1, :1].double())
    assert float(found) == pytest.approx(expected, abs=1e-9)


WIDE = (100, 470)
"""Height and width of images of several tiles, the last of which are cut."""

PLACES = {
    "nowhere": (slice(0, 0), slice(0, 0)),
    "at one pixel": (slice(50, 51), slice(300, 301)),
    "within a tile": (slice(10, 30), slice(20, 200)),
    "across tiles": (slice(30, 95), slice(210, 445)),
    "at the border": (slice(90, 100), slice(460, 470)),
    "everywhere": (slice(None), slice(None)),
}


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_tiles_have_the_value_and_gradient_of_the_whole(place: tuple[slice, slice]) -> None:
    target, other = images(3, *WIDE)
    one = target.clone()
    one[..., *place] = other[..., *place]
    exact = one.double().requires_grad_()
    plain = plain_ssim(exact, target.double())
    plain.backward()
    similarity, gradient = FastSsim(target).with_gradient(one)
    assert similarity == pytest.approx(float(plain.detach()), abs=1e-6)
    assert (gradient - exact.grad).abs().max() <= 1e-4 * exact.grad.abs().max() + 1e-12


def test_any_number_of_threads_gives_the_same_bits() -> None:
    target, one = images(4, *WIDE)
    before = numba.get_num_threads()
    found = []
    try:
        for threads in (1, before):
            numba.set_num_threads(threads)
            found.append(FastSsim(target).with_gradient(one))
    finally:
        numba.set_num_threads(before)
    assert found[0][0] == found[1][0]
    assert torch.equal(found[0][1], found[1][1])


@pytest.mark.parametrize("version", [FastSsim, TorchSsim])
@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000))
def test_fast_versions_have_the_value_and_gradient_of_the_plain_one(
    version: type[FastSsim] | type[TorchSsim], seed: int
) -> None:
    one, other = images(seed)
    exact = one.double().requires_grad_()
    plain = plain_ssim(exact, other.double())
    plain.backward()
    single = one.clone().requires_grad_()
    fast = version(other)(single)
    (3.0 * fast).backward()
    assert float(fast.detach()) == pytest.approx(float(plain.detach()), abs=2e-5)
    expected = 3.0 * exact.grad
    assert (single.grad - expected).abs().max() < 2e-3 * expected.abs().max()
