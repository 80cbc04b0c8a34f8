"""The loss: its terms by hand, and how they add up."""

import numpy as np
import pytest
import torch

from gaussiancad_core.splatting.losses import (
    ALPHA_MARGIN,
    LossWeights,
    Targets,
    fast_compared,
    mask_entropy,
    plain_compared,
    total_loss,
)
from gaussiancad_core.splatting.rasterizer import Rendering


def rendering(alpha: float = 0.25, colour: float = 0.1) -> Rendering:
    shape = (2, 4, 5)
    return Rendering(torch.full((2, 3, 4, 5), colour), torch.full(shape, alpha), torch.zeros(shape))


def test_entropy_is_that_of_the_formula() -> None:
    alphas = torch.tensor([[[0.2, 0.9], [0.5, 0.7]]])
    masks = torch.tensor([[[0.0, 1.0], [0.5, 0.25]]])
    a, m = alphas.numpy(), masks.numpy()
    expected = -(m * np.log(a) + (1 - m) * np.log(1 - a)).mean()
    assert float(mask_entropy(alphas, masks)) == pytest.approx(expected, rel=1e-6)


def test_entropy_and_its_gradient_stay_finite_at_the_ends() -> None:
    alphas = torch.tensor([[[0.0, 1.0]]]).requires_grad_()
    value = mask_entropy(alphas, torch.tensor([[[1.0, 0.0]]]))
    value.backward()
    assert float(value.detach()) == pytest.approx(-np.log(ALPHA_MARGIN), rel=1e-3)
    assert torch.isfinite(alphas.grad).all()


@pytest.mark.parametrize("weights", [LossWeights(), LossWeights(0.0, 0.0), LossWeights(1.0, 2.0)])
def test_terms_add_up_with_their_weights(weights: LossWeights) -> None:
    found = rendering()
    targets = Targets(torch.zeros(2, 3, 4, 5), torch.ones(2, 4, 5))
    total = total_loss(found, targets, lambda images: images.new_tensor(0.4), weights)
    absolute, entropy = 0.85, -np.log(0.25)
    expected = (1 - weights.ssim) * absolute + weights.ssim * 0.6 + weights.mask * entropy
    assert float(total) == pytest.approx(expected, rel=1e-6)


def test_compiled_terms_and_their_gradients_are_those_of_torch() -> None:
    random = torch.Generator().manual_seed(0)
    colours, wanted, upstream = (torch.rand(2, 3, 9, 37, generator=random) for _ in range(3))
    alphas, masks = (torch.rand(2, 9, 37, generator=random) for _ in range(2))
    # Beyond the margins of the entropy, and where there is no distance either.
    alphas[:, :2], alphas[:, 2:4], masks[:, 1:3] = 0.0, 1.0, 1.0
    wanted[..., 2:4, :] = colours[..., 2:4, :]
    targets = Targets(wanted, masks, (1.0, 0.5, 0.25))
    found = []
    for compared in (plain_compared, fast_compared):
        leaves = colours.clone().requires_grad_(), alphas.clone().requires_grad_()
        terms = compared(Rendering(*leaves, torch.zeros_like(alphas)), targets)
        ((terms[0] * upstream).sum() + 700.0 * terms[1] + 20.0 * terms[2]).backward()
        found.append([*(term.detach() for term in terms), *(leaf.grad for leaf in leaves)])
    for plain, fast in zip(*found, strict=True):
        torch.testing.assert_close(fast, plain, rtol=2e-6, atol=2e-6)
