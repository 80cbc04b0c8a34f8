"""Which circle or arc a text on a leader belongs to (ISO 128-22)."""

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.picture_noise import ASLANT
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.level_rules import rule_of
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.writing.dimension_layout import BESIDE, IN_LINE, MISSED
from gaussiancad_core.writing.sheet_texts import SheetText

Points = npt.NDArray[np.float64]
Leader = tuple[Points, Points]
"""(2,) px each of the two ends of its slanted line."""
Lines = Sequence[Leader] | Points
"""Lines by their ends, (n, 2, 2) px."""

_NARROW = frozenset(
    {
        AnnotationKind.EXTENSION,
        AnnotationKind.DIMENSION,
        AnnotationKind.LEADER,
        AnnotationKind.SYMBOL,
    }
)
"""What narrow lines are taken for: a leader may look like a part of a symbol."""

_BESIDE = 0.15
"""Distance at which a leader passes its circle's centre at most, in radii."""


def leaders_of(marks: Iterable[Mark]) -> list[Leader]:
    """The slanted narrow lines among the marks of a sheet."""
    return [
        (np.array(mark.line[0]), np.array(mark.line[1]))
        for mark in marks
        if mark.kind in _NARROW and mark.line is not None and rule_of(*mark.line) is None
    ]


def pointed_lines(heads: Iterable[Head], lines: Lines, turn: Turn) -> list[Leader]:
    """Lines that end in an arrowhead, anywhere between its base and its tip, in whatever direction,
    each from its far end to the tip.

    Args:
        heads: px of the sheet as stored.
        lines: px of the upright sheet.
        turn: of the sheet.
    """
    ends = np.array(lines, dtype=float).reshape(-1, 2, 2)
    ways = ends[:, 1] - ends[:, 0]
    ways = ways / np.maximum(np.hypot(*ways.T), 1e-9)[:, None]
    found = []
    for head in heads:
        base = np.subtract(head.tip, np.multiply(head.length, head.way))
        tip, back = turn.to_upright(np.array([head.tip, base]))
        way = (tip - back) / np.hypot(*(tip - back))
        parallel = np.abs(ways @ np.array([-way[1], way[0]])) <= ASLANT
        for at in (0, 1):
            ahead = np.clip((ends[:, at] - back) @ way, 0.0, head.length)
            near = np.hypot(*(ends[:, at] - back - ahead[:, None] * way).T)
            far = ends[:, 1 - at]
            away = (back - far) @ way > 0.0
            found += [(start, tip) for start in far[parallel & away & (near <= MISSED)]]
    return found


def shelves_of(marks: Iterable[Mark]) -> list[Leader]:
    """The level narrow lines among the marks of a sheet, under the texts of leaders."""
    found = []
    for mark in marks:
        if mark.kind in _NARROW and mark.line is not None:
            rule = rule_of(*mark.line)
            if rule is not None and rule.level:
                found.append((np.array(mark.line[0]), np.array(mark.line[1])))
    return found


def circles_at(
    text: SheetText, leaders: Sequence[Leader], shelves: Sequence[Leader], arcs: Sequence[Arc]
) -> tuple[Arc, ...]:
    """The circles and arcs that a text's leader may point at, the likeliest first; one of each
    radius.

    Args:
        text: level.
        leaders: slanted lines of the sheet.
        shelves: level lines of the sheet.
        arcs: of the views, px of the upright sheet.
    """
    if not text.level:
        return ()
    near = BESIDE * (text.box[3] - text.box[1])
    ends = np.array(leaders, dtype=float).reshape(-1, 2)
    starting = _distances(text.box, ends) <= near
    for shelf in shelves:
        if _runs_along_text(shelf, text.box, near):
            for end in shelf:
                starting |= np.hypot(*(ends - end).T) <= MISSED
    centres = np.array([arc.centre for arc in arcs]).reshape(-1, 2)
    radii = np.array([arc.radius for arc in arcs])
    missed: dict[float, tuple[float, Arc]] = {}
    # Each leader has two ends, one after the other.
    for number in np.flatnonzero(starting).tolist():
        start, tip = ends[number], ends[number ^ 1]
        # Edges that a leader crosses cut it into pieces.
        for end in (tip, *_beyond(start, tip, ends)):
            for miss, hit in _pointed_at(start, end, centres, radii):
                arc = arcs[hit]
                if arc.radius not in missed or miss < missed[arc.radius][0]:
                    missed[arc.radius] = miss, arc
    return tuple(arc for _, arc in sorted(missed.values(), key=lambda hit: hit[0]))


def _beyond(start: Points, tip: Points, points: Points) -> Points:
    """(m, 2) those of some points that lie on the line from a start, beyond its tip."""
    length = float(np.hypot(*(tip - start)))
    way, offsets = (tip - start) / length, points - start
    neighbour = np.abs(way[0] * offsets[:, 1] - way[1] * offsets[:, 0])
    return points[(offsets @ way > length) & (neighbour <= IN_LINE)]


def _runs_along_text(shelf: Leader, box: Box, near: float) -> bool:
    """Whether a level line runs along a text, or starts beside it."""
    left, right = sorted(float(end[0]) for end in shelf)
    level = float(shelf[0][1])
    below = box[1] - 0.2 * near <= level <= box[3] + near
    return below and left <= box[2] + near and right >= box[0] - near


def _distances(box: Box, points: Points) -> Points:
    """(n,) px from a box to points (n, 2)."""
    off = np.maximum(np.maximum(np.array(box[:2]) - points, points - np.array(box[2:])), 0.0)
    return np.hypot(off[:, 0], off[:, 1])


def _pointed_at(
    start: Points, tip: Points, centres: Points, radii: Points
) -> list[tuple[float, int]]:
    """How far the tip misses each circle towards whose centre a leader runs, and its number.

    Args:
        start, tip: (2,) px.
        centres, radii: (n, 2) and (n,) px.
    """
    way = (tip - start) / np.hypot(*(tip - start))
    offsets = centres - tip
    miss = np.abs(np.hypot(offsets[:, 0], offsets[:, 1]) - radii)
    neighbour = np.abs(way[0] * offsets[:, 1] - way[1] * offsets[:, 0])
    hit = np.flatnonzero((miss <= MISSED) & (neighbour <= _BESIDE * radii + 2.0))
    return list(zip(miss[hit].tolist(), hit.tolist(), strict=True))
