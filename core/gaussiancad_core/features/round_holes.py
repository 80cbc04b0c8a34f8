"""Round holes of a solid: stacks of bores about one axis, as a drill, a counterbore and a
countersink leave them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import atan, degrees, tau

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.inside_rays import Rays
from gaussiancad_core.features.round_axes import SAME, RoundAxis, around, by_axis
from gaussiancad_core.features.solid_faces import Kind, SolidFace, cone_of, v_range
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.kernel.brep import ShapeTable, edges_of

Vector = npt.NDArray[np.float64]

_WHOLE = 1e-3
"""Radians by which the faces of a bore may miss a whole turn."""

_ROUND_ABOUT = 7
"""Lines along an axis that are looked along, around it."""


@dataclass(frozen=True)
class Section:
    """A piece of a bore between two places along its axis.

    Attributes:
        low, high: units along the axis.
        at_low, at_high: units, its radius there; equal of a cylinder.
    """

    low: float
    high: float
    at_low: float
    at_high: float

    @property
    def is_cylinder(self) -> bool:
        """Whether its radius is the same all along."""
        return abs(self.at_low - self.at_high) < SAME

    @property
    def angle(self) -> float:
        """Degrees between the sides of a cone."""
        return 2.0 * degrees(atan(abs(self.at_high - self.at_low) / (self.high - self.low)))

    def reversed(self) -> "Section":
        """The same along the axis the other way."""
        return Section(-self.high, -self.low, self.at_high, self.at_low)


@dataclass(frozen=True, eq=False)
class Bore:
    """A round hole.

    Attributes:
        point: units, the point of its axis that is nearest to the origin.
        direction: unit vector along which it is drilled: its mouth is at the start.
        sections: from the mouth on, along the direction.
        is_through: whether there is no material beyond its end.
        is_blind: whether it ends within the material.
        faces: of the solid, that bound it.
    """

    point: Vector
    direction: Vector
    sections: tuple[Section, ...]
    is_through: bool
    is_blind: bool
    faces: tuple[SolidFace, ...]


def bores_of(faces: Sequence[SolidFace], rays: Rays) -> tuple[Bore, ...]:
    """The round holes of a solid that a drill can make: none is wider inside than at its mouth.

    Args:
        faces: of the solid.
        rays: through it.
    """
    found = []
    concave = (f for f in faces if f.kind in (Kind.CYLINDER, Kind.CONE) and f.is_concave)
    for axis in by_axis(concave):
        for stack, bounding in _stacks(axis):
            bore = _drilled(stack, bounding, axis, rays)
            if bore is not None:
                found.append(replace(bore, faces=(*bounding, *_steps(bounding, faces))))
    return tuple(_without_beyond(found))


def _without_beyond(bores: Sequence[Bore]) -> list[Bore]:
    """Without plain bores that another one goes on in beyond what it crosses: its drill makes them,
    and their faces are its own."""
    found: list[Bore] = []
    for bore in sorted(bores, key=lambda each: each.sections[0].low):
        for k, other in enumerate(found):
            if _goes_on(other, bore):
                found[k] = replace(other, faces=(*other.faces, *bore.faces))
                break
        else:
            found.append(bore)
    return found


def _goes_on(one: Bore, other: Bore) -> bool:
    """Whether a drill that makes a bore makes another one, farther along its axis, as well."""
    end, first = one.sections[-1], other.sections[0]
    is_beyond = one.is_through and len(other.sections) == 1 and end.high < first.low
    is_like = end.is_cylinder and first.is_cylinder and abs(end.at_high - first.at_low) < SAME
    apart = float(np.linalg.norm(one.direction - other.direction))
    is_one_axis = apart < COMPUTED and float(np.linalg.norm(one.point - other.point)) < SAME
    return is_beyond and is_like and is_one_axis


def _steps(bounding: Sequence[SolidFace], faces: Sequence[SolidFace]) -> Iterator[SolidFace]:
    """The planes between the round faces of a bore, and at its end: all of their edges are edges
    of those faces."""
    table = ShapeTable()
    for face in bounding:
        for edge in edges_of(face.face):
            table.number(edge)
    known = len(table.shapes)
    for face in faces:
        edges = edges_of(face.face) if face.kind is Kind.PLANE else ()
        if edges and all(table.number(edge) < known for edge in edges):
            yield face


def _stacks(axis: RoundAxis) -> Iterator[tuple[list[Section], list[SolidFace]]]:
    """Sections that go all around, in runs without gaps, ascending; with their faces."""
    turns: list[tuple[Section, float, list[SolidFace]]] = []
    for face in axis.faces:
        section = _section(face, axis.point, axis.direction)
        for k, (other, turn, group) in enumerate(turns):
            if _are_one(section, other):
                turns[k] = (_joined(section, other), turn + face.turn, [*group, face])
                break
        else:
            turns.append((section, face.turn, [face]))
    whole = sorted(
        (
            (section, group)
            for section, turn, group in turns
            if turn > tau - _WHOLE and section.high - section.low > SAME
        ),
        key=lambda entry: entry[0].low,
    )
    run: list[tuple[Section, list[SolidFace]]] = []
    for entry in whole:
        if run and abs(entry[0].low - run[-1][0].high) > SAME:
            yield [section for section, _ in run], [f for _, group in run for f in group]
            run = []
        run.append(entry)
    if run:
        yield [section for section, _ in run], [f for _, group in run for f in group]


def _section(face: SolidFace, point: Vector, direction: Vector) -> Section:
    bottom, top = v_range(face)
    if face.kind is Kind.CONE:
        ends = cone_of(face, (bottom, top))
    else:
        ends = tuple((face.point + at * face.direction, face.radius) for at in (bottom, top))
    (low, at_low), (high, at_high) = sorted(
        ((float((place - point) @ direction), radius) for place, radius in ends)
    )
    return Section(low, high, at_low, at_high)


def _are_one(one: Section, other: Section) -> bool:
    """Whether two sections are pieces of the same cylinder or cone."""
    if one.is_cylinder and other.is_cylinder:
        near = one.low < other.high + SAME and other.low < one.high + SAME
        return near and abs(one.at_low - other.at_low) < SAME
    return all(
        abs(a - b) < SAME
        for a, b in (
            (one.low, other.low),
            (one.high, other.high),
            (one.at_low, other.at_low),
            (one.at_high, other.at_high),
        )
    )


def _joined(one: Section, other: Section) -> Section:
    return Section(min(one.low, other.low), max(one.high, other.high), other.at_low, other.at_high)


def _drilled(
    stack: Sequence[Section],
    faces: Sequence[SolidFace],
    axis: RoundAxis,
    rays: Rays,
) -> Bore | None:
    """A stack as what drills leave; None where none can."""
    point, direction = axis.point, axis.direction
    closed_low = _is_closed(stack[0].reversed(), point, -direction, rays)
    closed_high = _is_closed(stack[-1], point, direction, rays)
    if closed_low and closed_high:
        return None
    # From the wider end where both are open.
    from_high = closed_low or (not closed_high and stack[-1].at_high >= stack[0].at_low)
    sections = [s.reversed() for s in reversed(stack)] if from_high else list(stack)
    way = -direction if from_high else direction
    is_blind = closed_low or closed_high
    if not _is_drilled(sections, is_blind):
        return None
    end = sections[-1]
    beyond = _is_free(end.at_high, end.high, point, way, rays)
    return Bore(point, way, tuple(sections), beyond and not is_blind, is_blind, tuple(faces))


def _is_drilled(sections: Sequence[Section], is_blind: bool) -> bool:
    """Whether drills leave such a bore: from each mouth cylinders that get narrower, or one
    countersink, down to the narrowest cylinder; at the end of a blind one perhaps a tip."""
    radii = [min(section.at_low, section.at_high) for section in sections]
    tip = is_blind and not sections[-1].is_cylinder and sections[-1].at_high < SAME
    body = list(sections[:-1] if tip else sections)
    if tip and (not body or abs(body[-1].at_high - sections[-1].at_low) > SAME):
        return False
    cylinders = [k for k, section in enumerate(body) if section.is_cylinder]
    if not cylinders:
        return False
    narrow = min(cylinders, key=lambda k: radii[k])
    core = body[narrow]
    after = [section.reversed() for section in reversed(body[narrow + 1 :])]
    if is_blind and after:
        return False
    return _is_mouth(body[:narrow], core) and _is_mouth(after, core)


def _is_mouth(sections: Sequence[Section], core: Section) -> bool:
    """Whether sections before the narrowest cylinder are steps, or one countersink."""
    if len(sections) == 1 and not sections[0].is_cylinder:
        return sections[0].at_low > core.at_low and abs(sections[0].at_high - core.at_low) < SAME
    radii = [*(section.at_low for section in sections), core.at_low]
    narrows = all(after < before for before, after in pairwise(radii))
    return narrows and all(section.is_cylinder for section in sections)


def _is_closed(section: Section, point: Vector, direction: Vector, rays: Rays) -> bool:
    """Whether material follows where a section ends, at most places across it; a tip is closed."""
    if section.at_high < SAME:
        return True
    hits = 0
    for base in around_bore(point, direction, 0.61 * section.at_high):
        stretches = rays.inside(base, direction)
        if stretches is None:
            continue
        place = section.high + 10.0 * SAME
        hits += bool(((stretches[:, 0] < place) & (stretches[:, 1] > place)).any())
    return hits > _ROUND_ABOUT // 2


def _is_free(radius: float, at: float, point: Vector, way: Vector, rays: Rays) -> bool:
    """Whether a hole that goes on beyond its end meets no material."""
    for base in around_bore(point, way, 0.97 * radius):
        stretches = rays.inside(base, way)
        if stretches is None or bool((stretches[:, 1] > at + 10.0 * SAME).any()):
            return False
    return True


def around_bore(point: Vector, direction: Vector, radius: float) -> Iterator[Vector]:
    """Points around the axis of a bore, none of them level with another."""
    return around(point, direction, radius, _ROUND_ABOUT, 0.213)
