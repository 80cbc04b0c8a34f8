"""Half spaces: what lies below a plane that is edge-on in no view.

Such a plane is a surface of the part only where some of its faces are.  In every view a face shows
all of its outline, so that the regions of the view inside of it belong to the face; only where the
regions of all views do, the half space counts (see :class:`.cell_complex.CellComplex`).
"""

from dataclasses import dataclass

from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import FAR, SHORTEST
from gaussiancad_core.geometry.whole_curves import LineOrCircle, line_through
from gaussiancad_core.model.axes import Axis, Vector
from gaussiancad_core.model.projection_planes import IN_PLANE


@dataclass(frozen=True)
class HalfSpace:
    """The points with ``normal . point < offset``.

    Attributes:
        normal: (3,) unit normal, no component of which is 0.
        offset: units.
        hulls: corners, in order, of convex polygons on the plane around its faces.
        creases: ends of segments within the hulls along which other surfaces cross the plane.
    """

    normal: Vector
    offset: float
    hulls: tuple[tuple[Vector, ...], ...]
    creases: tuple[tuple[Vector, Vector], ...] = ()

    def holds(self, point: Vector) -> bool:
        """Whether a point lies below the plane."""
        return sum(n * x for n, x in zip(self.normal, point, strict=True)) < self.offset

    def depth(self, normal: Axis, a: float, b: float) -> float:
        """Where the line through (a, b) along an axis meets the plane."""
        first, second = IN_PLANE[normal]
        rest = self.offset - self.normal[first] * a - self.normal[second] * b
        return rest / self.normal[normal.value]

    def crossings(self, normal: Axis, a: float, b: float) -> list[tuple[float, Vector]]:
        """Depths and unit normals where a line along an axis enters and leaves the half space.

        One of the two is far away: the half space has no other border than the plane.
        """
        depth = self.depth(normal, a, b)
        end = -FAR if self.normal[normal.value] > 0.0 else FAR
        return sorted([(depth, self.normal), (end, self.normal)])

    def rims(self, normal: Axis) -> list[tuple[LineOrCircle, tuple[float, float]]]:
        """The creases, as far as they are slanted in a view.

        Those that are not run along values of an axis, where everything is looked at anyway.
        """
        first, second = IN_PLANE[normal]
        found: list[tuple[LineOrCircle, tuple[float, float]]] = []
        for crease in self.creases:
            start, end = ((point[first], point[second]) for point in crease)
            if max(abs(start[0] - end[0]), abs(start[1] - end[1])) < SHORTEST:
                continue
            line = line_through(start, end)
            if line.axis is None:
                low, high = sorted((line.parameter(start), line.parameter(end)))
                found.append((line, (low, high)))
        return found

    def outlines(self, normal: Axis) -> tuple[tuple[Point, ...], ...]:
        """The hulls as a view sees them: corners in the view's plane."""
        first, second = IN_PLANE[normal]
        return tuple(tuple((p[first], p[second]) for p in hull) for hull in self.hulls)
