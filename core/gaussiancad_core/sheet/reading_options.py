"""What a user can say about a sheet."""

from collections.abc import Container
from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.length_units import MM_PER_INCH

Box = tuple[float, float, float, float]
"""x0, y0, x1, y1 in px of the sheet, y down."""

MEDIAN_KERNEL = 3
"""Side in px of the paper's median filter."""


class FileUnit(Enum):
    """What a length of a file, or a number on it, may be in."""

    MILLIMETRE = "mm"
    CENTIMETRE = "cm"
    METRE = "m"
    INCH = "in"
    FOOT = "ft"

    @property
    def millimetres(self) -> float:
        """Length of one."""
        return _MILLIMETRES[self.value]


_MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": MM_PER_INCH, "ft": 12.0 * MM_PER_INCH}


@dataclass(frozen=True)
class ReadingOptions:
    """What a user can say about a sheet.

    Attributes:
        projection: None to infer it.
        views: role -> box around the view in sheet px.
        lengths: (axis, mm), the part's extents along axes, each axis once; the first along one that
            a view shows tells the scale, the one along that which no view shows how thick the part
            is.
        mm_per_pixel: scale of the sheet, or None.
        unit: of a file that does not say its own, and of numbers that do not name theirs; None to
            tell it by these.
        colour: RGB of the part.
        open_holes: open the through holes that the hidden lines prove; the paper's masks are only
            filled contours.
        median_kernel: px, 0 for none.
    """

    projection: Projection | None = None
    views: tuple[tuple[Role, Box], ...] = ()
    lengths: tuple[tuple[Axis, float], ...] = ()
    mm_per_pixel: float | None = None
    unit: FileUnit | None = None
    colour: tuple[int, int, int] = (120, 160, 210)
    open_holes: bool = True
    median_kernel: int = MEDIAN_KERNEL

    def length_along(self, axis: Axis) -> float | None:
        """mm that the part is long along an axis, if it was said."""
        return next((length for this_axis, length in self.lengths if this_axis is axis), None)

    def scaling_length(self, shown: Container[Axis]) -> tuple[Axis, float] | None:
        """The length that tells the scale of views, if one does.

        Args:
            shown: axes that the views show.
        """
        return next((length for length in self.lengths if length[0] in shown), None)
