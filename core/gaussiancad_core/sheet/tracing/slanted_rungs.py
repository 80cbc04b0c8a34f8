"""Slanted rungs: short strokes aslant across the gap between two parallel lines.

The flanks of a narrow V-groove, or of an undercut beside a shoulder, are as long as a few line
widths.  Like those of a straight rung their ends merge with the lines that they join.  What is dark
between the lines moves along them from the one to the other at an even pace.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    CLEAR,
    COURSE,
    DARK,
    FEWEST_PLACES,
    FINE_STEP,
    FREE,
    INFERRED,
    NARROWEST,
    ON_LINE,
    STEP,
    WIDEST,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, runs_of_ink
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.line_widths import Pens
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.tracing.rungs import Gap, gaps_between

Floats = npt.NDArray[np.float64]

_FLATTEST, _STEEPEST = 0.35, 2.2
"""px along the lines that a rung moves for each px across."""

_SEEN_ASLANT = 0.2
"""The same of the ink between the lines, at least."""

_BEYOND = 1.2
"""Widths of a gap by which its ends are farther out at one line than at the other."""

_CORNER_PX = 1.6
"""px along a line from where a rung meets it to the corner that it starts from."""

_LOOSE = 0.12
"""px more by which it may be off for each end that is at a corner."""

_FEWEST = 2
"""Tracks that show a rung between two corners, at least."""


@dataclass(frozen=True, eq=False)
class _Course:
    """Where the ink crosses a gap.

    Attributes:
        across: (n,) px from the one line, of each track.
        along: (n,) px along the lines, of the middle of the ink there.
        wide: (n,) px of ink along the lines there.
    """

    across: Floats
    along: Floats
    wide: Floats

    def off(self, start: float, pace: float) -> float:
        """px by which it is off a straight course, at most."""
        return float(np.abs(self.along - start - pace * self.across).max())

    def fitted(self) -> tuple[float, float]:
        """Where along the one line it starts, and px along for each px across."""
        pace, start = np.polyfit(self.across, self.along, 1)
        return float(start), float(pace)

    def pace_from(self, start: float, across: float) -> float:
        """The same pace of the course through a place on one of the lines."""
        away = self.across - across
        return float((self.along - start) @ away / (away @ away))


def find_slanted_rungs(
    pieces: Sequence[Placed], sheet: CleanSheet, pens: Pens | None = None
) -> list[Placed]:
    """Strokes that join two parallel visible lines close by aslant.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
        pens: what widths tell; nothing if left out.

    Returns:
        Lines from one line to the other.
    """
    found: list[Placed] = []
    least = sheet.stroke_width + 2.0 * CLEAR + STEP
    for between in gaps_between(pieces, sheet.stroke_width, least):
        # Outwards a flank goes on beyond the shorter line.
        low, high = between.span
        aside = _BEYOND * between.width
        gap = replace(between, span=(low - aside, high + aside))
        corners = _corners(gap, pieces)
        for course in _courses(gap, sheet):
            ends = _settled(course, corners, gap)
            if ends is None:
                continue
            first = gap.origin + ends[0] * gap.along
            last = gap.origin + ends[1] * gap.along + gap.width * gap.across
            middle = (first + last)[None] / 2.0
            if min(distances_to(piece, middle)[0] for piece in (*pieces, *found)) > (
                FREE * sheet.stroke_width
            ):
                width = float(np.median(course.wide)) / np.hypot(1.0, course.fitted()[1])
                kind = pens.kind(width) if pens is not None and pens.distinct else None
                found.append(_rung(first, last, kind or Linetype.VISIBLE))
    return found


def _corners(gap: Gap, pieces: Sequence[Placed]) -> tuple[Floats, Floats]:
    """Positions along a gap of the ends of strokes on its one line, and on the other."""
    ends = np.array(
        [
            line.at(at)
            for line, piece in pieces
            if isinstance(line, Line) and piece.linetype is Linetype.VISIBLE
            for at in (piece.start, piece.end)
        ]
    )
    away = (ends - gap.origin) @ gap.across
    along = (ends - gap.origin) @ gap.along
    near = (along > gap.span[0] - _CORNER_PX) & (along < gap.span[1] + _CORNER_PX)
    on_one, on_other = (near & (np.abs(away - at) < 1.0) for at in (0.0, gap.width))
    return along[on_one], along[on_other]


def _courses(gap: Gap, sheet: CleanSheet) -> Iterator[_Course]:
    """Ink as wide as a pen that goes straight across a gap."""
    clear = sheet.stroke_width / 2.0 + CLEAR
    tracks = np.arange(clear, gap.width - clear + 1e-9, STEP)
    places = np.arange(gap.span[0], gap.span[1] + FINE_STEP, FINE_STEP)
    points = gap.origin + places[:, None, None] * gap.along + tracks[None, :, None] * gap.across
    ink = sample(sheet.weight, points[..., 0], points[..., 1])
    dark = [runs_of_ink(column > DARK) for column in ink.T]
    for start in dark[0] if len(tracks) >= _FEWEST else ():
        chain = [start]
        for runs in dark[1:]:
            offset = [run for run in runs if _leads_on(chain[-1], run)]
            chain += offset if len(offset) == 1 else []
        if len(chain) < len(tracks) or any(
            pair[0] == 0 or pair[1] + 1 == len(places) for pair in chain
        ):
            continue
        seen = [_ink_of(places, *pair) for pair in zip(ink.T, chain, strict=True)]
        middles, widths = np.array(seen).T
        course = _Course(tracks, middles, widths)
        shift, pace = course.fitted()
        wide = np.array([(last - first + 1) * FINE_STEP for first, last in chain]) / np.hypot(
            1.0, pace
        )
        like_pen = (wide >= NARROWEST * sheet.stroke_width) & (wide <= WIDEST * sheet.stroke_width)
        straight = course.off(shift, pace) <= COURSE
        if like_pen.all() and straight and abs(pace) >= _SEEN_ASLANT:
            yield course


def _leads_on(run: tuple[int, int], following: tuple[int, int]) -> bool:
    """Whether ink on a track goes on in that on the next one."""
    moved = abs(sum(run) - sum(following)) / 2.0 * FINE_STEP
    return moved <= _STEEPEST * STEP + COURSE


def _ink_of(places: Floats, ink: Floats, run: tuple[int, int]) -> tuple[float, float]:
    """The middle of a run's ink on a track, and px of it."""
    part = slice(max(0, run[0] - 2), run[1] + 3)
    values = ink[part]
    return float(np.average(places[part], weights=values)), float(values.sum()) * FINE_STEP


def _settled(
    course: _Course, corners: tuple[Floats, Floats], gap: Gap
) -> tuple[float, float] | None:
    """Positions along both lines between which a stroke has the ink of a course: from corner to
    corner, else from one, else where it was measured well enough; None if it is not aslant."""
    start, pace = course.fitted()
    rough = start, start + pace * gap.width
    one, other = (
        corner[np.abs(corner - at) < _CORNER_PX] for corner, at in zip(corners, rough, strict=True)
    )
    tried = [((float(a), float(b)), 0.0) for a in one for b in other]
    for a in one.tolist():
        tried.append(((a, a + course.pace_from(a, 0.0) * gap.width), _LOOSE))
    for b in other.tolist():
        tried.append(((b - course.pace_from(b, gap.width) * gap.width, b), _LOOSE))
    if len(course.across) >= FEWEST_PLACES:
        tried.append((rough, 2.0 * _LOOSE))
    fitting = [(_off(course, ends, gap) + extra, ends) for ends, extra in tried]
    fitting = [(off, ends) for off, ends in fitting if _is_aslant(ends, gap) and off <= ON_LINE]
    return min(fitting)[1] if fitting else None


def _off(course: _Course, ends: tuple[float, float], gap: Gap) -> float:
    return course.off(ends[0], (ends[1] - ends[0]) / gap.width)


def _is_aslant(ends: tuple[float, float], gap: Gap) -> bool:
    return _FLATTEST <= abs(ends[1] - ends[0]) / gap.width <= _STEEPEST


def _rung(first: Floats, last: Floats, kind: Linetype) -> Placed:
    """A stroke from (2,) px to (2,) px."""
    length = float(np.hypot(*(last - first)))
    x, y = ((last - first) / length).tolist()
    line = Line((float(first[0]), float(first[1])), (x, y))
    return line, Piece(0.0, length, kind, INFERRED)
