"""Planes that sketches lie on: where they are, and which way their coordinates run."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Vector = tuple[float, float, float]
Points = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Frame:
    """A plane through the origin, with coordinates in it.

    Attributes:
        name: ``XY``, ``XZ`` or ``YZ`` of the main planes; else made of its normal.
        right, up: unit vectors of its two coordinates.
        normal: unit vector, right x up; heights are counted along it.
    """

    name: str
    right: Vector
    up: Vector
    normal: Vector

    def project(self, points: Points) -> Points:
        """(n, 3) points in mm as (n, 3): right, up, height."""
        return points @ np.array([self.right, self.up, self.normal]).T

    def lift(self, points: Points, height: float) -> Points:
        """(n, 2) points of the plane at a height, as (n, 3) points of space."""
        right, up, normal = (np.array(axis) for axis in (self.right, self.up, self.normal))
        return points[:, :1] * right + points[:, 1:2] * up + height * normal


MAIN_FRAMES = (
    Frame("XY", (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    Frame("XZ", (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0)),
    Frame("YZ", (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)),
)
"""The origin planes of a body, as FreeCAD has them."""


def frame_across(normal: Vector) -> Frame:
    """A frame with a normal (either way along it): a main one where there is one."""
    along = np.array(normal) / np.linalg.norm(normal)
    for frame in MAIN_FRAMES:
        if abs(float(along @ np.array(frame.normal))) > 1.0 - 1e-9:
            return frame
    # The coordinate that runs most across the normal stays level.
    level = np.eye(3)[int(np.argmin(np.abs(along)))]
    right = np.cross(level, along)
    right /= np.linalg.norm(right)
    up = np.cross(along, right)
    name = "({:.4f}, {:.4f}, {:.4f})".format(*along)
    (rx, ry, rz), (ux, uy, uz), (ax, ay, az) = (
        (float(part) for part in vector) for vector in (right, up, along)
    )
    return Frame(name, (rx, ry, rz), (ux, uy, uz), (ax, ay, az))
