"""Sheets on a table, photographed at a slant by a camera of chance."""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

Picture = npt.NDArray[np.uint8]


@dataclass(frozen=True)
class Camera:
    """How a sheet is photographed.

    Attributes:
        tilt: degrees from straight above.
        focal: focal length, in the longer side of the picture.
        bend: radial distortion, share at the picture's corners.
        surroundings: whether there is a dark table around the paper.
    """

    tilt: float
    focal: float
    bend: float
    surroundings: bool


def photograph(sheet: Picture, camera: Camera, random: np.random.Generator) -> Picture:
    """(h, w, 3) uint8 BGR a picture of a sheet on a table.

    Args:
        sheet: (h, w) uint8.
        camera: that takes it.
        random: of light, noise, and the way in which the camera is tilted and turned.
    """
    height, width = sheet.shape
    size = (round(1.5 * max(sheet.shape)), round(1.125 * max(sheet.shape)))
    focal = camera.focal * size[0]
    way, turn = random.uniform(0.0, 2.0 * np.pi), np.radians(random.uniform(-5.0, 5.0))
    tilt = np.radians(camera.tilt) * np.array([np.cos(way), np.sin(way), 0.0])
    rotation = cv2.Rodrigues(tilt)[0] @ cv2.Rodrigues(np.array([0.0, 0.0, turn]))[0]
    middle = np.array([width, height]) / 2
    rim = np.array([[0, 0], [width, 0], [width, height], [0, height]]) - middle
    seen, distance = rim, 0.3 * focal
    while np.abs(seen / (np.array(size) / 2)).max() > 0.93 or distance == 0.3 * focal:
        distance *= 1.02
        places = np.column_stack([rim, np.zeros(4)]) @ rotation.T + [0.0, 0.0, distance]
        if (places[:, 2] > 0.1 * focal).all():
            seen = focal * places[:, :2] / places[:, 2:]
    homography = cv2.getPerspectiveTransform(
        (rim + middle).astype(np.float32),
        (seen + np.array(size) / 2).astype(np.float32),
    )
    paper = cv2.warpPerspective(np.full_like(sheet, 255), homography, size, borderValue=0)
    picture = cv2.warpPerspective(sheet, homography, size, flags=cv2.INTER_AREA, borderValue=255)
    share = (paper / 255.0)[..., None]
    table = np.full((size[1], size[0], 3), 255.0)
    if camera.surroundings:
        grain = random.normal(0.0, 1.0, (size[1] // 40 + 2, size[0] // 8 + 2))
        wood = cv2.resize(grain, size, interpolation=cv2.INTER_CUBIC)[..., None]
        table = random.uniform(30.0, 130.0, 3) * (1.0 + 0.12 * wood)
    coloured = picture[..., None] * share + table * (1.0 - share)
    coloured = _bent(coloured, camera.bend)
    y, x = np.mgrid[0 : size[1], 0 : size[0]] / size[0] - 0.5
    side = random.uniform(0.0, 2.0 * np.pi)
    light = 0.8 + random.uniform(0.0, 0.35) * (x * np.cos(side) + y * np.sin(side))
    lit = coloured * light[..., None] * random.uniform(0.9, 1.0, 3)
    blurred = cv2.GaussianBlur(lit, (0, 0), random.uniform(0.5, 1.1))
    noisy = blurred + random.normal(0.0, random.uniform(1.0, 5.0), blurred.shape)
    return np.clip(noisy, 0.0, 255.0).astype(np.uint8)


def _bent(picture: npt.NDArray[np.float64], bend: float) -> npt.NDArray[np.float64]:
    """A picture as a lens with radial distortion gives it."""
    height, width = picture.shape[:2]
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    dx, dy = x - width / 2, y - height / 2
    factor = 1.0 + bend * (dx**2 + dy**2) / ((width / 2) ** 2 + (height / 2) ** 2)
    places = (width / 2 + dx * factor, height / 2 + dy * factor)
    return cv2.remap(
        picture,
        *(place.astype(np.float32) for place in places),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
