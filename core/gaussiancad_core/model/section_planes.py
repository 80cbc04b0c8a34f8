"""Where views are cut open (ISO 128-3): full, half, offset and broken-out sections alike."""

from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING

from gaussiancad_core.model.axes import Role, ViewFrame

if TYPE_CHECKING:
    import shapely


class SectionKind(Enum):
    """How much of a view is cut open (ISO 128-3)."""

    FULL = "full"
    HALF = "half"
    BROKEN_OUT = "broken-out"


@dataclass(frozen=True, eq=False)
class CutRegion:
    """A region of a view before whose plane everything is cut away.

    Attributes:
        at: mm of the plane along the axis that the view looks along.
        region: mm in the view's plane (right, up); None for the whole view.
        source: how the plane is known: ``trace``, ``symmetry``, ``circle`` or ``given``.
    """

    at: float
    region: "shapely.Geometry | None" = None
    source: str = "trace"

    def holds(self, point: tuple[float, float]) -> bool:
        """Whether a place of the view is cut open."""
        if self.region is None:
            return True
        from shapely import contains_xy

        return bool(contains_xy(self.region, *point))

    def ends_at(self, point: tuple[float, float], reach: float) -> bool:
        """Whether the region's border is within reach of a place."""
        if self.region is None:
            return False
        from shapely import Point

        return bool(self.region.boundary.distance(Point(point)) <= reach)


@dataclass(frozen=True, eq=False)
class Cut:
    """How a view is cut open.

    Attributes:
        openings: regions that do not overlap; a full section has one, an offset section several
            beside each other, a half section one beside a half that is not cut.
        areas: what is hatched, mm in the view's plane (right, up); None where that is not known.
    """

    openings: tuple[CutRegion, ...]
    areas: "shapely.Geometry | None" = None

    def opening(self, point: tuple[float, float]) -> CutRegion | None:
        """The opening at a place of the view; None where it is not cut."""
        return next((opening for opening in self.openings if opening.holds(point)), None)

    def mapped(self, signs: tuple[int, int], scale: float) -> "Cut":
        """The same in other coordinates: places times a scale and signs, depths times the scale."""
        from shapely import affinity

        factors = tuple(sign * scale for sign in signs)

        def of(geometry: "shapely.Geometry | None") -> "shapely.Geometry | None":
            if geometry is None:
                return None
            return affinity.scale(geometry, *factors, origin=(0.0, 0.0))

        openings = tuple(
            replace(opening, at=opening.at * scale, region=of(opening.region))
            for opening in self.openings
        )
        return replace(self, openings=openings, areas=of(self.areas))


@dataclass(frozen=True)
class SectionRole:
    """What a section shows that stands beside a plain view of the same direction.

    Attributes:
        role: the direction.
        label: letters of the section.
    """

    role: Role
    label: str

    @property
    def frame(self) -> ViewFrame:
        """The orientation of the view in model axes."""
        return self.role.frame

    @property
    def value(self) -> str:
        """Name in reports."""
        return f"{self.role.value} {self.label}-{self.label}"

    def __str__(self) -> str:
        return self.value
