"""A solid drawn again and compared with the views it was made from."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
import shapely
from OCP.TopoDS import TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.coordinates.ambiguous_linetypes import as_drawn, with_unsure_kinds
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import TELLING
from gaussiancad_core.kernel.brep import (
    area,
    bounding_box,
    edge_length,
    edges_of,
    faces_of,
    soundness,
)
from gaussiancad_core.lines.cut_solids import section_view
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.lines.line_agreement import (
    STEPS_PER_TOLERANCE,
    MatchedLines,
    agreeing_share,
    match_lines,
)
from gaussiancad_core.lines.line_points import LinePoints, Lines, lines_of_strokes, tree_of
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.solid.tangent_agreement import TangentAgreement

LOOSE = 2.5
"""Tolerances of the views within which lines are the same."""

_LEAST = 1e-3
"""The same as a share of the longest extent, at least."""

_FLAW = 2.5
"""Matching tolerances of line in one place from which a disagreement counts."""

_UNREAD = 8.0
"""Tolerances of a hidden line, less what lies at its ends near others, up to which a picture may
not tell it: it is one dash at most."""

_CLOSE = 0.14
"""Share of the matching tolerance within which every line of a file, and every side of the bounding
box, lies; those of a picture lie within the tolerance of its views."""

_STEADY = 24.0
"""Matching tolerances of length from which a stroke is read that well; a shorter one may be off by
as much more as it is shorter, and moves a face as little."""

_SHORT = 1.5
"""Matching tolerances of length from which a straight stroke tells a direction."""

_ASKEW = np.sin(np.radians(25.0))
"""Sine of the angle to the solid's line from which a stroke is no part of that: a small rounding or
chamfer, of which the solid has the corner."""

_THIN, _LONG = 2.0, 15.0
"""Tolerances of width up to which a face is a sliver, and widths that it is long at least: a reader
cannot tell its sides apart."""

_NEAREST = 6
"""Points of the solid's lines by which their direction is taken: at a corner, those of both."""

_HATCHED = 4.0
"""Matching tolerances by which hatching may end beside the outline of what is cut."""

_SMALLEST_FLAW = 0.002
"""The same as a share of the longest extent, at least."""


Place = tuple[float, float]
"""(right, up) mm."""


@dataclass(frozen=True)
class Flaw:
    """A place where the drawings disagree.

    Attributes:
        role: the view.
        place: (right, up) mm, a point of the place.
        length: mm of line.
        missing: the sheet has the line and the solid does not; otherwise the other way round.
        linetype: of the line.
        ends: (right, up) mm, of a straight stretch; None of another one, and of an area.
    """

    role: Role
    place: tuple[float, float]
    length: float
    missing: bool
    linetype: Linetype = Linetype.VISIBLE
    ends: tuple[tuple[float, float], tuple[float, float]] | None = None


@dataclass(frozen=True, eq=False)
class Verification:
    """How a solid's lines agree with the views.

    Attributes:
        sound: one valid closed solid.
        matched: of each view.
        flaws: all places of disagreement, worst first.
        spread: mm that the line of a view runs beside the solid's which does so most, of those that
            are found at all; short lines count less.
        misfit: mm between the solid's bounding box and that of the views, where they differ most.
            The scale is that of the box: if a line sticks out of the part, all measures are off.
        apart: whether a line, or a side of the bounding box, lies farther beside than lines of the
            sheet may miss where they belong: then there may be a small step.
        askew: whether a stroke runs in a direction that no line near has: then there may be a small
            rounding or chamfer.
        thin: how many faces are slivers: no view can show them.
        relaxed_linetypes: whether strokes whose linetype nothing tells are of the other one.
        lines: of the solid in each view, mm.
        areas: of each section that is hatched, cut and hatched area: what is common by all.
    """

    sound: bool
    matched: Mapping[Role, MatchedLines]
    flaws: tuple[Flaw, ...]
    spread: float
    misfit: float
    apart: bool
    askew: bool = False
    thin: int = 0
    relaxed_linetypes: bool = False
    lines: Mapping[Role, tuple[DrawnStroke, ...]] = field(default_factory=dict)
    areas: Mapping[Role, float] = field(default_factory=dict)

    @property
    def share(self) -> float:
        """Share of all lines, the sheet's and the solid's, that the other drawing has."""
        return agreeing_share(self.matched.values())

    @property
    def explains(self) -> bool:
        """Whether the solid is sound and its lines are those of the views."""
        return self.sound and not self.flaws

    @property
    def neat(self) -> bool:
        """Whether it explains the views, and without slivers."""
        return self.explains and not self.thin


def matching_tolerance(views: DrawnViews) -> float:
    """mm within which a line of a solid is a line of the views."""
    return max(LOOSE * views.tolerance, _LEAST * max(views.size))


def verify(shape: TopoDS_Shape, views: DrawnViews) -> Verification:
    """Draw a solid in the views' directions and match the lines both ways.

    Args:
        shape: mm, in the model's axes.
        views: that it was made from.
    """
    facts = soundness(shape)
    tolerance = matching_tolerance(views)
    least = max(_FLAW * tolerance, _SMALLEST_FLAW * max(views.size))
    drawing = LineDrawing(shape)
    matched, spread = {}, 0.0
    drawn, areas = {}, {}
    flaws: list[Flaw] = []
    for role in views.roles:
        cut = views.cuts.get(role)
        if cut is None:
            drawn[role] = tuple(drawing.view(role))
            continue
        section = section_view(shape, role, cut.openings)
        drawn[role] = section.strokes
        if cut.areas is not None:
            areas[role] = _overlap(section.areas, cut.areas)
            flaws += _area_flaws(role, section.areas, cut.areas, tolerance)
    drawn_views, relaxed_linetypes = with_unsure_kinds(views) or views, False
    askew = False
    tangents = TangentAgreement(shape, views, drawn, tolerance)
    for role in views.roles:
        lines = lines_of_strokes(drawn[role], tolerance / STEPS_PER_TOLERANCE)
        strokes = as_drawn(drawn_views.strokes[role], lines, tolerance)
        relaxed_linetypes |= strokes != tuple(drawn_views.strokes[role])
        if role in views.without_hidden:
            # A hidden line of the solid is none that the view lacks.
            lines = Lines(
                lines.visible, lines.hidden.only(np.zeros(len(lines.hidden.points), bool))
            )
        found = match_lines(strokes, lines, tolerance)
        found = matched[role] = tangents.with_smooth_edges(role, found)
        spread = max(spread, _spread(strokes, lines, tolerance, TELLING * tolerance))
        askew |= _is_askew(strokes, lines, _SHORT * tolerance)
        unread = max(least, _UNREAD * views.tolerance)
        seen = max(tolerance, _SMALLEST_FLAW * max(views.size))
        for points, agree, missing, shortest, kind in (
            (found.sheet.visible, found.visible_found, True, seen, Linetype.VISIBLE),
            (found.sheet.hidden, found.hidden_found, True, least, Linetype.HIDDEN),
            (found.result.visible, found.visible_explained, False, least, Linetype.VISIBLE),
            (found.result.hidden, found.hidden_explained, False, unread, Linetype.HIDDEN),
        ):
            for place, length, ends in _places(points.only(~agree), tolerance):
                if length >= shortest:
                    flaws.append(Flaw(role, place, length, missing, kind, ends))
        unexplained = tangents.unexplained(role)
        for place, length, ends in _places(unexplained, tolerance):
            if length >= seen:
                flaws.append(Flaw(role, place, length, True, Linetype.VISIBLE, ends))
    flaws.sort(key=lambda flaw: -flaw.length)
    sound = facts.valid and facts.closed and facts.solids == 1
    misfit = _misfit(shape, views)
    most = views.tolerance if views.noise else _CLOSE * tolerance
    return Verification(
        sound,
        matched,
        tuple(flaws),
        spread,
        misfit,
        max(spread, misfit) > most,
        askew,
        _thin(shape, views),
        relaxed_linetypes,
        drawn,
        areas,
    )


def _overlap(one: shapely.Geometry, other: shapely.Geometry) -> float:
    """Common area by united area."""
    union = one.union(other).area
    return one.intersection(other).area / union if union else 1.0


def _area_flaws(
    role: Role, geometry: shapely.Geometry, hatched: shapely.Geometry, tolerance: float
) -> Iterator[Flaw]:
    """Places of a section where what is cut and what is hatched are not the same, by more than the
    lines around may be off."""
    for one, other, missing in ((hatched, geometry, True), (geometry, hatched, False)):
        offset = _HATCHED * tolerance
        rest = one.difference(other.buffer(offset))
        for part in shapely.get_parts(rest):
            # In corners the last line of a hatching leaves a triangle.
            if not part.buffer(-offset).is_empty:
                x, y = part.representative_point().coords[0]
                yield Flaw(role, (float(x), float(y)), float(part.length) / 2.0, missing)


def _thin(shape: TopoDS_Shape, views: DrawnViews) -> int:
    """How many faces are long, and narrower than what a reader can tell apart."""
    thin = 0
    for face in faces_of(shape):
        around = sum(map(edge_length, edges_of(face)))
        width = 2.0 * area(face) / around
        thin += width < _THIN * views.tolerance and around > 2.0 * _LONG * width
    return thin


def _misfit(shape: TopoDS_Shape, views: DrawnViews) -> float:
    """mm between the sides of a solid's bounding box and those of the views, at most."""
    sides = np.array([np.zeros(3), views.size])
    return float(np.abs(bounding_box(shape) - sides).max())


def _spread(strokes: Iterable[DrawnStroke], result: Lines, tolerance: float, least: float) -> float:
    """mm that the stroke of a view runs beside the solid's lines which does so most.

    What counts is where most of a stroke runs: ends are known less exactly.
    """
    kinds = {Linetype.VISIBLE: result.visible, Linetype.HIDDEN: result.hidden}
    trees = {kind: tree_of(lines.points) for kind, lines in kinds.items() if len(lines.points) > 1}
    worst = 0.0
    for stroke in strokes:
        if stroke.linetype in trees and stroke.length >= least:
            points = stroke.sample(tolerance / 4.0)
            offset = float(np.median(_off_lines(points, trees[stroke.linetype])))
            if offset <= tolerance:
                worst = max(worst, offset * min(1.0, stroke.length / (_STEADY * tolerance)))
    return worst


def _is_askew(strokes: Iterable[DrawnStroke], result: Lines, least: float) -> bool:
    """Whether a straight stroke of some length runs across all lines of the solid that are near."""
    kinds = {Linetype.VISIBLE: result.visible, Linetype.HIDDEN: result.hidden}
    trees = {kind: tree_of(lines.points) for kind, lines in kinds.items() if len(lines.points) > 1}
    for stroke in strokes:
        if isinstance(stroke, Segment) and stroke.linetype in trees and stroke.length >= least:
            tree = trees[stroke.linetype]
            start, end = np.array(stroke.start), np.array(stroke.end)
            item = (end - start) / stroke.length
            _, nearest = tree.query(0.5 * (start + end), k=min(_NEAREST, tree.n))
            near = tree.data[nearest]
            along = near[1:] - near[0]
            length = np.hypot(*along.T)
            some = length > 1e-9
            across = np.abs(item[0] * along[some, 1] - item[1] * along[some, 0]) / length[some]
            if some.any() and across.min() > _ASKEW:
                return True
    return False


def _off_lines(points: npt.NDArray[np.float64], tree: cKDTree) -> npt.NDArray[np.float64]:
    """(n,) mm between points and the lines through their two nearest points of lines."""
    distances, nearest = tree.query(points, k=2)
    one, other = tree.data[nearest[:, 0]], tree.data[nearest[:, 1]]
    along, away = other - one, points - one
    length = np.hypot(*along.T)
    across = np.abs(along[:, 0] * away[:, 1] - along[:, 1] * away[:, 0])
    return np.where(length > 0.0, across / np.maximum(length, 1e-12), distances[:, 0])


def _places(
    chosen: LinePoints, tolerance: float
) -> list[tuple[Place, float, tuple[Place, Place] | None]]:
    """Groups of neighbouring points: a point of each, its length in mm, and its ends where it is
    straight."""
    if not len(chosen.points):
        return []
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    pairs = cKDTree(chosen.points).query_pairs(tolerance, output_type="ndarray")
    count = len(chosen.points)
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), (count, count))
    groups, labels = connected_components(graph, directed=False)
    found = []
    for group in range(groups):
        values = np.flatnonzero(labels == group)
        middle = chosen.points[values[len(values) // 2]]
        length = float(chosen.lengths[values].sum())
        found.append((_place(middle), length, _ends(chosen.points[values], tolerance)))
    return found


def _ends(points: npt.NDArray[np.float64], tolerance: float) -> tuple[Place, Place] | None:
    """The outermost of points that lie on one straight line; None where they do not."""
    away = points - points.mean(axis=0)
    _, _, (along, across) = np.linalg.svd(away, full_matrices=True)
    if np.abs(away @ across).max() > tolerance / 2.0:
        return None
    order = np.argsort(away @ along)
    return _place(points[order[0]]), _place(points[order[-1]])


def _place(point: npt.NDArray[np.float64]) -> Place:
    return float(point[0]), float(point[1])
