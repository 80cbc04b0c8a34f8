"""What the report says of where trained Gaussians and the drawing disagree."""

from typing import Any

import numpy as np

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.splatting.residuals import ViewResidual


def residual_entries(
    residuals: tuple[ViewResidual, ...],
    cameras: tuple[Camera, ...],
    registered: RegisteredSheet,
    turn: Turn,
) -> dict[str, Any]:
    """JSON values by role: the difference of a view, and its regions in px of the stored sheet.

    Args:
        residuals: of views.
        cameras: in whose images the regions are, in the same order.
        registered: how the views lie on the upright sheet.
        turn: how that was turned.
    """
    return {
        residual.role.value: {
            "difference": round(residual.difference, 5),
            "regions": [
                {
                    "box": [round(v, 1) for v in _box(region.box, camera, registered, turn)],
                    "excess": region.excess,
                }
                for region in residual.regions
            ],
        }
        for residual, camera in zip(residuals, cameras, strict=True)
    }


def _box(box: Box, camera: Camera, registered: RegisteredSheet, turn: Turn) -> Box:
    role: Role = camera.role
    corners = camera.on_view_plane(np.array(box).reshape(2, 2))
    upright = registered.placements[role].to_sheet(corners)
    low, high = upright.min(axis=0), upright.max(axis=0)
    return turn.box_to_stored((float(low[0]), float(low[1]), float(high[0]), float(high[1])))
