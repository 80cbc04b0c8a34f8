"""Short strokes between two others, too bent for a line to be grown from and too flat for an arc.

Where two surfaces meet, curves of a few line widths end on edges at both ends.  Their ink is left
when all else is explained: what is straight to a pixel is drawn as a line up to the strokes that it
runs into.
"""

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import ONE_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    CLOSER,
    DARK,
    INFERRED,
    ON_LINE,
    ONE_PLACE,
    OVERRUN,
    STEP,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, Run
from gaussiancad_core.sheet.tracing.ink_shapes import cross_profile, refit_line, sample
from gaussiancad_core.sheet.tracing.junctions import crossings_with
from gaussiancad_core.sheet.tracing.leftover import Leftover, leftover_ink
from gaussiancad_core.sheet.tracing.line_widths import Pens, run_width
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to

Floats = npt.NDArray[np.float64]

_SHORTEST, _LONGEST = 5.0, 60.0
"""px of the ink that is left of such a stroke."""

_BENT = 0.3
"""Sagitta in px from which such a stroke is an arc."""

_FIRST = ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5))
"""px across by which the ends of a line are moved at first, to fit it."""

_FIT = {"xatol": 0.02, "fatol": 0.01, "maxiter": 60, "initial_simplex": _FIRST}
"""How exactly, in px and ink, it is fitted."""


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
    left: Leftover | None = None
    for pixels in _strips(remainder):
        shown = [
            (geometry, ends)
            for geometry, span in _seen(pixels, sheet)
            if (ends := _ends(geometry, span, placed, sheet)) is not None
        ]
        left = left or leftover_ink(placed, sheet)
        best = _likeliest(shown, left, sheet) if shown else None
        if best is None:
            continue
        geometry, ends = best
        kind = Linetype.VISIBLE
        if ends[1] - ends[0] <= ONE_DASH * rhythm.dash and pens is not None and pens.distinct:
            kind = pens.kind(run_width(sheet, geometry, Run(*ends), edges=True)) or kind
        found.append((geometry, Piece(*ends, kind, INFERRED)))
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


_Shown = tuple[Line | Circle, tuple[float, float]]
"""A shape, and from where to where on it there is ink."""


def _seen(pixels: Floats, sheet: CleanSheet) -> list[_Shown]:
    """The line through the middle of some ink, and the arc if it seems bent, with where on them the
    ink is seen; nothing if it is straight to no px."""
    middle = pixels.mean(0)
    _, vectors = np.linalg.eigh((pixels - middle).T @ (pixels - middle))
    way = vectors[:, 1]
    line = Line((float(middle[0]), float(middle[1])), (float(way[0]), float(way[1])))
    along, across = line.coordinates(pixels)
    if np.ptp(along) < _SHORTEST or np.abs(across).max() > sheet.stroke_width / 2.0 + ONE_PLACE:
        return []
    span = float(along.min()), float(along.max())
    line = refit_line(sheet, line, [span])
    at, adjacent = cross_profile(sheet, line, [span])
    if np.abs(adjacent).max(initial=0.0) > ON_LINE:
        return []
    if len(at) < _SHORTEST:
        # Nearly all of its ink is beside others'.
        return [(line, span)]
    bend, slope, shift = np.polyfit(at, adjacent, 2)
    # Its ends are in others' ink.
    half = 0.5 * (span[1] - span[0]) + sheet.stroke_width + 2.0
    if abs(bend) * half**2 < _BENT:
        return [(line, span)]
    return [(line, span), _arc_along(line, span, (bend, slope, shift))]


def _likeliest(shown: Sequence[_Shown], left: Leftover, sheet: CleanSheet) -> _Shown | None:
    """The line, or the arc where there is one: what has more of the sheet's ink with all others.

    Where a short stroke ends in others, their ink leads the middle of its own astray.  None if
    there is little less ink missing with either.
    """
    from scipy.optimize import minimize

    points = np.concatenate([item.points_at(np.arange(*ends, 1.0)) for item, ends in shown])
    margin = np.ceil(sheet.stroke_width) + 1.0
    low = np.maximum(np.floor(points.min(0) - margin), 0).astype(int)
    high = np.ceil(points.max(0) + margin).astype(int) + 1
    part = slice(low[1], high[1]), slice(low[0], high[0])
    ink, others = sheet.weight[part], left.expected[part]
    rows, columns = np.indices(ink.shape)
    places = np.stack([columns.ravel(), rows.ravel()], axis=1) + low.astype(np.float64)

    def missed(pair: _Shown) -> float:
        piece = Piece(*pair[1], Linetype.VISIBLE, INFERRED)
        drawn = left.pen.ink(distances_to((pair[0], piece), places)).reshape(ink.shape)
        return float(((np.maximum(drawn, others) - ink) ** 2).sum())

    def moved(off: Floats) -> _Shown:
        return _line_between(shown[0], off)

    fit = minimize(lambda off: missed(moved(off)), np.zeros(2), method="Nelder-Mead", options=_FIT)
    found = [(missed(pair), pair) for pair in (moved(fit.x), *shown[1:])]
    least, best = min(found, key=lambda pair: pair[0])
    return best if least < CLOSER * float(((others - ink) ** 2).sum()) else None


def _line_between(shown: _Shown, off: Floats) -> _Shown:
    """A stretch of a line with its ends moved so many px across."""
    line, (start, end) = shown
    points = line.points_at(np.array([start, end]))
    way = line.tangents_at(np.array([start]))[0]
    first, last = points + off[:, None] * np.array([-way[1], way[0]])
    length = float(np.hypot(*(last - first)))
    x, y = ((last - first) / length).tolist()
    return Line((float(first[0]), float(first[1])), (x, y)), (0.0, length)


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
    piece = Piece(*seen, Linetype.VISIBLE, INFERRED)
    near: tuple[list[float], list[float]] = ([], [])
    for other, stretch in placed:
        for crossing in crossings_with(line, piece, other, stretch, sheet.stroke_width):
            reach = crossing.reach + sheet.stroke_width / 2.0 + OVERRUN
            if 0.0 <= seen[0] - crossing.at <= reach:
                near[0].append(crossing.at)
            if 0.0 <= crossing.at - seen[1] <= reach:
                near[1].append(crossing.at)
    if not all(near):
        return None
    start, end = max(near[0]), min(near[1])
    points = line.points_at(np.arange(start, end, STEP))
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > DARK
    return (start, end) if dark.all() else None
