"""Slim arrowheads, told by the width of their line: it grows from the tip and falls at once behind.

On sheets whose lines are all of one width a head may be no more than twice as wide as its line, so
that it makes no blot.  Crossings and blots widen a line before and behind alike, slanted strokes
that end on it on one side, and corners that it ends in by more than any head.  Between two other
strokes that begin where it does it is as wide as a head, too, but these go on behind it.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.line_widths import sides_along
from gaussiancad_core.sheet.shapes import sample

Floats = npt.NDArray[np.float64]

_WIDER, _WIDER_PX = 1.25, 0.8
"""Width of a head at its widest at least, in that of its line, and beyond it in px."""

_PLAIN, _PLAIN_PX = 1.1, 0.2
"""Width up to which a line is as wide as elsewhere: a share of it, and px beyond."""

_TIP, _TIP_PX = 1.04, 0.1
"""The same where a head begins."""

_SHARP = 0.6
"""Width of a head where another stroke hides its tip at most, as a share of its widest."""

_HIDDEN_PX = 3
"""px over which the width may be unknown in the middle of a head."""

_RISE_PX = 4
"""px over which a head widens at least."""

_STEEPEST = 1.5
"""px by which a head widens over one at most: a line into a square corner by two."""

_KNOWN = 0.6
"""Share of a head over which its width is known, more than that: beside a crossing it is not."""

_STEADY, _STEADY_PX = 0.08, 0.25
"""By how much a head may become narrower before its widest place: a share of its line, and px."""

_FALL, _FALL_PX = 0.5, 1.5
"""How fast a head ends: px over which the line narrows at most, in those over which it widens, and
beyond."""

_BEHIND_PX = 4
"""px behind a head in which its line is as wide as elsewhere."""

_LONGEST = 16.0
"""Length of a head at most, in widths of its line."""

_ON_PX = (3, 9)
"""px behind its widest place, from and to, where strokes beside a line go on that are no head."""

_ON = 0.7
"""Share of these at which there is ink again on both sides, beyond paper, at least."""

_WIDENING = 1.5
"""How far away that is at most, in what the widening behind the tip leads to."""

_INK = 0.35
"""Share of full ink from which there is some."""

_AT_END = 18.0
"""Distance of a lone head from its line's end at most, in widths of the line."""


def mark_tapered(shapes: list[InkedShape], kinds: Kinds, sheet: CleanSheet) -> None:
    """Mark straight runs with slim heads on them as dimension lines, in place.

    One head counts where its tip points to the run's end, near it; two do anywhere.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is known to be.
        sheet: their ink.
    """
    for shape, own in zip(shapes, kinds, strict=True):
        if not isinstance(shape.geometry, Line):
            continue
        for k, run in enumerate(shape.runs):
            if own[k] is not None or run.width is None:
                continue
            # Where a slanted stroke ends on a line, that is wider on one side alone.
            widths = 2.0 * sides_along(sheet, shape.geometry, run.run).min(axis=1)
            forwards, backwards = (
                [
                    place
                    for place in tapers(side, run.width)
                    if not _is_between_strokes(sheet, line, place, side[place])
                ]
                for side, line in (
                    (widths, _from_end(shape.geometry, run.run.start, 1.0)),
                    (widths[::-1], _from_end(shape.geometry, run.run.end, -1.0)),
                )
            )
            near = [p for p in (*forwards, *backwards) if p < _AT_END * run.width]
            if near or len(forwards) + len(backwards) > 1:
                own[k] = AnnotationKind.DIMENSION


def _from_end(line: Line, end: float, way: float) -> Line:
    """The same line, from one of its run's ends on."""
    x, y = line.direction
    return Line(line.at(end), (way * x, way * y))


def _is_between_strokes(sheet: CleanSheet, line: Line, place: int, width: float) -> bool:
    """Whether what widens a line up to a place goes on behind it, beyond paper, on both sides."""
    behind = np.arange(*_ON_PX)
    points, normal = (
        line.points_at(place + behind.astype(float)),
        (-line.direction[1], line.direction[0]),
    )
    found = []
    for side in (1.0, -1.0):
        inked = []
        for point, on in zip(points, behind.tolist(), strict=True):
            far = _WIDENING * 0.5 * width * (place + on) / max(place, 1)
            away = side * np.arange(0.0, far + 1.0, 0.5)
            row = (
                sample(sheet.weight, point[0] + normal[0] * away, point[1] + normal[1] * away)
                > _INK
            )
            paper = np.flatnonzero(~row)
            inked.append(len(paper) > 0 and bool(row[paper[0] :].any()))
        found.append(np.mean(inked))
    return min(found) >= _ON


def tapers(widths: Floats, width: float) -> list[int]:
    """Where heads are widest whose tips point to a line's start.

    Args:
        widths: (n,) px of ink across the line, about every px; NaN where it is not known.
        width: px of the line.

    Returns:
        Numbers of places along the line.
    """
    known = _without_gaps(widths)
    plain, tip_width = _PLAIN * width + _PLAIN_PX, _TIP * width + _TIP_PX
    wide = np.flatnonzero(known >= max(_WIDER * width, width + _WIDER_PX))
    if not len(wide):
        return []
    found = []
    for group in np.split(wide, np.flatnonzero(np.diff(wide) > 2) + 1):
        peak = int(group[np.argmax(known[group])])
        before = known[: peak + 1]
        tip = _last((before <= tip_width) | np.isnan(before))
        behind = _first(known[peak:] <= plain)
        if behind is None:
            continue
        tip = -1 if tip is None else tip
        hidden = tip < 0 or np.isnan(known[tip])
        rising = known[tip + 1 : peak + 1]
        after = known[peak + behind : peak + behind + _BEHIND_PX]
        if (
            _RISE_PX <= len(rising) <= _LONGEST * width
            and behind <= _FALL_PX + _FALL * len(rising)
            and float(rising[-1] - rising[0]) <= _STEEPEST * (len(rising) - 1)
            and float(np.diff(rising).min()) > -(_STEADY * width + _STEADY_PX)
            and np.isfinite(widths[tip + 1 : peak + 1]).mean() > _KNOWN
            and (not hidden or rising[0] < _SHARP * rising[-1])
            and len(after) == _BEHIND_PX
            and bool((after <= plain).all())
        ):
            found.append(peak)
    return found


def _without_gaps(widths: Floats) -> Floats:
    """The widths, what is unknown between two that are not far apart laid in between."""
    known = np.flatnonzero(np.isfinite(widths))
    if len(known) < 2:
        return widths
    filled = np.interp(np.arange(len(widths)), known, widths[known])
    after = np.searchsorted(known, np.arange(len(widths)))
    inside = (after > 0) & (after < len(known))
    far = np.ones(len(widths), dtype=bool)
    gap = known[after[inside]] - known[after[inside] - 1]
    far[inside] = gap > _HIDDEN_PX + 1
    return np.where(np.isnan(widths) & far, np.nan, filled)


def _last(told: npt.NDArray[np.bool_]) -> int | None:
    places = np.flatnonzero(told)
    return int(places[-1]) if len(places) else None


def _first(told: npt.NDArray[np.bool_]) -> int | None:
    places = np.flatnonzero(told)
    return int(places[0]) if len(places) else None
