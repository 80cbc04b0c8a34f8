"""The back end for NVIDIA GPUs: gsplat's CUDA kernels (Ye et al. 2024), an optional package.

gsplat composites as 3D Gaussian splatting does, so that its limits are fixed; it ends a pixel one
Gaussian earlier than the other back ends, and cuts off at 3.33 standard deviations: images agree to
about a thousandth.  Its sums come in another order each time: runs do not repeat bit for bit.
"""

import torch
from torch import Tensor

from gaussiancad_core.model.cameras import CameraModel
from gaussiancad_core.splatting.projection import CameraBatch
from gaussiancad_core.splatting.rasterizer import Parameters, RasterSettings, Rendering

FIXED = RasterSettings()
"""The limits that are compiled into gsplat; only the dilation can be chosen."""

_MODELS = {CameraModel.ORTHOGRAPHIC: "ortho", CameraModel.PINHOLE: "pinhole"}


def draw_gsplat(
    parameters: Parameters,
    cameras: CameraBatch,
    optics: RasterSettings,
    shifts: Tensor | None = None,
) -> Rendering:
    """Draw the Gaussians in every view; see :mod:`.rasterizer` for the compositing.

    Args:
        parameters: on a CUDA device, float32.
        cameras: on the same device; an orthographic one shows nothing at negative depths.
        optics: with gsplat's own limits of alpha and transmittance.
        shifts: receives its gradient, but is not added.

    Raises:
        ValueError: other limits than gsplat's are asked for.
    """
    limits = (optics.smallest_alpha, optics.largest_alpha, optics.smallest_transmittance)
    if limits != (FIXED.smallest_alpha, FIXED.largest_alpha, FIXED.smallest_transmittance):
        raise ValueError(f"gsplat's limits of alpha and transmittance are fixed, not {limits}")
    import gsplat

    images, alphas, found = gsplat.rasterization(
        means=parameters.means,
        quats=parameters.quaternions,
        scales=parameters.log_scales.exp(),
        opacities=torch.sigmoid(parameters.logit_opacities),
        colors=parameters.colours,
        viewmats=_poses(cameras),
        Ks=_intrinsics(cameras),
        width=cameras.width,
        height=cameras.height,
        near_plane=max(cameras.nearest, 0.0),
        eps2d=optics.dilation,
        packed=False,
        render_mode="RGB+D",
        camera_model=_MODELS[cameras.model],
    )
    if shifts is not None and shifts.requires_grad:
        found["means2d"].register_hook(lambda gradient: _add_gradient(shifts, gradient))
    planes = images.permute(0, 3, 1, 2)
    return Rendering(planes[:, :3], alphas[..., 0], planes[:, 3])


def _add_gradient(shifts: Tensor, gradient: Tensor) -> None:
    shifts.grad = gradient.clone() if shifts.grad is None else shifts.grad + gradient


def _poses(cameras: CameraBatch) -> Tensor:
    """(v, 4, 4) world to camera."""
    poses = torch.eye(4, dtype=cameras.rotations.dtype, device=cameras.rotations.device)
    poses = poses.repeat(len(cameras.rotations), 1, 1)
    poses[:, :3, :3] = cameras.rotations
    poses[:, :3, 3] = cameras.translations
    return poses


def _intrinsics(cameras: CameraBatch) -> Tensor:
    """(v, 3, 3); for a parallel projection the focal lengths are px per unit."""
    matrices = torch.zeros_like(cameras.rotations)
    matrices[:, [0, 1], [0, 1]] = cameras.focals
    matrices[:, [0, 1], [2, 2]] = cameras.centres
    matrices[:, 2, 2] = 1.0
    return matrices
