"""Features and bodies with planes that no principal view sees edge-on."""

import numpy as np

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.drilled import hole
from sample_parts.classed.flat import FLOOR, flat_body, groove, notch, pocket
from sample_parts.classed.outlines import (
    convex,
    extruded,
    frustum,
    rectangle,
    regular,
    sharp,
)
from sample_parts.classed.placing import Feature, Work, place, spread
from sample_parts.classed.stock import CELL, Change, Fill, Site
from sample_parts.modelling import Point2, Point3


def corner_cut(work: Work) -> int:
    """One or two corners of the part's box cut off by a plane."""
    size = np.array(work.stock.size)
    legs = np.array([work.sized(0.4, 1.2) for _ in range(3)])
    if work.chance(0.3):
        legs[:] = legs.min()
    if (legs > 0.45 * size).any():
        return 0
    corner = work.random.integers(2, size=3)
    corners = [corner]
    if work.chance(0.6) and work.wanted > 1:
        other = corner.copy()
        other[int(work.random.integers(3))] ^= 1
        corners.append(other)
    made = 0
    for which in corners:
        tip = which * size
        inward = np.where(which == 0, 1.0, -1.0)
        lower, upper = np.sort(np.stack([tip, tip + inward * legs]), axis=0)
        if not work.stock.full(tuple(lower.tolist()), tuple(upper.tolist())):
            continue
        # Twice the tetrahedron, so that its other planes lie outside the part.
        far = tip - inward * legs
        points = [tuple(far.tolist())]
        for index in range(3):
            point = far.copy()
            point[index] = tip[index] + 3.0 * inward[index] * legs[index]
            points.append(tuple(point.tolist()))
        work.stock.apply(Change.CUT, convex(points))
        work.stock.mark_box(tuple(lower.tolist()), tuple(upper.tolist()), Fill.MIXED)
        made += 1
    return made


def tapered_polygon(work: Work) -> int:
    """A tapered hexagon, octagon or rhomb: a boss, a pyramid's stump or a socket."""
    radius = work.sized(0.5, 1.1)
    number, first = [(6, 0.0), (6, np.pi / 2.0), (8, np.pi / 8.0), (4, 0.0), (3, 0.0)][
        int(work.random.integers(5))
    ]
    sunk = work.chance(0.4)
    least = 3 * FLOOR if sunk else FLOOR
    site = place(work, (2.0 * radius, 2.0 * radius), lambda site: site.depth >= least)
    if site is None:
        return 0
    height = work.even(FLOOR, min(site.depth - FLOOR, work.scale)) if sunk else work.sized(0.4, 1.0)
    far = radius * float(work.random.choice([0.5, 0.6, 0.75]))
    sites = spread(work, site, number + 1)
    for one in sites:
        _stump(work, one, (radius, far), (number, float(first)), height * (-1.0 if sunk else 1.0))
    return (number + 1) * len(sites)


def _stump(
    work: Work, site: Site, radii: tuple[float, float], form: tuple[int, float], height: float
) -> None:
    """A tapered polygon of a signed height on a site."""
    # Continued by a cell on the other side of the surface, along its slants.
    near = radii[0] + (radii[0] - radii[1]) * CELL / abs(height)
    ends = site.at(-np.sign(height) * CELL), site.at(height)
    polygons = [
        [(x, y) for x, y, _ in regular(site.centre, radius, *form)] for radius in (near, radii[1])
    ]
    change, fill = (Change.CUT, Fill.EMPTY) if height < 0.0 else (Change.ADD, Fill.FULL)
    work.stock.apply(change, frustum(site.axis, polygons[0], polygons[1], ends))
    span = site.span(0.0, height)
    work.stock.mark(site.axis, regular(site.centre, radii[0], *form), span, Fill.MIXED)
    work.stock.mark(site.axis, sharp(polygons[1]), span, fill)


def turned_stump(work: Work) -> int:
    """A block whose top is a smaller rhomb, or a roof that leans: many oblique faces."""
    extent = work.sized(0.8, 1.6), work.sized(0.8, 1.4)
    site = place(work, extent, lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    height = work.sized(0.4, 0.9)
    sites = spread(work, site, 9)
    inset = [work.even(CELL, 0.3 * value) for value in extent]
    for one in sites:
        (x0, y0), (x1, y1) = one.low, one.high
        cx, cy = one.centre
        top: list[Point2] = [(x0 + inset[0], cy), (cx, y0 + inset[1]), (x1 - inset[0], cy),
                             (cx, y1 - inset[1])]  # fmt: skip
        lower: list[Point2] = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        work.stock.apply(Change.ADD, frustum(one.axis, lower, top, (one.at(0.0), one.at(height))))
        span = one.span(0.0, height)
        work.stock.mark(one.axis, sharp(lower), span, Fill.MIXED)
        work.stock.mark(one.axis, sharp(top), span, Fill.FULL)
    return 9 * len(sites)


def clipped_block(work: Work) -> int:
    """A block with one to four of its upper corners cut off."""
    extent = work.sized(0.7, 1.6), work.sized(0.6, 1.3)
    site = place(work, extent, lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    height = work.sized(0.5, 1.2)
    legs = [work.even(CELL, 0.45 * value) for value in (*extent, height)]
    clipped = work.random.random(4) < 0.6
    clipped[int(work.random.integers(4))] = True
    faces = 5 + int(clipped.sum())
    sites = spread(work, site, faces)
    for one in sites:
        corners = [(x, y) for x in (one.low[0], one.high[0]) for y in (one.low[1], one.high[1])]
        points = [(*corner, one.at(0.0)) for corner in corners]
        for corner, cut in zip(corners, clipped, strict=True):
            inward = np.sign(np.array(one.centre) - corner)
            if not cut:
                points.append((*corner, one.at(height)))
                continue
            points += [
                (corner[0] + inward[0] * legs[0], corner[1], one.at(height)),
                (corner[0], corner[1] + inward[1] * legs[1], one.at(height)),
                (*corner, one.at(height - legs[2])),
            ]
        work.stock.apply(Change.ADD, convex([_placed(one.axis, point) for point in points]))
        work.stock.mark(one.axis, rectangle(one.low, one.high), one.span(0.0, height), Fill.MIXED)
    return faces * len(sites)


def _placed(axis: Axis, point: tuple[float, float, float]) -> Point3:
    """(across, across, along) an axis as a point of the model."""
    coordinates = [float(point[0]), float(point[1])]
    coordinates.insert(axis.value, float(point[2]))
    x, y, z = coordinates
    return x, y, z


OBLIQUE: tuple[Feature, ...] = (
    corner_cut, corner_cut, corner_cut, tapered_polygon, tapered_polygon, turned_stump,
    clipped_block, clipped_block, pocket, groove, notch, hole,
)  # fmt: skip
"""Mostly oblique; a few flat ones and holes between them."""


def oblique_body(work: Work) -> int:
    """A flat body, or a tapered polygonal one."""
    if work.chance(0.65):
        return flat_body(work)
    stock = work.stock
    x, y, z = stock.size
    number = int(work.random.choice([5, 6, 8]))
    radius = min(x, y) / 2.0
    centre = (radius, radius)
    waist = work.even(0.2 * z, 0.6 * z)
    lower = [(a, b) for a, b, _ in regular(centre, radius, number)]
    upper = [(a, b) for a, b, _ in regular(centre, 0.7 * radius, number)]
    stock.apply(Change.ADD, extruded(Axis.Z, sharp(lower), 0.0, waist))
    stock.apply(Change.ADD, frustum(Axis.Z, lower, upper, (waist, z)))
    stock.mark(Axis.Z, sharp(lower), (0.0, z), Fill.MIXED)
    stock.mark(Axis.Z, sharp(lower), (0.0, waist), Fill.FULL)
    stock.mark(Axis.Z, sharp(upper), (0.0, z), Fill.FULL)
    return 2 * number + 2
