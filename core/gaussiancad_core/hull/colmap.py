"""The cameras folder: COLMAP text files and the images other 3DGS trainers start from.

COLMAP knows no orthographic camera.  One is written as a pinhole so far away that parallax stays
under half a pixel over the part's depth; a pinhole camera is written as it is.
"""

from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.cameras import Camera, CameraModel

_MAX_PARALLAX = 0.4
"""px by which a point at the near or far side of the part is off."""

MAX_POINTS = 50_000
"""Points that are written to points3D.txt at most."""


def as_pinhole(camera: Camera, size: tuple[float, float, float]) -> Camera:
    """A pinhole camera that draws the part as an orthographic one does, to under half a pixel.

    Args:
        camera: orthographic, or pinhole, which is returned as it is.
        size: (3,) extent of the part in mm.
    """
    if camera.model is CameraModel.PINHOLE:
        return camera
    corners = np.array(np.meshgrid(*[(0.0, s) for s in size])).reshape(3, -1).T
    pixels = camera.project(corners)
    radius = float(np.hypot(pixels[:, 0] - camera.cx, pixels[:, 1] - camera.cy).max())
    depths = camera.to_camera(corners)[:, 2] - camera.reference_depth
    # A point at depth offset d lands at r D / (D + d) instead of r.
    distance = float(np.abs(depths).max()) * (radius / _MAX_PARALLAX + 1.0)
    translation = camera.translation.copy()
    translation[2] += distance - camera.reference_depth
    return Camera(
        camera.role,
        CameraModel.PINHOLE,
        camera.rotation,
        translation,
        camera.width,
        camera.height,
        camera.fx * distance,
        camera.fy * distance,
        camera.cx,
        camera.cy,
        distance,
    )


def write_cameras(
    folder: Path,
    cameras: tuple[Camera, ...],
    colours: npt.NDArray[np.float32],
    masks: npt.NDArray[np.float32],
    points: tuple[npt.NDArray[np.float64], npt.NDArray[np.uint8]],
) -> None:
    """Write cameras.txt, images.txt, points3D.txt, ``images/ROLE.png`` and ``masks/ROLE.png``.

    Args:
        folder: made if missing.
        cameras: pinhole, v of them.
        colours: (v, 3, h, w) RGB 0..1.
        masks: (v, h, w) 0..1.
        points: (n, 3) mm and (n, 3) RGB of points on the part.
    """
    (folder / "images").mkdir(parents=True, exist_ok=True)
    (folder / "masks").mkdir(exist_ok=True)
    camera_lines = ["# CAMERA_ID MODEL WIDTH HEIGHT fx fy cx cy"]
    image_lines = ["# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then 2D points (none)"]
    for index, camera in enumerate(cameras, start=1):
        name = f"{camera.role.value}.png"
        intrinsics = " ".join(f"{v:.17g}" for v in (camera.fx, camera.fy, camera.cx, camera.cy))
        camera_lines.append(f"{index} PINHOLE {camera.width} {camera.height} {intrinsics}")
        pose = [*quaternion(camera.rotation), *camera.translation]
        image_lines += [f"{index} {' '.join(f'{v:.17g}' for v in pose)} {index} {name}", ""]
        rgb = np.rint(np.moveaxis(colours[index - 1], 0, 2) * 255).astype(np.uint8)
        _write_png(folder / "images" / name, rgb[..., ::-1])
        mask = np.rint(masks[index - 1] * 255).astype(np.uint8)
        _write_png(folder / "masks" / name, mask)
    (folder / "cameras.txt").write_text("\n".join(camera_lines) + "\n", encoding="utf-8")
    (folder / "images.txt").write_text("\n".join(image_lines) + "\n", encoding="utf-8")
    (folder / "points3D.txt").write_text(_points_text(*points), encoding="utf-8")


def quaternion(rotation: npt.NDArray[np.float64]) -> tuple[float, float, float, float]:
    """(w, x, y, z) with w >= 0 of a (3, 3) rotation matrix."""
    from scipy.spatial.transform import Rotation

    x, y, z, w = Rotation.from_matrix(rotation).as_quat()
    sign = -1.0 if w < 0 else 1.0
    return float(sign * w), float(sign * x), float(sign * y), float(sign * z)


def _points_text(positions: npt.NDArray[np.float64], colours: npt.NDArray[np.uint8]) -> str:
    lines = ["# POINT3D_ID X Y Z R G B ERROR TRACK (none)"]
    for index, ((x, y, z), (r, g, b)) in enumerate(
        zip(positions[:MAX_POINTS], colours[:MAX_POINTS], strict=True), start=1
    ):
        lines.append(f"{index} {x:.6f} {y:.6f} {z:.6f} {r} {g} {b} 0")
    return "\n".join(lines) + "\n"


def _write_png(path: Path, image: npt.NDArray[np.uint8]) -> None:
    """Write through memory: OpenCV opens no path with foreign letters on Windows."""
    path.write_bytes(cv2.imencode(".png", image)[1].tobytes())
