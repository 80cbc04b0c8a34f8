"""Where trained Gaussians and the drawing disagree, view by view and region by region."""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
import torch

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.losses import Targets
from gaussiancad_core.splatting.projection import batch_of
from gaussiancad_core.splatting.rasterizer import parameters_of, rasteriser
from gaussiancad_core.splatting.settings import TrainingSettings

_DIFFERENT = 0.5
"""Alpha by which a pixel must differ from the mask to count."""

_SPOT = np.ones((3, 3), np.uint8)
"""Narrower strips belong to no region: they are the outline between two pixels."""

_MOST_REGIONS = 20


@dataclass(frozen=True)
class ResidualRegion:
    """A patch of a view that is covered on one side only.

    Attributes:
        box: x0, y0, x1, y1 in px of the camera's image, y down.
        pixels: that differ.
        excess: whether the Gaussians cover it and the drawing does not.
    """

    box: tuple[float, float, float, float]
    pixels: int
    excess: bool


@dataclass(frozen=True)
class ViewResidual:
    """How far one view is from the drawing.

    Attributes:
        role: of the view.
        difference: pixels that are covered on one side only, as a share of the mask.
        regions: the largest first, 20 at most.
    """

    role: Role
    difference: float
    regions: tuple[ResidualRegion, ...]


def residuals_of(
    gaussians: Gaussians,
    cameras: tuple[Camera, ...],
    targets: Targets,
    settings: TrainingSettings,
) -> tuple[ViewResidual, ...]:
    """Draw Gaussians once more and compare their alphas with the masks.

    Args:
        gaussians: mm.
        cameras: v of them.
        targets: of the same views.
        settings: of the training.
    """
    device = settings.backend.device
    with torch.no_grad():
        alphas = rasteriser(settings.backend)(
            parameters_of(gaussians, device=device), batch_of(cameras).on(device), settings.optics
        ).alphas
    masks = targets.masks.cpu().numpy()
    return tuple(
        ViewResidual(
            camera.role,
            float((np.abs(alpha - mask) > _DIFFERENT).sum() / max(1.0, float(mask.sum()))),
            _regions(alpha - mask),
        )
        for camera, alpha, mask in zip(cameras, alphas.cpu().numpy(), masks, strict=True)
    )


def _regions(difference: npt.NDArray[np.float32]) -> tuple[ResidualRegion, ...]:
    found = []
    for sign, excess in ((1.0, True), (-1.0, False)):
        patches = (sign * difference > _DIFFERENT).astype(np.uint8)
        opened = cv2.morphologyEx(patches, cv2.MORPH_OPEN, _SPOT)
        _, _, facts, _ = cv2.connectedComponentsWithStats(opened)
        for left, top, width, height, pixels in facts[1:].tolist():
            box = (float(left), float(top), float(left + width), float(top + height))
            found.append(ResidualRegion(box, pixels, excess))
    return tuple(sorted(found, key=lambda region: -region.pixels)[:_MOST_REGIONS])
