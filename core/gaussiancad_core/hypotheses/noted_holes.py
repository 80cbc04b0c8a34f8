"""Holes whose depth a note tells, where views draw no hidden lines.

A depth counts from the face that a hole is drawn on, which is one of the surfaces around it: the
note is kept if for one of them the hole ends where it says.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import cos, sin

from gaussiancad_core.cells.cell_complex import Cell, CellComplex
from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import SAME_PLACE
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.hole_depths import NotedHole
from gaussiancad_core.model.projection_planes import RolePlane, role_plane

_ANGLES = tuple((k + 0.317) * FULL_TURN / 12 for k in range(12))
"""Where columns around a centre are looked up."""

_BESIDE = 0.4
"""Units beside a hole where its face is looked up."""


@dataclass(frozen=True)
class Kept:
    """Labels under which a note is kept.

    Attributes:
        void, solid: cells.
    """

    void: tuple[Cell, ...]
    solid: tuple[Cell, ...]


def floors(holes: Iterable[NotedHole], carriers: PartCarriers) -> dict[Axis, tuple[float, ...]]:
    """Coordinates in units at which holes may end, beside those that any view shows."""
    found: dict[Axis, list[float]] = {}
    near = max(SAME_PLACE, carriers.tolerance)
    for hole in holes:
        plane = role_plane(hole.role)
        sign = 1.0 if plane.looks_up else -1.0
        items = found.setdefault(plane.normal, [])
        known = carriers.values.get(plane.normal, ())
        for step in hole.steps:
            if step.depth is None:
                continue
            for value in known:
                floor = value + sign * step.depth * carriers.scale
                inside = 0.0 < floor < carriers.size[plane.normal.value]
                if inside and all(abs(floor - other) > near for other in (*known, *items)):
                    items.append(floor)
    return {axis: tuple(entries) for axis, entries in found.items()}


def kept_notes(
    holes: Iterable[NotedHole], space: CellComplex, carriers: PartCarriers
) -> tuple[tuple[Kept, ...], ...]:
    """For each note the labels under which it is kept; notes that no labels keep are left out."""
    near = max(SAME_PLACE, carriers.tolerance)
    found = (tuple(dict.fromkeys(_kept(hole, space, carriers.scale, near))) for hole in holes)
    return tuple(kepts for kepts in found if kepts)


def _kept(hole: NotedHole, space: CellComplex, scale: float, near: float) -> Iterator[Kept]:
    plane = role_plane(hole.role)
    a, b = (value * sign * scale for value, sign in zip(hole.centre, plane.signs, strict=True))
    radii = [step.diameter * scale / 2.0 for step in hole.steps]
    around = _columns(space, plane, (a, b), radii[-1] + _BESIDE)
    inside = [
        (None if step.depth is None else step.depth * scale, stretches)
        for step, low, high in zip(hole.steps, (0.0, *radii), radii, strict=False)
        for stretches in _columns(space, plane, (a, b), (low + high) / 2.0)
    ]
    through = any(depth is None for depth, _ in inside)
    for column in around:
        for first, face in enumerate(column):
            before = [stretch.cell for stretch in column[:first]]
            for last in range(first, len(column) if through else first + 1):
                beyond = (
                    [stretch.cell for stretch in column[last + 1 : last + 2]] if through else []
                )
                solid = [stretch.cell for stretch in column[first : last + 1]]
                kept = _inside(inside, (face.start, column[last].end), near)
                if kept is not None:
                    void = dict.fromkeys((*before, *beyond, *kept.void))
                    yield Kept(tuple(void), tuple(dict.fromkeys((*solid, *kept.solid))))


def _inside(
    columns: Sequence[tuple[float | None, "_Column"]], ends: tuple[float, float], near: float
) -> Kept | None:
    """Labels of the cells in a hole, from the face that it begins at to where the part ends around
    it; None where no surface lies at its depth."""
    void: list[Cell] = []
    solid: list[Cell] = []
    for depth, column in columns:
        floor = ends[1] if depth is None else ends[0] + depth
        if any(stretch.start < floor - near and stretch.end > floor + near for stretch in column):
            return None
        void += [stretch.cell for stretch in column if stretch.end <= floor + near]
        if depth is not None:
            solid += [stretch.cell for stretch in column if stretch.start > floor - near][:1]
    return Kept(tuple(void), tuple(solid))


@dataclass(frozen=True)
class _Stretch:
    """A cell on a line of sight, from and to a distance from the viewer's side."""

    start: float
    end: float
    cell: Cell


_Column = tuple[_Stretch, ...]


def _columns(space: CellComplex, plane: RolePlane, centre: Point, radius: float) -> list[_Column]:
    """What lies behind a circle around a centre, each kind of column once."""
    found: dict[_Column, None] = {}
    for angle in _ANGLES:
        at = centre[0] + radius * cos(angle), centre[1] + radius * sin(angle)
        column = space.column(plane.normal, *at)
        intervals = [
            (c.depth, d.depth, c.after) for c, d in pairwise(column) if c.after is not None
        ]
        if plane.looks_up:
            found[tuple(_Stretch(*pair) for pair in intervals)] = None
        else:
            found[tuple(_Stretch(-end, -start, cell) for start, end, cell in intervals[::-1])] = (
                None
            )
    return [column for column in found if column]
