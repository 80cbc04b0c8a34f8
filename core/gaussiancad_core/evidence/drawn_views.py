"""The lines of a part's views, as the reasoning takes them."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from gaussiancad_core.evidence.dimension_constraints import DimensionConstraints
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import NotedHole
from gaussiancad_core.model.section_planes import Cut
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype, ViewSet


@dataclass(frozen=True, eq=False)
class DroppedLine:
    """A line of a picture that was taken for annotation, and may be an edge.

    Attributes:
        points: (n, 2) mm in the view's plane (right, up), along it.
        linetype: that it would be of.
        odds: 0 to 1, that it is an edge.
    """

    points: npt.NDArray[np.float64]
    linetype: Linetype
    odds: float


@dataclass(frozen=True)
class DrawnViews:
    """Strokes of views that show one part.

    Attributes:
        strokes: of each view, mm in its plane (right, up); segments, arcs, and curves that are
            neither (ellipses, chains of chords).
        size: (3,) extent of the part's bounding box in mm; it starts at the origin.
        tolerance: mm by which strokes may miss where they belong: about a px of a raster sheet,
            or the rounding of exact lines.
        apart: mm from which coordinates of two lines are different ones; None if the tolerance
            tells.  The reader has made equal what is one.
        noise: mm by which views contradict each other about a coordinate that they share, at the
            median, on the axis on which they do most; 0 for exact lines.
        bound: mm within which 95 % of what is measured between lines lies from what it is.
        likely: whether measures become round ones where they most likely are.
        dash: mm up to which a hidden line may be one dash, as solid as a visible one; None where
            all linetypes are known.
        dimensions: lengths that the sheet has in numbers, mm.
        known: the axis whose extent was told; None where none was.
        undrawn: views that are taken to draw no hidden lines: what is blank there is not visible.
        cuts: views that are sections.  They draw no hidden lines.
        holes: of which notes speak.
        about: the axis that the part is turned about, where no view looks along it.
        dropped: lines of each view that were taken for annotation and may be edges.
        tangents: of each view, lines of the sheet along which faces meet smoothly.
        tangent_policy: what the sheet does with such lines.
    """

    strokes: Mapping[Role, tuple[DrawnStroke, ...]]
    size: tuple[float, float, float]
    tolerance: float
    apart: float | None = None
    noise: float = 0.0
    bound: float = 0.0
    likely: bool = False
    dash: float | None = None
    dimensions: DimensionConstraints | None = None
    known: Axis | None = None
    undrawn: tuple[Role, ...] = ()
    cuts: Mapping[Role, Cut] = field(default_factory=dict)
    holes: tuple[NotedHole, ...] = ()
    about: Axis | None = None
    dropped: Mapping[Role, tuple[DroppedLine, ...]] = field(default_factory=dict)
    tangents: Mapping[Role, tuple[DrawnStroke, ...]] = field(default_factory=dict)
    tangent_policy: TangentPolicy = TangentPolicy.UNKNOWN

    @property
    def without_hidden(self) -> tuple[Role, ...]:
        """Views in which what is blank is only not visible."""
        return tuple(role for role in self.roles if role in self.undrawn or role in self.cuts)

    @property
    def roles(self) -> tuple[Role, ...]:
        """The views in their order."""
        return tuple(self.strokes)

    @property
    def indistinct(self) -> float:
        """mm up to which surfaces are not told apart: how well places are known."""
        return max(FLOOR_MM, self.bound, self.tolerance)


def silent_views(views: DrawnViews) -> tuple[Role, ...]:
    """Views that have no hidden line."""
    return tuple(
        role
        for role, strokes in views.strokes.items()
        if all(stroke.linetype is not Linetype.HIDDEN for stroke in strokes)
    )


FLOOR_MM = 1e-3
"""mm that nobody asks a bound of measures to be less than."""

EXACT_TOLERANCE = 2e-6
"""Tolerance of lines known to rounding, as a share of the part's longest extent."""


def exact_views(
    strokes: Mapping[Role, Iterable[DrawnStroke]], size: tuple[float, float, float]
) -> DrawnViews:
    """Views whose lines are exact: drawn from a solid, or read from a vector file."""
    return DrawnViews(
        {role: tuple(drawn) for role, drawn in strokes.items()}, size, EXACT_TOLERANCE * max(size)
    )


def views_as_read(
    views: ViewSet,
    tolerance: float,
    apart: float | None = None,
    noise: float = 0.0,
    dash: float | None = None,
) -> DrawnViews:
    """Views as they were read from a sheet; ``tolerance``, ``apart``, ``noise``, ``dash`` in mm."""
    strokes = {view.role: view.strokes for view in views.views}
    return DrawnViews(strokes, views.size, tolerance, apart, noise, dash=dash)
