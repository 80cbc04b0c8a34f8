"""Maps of a plane that keep shapes: moves, turns, changes of scale and of handedness."""

from dataclasses import dataclass
from functools import cached_property
from math import cos, sin

from gaussiancad_core.geometry.points import Point


@dataclass(frozen=True)
class Similarity:
    """A map ``p -> offset + scale R F (p - origin)``, ``R`` a turn by ``angle``.

    Attributes:
        scale: positive.
        angle: radians from the first axis towards the second.
        flip: whether ``F`` turns the second axis over, as between planes whose second axis points
            up and down.
        origin: (2,) the point that ``offset`` is the image of.
        offset: (2,).
    """

    scale: float = 1.0
    angle: float = 0.0
    flip: bool = False
    origin: Point = (0.0, 0.0)
    offset: Point = (0.0, 0.0)

    @cached_property
    def _axes(self) -> tuple[float, float]:
        """Cosine and sine of the angle, each times the scale."""
        return self.scale * cos(self.angle), self.scale * sin(self.angle)

    def point(self, point: Point) -> Point:
        """(2,) the image of a point."""
        cosine, sine = self._axes
        x, y = point[0] - self.origin[0], point[1] - self.origin[1]
        if self.flip:
            y = -y
        return self.offset[0] + cosine * x - sine * y, self.offset[1] + sine * x + cosine * y

    def direction(self, angle: float) -> float:
        """Radians: the image of a direction."""
        return self.angle - angle if self.flip else self.angle + angle


def turn_about(centre: Point, angle: float) -> Similarity:
    """The turn by so many radians, from the first axis towards the second, that keeps a point."""
    return Similarity(angle=angle, origin=centre, offset=centre)
