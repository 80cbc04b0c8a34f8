"""Thread symbols: three quarters of a thin circle about a wide one (ISO 6410-1).

Beside the circle the thread's other diameter shows as two lines along its axis.  None of these is
an edge: they are told, and taken off the part.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds, Told, erased
from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.annotations.separated import SeparatedSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.special_views.kinds import SpecialKind, SpecialView

DRAWN = (0.6, 0.9)
"""Share of the thin circle that is drawn: about three quarters."""

_BROKEN = 0.08
"""Share of it that gaps besides the one large take at most: it is no dashed circle."""

_WHOLE = 0.92
"""Share of the wide circle that is drawn at least."""

RATIO = (0.7, 0.95)
"""The smaller radius in larger ones: minor diameters are 0.8 to 0.9 of major ones."""

_CONCENTRIC_PX = 2.0

_THIN = 0.8
"""Width of the thin circle at most, in those of the wide one, where the sheet's lines differ."""

_AROUND = 3.0
"""Distance from an end of the arc within which nothing else is, in stroke widths."""

_ON = 1.5
"""Distance from its circle within which ink is its own, in the same."""

_SAME_PX = 2.0
"""px by which a line of another view may lie beside the thread's diameter."""

_SHORTEST_PX = 6.0

_SOLID_PX = 20.0
"""px of a run whose width counts."""


@dataclass(frozen=True)
class Thread:
    """A thread symbol seen along its axis.

    Attributes:
        arc: the thin circle's number among the shapes.
        circle: the same, px of the upright sheet, corner of the first pixel at (0, 0).
    """

    arc: int
    circle: Circle

    @property
    def box(self) -> Box:
        """px around the thin circle."""
        (x, y), r = self.circle.centre, self.circle.radius
        return x - r, y - r, x + r, y + r


def without_threads(
    separated: SeparatedSheet, layout: Layout
) -> tuple[SeparatedSheet, tuple[SpecialView, ...]]:
    """The sheet without the thin lines of its thread symbols, and the symbols.

    Args:
        separated: without annotations.
        layout: the views; symbols elsewhere are left as they are.
    """
    if separated.told is None:
        return separated, ()
    told = separated.told
    found = find_threads(told, separated.part.ink, separated.part.stroke_width)
    marked: Kinds = [[None] * len(shape.runs) for shape in told.shapes]
    special = []
    for thread in found:
        role = next((r for r, box in layout.boxes.items() if _holds(box, thread)), None)
        if role is None:
            continue
        special.append(SpecialView(SpecialKind.THREAD, thread.box))
        marked[thread.arc] = [AnnotationKind.THREAD] * len(marked[thread.arc])
        for number in _side_lines(told, layout, role, thread):
            marked[number] = [AnnotationKind.THREAD] * len(marked[number])
    if not special:
        return separated, ()
    part = erased(separated.part, Told(told.shapes, marked, told.unexplained))
    return replace(separated, part=part), tuple(special)


def find_threads(told: Told, ink: Mask, stroke_width: float) -> list[Thread]:
    """Thread symbols seen along their axis.

    Args:
        told: the sheet's lines and circles.
        ink: (h, w) bool, the part's.
        stroke_width: px, of the part.
    """
    by_form = not _has_thin_lines(told)
    circles = [
        (number, shape)
        for number, shape in enumerate(told.shapes)
        if isinstance(shape.geometry, Circle)
    ]
    rims = [shape for _, shape in circles if _drawn(shape)[0] > _WHOLE]
    found = []
    for number, shape in circles:
        share, largest = _drawn(shape)
        broken = 1.0 - share - largest
        if not DRAWN[0] < share < DRAWN[1] or broken > _BROKEN:
            continue
        about = [rim for rim in rims if _is_thread(shape, rim, by_form)]
        if any(_ends_free(shape, rim, ink, stroke_width) for rim in about):
            (x, y), radius = shape.geometry.centre, shape.geometry.radius
            found.append(Thread(number, Circle((x + 0.5, y + 0.5), radius)))
    return found


def _has_thin_lines(told: Told) -> bool:
    """Whether the sheet has circles or lines much thinner than its widest ones."""
    widths = [
        own.width
        for shape in told.shapes
        for own in shape.runs
        if own.width is not None and own.run.length > _SOLID_PX
    ]
    return bool(widths) and float(np.percentile(widths, 10)) < _THIN * float(np.median(widths))


def _drawn(shape: InkedShape) -> tuple[float, float]:
    """Shares of a circle that are ink, and that its largest gap takes."""
    around = shape.geometry.around
    runs = [own.run for own in shape.runs]
    if not runs:
        return 0.0, 1.0
    gaps = [after.start - before.end for before, after in pairwise(runs)]
    gaps.append(runs[0].start + around - runs[-1].end)
    return sum(run.length for run in runs) / around, max(*gaps, 0.0) / around


def _is_thread(arc: InkedShape, rim: InkedShape, by_form: bool) -> bool:
    """Whether an arc lies about a whole circle as the thin circle of a thread does."""
    away = np.hypot(*np.subtract(arc.geometry.centre, rim.geometry.centre))
    small, large = sorted((arc.geometry.radius, rim.geometry.radius))
    if away > _CONCENTRIC_PX or not RATIO[0] < small / large < RATIO[1]:
        return False
    thin, wide = _width(arc), _width(rim)
    # On sheets of one line width the form alone tells; an arc wider than the rim is an edge.
    return thin is None or wide is None or thin < _THIN * wide or by_form


def _width(shape: InkedShape) -> float | None:
    """px, of the ink of a circle."""
    known = [own.width for own in shape.runs if own.width is not None]
    return float(np.median(known)) if known else None


def _ends_free(shape: InkedShape, rim: InkedShape, ink: Mask, stroke_width: float) -> bool:
    """Whether the arc ends at nothing: an edge goes on, or ends at another."""
    circle = shape.geometry
    around = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    ring = _AROUND * stroke_width * np.stack([np.cos(around), np.sin(around)], axis=1)
    start, end = _open_ends(shape)
    for position in (start, end):
        places = circle.points_at(np.array([position]))[0] + ring
        away = np.minimum(circle.distances(places), rim.geometry.distances(places))
        columns, rows = np.rint(places[away > _ON * stroke_width]).astype(int).T
        inside = (columns >= 0) & (rows >= 0)
        inside &= (columns < ink.shape[1]) & (rows < ink.shape[0])
        if ink[rows[inside], columns[inside]].any():
            return False
    return True


def _open_ends(shape: InkedShape) -> tuple[float, float]:
    """Positions along a circle at which its largest gap ends and begins."""
    runs = [own.run for own in shape.runs]
    around = shape.geometry.around
    following = [*runs[1:], replace(runs[0], start=runs[0].start + around)]
    before, after = max(
        zip(runs, following, strict=True), key=lambda pair: pair[1].start - pair[0].end
    )
    return after.start, before.end


def _holds(box: Box, thread: Thread) -> bool:
    x, y = thread.circle.centre
    return box[0] < x < box[2] and box[1] < y < box[3]


def _side_lines(told: Told, layout: Layout, role: Role, thread: Thread) -> Iterator[int]:
    """Numbers of the lines that show a thread's diameter in the other views, both or none."""
    for other, box in layout.boxes.items():
        if other is role:
            continue
        for axis in shared_axes_of(role, other):
            upright = other.frame.right_axis[0] is axis
            if other.frame.right_axis[0] is not axis and other.frame.up_axis[0] is not axis:
                continue
            places = [
                across_of(other, box, axis, place)
                for place in places_of(role, layout.boxes[role], axis, thread.circle)
            ]
            pairs = [_lines_at(told, box, upright, place) for place in places]
            if all(pairs):
                yield from (number for lines in pairs for number in lines)


def shared_axes_of(one: Role, other: Role) -> list[Axis]:
    """Axes that two views with different directions both show."""
    if one.frame.look_axis[0] is other.frame.look_axis[0]:
        return []
    axes = [(role.frame.right_axis[0], role.frame.up_axis[0]) for role in (one, other)]
    return [axis for axis in axes[0] if axis in axes[1]]


def places_of(role: Role, box: Box, axis: Axis, circle: Circle) -> tuple[float, float]:
    """px along an axis of the part, from its lower end, of both sides of a circle."""
    frame = role.frame
    if frame.right_axis[0] is axis:
        middle = circle.centre[0] - box[0]
        middle = middle if frame.right_axis[1] > 0 else box[2] - box[0] - middle
    else:
        middle = box[3] - circle.centre[1]
        middle = middle if frame.up_axis[1] > 0 else box[3] - box[1] - middle
    return middle - circle.radius, middle + circle.radius


def across_of(role: Role, box: Box, axis: Axis, place: float) -> float:
    """The sheet's coordinate of a place along an axis of the part."""
    frame = role.frame
    if frame.right_axis[0] is axis:
        return box[0] + place if frame.right_axis[1] > 0 else box[2] - place
    return box[3] - place if frame.up_axis[1] > 0 else box[1] + place


def _lines_at(told: Told, box: Box, upright: bool, at: float) -> list[int]:
    """Numbers of the upright or level lines of a view at a coordinate."""
    across = 0 if upright else 1
    found = []
    for number, shape in enumerate(told.shapes):
        if not isinstance(shape.geometry, Line) or not shape.runs:
            continue
        ends = _ends(shape)
        beside = np.abs(ends[:, across] - at).max() <= _SAME_PX
        inside = (ends > np.array(box[:2]) - _SHORTEST_PX).all()
        inside &= (ends < np.array(box[2:]) + _SHORTEST_PX).all()
        if beside and inside and np.ptp(ends[:, 1 - across]) > _SHORTEST_PX:
            found.append(number)
    return found


def _ends(shape: InkedShape) -> np.ndarray:
    """(2, 2) px, where the ink of a line begins and ends."""
    runs = shape.runs
    return (
        np.array([shape.geometry.at(runs[0].run.start), shape.geometry.at(runs[-1].run.end)]) + 0.5
    )
