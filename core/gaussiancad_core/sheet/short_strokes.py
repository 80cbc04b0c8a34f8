"""Short strokes between two others, too bent for a line to be grown from and too flat for an arc.

Where two surfaces meet, curves of a few line widths end on edges at both ends.  Their ink is left
when all else is explained: what is straight to a pixel is drawn as a line up to the strokes that it
runs into.
"""

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.junctions import crossings_with
from gaussiancad_core.sheet.line_widths import Pens, run_width
from gaussiancad_core.sheet.runs import Piece, Rhythm, Run
from gaussiancad_core.sheet.shapes import cross_profile, refit_line, sample
from gaussiancad_core.sheet.stubs import Placed
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_SHORTEST, _LONGEST = 5.0, 60.0
"""px of the ink that is left of such a stroke."""

_BESIDE = 1.0
"""px beyond half a stroke within which all of this ink lies."""

_STRAIGHT = 0.8
"""px beside the line that the middle of its ink lies at most."""

_BENT = 0.3
"""Sagitta in px from which such a stroke is an arc."""

_BEYOND = 3.0
"""px from the end of what is left to the ink that another stroke has in common with it."""

_DARK, _STEP = 0.5, 0.5
"""Weight from which a place is ink, and px between the places that are looked at."""

_CONFIDENCE = 0.6

_LONG_DASH = 1.75
"""Dashes from which a stroke is no dash."""


def find_short_strokes(
    remainder: npt.NDArray[np.bool_],
    placed: Sequence[Placed],
    sheet: CleanSheet,
    rhythm: Rhythm,
    pens: Pens | None,
) -> list[Placed]:
    """Straight strokes in the ink that is left of a view, from one stroke to another.

    Args:
        remainder: (h, w) ink that no piece has.
        placed: pieces with their ends at junctions; px, pixel centres at integers.
        sheet: the ink.
        rhythm: of its dashes.
        pens: what widths tell; nothing if left out.
    """
    found: list[Placed] = []
    for pixels in _strips(remainder):
        seen = _seen(pixels, sheet)
        if seen is None:
            continue
        geometry, span = seen
        ends = _ends(geometry, span, placed, sheet)
        if ends is None:
            continue
        kind = Linetype.VISIBLE
        if ends[1] - ends[0] <= _LONG_DASH * rhythm.dash and pens is not None and pens.told:
            kind = pens.kind(run_width(sheet, geometry, Run(*ends))) or kind
        found.append((geometry, Piece(*ends, kind, _CONFIDENCE)))
    return found


def _strips(remainder: npt.NDArray[np.bool_]) -> Iterator[Floats]:
    """(n, 2) px of pieces of ink as long as such strokes."""
    count, labels, boxes, _ = cv2.connectedComponentsWithStats(
        remainder.astype(np.uint8), connectivity=8
    )
    for label in range(1, count):
        x, y, w, h, _ = boxes[label]
        if _SHORTEST <= np.hypot(w, h) <= _LONGEST:
            rows, columns = np.nonzero(labels[y : y + h, x : x + w] == label)
            yield np.stack([columns + x, rows + y], axis=1).astype(np.float64)


def _seen(pixels: Floats, sheet: CleanSheet) -> tuple[Line | Circle, tuple[float, float]] | None:
    """The line through the middle of some ink, or the arc if it is bent, and from where to where
    on it the ink is seen; None if it is straight to no px."""
    middle = pixels.mean(0)
    _, vectors = np.linalg.eigh((pixels - middle).T @ (pixels - middle))
    way = vectors[:, 1]
    line = Line((float(middle[0]), float(middle[1])), (float(way[0]), float(way[1])))
    along, across = line.coordinates(pixels)
    if np.ptp(along) < _SHORTEST or np.abs(across).max() > sheet.stroke_width / 2.0 + _BESIDE:
        return None
    span = float(along.min()), float(along.max())
    line = refit_line(sheet, line, [span])
    at, beside = cross_profile(sheet, line, [span])
    if len(at) < _SHORTEST or np.abs(beside).max() > _STRAIGHT:
        return None
    bend, slope, shift = np.polyfit(at, beside, 2)
    # Its ends are in others' ink.
    half = 0.5 * (span[1] - span[0]) + sheet.stroke_width + 2.0
    if abs(bend) * half**2 < _BENT:
        return line, span
    return _arc_along(line, span, (bend, slope, shift))


def _arc_along(
    line: Line, span: tuple[float, float], parabola: tuple[float, float, float]
) -> tuple[Circle, tuple[float, float]]:
    """The circle that a parabola beside a line is, and the stretch of it that the line's is."""
    bend, slope, shift = parabola
    top = -slope / (2.0 * bend)
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    radius = 1.0 / (2.0 * abs(bend))
    foot = np.array(line.at(top)) + (shift - bend * top**2) * normal
    centre = foot + np.sign(bend) * radius * normal
    circle = Circle((float(centre[0]), float(centre[1])), radius)
    first, last = circle.positions(line.points_at(np.array(span)))
    if (last - first) % circle.around > circle.around / 2.0:
        first, last = last, first
    return circle, (float(first), float(first + (last - first) % circle.around))


def _ends(
    line: Line | Circle,
    seen: tuple[float, float],
    placed: Sequence[Placed],
    sheet: CleanSheet,
) -> tuple[float, float] | None:
    """Where a shape meets other strokes beyond both ends of what is left of it."""
    piece = Piece(*seen, Linetype.VISIBLE, _CONFIDENCE)
    near: tuple[list[float], list[float]] = ([], [])
    for other, stretch in placed:
        for crossing in crossings_with(line, piece, other, stretch, sheet.stroke_width):
            reach = crossing.reach + sheet.stroke_width / 2.0 + _BEYOND
            if 0.0 <= seen[0] - crossing.at <= reach:
                near[0].append(crossing.at)
            if 0.0 <= crossing.at - seen[1] <= reach:
                near[1].append(crossing.at)
    if not all(near):
        return None
    start, end = max(near[0]), min(near[1])
    points = line.points_at(np.arange(start, end, _STEP))
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > _DARK
    return (start, end) if dark.all() else None
