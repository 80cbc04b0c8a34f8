"""Features of a planned part: prisms of closed areas, turned profiles, and patterns of prisms."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.feature_kernels import (
    MOST,
    Crossed,
    Operation,
    Table,
    across,
    across_turned,
    combine,
    inside,
)
from gaussiancad_core.proposing.lines_by_plane import Circle, Floats
from gaussiancad_core.proposing.plane_loops import Loop, Numbers


@dataclass(frozen=True, eq=False)
class Sights:
    """Lines of sight of a view.

    Attributes:
        number: of the view.
        axis: that it looks along.
        places: (n, 2) mm in the plane across.
    """

    number: int
    axis: Axis
    places: Floats


@dataclass(frozen=True, eq=False)
class Prism:
    """A closed area between two places along its axis.

    Attributes:
        loop: the area.
        low, high: mm.
        ends: numbers of the planes there.
    """

    loop: Loop
    low: float
    high: float
    ends: tuple[int, int]

    @property
    def axis(self) -> Axis:
        """Along which it runs."""
        return self.loop.axis

    @property
    def volume(self) -> float:
        """mm^3."""
        return float(self.loop.polygon.area * (self.high - self.low))

    @cached_property
    def box(self) -> Floats:
        """(2, 3) mm, its least and its greatest corner."""
        return _boxed(self.axis, self.loop.polygon.bounds, (self.low, self.high))

    def table(self, sights: Sights) -> Table:
        """What lines of sight cross of it."""
        found = self.loop.tables.get(sights.number)
        if found is None:
            found = self.loop.tables[sights.number] = loop_table(self.loop, sights)
        return between(found, self)


@dataclass(frozen=True, eq=False)
class Turned:
    """A profile turned about an axis.

    Attributes:
        axis: of the turn.
        centre: (2,) mm in the plane across.
        edges: (m, 4) radius and height of the profile's corners, from and to, closed.
        surfaces: (m,) numbers of the surfaces behind its edges.
        circles: (m) the circle, in radius and height, that an edge is a chord of; None of others.
        tables: of each view, as far as anybody asked.
    """

    axis: Axis
    centre: tuple[float, float]
    edges: Floats
    surfaces: Numbers
    circles: tuple[Circle | None, ...]
    tables: dict[Any, Any] = field(default_factory=dict)

    @property
    def low(self) -> float:
        """mm along the axis."""
        return float(self.edges[:, [1, 3]].min())

    @property
    def high(self) -> float:
        """mm along the axis."""
        return float(self.edges[:, [1, 3]].max())

    @property
    def radius(self) -> float:
        """mm, the largest."""
        return float(self.edges[:, [0, 2]].max())

    @property
    def volume(self) -> float:
        """mm^3."""
        r, z, s, w = self.edges.T
        return float(abs(np.pi / 3.0 * ((w - z) * (r * r + r * s + s * s)).sum()))

    @cached_property
    def box(self) -> Floats:
        """(2, 3) mm, its least and its greatest corner."""
        (a, b), r = self.centre, self.radius
        return _boxed(self.axis, (a - r, b - r, a + r, b + r), (self.low, self.high))

    def table(self, sights: Sights) -> Table:
        """What lines of sight cross of it."""
        found = self.tables.get(sights.number)
        if found is None:
            found = self.tables[sights.number] = self._table(sights)
        return found

    def _table(self, sights: Sights) -> Table:
        places, centre = sights.places, np.array(self.centre)
        if sights.axis is self.axis:
            radii = np.hypot(*(places - centre).T)
            near = np.flatnonzero(radii < self.radius)
            count, depth, surface = across(self.edges, self.surfaces, radii[near], 1)
        else:
            along = IN_PLANE[sights.axis].index(self.axis.value)
            off_axis = places[:, 1 - along] - centre[_column(self.axis, sights.axis, along)]
            height = places[:, along]
            near = np.flatnonzero(
                (np.abs(off_axis) < self.radius) & (height > self.low) & (height < self.high)
            )
            count, depth, surface = across_turned(
                self.edges, self.surfaces, height[near], off_axis[near]
            )
            depth = depth + centre[IN_PLANE[self.axis].index(sights.axis.value)]
        met = count > 0
        return _always(near[met], count[met], depth[met], surface[met])


@dataclass(frozen=True, eq=False)
class Pattern:
    """Equal prisms, or equal turned profiles, as one feature.

    Attributes:
        parts: that do not touch each other.
        tables: of each view, as far as anybody asked.
    """

    parts: tuple[Prism, ...] | tuple[Turned, ...]
    tables: dict[Any, Any] = field(default_factory=dict)

    @property
    def volume(self) -> float:
        """mm^3."""
        return sum(part.volume for part in self.parts)

    @cached_property
    def box(self) -> Floats:
        """(2, 3) mm, its least and its greatest corner."""
        boxes = np.array([part.box for part in self.parts])
        return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])

    def table(self, sights: Sights) -> Table:
        """What lines of sight cross of it."""
        found = self.tables.get(sights.number)
        if found is None:
            found = self.tables[sights.number] = self._table(sights)
        return found

    def _table(self, sights: Sights) -> Table:
        crossed = nothing_crossed(len(sights.places))
        for part in self.parts:
            combine(crossed, part.table(sights), np.array([int(Operation.ADD)]), 0.0)
        met = np.flatnonzero(crossed.counts)
        return _always(met, crossed.counts[met], crossed.depth[met], crossed.surface[met])


Feature = Prism | Turned | Pattern


def single_features(feature: Feature) -> tuple[Prism | Turned, ...]:
    """A feature, or those of a pattern."""
    return feature.parts if isinstance(feature, Pattern) else (feature,)


def nothing_crossed(count: int) -> Crossed:
    """What so many lines of sight cross of nothing."""
    return Crossed(
        np.zeros(count, np.int64), np.zeros((count, MOST)), np.zeros((count, MOST), np.int64)
    )


def loop_table(loop: Loop, sights: Sights) -> Table:
    """What lines of sight cross of a prism of an area, whatever its places."""
    places = sights.places
    if sights.axis is loop.axis:
        x0, y0, x1, y1 = loop.polygon.bounds
        x, y = places.T
        near = np.flatnonzero((x > x0) & (x < x1) & (y > y0) & (y < y1))
        rows = near[inside(loop.edges, x[near], y[near])]
        none = np.zeros((1, 2))
        table = _always(rows, np.zeros(1, np.int64), none, none.astype(np.int64))
        return table._replace(where=np.zeros(len(rows), np.int64), is_along=True)
    along = IN_PLANE[sights.axis].index(loop.axis.value)
    column = _column(loop.axis, sights.axis, along)
    fixed = places[:, 1 - along]
    low, high = loop.edges[:, [column, column + 2]].min(), loop.edges[:, [column, column + 2]].max()
    near = np.flatnonzero((fixed > low) & (fixed < high))
    values, where = np.unique(fixed[near], return_inverse=True)
    count, depth, surface = across(loop.edges, loop.surfaces, values, 1 - column)
    met = count[where] > 0
    rows = near[met]
    heights = np.ascontiguousarray(places[rows, along])
    table = _always(rows, count, depth, surface)
    return table._replace(where=where[met], at=heights)


def between(table: Table, prism: Prism) -> Table:
    """The table of a prism's area, for the prism between its places."""
    if not table.is_along:
        return table._replace(low=prism.low, high=prism.high)
    depth, surface = np.array([[prism.low, prism.high]]), np.array([prism.ends], np.int64)
    return table._replace(counts=np.array([2]), depth=depth, surface=surface)


def every_sight(loop: Loop, sights: Sights) -> tuple[Table, npt.NDArray[np.bool_]]:
    """The table of an area with a row for each line of sight of a view, and (n,) which of them pass
    through it where the view looks along it."""
    table, count = loop_table(loop, sights), len(sights.places)
    is_inside = np.zeros(count, bool)
    is_inside[table.rows] = True
    if table.is_along:
        rows, none = np.arange(count), np.zeros(count, np.int64)
        return table._replace(rows=rows, where=none, at=np.zeros(count)), is_inside
    # One more row for what does not cross it.
    where = np.full(count, len(table.counts))
    where[table.rows] = table.where
    counts, depth, surface = (
        np.concatenate([each, np.zeros((1, *each.shape[1:]), each.dtype)])
        for each in (table.counts, table.depth, table.surface)
    )
    along = IN_PLANE[sights.axis].index(loop.axis.value)
    at = np.ascontiguousarray(sights.places[:, along])
    full = table._replace(rows=np.arange(count), where=where, counts=counts)
    return full._replace(depth=depth, surface=surface, at=at), is_inside


def _always(rows: Numbers, count: Numbers, depth: Floats, surface: Numbers) -> Table:
    """A table all of whose rows count, whatever the places."""
    where, at = np.arange(len(rows)), np.zeros(len(rows))
    return Table(rows, where, count, depth, surface, at, -1.0, 1.0, False)


def _boxed(
    axis: Axis, sides: tuple[float, float, float, float], along: tuple[float, float]
) -> Floats:
    x0, y0, x1, y1 = sides
    first, second = IN_PLANE[axis]
    box = np.zeros((2, 3))
    box[:, first], box[:, second], box[:, axis.value] = (x0, x1), (y0, y1), along
    return box


def _column(axis: Axis, look: Axis, along: int) -> int:
    """Which coordinate of the plane across an axis a view along another one keeps.

    Args:
        axis: of the feature.
        look: that the view looks along.
        along: which of the view's coordinates runs along the feature's axis.
    """
    return IN_PLANE[axis].index(IN_PLANE[look][1 - along])
