"""Centre marks: a cross in the middle of a circle, perhaps with arms that lead beyond the circle.

Where all lines of a sheet are of one width, only their places tell them: two equal lines at right
angles, their middles at the circle's centre, and all their ends free.  Edges end at other edges.
Where they are drawn with the narrow pen of hidden lines, without its gaps, they may end anywhere.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise, product

import numpy as np
from scipy.ndimage import map_coordinates

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.dotted_arms import has_dotted_arms
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.annotations.mark_forms import (
    FreeMark,
    learned_form,
    mark_by_form,
    whole_forms,
)
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.annotations.small_crosses import mark_small_crosses
from gaussiancad_core.sheet.annotations.uneven_marks import uneven_mark
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.line_widths import run_width
from gaussiancad_core.sheet.runs import Run

_OFF = 2.0
"""px by which a mark may miss its circle's centre: programs that draw on whole pixels put a line
that runs one way a px beside the one that runs the other way, and the circle another px off."""

_AT_CIRCLE = 1.0
"""px, besides the width of a stroke, within which a line ends at its circle."""

_EVEN = 2.5
"""px by which arms that belong together may differ."""

_SQUARE, _JOG = 0.02, 1.0
"""Cosine of the angle between a cross's lines at most, and px by which the halves of each may lie
beside each other: then one line through both leans."""

_DRAWN = 0.2
"""Share of a circle that is drawn at least, for it to have a mark."""

_BEYOND = 1.5
"""Distance by which the ends of an uneven mark are beyond its circle at least, in stroke widths."""

_ROW = 4
"""Dashes of one length and at one distance that are a hidden line."""

_NARROW = 0.82
"""Width of a mark's lines at most, in that of its circle, for their pen to tell them."""

_UNBROKEN = 9.0
"""Length of these lines at least, in stroke widths: no dash is as long."""

_BROKEN = 4.0
"""Gap where the other line of a cross breaks one at most, in stroke widths."""

_PAPER = 0.35
"""Weight of ink under which it is paper."""

_AHEAD = (1.5, 5.0)
"""px ahead of a line's ink where there is nothing if its end is free."""

_LEAST_ROOM, _CLEAR = 3.0, 1.0
"""px between a cross's end and the ink of its circle at least, and what of them on either side is
not looked at."""

_BESIDE = 2.0
"""px on either side of the way ahead."""


@dataclass(frozen=True)
class _Ray:
    """A straight run whose line leads through a circle's centre, or two on either side of it.

    Attributes:
        shape: its number.
        runs: their numbers.
        line: that it lies on.
        start, end: px along it from the centre.
        zero: position of the centre along the line.
    """

    shape: int
    runs: tuple[int, ...]
    line: Line
    start: float
    end: float
    zero: float

    def tell(self, kinds: Kinds) -> None:
        """Make it a centre line, in place."""
        for run in self.runs:
            kinds[self.shape][run] = AnnotationKind.CENTRE_LINE


def mark_centre_marks(shapes: list[InkedShape], kinds: Kinds, sheet: CleanSheet) -> None:
    """Mark the runs of centre marks as centre lines, in place.

    Those that stand free tell the form of the others.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        sheet: their ink.
    """
    ink, stroke_width = sheet.ink, sheet.stroke_width
    circles = [
        shape.geometry
        for shape in shapes
        if isinstance(shape.geometry, Circle)
        and sum(own.run.length for own in shape.runs) >= _DRAWN * shape.geometry.around
    ]
    marks: list[FreeMark] = []
    for circle in circles:
        # One line of a mark may be known by its pen or its rhythm, and tells the other.
        rays = list(_rays(circle, shapes, stroke_width))
        free = {
            ray
            for ray in rays
            if (
                _is_free(ray, circle, ink, stroke_width) and not _ends_at(ray, circle, stroke_width)
            )
            or _ends_before(ray, circle, sheet)
        }
        for one, other in combinations([ray for ray in rays if _is_even(ray, ray)], 2):
            found = _mark(one, other, rays, free) or _dotted(one, other, circle, sheet)
            for ray in found:
                ray.tell(kinds)
            if found:
                marks.append(_free_mark(circle, found))
        # Last, so that those that stand free tell the form.
        beyond = _beyond(circle, rays, ink, stroke_width)
        uneven = [] if beyond else _uneven(circle, rays, sheet)
        for ray in (*beyond, *uneven, *_narrow(rays, circle, shapes, sheet)):
            ray.tell(kinds)
    armed = learned_form(marks)
    for form in (*([] if armed is None else [armed]), *whole_forms(marks, circles)):
        mark_by_form(shapes, kinds, ink, form, circles)
    mark_small_crosses(shapes, kinds, sheet)


def _free_mark(circle: Circle, rays: Sequence[_Ray]) -> FreeMark:
    """A mark as it was found: its cross first, then its arms."""
    cross = float(np.mean([ray.end - ray.start for ray in rays[:2]])) / 2.0
    arms = [sorted((abs(ray.start), abs(ray.end))) for ray in rays[2:]]
    if not arms:
        return FreeMark(circle, cross)
    inner, outer = np.mean(arms, axis=0).tolist()
    return FreeMark(circle, cross, inner, outer)


def _mark(one: _Ray, other: _Ray, rays: Sequence[_Ray], free: set[_Ray]) -> list[_Ray]:
    """The lines of a mark whose cross two runs are; none if they are no cross.

    Its ends are free.  Where they are not, as the circle is as large as the cross, arms on all four
    sides tell it.
    """
    if not _is_turned(one, other):
        return []
    arms = [_arms(own, rays) for own in (one, other)]
    both = [
        [arm for arm in own if any(_is_turned(arm, ray) for ray in opposite)]
        for own, opposite in (arms, arms[::-1])
    ]
    if all(both):
        return [one, other, *both[0], *both[1]]
    if one in free and other in free:
        return [one, other, *(arm for own in arms for arm in own if arm in free)]
    return []


def _dotted(one: _Ray, other: _Ray, circle: Circle, sheet: CleanSheet) -> list[_Ray]:
    """The lines of a cross as large as its circle, if dots are all that is left of its arms."""
    at_circle = all(_ends_at(ray, circle, sheet.stroke_width) for ray in (one, other))
    if at_circle and _is_turned(one, other) and has_dotted_arms(circle, one.line.direction, sheet):
        return [one, other]
    return []


def _narrow(
    rays: Sequence[_Ray], circle: Circle, shapes: Sequence[InkedShape], sheet: CleanSheet
) -> list[_Ray]:
    """The runs of a cross that its pen tells, with its arms: too long for dashes, and narrower than
    its circle, which is no dashes either."""
    longest = _UNBROKEN * sheet.stroke_width
    around = [
        run_width(sheet, circle, own.run, edges=True)
        for shape in shapes
        if shape.geometry == circle
        for own in shape.runs
        if own.run.length > longest
    ]
    widest = _NARROW * min((width for width in around if np.isfinite(width)), default=0.0)
    # Where it ends at its circle, the ink of that may be counted as its own.
    even = _EVEN + sheet.stroke_width
    lines = []
    for ray in rays:
        own = shapes[ray.shape].runs
        run = Run(own[ray.runs[0]].run.start, own[ray.runs[-1]].run.end)
        if ray.start < 0.0 < ray.end and run.length > longest and abs(ray.start + ray.end) <= even:
            width = run_width(sheet, ray.line, run, edges=True)
            lines += [ray] if width <= widest else []
    for one, other in combinations(lines, 2):
        if _is_square(one, other) and abs(one.end - one.start - other.end + other.start) <= even:
            return [one, other, *_arms(one, rays), *_arms(other, rays)]
    return []


def _beyond(circle: Circle, rays: Sequence[_Ray], ink: Mask, stroke_width: float) -> list[_Ray]:
    """The runs of a mark whose lines end freely beyond the circle, equally far on all four sides,
    however they are dashed in between."""
    least = circle.radius + _BEYOND * stroke_width
    crossing = []
    for own in _families(rays):
        firsts = [k for k, (start, _, _) in enumerate(own) if start < -least]
        lasts = [k for k, (_, end, _) in enumerate(own) if end > least]
        for first, last in product(firsts, lasts):
            inner = own[first : last + 1]
            if (
                last >= first
                and abs(inner[0][0] + inner[-1][1]) <= _EVEN
                and all(two[0] - one[1] <= circle.radius for one, two in pairwise(inner))
                and _leaves_freely(inner[0], -1.0, ink, stroke_width)
                and _leaves_freely(inner[-1], 1.0, ink, stroke_width)
            ):
                crossing.append(inner)
    for one, other in combinations(crossing, 2):
        if _is_square(one[0][2], other[0][2]) and abs(one[-1][1] - other[-1][1]) <= _EVEN:
            return [ray for _, _, ray in (*one, *other)]
    return []


def _uneven(circle: Circle, rays: Sequence[_Ray], sheet: CleanSheet) -> list[_Ray]:
    """The runs of a mark whose lines begin freely beyond the circle and leave off anywhere."""
    for own in _families(rays):
        way = own[0][2].line.direction
        end = uneven_mark(circle, way, sheet)
        if end is None:
            continue
        # Where it ends at an edge, the ink of that may be counted as its own.
        most = end + _EVEN + sheet.stroke_width
        found = [
            ray
            for ray in rays
            if max(abs(ray.start), abs(ray.end)) <= most
            and min(abs(float(np.dot(ray.line.direction, way))), _across(ray, way)) <= _SQUARE
        ]
        return [] if _has_row(found) else found
    return []


def _has_row(rays: Sequence[_Ray]) -> bool:
    """Whether even dashes are among the runs of a line: a hidden line on its way."""
    for shape in {ray.shape for ray in rays}:
        single = [ray for ray in rays if ray.shape == shape and len(ray.runs) == 1]
        own = sorted((ray.start, ray.end) for ray in single)
        for k in range(len(own) - _ROW + 1):
            row = own[k : k + _ROW]
            lengths = [end - start for start, end in row]
            gaps = [two[0] - one[1] for one, two in pairwise(row)]
            if max(lengths) <= _EVEN + min(lengths) and max(gaps) <= _EVEN + min(gaps):
                return True
    return False


def _across(ray: _Ray, way: tuple[float, float]) -> float:
    """Sine of the angle between a run and a direction."""
    return abs(ray.line.direction[0] * way[1] - ray.line.direction[1] * way[0])


def _families(rays: Sequence[_Ray]) -> list[list[tuple[float, float, _Ray]]]:
    """Runs of one line, or of parallel ones through the centre, in order: px from the centre of
    both ends along the first one's line, and the run."""
    families: list[list[tuple[float, float, _Ray]]] = []
    for ray in rays:
        for own in families:
            way = float(np.dot(own[0][2].line.direction, ray.line.direction))
            if abs(way) > 1.0 - _SQUARE:
                forwards = ray.start, ray.end, ray
                own.append(forwards if way > 0.0 else (-ray.end, -ray.start, ray))
                break
        else:
            families.append([(ray.start, ray.end, ray)])
    return [sorted(own, key=lambda told: told[:2]) for own in families]


def _leaves_freely(
    told: tuple[float, float, _Ray], outward: float, ink: Mask, stroke_width: float
) -> bool:
    """Whether nothing is ahead of the outer end of a family's first run, or of its last one."""
    start, end, ray = told
    at, way = (start, -1.0) if outward < 0.0 else (end, 1.0)
    same = abs(ray.start - start) < 1e-9
    return _end_is_free(ray, (at, way) if same else (-at, -way), ink, stroke_width)


def _rays(circle: Circle, shapes: Sequence[InkedShape], stroke_width: float) -> Iterator[_Ray]:
    """The straight runs whose lines lead through a circle's centre, and both sides of those that
    the other line of a small pale cross breaks there."""
    centre = np.array([circle.centre])
    for k, shape in enumerate(shapes):
        line = shape.geometry
        if not isinstance(line, Line):
            continue
        along, across = line.coordinates(centre)
        if abs(float(across[0])) > _OFF:
            continue
        zero = float(along[0])
        for i, own in enumerate(shape.runs):
            yield _Ray(k, (i,), line, own.run.start - zero, own.run.end - zero, zero)
        for i, (one, other) in enumerate(pairwise(shape.runs)):
            broken = one.run.end < zero < other.run.start
            if broken and other.run.start - one.run.end <= _BROKEN * stroke_width:
                yield _Ray(k, (i, i + 1), line, one.run.start - zero, other.run.end - zero, zero)


def _is_even(one: _Ray, other: _Ray) -> bool:
    """Whether two runs of parallel lines are each other's picture in the centre."""
    way = float(np.dot(one.line.direction, other.line.direction))
    start, end = (other.start, other.end) if way > 0.0 else (-other.end, -other.start)
    return max(abs(one.start + end), abs(one.end + start)) <= _EVEN


def _is_square(one: _Ray, other: _Ray) -> bool:
    """Whether two runs are at right angles, but for what their halves may lie beside each other."""
    lean = sum(_JOG / max(ray.end - ray.start, _JOG) for ray in (one, other))
    return abs(float(np.dot(one.line.direction, other.line.direction))) <= _SQUARE + lean


def _is_turned(one: _Ray, other: _Ray) -> bool:
    """Whether a run is the picture of another one, turned around the centre by a right angle."""
    if not _is_square(one, other):
        return False
    first, second = (
        sorted(map(abs, (one.start, one.end))),
        sorted(map(abs, (other.start, other.end))),
    )
    alike = max(abs(a - b) for a, b in zip(first, second, strict=True)) <= _EVEN
    return alike and (one.start * one.end < 0.0) == (other.start * other.end < 0.0)


def _arms(cross: _Ray, rays: Sequence[_Ray]) -> list[_Ray]:
    """The runs beyond both ends of one line of a cross."""
    level = [
        ray
        for ray in rays
        if abs(float(np.dot(ray.line.direction, cross.line.direction))) > 1.0 - _SQUARE
        and min(abs(ray.start), abs(ray.end)) > cross.end
        and ray.start * ray.end > 0.0
    ]
    return [ray for ray in level if any(_is_even(ray, other) for other in level)]


def _ends_at(ray: _Ray, circle: Circle, stroke_width: float) -> bool:
    """Whether a run ends at its circle."""
    away = [abs(abs(end) - circle.radius) for end in (ray.start, ray.end)]
    return min(away) <= stroke_width + _AT_CIRCLE


def _ends_before(ray: _Ray, circle: Circle, sheet: CleanSheet) -> bool:
    """Whether both ends of a run are within its circle and paper shows before that: an edge that
    ends there touches it."""
    line = ray.line
    for place, outward in (ray.start, -1.0), (ray.end, 1.0):
        if not 0.0 < outward * place < circle.radius:
            return False
        ahead = np.arange(place, outward * circle.radius, 0.25 * outward)
        points = np.array([line.at(ray.zero + at) for at in ahead])
        paper = map_coordinates(sheet.weight, points[:, ::-1].T, order=1, mode="nearest")
        if paper.min() > _PAPER:
            return False
    return True


def _is_free(ray: _Ray, circle: Circle, ink: Mask, stroke_width: float) -> bool:
    """Whether nothing is ahead of either end of a run, but its circle."""
    for place, outward in (ray.start, -1.0), (ray.end, 1.0):
        room = circle.radius - outward * place - stroke_width / 2
        near = _LEAST_ROOM < room < _AHEAD[1] + stroke_width / 2 + _CLEAR
        ahead = (_CLEAR, room - _CLEAR) if near else None
        if not _end_is_free(ray, (place, outward), ink, stroke_width, ahead):
            return False
    return True


def _end_is_free(
    ray: _Ray,
    end: tuple[float, float],
    ink: Mask,
    stroke_width: float,
    within: tuple[float, float] | None = None,
) -> bool:
    """Whether nothing is ahead of an end of a run, as far as usual or between these px from it.

    The end is told by its position and the sign of outwards.
    """
    position, outward = end
    way = np.array(ray.line.direction)
    normal = np.array([-way[1], way[0]])
    ahead = np.arange(*_AHEAD) + stroke_width / 2 if within is None else np.arange(*within, 0.5)
    beside = np.arange(-_BESIDE, _BESIDE + 1.0)
    at = np.array(ray.line.at(ray.zero + position))
    places = at + outward * ahead[:, None, None] * way + beside[:, None] * normal
    columns, rows = np.rint(places.reshape(-1, 2)).astype(int).T
    inside = (columns >= 0) & (rows >= 0) & (columns < ink.shape[1]) & (rows < ink.shape[0])
    return not bool(ink[rows[inside], columns[inside]].any())
