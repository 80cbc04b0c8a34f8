"""Structural similarity (Wang et al. 2004) of images with fixed targets.

An 11 x 11 Gaussian window of standard deviation 1.5, blank beyond the border, as 3D Gaussian
splatting uses it.  :func:`plain_ssim` is the reference in torch.  :func:`similarity_with` has its
gradient worked out, which needs half of the blurs, and blurs along the rows and then along the
columns: with OpenCV on a processor, where it is about ten times as fast, and in torch on a GPU.
"""

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt
import torch
from numba import njit
from torch import Tensor

WINDOW = 11
SIGMA = 1.5
_C1 = 0.01**2
_C2 = 0.03**2

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
        self._targets = np.ascontiguousarray(targets.detach().numpy(), dtype=np.float32)
        self._mean = _blur(self._targets)
        self._variance = _blur(self._targets * self._targets) - self._mean * self._mean

    def __call__(self, images: Tensor) -> Tensor:
        """Mean SSIM of (v, c, h, w) images with the targets; differentiable once."""
        return _Similarity.apply(images, self._targets, self._mean, self._variance)


class _Similarity(torch.autograd.Function):
    @staticmethod
    def forward(
        ctx: Any,  # noqa: ANN401
        images: Tensor,
        targets: Array,
        target_mean: Array,
        target_variance: Array,
    ) -> Tensor:
        x = np.ascontiguousarray(images.detach().numpy())
        mean, square, product = _blur(x), _blur(x * x), _blur(x * targets)
        to_mean, to_square, to_product = (np.empty_like(x) for _ in range(3))
        total = _similarity(
            (mean.ravel(), square.ravel(), product.ravel()),
            (target_mean.ravel(), target_variance.ravel()),
            (to_mean.ravel(), to_square.ravel(), to_product.ravel()),
        )
        # The blur is symmetric: it is its own transpose.
        gradient = _blur(to_mean)
        gradient += 2.0 * x * _blur(to_square)
        gradient += targets * _blur(to_product)
        ctx.gradient = torch.from_numpy(gradient / np.float32(x.size))
        return torch.tensor(total / x.size, dtype=torch.float32)

    @staticmethod
    def backward(ctx: Any, upstream: Tensor) -> tuple[Tensor | None, ...]:  # noqa: ANN401
        return ctx.gradient * upstream, None, None, None


def _blur(stack: Array) -> Array:
    blurred = np.empty_like(stack)
    height, width = stack.shape[-2:]
    for source, target in zip(
        stack.reshape(-1, height, width), blurred.reshape(-1, height, width), strict=True
    ):
        cv2.GaussianBlur(source, (WINDOW, WINDOW), SIGMA, target, borderType=cv2.BORDER_CONSTANT)
    return blurred


@njit(fastmath=True, error_model="numpy", cache=True)
def _similarity(own, fixed, gradients):  # noqa: ANN001, ANN202
    """Sum of the SSIM over all pixels, and its gradients to the three blurred images."""
    means, squares, products = own
    target_means, target_variances = fixed
    to_means, to_squares, to_products = gradients
    c1, c2, two = np.float32(_C1), np.float32(_C2), np.float32(2.0)
    total = 0.0
    for i in range(means.size):
        x, y = means[i], target_means[i]
        variance = squares[i] - x * x
        covariance = products[i] - x * y
        a1, a2 = two * x * y + c1, two * covariance + c2
        b1 = x * x + y * y + c1
        b2 = variance + target_variances[i] + c2
        value = a1 * a2 / (b1 * b2)
        total += value
        to_products[i] = two * a1 / (b1 * b2)
        to_squares[i] = -value / b2
        # The mean also enters through the variance and the covariance.
        direct = two * y * a2 / (b1 * b2) - two * value * x / b1
        to_means[i] = direct - two * x * to_squares[i] - y * to_products[i]
    return total
