"""Features and bodies with cylinders along the axes: holes, slots, bosses, discs, links."""

import numpy as np

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.flat import FLOOR, flat_body, groove, notch, pocket
from sample_parts.classed.outlines import extruded, rectangle
from sample_parts.classed.placing import Feature, Work, place, spread
from sample_parts.classed.stock import BEYOND, CELL, Change, Fill, Site, Stock
from sample_parts.modelling import Point2, cylinder


def drill(stock: Stock, site: Site, radius: float, span: tuple[float, float]) -> None:
    """Cut a round hole in a site's middle, between two heights above its surface."""
    start, end = site.span(*span)
    stock.apply(Change.CUT, cylinder(site.axis, site.centre, radius, start, end))
    stock.mark(site.axis, disc(site.centre, radius), (start, end), Fill.EMPTY)


def disc(centre: Point2, radius: float) -> list[tuple[float, float, float]]:
    """A circle as an outline: good for the map, not to extrude (it has four arcs)."""
    low = centre[0] - radius, centre[1] - radius
    high = centre[0] + radius, centre[1] + radius
    return rectangle(low, high, radius)


def hole(work: Work) -> int:
    """A drilled hole, blind or through, or a counterbored one."""
    radius = work.sized(0.2, 0.6) / 2.0 + (1.0 if work.chance(0.3) else 0.0)
    wider = radius + work.sized(0.1, 0.3) if work.chance(0.3) else radius
    site = place(work, (2.0 * wider, 2.0 * wider), lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    through = site.runs > 0 and site.depth < 12.0 * radius and work.chance(0.75)
    if not through and site.depth < 2 * FLOOR:
        return 0
    faces = (site.runs if through else 2) + (2 if wider > radius else 0)
    depth = work.even(FLOOR, min(site.depth - FLOOR, 6.0 * radius))
    bottom = -_beyond(work.stock, site) if through else -depth
    sites = spread(work, site, faces)
    for one in sites:
        drill(work.stock, one, radius, (BEYOND, bottom))
        if wider > radius:
            flat = min(depth, 0.5 * one.depth)
            drill(work.stock, one, wider, (BEYOND, -CELL * max(1.0, flat // (2 * CELL))))
    return faces * len(sites)


def _beyond(stock: Stock, site: Site) -> float:
    """Depth at which a tool has left the part, bosses on its far side included."""
    far = site.level if site.sign > 0 else stock.size[site.axis.value] - site.level
    return far + 60.0


def slot(work: Work) -> int:
    """A slot with round ends, blind or through."""
    width = work.sized(0.25, 0.6)
    extent = width + work.sized(0.4, 1.2), width
    site = place(work, extent, lambda site: site.depth >= 2 * FLOOR)
    if site is None:
        return 0
    through = site.runs == 1 and site.depth < 4.0 * width and work.chance(0.55)
    depth = site.depth if through else work.even(FLOOR, min(site.depth - FLOOR, work.scale))
    sites = spread(work, site, 5)
    for one in sites:
        outline = rectangle(one.low, one.high, width / 2.0)
        bottom = -depth - BEYOND if through else -depth
        work.stock.apply(Change.CUT, extruded(one.axis, outline, *one.span(BEYOND, bottom)))
        work.stock.mark(one.axis, outline, one.span(0.0, -depth), Fill.EMPTY)
    return (4 if through else 5) * len(sites)


def boss(work: Work) -> int:
    """A round boss, mostly bored."""
    radius = work.sized(0.5, 1.1) / 2.0 + 2.0
    site = place(work, (2.0 * radius, 2.0 * radius), lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    height = work.sized(0.3, 1.0)
    bored, through = work.chance(0.7), site.runs == 1 and work.chance(0.6)
    bore = max(2.0, radius - work.sized(0.1, 0.4))
    if bore >= radius - 1.5:
        bored = False
    sites = spread(work, site, 4)
    for one in sites:
        start, end = one.span(-CELL, height)
        work.stock.apply(Change.ADD, cylinder(one.axis, one.centre, radius, start, end))
        work.stock.mark(one.axis, disc(one.centre, radius), one.span(0.0, height), Fill.FULL)
    for one in sites if bored else ():
        bottom = -one.depth - BEYOND if through else CELL - height
        drill(work.stock, one, bore, (height + BEYOND, bottom))
    return (2 + (0 if not bored else 1 if through else 2)) * len(sites)


def bolt_circle(work: Work) -> int:
    """Holes evenly on a circle, on a flat place, often around a bore."""
    radius = work.sized(0.15, 0.3) / 2.0 + 1.0
    number = int(work.random.choice([3, 4, 5, 6, 8]))
    pitch = max(work.sized(0.6, 1.4), number * 1.1 * radius)
    reach = CELL * np.ceil((pitch + radius) / CELL)
    site = place(work, (2.0 * reach, 2.0 * reach), lambda site: site.runs == 1)
    if site is None:
        return 0
    centre = np.array(site.centre)
    first = 0.0 if work.chance(0.6) else np.pi / number
    for angle in first + 2.0 * np.pi * np.arange(number) / number:
        x, y = (centre + pitch * np.array([np.cos(angle), np.sin(angle)])).tolist()
        start, end = site.span(BEYOND, -site.depth - BEYOND)
        work.stock.apply(Change.CUT, cylinder(site.axis, (x, y), radius, start, end))
        work.stock.mark(site.axis, disc((x, y), radius), (start, end), Fill.EMPTY)
    bore = CELL * np.floor((pitch - 2.5 * radius) / CELL)
    if bore >= 4.0 and work.chance(0.6):
        drill(work.stock, site, float(bore), (BEYOND, -site.depth - BEYOND))
        return number + 1
    return number


DRILLED: tuple[Feature, ...] = (
    hole, hole, hole, slot, slot, boss, boss, bolt_circle, pocket, groove, notch,
)  # fmt: skip
"""Mostly round, as milled and drilled parts are."""


def drilled_body(work: Work) -> int:
    """A flat body, a disc with or without a hub, or a link."""
    kind = work.random.random()
    if kind < 0.6:
        return flat_body(work)
    if kind < 0.8:
        return _flange(work)
    return _link(work)


def _flange(work: Work) -> int:
    """A disc, often with a hub; it fills a square box."""
    axis, radius, length = _round_box(work)
    centre = (radius, radius)
    thick = length if work.chance(0.4) else work.even(0.3 * length, 0.6 * length)
    work.stock.apply(Change.ADD, cylinder(axis, centre, radius, 0.0, thick))
    work.stock.mark(axis, disc(centre, radius), (0.0, thick), Fill.FULL)
    if thick == length:
        return 3
    hub = work.even(0.35 * radius, 0.6 * radius)
    work.stock.apply(Change.ADD, cylinder(axis, centre, hub, thick - CELL, length))
    work.stock.mark(axis, disc(centre, hub), (thick, length), Fill.FULL)
    return 5


def _round_box(work: Work) -> tuple[Axis, float, float]:
    """An axis, the radius around the box's corner-free middle, and the length along the axis."""
    lengths = np.array(work.stock.size)
    axis = Axis(int(lengths.argmin()))
    radius = CELL * np.floor(np.delete(lengths, axis.value).min() / (2.0 * CELL))
    return axis, float(radius), float(lengths[axis.value])


def _link(work: Work) -> int:
    """A bar with round ends, with an eye at each."""
    lengths = np.array(work.stock.size)
    axis = Axis(int(lengths.argmin()))
    flat = np.delete(lengths, axis.value)
    radius = float(flat.min()) / 2.0
    if flat.max() < 2.6 * radius:
        return _flange(work)
    thick = float(lengths[axis.value])
    outline = rectangle((0.0, 0.0), (float(flat[0]), float(flat[1])), radius)
    work.stock.apply(Change.ADD, extruded(axis, outline, 0.0, thick))
    work.stock.mark(axis, outline, (0.0, thick), Fill.FULL)
    long = int(flat.argmax())
    for end in (radius, float(flat[long]) - radius):
        centre = [radius, radius]
        centre[long] = end
        eye = work.even(0.35 * radius, 0.6 * radius)
        at = (centre[0], centre[1])
        work.stock.apply(Change.CUT, cylinder(axis, at, eye, -BEYOND, thick + BEYOND))
        work.stock.mark(axis, disc(at, eye), (0.0, thick), Fill.EMPTY)
    return 8
