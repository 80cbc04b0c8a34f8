"""The cameras folder for nerfstudio: ``transforms.json`` beside the COLMAP files.

Its format is that of instant-ngp and nerfstudio: camera-to-world matrices whose axes are x right, y
up, z towards the viewer (OpenGL's); intrinsics in px; lengths in the model's millimetres.  Masks
are left out, since nerfstudio takes them for pixels of which nothing is known, and here the
background is known to be empty.
"""

import json
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from gaussiancad_core.hull.colmap import MAX_POINTS
from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.storage.single_file import write_whole

POINTS_FILE = "points.ply"

_OPENGL = np.diag([1.0, -1.0, -1.0, 1.0])
"""From COLMAP's camera axes (y down, z along the view)."""


def write_transforms(
    folder: Path,
    cameras: tuple[Camera, ...],
    points: tuple[npt.NDArray[np.float64], npt.NDArray[np.uint8]],
) -> None:
    """Write ``transforms.json`` and the points from which a training starts.

    Args:
        folder: with the images that :func:`gaussiancad_core.hull.colmap.write_cameras` wrote.
        cameras: pinhole.
        points: (n, 3) mm and (n, 3) RGB of points on the part.

    Raises:
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    import trimesh

    content = {
        "camera_model": "PINHOLE",
        "orientation_override": "none",
        "ply_file_path": POINTS_FILE,
        "frames": [_frame(camera) for camera in cameras],
    }
    places, colours = (values[:MAX_POINTS] for values in points)
    cloud = trimesh.PointCloud(places, colours)
    write_whole(folder / POINTS_FILE, cloud.export(file_type="ply"))
    text = json.dumps(content, indent=2)
    write_whole(folder / "transforms.json", f"{text}\n".encode())


def _frame(camera: Camera) -> dict[str, Any]:
    world = np.eye(4)
    world[:3, :3] = camera.rotation.T
    world[:3, 3] = camera.position
    return {
        "file_path": f"images/{camera.role.value}.png",
        "w": camera.width,
        "h": camera.height,
        "fl_x": camera.fx,
        "fl_y": camera.fy,
        "cx": camera.cx,
        "cy": camera.cy,
        "transform_matrix": (world @ _OPENGL).tolist(),
    }
