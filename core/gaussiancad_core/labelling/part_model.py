"""A drawing as cells and rules: what the labelling starts from."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from types import MappingProxyType

import numpy as np

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.cells.cell_complex import CellComplex
from gaussiancad_core.cells.edge_fragments import Piece, find_pieces
from gaussiancad_core.cells.grid_rows import count_pieces, find_rows
from gaussiancad_core.cells.surfaces_of_revolution import SurfaceOfRevolution
from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers, find_carriers
from gaussiancad_core.coordinates.coordinate_clustering import nearest_value
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.coordinates.geometric_constraints import Facet
from gaussiancad_core.coordinates.point_chains import Chain, through_points
from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import APART, ASIDE, SAME_PLACE
from gaussiancad_core.geometry.whole_curves import axis_line
from gaussiancad_core.hypotheses.bridges import bridges
from gaussiancad_core.hypotheses.missing_edges import as_if_drawn, with_missing_edges
from gaussiancad_core.hypotheses.noted_holes import floors, kept_notes
from gaussiancad_core.hypotheses.oblique_planes import find_half_spaces
from gaussiancad_core.hypotheses.reprojected_silhouettes import retraced
from gaussiancad_core.hypotheses.revolution_candidates import find_bodies
from gaussiancad_core.hypotheses.short_chamfers import with_short_chamfers
from gaussiancad_core.hypotheses.suppressed_slants import with_suppressed_slants
from gaussiancad_core.hypotheses.undrawn_smooth_edges import with_smooth_edges
from gaussiancad_core.labelling.counted_work import NEVER, Counted, Deadline
from gaussiancad_core.labelling.priors import Priors, priors_of
from gaussiancad_core.labelling.section_rules import area_rules, merged, scaled_cuts, shown
from gaussiancad_core.labelling.visibility_rules import Columns, Rule, rules_of, without_hidden
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.section_planes import Cut
from gaussiancad_core.model.views import Linetype
from gaussiancad_protocol.codes import Code

MOST_STROKES = 900
"""Lines of a view, at most: all that is made of them looks at each beside the others."""

_MOST_PIECES = 80_000
"""Pieces of all views, at most: a part of 120 faces has up to 40,000."""

_MOST_READ, _EXACT = 40_000, 0.02
"""The same of pictures, whose views are known to more than so many units: where they are read that
wrongly, no labels are found in time."""

_MEETING = 0.5
"""Units between a chain's end and the corner that it ends at, at most: where a curve turns back,
its last point is a sample."""

Contradict = Callable[[Sequence[int]], bool]


@dataclass(frozen=True)
class PartModel:
    """A part as cells with rules.

    Attributes:
        carriers: of the views.
        space: the cells.
        rules: what the views say about them.
        usual: what is taken for usual, where views draw no hidden lines.
        sections: where views are cut.
    """

    carriers: PartCarriers
    space: CellComplex
    rules: tuple[Rule, ...]
    usual: Priors | None = None
    sections: Mapping[Role, Cut] = field(default_factory=dict)


def model_part(
    views: DrawnViews,
    near: float = SAME_PLACE,
    deadline: Deadline = NEVER,
    *,
    lost_lines: bool = False,
) -> PartModel:
    """Carriers, cells and rules of views.

    Args:
        views: two to six; those that draw no hidden lines may lack any line along an axis, too,
            where lines may be lacking.
        near: units within which a computed curve is one that is drawn, at least.
        deadline: by which it has to be done.
        lost_lines: whether regions are divided as well where a view may lack a line.

    Raises:
        LimitError: ``part-too-complex``, or ``search-unfinished`` after the deadline.
    """
    strokes = max(len(curves) for curves in views.strokes.values())
    if strokes > MOST_STROKES:
        raise _too_complex(f"a view has {strokes} lines")
    carriers = find_carriers(views)
    half_spaces = find_half_spaces(carriers)
    facets = [Facet(body.normal, hull) for body in half_spaces for hull in body.hulls]
    if facets:
        # Read by themselves their corners lie on no common plane.
        carriers = find_carriers(views, facets)
        half_spaces = find_half_spaces(carriers)
    if lost_lines:
        half_spaces = find_half_spaces(as_if_drawn(with_missing_edges(carriers)))
    carriers = retraced(carriers, half_spaces, find_bodies(carriers))
    carriers = with_short_chamfers(with_suppressed_slants(carriers))
    carriers = with_smooth_edges(carriers)
    if lost_lines:
        carriers = with_missing_edges(
            carriers,
            undrawn=views.without_hidden,
            cuts=_planes_of(views, carriers.scale),
            floors=_undrawn_values(views, carriers),
        )
    planes = {axis: _arranged(plane, carriers.tolerance) for axis, plane in carriers.planes.items()}
    for axis in Axis:
        if axis not in planes:
            planes[axis] = _box(axis, _known_size(carriers))
    space = CellComplex(planes, (*find_bodies(carriers), *half_spaces))
    return without_undrawn(_part(carriers, space, near, deadline, views.cuts), views)


def without_undrawn(part: PartModel, views: DrawnViews) -> PartModel:
    """The part with what is blank only not visible in views that draw no hidden lines."""
    if not views.without_hidden:
        return part
    rules = without_hidden(part.rules, views.without_hidden)
    if not views.undrawn:
        return replace(part, rules=rules)
    whole = [role for role in views.roles if role not in views.cuts]
    silent = [role for role in views.undrawn if role not in views.cuts]
    cuts = scaled_cuts(views.cuts, part.carriers.scale)
    usual = priors_of(part.carriers, part.space, whole, silent, cuts)
    usual = replace(usual, noted=kept_notes(views.holes, part.space, part.carriers))
    return replace(part, rules=rules, usual=usual)


def _undrawn_values(views: DrawnViews, carriers: PartCarriers) -> dict[Axis, tuple[float, ...]]:
    """Coordinates in units at which nothing is drawn and something may end: holes of which notes
    tell the depth, and what is cut open of a view."""
    found = floors(views.holes, carriers)
    for role, cut in scaled_cuts(views.cuts, carriers.scale).items():
        for opening in cut.openings:
            if opening.region is None:
                continue
            corners = np.array(opening.region.exterior.coords)
            for place, index in enumerate(IN_PLANE[role_plane(role).normal]):
                axis = Axis(index)
                inner = {
                    float(value)
                    for value in corners[:, place]
                    if 0.0 < value < carriers.size[index]
                }
                if len(inner) <= 2:
                    found[axis] = (*found.get(axis, ()), *sorted(inner))
    return found


def _planes_of(views: DrawnViews, scale: float) -> tuple[tuple[Axis, float], ...]:
    """Cutting planes: the axis that one is across, and units along it."""
    return tuple(
        (role_plane(role).normal, opening.at * scale)
        for role, cut in views.cuts.items()
        for opening in cut.openings
    )


def with_lone_bodies(
    part: PartModel, contradict: Contradict, deadline: Deadline = NEVER
) -> PartModel | None:
    """The part divided as well by bodies of revolution that one view speaks of.

    More bodies are more cells: they are left out as long as the part can do without.

    Args:
        part: without them.
        contradict: tells whether the part's rules contradict each other, those of some numbers left
            out.  Where lines of sight miss the bodies, the rules stay the same.
        deadline: by which it has to be done.

    Returns:
        None if there are no such bodies, or the lines contradict each other whatever lies in them.

    Raises:
        LimitError: ``part-too-complex``, or ``search-unfinished`` after the deadline.
    """
    bodies = find_bodies(part.carriers, lone=True)
    plain = tuple(body for body in part.space.bodies if isinstance(body, SurfaceOfRevolution))
    if bodies == plain:
        return None
    if set(plain) <= set(bodies):
        added = [body for body in bodies if body not in plain]
        through = [number for number, rule in enumerate(part.rules) if _looks_into(rule, added)]
        if contradict(through):
            return None
    others = part.space.bodies[len(plain) :]
    space = CellComplex(part.space.planes, (*bodies, *others))
    return _part(part.carriers, space, SAME_PLACE, deadline, part.sections)


def _looks_into(rule: Rule, bodies: Sequence[SurfaceOfRevolution]) -> bool:
    """Whether a line of sight beside one of a rule's pieces meets one of the bodies."""
    return any(
        body.crossings(role_plane(piece.role).normal, a + way * da, b + way * db)
        for piece in rule.pieces
        for (a, b), (da, db) in [(piece.point, piece.across)]
        for way in (-ASIDE, ASIDE)
        for body in bodies
    )


def _part(
    carriers: PartCarriers,
    space: CellComplex,
    near: float,
    deadline: Deadline,
    cuts: Mapping[Role, Cut] = MappingProxyType({}),
) -> PartModel:
    near = max(near, 2.0 * carriers.tolerance)
    most = _MOST_PIECES if carriers.tolerance <= _EXACT else _MOST_READ
    rows = {normal: find_rows(space, normal) for normal in carriers.planes}
    planes = carriers.planes.items()
    # Counted before any is made: most lie on the grid.
    count = sum(len(plane.roles) * count_pieces(rows[normal]) for normal, plane in planes)
    found = find_pieces(space, carriers.planes, near, carriers.tolerance, rows)
    pieces = list(islice(_until(found, deadline), most + 1)) if count <= most else []
    if max(count, len(pieces)) > most:
        raise _too_complex(f"its lines divide the views into more than {most:,} pieces")
    sections = scaled_cuts(cuts, carriers.scale)

    def seen(role: Role, places: Sequence[Point], columns: Columns) -> Columns | None:
        return shown(sections[role], role, places, columns)

    rules = rules_of(space, pieces, sections, seen)
    rules += merged(area_rules(space, sections))
    return PartModel(carriers, space, tuple(rules), sections=cuts)


def _until(pieces: Iterable[Piece], deadline: Deadline) -> Iterator[Piece]:
    """The pieces, each counted as it is made."""
    for piece in pieces:
        deadline.count(Counted.PIECE)
        if not deadline.left:
            raise LimitError(
                Code.SEARCH_UNFINISHED,
                "the drawing has more lines than are understood with the work allowed for one "
                "sheet: draw less in one sheet",
                case="lines",
            )
        yield piece


def _too_complex(what: str) -> LimitError:
    return LimitError(
        Code.PART_TOO_COMPLEX,
        "the drawing is too complex for an exact solid: {what}; draw less in one sheet",
        what=what,
    )


def _arranged(plane: PlaneCarriers, tolerance: float) -> Arrangement:
    """The plane's regions; chains become boundaries where the outline is open without them."""
    plain = Arrangement(plane.carriers, lost=plane.lost)
    chains = [chain for _, chain, _ in plane.chains]
    leaking = [chain for chain in chains if _lies_outside(plain, chain)]
    reach = max(APART, 1.5 * tolerance)
    attached = [_attached(chain, plain, chains) for chain in leaking]
    closing = bridges(plain, attached, reach)
    if not attached and not closing:
        return plain
    return Arrangement(plane.carriers, [*attached, *closing], plane.lost)


def _lies_outside(arrangement: Arrangement, chain: Chain) -> bool:
    """Whether most of a drawn curve has the outside on both sides, which cannot be."""
    outside = 0
    inner = chain[1:-1] or chain
    aside = 2.0 * SAME_PLACE
    for a, b in inner:
        sides = ((a + x, b + y) for x in (-aside, aside) for y in (-aside, aside))
        outside += all(arrangement.locate(*side) == OUTSIDE for side in sides)
    return 2 * outside > len(inner)


def _attached(chain: Chain, arrangement: Arrangement, chains: Sequence[Chain]) -> Chain:
    """The chain led through the corners, and ends of other chains, that it meets.

    Its points are known less exactly than they are; a gap would open the outline.
    """
    ends = [end for other in chains if other is not chain for end in (other[0], other[-1])]
    targets = np.array([*arrangement.corners, *ends])
    points = np.array(chain)
    for end in (0, -1):
        away = np.hypot(*(targets - points[end]).T)
        if away.min() < _MEETING:
            points[end] = targets[int(away.argmin())]
    return through_points(points, targets, 2.0 * SAME_PLACE)


def _known_size(carriers: PartCarriers) -> tuple[float, float, float]:
    """The part's extents as its values have them, which may have been rounded."""
    x, y, z = (
        nearest_value(carriers.values.get(axis, ()), extent, max(SAME_PLACE, carriers.tolerance))
        for axis, extent in zip(Axis, carriers.size, strict=True)
    )
    return x, y, z


def _box(normal: Axis, size: tuple[float, float, float]) -> Arrangement:
    """The plane of an axis along which no view looks: nothing is known but the box."""
    first, second = (size[index] for index in IN_PLANE[normal])
    role = next(role for role in Role if role.frame.look_axis[0] is normal)
    sides = ((0, 0.0, second), (0, first, second), (1, 0.0, first), (1, second, first))
    return Arrangement(
        [
            Carrier(
                axis_line(coordinate, value),
                {role: (Interval(0.0, length, Linetype.VISIBLE, 1.0),)},
            )
            for coordinate, value, length in sides
        ]
    )
