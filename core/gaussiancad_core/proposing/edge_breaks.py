"""Edge breaks taken off before the search: chamfers and roundings around a face, seen from beside.

A break around a face is a short slanted stroke, or an arc, at either end of the face in a view from
beside, and a line at its foot; in the view on the face it is a narrow band along the outline.  What
is like that in one view alone is a profile's own corner.  Here corners are made sharp, and what the
breaks draw is taken off; :mod:`.broken_edges` puts them on the solid.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.proposing.lines_by_plane import ROUND, Floats, PlaneLine
from gaussiancad_core.proposing.plane_loops import areas_between, stretched

_MOST = 0.06
"""Share of the part's longest extent that a break takes away at most."""

_LEAST = 3.0
"""Tolerances that it takes away at least."""

_SLOPE = 4.5
"""Ratio of what it takes away in its two ways at most."""

_ROUND = (1.2, 1.9)
"""Radians that a rounding turns."""

_LONGER = 0.6
"""Of what a break takes away, how long the lines that it joins are at least."""

_MEET = 3.0
"""Tolerances within which ends of lines meet, and two breaks are at one place."""

_ELONGATED = 8.0
"""Widths of a break that a band is long around at least."""

_OF_STRIP = 0.6
"""Share of its width that twice the area by the outline is, of a strip as short as that."""

_SAMPLE = 9
"""Points along a straight line that tell where it runs."""


@dataclass(frozen=True)
class EdgeBreak:
    """A chamfer or rounding around a face.

    Attributes:
        axis: across the face.
        at: mm along it, of the face.
        width: mm that it takes away across the axis.
        height: mm that it takes away along it; towards lower places where it is negative.
        is_round: whether it is a rounding.
        across: the model's other axis in the view that shows it.
        place: mm along that, of the sharp edge seen there.
    """

    axis: Axis
    at: float
    width: float
    height: float
    is_round: bool
    across: Axis
    place: float


@dataclass(frozen=True, eq=False)
class _Line:
    """A stroke in its plane.

    Attributes:
        stroke: as the view has it.
        points: (n, 2) mm along it, the ends first and last.
    """

    stroke: DrawnStroke
    points: Floats

    @property
    def is_whole(self) -> bool:
        return isinstance(self.stroke, Arc) and self.stroke.is_full

    @property
    def is_straight(self) -> bool:
        return isinstance(self.stroke, Segment)

    @property
    def length(self) -> float:
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    @property
    def ends(self) -> Floats:
        return self.points[[0, -1]]

    def lies_at(self, place: Floats, near: float) -> bool:
        """Whether an end of it is at a place."""
        return bool(np.hypot(*(self.ends - place).T).min() <= near)

    def leads(self, place: Floats, corner: Floats) -> bool:
        """Whether it leads from a place away from a corner."""
        far = self.ends[np.hypot(*(self.ends - place).T).argmax()]
        return float((far - place) @ (place - corner)) > 0.0


@dataclass(frozen=True, eq=False)
class _Corner:
    """A break in a view.

    Attributes:
        role: of the view.
        stroke: number of its line.
        feet: (2, 2) where it meets the line across the plane's first coordinate, and that across
            its second one.
        joined: for either, numbers of these lines.
        own: numbers of lines at its feet that are its own.
        is_round: whether it is an arc.
    """

    role: Role
    stroke: int
    feet: Floats
    joined: tuple[tuple[int, ...], tuple[int, ...]]
    own: tuple[int, ...]
    is_round: bool

    @property
    def sharp(self) -> Floats:
        """(2,) where the sharp edge is."""
        return np.array([self.feet[0, 0], self.feet[1, 1]])

    def around(self, column: int) -> EdgeBreak:
        """It as a break around the face across a coordinate of the plane."""
        axes = IN_PLANE[role_plane(self.role).normal]
        width = abs(self.feet[1 - column, 1 - column] - self.feet[column, 1 - column])
        height = self.feet[1 - column, column] - self.feet[column, column]
        place, at = self.sharp[1 - column], self.sharp[column]
        return EdgeBreak(
            axis=Axis(axes[column]),
            at=float(at),
            width=float(width),
            height=float(height),
            is_round=self.is_round,
            across=Axis(axes[1 - column]),
            place=float(place),
        )


@dataclass(frozen=True, eq=False)
class EdgeBreaks:
    """The breaks of a sheet.

    Attributes:
        each: one for each corner that shows one.
        rims: of the faces across each axis, holes whose edges are broken, too.
    """

    each: tuple[EdgeBreak, ...]
    rims: Mapping[Axis, tuple[shapely.Polygon, ...]]


def without_breaks(views: DrawnViews) -> tuple[DrawnViews, EdgeBreaks]:
    """Views whose edges are sharp where they were broken around a face, and these breaks."""
    near = _MEET * views.tolerance
    lines = {role: _lines(strokes, role) for role, strokes in views.strokes.items()}
    corners = [
        corner for role, drawn in lines.items() for corner in _corners(drawn, role, views, near)
    ]
    found: dict[Role, list[_Corner]] = {}
    breaks: list[EdgeBreak] = []
    for corner in corners:
        around = [
            each
            for each in (corner.around(0), corner.around(1))
            if _goes_around(each, corner.role, corners, lines, near)
        ]
        if around:
            found.setdefault(corner.role, []).append(corner)
            breaks += around
    strokes: dict[Role, tuple[DrawnStroke, ...]] = {}
    rims: dict[Axis, list[shapely.Polygon]] = {}
    for role, drawn in lines.items():
        kept, plane = _sharpened(drawn, found.get(role, ()), near), role_plane(role)
        around = [each for each in breaks if each.axis is plane.normal]
        if around:
            kept, holes = _without_bands(kept, around, views.tolerance)
            rims.setdefault(plane.normal, []).extend(holes)
        strokes[role] = tuple(_stroke(line, np.array(plane.signs)) for line in kept)
    every = {axis: tuple(holes) for axis, holes in rims.items()}
    return replace(views, strokes=strokes), EdgeBreaks(tuple(breaks), every)


def _lines(strokes: Sequence[DrawnStroke], role: Role) -> list[_Line]:
    signs = np.array(role_plane(role).signs)
    return [_Line(stroke, _points(stroke) * signs) for stroke in strokes]


def _points(stroke: DrawnStroke) -> Floats:
    if isinstance(stroke, Segment):
        ways = np.linspace(0.0, 1.0, _SAMPLE)[:, None]
        return np.asarray(stroke.start) * (1.0 - ways) + np.asarray(stroke.end) * ways
    return np.asarray(stroke.sample(stroke.length / ROUND))


def _corners(
    lines: Sequence[_Line], role: Role, views: DrawnViews, near: float
) -> Iterator[_Corner]:
    """What may be a break in a view."""
    most, least = _MOST * max(views.size), _LEAST * views.tolerance
    across = [
        [
            number
            for number, line in enumerate(lines)
            if line.is_straight and np.ptp(line.ends[:, column]) <= near < line.length
        ]
        for column in (0, 1)
    ]
    for number, line in enumerate(lines):
        size = np.ptp(line.ends, axis=0)
        if not _is_break(line, size, (least, most)):
            continue
        for feet in (line.ends, line.ends[::-1]):
            sharp = np.array([feet[0, 0], feet[1, 1]])
            joined = [
                tuple(
                    other
                    for other in across[column]
                    if lines[other].lies_at(feet[column], near)
                    and lines[other].leads(feet[column], sharp)
                )
                for column in (0, 1)
            ]
            long = [max((lines[k].length for k in numbers), default=0.0) for numbers in joined]
            if min(long) < _LONGER * float(size.max()):
                continue
            own = tuple(
                other
                for column in (0, 1)
                for other in across[1 - column]
                if lines[other].lies_at(feet[column], near)
                and not lines[other].leads(feet[column], feet[1 - column])
            )
            is_round = isinstance(line.stroke, Arc)
            yield _Corner(role, number, feet, (joined[0], joined[1]), own, is_round)
            break


def _is_break(line: _Line, size: Floats, limits: tuple[float, float]) -> bool:
    least, most = limits
    small, large = sorted(size.tolist())
    if line.stroke.linetype is not Linetype.VISIBLE:
        return False
    if small < least or large > most or large > _SLOPE * small:
        return False
    if isinstance(line.stroke, Arc):
        return _ROUND[0] < line.stroke.sweep < _ROUND[1]
    return line.is_straight


def _goes_around(
    edge_break: EdgeBreak,
    role: Role,
    corners: Sequence[_Corner],
    lines: Mapping[Role, Sequence[_Line]],
    near: float,
) -> bool:
    """Whether other views show that a break goes around its face: from beside a corner at the same
    place, or, where no other looks from beside, a line in the view on the face that ends before the
    outline does."""
    look = role_plane(role).normal
    beside = [
        other
        for other in lines
        if role_plane(other).normal not in (edge_break.axis, look)
        and any(line.stroke.linetype is Linetype.VISIBLE for line in lines[other])
    ]
    if beside:
        return any(
            corner.role in beside
            and any(_is_same(corner.around(column), edge_break, near) for column in (0, 1))
            for corner in corners
        )
    return any(
        _ends_before(drawn, edge_break, look, near)
        for other, drawn in lines.items()
        if role_plane(other).normal is edge_break.axis
    )


def _is_same(one: EdgeBreak, other: EdgeBreak, near: float) -> bool:
    """Whether two breaks are of one face."""
    return (
        one.axis is other.axis
        and abs(one.at - other.at) <= near
        and abs(one.height - other.height) <= near
    )


def _ends_before(drawn: Sequence[_Line], edge_break: EdgeBreak, look: Axis, near: float) -> bool:
    """Whether a view on a face has a line at a break's foot that is shorter than the outline."""
    across = IN_PLANE[edge_break.axis].index(edge_break.across.value)
    along = IN_PLANE[edge_break.axis].index(look.value)
    whole = np.vstack([line.points for line in drawn])
    low, high = whole[:, along].min(), whole[:, along].max()
    feet = edge_break.place - edge_break.width, edge_break.place + edge_break.width
    for line in drawn:
        ends = line.points[:, across].min(), line.points[:, across].max()
        if min(abs(end - foot) for end in ends for foot in feet) > near:
            continue
        first, last = line.points[:, along].min(), line.points[:, along].max()
        inset = edge_break.width / 2.0
        if last - first > edge_break.width and first > low + inset and last < high - inset:
            return True
    return False


def _sharpened(lines: Sequence[_Line], corners: Sequence[_Corner], near: float) -> list[_Line]:
    """Lines led on to the sharp corners; breaks, and what stands at their feet, are gone."""
    found = [line.ends.copy() for line in lines]
    gone: set[int] = set()
    moved: set[int] = set()
    for corner in corners:
        gone |= {corner.stroke, *corner.own}
        for column, numbers in enumerate(corner.joined):
            for number in numbers:
                away = np.hypot(*(lines[number].ends - corner.feet[column]).T)
                if away.min() <= near:
                    found[number][away.argmin(), 1 - column] = corner.sharp[1 - column]
                    moved.add(number)
    return [
        _led(line, ends) if number in moved else line
        for number, (line, ends) in enumerate(zip(lines, found, strict=True))
        if number not in gone - moved
    ]


def _led(line: _Line, ends: Floats) -> _Line:
    ways = np.linspace(0.0, 1.0, _SAMPLE)[:, None]
    return replace(line, points=ends[0] * (1.0 - ways) + ends[1] * ways)


def _without_bands(
    lines: Sequence[_Line], breaks: Sequence[EdgeBreak], tolerance: float
) -> tuple[list[_Line], list[shapely.Polygon]]:
    """The lines of a view without those of bands as narrow as the breaks of faces that it looks on,
    but for the sharp edges, and the holes around which there are bands."""
    near = _MEET * tolerance
    holes: list[shapely.Polygon] = []
    kept = [line for line in lines if not _is_mitre(line, lines, breaks, near)]
    for band in _bands(lines, breaks, tolerance):
        sides = [band.exterior, *band.interiors]
        walls = [side for side in sides if any(_reaches(side, each, near) for each in breaks)]
        if not walls:
            # What no view from beside shows is a hole.
            walls = sides[1:]
            holes += [shapely.Polygon(side) for side in walls]
        if walls:
            edge, area = shapely.MultiLineString(walls), band.buffer(near)
            kept = [line for line in kept if not _is_in(line, area, edge, near)]
    return kept, holes


def _is_mitre(
    line: _Line, lines: Sequence[_Line], breaks: Sequence[EdgeBreak], near: float
) -> bool:
    """Whether a line is where two roundings meet: as wide as one in both ways, from a corner to
    where nothing is drawn."""
    size = np.ptp(line.ends, axis=0)
    widths = np.array([each.width for each in breaks if each.is_round])
    if not line.is_straight or not len(widths):
        return False
    if np.abs(size[:, None] - widths).min(axis=1).max() > near:
        return False
    others = [other for other in lines if other is not line]
    return sum(any(other.lies_at(end, near) for other in others) for end in line.ends) == 1


def _bands(
    lines: Sequence[_Line], breaks: Sequence[EdgeBreak], tolerance: float
) -> Iterator[shapely.Polygon]:
    """Areas as narrow as a break, those beside each other as one."""
    curves = [PlaneLine(line.points, True, line.length, is_full=line.is_whole) for line in lines]
    narrow = [
        area
        for area in areas_between(stretched(curves, 0.0, tolerance), tolerance)
        if any(_is_band(area, each.width, _MEET * tolerance) for each in breaks)
    ]
    for part in shapely.get_parts(shapely.union_all(narrow)):
        if part.geom_type == "Polygon":
            yield part


def _is_band(area: shapely.Polygon, width: float, near: float) -> bool:
    # The outline of a strip has its ends, too; that of a ring has none.
    is_narrow = _OF_STRIP * width - near <= 2.0 * area.area / area.length <= width + near
    return bool(is_narrow and area.length > _ELONGATED * width)


def _reaches(side: shapely.LinearRing, edge_break: EdgeBreak, near: float) -> bool:
    """Whether a side of a band is where a view from beside shows the sharp edge of a break."""
    column = IN_PLANE[edge_break.axis].index(edge_break.across.value)
    ends = side.bounds[column], side.bounds[2 + column]
    return min(abs(end - edge_break.place) for end in ends) <= near


def _is_in(line: _Line, area: shapely.Geometry, edge: shapely.Geometry, near: float) -> bool:
    """Whether a line runs in a band, and not along its sharp edges."""
    points = shapely.points(line.points)
    is_along = bool((shapely.distance(points, edge) <= near).all())
    return not is_along and bool(shapely.covers(area, points).all())


def _stroke(line: _Line, signs: Floats) -> DrawnStroke:
    if not isinstance(line.stroke, Segment):
        return line.stroke
    start, end = (line.ends * signs).tolist()
    return replace(line.stroke, start=tuple(start), end=tuple(end))
