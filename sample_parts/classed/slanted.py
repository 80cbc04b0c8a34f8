"""Features and bodies with planes that are slanted in one view: wedges, chamfers, dovetails."""

import numpy as np

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.drilled import hole
from sample_parts.classed.flat import (
    FLOOR,
    flat_body,
    groove,
    notch,
    pocket,
    profile_body,
)
from sample_parts.classed.outlines import Outline, extruded, frustum, regular, sharp
from sample_parts.classed.placing import Feature, Work, across, place, spread
from sample_parts.classed.stock import BEYOND, CELL, Change, Fill, Site
from sample_parts.modelling import Point2


def chamfer(work: Work) -> int:
    """One edge of the part's box cut off, at 45 degrees or at another angle."""
    axis = Axis(int(work.random.integers(3)))
    size = np.delete(np.array(work.stock.size), axis.value)
    legs = [work.sized(0.2, 0.7)] * 2
    if work.chance(0.4):
        legs[1] = work.sized(0.2, 0.9)
    if (np.array(legs) > 0.4 * size).any():
        return 0
    corner = [float(work.random.integers(2)) * value for value in size.tolist()]
    inward = [1.0 if value == 0.0 else -1.0 for value in corner]
    ends = [corner[index] + inward[index] * legs[index] for index in range(2)]
    lower, upper = np.sort(np.array([corner, ends]), axis=0)
    length = work.stock.size[axis.value]
    low3, high3 = np.insert(lower, axis.value, 0.0), np.insert(upper, axis.value, length)
    if not work.stock.full(tuple(low3.tolist()), tuple(high3.tolist())):
        return 0
    # The tool reaches beyond the edge, along the same slant.
    over = [corner[index] - inward[index] * legs[index] * 0.2 for index in range(2)]
    tips = [ends[index] + inward[index] * legs[index] * 0.2 for index in range(2)]
    outline = sharp([(over[0], over[1]), (tips[0], over[1]), (over[0], tips[1])])
    work.stock.apply(Change.CUT, extruded(axis, outline, -BEYOND, length + BEYOND))
    work.stock.mark(axis, outline, (0.0, length), Fill.EMPTY)
    return 1


def vee_groove(work: Work) -> int:
    """A V groove, a trapezoid groove or a dovetail right across the part."""
    width = work.sized(0.5, 1.1)
    found = across(work, width, lambda site: site.depth >= 3 * FLOOR)
    if found is None:
        return 0
    site, long = found
    depth = work.even(FLOOR, min(0.6 * site.depth, width))
    kind = work.random.random()
    slope = 1.0 if kind < 0.35 else -0.5 if kind < 0.7 else 0.5
    first, last = site.low[1 - long], site.high[1 - long]
    run = min(depth * abs(slope), 0.35 * width)
    if kind < 0.35:
        middle = (first + last) / 2.0
        profile = [(first, 0.0), (middle, -depth), (last, 0.0)]
    elif slope < 0.0:
        profile = [(first + run, 0.0), (first, -depth), (last, -depth), (last - run, 0.0)]
    else:
        profile = [(first, 0.0), (first + run, -depth), (last - run, -depth), (last, 0.0)]
    _plane_strip(work, site, long, profile, Change.CUT)
    return len(profile)


def ridge(work: Work) -> int:
    """A ridge right across the part: a roof, a trapezoid or a dovetail."""
    width = work.sized(0.6, 1.1)
    found = across(work, width, lambda site: site.depth >= FLOOR)
    if found is None:
        return 0
    site, long = found
    height = work.sized(0.3, 0.7)
    first, last = site.low[1 - long], site.high[1 - long]
    run = work.even(CELL, 0.35 * width)
    profile = [(first, 0.0), (first + run, height), (last - run, height), (last, 0.0)]
    if work.chance(0.4):
        profile = [(first, 0.0), (first, height), (last - run, height), (last, 0.0)]
    _plane_strip(work, site, long, profile, Change.ADD)
    return 5


def _plane_strip(work: Work, site: Site, long: int, profile: list[Point2], change: Change) -> None:
    """Sweep a profile of (place across the strip, height above the surface) along the strip."""
    other = _flat_axes(site.axis)[long]
    flat = [(place, site.at(height)) for place, height in profile]
    if change is Change.CUT:
        # Prolonged upwards, so that the tool leaves no skin.
        flat = [flat[0], *flat[1:], flat[-1]]
        flat.insert(0, (profile[0][0], site.at(BEYOND)))
        flat.append((profile[-1][0], site.at(BEYOND)))
    else:
        flat.insert(0, (profile[0][0], site.at(-CELL)))
        flat.append((profile[-1][0], site.at(-CELL)))
    # The plane across the strip has the site's axis and the short one, in the order x, y, z.
    short = _flat_axes(site.axis)[1 - long]
    ordered = flat if short.value < site.axis.value else [(b, a) for a, b in flat]
    length = work.stock.size[other.value]
    reach = BEYOND if change is Change.CUT else 0.0
    work.stock.apply(change, extruded(other, sharp(ordered), -reach, length + reach))
    fill = Fill.EMPTY if change is Change.CUT else Fill.FULL
    work.stock.mark(other, sharp(ordered), (0.0, length), fill)


def _flat_axes(axis: Axis) -> tuple[Axis, Axis]:
    first, second = (other for other in Axis if other is not axis)
    return first, second


def tapered_pad(work: Work) -> int:
    """A block with slanted sides, one to four of them, or a pocket of that form."""
    extent = work.sized(0.6, 1.4), work.sized(0.6, 1.2)
    sunk = work.chance(0.4)
    site = place(work, extent, lambda site: site.depth >= (3 * FLOOR if sunk else FLOOR))
    if site is None:
        return 0
    height = work.even(FLOOR, min(site.depth - FLOOR, work.scale)) if sunk else work.sized(0.3, 0.8)
    runs = [work.even(CELL, 0.3 * min(extent)) * work.chance(0.6) for _ in range(4)]
    if not any(runs):
        runs[0] = CELL
    sites = spread(work, site, 5)
    for one in sites:
        _taper(work, one, runs, height, sunk)
    return 5 * len(sites)


def _taper(work: Work, site: Site, runs: list[float], height: float, sunk: bool) -> None:
    """A block or pocket whose far end is smaller by a run at each side."""
    (x0, y0), (x1, y1) = site.low, site.high
    # Continued into the air of a pocket, or into the material under a block, along its slants.
    more = CELL / height
    near = _shrunk((x0, y0, x1, y1), [-run * more for run in runs])
    far = _shrunk((x0, y0, x1, y1), runs)
    sign = -1.0 if sunk else 1.0
    ends = site.at(-sign * CELL), site.at(sign * height)
    change = Change.CUT if sunk else Change.ADD
    work.stock.apply(change, frustum(site.axis, near, far, ends))
    fill = Fill.EMPTY if sunk else Fill.FULL
    span = site.span(0.0, sign * height)
    work.stock.mark(site.axis, sharp(_shrunk((x0, y0, x1, y1), [0.0] * 4)), span, Fill.MIXED)
    work.stock.mark(site.axis, sharp(far), span, fill)


def _shrunk(sides: tuple[float, float, float, float], runs: list[float]) -> list[Point2]:
    x0, y0, x1, y1 = sides
    x0, y0, x1, y1 = x0 + runs[0], y0 + runs[1], x1 - runs[2], y1 - runs[3]
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def polygon_feature(work: Work) -> int:
    """A hexagon, octagon, rhomb or triangle: a boss, a socket or a window."""
    radius = work.sized(0.5, 1.0)
    number, first = [(6, 0.0), (6, np.pi / 2.0), (8, np.pi / 8.0), (4, 0.0), (3, 0.0)][
        int(work.random.integers(5))
    ]
    sunk = work.chance(0.65)
    site = place(
        work, (2.0 * radius, 2.0 * radius), lambda site: site.depth >= (2 * FLOOR if sunk else 4.0)
    )
    if site is None:
        return 0
    through = sunk and site.runs == 1 and work.chance(0.5)
    depth = work.even(FLOOR, min(max(site.depth - FLOOR, FLOOR), work.scale))
    span = (BEYOND, -site.depth - BEYOND) if through else (BEYOND, -depth)
    if not sunk:
        span = (-CELL, depth)
    sites = spread(work, site, number + 1)
    for one in sites:
        outline = regular(one.centre, radius, number, float(first))
        change = Change.CUT if sunk else Change.ADD
        start, end = one.span(*span)
        work.stock.apply(change, extruded(one.axis, outline, start, end))
        work.stock.mark(one.axis, outline, (start, end), Fill.EMPTY if sunk else Fill.FULL)
    return (number + (0 if through else 1)) * len(sites)


SLANTED: tuple[Feature, ...] = (
    chamfer, chamfer, chamfer, vee_groove, vee_groove, ridge, ridge, tapered_pad, tapered_pad,
    polygon_feature, polygon_feature, pocket, groove, notch, hole,
)  # fmt: skip
"""Mostly slanted; a few flat ones and holes between them."""


def slanted_body(work: Work) -> int:
    """A prism over a slanted outline, or a flat body with ribs."""
    if work.chance(0.2):
        return flat_body(work)
    axis = Axis(int(work.random.choice(3, p=(0.3, 0.5, 0.2))))
    width, height = (float(value) for value in np.delete(np.array(work.stock.size), axis.value))
    outline = _OUTLINES[int(work.random.integers(len(_OUTLINES)))](work, width, height)
    return profile_body(work, axis, outline)


def _wedge(work: Work, x: float, y: float) -> Outline:
    top, side = work.even(0.15 * x, 0.6 * x), work.even(0.15 * y, 0.6 * y)
    return sharp([(0, 0), (x, 0), (x, side), (top, y), (0, y)])


def _roof(work: Work, x: float, y: float) -> Outline:
    eaves, left = work.even(0.3 * y, 0.7 * y), work.even(0.15 * x, 0.4 * x)
    return sharp([(0, 0), (x, 0), (x, eaves), (x - left, y), (left, y), (0, eaves)])


def _ribbed_angle(work: Work, x: float, y: float) -> Outline:
    leg, floor = work.even(8, 0.3 * x), work.even(8, 0.3 * y)
    foot, head = work.even(leg + 4, 0.7 * x), work.even(floor + 4, 0.7 * y)
    return sharp([(0, 0), (x, 0), (x, floor), (foot, floor), (leg, head), (leg, y), (0, y)])


def _chamfered_channel(work: Work, x: float, y: float) -> Outline:
    wall, floor, bevel = work.even(10, 0.25 * x), work.even(8, 0.35 * y), work.even(4, 0.12 * x)
    return sharp(
        [
            (bevel, 0), (x - bevel, 0), (x, bevel), (x, y), (x - wall, y),
            (x - wall - bevel, floor), (wall + bevel, floor), (wall, y), (0, y), (0, bevel),
        ]
    )  # fmt: skip


def _dovetail(work: Work, x: float, y: float) -> Outline:
    depth, run = work.even(0.25 * y, 0.5 * y), work.even(4, 0.12 * x)
    left, right = work.even(0.2 * x, 0.35 * x), x - work.even(0.2 * x, 0.35 * x)
    bottom = y - depth
    return sharp(
        [
            (0, 0), (x, 0), (x, y), (right - run, y), (right, bottom), (left, bottom),
            (left + run, y), (0, y),
        ]
    )  # fmt: skip


def _vee_block(work: Work, x: float, y: float) -> Outline:
    wing, depth = work.even(4, 0.2 * x), work.even(0.3 * y, 0.6 * y)
    return sharp([(0, 0), (x, 0), (x, y), (x - wing, y), (x / 2, y - depth), (wing, y), (0, y)])


def _bevelled(work: Work, x: float, y: float) -> Outline:
    bevels = [work.even(4, 0.3 * min(x, y)) for _ in range(4)]
    a, b, c, d = bevels if work.chance(0.5) else [bevels[0]] * 4
    return sharp([(a, 0), (x - b, 0), (x, b), (x, y - c), (x - c, y), (d, y), (0, y - d), (0, a)])


_OUTLINES = (_wedge, _roof, _ribbed_angle, _chamfered_channel, _dovetail, _vee_block, _bevelled)
