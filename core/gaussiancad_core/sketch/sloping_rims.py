"""What the plan shows of surfaces that slope: countersinks as rings, and edge breaks as bands.

No slab is a cone.  A ring around a hole may therefore be sunk: its surface then falls from its
outer circle to the inner one, at 45 degrees (ISO 15065), as the rim of a countersunk screw does.
And a band as narrow as an edge break may be the bevel of what it runs along.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from gaussiancad_core.coordinates.grid_tolerances import NEAR
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sketch.line_costs import HIDDEN
from gaussiancad_core.sketch.plan_regions import OUTSIDE, is_disc
from gaussiancad_core.sketch.slab_plan import Plan
from gaussiancad_core.sketch.slab_terms import Literal, Terms

_COST = 0.05
"""What a sunk rim costs, in the root of the ring's area; and a grid step."""


@dataclass(frozen=True)
class Ring:
    """A ring of the plan.

    Attributes:
        region: its number.
        within: numbers of the regions that it encloses.
        centre: mm.
        outer, inner: mm, radii.
    """

    region: int
    within: tuple[int, ...]
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
    for number, polygon in enumerate(polygons):
        if number in plan.regions.bands or len(polygon.interiors) != 1:
            continue
        if not is_disc(shapely.Polygon(polygon.exterior)):
            continue
        hole = shapely.Polygon(polygon.interiors[0])
        around, middle = polygon.exterior.centroid, hole.centroid
        if not is_disc(hole) or around.distance(middle) > NEAR * plan.grid:
            continue
        neighbours = {
            border.other if border.one == number else border.one
            for border in plan.regions.borders
            if number in (border.one, border.other)
        } - {OUTSIDE}
        within = {k for k in neighbours if hole.covers(polygons[k].representative_point())}
        outer, inner = (_circle_of(ring, plan) for ring in (polygon.exterior, polygon.interiors[0]))
        if within and outer is not None and inner is not None:
            sizes = outer.radius, inner.radius
            found.append(Ring(number, tuple(sorted(within)), inner.centre, *sizes))
    return tuple(found)


def _circle_of(ring: shapely.LinearRing, plan: Plan) -> Circle | None:
    """The circle of the plan's lines along which a round ring runs."""
    middle, radius = ring.centroid, ring.length / (2.0 * np.pi)

    def away(curve: Circle) -> float:
        off = float(np.hypot(curve.centre[0] - middle.x, curve.centre[1] - middle.y))
        return max(off, abs(curve.radius - radius))

    circles = [line.circle for line in plan.regions.lines if line.circle is not None]
    nearest = min(circles, key=away, default=None)
    return nearest if nearest is not None and away(nearest) <= NEAR * plan.grid else None


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
            item = sum(opened[ring.region])
            for other in ring.within:
                # What the ring encloses begins deeper.
                terms.model.add(sum(opened[other]) >= item + 1).only_enforce_if(sunk)
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


def add_bands(terms: Terms) -> None:
    """Let bands as narrow as an edge break be a bevel of what they run along on one side, whose
    border is drawn then; borders of bands with each other are mitres.

    Args:
        terms: of the plan.
    """
    plan = terms.plan
    bands = set(plan.regions.bands)
    sides: dict[tuple[int, int], Literal] = {}
    for is_top, opened in ((True, terms.tops), (False, terms.bottoms)):
        for border in plan.regions.borders:
            pair = {border.one, border.other}
            drawn = border.visible if is_top else border.visible_below
            if OUTSIDE in pair or not pair & bands or not drawn:
                continue
            same = terms.same(opened, border)
            if pair <= bands:
                terms.cost(-drawn, same)
                continue
            (band,), (other,) = pair & bands, pair - bands
            if (band, other) not in sides:
                sides[band, other] = terms.model.new_bool_var("")
                terms.cost(plan.grid, sides[band, other])
            shown = terms.model.new_bool_var("")
            terms.model.add(shown <= same)
            terms.model.add(shown <= sides[band, other])
            terms.cost(-drawn, shown)
    for band in bands:
        int_vars = [side for (number, _), side in sides.items() if number == band]
        if int_vars:
            terms.model.add_at_most_one(int_vars)
