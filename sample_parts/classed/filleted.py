"""Features and bodies with rounds and fillets along the axes, and pockets with round corners."""

import numpy as np

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.drilled import boss, hole, slot
from sample_parts.classed.flat import FLOOR, groove, notch, profile_body
from sample_parts.classed.outlines import Outline, extruded, rectangle
from sample_parts.classed.placing import Feature, Work, across, place, spread
from sample_parts.classed.stock import BEYOND, CELL, Change, Fill
from sample_parts.modelling import Point2


def round_pocket(work: Work) -> int:
    """A pocket or window with rounded corners; some are tangent, with round ends."""
    extent = work.sized(0.6, 1.8), work.sized(0.5, 1.2)
    site = place(work, extent, lambda site: site.depth >= 2 * FLOOR)
    if site is None:
        return 0
    radius = _corner(work, extent)
    through = site.runs == 1 and site.depth < 1.5 * max(extent) and work.chance(0.4)
    depth = site.depth if through else work.even(FLOOR, min(site.depth - FLOOR, work.scale))
    faces = (8 if through else 9) if radius < min(extent) / 2.0 else 5
    sites = spread(work, site, faces)
    for one in sites:
        outline = rectangle(one.low, one.high, radius)
        bottom = -depth - BEYOND if through else -depth
        work.stock.apply(Change.CUT, extruded(one.axis, outline, *one.span(BEYOND, bottom)))
        work.stock.mark(one.axis, outline, one.span(0.0, -depth), Fill.EMPTY)
    return faces * len(sites)


def _corner(work: Work, extent: Point2) -> float:
    """A radius for a rectangle's corners; half its width in some cases."""
    half = min(extent) / 2.0
    if work.chance(0.3):
        return half
    return float(work.random.integers(2, max(3, int(0.8 * half) + 1)))


def round_pad(work: Work) -> int:
    """A block with rounded vertical edges."""
    extent = work.sized(0.6, 1.6), work.sized(0.5, 1.2)
    site = place(work, extent, lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    radius = _corner(work, extent)
    height = work.sized(0.3, 0.9)
    faces = 9 if radius < min(extent) / 2.0 else 5
    sites = spread(work, site, faces)
    for one in sites:
        outline = rectangle(one.low, one.high, radius)
        work.stock.apply(Change.ADD, extruded(one.axis, outline, *one.span(-CELL, height)))
        work.stock.mark(one.axis, outline, one.span(0.0, height), Fill.FULL)
    return faces * len(sites)


def filleted_rib(work: Work) -> int:
    """A wall right across the part with fillets at its foot and rounds at its top."""
    width = work.sized(0.7, 1.3)
    found = across(work, width, lambda site: site.depth >= FLOOR)
    if found is None:
        return 0
    site, long = found
    foot = float(work.random.integers(2, max(3, int(0.3 * width))))
    thick = width - 2.0 * foot
    height = foot + 2.0 + work.sized(0.2, 0.8)
    first = site.low[1 - long]
    top = float(work.random.choice([0.0, 1.0, 2.0, thick / 2.0 - 0.5]))
    if top >= thick / 2.0 or top + foot > height:
        top = 0.0
    profile = [
        (first, 0.0, 0.0), (first + foot, 0.0, foot), (first + foot, height, top),
        (first + foot + thick, height, top), (first + foot + thick, 0.0, foot),
        (first + width, 0.0, 0.0),
    ]  # fmt: skip
    placed = [(at, site.at(up), radius) for at, up, radius in profile]
    short = _other(site.axis, 1 - long)
    along = _other(site.axis, long)
    ordered = placed if short.value < site.axis.value else [(b, a, r) for a, b, r in placed]
    length = work.stock.size[along.value]
    work.stock.apply(Change.ADD, extruded(along, ordered, 0.0, length))
    work.stock.mark(along, ordered, (0.0, length), Fill.FULL)
    return 6 + 2 * (top > 0.0)


def round_groove(work: Work) -> int:
    """A groove right across the part with a round bottom, or with rounded bottom corners."""
    width = work.sized(0.4, 0.9)
    found = across(work, width, lambda site: site.depth >= 3 * FLOOR)
    if found is None:
        return 0
    site, long = found
    depth = work.even(FLOOR, min(0.6 * site.depth, width))
    radius = width / 2.0
    if depth < radius or work.chance(0.5):
        radius = float(work.random.integers(2, max(3, int(min(depth, 0.45 * width)))))
    first, last = site.low[1 - long], site.high[1 - long]
    profile = [
        (first, BEYOND, 0.0), (first, -depth, radius), (last, -depth, radius), (last, BEYOND, 0.0)
    ]  # fmt: skip
    placed = [(at, site.at(up), corner) for at, up, corner in profile]
    short = _other(site.axis, 1 - long)
    along = _other(site.axis, long)
    ordered = placed if short.value < site.axis.value else [(b, a, r) for a, b, r in placed]
    length = work.stock.size[along.value]
    work.stock.apply(Change.CUT, extruded(along, ordered, -BEYOND, length + BEYOND))
    work.stock.mark(along, ordered, (0.0, length), Fill.EMPTY)
    return 6 if radius < width / 2.0 else 3


def _other(axis: Axis, index: int) -> Axis:
    return [other for other in Axis if other is not axis][index]


def rounded_edge(work: Work) -> int:
    """One edge of the part's box rounded, or hollowed by a quarter of a circle."""
    axis = Axis(int(work.random.integers(3)))
    size = np.delete(np.array(work.stock.size), axis.value)
    radius = work.sized(0.2, 0.7)
    if (radius > 0.4 * size).any():
        return 0
    corner = [float(work.random.integers(2)) * value for value in size.tolist()]
    inward = [1.0 if value == 0.0 else -1.0 for value in corner]
    ends = [corner[index] + inward[index] * radius for index in range(2)]
    lower, upper = np.sort(np.array([corner, ends]), axis=0)
    length = work.stock.size[axis.value]
    low3, high3 = np.insert(lower, axis.value, 0.0), np.insert(upper, axis.value, length)
    if not work.stock.full(tuple(low3.tolist()), tuple(high3.tolist())):
        return 0
    over = [corner[index] - inward[index] * BEYOND for index in range(2)]
    outline = [
        (over[0], over[1], 0.0), (ends[0], over[1], 0.0), (ends[0], corner[1], 0.0),
        (corner[0], corner[1], radius), (corner[0], ends[1], 0.0), (over[0], ends[1], 0.0),
    ]  # fmt: skip
    work.stock.apply(Change.CUT, extruded(axis, outline, -BEYOND, length + BEYOND))
    work.stock.mark(axis, outline, (0.0, length), Fill.EMPTY)
    return 1


FILLETED: tuple[Feature, ...] = (
    round_pocket, round_pocket, round_pad, filleted_rib, round_groove, rounded_edge,
    rounded_edge, hole, slot, boss, groove, notch,
)  # fmt: skip
"""Mostly rounded; a few holes and sharp ones between them."""


def filleted_body(work: Work) -> int:
    """A prism over an outline with rounds at its outer and fillets at its inner corners."""
    axis = Axis(int(work.random.choice(3, p=(0.2, 0.4, 0.4))))
    width, height = (float(value) for value in np.delete(np.array(work.stock.size), axis.value))
    outline = _OUTLINES[int(work.random.integers(len(_OUTLINES)))](work, width, height)
    return profile_body(work, axis, outline)


def _radius(work: Work, most: float) -> float:
    return float(work.random.integers(2, max(3, int(most) + 1)))


def _plate(work: Work, x: float, y: float) -> Outline:
    return rectangle((0.0, 0.0), (x, y), _radius(work, 0.3 * min(x, y)))


def _half_round(work: Work, x: float, y: float) -> Outline:
    corners = rectangle((0.0, 0.0), (x, y))
    radius = _radius(work, 0.45 * min(x, y))
    chosen = work.random.random(4) < 0.5
    chosen[int(work.random.integers(4))] = True
    return [(a, b, radius if one else 0.0) for (a, b, _), one in zip(corners, chosen, strict=True)]


def _angle(work: Work, x: float, y: float) -> Outline:
    leg, floor = work.even(8, 0.35 * x), work.even(8, 0.35 * y)
    inner = _radius(work, 0.3 * min(x, y))
    outer = inner + leg if leg == floor and inner + leg < 0.8 * min(x, y) else 0.0
    return [
        (0, 0, outer), (x, 0, 0), (x, floor, 0), (leg, floor, inner), (leg, y, 0), (0, y, 0)
    ]  # fmt: skip


def _channel(work: Work, x: float, y: float) -> Outline:
    wall, floor = work.even(8, 0.22 * x), work.even(8, 0.4 * y)
    inner, outer = _radius(work, 0.2 * min(x, y)), _radius(work, 0.2 * min(x, y))
    tip = _radius(work, 0.4 * wall) if work.chance(0.4) else 0.0
    return [
        (0, 0, outer), (x, 0, outer), (x, y, tip), (x - wall, y, tip), (x - wall, floor, inner),
        (wall, floor, inner), (wall, y, tip), (0, y, tip),
    ]  # fmt: skip


def _tee(work: Work, x: float, y: float) -> Outline:
    web, floor = work.even(8, 0.3 * x), work.even(8, 0.4 * y)
    left = CELL * np.floor((x - web) / (2.0 * CELL))
    inner = _radius(work, 0.6 * min(left, y - floor))
    return [
        (0, 0, 0), (x, 0, 0), (x, floor, 0), (left + web, floor, inner), (left + web, y, 0),
        (left, y, 0), (left, floor, inner), (0, floor, 0),
    ]  # fmt: skip


def _step(work: Work, x: float, y: float) -> Outline:
    at, low = work.even(0.3 * x, 0.7 * x), work.even(0.3 * y, 0.7 * y)
    most = 0.4 * min(at, x - at, low, y - low)
    inner, outer = _radius(work, most), _radius(work, most)
    return [(0, 0, 0), (x, 0, 0), (x, low, outer), (at, low, inner), (at, y, outer), (0, y, 0)]


_OUTLINES = (_plate, _half_round, _angle, _channel, _tee, _step)
