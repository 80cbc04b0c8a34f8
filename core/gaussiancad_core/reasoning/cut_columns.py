"""What sections say: columns that begin at a plane, and material where they are hatched.

A section shows the part without what stands between the viewer and a plane.  Columns of its view
begin with the plane itself, behind which is the cell that it runs through; what was crossed before
is cut away.  Where the plane meets material the view is hatched (ISO 128-3).
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

import shapely

from gaussiancad_core.axes import Role
from gaussiancad_core.reasoning.columns import Cell, Crossing, Space, Vector
from gaussiancad_core.reasoning.curves import Point
from gaussiancad_core.reasoning.drawn_views import Cut
from gaussiancad_core.reasoning.planes import lifted, role_plane
from gaussiancad_core.reasoning.rules import Group, Rule
from gaussiancad_core.views import Linetype

CUT = 4
"""Number that stands for the normal of a surface that is a cutting plane."""

_HATCHED, _BLANK = 1.0, 0.25
"""Weight of what is hatched or left blank, in units of line for a unit of the side of a square as
large: ribs, shafts and pins are not hatched though they are cut (ISO 128-3)."""


@dataclass(frozen=True)
class CutPlane:
    """A cutting plane in units.

    Attributes:
        at: along the axis that the view looks along.
        areas: what is hatched, in the plane of that axis; None where that is not known.
    """

    at: float
    areas: shapely.Geometry | None = None


def cut_planes(cuts: Mapping[Role, Cut], scale: float) -> dict[Role, CutPlane]:
    """Cuts in units of the planes, ``scale`` to the millimetre."""
    found = {}
    for role, cut in cuts.items():
        signs = role_plane(role).signs
        areas = cut.areas
        if areas is not None:
            factors = (sign * scale for sign in signs)
            areas = shapely.affinity.scale(areas, *factors, origin=(0.0, 0.0))
        found[role] = CutPlane(cut.at * scale, areas)
    return found


def behind(crossings: tuple[Crossing, ...], role: Role, plane: CutPlane) -> tuple[Crossing, ...]:
    """The crossings of a column that a section shows, in ascending depth."""
    normal, up = role_plane(role).normal, role_plane(role).looks_up
    cell: Cell | None = crossings[0].before if crossings else None
    for crossing in crossings:
        if crossing.depth > plane.at:
            break
        cell = crossing.after
    kept = [own for own in crossings if (own.depth > plane.at) is up]
    if cell is None:
        return tuple(kept)
    direction: Vector = lifted(normal, 0.0, 0.0, 1.0)
    ends = (None, cell) if up else (cell, None)
    entry = Crossing(plane.at, direction, (CUT, 0), *ends)
    return (entry, *kept) if up else (*kept, entry)


def area_rules(space: Space, planes: Mapping[Role, CutPlane]) -> Iterator[Rule]:
    """Rules of hatched and of blank regions of sections."""
    for role, plane in planes.items():
        if plane.areas is None:
            continue
        shapely.prepare(plane.areas)
        normal = role_plane(role).normal
        for _, point, area in space.planes[normal].trapezoids():
            column = behind(space.column(normal, *point), role, plane)
            cells = [own for own in column if own.surface[0] == CUT]
            if cells:
                yield _area_rule(cells[0], role, point, area, plane.areas)


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
