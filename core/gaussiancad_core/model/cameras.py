"""Fixed cameras of the views: orthographic, or the pinhole ones of the GaussianCAD paper.

Camera axes are COLMAP's: x right, y down, z along the view.  The paper prints Euler angles and
positions that do not agree with each other (see ``docs/method.md``); what is meant, and what stands
here, is one camera a view at distance 5 from the part's centre, on the side from which the role
looks, its axis through the centre.
"""

from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Role

PAPER_DISTANCE = 5.0
"""Distance of the paper's cameras from the origin, in units of its scene."""

PAPER_BOX = 5.0
"""Edge of the box that a part fills at most, in units."""

PAPER_INTRINSICS = (2480.0, 2080.0, 960.0, 540.0)
"""fx, fy, cx, cy in px at 1920 x 1080, as printed."""

PAPER_RESOLUTION = (1920, 1080)


class CameraModel(Enum):
    """How a camera projects."""

    ORTHOGRAPHIC = "orthographic"
    PINHOLE = "pinhole"


@dataclass(frozen=True)
class Camera:
    """A camera with a fixed pose.

    Attributes:
        role: the view that it takes.
        model: orthographic (``u = fx x + cx``) or pinhole (``u = fx x / z + cx``).
        rotation: (3, 3) world to camera; rows are right, down and look.
        translation: (3,) mm, so that ``camera = rotation @ world + translation``.
        width, height: px.
        fx, fy: px per mm (orthographic) or px (pinhole).
        cx, cy: px; pixel centres are at .5.
        reference_depth: mm from the camera to the part's centre.
    """

    role: Role
    model: CameraModel
    rotation: npt.NDArray[np.float64]
    translation: npt.NDArray[np.float64]
    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float
    reference_depth: float

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """(3,) the camera's centre in mm of the model."""
        return -self.rotation.T @ self.translation

    def to_camera(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 3) model mm -> (n, 3) camera mm (right, down, depth)."""
        return points @ self.rotation.T + self.translation

    def project(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 3) model mm -> (n, 2) px."""
        local = self.to_camera(points)
        plane = local[:, :2]
        if self.model is CameraModel.PINHOLE:
            plane = plane / local[:, 2:3]
        return plane * np.array([self.fx, self.fy]) + np.array([self.cx, self.cy])

    def plane_coordinates(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 3) model mm -> (n, 2) mm (right, up) on the view's plane through the part's centre.

        For an orthographic camera these are the points' own (right, up); a pinhole camera moves
        them along its rays onto the plane that its principal axis meets at ``reference_depth``.
        """
        local = self.to_camera(points)
        plane = local[:, :2].copy()
        if self.model is CameraModel.PINHOLE:
            plane *= self.reference_depth / local[:, 2:3]
        position = self.position
        offset = np.array([self.rotation[0] @ position, self.rotation[1] @ position])
        return (plane + offset) * np.array([1.0, -1.0])

    def on_view_plane(self, pixels: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) px -> (n, 2) mm (right, up) on the view's plane through the part's centre."""
        local = (pixels - np.array([self.cx, self.cy])) / np.array([self.fx, self.fy])
        if self.model is CameraModel.PINHOLE:
            local = local * self.reference_depth
        depths = np.full(len(pixels), self.reference_depth)
        points = np.column_stack([local, depths]) - self.translation
        return self.plane_coordinates(points @ self.rotation)

    def resized(self, factor: float) -> "Camera":
        """The same camera with its image scaled by ``factor``."""
        return replace(
            self,
            width=round(self.width * factor),
            height=round(self.height * factor),
            fx=self.fx * factor,
            fy=self.fy * factor,
            cx=self.cx * factor,
            cy=self.cy * factor,
        )


def orthographic_camera(
    role: Role, size: tuple[float, float, float], pixels: int, margin: float = 0.05
) -> Camera:
    """A square orthographic camera that shows the whole part with a margin.

    All roles get the same scale, so that shared axes have equal pixels in all views.

    Args:
        role: the view.
        size: (3,) extent of the part in mm; its box starts at the origin.
        pixels: width and height of the image.
        margin: blank border on each side, as a share of the longest edge.
    """
    longest = max(size)
    scale = pixels / (longest * (1.0 + 2.0 * margin))
    rotation = role.frame.world_to_camera()
    # The camera stands one longest edge outside the box, so that all depths are positive.
    centre = np.array(size) / 2.0
    position = centre - rotation[2] * 2.0 * longest
    return Camera(
        role,
        CameraModel.ORTHOGRAPHIC,
        rotation,
        -rotation @ position,
        pixels,
        pixels,
        scale,
        scale,
        pixels / 2.0,
        pixels / 2.0,
        2.0 * longest,
    )


def paper_unit(size: tuple[float, float, float], fill: float = 0.95) -> float:
    """Millimetres per unit of the paper's scene, the smallest that keeps the part in the images.

    The printed K shows only 3.9 x 2.6 units at distance 5, so that a part cannot fill the paper's
    5-unit box: it is made as large as its nearest corners allow in all views, and 5 units at most.

    Args:
        size: (3,) extent of the part in mm.
        fill: share of the half image that the nearest corners may reach.
    """
    fx, fy, cx, cy = PAPER_INTRINSICS
    largest = PAPER_BOX / max(size)
    for role in (Role.FRONT, Role.TOP, Role.RIGHT):
        frame = role.frame
        depth = size[frame.look_axis[0].value] / 2.0
        for axis, focal, half in ((frame.right_axis, fx, cx), (frame.up_axis, fy, cy)):
            extent = size[axis[0].value] / 2.0
            reach = fill * half
            largest = min(largest, reach * PAPER_DISTANCE / (focal * extent + reach * depth))
    return 1.0 / largest


def paper_camera(role: Role, size: tuple[float, float, float], factor: float = 1.0) -> Camera:
    """The paper's pinhole camera: its K as printed, at distance 5 from the part's centre.

    Args:
        role: the view.
        size: (3,) extent of the part in mm; its box starts at the origin.
        factor: scales the 1920 x 1080 image (and K with it).
    """
    rotation = role.frame.world_to_camera()
    centre = np.array(size) / 2.0
    distance = PAPER_DISTANCE * paper_unit(size)
    position = centre - rotation[2] * distance
    fx, fy, cx, cy = PAPER_INTRINSICS
    width, height = PAPER_RESOLUTION
    camera = Camera(
        role,
        CameraModel.PINHOLE,
        rotation,
        -rotation @ position,
        width,
        height,
        fx,
        fy,
        cx,
        cy,
        distance,
    )
    return camera.resized(factor)
