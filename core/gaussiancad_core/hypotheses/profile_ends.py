"""Where profiles of bodies of revolution end: exactly at the edges and circles that are drawn.

A slanted line is known by its own ink; its ends, carried to the axis, miss the circles and edges
that they lie on by a little.  Slivers of cells would lie in between.  Where profiles pass smoothly
into each other nothing is drawn: each tells where the other ends.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from gaussiancad_core.cells.surfaces_of_revolution import ArcProfile, LineProfile, Profile
from gaussiancad_core.coordinates.coordinate_clustering import nearest_value
from gaussiancad_core.coordinates.drawn_intervals import Carrier
from gaussiancad_core.geometry.whole_curves import Circle

_STEEP = 0.05
"""Share of a line's change of radius that is left of it at least: a cone that would become a
cylinder is left as it was read."""


@dataclass(frozen=True)
class ProfileEnds:
    """Heights and radii that ends of profiles about one axis have.

    Attributes:
        heights: of edges across the axis.
        radii: of circles about it, and 0.
        near: units within which an end has one of them.
    """

    heights: tuple[float, ...]
    radii: tuple[float, ...]
    near: float

    @classmethod
    def of(
        cls, heights: Sequence[float], concentric: Sequence[Carrier], near: float
    ) -> "ProfileEnds":
        """What edges across an axis and circles about it say."""
        circles = [s.curve.radius for s in concentric if isinstance(s.curve, Circle)]
        return cls(tuple(heights), (0.0, *circles), near)

    def met_by(self, profile: Profile) -> Profile:
        """A line with its ends at the heights and radii that they are near to.

        An arc ends where its circle says, which is adjusted with the others.
        """
        if isinstance(profile, ArcProfile):
            return profile
        low, high = self._height(profile.low), self._height(profile.high)
        if high <= low:
            return profile
        radii = self._radius(profile.at_low), self._radius(profile.at_high)
        if abs(radii[1] - radii[0]) < _STEEP * abs(profile.at_high - profile.at_low):
            return profile
        return LineProfile(low, high, *radii)

    def _height(self, z: float) -> float:
        return nearest_value(self.heights, z, self.near)

    def _radius(self, r: float) -> float:
        return nearest_value(self.radii, r, self.near)


def with_continuations(
    whole: Sequence[Profile], shown: Sequence[Profile], near: float
) -> list[Profile]:
    """Profiles, and those of the ones shown that go on where they end, and so on.

    Where a fillet passes into a cone and into a flat face, programs draw no circle of its own.
    """
    found = list(whole)
    ends = [end for profile in whole for end in _ends(profile)]
    left = [profile for profile in shown if profile not in whole]
    while True:
        more = [p for p in left if any(_meet(a, b, near) for a in _ends(p) for b in ends)]
        if not more:
            return found
        found += more
        ends = [end for profile in more for end in _ends(profile)]
        left = [profile for profile in left if profile not in more]


def _ends(profile: Profile) -> list[tuple[float, float]]:
    """(z, r) of both ends."""
    return [(z, profile.radius(z)) for z in (profile.low, profile.high)]


def _meet(one: tuple[float, float], other: tuple[float, float], near: float) -> bool:
    return abs(one[0] - other[0]) <= near and abs(one[1] - other[1]) <= near
