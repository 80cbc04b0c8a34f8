"""Lengths and radii that a sheet's dimensions state in numbers.

On a drawing the number counts, not the line (ISO 129-1): what was drawn, printed and scanned is a
few hundredths of a millimetre off.
"""

from dataclasses import dataclass, replace

from gaussiancad_core.model.axes import Axis


@dataclass(frozen=True)
class LengthDimension:
    """A distance along an axis.

    Attributes:
        axis: of the model.
        low, high: what it lies between, as drawn, in the unit of whoever holds it.
        value: that the number says, in the same unit.
    """

    axis: Axis
    low: float
    high: float
    value: float

    def scaled(self, factor: float) -> "LengthDimension":
        """The same in another unit."""
        return replace(
            self, low=factor * self.low, high=factor * self.high, value=factor * self.value
        )


@dataclass(frozen=True)
class RadiusDimension:
    """The radius of a circle or an arc.

    Attributes:
        normal: of the plane it lies in.
        centre: coordinates in this plane, as drawn.
        radius: as drawn.
        value: that the number says.
    """

    normal: Axis
    centre: tuple[float, float]
    radius: float
    value: float

    def scaled(self, factor: float) -> "RadiusDimension":
        """The same in another unit."""
        x, y = self.centre
        return replace(
            self,
            centre=(factor * x, factor * y),
            radius=factor * self.radius,
            value=factor * self.value,
        )


Told = LengthDimension | RadiusDimension


@dataclass(frozen=True)
class DimensionConstraints:
    """What numbers say.

    Attributes:
        lengths: of all dimensions.
        reach: by which what is drawn may differ from its number.
        digit: the last one that they are rounded to.
    """

    lengths: tuple[Told, ...] = ()
    reach: float = 0.0
    digit: float = 0.0

    def scaled(self, factor: float) -> "DimensionConstraints":
        """The same in another unit."""
        lengths = tuple(length.scaled(factor) for length in self.lengths)
        return DimensionConstraints(lengths, factor * self.reach, factor * self.digit)
