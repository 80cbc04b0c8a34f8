"""Names for the drawings that are left once the principal views are found.

A pictorial shows the part's axes in three directions of which at most one is upright.  An auxiliary
view is turned: its edges are square to each other, but not level.  A detail is cut out by a circle.
Another part has views of its own that belong together.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.annotations.erase import SHOWS, Told
from gaussiancad_core.sheet.annotations.inked_shapes import points_along
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind

Floats = npt.NDArray[np.float64]

_LEAST_PX = 40.0
"""Longer side of a drawing that has a name at least."""

_SLACK_PX = 6.0
"""px by which a stroke of a drawing may seem to end beyond its box."""

_LEAST_STROKES = 4
"""Lines of a drawing that their directions name at least."""

_SQUARE = np.radians(4.0)
"""Largest angle to the sheet's own directions of what is level or upright."""

_ONE_WAY = np.radians(3.0)
"""Largest angle between lines that run one way."""

_LEVEL = 0.15
"""Share of a pictorial's lines that are level at most."""

_SLANTED = 0.3
"""Share of its lines that are slanted at least; of an auxiliary view's twice as many."""

_SECOND = 0.1
"""Share of its lines that run the second slanted way at least."""

_CURVED = 0.3
"""Share of a round pictorial's strokes that are curves at least."""

_WHOLE = 0.7
"""Share of a detail's circle that is drawn at least: the part's edges may cut it."""

_MEETING = 4.0
"""Distance of a detail's strokes from its circle at their ends at most, in stroke widths."""


@dataclass(frozen=True, eq=False)
class Lines:
    """The straight lines of a drawing.

    Attributes:
        angles: (n,) radians in 0..pi, from the sheet's right towards its bottom.
        lengths: (n,) px.
        ends: (n, 2, 2) px.
    """

    angles: Floats
    lengths: Floats
    ends: Floats

    def share(self, chosen: npt.NDArray[np.bool_]) -> float:
        """Share of the length of all lines that some of them have."""
        return float(self.lengths[chosen].sum() / max(self.lengths.sum(), 1e-9))


def lines_in(stated: Told, box: Box) -> Lines:
    """The straight lines in a box that show a part."""
    angles, ends = stated.straight_runs
    low, high = _around(box)
    item = ((ends >= low) & (ends <= high)).all(axis=(1, 2))
    stacked = ends[item]
    return Lines(angles[item], np.hypot(*(stacked[:, 1] - stacked[:, 0]).T), stacked)


def special_kind(stated: Told, box: Box) -> SpecialKind | None:
    """What a drawing is that fits no principal view, or nothing where it has no name.

    Args:
        stated: the lines and circles of the sheet.
        box: of the drawing in px.
    """
    lines = lines_in(stated, box)
    side = max(box[2] - box[0], box[3] - box[1])
    if side < _LEAST_PX:
        return None
    if _is_round_pictorial(stated, lines, box):
        return SpecialKind.PICTORIAL
    return slanted_kind(lines)


def _is_round_pictorial(stated: Told, lines: Lines, box: Box) -> bool:
    """Whether a drawing is of curves, none of them a circle, and its lines run one slanted way:
    what was turned on a lathe, seen askew."""
    x0, y0, x1, y1 = (int(value) for value in box)
    curved = float(stated.unexplained[y0:y1, x0:x1].sum())
    for shape, annotation_kinds in zip(stated.shapes, stated.kinds, strict=True):
        if isinstance(shape.geometry, Line):
            continue
        runs = [
            run for run, kind in zip(shape.runs, annotation_kinds, strict=True) if kind in SHOWS
        ]
        runs = [r for r in runs if _within(points_along(shape.geometry, r.run, 2.0) + 0.5, box)]
        length = sum(run.run.length for run in runs)
        round_one = isinstance(shape.geometry, Circle)
        if round_one and length > _WHOLE * 2.0 * np.pi * shape.geometry.radius:
            return False
        curved += length
    straight = float(lines.lengths.sum())
    if curved < max(_CURVED * (curved + straight), 2.0 * _LEAST_PX):
        return False
    if not len(lines.lengths):
        return True
    level = np.minimum(_apart(lines.angles, 0.0), _apart(lines.angles, np.pi / 2)) < _SQUARE
    one_way = _apart(lines.angles, _commonest(lines, np.ones(len(level), bool))) < _ONE_WAY
    return lines.share(one_way & ~level) > 1.0 - _LEVEL


def slanted_kind(lines: Lines) -> SpecialKind | None:
    """Pictorial or auxiliary view, by the directions of the lines; neither where they are few."""
    if len(lines.lengths) < _LEAST_STROKES:
        return None
    level = _apart(lines.angles, 0.0) < _SQUARE
    upright = _apart(lines.angles, np.pi / 2) < _SQUARE
    slanted = ~level & ~upright
    if lines.share(slanted) < _SLANTED:
        return None
    first = _commonest(lines, slanted)
    rest = slanted & (_apart(lines.angles, first) > _ONE_WAY)
    if lines.share(rest) < _SECOND:
        return None
    second = _commonest(lines, rest)
    square = abs(_apart(np.array([first]), second)[0] - np.pi / 2) < _ONE_WAY
    both = ~rest | (_apart(lines.angles, second) < _ONE_WAY)
    if square and lines.share(slanted & both) > 2.0 * _SLANTED:
        return SpecialKind.AUXILIARY
    if not square and lines.share(level) < _LEVEL:
        return SpecialKind.PICTORIAL
    return None


def _commonest(lines: Lines, chosen: npt.NDArray[np.bool_]) -> float:
    """The direction in which the chosen lines are longest together."""
    angles, lengths = lines.angles[chosen], lines.lengths[chosen]
    near = _apart(angles[:, None], angles) < _ONE_WAY
    return float(angles[int(np.argmax(near @ lengths))])


def _apart(angles: Floats, other: float | Floats) -> Floats:
    """Angles between directions modulo half a turn."""
    return np.abs((angles - other + np.pi / 2) % np.pi - np.pi / 2)


def details(stated: Told, used: Sequence[Box], stroke_width: float) -> list[Box]:
    """Boxes of the circles beside the views that cut lines off: enlarged details.

    Args:
        stated: the lines and circles of the sheet, whatever they were taken for.
        used: boxes of the views.
        stroke_width: px.
    """
    found = []
    for circle in _whole_circles(stated):
        (x, y), radius = circle.centre, circle.radius
        box = (x + 0.5 - radius, y + 0.5 - radius, x + 0.5 + radius, y + 0.5 + radius)
        if 2.0 * radius < _LEAST_PX or any(_overlap(box, other) for other in used):
            continue
        if _cut_off(stated, circle, stroke_width) >= 2:
            found.append(box)
    return found


def _whole_circles(stated: Told) -> list[Circle]:
    return [
        shape.geometry
        for shape in stated.shapes
        if isinstance(shape.geometry, Circle)
        and sum(r.run.length for r in shape.runs) > _WHOLE * 2.0 * np.pi * shape.geometry.radius
    ]


def _cut_off(stated: Told, circle: Circle, stroke_width: float) -> int:
    """How many ends of strokes within a circle lie on it."""
    count = 0
    for shape, annotation_kinds in zip(stated.shapes, stated.kinds, strict=True):
        if shape.geometry == circle:
            continue
        for run, kind in zip(shape.runs, annotation_kinds, strict=True):
            if kind is AnnotationKind.CENTRE_LINE or run.run.length < _LEAST_PX / 2:
                continue
            points = points_along(shape.geometry, run.run, 2.0) - np.array(circle.centre)
            away = np.hypot(*points.T) - circle.radius
            if away[len(away) // 2] < -_MEETING * stroke_width:
                count += int((np.abs(away[[0, -1]]) < _MEETING * stroke_width).sum())
    return count


def _overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def inside(box: Box, other: Box) -> bool:
    """Whether most of a box lies in another one."""
    wide = min(box[2], other[2]) - max(box[0], other[0])
    high = min(box[3], other[3]) - max(box[1], other[1])
    area = (box[2] - box[0]) * (box[3] - box[1])
    return min(wide, high) > 0.0 and wide * high > 0.7 * area


def _within(points: Floats, box: Box) -> bool:
    low, high = _around(box)
    return bool(((points >= low) & (points <= high)).all())


def _around(box: Box) -> tuple[Floats, Floats]:
    """The corners of a box with slack."""
    return np.array(box[:2]) - _SLACK_PX, np.array(box[2:]) + _SLACK_PX
