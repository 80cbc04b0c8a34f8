"""What sections say: columns that begin at a plane, and material where they are hatched.

A section shows the part without what stands between the viewer and a plane.  Columns of its view
begin with the plane itself, behind which is the cell that it runs through; what was crossed before
is cut away.  Where the plane meets material the view is hatched (ISO 128-3).
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence

import shapely

from gaussiancad_core.cells.cell_complex import Cell, CellComplex, Crossing
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.labelling.visibility_rules import Group, Rule
from gaussiancad_core.model.axes import Role, Vector
from gaussiancad_core.model.projection_planes import lifted, role_plane
from gaussiancad_core.model.section_planes import Cut
from gaussiancad_core.model.views import Linetype

Column = tuple[Crossing, ...]

CUT = 4
"""Number that stands for the normal of a surface that is a cutting plane."""

_BORDER = 0.1
"""Units from the border of an opening within which nothing is said."""

_HATCHED, _BLANK = 1.0, 0.25
"""Weight of what is hatched or left blank, in units of line for a unit of the side of a square as
large: ribs, shafts and pins are not hatched though they are cut (ISO 128-3)."""


def scaled_cuts(cuts: Mapping[Role, Cut], scale: float) -> dict[Role, Cut]:
    """Cuts in units of the planes, ``scale`` to the millimetre."""
    return {role: cut.mapped(role_plane(role).signs, scale) for role, cut in cuts.items()}


def shown(
    cut: Cut, role: Role, places: Sequence[Point], columns: Sequence[Column]
) -> list[Column] | None:
    """What a view that is cut shows of neighbouring columns.

    Returns:
        The columns, in ascending depth; None where they are not cut alike: between two openings,
        and beside one, nothing is drawn.
    """
    openings = [cut.opening(place) for place in places]
    apart = any(opening is not openings[0] for opening in openings)
    if apart or any(opening.ends_at(places[0], _BORDER) for opening in cut.openings):
        return None
    if openings[0] is None:
        return list(columns)
    return [behind(column, role, openings[0].at) for column in columns]


def behind(crossings: Column, role: Role, at: float) -> Column:
    """The crossings of a column behind a cutting plane, in ascending depth."""
    normal, up = role_plane(role).normal, role_plane(role).looks_up
    cell: Cell | None = crossings[0].before if crossings else None
    for crossing in crossings:
        if crossing.depth > at:
            break
        cell = crossing.after
    kept = [this_crossing for this_crossing in crossings if (this_crossing.depth > at) is up]
    if cell is None:
        return tuple(kept)
    direction: Vector = lifted(normal, 0.0, 0.0, 1.0)
    ends = (None, cell) if up else (cell, None)
    entry = Crossing(at, direction, (CUT, 0), *ends)
    return (entry, *kept) if up else (*kept, entry)


def area_rules(space: CellComplex, cuts: Mapping[Role, Cut]) -> Iterator[Rule]:
    """Rules of hatched and of blank regions of sections."""
    for role, cut in cuts.items():
        if cut.areas is None:
            continue
        shapely.prepare(cut.areas)
        normal = role_plane(role).normal
        for _, point, area in space.planes[normal].trapezoids():
            opening = cut.opening(point)
            if opening is None or opening.ends_at(point, _BORDER):
                continue
            column = behind(space.column(normal, *point), role, opening.at)
            cells = [crossing for crossing in column if crossing.surface[0] == CUT]
            if cells:
                yield _area_rule(cells[0], role, point, area, cut.areas)


def _area_rule(
    entry: Crossing, role: Role, point: Point, area: float, hatched: shapely.Geometry
) -> Rule:
    transition = entry.before, entry.after
    group = Group((), (transition,), (transition,))
    is_hatched = bool(shapely.contains_xy(hatched, *point))
    weight = (_HATCHED if is_hatched else _BLANK) * area**0.5
    return Rule((group,), Linetype.VISIBLE if is_hatched else None, weight, role, point)


def merged(rules: Iterable[Rule]) -> list[Rule]:
    """Rules of which those that say the same are one."""
    found: dict[tuple[object, ...], Rule] = {}
    for rule in rules:
        key = rule.groups, rule.linetype
        known = found.get(key)
        weight = rule.weight + (known.weight if known is not None else 0.0)
        found[key] = Rule(rule.groups, rule.linetype, weight, rule.role, rule.point)
    return list(found.values())
