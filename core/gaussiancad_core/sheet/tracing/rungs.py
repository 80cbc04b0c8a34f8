"""Rungs: short strokes across the gap between two parallel lines.

The shoulder beside a groove, or the rim of a flange, is as long as a few line widths.  Most of its
ink merges with that of the lines that it joins, so that no line is grown from the rest.  But where
the gap between two lines is dark from one to the other, over the width of a pen, there is a stroke.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    CLEAR,
    DARK,
    FINE_STEP,
    FREE,
    INFERRED,
    LEVEL,
    NARROWEST,
    ON_LINE,
    WIDEST,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.line_widths import Pens
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to

Floats = npt.NDArray[np.float64]

_LONGEST = 14.0
"""px between two lines up to which a stroke between them may not have been found as a line."""

_LEAST_GAP = 0.9
"""px between the clear sides of two strokes that a gap is wide at least."""


@dataclass(frozen=True)
class Gap:
    """Where a rung may be.

    Attributes:
        origin: (2,) px on the one line, from which positions along it count.
        along, across: (2,) unit vectors; the other line lies across.
        span: px from where to where along both lines.
        width: px from one line to the other.
    """

    origin: Floats
    along: Floats
    across: Floats
    span: tuple[float, float]
    width: float


def find_rungs(pieces: Sequence[Placed], sheet: CleanSheet, pens: Pens | None) -> list[Placed]:
    """Strokes that join two parallel visible lines close by at right angles.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
        pens: what widths tell; nothing if left out.

    Returns:
        Lines from one line to the other.
    """
    found: list[Placed] = []
    least = sheet.stroke_width + 2.0 * CLEAR + _LEAST_GAP
    for gap in gaps_between(pieces, sheet.stroke_width, least):
        for at, wide in _dark_places(gap, sheet):
            start = gap.origin + at * gap.along
            middle = start + gap.width / 2.0 * gap.across
            others = (distances_to(piece, middle[None])[0] for piece in (*pieces, *found))
            if min(others) > FREE * sheet.stroke_width:
                kind = pens.kind(wide) if pens is not None and pens.distinct else None
                found.append(_rung(start, gap, kind or Linetype.VISIBLE))
    return found


def gaps_between(pieces: Sequence[Placed], stroke_width: float, least: float) -> Iterator[Gap]:
    """The gaps of so many px at least between visible lines that run beside each other, with
    nothing between them."""
    lines = [
        (this_line, piece)
        for this_line, piece in pieces
        if isinstance(this_line, Line) and piece.linetype is Linetype.VISIBLE
    ]
    if not lines:
        return
    starts = np.array([this_line.at(piece.start) for this_line, piece in lines])
    ends = np.array([this_line.at(piece.end) for this_line, piece in lines])
    ways = np.array([this_line.direction for this_line, _ in lines])
    for number, (line, piece) in enumerate(lines):
        along = np.array(line.direction)
        across = np.array([-along[1], along[0]])
        firsts, lasts = (line.positions(points) for points in (starts, ends))
        low = np.maximum(np.minimum(firsts, lasts), piece.start)
        high = np.minimum(np.maximum(firsts, lasts), piece.end)
        # The ink of a stroke ends half its width beyond the corner.
        neighbour = (np.abs(ways @ across) < LEVEL) & (low - stroke_width < high)
        for way in (across, -across):
            away = ((starts + ends) / 2.0 - starts[number]) @ way
            near = neighbour & (away >= least) & (away <= _LONGEST)
            for other in np.flatnonzero(near[:number]):
                between = near & (away < away[other] - least / 2.0)
                between &= (low <= low[other] + stroke_width) & (high >= high[other] - stroke_width)
                if not between.any():
                    span = float(low[other]) - stroke_width, float(high[other]) + stroke_width
                    yield Gap(np.array(line.point), along, way, span, float(away[other]))


def _dark_places(gap: Gap, sheet: CleanSheet) -> Iterator[tuple[float, float]]:
    """Where along a gap it is dark from one line to the other, and px over which it is."""
    offset = sheet.stroke_width / 2.0 + CLEAR
    tracks = np.arange(offset, gap.width - offset + 1e-9, 2.0 * FINE_STEP)
    along = np.arange(gap.span[0], gap.span[1] + FINE_STEP, FINE_STEP)
    points = gap.origin + along[:, None, None] * gap.along + tracks[None, :, None] * gap.across
    ink = sample(sheet.weight, points[..., 0], points[..., 1])
    dark = np.concatenate([[False], ink.min(axis=1) > DARK, [False]])
    for first, last in np.flatnonzero(np.diff(dark.astype(int))).reshape(-1, 2):
        wide = (last - first) * FINE_STEP
        if not NARROWEST <= wide / sheet.stroke_width <= WIDEST:
            continue
        # All its ink, down to the paper on both sides.
        reach = int(np.ceil(sheet.stroke_width / FINE_STEP))
        part = slice(max(0, first - reach), last + reach)
        values = ink[part]
        if values[0].max() > DARK or values[-1].max() > DARK:
            continue
        centres = (along[part, None] * values).sum(axis=0) / values.sum(axis=0)
        if np.ptp(centres) <= ON_LINE:
            yield float(np.median(centres)), float(np.median(values.sum(axis=0))) * FINE_STEP


def _rung(start: Floats, gap: Gap, kind: Linetype) -> Placed:
    """A stroke from (2,) px on the one line to the other."""
    x, y = gap.across.tolist()
    line = Line((float(start[0]), float(start[1])), (x, y))
    return line, Piece(0.0, gap.width, kind, INFERRED)
