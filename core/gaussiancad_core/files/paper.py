"""The paper of a sheet as it would be without ink: the light of its surroundings.

No paper is white: scans are grey or yellowed, photographs have shadows.  What is called dark or
coloured is so against the paper around it.
"""

import cv2
import numpy as np
import numpy.typing as npt

PAPER_SCALE = 4
"""Factor by which a sheet is made smaller to find its paper."""

STROKE_REACH, PICTURE_REACH = 11, 21
"""px of the smaller sheet that are wider than any stroke: of a sheet at the width of lines at which
it is read, and of a picture as it was stored."""


def smaller(picture: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """A picture at the size at which its paper is found.

    Args:
        picture: (h, w) or (h, w, 3) uint8.
    """
    height, width = picture.shape[:2]
    size = (max(1, width // PAPER_SCALE), max(1, height // PAPER_SCALE))
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)


def even_paper(small: npt.NDArray[np.uint8], reach: int) -> npt.NDArray[np.float32]:
    """The light of the paper, of a small picture and as small, for each channel by itself.

    Args:
        small: (h, w) or (h, w, 3) uint8, dark ink on light paper.
        reach: side in px over which ink is closed.
    """
    kernel = np.ones((reach, reach), np.uint8)
    # Closing dark strokes would take the brightest noise for paper: smooth before and after.
    closed = cv2.morphologyEx(cv2.GaussianBlur(small, (0, 0), 1.0), cv2.MORPH_CLOSE, kernel)
    smooth = cv2.GaussianBlur(closed.astype(np.float32), (0, 0), reach / 2)
    return np.asarray(smooth, dtype=np.float32)


def enlarged(paper: npt.NDArray[np.float32], size: tuple[int, int]) -> npt.NDArray[np.float32]:
    """The paper in the size of the picture.

    Args:
        paper: (h, w) or (h, w, 3), as small as it was found.
        size: width and height in px.
    """
    return np.asarray(cv2.resize(paper, size, interpolation=cv2.INTER_LINEAR), dtype=np.float32)
