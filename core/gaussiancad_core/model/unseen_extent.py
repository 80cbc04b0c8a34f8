"""How far a part reaches along the axis that its only view does not show."""

from dataclasses import dataclass

from gaussiancad_core.model.axes import Axis


@dataclass(frozen=True)
class Unseen:
    """What is known of an axis along which the only view of a sheet looks.

    Attributes:
        axis: that no view shows.
        thickness: mm of the part along it, all over; None of a turned part.
        about: the axis in the view about which the part is turned; None of a plate.
    """

    axis: Axis
    thickness: float | None = None
    about: Axis | None = None

    def extent(self, shown: dict[Axis, float], mm_per_pixel: float) -> float:
        """px of the part along the axis.

        Args:
            shown: px along the two others.
            mm_per_pixel: of the sheet.
        """
        if self.thickness is not None:
            return self.thickness / mm_per_pixel
        return next(value for axis, value in shown.items() if axis is not self.about)
