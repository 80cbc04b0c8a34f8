"""A solid's smooth edges against the tangent edges of the views.

A sheet that draws tangent edges draws the solid's smooth edges: such a line is no missing edge.  A
line of the sheet that was taken for a tangent edge has to be an edge of the solid, smooth or sharp.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.lines.line_agreement import STEPS_PER_TOLERANCE, MatchedLines
from gaussiancad_core.lines.line_points import LinePoints, Lines, lines_of_strokes
from gaussiancad_core.lines.smooth_edges import smooth_edges
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role


@dataclass(frozen=True, eq=False)
class TangentAgreement:
    """The tangent edges of a solid and of the views that it is compared with.

    Attributes:
        shape: the solid, mm in the model's axes.
        views: that it was made from.
        drawn: role -> the solid's other lines, mm of the view's plane.
        tolerance: mm within which lines are the same.
    """

    shape: TopoDS_Shape
    views: DrawnViews
    drawn: Mapping[Role, tuple[DrawnStroke, ...]]
    tolerance: float

    def with_smooth_edges(self, role: Role, found: MatchedLines) -> MatchedLines:
        """The same with lines of the sheet found that run along smooth edges of the solid, on a
        sheet that draws these."""
        is_found = found.visible_found.all() and found.hidden_found.all()
        if is_found or not self.views.tangent_policy.draws or role in self.views.cuts:
            return found
        return replace(
            found,
            visible_found=found.visible_found | self._on_smooth(found.sheet.visible, role),
            hidden_found=found.hidden_found | self._on_smooth(found.sheet.hidden, role),
        )

    def unexplained(self, role: Role) -> LinePoints:
        """Points of the sheet's tangent edges where the solid has no edge, smooth or sharp; none of
        a view that is cut open."""
        if role in self.views.cuts:
            return LinePoints(np.zeros((0, 2)), np.zeros(0))
        tangents = self._points(self.views.tangents.get(role, ()))
        lines = self._points(self.drawn[role])
        places = _both(tangents)
        wrong = ~(places.near(_both(lines), self.tolerance) | self._on_smooth(places, role))
        return places.only(wrong)

    def _on_smooth(self, points: LinePoints, role: Role) -> npt.NDArray[np.bool_]:
        if not len(points.points):
            return np.zeros(0, dtype=bool)
        return points.near(_both(self._points(self._smooth[role])), self.tolerance)

    def _points(self, strokes: tuple[DrawnStroke, ...]) -> Lines:
        return lines_of_strokes(strokes, self.tolerance / STEPS_PER_TOLERANCE)

    @cached_property
    def _smooth(self) -> dict[Role, tuple[DrawnStroke, ...]]:
        """The solid's smooth edges in the views that are not cut open."""
        plain = {role: lines for role, lines in self.drawn.items() if role not in self.views.cuts}
        return smooth_edges(self.shape, plain)


def _both(lines: Lines) -> LinePoints:
    """The points of visible and of hidden lines."""
    return LinePoints(
        np.concatenate([lines.visible.points, lines.hidden.points]),
        np.concatenate([lines.visible.lengths, lines.hidden.lengths]),
    )
