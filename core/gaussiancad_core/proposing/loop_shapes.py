"""The closed areas of a plane that a feature may have as its section."""

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.proposing.lines_by_plane import ROUND, Circle, PlaneLine, PlaneSheet
from gaussiancad_core.proposing.plane_loops import (
    Loop,
    LoopKind,
    PlaneLoops,
    areas_between,
    stretched,
)

_QUARTER = 1.5
"""Radians of a circle that are drawn at least for its disc to count."""

_SAME_CIRCLE = 3.0
"""Tolerances within which two circles are one."""

_LARGE = 0.04
"""Share of the outline's area from which everything around a loop may be cut off."""

_MARGIN = 0.05
"""Share of the longest extent by which what is around a loop reaches beyond the part."""

_ONCE = 8.0
"""Tolerances within which two areas are one: by width, place and a tenth of the outline."""

_ON_OUTLINE = 2.0
"""Tolerances within which a line runs along the outline."""


def loops_of(sheet: PlaneSheet, plane: PlaneLoops) -> tuple[Loop, ...]:
    """The closed areas of a plane, each once, the outline first."""
    found = [(plane.outline, LoopKind.OUTLINE)]
    found += [(region, LoopKind.REGION) for region in plane.regions]
    found += [
        (shapely.Polygon(region.exterior), LoopKind.FILLED)
        for region in plane.regions
        if region.interiors
    ]
    found += [(area, LoopKind.REGION) for area in _by_view(sheet, plane)]
    found += _by_linetype(sheet, plane)
    circles = [*_circles(sheet, plane), *_noted_circles(sheet, plane.axis)]
    discs = [_disc(circle, sheet.tolerance) for circle in circles]
    found += [(disc, LoopKind.CIRCLE) for disc in discs]
    outer = [
        shapely.Polygon(area.exterior)
        for area, kind in found
        if kind in (LoopKind.REGION, LoopKind.SEEN)
    ]
    found += [(area, LoopKind.AROUND) for area in _around(discs + outer, sheet, plane)]
    return tuple(_each_once(found, sheet, plane))


def _by_view(sheet: PlaneSheet, plane: PlaneLoops) -> Iterator[shapely.Polygon]:
    """What the lines of each view enclose by themselves, where several look along the axis: a
    section has lines of what is hidden, or gone, in a plain view."""
    views = [view for view in sheet.views if view.axis is plane.axis and view.lines]
    for view in views if len(views) > 1 else ():
        curves = stretched(view.lines, plane.stretch, sheet.tolerance)
        yield from areas_between([each for each in curves if not each.is_empty], sheet.tolerance)


def _by_linetype(
    sheet: PlaneSheet, plane: PlaneLoops
) -> Iterator[tuple[shapely.Polygon, LoopKind]]:
    """What visible lines enclose by themselves, and hidden ones with the outline."""
    lines = sheet.lines(plane.axis)
    visible = [line for line in lines if line.is_visible]
    hidden = [line for line in lines if not line.is_visible]
    if not visible or not hidden:
        return
    around = [line for line in visible if _is_on_outline(line, sheet, plane)]
    for kind, chosen in ((LoopKind.SEEN, visible), (LoopKind.BEHIND, hidden + around)):
        curves = stretched(chosen, plane.stretch, sheet.tolerance)
        areas = areas_between([curve for curve in curves if not curve.is_empty], sheet.tolerance)
        yield from ((area, kind) for area in areas)
        yield from ((shapely.Polygon(area.exterior), kind) for area in areas if area.interiors)


def _is_on_outline(line: PlaneLine, sheet: PlaneSheet, plane: PlaneLoops) -> bool:
    middle = line.points[len(line.points) // 2] if len(line.points) > 2 else line.points.mean(0)
    away = plane.outline.exterior.distance(shapely.Point(middle))
    return bool(away < _ON_OUTLINE * sheet.tolerance)


def _circles(sheet: PlaneSheet, plane: PlaneLoops) -> Iterator[Circle]:
    """Circles of which enough is drawn."""
    found: list[tuple[Circle, list[float]]] = []
    for line in sheet.lines(plane.axis):
        if line.circle is None:
            continue
        sweep = line.length / line.circle[2]
        for circle, sweeps in found:
            apart = np.abs(np.subtract(circle, line.circle)).max()
            if apart < _SAME_CIRCLE * sheet.tolerance:
                sweeps.append(sweep)
                break
        else:
            found.append((line.circle, [sweep]))
    yield from (circle for circle, sweeps in found if sum(sweeps) > _QUARTER)


def _noted_circles(sheet: PlaneSheet, axis: Axis) -> Iterator[Circle]:
    """Circles of holes of which notes speak: not all are drawn."""
    for hole in sheet.holes:
        if hole.axis is axis:
            yield from ((*hole.centre, step.diameter / 2.0) for step in hole.steps)


def _disc(circle: Circle, tolerance: float) -> shapely.Polygon:
    x, y, radius = circle
    angles = np.linspace(0.0, 2.0 * np.pi, ROUND + 1)[:-1]
    points = np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=1)
    return shapely.set_precision(shapely.Polygon(points), tolerance / 2.0)


def _around(
    areas: Sequence[shapely.Polygon], sheet: PlaneSheet, plane: PlaneLoops
) -> Iterator[shapely.Polygon]:
    margin = _MARGIN * sheet.longest
    x0, y0, x1, y1 = plane.outline.bounds
    box = shapely.box(x0 - margin, y0 - margin, x1 + margin, y1 + margin)
    for area in areas:
        if area.area > _LARGE * plane.outline.area:
            yield shapely.Polygon(box.exterior, [area.exterior])


def _each_once(
    found: Sequence[tuple[shapely.Polygon, LoopKind]], sheet: PlaneSheet, plane: PlaneLoops
) -> Iterator[Loop]:
    known = np.zeros((0, 4))
    for area, kind in found:
        if area.is_empty or area.geom_type != "Polygon":
            continue
        middle = area.centroid
        row = np.array([[area.area / area.length, middle.x, middle.y, area.length / 10.0]])
        apart = np.abs(known - row).max(axis=1) if len(known) else np.array([np.inf])
        if kind is LoopKind.OUTLINE or apart.min() > _ONCE * sheet.tolerance:
            known = np.vstack([known, row])
            yield plane.loop(area, kind)
