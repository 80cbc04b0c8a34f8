"""What a user can say about a sheet."""

from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.axes import Axis, Projection, Role

Box = tuple[float, float, float, float]
"""x0, y0, x1, y1 in px of the sheet, y down."""

MEDIAN_KERNEL = 3
"""Side in px of the paper's median filter."""


class Finder(Enum):
    """What finds lines and circles: ridges of the ink, or the GaussianCAD paper's transforms."""

    RIDGES = "ridges"
    HOUGH = "hough"


@dataclass(frozen=True)
class ReadingOptions:
    """What a user can say about a sheet.

    Attributes:
        projection: None to infer it.
        views: role -> box around the view in sheet px.
        length: (axis, mm), the part's extent along an axis, or None; along the one that the only
            view does not show it is the part's thickness, and tells no scale.
        mm_per_pixel: scale of the sheet, or None.
        colour: RGB of the part.
        open_holes: open the through holes that the hidden lines prove; the paper's masks are only
            filled contours.
        median_kernel: px, 0 for none.
        finder: of lines and circles.
    """

    projection: Projection | None = None
    views: tuple[tuple[Role, Box], ...] = ()
    length: tuple[Axis, float] | None = None
    mm_per_pixel: float | None = None
    colour: tuple[int, int, int] = (120, 160, 210)
    open_holes: bool = True
    median_kernel: int = MEDIAN_KERNEL
    finder: Finder = Finder.RIDGES
