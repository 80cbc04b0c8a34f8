"""Rings around round holes: countersinks, and chamfered rims, of which the plan shows two circles.

No slab is a cone.  A ring around a hole may therefore be sunk: its surface then falls from its
outer circle to the inner one, at 45 degrees (ISO 15065), as the rim of a countersunk screw does.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from gaussiancad_core.sketch.evidence import HIDDEN
from gaussiancad_core.sketch.plan import Plan
from gaussiancad_core.sketch.regions import OUTSIDE, is_disc
from gaussiancad_core.sketch.terms import Literal, Terms

_CONCENTRIC = 1.2
"""Grid steps between the centres of a ring's circles at most."""

_COST = 0.05
"""What a sunk rim costs, in the root of the ring's area; and a grid step."""


@dataclass(frozen=True)
class Ring:
    """A ring of the plan.

    Attributes:
        region: its number.
        within: numbers of the regions that it encloses.
        around: of those beside it.
        centre: mm.
        outer, inner: mm, radii.
    """

    region: int
    within: tuple[int, ...]
    around: tuple[int, ...]
    centre: tuple[float, float]
    outer: float
    inner: float


@dataclass(frozen=True)
class SunkRim:
    """A ring whose surface is a cone.

    Attributes:
        ring: where.
        is_top: whether it is at the upper end of the ring's material, else at the lower.
    """

    ring: Ring
    is_top: bool


def rings_of(plan: Plan) -> tuple[Ring, ...]:
    """The rings of a plan between two circles about one centre."""
    polygons = plan.regions.polygons
    found = []
    for number, own in enumerate(polygons):
        if len(own.interiors) != 1 or not is_disc(shapely.Polygon(own.exterior)):
            continue
        hole = shapely.Polygon(own.interiors[0])
        around, middle = own.exterior.centroid, hole.centroid
        if not is_disc(hole) or around.distance(middle) > _CONCENTRIC * plan.grid:
            continue
        beside = {
            border.other if border.one == number else border.one
            for border in plan.regions.borders
            if number in (border.one, border.other)
        } - {OUTSIDE}
        within = {k for k in beside if hole.covers(polygons[k].representative_point())}
        outer, inner = (
            float(np.sqrt(area / np.pi)) for area in (shapely.Polygon(own.exterior).area, hole.area)
        )
        centre = float(middle.x), float(middle.y)
        if within:
            rest = tuple(sorted(beside - within))
            found.append(Ring(number, tuple(sorted(within)), rest, centre, outer, inner))
    return tuple(found)


def add_rims(terms: Terms, rings: Sequence[Ring]) -> dict[SunkRim, Literal]:
    """Let rings of a plan be sunk, and their outer circles be drawn then.

    Args:
        terms: of the plan.
        rings: of it.

    Returns:
        Of each end of each ring, whether it is.
    """
    found = {}
    plan = terms.plan
    seen_above, seen_below = plan.is_seen
    for ring in rings:
        for is_top, opened in ((True, terms.tops), (False, terms.bottoms)):
            sunk = terms.model.new_bool_var("")
            found[SunkRim(ring, is_top)] = sunk
            own = sum(opened[ring.region])
            for other in ring.within:
                # What the ring encloses begins deeper.
                terms.model.add(sum(opened[other]) >= own + 1).only_enforce_if(sunk)
            root = float(terms.roots[ring.region])
            terms.cost(_COST * root + plan.grid, sunk)
            for border in plan.regions.borders:
                pair = {border.one, border.other}
                if ring.region not in pair or pair & set(ring.within):
                    continue
                if is_top:
                    drawn = border.visible if seen_above else 0.0
                else:
                    drawn = border.visible_below if seen_below else 0.0
                    # From above the far rim is a hidden circle.
                    if seen_above and plan.draws_hidden:
                        drawn += HIDDEN * border.hidden
                if not drawn:
                    continue
                shown = terms.model.new_bool_var("")
                terms.model.add(shown <= terms.same(opened, border))
                terms.model.add(shown <= sunk)
                terms.cost(-drawn, shown)
    return found
