"""Structural similarity (Wang et al. 2004) of images with fixed targets.

An 11 x 11 Gaussian window of standard deviation 1.5, blank beyond the border, as 3D Gaussian
splatting uses it.  :func:`plain_ssim` is the reference in torch.  :func:`similarity_with` has its
gradient worked out, which needs half of the blurs, and blurs along the rows and then along the
columns: compiled on a processor, see :mod:`ssim_kernels`, and in torch on a GPU.
"""

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from gaussiancad_core.splatting import ssim_kernels
from gaussiancad_core.splatting.kernel_threads import KERNELS
from gaussiancad_core.splatting.ssim_kernels import C1 as _C1
from gaussiancad_core.splatting.ssim_kernels import C2 as _C2
from gaussiancad_core.splatting.ssim_kernels import SIGMA, WINDOW

Array = npt.NDArray[np.float32]


def plain_ssim(images: Tensor, targets: Tensor) -> Tensor:
    """Mean SSIM of two (v, c, h, w) stacks with values from 0 to 1, of any float type."""
    channels = images.shape[1]
    profile = _profile(images)
    window = torch.outer(profile, profile).expand(channels, 1, WINDOW, WINDOW)

    def blur(stack: Tensor) -> Tensor:
        return torch.nn.functional.conv2d(stack, window, padding=WINDOW // 2, groups=channels)

    mean_x, mean_y = blur(images), blur(targets)
    variance_x = blur(images * images) - mean_x * mean_x
    variance_y = blur(targets * targets) - mean_y * mean_y
    covariance = blur(images * targets) - mean_x * mean_y
    luminance = (2 * mean_x * mean_y + _C1) / (mean_x**2 + mean_y**2 + _C1)
    contrast = (2 * covariance + _C2) / (variance_x + variance_y + _C2)
    return (luminance * contrast).mean()


def similarity_with(targets: Tensor) -> Callable[[Tensor], Tensor]:
    """Mean SSIM with fixed targets, where they are; differentiable once.

    Args:
        targets: (v, c, h, w) float32 with values from 0 to 1.
    """
    return FastSsim(targets) if targets.device.type == "cpu" else TorchSsim(targets)


def _profile(like: Tensor) -> Tensor:
    """(WINDOW,) weights along a row or a column, of the type of a tensor and where it is."""
    offsets = torch.arange(WINDOW, dtype=like.dtype, device=like.device) - WINDOW // 2
    profile = torch.exp(-(offsets**2) / (2 * SIGMA**2))
    return profile / profile.sum()


class TorchSsim:
    """SSIM with fixed targets on any device, for GPUs: see :func:`similarity_with`.

    Attributes:
        targets: (v, c, h, w).
        mean, variance: of the targets about each pixel.
    """

    def __init__(self, targets: Tensor) -> None:
        self.targets = targets.detach().contiguous()
        self.mean, square = self.blurred(torch.stack([self.targets, self.targets**2]))
        self.variance = square - self.mean**2

    def __call__(self, images: Tensor) -> Tensor:
        """Mean SSIM of (v, c, h, w) images with the targets; differentiable once."""
        return _TorchSimilarity.apply(images, self)

    @staticmethod
    def blurred(stack: Tensor) -> Tensor:
        """Each (h, w) image of a stack of any shape, blurred; blank beyond the border."""
        images, half = stack.reshape(-1, 1, *stack.shape[-2:]), WINDOW // 2
        row = _profile(stack).view(1, 1, 1, -1)
        along = torch.nn.functional.conv2d(images, row, padding=(0, half))
        both = torch.nn.functional.conv2d(along, row.mT, padding=(half, 0))
        return both.view(stack.shape)


class _TorchSimilarity(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, images: Tensor, fixed: TorchSsim) -> Tensor:  # noqa: ANN401
        x, y = images.detach().contiguous(), fixed.mean
        mean, square, product = fixed.blurred(torch.stack([x, x * x, x * fixed.targets]))
        a1, a2 = 2 * mean * y + _C1, 2 * (product - mean * y) + _C2
        b1, b2 = mean**2 + y**2 + _C1, square - mean**2 + fixed.variance + _C2
        value = a1 * a2 / (b1 * b2)
        to_product = 2 * a1 / (b1 * b2)
        to_square = -value / b2
        # The mean also enters through the variance and the covariance.
        direct = 2 * y * a2 / (b1 * b2) - 2 * value * mean / b1
        to_mean = direct - 2 * mean * to_square - y * to_product
        # The blur is symmetric: it is its own transpose.
        first, second, third = fixed.blurred(torch.stack([to_mean, to_square, to_product]))
        ctx.gradient = (first + 2 * x * second + fixed.targets * third) / x.numel()
        return value.mean()

    @staticmethod
    def backward(ctx: Any, upstream: Tensor) -> tuple[Tensor | None, ...]:  # noqa: ANN401
        return ctx.gradient * upstream, None


class FastSsim:
    """SSIM with fixed targets on a processor, float32: see :func:`similarity_with`.

    Args:
        targets: (v, c, h, w) with values from 0 to 1.
    """

    def __init__(self, targets: Tensor) -> None:
        self._shape = targets.shape
        images = targets.detach().reshape(-1, *targets.shape[-2:])
        self._targets = np.ascontiguousarray(images.numpy(), dtype=np.float32)
        self._mean = _blurred(self._targets)
        self._variance = _blurred(self._targets * self._targets) - self._mean * self._mean

    def __call__(self, images: Tensor) -> Tensor:
        """Mean SSIM of (v, c, h, w) images with the targets; differentiable once."""
        return _Similarity.apply(images, self)

    def with_gradient(self, images: Tensor) -> tuple[float, Tensor]:
        """Mean SSIM of (v, c, h, w) images with the targets, and its gradient to the images."""
        values = np.ascontiguousarray(images.detach().numpy()).reshape(self._targets.shape)
        gradient = np.zeros_like(values)
        sums = np.empty(ssim_kernels.tile_count(values.shape))
        fixed = self._targets, self._mean, self._variance
        with KERNELS:
            ssim_kernels.similarities(values, *fixed, gradient, sums)
        return float(sums.sum()) / values.size, torch.from_numpy(gradient).view(self._shape)


class _Similarity(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, images: Tensor, fixed: FastSsim) -> Tensor:  # noqa: ANN401
        similarity, ctx.gradient = fixed.with_gradient(images)
        return torch.tensor(similarity, dtype=torch.float32)

    @staticmethod
    def backward(ctx: Any, upstream: Tensor) -> tuple[Tensor | None, ...]:  # noqa: ANN401
        return ctx.gradient * upstream, None


def _blurred(images: Array) -> Array:
    """Each of (n, h, w) images, blurred; blank beyond the border."""
    size = (WINDOW, WINDOW)
    return np.stack(
        [cv2.GaussianBlur(image, size, SIGMA, borderType=cv2.BORDER_CONSTANT) for image in images]
    )
