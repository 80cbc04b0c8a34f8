"""The views of a sheet under one projection, and their lines as the reasoning takes them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import cast

from gaussiancad_core.evidence.dimension_evidence import dimension_constraints
from gaussiancad_core.evidence.drawn_views import DrawnViews, DroppedLine, views_as_read
from gaussiancad_core.evidence.line_noise import bound_of_seen_px, noise_px
from gaussiancad_core.evidence.section_evidence import SectionBeside
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.hole_depths import NotedHole
from gaussiancad_core.model.section_planes import Cut, SectionRole
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.label_evidence import LabelledLine
from gaussiancad_core.sheet.registration.stroke_precision import tolerance_px
from gaussiancad_core.sheet.registration.view_registration import strokes_in_plane
from gaussiancad_core.sheet.sheet_stages import ReadView, RegisteredSheet
from gaussiancad_core.writing.scale_agreement import Measure

_ROUGH_PX = 1.0
"""Tolerance of strokes that were read from a picture."""

_LEAST_ODDS = 0.1
"""Odds that a line is an edge from which it counts though it was taken for annotation."""

APART_PX = 0.3
"""px from which the coordinates of such strokes are different ones: lines are read to a twentieth
of a pixel, and what is one over the views has been made equal."""


@dataclass(frozen=True, eq=False)
class ProjectedReading:
    """The views of a sheet under a projection.

    Attributes:
        registered: on shared axes.
        projection: first or third angle.
        measures: what the sheet's dimensions say.
        cuts: views that are sections.
        adjacent_sections: sections beside plain views.
        holes: of which notes speak.
        tangent_policy: what the sheet does with lines along which faces meet smoothly.
    """

    registered: RegisteredSheet
    projection: Projection
    measures: tuple[Measure, ...] = ()
    cuts: Mapping[Role, Cut] = field(default_factory=dict)
    adjacent_sections: Mapping[SectionRole, SectionBeside] = field(default_factory=dict)
    holes: tuple[NotedHole, ...] = ()
    tangent_policy: TangentPolicy = TangentPolicy.UNKNOWN

    @property
    def grid(self) -> float:
        """mm of a px of the sheet: lines closer together are one."""
        return self.registered.mm_per_pixel

    @property
    def is_alone(self) -> bool:
        """Whether the sheet has one view."""
        return self.registered.unseen is not None

    @property
    def drawn(self) -> DrawnViews:
        """The lines of the views, as the reasoning takes them."""
        plain = drawn_views(self.registered, self.measures)
        neighbour, unseen = self.adjacent_sections.items(), self.registered.unseen
        return replace(
            plain,
            strokes={**plain.strokes, **{cast(Role, r): each.strokes for r, each in neighbour}},
            cuts={**self.cuts, **{cast(Role, r): each.cut for r, each in neighbour}},
            holes=self.holes,
            about=unseen.about if unseen is not None else None,
            dropped={view.role: self._dropped(view) for view in self.registered.drawn},
            tangents=_tangents(self.registered),
            tangent_policy=self.tangent_policy,
        )

    def _dropped(self, view: ReadView) -> tuple[DroppedLine, ...]:
        """Lines of a view that were taken for annotation and may be edges."""
        places = self.registered.placements
        return tuple(
            DroppedLine(
                places[view.role].to_plane(line.points), _linetype(line), 1.0 - line.confidence
            )
            for line in view.labels.lines
            if not line.is_part and line.confidence <= 1.0 - _LEAST_ODDS
        )

    @property
    def numbered(self) -> DrawnViews:
        """The same with what the sheet's numbers say of lengths, where the sheet is a file, too."""
        drawn = self.drawn
        if drawn.dimensions is not None:
            return drawn
        return replace(
            drawn, dimensions=dimension_constraints(self.registered, self.measures, drawn.noise)
        )


def _linetype(line: LabelledLine) -> Linetype:
    return Linetype.HIDDEN if line.otherwise is InkClass.HIDDEN else Linetype.VISIBLE


def _tangents(registered: RegisteredSheet) -> dict[Role, tuple[Stroke, ...]]:
    """The tangent edges of each view, mm in its plane; not of views that have none."""
    return {
        view.role: strokes_in_plane(view.tangents, registered.placements[view.role])
        for view in registered.drawn
        if view.tangents
    }


def drawn_views(registered: RegisteredSheet, measures: Sequence[Measure] = ()) -> DrawnViews:
    """The lines of a sheet's views, with the tolerance of the view that is known least exactly.

    Args:
        registered: the views.
        measures: what the sheet's dimensions say; lines of a file are more exact than these.
    """
    tolerance = max(tolerance_px(view.source, view.step) for view in registered.drawn)
    pixel = registered.mm_per_pixel
    if tolerance < _ROUGH_PX:
        exact = views_as_read(registered.views, tolerance * pixel)
        return replace(exact, bound=bound_of_seen_px(registered) * pixel)
    noise, bound = noise_px(registered)
    dashes = [view.dash * pixel for view in registered.drawn if view.dash is not None]
    drawn = views_as_read(
        registered.views,
        tolerance * pixel,
        APART_PX * pixel,
        noise * pixel,
        max(dashes, default=None),
    )
    numbers = dimension_constraints(registered, measures, noise)
    return replace(drawn, bound=bound * pixel, dimensions=numbers, known=registered.given_axis)
