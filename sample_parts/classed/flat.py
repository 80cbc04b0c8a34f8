"""Features and bodies with planes across the axes only."""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.outlines import extruded, rectangle
from sample_parts.classed.placing import Feature, Work, across, place, spread
from sample_parts.classed.stock import BEYOND, CELL, Change, Fill, Site, Stock
from sample_parts.modelling import Point2, Point3, box

Box = tuple[Point2, Point2]

FLOOR = 4.0
"""mm of material that stay below what is sunk in."""


def pocket(work: Work) -> int:
    """A rectangular pocket, blind or through."""
    extent = work.sized(0.4, 1.6), work.sized(0.3, 1.0)
    site = place(work, extent, lambda site: site.depth >= 2 * FLOOR)
    if site is None:
        return 0
    through = site.runs == 1 and site.depth < 1.5 * max(extent) and work.chance(0.4)
    faces = 4 if through else 5
    depth = site.depth if through else work.even(FLOOR, min(site.depth - FLOOR, work.scale))
    sites = spread(work, site, faces)
    for one in sites:
        sink(work.stock, one, depth, through)
    return faces * len(sites)


def sink(stock: Stock, site: Site, depth: float, through: bool = False) -> None:
    """Cut a site's whole rectangle to a depth."""
    bottom = depth + BEYOND if through else depth
    outline = rectangle(site.low, site.high)
    stock.apply(Change.CUT, extruded(site.axis, outline, *site.span(BEYOND, -bottom)))
    stock.mark(site.axis, outline, site.span(0.0, -depth), Fill.EMPTY)


def pad(work: Work) -> int:
    """A block that stands on the surface."""
    extent = work.sized(0.6, 2.0), work.sized(0.5, 1.4)
    site = place(work, extent, lambda site: site.depth >= FLOOR)
    if site is None:
        return 0
    height = work.sized(0.3, 0.9)
    sites = spread(work, site, 5)
    for one in sites:
        raise_block(work.stock, one, height)
    return 5 * len(sites)


def raise_block(stock: Stock, site: Site, height: float) -> None:
    """Build a block on a site's whole rectangle."""
    outline = rectangle(site.low, site.high)
    # It reaches into the part, so that the two have more than a face in common.
    stock.apply(Change.ADD, extruded(site.axis, outline, *site.span(-CELL, height)))
    stock.mark(site.axis, outline, site.span(0.0, height), Fill.FULL)


def groove(work: Work) -> int:
    """A groove right across the part, or several, as in a rack; sometimes wider at its bottom."""
    width = work.sized(0.3, 0.8)
    found = across(work, width, lambda site: site.depth >= 3 * FLOOR)
    if found is None:
        return 0
    site, long = found
    depth = work.even(FLOOR, min(0.6 * site.depth, 1.2 * width + FLOOR))
    undercut = work.chance(0.25) and depth >= 3 * FLOOR
    if undercut:
        return _tee_slot(work, site, long, depth)
    count = min(int(work.random.choice([1, 1, 2, 3, 5])), max(1, work.wanted // 4))
    pitch = width + work.even(2 * CELL, max(2 * CELL, 0.8 * width))
    made = 0
    for number in range(count):
        low, high = list(site.low), list(site.high)
        low[1 - long] += number * pitch
        high[1 - long] += number * pitch
        walls = (0, 1) if long == 0 else (1, 0)
        low2, high2 = (low[0], low[1]), (high[0], high[1])
        one = work.stock.site(site.axis, site.sign, low2, high2, walls)
        if one is None or one.level != site.level or one.depth < site.depth:
            break
        _mill(work.stock, one, long, depth)
        made += 1
    return 4 * made


def _mill(stock: Stock, site: Site, long: int, depth: float) -> None:
    low, high = list(site.low), list(site.high)
    low[long] -= BEYOND
    high[long] += BEYOND
    outline = rectangle((low[0], low[1]), (high[0], high[1]))
    stock.apply(Change.CUT, extruded(site.axis, outline, *site.span(BEYOND, -depth)))
    stock.mark(site.axis, outline, site.span(0.0, -depth), Fill.EMPTY)


def _tee_slot(work: Work, site: Site, long: int, depth: float) -> int:
    """A groove whose lower half is wider."""
    wide_low, wide_high = list(site.low), list(site.high)
    wide_low[1 - long] -= CELL
    wide_high[1 - long] += CELL
    walls = (0, 1) if long == 0 else (1, 0)
    wide = work.stock.site(
        site.axis, site.sign, (wide_low[0], wide_low[1]), (wide_high[0], wide_high[1]), walls
    )
    if wide is None or wide.depth < depth + FLOOR:
        _mill(work.stock, site, long, depth)
        return 4
    wide_low[long] -= BEYOND
    wide_high[long] += BEYOND
    _mill(work.stock, site, long, depth)
    outline = rectangle((wide_low[0], wide_low[1]), (wide_high[0], wide_high[1]))
    lower = wide.span(-FLOOR, -depth)
    work.stock.apply(Change.CUT, extruded(site.axis, outline, *lower))
    work.stock.mark(site.axis, outline, lower, Fill.EMPTY)
    return 8


def notch(work: Work) -> int:
    """A recess in an edge of the part, open to two or three sides."""
    axis, sign = work.side()
    size = np.delete(np.array(work.stock.size), axis.value)
    edge = int(work.random.integers(2))
    reach, width = work.sized(0.3, 0.8), work.sized(0.4, 1.2)
    if reach > 0.4 * size[edge] or width > 0.6 * size[1 - edge]:
        return 0
    low, high = [0.0, 0.0], [0.0, 0.0]
    low[edge] = 0.0 if work.chance(0.5) else float(size[edge]) - reach
    high[edge] = low[edge] + reach
    corner = work.chance(0.3)
    low[1 - edge] = 0.0 if corner else work.even(2 * CELL, size[1 - edge] - width - 2 * CELL)
    high[1 - edge] = low[1 - edge] + width
    site = work.stock.site(axis, sign, (low[0], low[1]), (high[0], high[1]), (0, 0))
    if site is None or site.depth < 2 * FLOOR:
        return 0
    through = site.runs == 1 and work.chance(0.5)
    depth = site.depth if through else work.even(FLOOR, min(site.depth - FLOOR, work.scale))
    bottom = depth + BEYOND if through else depth
    stretched_low, stretched_high = list(site.low), list(site.high)
    for index in range(2):
        if stretched_low[index] == 0.0:
            stretched_low[index] -= BEYOND
        if stretched_high[index] == size[index]:
            stretched_high[index] += BEYOND
    outline = rectangle(
        (stretched_low[0], stretched_low[1]), (stretched_high[0], stretched_high[1])
    )
    work.stock.apply(Change.CUT, extruded(axis, outline, *site.span(BEYOND, -bottom)))
    work.stock.mark(axis, outline, site.span(0.0, -depth), Fill.EMPTY)
    return (2 if corner else 3) + (0 if through else 1)


FLAT: tuple[Feature, ...] = (pocket, pocket, pocket, pad, groove, groove, notch, notch)
"""What keeps to planes across the axes."""


def flat_body(work: Work) -> int:
    """A block, plate, angle, channel, tee, stair, cross, or a plate with walls; its faces."""
    size = work.stock.size
    kind = int(work.random.integers(8))
    if kind == 0:
        return _boxes(work.stock, [((0.0, 0.0, 0.0), size)], 6)
    if kind == 7:
        return _plate_with_walls(work)
    axis = Axis(int(work.random.choice(3, p=(0.35, 0.5, 0.15))))
    width, height = (float(value) for value in np.delete(np.array(size), axis.value))
    rectangles, faces = _PROFILES[kind - 1](work, width, height)
    length = size[axis.value]
    placed = []
    for (x0, y0), (x1, y1) in rectangles:
        lower, upper = [x0, y0], [x1, y1]
        lower.insert(axis.value, 0.0)
        upper.insert(axis.value, length)
        placed.append((_point(lower), _point(upper)))
    return _boxes(work.stock, placed, faces)


def _boxes(stock: Stock, boxes: list[tuple[Point3, Point3]], faces: int) -> int:
    for lower, upper in boxes:
        stock.apply(Change.ADD, box(lower, upper))
        stock.mark_box(lower, upper, Fill.FULL)
    return faces


def _plate_with_walls(work: Work) -> int:
    """A plate with one or two walls across it."""
    x, y, z = work.stock.size
    floor = work.even(max(6.0, 0.15 * z), 0.35 * z)
    boxes = [((0.0, 0.0, 0.0), (x, y, floor))]
    faces = 6
    for _ in range(int(work.random.integers(1, 3))):
        thick = work.even(6.0, max(8.0, 0.2 * x))
        at = work.even(0.0, x - thick)
        top = work.even(floor + 8.0, z)
        inset = work.even(0.0, 0.2 * y) if work.chance(0.5) else 0.0
        boxes.append(((at, inset, 0.0), (at + thick, y - inset, top)))
        faces += 6
    # The part is as high as its box whatever the chance.
    first, upper = boxes[1]
    boxes[1] = (first, (upper[0], upper[1], z))
    return _boxes(work.stock, boxes, faces)


def _angle(work: Work, x: float, y: float) -> tuple[list[Box], int]:
    leg, floor = work.even(8, 0.4 * x), work.even(8, 0.4 * y)
    return [((0.0, 0.0), (x, floor)), ((0.0, 0.0), (leg, y))], 8


def _channel(work: Work, x: float, y: float) -> tuple[list[Box], int]:
    left, floor = work.even(6, 0.25 * x), work.even(6, 0.4 * y)
    right = left if work.chance(0.7) else work.even(6, 0.25 * x)
    low = y if work.chance(0.6) else work.even(floor + 8, y)
    return [((0.0, 0.0), (x, floor)), ((0.0, 0.0), (left, y)), ((x - right, 0.0), (x, low))], 10


def _tee(work: Work, x: float, y: float) -> tuple[list[Box], int]:
    thick, floor = work.even(8, 0.35 * x), work.even(8, 0.4 * y)
    at = work.even(8, x - thick - 8)
    return [((0.0, 0.0), (x, floor)), ((at, 0.0), (at + thick, y))], 10


def _stair(work: Work, x: float, y: float) -> tuple[list[Box], int]:
    first, second = work.even(0.25 * x, 0.4 * x), work.even(0.55 * x, 0.75 * x)
    low, middle = work.even(0.2 * y, 0.35 * y), work.even(0.5 * y, 0.75 * y)
    return [((0.0, 0.0), (x, low)), ((0.0, 0.0), (second, middle)), ((0.0, 0.0), (first, y))], 10


def _beam(work: Work, x: float, y: float) -> tuple[list[Box], int]:
    floor, lid = work.even(6, 0.3 * y), work.even(6, 0.3 * y)
    web = work.even(8, 0.4 * x)
    at = work.even(4, x - web - 4)
    return [
        ((0.0, 0.0), (x, floor)),
        ((at, 0.0), (at + web, y)),
        ((0.0, y - lid), (x, y)),
    ], 14


def _cross(work: Work, x: float, y: float) -> tuple[list[Box], int]:
    left, right = work.even(6, 0.3 * x), work.even(6, 0.3 * x)
    low, high = work.even(6, 0.3 * y), work.even(6, 0.3 * y)
    return [((left, 0.0), (x - right, y)), ((0.0, low), (x, y - high))], 14


def _point(values: list[float]) -> Point3:
    x, y, z = values
    return x, y, z


_PROFILES = (_angle, _channel, _tee, _stair, _beam, _cross)


def profile_body(work: Work, axis: Axis, outline: Sequence[tuple[float, float, float]]) -> int:
    """An outline across an axis, as long as the stock's box."""
    length = work.stock.size[axis.value]
    work.stock.apply(Change.ADD, extruded(axis, outline, 0.0, length))
    work.stock.mark(axis, outline, (0.0, length), Fill.FULL)
    rounded = sum(radius > 0.0 for *_, radius in outline)
    return len(outline) + rounded + 2
