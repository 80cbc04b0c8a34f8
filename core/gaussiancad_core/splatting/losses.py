"""What the training minimises: the paper's loss.

``(1 - l) L1 + l (1 - SSIM) + m BCE`` with L1 and D-SSIM of 3D Gaussian splatting (Kerbl et al.
2023) on the colours and the binary cross entropy on the masks, as GaussianCAD (Zhou et al.) has it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from gaussiancad_core.splatting import loss_kernels
from gaussiancad_core.splatting.kernel_threads import KERNELS
from gaussiancad_core.splatting.rasterizer import Rendering

ALPHA_MARGIN = 1e-4
"""Alphas are held this far from 0 and 1 in the cross entropy, where its gradient has no end."""


@dataclass(frozen=True)
class LossWeights:
    """Weights of the terms.

    Attributes:
        ssim: the share of D-SSIM against L1; 0.2 as in 3DGS.
        mask: the weight of the cross entropy; 0.1 holds silhouettes without overruling the colours.
    """

    ssim: float = 0.2
    mask: float = 0.1


@dataclass(frozen=True, eq=False)
class Targets:
    """What the views should show.

    Attributes:
        colours: (v, 3, h, w) float32 RGB, 0 to 1.
        masks: (v, h, w) float32, share of each pixel that the part covers.
        background: RGB, 0 to 1, where there is no part.
    """

    colours: Tensor
    masks: Tensor
    background: tuple[float, float, float] = (1.0, 1.0, 1.0)

    def on(self, device: str) -> "Targets":
        """The same targets on a device."""
        return Targets(self.colours.to(device), self.masks.to(device), self.background)

    def part(self, views: slice) -> "Targets":
        """The targets of some of the views."""
        return Targets(self.colours[views], self.masks[views], self.background)


def composed(rendering: Rendering, background: tuple[float, float, float]) -> Tensor:
    """(v, 3, h, w) the rendered colours on a uniform background."""
    # Each is filled in where it is needed: a copy from the processor would make a GPU wait.
    behind = torch.stack([rendering.alphas.new_full((1, 1), value) for value in background])
    return rendering.colours + (1.0 - rendering.alphas)[:, None] * behind


def mask_entropy(alphas: Tensor, masks: Tensor) -> Tensor:
    """Mean binary cross entropy of (v, h, w) alphas against masks from 0 to 1."""
    held = alphas.clamp(ALPHA_MARGIN, 1.0 - ALPHA_MARGIN)
    return torch.nn.functional.binary_cross_entropy(held, masks)


def plain_compared(rendering: Rendering, targets: Targets) -> tuple[Tensor, Tensor, Tensor]:
    """(v, 3, h, w) images on the background, their mean distance in colour, and the entropy.

    In torch, for any device.
    """
    images = composed(rendering, targets.background)
    absolute = (images - targets.colours).abs().mean()
    return images, absolute, mask_entropy(rendering.alphas, targets.masks)


def fast_compared(rendering: Rendering, targets: Targets) -> tuple[Tensor, Tensor, Tensor]:
    """As :func:`plain_compared`, float32 on a processor; differentiable once."""
    return _Compared.apply(rendering.colours, rendering.alphas, targets)


class _Compared(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any,  # noqa: ANN401
        colours: Tensor,
        alphas: Tensor,
        targets: Targets,
    ) -> tuple[Tensor, Tensor, Tensor]:
        rendered = _array(colours), _array(alphas)
        wanted = _array(targets.colours), _array(targets.masks)
        fixed = np.array(targets.background, dtype=np.float32), np.float32(ALPHA_MARGIN)
        images, sums = np.empty_like(rendered[0]), np.empty((loss_kernels.PARTS, 2))
        with KERNELS:
            loss_kernels.compare_forward(rendered, wanted, *fixed, images, sums)
        ctx.state = (rendered[1], images, wanted, *fixed)
        absolute, entropy = sums.sum(axis=0) / (images.size, wanted[1].size)
        return torch.from_numpy(images), colours.new_tensor(absolute), colours.new_tensor(entropy)

    @staticmethod
    def backward(ctx: Any, *upstream: Tensor) -> tuple[Tensor | None, ...]:  # noqa: ANN401
        alphas, images = ctx.state[:2]
        to_images, to_absolute, to_entropy = upstream
        each = (
            _array(to_images),
            np.float32(to_absolute.item() / images.size),
            np.float32(to_entropy.item() / alphas.size),
        )
        gradients = np.empty_like(images), np.empty_like(alphas)
        with KERNELS:
            loss_kernels.compare_backward(*ctx.state, each, gradients)
        return *(torch.from_numpy(gradient) for gradient in gradients), None


def _array(tensor: Tensor) -> npt.NDArray[np.float32]:
    return np.ascontiguousarray(tensor.detach().numpy(), dtype=np.float32)


def total_loss(
    rendering: Rendering,
    targets: Targets,
    similarity: Callable[[Tensor], Tensor],
    weights: LossWeights,
) -> Tensor:
    """The loss of a rendering; a scalar.

    Args:
        rendering: v views.
        targets: the same views.
        similarity: mean SSIM of (v, 3, h, w) images with the targets' colours.
        weights: of the terms.
    """
    compare = fast_compared if rendering.alphas.device.type == "cpu" else plain_compared
    images, absolute, entropy = compare(rendering, targets)
    dissimilar = 1.0 - similarity(images)
    return (1.0 - weights.ssim) * absolute + weights.ssim * dissimilar + weights.mask * entropy
