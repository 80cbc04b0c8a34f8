"""What a rasteriser takes and gives, whichever back end does the work.

Front-to-back compositing as in 3D Gaussian splatting (Kerbl et al. 2023): at a pixel, the Gaussians
in order of depth have the alphas ``a = min(opacity * exp(-d^T C^-1 d / 2), largest)``; each weighs
``w = a * T`` with the transmittance ``T`` left by those before it.  Colour and depth are sums over
``w`` (depth is not divided by alpha), alpha is the sum of ``w`` itself; no background is added.
"""

from dataclasses import dataclass
from enum import Enum
from typing import Protocol

import numpy as np
import torch
from torch import Tensor

from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.projection import CameraBatch


@dataclass(frozen=True, eq=False)
class Parameters:
    """What is optimised, in the cameras' unit of length; fields as in :class:`Gaussians`.

    Attributes:
        means: (n, 3).
        quaternions: (n, 4) w x y z.
        log_scales: (n, 3).
        logit_opacities: (n,).
        colours: (n, 3) RGB.
    """

    means: Tensor
    quaternions: Tensor
    log_scales: Tensor
    logit_opacities: Tensor
    colours: Tensor

    @property
    def tensors(self) -> tuple[Tensor, ...]:
        """The five tensors in the order of the fields."""
        return self.means, self.quaternions, self.log_scales, self.logit_opacities, self.colours


@dataclass(frozen=True)
class RasterSettings:
    """Constants of the compositing; the defaults are those of 3DGS where it has them.

    Attributes:
        dilation: added to the 2D variances, px^2.
        smallest_alpha: what weighs less at a pixel is left out.
        largest_alpha: keeps the gradient of what lies behind finite.
        smallest_transmittance: once less is left, what follows is not drawn.
    """

    dilation: float = 0.3
    smallest_alpha: float = 1.0 / 255.0
    largest_alpha: float = 0.999
    smallest_transmittance: float = 1e-4


@dataclass(frozen=True, eq=False)
class Rendering:
    """Images of v views.

    Attributes:
        colours: (v, 3, h, w) on black.
        alphas: (v, h, w) 0 to 1.
        depths: (v, h, w) weighted sums of the Gaussians' depths.
    """

    colours: Tensor
    alphas: Tensor
    depths: Tensor


class Rasteriser(Protocol):
    """A back end."""

    def __call__(
        self,
        parameters: Parameters,
        cameras: CameraBatch,
        optics: RasterSettings,
        shifts: Tensor | None = None,
    ) -> Rendering:
        """Draw the Gaussians in every view, differentiably.

        Args:
            parameters: n Gaussians.
            cameras: v of them, on the device of the parameters.
            optics: constants.
            shifts: (v, n, 2) zeros in px, whose gradient tells how the loss pulls at the Gaussians'
                images: what density control goes by.
        """


class Backend(Enum):
    """Which code draws."""

    TILES = "tiles"
    REFERENCE = "reference"
    GSPLAT = "gsplat"

    @property
    def device(self) -> str:
        """The device of the tensors that it draws."""
        return "cuda" if self is Backend.GSPLAT else "cpu"


def rasteriser(backend: Backend) -> Rasteriser:
    """The function that draws with this back end."""
    if backend is Backend.TILES:
        from gaussiancad_core.splatting.tiles import draw_tiles

        return draw_tiles
    if backend is Backend.GSPLAT:
        from gaussiancad_core.splatting.gsplat_draw import draw_gsplat

        return draw_gsplat
    from gaussiancad_core.splatting.reference import draw_reference

    return draw_reference


def parameters_of(
    gaussians: Gaussians,
    unit: float = 1.0,
    dtype: torch.dtype = torch.float32,
    device: str = "cpu",
) -> Parameters:
    """Gaussians as leaves of a graph, in a unit of ``unit`` mm."""

    def leaf(values: np.ndarray) -> Tensor:
        return torch.tensor(values, dtype=dtype, device=device).requires_grad_()

    return Parameters(
        leaf(gaussians.means / np.float32(unit)),
        leaf(gaussians.quaternions),
        leaf(gaussians.log_scales - np.float32(np.log(unit))),
        leaf(gaussians.logit_opacities),
        leaf(gaussians.colours),
    )
