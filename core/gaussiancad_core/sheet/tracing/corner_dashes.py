"""Hidden lines too short for their dashes to be told: legs between a corner and the next stroke.

A hidden line of little more than a dash is drawn as two ends of dashes with a gap.  What tells it
is the corner: a hidden line ends, and its last dash goes on at a right angle.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import DARK, INFERRED, ONE_PLACE, STEP
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, runs_of_ink, widest_gap
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.outline_jogs import distance_to
from gaussiancad_core.sheet.tracing.parted_lines import wide_gaps
from gaussiancad_core.sheet.tracing.small_fillets import boxes_of
from gaussiancad_core.sheet.work_limits import ENDS

_LONGEST = 2.0
"""Dashes with their gaps that a leg is long at most."""

_TICK = 2.0
"""px of ink beside the line at least that its dash goes on with."""

_INKED = 0.35
"""Share of a leg that is ink, at least."""

_SOLID = 0.8
"""Dashes that a leg is long at most to have no gap: too short for a line to be grown from."""

_WITHIN = (0.25, 0.5)
"""Widths of a stroke by which a corner lies before the end of its ink."""

_ALONG = 0.99
"""Cosine of the angle between a leg and a line that it is a dash of."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class _Corner:
    """The end of a hidden line: its number, the corner (2,) px, and a unit vector to one side."""

    index: int
    place: Floats
    aside: Floats


def find_corner_dashes(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """Hidden legs from the ends of hidden lines to the next stroke at a right angle.

    Args:
        pieces: of a view, with their ends where their ink ends; px.
        sheet: its ink.
        rhythm: of its dashes.
    """
    found: list[Placed] = []
    if len(pieces) > ENDS:
        return found
    boxes = boxes_of(pieces)
    reach = _LONGEST * (rhythm.dash + rhythm.gap) + sheet.stroke_width + ONE_PLACE
    for corner in _corners(pieces, sheet, rhythm):
        near = (boxes[:, 0] <= corner.place + reach) & (boxes[:, 1] >= corner.place - reach)
        near[corner.index] = False
        around = [pieces[k] for k in np.flatnonzero(near.all(axis=1)).tolist()]
        leg = _leg(corner, [*around, *found], sheet, rhythm)
        if leg is not None:
            found.append(leg)
    return found


def _corners(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> Iterator[_Corner]:
    """The ends of hidden lines, and those that a wide gap in one may have."""
    for index, (geometry, piece) in enumerate(pieces):
        if not isinstance(geometry, Line) or piece.linetype is not Linetype.HIDDEN:
            continue
        dx, dy = geometry.direction
        ends = [(piece.start, -1.0), (piece.end, 1.0)]
        for low, high in wide_gaps(geometry, piece, sheet, rhythm):
            ends += [(low, 1.0), (high, -1.0)]
        for at, way in [(piece.start, -1.0), (piece.end, 1.0)]:
            beyond = _next_dash_end(geometry, at, way, sheet, rhythm)
            if beyond is not None:
                ends.append((beyond, way))
        for at, way in ends:
            # Hidden lines may be as wide as others or half of that.
            places = [np.array(geometry.at(at - way * sheet.stroke_width * w)) for w in _WITHIN]
            for side in (-1.0, 1.0):
                for place in places:
                    yield _Corner(index, place, side * np.array([-dy, dx]))


def _next_dash_end(
    line: Line, at: float, way: float, sheet: CleanSheet, rhythm: Rhythm
) -> float | None:
    """Where the ink ends that follows a line's end after a gap, if it is a dash or a part of one:
    so short beside its corner that no ridge runs along it."""
    away = np.arange(1.0, widest_gap(rhythm) + (1.0 + LIKE_A_DASH) * rhythm.dash + 2.0, STEP)
    points = line.points_at(at + way * away)
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > DARK
    stretches = runs_of_ink(dark)
    if not stretches:
        return None
    first, last = stretches[0]
    long_enough = (
        sheet.stroke_width <= away[last] - away[first] <= (1.0 + LIKE_A_DASH) * rhythm.dash
    )
    gap = 1.0 < away[first] <= widest_gap(rhythm) + 1.0
    return at + way * float(away[last]) if gap and long_enough and last < len(away) - 1 else None


def _leg(
    corner: _Corner, others: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm
) -> Placed | None:
    """The leg that leaves a corner; None if no ink does, or it is another stroke's."""
    width = sheet.stroke_width
    places = np.arange(0.0, _LONGEST * (rhythm.dash + rhythm.gap), STEP)
    points = corner.place + places[:, None] * corner.aside
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > DARK
    offset = width / 2.0
    tick = (places > offset) & (places < offset + _TICK)
    if not dark[tick].all() or _is_taken(points[tick][-1], others, width):
        return None
    ends = (k for k in np.flatnonzero(places > 2.0 * width) if _is_taken(points[k], others, 0.0))
    end = next(ends, None)
    if end is None or _is_led_on(corner.aside, points[end], others):
        return None
    inked = dark[: end + 1]
    blank = longest_blank(inked) * STEP
    if inked.mean() < _INKED or blank > widest_gap(rhythm):
        return None
    if blank < 1.0 and places[end] > _SOLID * rhythm.dash:
        # Ink without any gap would have been found as a line.
        return None
    (x, y), (dx, dy) = map(float, corner.place), map(float, corner.aside)
    line = Line((x, y), (dx, dy))
    return line, Piece(0.0, float(places[end]), Linetype.HIDDEN, INFERRED)


def _is_led_on(way: Floats, point: Floats, others: Sequence[Placed]) -> bool:
    """Whether a hidden line along a way ends at a point: what leads there is a dash of its own."""
    return any(
        isinstance(other[0], Line)
        and other[1].linetype is Linetype.HIDDEN
        and abs(float(np.dot(other[0].direction, way))) > _ALONG
        and distance_to(other, point) <= ONE_PLACE
        for other in others
    )


def _is_taken(point: Floats, others: Sequence[Placed], width: float) -> bool:
    """Whether a point lies on another stroke, or within its ink."""
    return any(distance_to(other, point) <= width / 2.0 + ONE_PLACE for other in others)


def longest_blank(dark: npt.NDArray[np.bool_]) -> int:
    """How many places in a row of (n,) are blank at most."""
    padded = np.concatenate([[True], dark, [True]]).astype(np.int8)
    starts, ends = np.flatnonzero(np.diff(padded) == -1), np.flatnonzero(np.diff(padded) == 1)
    return int((ends - starts).max(initial=0))
