"""Turned parts and turned features: shafts, flanges, countersinks, domes, ring grooves."""

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.drilled import boss, disc, hole
from sample_parts.classed.flat import FLOOR, flat_body, groove, pocket
from sample_parts.classed.outlines import Corner, extruded, rectangle, turned
from sample_parts.classed.placing import Feature, Work, place, spread
from sample_parts.classed.stock import BEYOND, CELL, Change, Fill, Site
from sample_parts.modelling import Point2, cylinder


def _turn(work: Work, site: Site, profile: list[Corner], change: Change) -> None:
    """Turn a profile of (height above the surface, radius, rounding) at a site's middle."""
    placed = [(site.at(height), radius, rounding) for height, radius, rounding in profile]
    work.stock.apply(change, turned(site.axis, site.centre, placed))
    heights = [height for height, *_ in profile]
    span = site.span(max(0.0, min(heights)) if change is Change.ADD else min(heights), max(heights))
    radius = max(radius for _, radius, _ in profile)
    fill = Fill.FULL if change is Change.ADD else Fill.EMPTY
    work.stock.mark(site.axis, disc(site.centre, radius), span, Fill.MIXED)
    least = min(radius for height, radius, _ in profile if radius > 0.0)
    if change is Change.CUT:
        inner = min(heights), max(heights)
        work.stock.mark(site.axis, disc(site.centre, least), site.span(*inner), fill)


def countersunk_hole(work: Work) -> int:
    """A hole with a conical mouth, or a blind one with a drill's point."""
    radius = work.sized(0.2, 0.5) / 2.0 + 1.0
    wider = radius + float(work.random.integers(1, max(2, int(0.8 * radius)) + 1))
    sink = work.chance(0.65)
    reach = CELL * np.ceil(wider / CELL) if sink else CELL * np.ceil(radius / CELL)
    least = wider - radius + 2 * FLOOR
    site = place(work, (2.0 * reach, 2.0 * reach), lambda site: site.depth >= least)
    if site is None:
        return 0
    tip = radius * float(work.random.choice([1.0, 0.577]))
    blind = not sink or site.runs != 1 or work.chance(0.3)
    depth = work.even(FLOOR, min(site.depth - FLOOR - tip, 5.0 * radius))
    if depth + tip > site.depth - 2.0 and blind:
        return 0
    sites = spread(work, site, 3 if blind else 2)
    for one in sites:
        profile: list[Corner] = [(BEYOND, 0.0, 0.0)]
        if sink:
            profile += [(BEYOND, wider, 0.0), (0.0, wider, 0.0), (radius - wider, radius, 0.0)]
        else:
            profile.append((BEYOND, radius, 0.0))
        if blind:
            bottom = max(depth, wider - radius + 2.0) if sink else depth
            profile += [(-bottom, radius, 0.0), (-bottom - tip, 0.0, 0.0)]
        else:
            profile += [(-one.depth - BEYOND, radius, 0.0), (-one.depth - BEYOND, 0.0, 0.0)]
        _turn(work, one, profile, Change.CUT)
    return (1 + sink + blind) * len(sites)


def turned_boss(work: Work) -> int:
    """A boss that is conical, domed, chamfered, or has a round foot or rim."""
    radius = work.sized(0.5, 1.1) / 2.0 + 3.0
    reach = CELL * np.ceil((radius + 4.0) / CELL)
    site = place(work, (2.0 * reach, 2.0 * reach), lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    height = float(np.ceil(radius / 2.0)) + work.sized(0.3, 0.9)
    kind = int(work.random.integers(5))
    bevel = float(work.random.integers(1, 1 + max(1, int(0.4 * radius))))
    profiles: list[list[Corner]] = [
        [(0.0, radius, 0.0), (height, radius - bevel, 0.0), (height, 0.0, 0.0)],
        [(0.0, radius, 0.0), (height - bevel, radius, 0.0), (height, radius - bevel, 0.0),
         (height, 0.0, 0.0)],
        [(0.0, radius + 3.0, 0.0), (0.0, radius, 3.0), (height, radius, 0.0), (height, 0.0, 0.0)],
        [(0.0, radius, 0.0), (height, radius, bevel), (height, 0.0, 0.0)],
        [(0.0, radius, 0.0), (height, radius, radius), (height, 0.0, 0.0)],
    ]  # fmt: skip
    if kind == 4:
        height = max(height, radius + 2.0)
        profiles[4] = [(0.0, radius, 0.0), (height, radius, radius), (height, 0.0, 0.0)]
    sites = spread(work, site, 3)
    for one in sites:
        profile = [(0.0, 0.0, 0.0), *profiles[kind]]
        _turn(work, one, profile, Change.ADD)
        if kind == 1 and radius - bevel > 4.0 and work.chance(0.5):
            _turn(
                work,
                one,
                [
                    (height + BEYOND, 0.0, 0.0), (height + BEYOND, 2.0, 0.0), (FLOOR, 2.0, 0.0),
                    (FLOOR, 0.0, 0.0),
                ],
                Change.CUT,
            )  # fmt: skip
    return (2 + (kind in (1, 2, 3))) * len(sites)


def ring_groove(work: Work) -> int:
    """A groove around a circle: rectangular, half round, or with slanted walls."""
    inner = work.sized(0.3, 0.8)
    width = float(work.random.integers(2, 6))
    reach = CELL * np.ceil((inner + width) / CELL)
    site = place(work, (2.0 * reach, 2.0 * reach), lambda site: site.depth >= 2 * FLOOR + width)
    if site is None:
        return 0
    outer = inner + width
    kind = int(work.random.integers(3))
    depth = float(work.random.integers(2, 5))
    profile: list[Corner] = [(BEYOND, inner, 0.0), (BEYOND, outer, 0.0)]
    if kind == 0:
        profile += [(-depth, outer, 0.0), (-depth, inner, 0.0)]
    elif kind == 1:
        profile += [(-width, outer, width / 2.0), (-width, inner, width / 2.0)]
    else:
        depth = width / 2.0
        profile += [(0.0, outer, 0.0), (-depth, inner + width / 2.0, 0.0), (0.0, inner, 0.0)]
    placed = [(site.at(height), radius, rounding) for height, radius, rounding in profile]
    work.stock.apply(Change.CUT, turned(site.axis, site.centre, placed))
    deepest = -min(height for height, *_ in profile)
    span = site.span(0.0, -deepest)
    work.stock.mark(site.axis, disc(site.centre, outer), span, Fill.MIXED)
    work.stock.mark(site.axis, disc(site.centre, inner), span, Fill.FULL)
    return 4 if kind == 0 else 4 if kind == 1 else 3


def round_recess(work: Work) -> int:
    """A spherical recess, as for a ball."""
    radius = work.sized(0.3, 0.8)
    site = place(work, (2.0 * radius, 2.0 * radius), lambda site: site.depth >= radius + FLOOR)
    if site is None:
        return 0
    sites = spread(work, site, 1)
    for one in sites:
        profile = [
            (BEYOND, 0.0, 0.0), (BEYOND, radius, 0.0), (-radius, radius, radius),
            (-radius, 0.0, 0.0),
        ]  # fmt: skip
        _turn(work, one, profile, Change.CUT)
    return 2 * len(sites)


TURNED: tuple[Feature, ...] = (
    countersunk_hole, countersunk_hole, countersunk_hole, turned_boss, turned_boss, turned_boss,
    ring_groove, ring_groove, round_recess, hole, boss, pocket, groove,
)  # fmt: skip
"""Turned features on prismatic parts."""


def shaft(work: Work) -> int:
    """A turned part along an axis: steps, chamfers, grooves, rounds, a ball end; some are bored."""
    axis = Axis(int(work.random.integers(3)))
    middle = 40.0
    profile: list[Corner] = []
    steps: list[tuple[float, float, float]] = []
    at, radius = 0.0, work.even(10, 34)
    faces = 2
    number = int(np.clip(work.wanted // 4, 1, 24))
    while len(steps) < number and faces < work.wanted:
        length = work.even(10, 30)
        shape = int(work.random.integers(6))
        size = float(work.random.integers(1, 4))
        before = steps[-1][2] if steps else 0.0
        profile.extend(_segment((at, at + length), radius, before, shape, size))
        faces += (2, 3, 5, 3, 3, 4)[shape]
        steps.append((at, at + length, radius))
        at += length
        following = work.even(8, 36)
        radius = following if following != radius else radius + 4.0
    last = steps[-1][2]
    if work.chance(0.25):
        at += last
        profile += [(at, last, last)]
    profile = [(0.0, 0.0, 0.0), *profile, (at, 0.0, 0.0)]
    work.stock.apply(Change.ADD, turned(axis, (middle, middle), profile))
    return faces + _shaft_details(work, axis, (middle, middle), steps)


def _segment(
    span: tuple[float, float], radius: float, before: float, shape: int, size: float
) -> list[Corner]:
    """Corners of one step of a shaft; the next one starts where it ends.

    Args:
        span: mm along the axis.
        radius: of the step, and ``before`` that of the one before it.
        before: see ``radius``.
        shape: plain, chamfered, grooved, conical, rounded or with a V groove.
        size: mm of that detail.
    """
    at, end = span
    length = end - at
    if shape == 1:
        return [(at, radius - size, 0.0), (at + size, radius, 0.0), (end, radius, 0.0)]
    if shape == 2:
        first, last = at + 0.3 * length, at + 0.3 * length + size
        return [
            (at, radius, 0.0), (first, radius, 0.0), (first, radius - 2.0, 0.0),
            (last, radius - 2.0, 0.0), (last, radius, 0.0), (end, radius, 0.0),
        ]  # fmt: skip
    if shape == 3:
        return [(at, radius, 0.0), (end, radius - 0.25 * min(radius, length), 0.0)]
    if shape == 4:
        # Where the step rises the round is its rim.
        rounding = size if radius - before > size + 1.0 else 0.0
        return [(at, radius, rounding), (end, radius, 0.0)]
    if shape == 5:
        middle = at + length / 2.0
        return [
            (at, radius, 0.0), (middle - size - 1.0, radius, 0.0),
            (middle, radius - size - 1.0, 0.0), (middle + size + 1.0, radius, 0.0),
            (end, radius, 0.0),
        ]  # fmt: skip
    return [(at, radius, 0.0), (end, radius, 0.0)]


def _shaft_details(
    work: Work, axis: Axis, centre: Point2, steps: list[tuple[float, float, float]]
) -> int:
    """A bore, a keyway, a cross hole or flats on a shaft; the faces that they add."""
    faces = 0
    low, high, radius = max(steps, key=lambda step: step[1] - step[0])
    thinnest = min(radius for *_, radius in steps)
    if work.chance(0.35) and thinnest >= 8.0:
        bore = float(work.random.integers(2, int(0.55 * thinnest)))
        deep = float(work.random.integers(8, 8 + int(steps[-1][1])))
        profile = [
            (-BEYOND, 0.0, 0.0), (-BEYOND, bore, 0.0), (deep, bore, 0.0), (deep + bore, 0.0, 0.0)
        ]  # fmt: skip
        work.stock.apply(Change.CUT, turned(axis, centre, profile))
        faces += 2
    kind = work.random.random()
    if high - low < 14.0 or radius < 8.0 or kind > 0.8:
        return faces
    upward = [other for other in Axis if other is not axis][int(work.random.integers(2))]
    if kind < 0.35:
        tool = _keyway(axis, upward, centre, (low, high), radius)
        faces += 5
    elif kind < 0.55:
        cross = float(np.ceil(0.2 * min(radius, high - low)))
        at = _ordered(axis, upward, ((low + high) / 2.0, centre[0]))
        tool = cylinder(upward, at, cross, -100.0, 200.0)
        faces += 1
    else:
        tool = _flat_side(axis, upward, centre, (low, high), radius)
        faces += 3
    work.stock.apply(Change.CUT, tool)
    return faces


def _keyway(
    axis: Axis, upward: Axis, centre: Point2, span: tuple[float, float], radius: float
) -> TopoDS_Shape:
    """A slot with round ends, sunk into a step from above."""
    half = float(np.ceil(0.2 * radius))
    low = _ordered(axis, upward, (span[0] + 2.0, centre[0] - half))
    high = _ordered(axis, upward, (span[1] - 2.0, centre[0] + half))
    floor = centre[0] + float(np.floor(0.6 * radius))
    return extruded(upward, rectangle(low, high, half), floor, centre[0] + 2.0 * radius)


def _flat_side(
    axis: Axis, upward: Axis, centre: Point2, span: tuple[float, float], radius: float
) -> TopoDS_Shape:
    """What a cutter takes from a step to leave a flat."""
    low = _ordered(axis, upward, (span[0] + 2.0, centre[0] - 2.0 * radius))
    high = _ordered(axis, upward, (span[1] - 2.0, centre[0] + 2.0 * radius))
    floor = centre[0] + float(np.floor(0.75 * radius))
    return extruded(upward, rectangle(low, high), floor, centre[0] + 2.0 * radius)


def _ordered(axis: Axis, upward: Axis, flat: Point2) -> Point2:
    """(along an axis, across it) in the order of the plane across ``upward``."""
    third = next(other for other in Axis if other not in (axis, upward))
    return flat if axis.value < third.value else (flat[1], flat[0])


def turned_body(work: Work) -> int:
    """A turned part, or a flat body that gets turned features."""
    return shaft(work) if work.chance(0.5) else flat_body(work)
