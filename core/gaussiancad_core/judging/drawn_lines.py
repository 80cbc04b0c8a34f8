"""What a view draws of a part, as the judge looks at it: lines as chords, cuts, hatched areas."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.evidence.drawn_views import DrawnViews, DroppedLine
from gaussiancad_core.judging.faceted_solids import Floats
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import Cut
from gaussiancad_core.model.views import Arc, Linetype

_CHORD, _ROUND = 1.0 / 400.0, 1.0 / 8.0
"""Chords of a curve: shares of the part's longest extent, and of an arc's radius, at most."""

_OFF = 4e-4
"""Share of the longest extent by which the judge looks beside a stroke at least."""


@dataclass(frozen=True, eq=False)
class DrawnLine:
    """A stroke of a view.

    Attributes:
        points: (n, 2) mm in the view's plane (right, up), corners of its chords.
        is_visible: whether it is drawn as a visible edge.
        is_circle: whether it is a whole circle.
        odds: 0 to 1, that it is the part's as it is drawn.
        is_tangent: whether it is drawn where faces meet smoothly; then it is no visible edge.
    """

    points: Floats
    is_visible: bool
    is_circle: bool = False
    odds: float = 1.0
    is_tangent: bool = False

    @property
    def length(self) -> float:
        """mm."""
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())


@dataclass(frozen=True, eq=False)
class DrawnView:
    """What one view draws.

    Attributes:
        role: of the view, or of a section that stands beside one.
        lines: of the part.
        draws_hidden: whether what is hidden is drawn.
        cut: where the view is cut open; None where it is not.
        draws_tangents: whether lines where faces meet smoothly are drawn, wide or thin.
    """

    role: Role
    lines: tuple[DrawnLine, ...]
    draws_hidden: bool
    cut: Cut | None = None
    draws_tangents: bool = False

    @property
    def length(self) -> float:
        """mm of all lines but tangent edges, each by its odds."""
        return sum(line.odds * line.length for line in self.lines if not line.is_tangent)


@dataclass(frozen=True, eq=False)
class DrawnSheet:
    """What a sheet draws of a part.

    Attributes:
        views: each on the part's axes.
        size: (3,) mm, the extent of the views together; they start at the origin.
        tolerance: mm by which strokes may miss where they belong.
    """

    views: tuple[DrawnView, ...]
    size: Floats
    tolerance: float

    @property
    def longest(self) -> float:
        """mm."""
        return float(self.size.max())

    @property
    def aside(self) -> float:
        """mm from a stroke to the lines of sight on its two sides."""
        return max(3.0 * self.tolerance, _OFF * self.longest)

    @property
    def length(self) -> float:
        """mm of all lines but tangent edges, each by its odds."""
        return sum(view.length for view in self.views)


def drawn_sheet(views: DrawnViews) -> DrawnSheet:
    """The views of a sheet as the judge looks at them."""
    size = np.array(views.size, dtype=np.float64)
    longest = float(size.max())
    # Where no view draws a hidden line, none tells that nothing is hidden.
    drawn = [
        DrawnView(
            role,
            (
                *_lines(strokes, longest),
                *_dropped(views.dropped.get(role, ())),
                *_tangents(views.tangents.get(role, ()), longest),
            ),
            role not in views.without_hidden
            and any(stroke.linetype is Linetype.HIDDEN for stroke in strokes),
            views.cuts.get(role),
            views.tangent_policy.draws,
        )
        for role, strokes in views.strokes.items()
    ]
    return DrawnSheet(tuple(drawn), size, views.tolerance)


def _dropped(lines: Iterable[DroppedLine]) -> Iterable[DrawnLine]:
    for line in lines:
        yield DrawnLine(line.points, line.linetype is Linetype.VISIBLE, odds=line.odds)


def chords_of(lines: Sequence[DrawnLine]) -> list[shapely.LineString]:
    """The lines as geometry, in their order."""
    return [shapely.LineString(line.points) for line in lines]


def _tangents(strokes: Iterable[DrawnStroke], longest: float) -> Iterable[DrawnLine]:
    for line in _lines(strokes, longest):
        yield replace(line, is_visible=False, is_tangent=True)


def _lines(strokes: Iterable[DrawnStroke], longest: float) -> Iterable[DrawnLine]:
    for stroke in strokes:
        step = _CHORD * longest
        if isinstance(stroke, Arc):
            step = min(step, _ROUND * stroke.radius)
        points = stroke.vertices(step)
        points = points[np.append(True, np.hypot(*np.diff(points, axis=0).T) > 1e-9)]
        if len(points) > 1:
            is_circle = isinstance(stroke, Arc) and stroke.is_full
            is_visible = stroke.linetype is Linetype.VISIBLE
            yield DrawnLine(points, is_visible, is_circle, stroke.confidence)
