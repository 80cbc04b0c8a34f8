"""Cameras around a part, and the gradients of what they see."""

import torch

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera, CameraModel, orthographic_camera, paper_camera
from gaussiancad_core.splatting.projection import CameraBatch, batch_of
from gaussiancad_core.splatting.rasterizer import Rendering

SIZE = (50.0, 30.0, 40.0)
THREE = (Role.FRONT, Role.TOP, Role.RIGHT)


def cameras(
    model: CameraModel, pixels: int, dtype: torch.dtype, roles: tuple[Role, ...] = THREE
) -> CameraBatch:
    """A camera for each role, in units of 10 mm."""

    def camera(role: Role) -> Camera:
        if model is CameraModel.ORTHOGRAPHIC:
            return orthographic_camera(role, SIZE, pixels)
        return paper_camera(role, SIZE, pixels / 1920)

    return batch_of(tuple(camera(role) for role in roles), unit=10.0, dtype=dtype)


def gradients(rendering: Rendering, of: tuple[torch.Tensor, ...]) -> tuple[torch.Tensor, ...]:
    """Gradients of a fixed random combination of all images."""
    generator = torch.Generator().manual_seed(1)
    total = torch.zeros((), dtype=rendering.colours.dtype, device=rendering.colours.device)
    for image in (rendering.colours, rendering.alphas, rendering.depths):
        weights = torch.randn(image.shape, generator=generator, dtype=torch.float64)
        total = total + (image * weights.to(image)).sum()
    for tensor in of:
        tensor.grad = None
    total.backward()
    return tuple(tensor.grad for tensor in of)
