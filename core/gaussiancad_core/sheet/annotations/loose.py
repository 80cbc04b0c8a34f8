"""Annotations on sheets whose lines are all of one width.

Dimension lines and leaders end in arrowheads, which are thicker than any line.  Without them,
extension lines, shoulders of leaders and centre marks bound nothing: the same blank area lies on
both of their sides, while an edge of the part always parts two areas.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt
from scipy.ndimage import median_filter

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.blank_areas import (
    BlankAreas,
    blank_areas,
    outlined_areas,
    paper_around,
)
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import (
    InkedRun,
    InkedShape,
    normals_along,
    points_along,
)
from gaussiancad_core.sheet.annotations.marks import Mark, Mask, values_at
from gaussiancad_core.sheet.annotations.sharp_tips import Tip, sharp_tips
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

_STEADY = 4
"""px on either side over which the areas beside a line are made steady."""

_SHORTEST_PX = 5

_BRIDGE_PX = 7
"""px; closes gaps of fewer."""

_SQUARE = 0.05
"""Cosine of the angle between an extension line and its dimension line at most."""

_OVER = 5.0
"""Length by which an extension line goes on beyond its dimension line at most, in its widths."""

_LEAST_OUT_PX = 8.0
"""px of a line over blank paper: runs seem to end a little beyond their ink."""

_AHEAD_PX, _AROUND_PX = 14.0, 4.0
"""px ahead of the end of a line, and beside it, where nothing is if it sticks out."""

_BACK_PX = 5.0
"""px back from the end of a line along which another that meets it there comes near."""

_SLANTED = 0.05
"""Sine of the angle between a slanted line and the sheet's axes at least."""

_LED_PX = 30.0
"""px over paper from which a slanted line leads in from there."""

_FREE_AHEAD = (0.0, 5.0)
"""px ahead of a line's end, somewhere in which paper shows if the end is free."""

_BEND_PX = 3.0
"""px beside a line's end in which a rounding goes on."""

_JOINED = 0.4
"""Length of the dashes beside two that a crossing stroke joins at least, as a share of these."""

_LETTERED = 0.12
"""Share of a box that letters fill at least, for it to be one around them."""

_BOX_HEIGHT = 4.0
"""Height of a box around letters at most, in heights of a letter."""


class _Side(IntEnum):
    """What a stretch of line lies between: two areas, one area of a view, or blank paper."""

    PARTING = 0
    INSIDE = 1
    PAPER = 2


@dataclass(frozen=True)
class LooseRule:
    """Which runs that part nothing are annotations.

    Attributes:
        shortest: px; shorter runs are dashes, which part nothing either, but for those that a known
            dimension line ends on.
        everywhere: all of them; otherwise those that run on over blank paper.
        bridge: px; gaps of fewer do not open an outline.
        faded: px; what parts two areas once gaps of fewer are closed stays as well.  Between lines
            closer than that nothing is known, and ``bridge`` counts.
        corners: whether an outline may be open at corners, before which both lines end.
        closed: whether outlines have no gaps, so that what has the paper around the views on both
            sides parts nothing, whatever closing gaps would make of it.
    """

    shortest: float
    everywhere: bool
    bridge: int = _BRIDGE_PX
    faded: int = 0
    corners: bool = False
    closed: bool = False


def split_loose(
    shapes: Sequence[InkedShape], kinds: Kinds, ink: Mask, rule: LooseRule
) -> tuple[list[InkedShape], Kinds]:
    """Cut runs where they begin or cease to part two areas, and mark what parts none.

    Args:
        shapes, kinds: with what is known by now.
        ink: (h, w) bool, without what was marked.
        rule: which of the runs that part nothing are marked.
    """
    # An outline that faded somewhere still parts the view from the paper.
    areas = (outlined_areas if rule.corners else blank_areas)(ink, rule.bridge)
    faded = blank_areas(ink, rule.faded).labels if rule.faded else None
    paper = paper_around(ink) if rule.closed else None
    ends = _dimensioned(shapes, kinds)
    tips = sharp_tips(shapes)
    cut: list[InkedShape] = []
    cut_kinds: Kinds = []
    for number, (shape, own) in enumerate(zip(shapes, kinds, strict=True)):
        runs: list[InkedRun] = []
        marks: list[AnnotationKind | None] = []
        looked_at = [
            kind is None
            and (run.run.length > rule.shortest or _is_held(shape, run, ends))
            and not _is_in_a_row(shape.runs, k)
            for k, (run, kind) in enumerate(zip(shape.runs, own, strict=True))
        ]
        found = [
            _parts(shape, run, areas, faded, paper) if looked else [(run.run, _Side.PARTING)]
            for run, looked in zip(shape.runs, looked_at, strict=True)
        ]
        found = [_with_tips(parts, tips.get((number, k), ())) for k, parts in enumerate(found)]
        over = [_is_over_paper(parts) for parts in found]
        leading = _leading(shape, over, rule.faded / 2)
        for index, (run, kind) in enumerate(zip(shape.runs, own, strict=True)):
            parts = found[index]
            # A line that runs on over blank paper is no edge, nor is its rest within a view: what
            # that parts only once gaps are closed lies between it and the next such line.
            if faded is not None and leading[index] and looked_at[index]:
                strict = _parts(shape, run, areas, None, paper)
                if any(side is _Side.INSIDE for _, side in strict):
                    parts = strict
            loose = rule.everywhere or (over[index] and _sticks_out(shape, run, ink))
            led_in = rule.everywhere and over[index] and _is_led_in(shape, run, parts, ink)
            if not over[index]:
                parts = _with_run_out(parts, rule.shortest)
            for place, (part, side) in enumerate(parts):
                runs.append(InkedRun(part, run.width))
                # Nothing is known beside an arrowhead; what an extension line crosses stays.
                within = 0 < place < len(parts) - 1 and part.length < rule.shortest / 2
                parting = (side is _Side.PARTING and not within and not led_in) or not loose
                marks.append(kind if parting else AnnotationKind.EXTENSION)
        cut.append(InkedShape(shape.geometry, tuple(runs)))
        cut_kinds.append(marks)
    return cut, cut_kinds


def _with_tips(parts: list[tuple[Run, _Side]], tips: Sequence[Tip]) -> list[tuple[Run, _Side]]:
    """The stretches of a run, of which what seems to lie over paper at a sharp tip is an edge's."""
    return [
        (part, _Side.PARTING)
        if any(
            part.length <= tip.reach and min(abs(part.start - tip.at), abs(part.end - tip.at)) < 1.0
            for tip in tips
        )
        else (part, side)
        for part, side in parts
    ]


def _with_run_out(parts: list[tuple[Run, _Side]], least: float) -> list[tuple[Run, _Side]]:
    """The stretches of a run within a view, of which the one at its end, that parts nothing, is an
    edge's as well where a longer one goes on as it: edges run out where faces become tangent.

    The arms of centre marks run out on both sides, or not so far.

    Args:
        parts: of a run.
        least: px that an edge runs out at least.
    """
    found = list(parts)
    if len(parts) > 1 and (parts[0][1] is _Side.INSIDE) != (parts[-1][1] is _Side.INSIDE):
        end, beside = (0, 1) if parts[0][1] is _Side.INSIDE else (-1, -2)
        out, (other, side) = parts[end][0], parts[beside]
        if side is _Side.PARTING and least < out.length < other.length:
            found[end] = out, _Side.PARTING
    return found


def _dimensioned(shapes: Sequence[InkedShape], kinds: Kinds) -> npt.NDArray[np.float64]:
    """(n, 4) px, the ends of the dimension lines and their directions."""
    ends = [
        (*shape.geometry.at(place), *shape.geometry.direction)
        for shape, own in zip(shapes, kinds, strict=True)
        if isinstance(shape.geometry, Line)
        for run, kind in zip(shape.runs, own, strict=True)
        if kind is AnnotationKind.DIMENSION
        for place in (run.run.start, run.run.end)
    ]
    return np.array(ends).reshape(-1, 4)


def _is_held(shape: InkedShape, run: InkedRun, ends: npt.NDArray[np.float64]) -> bool:
    """Whether a dimension line ends square on a straight run, about where that ends."""
    if not isinstance(shape.geometry, Line):
        return False
    width = run.width or 2.0
    along, across = shape.geometry.coordinates(ends[:, :2])
    square = np.abs(ends[:, 2:] @ np.array(shape.geometry.direction)) < _SQUARE
    inside = np.minimum(along - run.run.start, run.run.end - along)
    near = (np.abs(across) <= width) & (inside > -width) & (inside < _OVER * width)
    return bool((square & near).any())


def _is_in_a_row(runs: Sequence[InkedRun], k: int) -> bool:
    """Whether a run is dashes that a crossing stroke joins: those on both sides of it are not much
    shorter, and nearer than they are long.  The dots beside a centre line's dashes are."""
    if not 0 < k < len(runs) - 1:
        return False
    own, before, after = runs[k].run, runs[k - 1].run, runs[k + 1].run
    shortest = min(before.length, after.length)
    farthest = max(own.start - before.end, after.start - own.end)
    return shortest >= _JOINED * own.length and farthest < shortest


def _is_over_paper(parts: list[tuple[Run, _Side]]) -> bool:
    return any(side is _Side.PAPER and part.length > _LEAST_OUT_PX for part, side in parts)


def _leading(shape: InkedShape, over: list[bool], gap: float) -> list[bool]:
    """Which runs lead on over paper, or follow one that does after a gap, as where an extension
    line crosses the outline."""
    leading = list(over)
    order = range(1, len(over))
    for way in (order, reversed(order)):
        for k in way:
            apart = shape.runs[k].run.start - shape.runs[k - 1].run.end
            if apart <= gap and isinstance(shape.geometry, Line):
                leading[k - 1] = leading[k] = leading[k - 1] or leading[k]
    return leading


def _is_led_in(shape: InkedShape, run: InkedRun, parts: list[tuple[Run, _Side]], ink: Mask) -> bool:
    """Whether a straight run that leads in from the paper is an annotation all along: it is slanted
    and crosses the outline, as leaders do, or ends at nothing within the view.

    An edge that an extension line goes on from may have such a gap as well, on a copy.
    """
    if not isinstance(shape.geometry, Line):
        return False
    slanted = min(map(abs, shape.geometry.direction)) > _SLANTED
    longest = max((part.length for part, side in parts if side is _Side.PAPER), default=0.0)
    if slanted and longest > _LED_PX:
        return True
    return any(
        is_free_end(shape.geometry, position, outward, run.width or 2.0, ink)
        for position, outward in ((run.run.start, -1.0), (run.run.end, 1.0))
        if not _near_paper(position, parts)
    )


def _near_paper(position: float, parts: list[tuple[Run, _Side]]) -> bool:
    """Whether an end of a run lies over paper."""
    return any(
        side is _Side.PAPER and min(abs(part.start - position), abs(part.end - position)) < 1.0
        for part, side in parts
    )


def is_free_end(line: Line, position: float, outward: float, width: float, ink: Mask) -> bool:
    """Whether paper is right ahead of an end of a run, and no other line meets it there."""
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    end = np.array(line.at(position))
    ahead = np.arange(*_FREE_AHEAD)
    # A rounding goes on beside the line, and so does what meets its end.
    across = np.arange(-width / 2 - _BEND_PX, width / 2 + _BEND_PX + 1.0)
    places = end + outward * ahead[:, None, None] * direction + across[:, None] * normal
    blank = ~values_at(ink, places.reshape(-1, 2)).reshape(len(ahead), -1).any(axis=1)
    back, aside = np.arange(-_BACK_PX, 1.0), width / 2 + np.arange(2.0, _AROUND_PX)
    flanks = np.concatenate([aside, -aside])
    beside = end + outward * back[:, None, None] * direction + flanks[:, None] * normal
    return bool((blank[:-1] & blank[1:]).any()) and not values_at(ink, beside.reshape(-1, 2)).any()


def _sticks_out(shape: InkedShape, run: InkedRun, ink: Mask) -> bool:
    """Whether a straight run ends on blank paper: nothing goes on ahead or meets it there.

    At a sharp corner nothing is ahead either, but the other edge is beside the end.
    """
    if not isinstance(shape.geometry, Line):
        return False
    direction = np.array(shape.geometry.direction)
    normal = np.array([-direction[1], direction[0]])
    ahead, across = np.arange(3.0, _AHEAD_PX), np.arange(-_AROUND_PX, _AROUND_PX + 1.0)
    here, beside = np.arange(-_BACK_PX, 1.0), (run.width or 2.0) / 2 + np.arange(2.0, _AROUND_PX)
    for position, outward in ((run.run.start, -1.0), (run.run.end, 1.0)):
        end = np.array(shape.geometry.at(position))
        around = ((ahead, across), (here, beside), (here, -beside))
        if not any(
            values_at(
                ink,
                (
                    end + outward * along[:, None, None] * direction + aside[:, None] * normal
                ).reshape(-1, 2),
            ).any()
            for along, aside in around
        ):
            return True
    return False


def _parts(
    shape: InkedShape,
    run: InkedRun,
    areas: BlankAreas,
    faded: npt.NDArray[np.int32] | None,
    paper: Mask | None,
) -> list[tuple[Run, _Side]]:
    """Stretches of a run, and what lies on both sides of each.

    Args:
        shape, run: a run of a shape.
        areas: gaps of some px closed.
        faded: labels of areas, wider gaps closed.
        paper: (h, w) bool, what is known to lie outside of all views.
    """
    points = points_along(shape.geometry, run.run, 1.0)
    normals = normals_along(shape.geometry, run.run, 1.0)
    beside = (run.width or 2.0) / 2 + 2.5
    flanks = [points + side * beside * normals for side in (1.0, -1.0)]
    left, right = (values_at(areas.labels, flank) for flank in flanks)
    known = np.flatnonzero((left > 0) & (right > 0))
    if len(known) < _SHORTEST_PX:
        return [(run.run, _Side.PARTING)]
    places = np.searchsorted(known, np.arange(len(points))).clip(1, len(known) - 1)
    ahead, behind = known[places], known[places - 1]
    index = np.arange(len(points))
    nearest = np.where(index - behind < ahead - index, behind, ahead)
    same = left == right
    if faded is not None:
        one, other = (values_at(faded, flank) for flank in flanks)
        same &= (one == other) | (one == 0) | (other == 0)
    sides = np.where(same & (left == areas.paper), _Side.PAPER, np.where(same, _Side.INSIDE, 0))
    if paper is not None:
        sides[np.logical_and(*(values_at(paper, flank) for flank in flanks))] = _Side.PAPER
    # What lies beside is not known between near lines; what is known far off says nothing there.
    told = np.where(np.abs(nearest - index) <= 2 * _STEADY, sides[nearest], _Side.PARTING)
    steady = median_filter(told.astype(np.uint8), 2 * _STEADY + 1)
    borders = [0, *(np.flatnonzero(np.diff(steady)) + 1), len(steady)]
    step = run.run.length / len(steady)
    return [
        (Run(run.run.start + first * step, run.run.start + last * step), _Side(int(steady[first])))
        for first, last in pairwise(borders)
    ]


def lettered_boxes(ink: Mask, letters: Sequence[Mark]) -> Mask:
    """(h, w) the ink of boxes around letters: tolerance frames, datum letters."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    chosen = np.zeros(len(stats), dtype=bool)
    for label in range(1, len(stats)):
        x, y, width, height = (float(value) for value in stats[label, :4])
        within = [
            mark.box
            for mark in letters
            if x <= (mark.box[0] + mark.box[2]) / 2 <= x + width
            and y <= (mark.box[1] + mark.box[3]) / 2 <= y + height
        ]
        if not within:
            continue
        filled = sum((x1 - x0) * (y1 - y0) for x0, y0, x1, y1 in within)
        tallest = max(min(x1 - x0, y1 - y0) for x0, y0, x1, y1 in within)
        flat = min(width, height) < _BOX_HEIGHT * tallest
        chosen[label] = flat and filled > _LETTERED * width * height
    return chosen[labels]
