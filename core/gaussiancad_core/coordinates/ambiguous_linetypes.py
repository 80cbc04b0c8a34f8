"""Strokes of which nothing tells whether they are visible or hidden.

On sheets whose lines are all of one width the dashes alone tell hidden lines.  One that is no
longer than a dash is drawn as a short solid line, and so is a short end by which an edge goes on
behind another: what it is only the other views tell.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import cast

import numpy as np
import numpy.typing as npt

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import MEETING, TELLING, WELL_READ
from gaussiancad_core.lines.line_points import Lines, lines_of_strokes
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.votes import MOST

UNSURE = 0.4
"""Confidence up to which a stroke may be of either linetype; readers tell more of each."""

Points = npt.NDArray[np.float64]


def with_unsure_kinds(views: DrawnViews) -> DrawnViews | None:
    """The views with parts of strokes that may be of either linetype as strokes of their own.

    Args:
        views: as read.

    Returns:
        None if all linetypes are known.
    """
    if views.dash is None:
        return None
    strokes = {}
    found = False
    for role, curves in views.strokes.items():
        points = [stroke.sample(WELL_READ * views.tolerance) for stroke in curves]
        parts = [_parts(curves, number, points, views) for number in range(len(curves))]
        strokes[role] = tuple(part for stroke in parts for part in stroke)
        found |= any(is_unsure(part) for part in strokes[role])
    return replace(views, strokes=strokes) if found else None


def is_unsure(stroke: object) -> bool:
    """Whether a stroke, or a stretch of one, may be of either linetype."""
    return 0.0 < getattr(stroke, "confidence", 1.0) <= UNSURE


def as_drawn(
    strokes: Sequence[DrawnStroke], drawn: Lines, tolerance: float
) -> tuple[DrawnStroke, ...]:
    """Strokes with those that may be of either linetype as a solid's lines have them.

    Args:
        strokes: of a view, mm.
        drawn: the solid's lines in that view.
        tolerance: mm within which lines are the same.
    """
    return tuple(
        _as_drawn(stroke, drawn, tolerance) if is_unsure(stroke) else stroke for stroke in strokes
    )


def _as_drawn(stroke: DrawnStroke, drawn: Lines, tolerance: float) -> DrawnStroke:
    points = lines_of_strokes([stroke], tolerance / 4.0)
    line_points = points.visible if stroke.linetype is Linetype.VISIBLE else points.hidden
    shares = {
        kind: line_points.share(line_points.near(lines, tolerance))
        for kind, lines in ((Linetype.VISIBLE, drawn.visible), (Linetype.HIDDEN, drawn.hidden))
    }
    other = _other(stroke.linetype)
    if shares[other] > MOST and shares[other] > shares[stroke.linetype]:
        return replace(cast("Segment | Arc", stroke), linetype=other)
    return stroke


def _other(kind: Linetype) -> Linetype:
    return Linetype.HIDDEN if kind is Linetype.VISIBLE else Linetype.VISIBLE


def _parts(
    strokes: Sequence[DrawnStroke], number: int, points: Sequence[Points], views: DrawnViews
) -> Iterator[DrawnStroke]:
    """A stroke, or its parts that are certain and those that are not, in order."""
    stroke, longest = strokes[number], views.dash or 0.0
    if stroke.length <= longest and isinstance(stroke, Segment | Arc):
        yield replace(stroke, confidence=UNSURE)
        return
    if not isinstance(stroke, Segment):
        yield stroke
        return
    low, high = points[number].min(0), points[number].max(0)
    reach = MEETING * views.tolerance
    others = [
        (other, points[k])
        for k, other in enumerate(strokes)
        if k != number
        and (points[k].max(0) >= low - reach).all()
        and (points[k].min(0) <= high + reach).all()
    ]
    places = _met(stroke, others, views.tolerance)
    cuts = [0.0, *places, stroke.length]
    parts = [
        _Part(low, high, TELLING * views.tolerance < high - low <= longest)
        for low, high in pairwise(cuts)
    ]
    if stroke.linetype is Linetype.HIDDEN:
        # Between dashes there are gaps: only at its end may it be the end of a visible one.
        inner = [replace(part, unsure=False) for part in parts[1:-1]]
        parts = [parts[0], *inner, parts[-1]]
    joined: list[_Part] = []
    for part in parts:
        if joined and not part.unsure and not joined[-1].unsure:
            joined[-1] = replace(joined[-1], high=part.high)
        else:
            joined.append(part)
    along = np.subtract(stroke.end, stroke.start) / stroke.length
    for part in joined:
        start, end = (_point(stroke, along, at) for at in (part.low, part.high))
        sure = UNSURE if part.unsure else stroke.confidence
        yield replace(stroke, start=start, end=end, confidence=sure)


@dataclass(frozen=True)
class _Part:
    """A part of a straight stroke, in mm along it."""

    low: float
    high: float
    unsure: bool


def _point(stroke: Segment, along: npt.NDArray[np.float64], position: float) -> tuple[float, float]:
    if position in (0.0, stroke.length):
        return stroke.end if position else stroke.start
    x, y = np.array(stroke.start) + position * along
    return float(x), float(y)


def _met(
    stroke: Segment, others: Sequence[tuple[DrawnStroke, Points]], tolerance: float
) -> list[float]:
    """Positions along a stroke, mm and ascending, at which others cross it or end on it."""
    along = np.subtract(stroke.end, stroke.start) / stroke.length
    across = np.array([-along[1], along[0]])
    reach = MEETING * tolerance
    found: list[float] = []
    for other, points in others:
        offset = points - np.array(stroke.start)
        position, neighbour = offset @ along, offset @ across
        ends = np.abs(neighbour[[0, -1]]) <= reach
        if ends.all() and isinstance(other, Segment):
            # What runs along the stroke ends there.
            found += [float(at) for at in position[[0, -1]]]
            continue
        crossed = np.flatnonzero(neighbour[:-1] * neighbour[1:] <= 0.0)
        if len(crossed):
            found += position[crossed].tolist()
            continue
        found += position[[0, -1]][ends].tolist()
        if isinstance(other, Arc) and not ends.any() and np.abs(neighbour).min() <= tolerance:
            # It touches.
            found.append(float(position[np.abs(neighbour).argmin()]))
    inside = sorted(at for at in found if reach < at < stroke.length - reach)
    return [at for k, at in enumerate(inside) if not k or at - inside[k - 1] > tolerance]
