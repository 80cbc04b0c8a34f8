"""Bodies of revolution: cones, spheres and tori about an axis of a circle.

Their surfaces are edge-on in no view.  A body is the space below a profile: with the coordinate z
along its axis and the distance r from it, all points with ``low < z < high`` and ``r < f(z)``, f
being a slanted line or a part of a circle.
"""

from dataclasses import dataclass
from math import cos, hypot, sin, sqrt

from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import FAR, SHORTEST, UNIT_VECTOR
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, line_through
from gaussiancad_core.model.axes import Axis, Vector
from gaussiancad_core.model.projection_planes import IN_PLANE

_SMOOTH = 0.01
"""Units from its widest place within which an arc ends along the axis."""


@dataclass(frozen=True)
class LineProfile:
    """A slanted line: the profile of a cone.

    Attributes:
        low, high: z of its ends, ascending.
        at_low, at_high: r there.
    """

    low: float
    high: float
    at_low: float
    at_high: float

    def radius(self, z: float) -> float:
        """r at z."""
        share = (z - self.low) / (self.high - self.low)
        return self.at_low + share * (self.at_high - self.at_low)

    def heights(self, r: float) -> list[float]:
        """All z where the profile has a radius."""
        if self.at_high == self.at_low:
            return []
        share = (r - self.at_low) / (self.at_high - self.at_low)
        return [self.low + share * (self.high - self.low)] if 0.0 < share < 1.0 else []

    def normal(self, z: float) -> tuple[float, float]:
        """Unit normal (along r, along z) that leaves the body."""
        along, across = self.high - self.low, self.at_high - self.at_low
        length = hypot(along, across)
        return along / length, -across / length


@dataclass(frozen=True)
class ArcProfile:
    """A part of a circle: the profile of a sphere or a torus.

    Attributes:
        low, high: z of its ends, ascending.
        z, r: centre; r is 0 for a sphere.
        radius_of_arc: of the circle.
        side: 1 for the part away from the axis, -1 for the one towards it.
    """

    low: float
    high: float
    z: float
    r: float
    radius_of_arc: float
    side: int

    @property
    def ends_along_axis(self) -> bool:
        """Whether it runs along the axis at one of its ends."""
        return min(abs(self.low - self.z), abs(self.high - self.z)) < _SMOOTH

    def radius(self, z: float) -> float:
        """r at z."""
        square = self.radius_of_arc**2 - (z - self.z) ** 2
        return self.r + self.side * sqrt(max(square, 0.0))

    def heights(self, r: float) -> list[float]:
        """All z where the profile has a radius."""
        off = (r - self.r) * self.side
        if off < 0.0 or off >= self.radius_of_arc:
            return []
        half = sqrt(self.radius_of_arc**2 - off**2)
        return [z for z in (self.z - half, self.z + half) if self.low < z < self.high]

    def normal(self, z: float) -> tuple[float, float]:
        """Unit normal (along r, along z) that leaves the body."""
        return (
            (self.radius(z) - self.r) / self.radius_of_arc * self.side,
            (z - self.z) / self.radius_of_arc * self.side,
        )


Profile = LineProfile | ArcProfile


@dataclass(frozen=True)
class SurfaceOfRevolution:
    """The space below a profile that turns about an axis.

    With a sector the profile turns only through that angle, as at a rounded corner.  What lies in
    the sector on the other side of the profile is one cell with what lies around it, so the body is
    the side that is not: the space *beyond* the profile as a rule, as at an outer corner, and the
    space below it where an arc curves towards the axis, as at the rim of a round notch.

    Nor is a line drawn where an arc passes smoothly into a cylinder, as at a rod's rounded end.
    What lies below such a profile goes on below the cylinder: the body is the space beyond it.

    Attributes:
        axis: direction.
        centre: (2,) of the axis in its projection plane.
        profile: line or arc.
        sector: (start, sweep) in radians of the projection plane, sweep at most pi; None for a
            whole turn.
    """

    axis: Axis
    centre: tuple[float, float]
    profile: Profile
    sector: tuple[float, float] | None = None

    def holds(self, point: Vector) -> bool:
        """Whether a point lies in the body."""
        first, second = IN_PLANE[self.axis]
        z = point[self.axis.value]
        if not self.profile.low < z < self.profile.high:
            return False
        a, b = point[first] - self.centre[0], point[second] - self.centre[1]
        if self.sector and not self._in_sector(a, b):
            return False
        return (hypot(a, b) > self.profile.radius(z)) == self.is_beyond

    @property
    def is_beyond(self) -> bool:
        """Whether the body is the space beyond the profile."""
        profile = self.profile
        if not isinstance(profile, ArcProfile):
            return self.sector is not None
        return profile.side > 0 and (self.sector is not None or profile.ends_along_axis)

    def _in_sector(self, a: float, b: float) -> bool:
        return all(a * x + b * y > 0.0 for x, y in self._inward())

    def _inward(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Normals of the sector's two sides that point into it."""
        if self.sector is None:
            raise ValueError("the body has no sector")
        start, sweep = self.sector
        end = start + sweep
        return (-sin(start), cos(start)), (sin(end), -cos(end))

    def crossings(self, normal: Axis, a: float, b: float) -> list[tuple[float, Vector]]:
        """Depths and unit normals where the line through (a, b) along an axis meets the border."""
        if normal is self.axis:
            if self.sector and not self._in_sector(a - self.centre[0], b - self.centre[1]):
                return []
            return self._along(a, b)
        return self._across(normal, a, b)

    def _along(self, a: float, b: float) -> list[tuple[float, Vector]]:
        profile = self.profile
        # On the axis itself a cone would be entered at its apex, which is no crossing.
        r = max(hypot(a - self.centre[0], b - self.centre[1]), UNIT_VECTOR)
        flat = self._vector((0.0, 0.0), 1.0)
        ends = (profile.low, profile.high)
        found = [(z, flat) for z in ends if (r > profile.radius(z)) == self.is_beyond]
        for z in profile.heights(r):
            along_r, along_z = profile.normal(z)
            out = (
                (0.0, 0.0)
                if r <= UNIT_VECTOR
                else ((a - self.centre[0]) / r, (b - self.centre[1]) / r)
            )
            found.append((z, self._vector((along_r * out[0], along_r * out[1]), along_z)))
        return found

    def _across(self, normal: Axis, a: float, b: float) -> list[tuple[float, Vector]]:
        axes = IN_PLANE[normal]
        point = dict(zip(axes, (a, b), strict=True))
        z = point[self.axis.value]
        if not self.profile.low < z < self.profile.high:
            return []
        pair = IN_PLANE[self.axis]
        place = pair.index(normal.value)
        off = point[pair[1 - place]] - self.centre[1 - place]
        r = self.profile.radius(z)
        half = sqrt(r * r - off * off) if r > abs(off) else 0.0
        along_r, along_z = self.profile.normal(z)
        found = []
        for way in (-half, half) if half else ():
            out = [0.0, 0.0]
            out[place], out[1 - place] = way / r, off / r
            direction = self._vector((along_r * out[0], along_r * out[1]), along_z)
            found.append((self.centre[place] + way, direction))
        if self.sector is not None:
            return self._of_sector(found, place, off)
        if self.is_beyond:
            # The space beyond reaches far away on both sides.
            found += [(way, self._vector((1.0, 0.0), 0.0)) for way in (-FAR, FAR)]
        return found

    def _of_sector(
        self, circle: list[tuple[float, Vector]], place: int, off: float
    ) -> list[tuple[float, Vector]]:
        """Crossings of a line with what of the sector lies beyond the profile's circle, or in it.

        Args:
            circle: crossings of the line with the whole circle, two or none.
            place: of the line's axis in the projection plane.
            off: the line's other coordinate, from the centre.
        """
        low, high = -FAR, FAR
        sides: dict[float, Vector] = {}
        for inward in self._inward():
            slope, rest = inward[place], inward[1 - place] * off
            if abs(slope) < UNIT_VECTOR:
                if rest <= 0.0:
                    return []
                continue
            at = -rest / slope
            sides[at] = self._vector(inward, 0.0)
            if slope > 0.0:
                low = max(low, at)
            else:
                high = min(high, at)
        if low >= high:
            return []
        middle = self.centre[place]
        ends = [(middle + at, sides.get(at, self._vector((1.0, 0.0), 0.0))) for at in (low, high)]
        inside = [hit for hit in circle if middle + low < hit[0] < middle + high]
        # Between its meetings with the circle the line is below the profile.
        below = [bool(circle) and circle[0][0] < end[0] < circle[1][0] for end in ends]
        kept = [
            end for end, is_below in zip(ends, below, strict=True) if is_below != self.is_beyond
        ]
        return kept + inside

    def rims(self, normal: Axis) -> list[tuple[LineOrCircle, tuple[float, float]]]:
        """Circles of both ends along the axis; both outlines of the profile across it.

        A sector's outlines are left out: they are those of the surfaces that it passes into.
        """
        profile = self.profile
        if normal is self.axis:
            radii = (profile.radius(profile.low), profile.radius(profile.high))
            return [
                (Circle(self.centre, radius), stretch)
                for radius in radii
                if radius > SHORTEST
                for stretch in self._stretches()
            ]
        if self.sector:
            return []
        along = IN_PLANE[normal].index(self.axis.value)
        other = IN_PLANE[normal][1 - along]
        middle = self.centre[IN_PLANE[self.axis].index(other)]
        found: list[tuple[LineOrCircle, tuple[float, float]]] = []
        for side in (-1.0, 1.0):
            ends = []
            for z in (profile.low, profile.high):
                end = [0.0, 0.0]
                end[along], end[1 - along] = z, middle + side * profile.radius(z)
                ends.append((end[0], end[1]))
            if isinstance(profile, LineProfile):
                line = line_through(ends[0], ends[1])
                first, last = sorted(line.parameter(end) for end in ends)
                found.append((line, (first, last)))
                continue
            centre = [0.0, 0.0]
            centre[along], centre[1 - along] = profile.z, middle + side * profile.r
            circle = Circle((centre[0], centre[1]), profile.radius_of_arc)
            low, high = sorted(circle.parameter(end) for end in ends)
            half = circle.at((low + high) / 2.0)[1 - along] - centre[1 - along]
            if half * side * profile.side < 0.0:
                found += [(circle, (0.0, low)), (circle, (high, FULL_TURN))]
            else:
                found.append((circle, (low, high)))
        return found

    def outlines(self, normal: Axis) -> None:
        """The body counts everywhere: it has ends of its own."""

    def _stretches(self) -> list[tuple[float, float]]:
        if self.sector is None:
            return [(0.0, FULL_TURN)]
        start, sweep = self.sector
        if start + sweep <= FULL_TURN:
            return [(start, start + sweep)]
        return [(start, FULL_TURN), (0.0, start + sweep - FULL_TURN)]

    def _vector(self, flat: tuple[float, float], along: float) -> Vector:
        first, second = IN_PLANE[self.axis]
        vector = [0.0, 0.0, 0.0]
        vector[first], vector[second], vector[self.axis.value] = flat[0], flat[1], along
        return vector[0], vector[1], vector[2]
