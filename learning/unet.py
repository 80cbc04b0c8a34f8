"""The labels network as it is trained: a U-Net that labels each pixel (Ronneberger 2015).

Everything but its first and last layer works on a half of the picture's resolution and below, with
residual blocks (He 2016), the deepest of them dilated so that a pixel sees half a view.
"""

from typing import Any

import torch
from torch import Tensor, nn
from torch.nn import functional

from gaussiancad_core.sheet.labels.ink_classes import InkClass

CHANNELS = (24, 32, 48, 72, 160)
"""Of the five levels, from half of the resolution to a thirty-second."""

EXTRA = 2
"""Outputs beside the classes: on a hidden line, dash or gap; corner or junction of the part's
lines.  Logits of their own probabilities."""

_RARE = -4.0
"""Where the logits of the extra outputs begin: both are rare."""


class _Block(nn.Module):
    """Two convolutions beside a short cut."""

    def __init__(self, channels: int, dilation: int = 1) -> None:
        super().__init__()
        self.a = _convolution(channels, channels, 3, 1, dilation)
        self.b = nn.Conv2d(channels, channels, 3, 1, dilation, dilation, bias=False)
        self.n = nn.BatchNorm2d(channels)

    def forward(self, x: Tensor) -> Tensor:
        return functional.relu(x + self.n(self.b(self.a(x))))


def _convolution(
    inputs: int, outputs: int, size: int = 3, stride: int = 1, dilation: int = 1
) -> nn.Sequential:
    padding = dilation * (size // 2)
    return nn.Sequential(
        nn.Conv2d(inputs, outputs, size, stride, padding, dilation, bias=False),
        nn.BatchNorm2d(outputs),
        nn.ReLU(inplace=True),
    )


class LabelsNetwork(nn.Module):
    """Ink to logits.

    Takes (n, 1, h, w) float, 1 for ink to 0 for paper, h and w multiples of 32; gives
    (n, classes + extra, h, w).
    """

    def __init__(self, channels: tuple[int, ...] = CHANNELS, extra: int = EXTRA) -> None:
        super().__init__()
        a, b, c, d, e = channels
        outputs = len(InkClass) + extra
        self.stem = nn.Sequential(nn.PixelUnshuffle(2), _convolution(4, a), _Block(a))
        self.d1 = nn.Sequential(_convolution(a, b, 3, 2), _Block(b), _Block(b))
        self.d2 = nn.Sequential(_convolution(b, c, 3, 2), _Block(c), _Block(c, 2))
        self.d3 = nn.Sequential(_convolution(c, d, 3, 2), _Block(d), _Block(d, 2))
        self.d4 = nn.Sequential(_convolution(d, e, 3, 2), _Block(e), _Block(e, 2), _Block(e, 4))
        self.u3 = nn.Sequential(_convolution(d + e, d), _Block(d))
        self.u2 = nn.Sequential(_convolution(c + d, c), _Block(c))
        self.u1 = nn.Sequential(_convolution(b + c, b), _Block(b))
        self.u0 = nn.Sequential(_convolution(a + b, a), _Block(a))
        last = nn.Conv2d(a, 4 * outputs, 1)
        self.head = nn.Sequential(last, nn.PixelShuffle(2))
        assert last.bias is not None
        nn.init.constant_(last.bias[-4 * extra :].data, _RARE)

    def forward(self, ink: Tensor) -> Tensor:
        """Logits of a batch."""
        x0 = self.stem(ink)
        x1 = self.d1(x0)
        x2 = self.d2(x1)
        x3 = self.d3(x2)
        y = self.u3(torch.cat([x3, _larger(self.d4(x3))], 1))
        y = self.u2(torch.cat([x2, _larger(y)], 1))
        y = self.u1(torch.cat([x1, _larger(y)], 1))
        y = self.u0(torch.cat([x0, _larger(y)], 1))
        return self.head(y)


def _larger(x: Tensor) -> Tensor:
    return functional.interpolate(x, scale_factor=2.0, mode="nearest")


def load_weights(network: LabelsNetwork, stored: dict[str, Any]) -> None:
    """Take weights as they are stored, in half precision or full."""
    network.load_state_dict(
        {name: item.float() if item.is_floating_point() else item for name, item in stored.items()}
    )
