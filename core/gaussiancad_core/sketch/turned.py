"""Turned parts: outlines that slope are made steps first, and the solid is turned down last.

Seen from beside, the outline of a turned part is its profile.  Slabs are cylinders: where the
outline slopes, they reach out to its larger end, and what lies beyond the profile is taken away
from the solid of the slabs at the end.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.planes import IN_PLANE, role_plane
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine, profile_along
from gaussiancad_core.sketch.regions import find_regions
from gaussiancad_core.solid.profiles import Profile

_NEAR = 1.5
"""Grid steps within which places are one."""

_STRAIGHT = 0.4
"""Grid steps by which a line along an axis may lean."""

_LEAST = 1.0
"""Grid steps that an outline slopes by at least, along either coordinate."""

_Lines = Mapping[Role, Sequence[PlaneLine]]


@dataclass(frozen=True, eq=False)
class Envelope:
    """What a turned part lies within.

    Attributes:
        centre: mm in the plane across the axis.
        area: mm along the axis, and away from it.
        lines: along which its outline runs.
    """

    centre: tuple[float, float]
    area: shapely.Polygon
    lines: tuple[PlaneLine, ...]

    def profile(self, grid: float) -> Profile:
        """Its area with the arcs along which its outline runs.

        Args:
            grid: mm of a step of the sheet's coordinates.
        """
        return profile_along(self.area, self.lines, grid)


def without_slopes(
    lines: _Lines, axis: Axis, size: Sequence[float], grid: float
) -> tuple[dict[Role, list[PlaneLine]], Envelope | None]:
    """Views of a turned part with steps in place of what slopes, and its envelope; the lines as
    they are and None where it is none, or nothing slopes.

    Args:
        lines: of each view, mm in its plane.
        axis: that the part may be turned about.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
    """
    found = {role: list(own) for role, own in lines.items()}
    centre = _centre(lines, axis, size, grid)
    if centre is None:
        return found, None
    halves = []
    slopes: list[_Slope] = []
    for role, own in lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if axis.value not in axes:
            continue
        along = axes.index(axis.value)
        middle = centre[IN_PLANE[axis].index(axes[1 - along])]
        told = _outline(own, grid)
        if told is None:
            continue
        outline, closed = told
        found[role], sloping = _stepped(own, outline, (along, middle), grid)
        slopes += sloping
        halves += [_half(closed, outline, (along, middle), side) for side in (1.0, -1.0)]
    known = [own for own in halves if own is not None]
    if not slopes or not known:
        return {role: list(own) for role, own in lines.items()}, None
    area, profile = max(known, key=lambda own: own[0].area)
    for role, own in found.items():
        if role_plane(role).normal is axis:
            found[role] = [each for each in own if not _is_foot(each, centre, slopes, grid)]
    return found, Envelope(centre, area, profile)


@dataclass(frozen=True)
class _Slope:
    """A sloping piece of an outline, whose smaller end is no end of a cylinder.

    Attributes:
        radius: mm, of the smaller end; None where a cylinder ends there.
    """

    radius: float | None


def _centre(
    lines: _Lines, axis: Axis, size: Sequence[float], grid: float
) -> tuple[float, float] | None:
    """Where a circle as wide as the part is drawn."""
    first, second = (size[k] for k in IN_PLANE[axis])
    if abs(first - second) > _NEAR * grid:
        return None
    for role, own in lines.items():
        if role_plane(role).normal is not axis:
            continue
        for each in own:
            if not each.is_closed or each.circle is None:
                continue
            off = max(abs(each.circle.centre[k] - first / 2.0) for k in (0, 1))
            if max(off, abs(each.circle.radius - first / 2.0)) <= _NEAR * grid:
                return each.circle.centre
    return None


def _outline(
    lines: Sequence[PlaneLine], grid: float
) -> tuple[shapely.Polygon, tuple[PlaneLine, ...]] | None:
    """What a view shows, without holes, and its lines, made to meet; None where it is in pieces."""
    regions = find_regions([own for own in lines if own.is_visible], (), grid)
    whole = shapely.union_all(regions.polygons)
    if whole.geom_type != "Polygon":
        return None
    return shapely.Polygon(whole.exterior), regions.lines


def _stepped(
    lines: Sequence[PlaneLine],
    outline: shapely.Polygon,
    coordinates: tuple[int, float],
    grid: float,
) -> tuple[list[PlaneLine], list[_Slope]]:
    """Lines of a view with two in place of each that slopes along its outline on both sides of the
    axis, and these."""
    along, middle = coordinates
    near = _NEAR * grid
    border = outline.boundary
    sloping = [
        own
        for own in lines
        if own.is_visible
        and not own.is_closed
        and np.ptp(own.points, axis=0).min() > _LEAST * grid
        and border.distance(shapely.Point(own.points[len(own.points) // 2])) <= near
    ]
    even = [own for own in sloping if _has_image(own, sloping, coordinates, near)]
    ends = [own.points[[0, -1]] for own in lines]
    found = [own for own in lines if not any(own is other for other in even)]
    slopes = []
    gone: set[int] = set()
    for own in even:
        far = sorted(own.points[[0, -1]].tolist(), key=lambda at: abs(at[1 - along] - middle))
        small, large = (np.array(at) for at in far)
        corner = small.copy()
        corner[1 - along] = large[1 - along]
        found += [
            PlaneLine(np.array([a, b]), True)
            for a, b in ((small, corner), (corner, large))
            if float(np.hypot(*(b - a))) > _STRAIGHT * grid
        ]

        def at(place: Floats, constant: int) -> list[int]:
            return [
                k
                for k, other in enumerate(lines)
                if other.is_visible
                and other.constant(_STRAIGHT * grid) == constant
                and np.hypot(*(ends[k] - place).T).min() <= near
            ]

        is_cylinder = bool(at(small, 1 - along))
        slopes.append(_Slope(None if is_cylinder else abs(float(small[1 - along]) - middle)))
        if at(large, 1 - along):
            # Where a cylinder goes on the step has no edge.
            gone |= {id(lines[k]) for k in at(large, along)}
    return [own for own in found if id(own) not in gone], slopes


def _has_image(
    line: PlaneLine, others: Sequence[PlaneLine], coordinates: tuple[int, float], near: float
) -> bool:
    along, middle = coordinates
    image = line.points[[0, -1]].copy()
    image[:, 1 - along] = 2.0 * middle - image[:, 1 - along]
    return any(
        min(np.hypot(*(other.points[[0, -1]] - own).T).max() for own in (image, image[::-1]))
        <= near
        for other in others
    )


def _half(
    lines: Sequence[PlaneLine],
    outline: shapely.Polygon,
    coordinates: tuple[int, float],
    side: float,
) -> tuple[shapely.Polygon, tuple[PlaneLine, ...]] | None:
    """The profile on one side of the axis, and the lines it may run along."""
    along, middle = coordinates
    moved = tuple(_moved(own, along, middle, side) for own in lines)
    points = _away(np.array(outline.exterior.coords), along, middle, side)
    low, high = points[:, 0].min(), points[:, 0].max()
    area = shapely.Polygon(points).buffer(0.0)
    area = area.intersection(shapely.box(low, 0.0, high, points[:, 1].max() + 1.0))
    return (area, moved) if area.geom_type == "Polygon" and not area.is_empty else None


def _away(points: Floats, along: int, middle: float, side: float) -> Floats:
    """Points as places along the axis, and away from it."""
    return np.stack([points[:, along], side * (points[:, 1 - along] - middle)], axis=1)


def _moved(line: PlaneLine, along: int, middle: float, side: float) -> PlaneLine:
    circle = line.circle
    if circle is not None:
        x, y = _away(np.array([circle.centre]), along, middle, side)[0].tolist()
        circle = replace(circle, centre=(x, y))
    return replace(line, points=_away(line.points, along, middle, side), circle=circle)


def _is_foot(
    line: PlaneLine, centre: tuple[float, float], slopes: Sequence[_Slope], grid: float
) -> bool:
    """Whether a circle of the plan is the smaller end of a slope only."""
    if line.circle is None or not line.is_closed:
        return False
    near = _NEAR * grid
    if max(abs(a - b) for a, b in zip(line.circle.centre, centre, strict=True)) > near:
        return False
    radii = [own.radius for own in slopes if own.radius is not None]
    return any(abs(line.circle.radius - own) <= near for own in radii)
