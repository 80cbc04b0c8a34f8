"""What an engineer takes for usual where views leave hidden lines out.

Nothing is inside a part that no view shows, and what is seen of a hole goes through.  Neither is a
rule: of the labels that have all lines those are looked for that keep most of it.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise, product
from math import dist, hypot, prod

from shapely import contains_xy

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.cells.cell_complex import Cell, CellComplex, Crossing, Surface
from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import APART, SAME_PLACE
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.hypotheses.noted_holes import Kept
from gaussiancad_core.hypotheses.symmetry import is_symmetric, mirror_images
from gaussiancad_core.labelling.visibility_rules import Transition
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.section_planes import Cut
from gaussiancad_core.sheet.work_limits import PLACES

UNSEEN, LOOSE, BLIND = 40, 40, 3
"""Surfaces that weigh as much as a void that no view sees, as what stands by itself in a through
hole, and, beside one for each of its cells, as a hole that is seen and does not go through."""

NOWHERE = 15
"""Surfaces that a surface weighs as much as whose trace no view draws."""

NOTED = 400
"""Surfaces that weigh as much as a note at a hole that is not kept."""

_BULK = 1000.0
"""Surfaces that a void as large as the part's box weighs as much as, if it is no through hole."""

ROUND = 5
"""Surfaces that a square corner weighs as much as where a part may be round."""


@dataclass(frozen=True)
class Hole:
    """Cells behind a region of a view that the part surrounds.

    Attributes:
        cells: of the region itself, the first that is seen first.
        within: of the regions that it surrounds.
    """

    cells: tuple[Cell, ...]
    within: tuple[Cell, ...] = ()


@dataclass(frozen=True)
class Priors:
    """Columns of cells that tell what is usual.

    Attributes:
        sights: cells along lines of sight, from each viewer on.
        holes: that may be, as seen in views without hidden lines.
        bulks: of each cell, in surfaces, how much a void of its size weighs.
        corners: of each cell between a circle that no view draws and the square around it the cell
            that is beyond, None outside of all: where that is void, it is likely to be void.
        squares: those of them that no larger circle parts from the square's corner.
        undrawn: of each surface whose trace no view draws the pairs of cells that it parts.
        mirrored: cells on both sides of a section through the middle of what is drawn alike on
            both, and how much it weighs, in surfaces, that one is void and the other is not.
        noted: of each note at a hole the labels under which it is kept.
    """

    sights: tuple[tuple[Cell, ...], ...]
    holes: tuple[Hole, ...]
    bulks: Mapping[Cell, int]
    undrawn: tuple[frozenset[Transition], ...] = ()
    mirrored: tuple[tuple[Cell, Cell, int], ...] = ()
    noted: tuple[tuple[Kept, ...], ...] = ()
    corners: Mapping[Cell, Cell | None] = field(default_factory=dict)
    squares: frozenset[Cell] = frozenset()


def priors_of(
    carriers: PartCarriers,
    space: CellComplex,
    roles: Iterable[Role],
    undrawn: Iterable[Role],
    cuts: Mapping[Role, Cut],
) -> Priors:
    """What is usual in the cells of a part.

    Args:
        carriers: of the views.
        space: the cells.
        roles: views that are not cut.
        undrawn: those of them that draw no hidden lines.
        cuts: sections, in units.  What they show behind their planes is likely to be before them as
            well.
    """
    silent = {role_plane(role).normal for role in undrawn}
    found = _Found()
    for role in roles:
        normal = role_plane(role).normal
        _look(found, carriers, space, role, with_holes=normal in silent)
    for role, cut in cuts.items():
        normal = role_plane(role).normal
        _look_through(found, carriers.planes[normal], space, cut)
        for at in {opening.at for opening in cut.openings}:
            in_middle = abs(2.0 * at - carriers.size[normal.value]) <= SAME_PLACE
            alike = in_middle and is_symmetric(carriers, normal)
            _look_from(found, space, normal, at, alike=alike)
    box = prod(values[-1] - values[0] for values in space.values.values())
    bulks = {
        cell: 1 + round(_BULK * min(v for v in volumes if v) / box)
        for cell, volumes in found.volumes.items()
    }
    return Priors(
        tuple(sights for sights in found.sights if sights),
        tuple(found.holes),
        bulks,
        tuple(_undrawn(carriers, space)),
        tuple((a, b, min(bulks.get(a, 1), bulks.get(b, 1))) for a, b in found.mirrored),
        corners=found.corners,
        squares=frozenset(found.squares),
    )


@dataclass
class _Found:
    """What lines of sight tell; the keys of dictionaries in the order in which they were found.

    Attributes:
        sights, holes, mirrored: as in :class:`Priors`.
        volumes: units^3 of each cell, by the axis that lines of sight were along.
        corners, squares: cells beside what is round rather than square, as there.
    """

    sights: dict[tuple[Cell, ...], None] = field(default_factory=dict)
    holes: dict[Hole, None] = field(default_factory=dict)
    mirrored: dict[tuple[Cell, Cell], None] = field(default_factory=dict)
    volumes: defaultdict[Cell, list[float]] = field(
        default_factory=lambda: defaultdict(lambda: [0.0, 0.0, 0.0])
    )
    corners: dict[Cell, Cell | None] = field(default_factory=dict)
    squares: set[Cell] = field(default_factory=set)


def _look(
    found: _Found, carriers: PartCarriers, space: CellComplex, role: Role, *, with_holes: bool
) -> None:
    """What a view that is not cut tells."""
    looks = role_plane(role)
    plane = carriers.planes[looks.normal]
    rounds = _turned(plane, max(SAME_PLACE, carriers.tolerance))
    drawn = _as_drawn(plane)
    behind: dict[int, tuple[Cell, ...]] = {}
    parts: defaultdict[int, set[int]] = defaultdict(set)
    for region, point, area in space.planes[plane.normal].trapezoids():
        if len(found.sights) >= PLACES:
            break
        column = space.column(plane.normal, *point)
        inside = [(c.after, d.depth - c.depth) for c, d in pairwise(column) if c.after is not None]
        for circle in rounds:
            if _in_corner(point, circle):
                beyond = _beyond(point, circle)
                found.corners.update(_adjacent(column, space.column(plane.normal, *beyond)))
                # Of several circles the largest one counts.
                items = {cell for cell, _ in inside}
                found.squares -= items
                if not _is_ringed(point, beyond, circle, plane):
                    found.squares |= items
        for cell, depth in inside:
            found.volumes[cell][plane.normal.value] += max(area * depth, 1e-9)
        cells = tuple(cell for cell, _ in (inside if looks.looks_up else inside[::-1]))
        found.sights[cells] = None
        parts[drawn.locate(*point)].add(region)
        if len(cells) > len(behind.get(region, ())):
            behind[region] = cells
    if with_holes:
        _add_holes(found, drawn, parts, behind)


def _add_holes(
    found: _Found,
    drawn: Arrangement,
    parts: Mapping[int, set[int]],
    behind: Mapping[int, tuple[Cell, ...]],
) -> None:
    """The holes of a view; lines that it may lack divide a hole: it is a hole all the same.

    Args:
        found: what is known.
        drawn: regions that drawn lines bound.
        parts: into which lines that may be lacking divide them.
        behind: the cells behind each.
    """
    for whole, within in _surrounded(drawn).items():
        inner = dict.fromkeys(
            cell
            for each in within
            for part in sorted(parts.get(each, ()))
            for cell in behind.get(part, ())
        )
        for part in sorted(parts.get(whole, ())):
            if part in behind:
                found.holes[Hole(behind[part], tuple(inner))] = None


def _look_through(found: _Found, plane: PlaneCarriers, space: CellComplex, cut: Cut) -> None:
    """Holes that a section looks into along their axis: they are before its plane as well."""
    if cut.areas is None:
        return
    drawn = _as_drawn(plane)
    behind: dict[int, tuple[Cell, ...]] = {}
    parts: defaultdict[int, set[int]] = defaultdict(set)
    for region, point in space.planes[plane.normal].inner_points():
        if cut.opening(point) is None or contains_xy(cut.areas, *point):
            continue
        column = space.column(plane.normal, *point)
        cells = tuple(crossing.after for crossing in column if crossing.after is not None)
        parts[drawn.locate(*point)].add(region)
        if len(cells) > len(behind.get(region, ())):
            behind[region] = cells
    _add_holes(found, drawn, parts, behind)


def _look_from(found: _Found, space: CellComplex, normal: Axis, at: float, *, alike: bool) -> None:
    """What is usual on both sides of a cutting plane."""
    for _, point in islice(space.planes[normal].inner_points(), PLACES):
        column = space.column(normal, *point)
        ends = [(d.depth, c.after) for c, d in pairwise(column) if c.after is not None]
        before = [c.after for c in column if c.after is not None and c.depth <= at]
        beyond = [cell for depth, cell in ends if depth > at]
        found.sights[tuple(before[::-1])] = found.sights[tuple(beyond)] = None
        if alike:
            found.mirrored.update(dict.fromkeys(mirror_images(column, at)))


def _as_drawn(plane: PlaneCarriers) -> Arrangement:
    """The regions that lines bound which are drawn."""
    carriers = [carrier for carrier in plane.carriers if carrier.intervals]
    return Arrangement(carriers, [chain for _, chain, _ in plane.chains])


def _turned(plane: PlaneCarriers, near: float) -> list[Circle]:
    """Circles that no view of a plane draws, about the centre of one that is drawn, within
    ``near``: where other views draw the sides of what may be round or square, a turned part is
    round."""
    circles = [
        (carrier.curve, carrier.intervals)
        for carrier in plane.carriers
        if isinstance(carrier.curve, Circle)
    ]
    circles.sort(key=lambda circle: circle[0].radius)
    drawn = [curve.centre for curve, intervals in circles if intervals]
    return [
        curve
        for curve, intervals in circles
        if not intervals and any(dist(curve.centre, each) <= near for each in drawn)
    ]


def _in_corner(point: Point, circle: Circle) -> bool:
    """Whether a point is outside of a circle and in the square around it."""
    away = [abs(value - centre) for value, centre in zip(point, circle.centre, strict=True)]
    return max(away) < circle.radius < hypot(*away)


def _beyond(point: Point, circle: Circle) -> Point:
    """Where the way from a circle's centre through a point leaves the square around it."""
    (x, y), (a, b) = point, circle.centre
    far = (circle.radius + APART) / max(abs(x - a), abs(y - b))
    return a + far * (x - a), b + far * (y - b)


def _is_ringed(point: Point, beyond: Point, circle: Circle, plane: PlaneCarriers) -> bool:
    """Whether a larger circle about the same centre runs between a point and one beyond it."""
    near, far = dist(point, circle.centre), dist(beyond, circle.centre)
    return any(
        isinstance(carrier.curve, Circle)
        and dist(carrier.curve.centre, circle.centre) <= SAME_PLACE
        and near < carrier.curve.radius < far
        for carrier in plane.carriers
    )


def _adjacent(
    column: Sequence[Crossing], other: Sequence[Crossing]
) -> Iterator[tuple[Cell, Cell | None]]:
    """The cells of a column with those of another one at the same depth; None outside of all."""
    for one, end in pairwise(column):
        if one.after is not None:
            middle = 0.5 * (one.depth + end.depth)
            before = [crossing.after for crossing in other if crossing.depth <= middle]
            yield one.after, before[-1] if before else None


def _undrawn(carriers: PartCarriers, space: CellComplex) -> Iterator[frozenset[Transition]]:
    blank = {
        (normal.value, number)
        for normal, plane in carriers.planes.items()
        for number, carrier in enumerate(plane.carriers)
        # Of lost circles other views draw the sides.
        if not carrier.intervals and not isinstance(carrier.curve, Circle)
    }
    if not blank:
        return
    for normal in Axis:
        # Views look along two axes at times, and across these surfaces along the third.
        first, second = (_middles(space.values[Axis(index)]) for index in IN_PLANE[normal])
        for point in islice(product(first, second), PLACES):
            space.column(normal, *point)
    parted: defaultdict[Surface, set[Transition]] = defaultdict(set)
    for before, after, surface in space.crossed():
        if surface in blank:
            parted[surface].add((before, after))
    yield from map(frozenset, parted.values())


def _middles(values: Iterable[float]) -> list[float]:
    return [0.5 * (low + high) for low, high in pairwise(values)]


def _surrounded(plane: Arrangement) -> dict[int, list[int]]:
    """Regions of a plane that do not touch the outside, each with those that it surrounds."""
    adjacent: defaultdict[int, set[int]] = defaultdict(set)
    for one, other in plane.neighbours():
        adjacent[one].add(other)
    inner = sorted(
        number for number, others in adjacent.items() if OUTSIDE not in (number, *others)
    )
    return {
        region: sorted(set(adjacent) - {region} - _reached(adjacent, region)) for region in inner
    }


def _reached(adjacent: Mapping[int, set[int]], without: int) -> set[int]:
    """Regions that the outside leads to past one of them."""
    found, latest = {OUTSIDE}, [OUTSIDE]
    while latest:
        more = adjacent[latest.pop()] - found - {without}
        found |= more
        latest += more
    return found
