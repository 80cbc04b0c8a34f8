"""Gaussians seen by a camera: 2D means, 2D covariances, depths.

A parallel projection is linear, so that the 2D covariance is exactly the upper 2 x 2 block of the
covariance in camera axes, times the scale.  A pinhole's is approximated to first order about the
mean (EWA splatting, Zwicker et al. 2001), as 3D Gaussian splatting does (Kerbl et al. 2023).

Plain torch: differentiable, all views at once, shared by both back ends.
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from gaussiancad_core.model.cameras import Camera, CameraModel

NEAREST_DEPTH = 1e-3
"""A pinhole sees nothing nearer than this share of its reference depth."""

FIELD_MARGIN = 1.3
"""Slopes in a pinhole's first-order term are held within this many half images, as in 3DGS."""


@dataclass(frozen=True, eq=False)
class CameraBatch:
    """Cameras of one model and image size, as tensors.

    Attributes:
        model: how all of them project.
        width, height: px.
        rotations: (v, 3, 3) world to camera.
        translations: (v, 3).
        focals: (v, 2) fx, fy: px per unit of length, or px.
        centres: (v, 2) cx, cy, px.
        nearest: smallest depth that is drawn; minus infinity for parallel projection.
    """

    model: CameraModel
    width: int
    height: int
    rotations: Tensor
    translations: Tensor
    focals: Tensor
    centres: Tensor
    nearest: float

    def on(self, device: str) -> "CameraBatch":
        """The same cameras with their tensors on a device."""
        return CameraBatch(
            self.model,
            self.width,
            self.height,
            self.rotations.to(device),
            self.translations.to(device),
            self.focals.to(device),
            self.centres.to(device),
            self.nearest,
        )


@dataclass(frozen=True, eq=False)
class Splats:
    """n Gaussians on the images of v views.

    Attributes:
        means: (v, n, 2) px, x right and y down, pixel centres at .5.
        covariances: (v, n, 3) xx, xy, yy in px^2, dilation included.
        depths: (v, n) along the view, in the cameras' unit of length.
    """

    means: Tensor
    covariances: Tensor
    depths: Tensor


def batch_of(
    cameras: tuple[Camera, ...], unit: float = 1.0, dtype: torch.dtype = torch.float32
) -> CameraBatch:
    """Cameras side by side, in a unit of length of one's own.

    Args:
        cameras: of one model and one image size.
        unit: mm that become 1.
        dtype: of the tensors.

    Raises:
        ValueError: the cameras differ in model or image size.
    """
    first = cameras[0]
    same = {(c.model, c.width, c.height) for c in cameras}
    if len(same) != 1:
        raise ValueError(f"cameras of one batch must have one model and one size, not {same}")
    pinhole = first.model is CameraModel.PINHOLE
    scale = 1.0 if pinhole else unit
    nearest = min(c.reference_depth for c in cameras) / unit * NEAREST_DEPTH

    def stack(rows: list[object]) -> Tensor:
        return torch.tensor(np.array(rows, dtype=np.float64), dtype=dtype)

    return CameraBatch(
        model=first.model,
        width=first.width,
        height=first.height,
        rotations=stack([c.rotation for c in cameras]),
        translations=stack([c.translation / unit for c in cameras]),
        focals=stack([(c.fx * scale, c.fy * scale) for c in cameras]),
        centres=stack([(c.cx, c.cy) for c in cameras]),
        nearest=nearest if pinhole else -float("inf"),
    )


def project(
    means: Tensor, quaternions: Tensor, log_scales: Tensor, cameras: CameraBatch, dilation: float
) -> Splats:
    """Gaussians on the images of the cameras.

    Args:
        means: (n, 3) in the cameras' unit of length.
        quaternions: (n, 4) w x y z, of any length but zero.
        log_scales: (n, 3).
        cameras: v of them.
        dilation: added to the variances, px^2: the footprint of a pixel.

    Returns:
        Means, covariances and depths in each view.
    """
    local = means @ cameras.rotations.transpose(1, 2) + cameras.translations[:, None, :]
    depths = local[..., 2]
    # (v, 2, 3): rows of the map from model to image, to be applied to the Gaussians' axes.
    linear = cameras.rotations[:, :2] * cameras.focals[:, :, None]
    axes = _axes(quaternions, log_scales)
    if cameras.model is CameraModel.ORTHOGRAPHIC:
        plane = local[..., :2]
        rows = torch.matmul(linear[:, None], axes[None])
    else:
        inverse = 1.0 / depths.clamp_min(cameras.nearest)
        plane = local[..., :2] * inverse[..., None]
        limit = half_field(cameras)[:, None]
        slope = torch.minimum(torch.maximum(plane, -limit), limit)
        look = cameras.rotations[:, None, 2:3] * (slope * cameras.focals[:, None])[..., None]
        rows = torch.matmul((linear[:, None] - look) * inverse[..., None, None], axes[None])
    covariances = torch.stack(
        [
            (rows[..., 0, :] * rows[..., 0, :]).sum(-1) + dilation,
            (rows[..., 0, :] * rows[..., 1, :]).sum(-1),
            (rows[..., 1, :] * rows[..., 1, :]).sum(-1) + dilation,
        ],
        dim=-1,
    )
    return Splats(plane * cameras.focals[:, None] + cameras.centres[:, None], covariances, depths)


def conics(covariances: Tensor) -> Tensor:
    """(..., 3) covariances xx, xy, yy -> (..., 3) their inverses, in the same order."""
    xx, xy, yy = covariances.unbind(-1)
    inverse = 1.0 / (xx * yy - xy * xy)
    return torch.stack([yy * inverse, -xy * inverse, xx * inverse], dim=-1)


def _axes(quaternions: Tensor, log_scales: Tensor) -> Tensor:
    """(n, 3, 3) columns: the Gaussians' axes, each as long as its standard deviation."""
    w, x, y, z = torch.nn.functional.normalize(quaternions, dim=1).unbind(1)
    rotation = torch.stack(
        [
            1 - 2 * (y * y + z * z),
            2 * (x * y - w * z),
            2 * (x * z + w * y),
            2 * (x * y + w * z),
            1 - 2 * (x * x + z * z),
            2 * (y * z - w * x),
            2 * (x * z - w * y),
            2 * (y * z + w * x),
            1 - 2 * (x * x + y * y),
        ],
        dim=1,
    ).view(-1, 3, 3)
    return rotation * log_scales.exp()[:, None, :]


def half_field(cameras: CameraBatch) -> Tensor:
    """(v, 2) largest slopes, to the right or left and down or up, in a pinhole's first-order term.

    They reach a little beyond the farther border of the image: a Gaussian far outside of it would
    otherwise be stretched without bound.
    """
    size = torch.tensor([cameras.width, cameras.height], dtype=cameras.centres.dtype)
    farther = torch.maximum(cameras.centres, size - cameras.centres)
    return FIELD_MARGIN * farther / cameras.focals
