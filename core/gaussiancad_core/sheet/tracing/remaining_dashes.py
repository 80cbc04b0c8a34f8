"""Rows of dashes that no shape explains: pale ones, close beside an edge that outshines them.

Lines grow along ridges of smoothed ink.  A narrow grey line a pixel beside a wide black one has no
ridge of its own, but what the edge leaves of its ink lies in a row all the same.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH, ROW
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import DARK, FINEST_STEP, ONE_PLACE
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.ink_shapes import sample

Floats = npt.NDArray[np.float64]

_LACKING = 2
"""Dashes one after the other that a row may lack, where other lines cross it."""

_WIDER_PX = 2.0
"""px by which a dash is wider than the sheet's strokes at most."""

_REACH_PX = 3.0
"""px across a row that are looked at."""

_SURE = 0.9
"""Confidence of a row."""


@dataclass(frozen=True)
class _Dash:
    """A lone dash.

    Attributes:
        middle: (2,) px.
        along: (2,) unit vector.
        length: px.
        ink: (n, 3) x, y and weight of its pixels.
    """

    middle: Floats
    along: Floats
    length: float
    ink: Floats


def find_remaining_dashes(
    remainder: npt.NDArray[np.bool_], sheet: CleanSheet, rhythm: Rhythm
) -> list[tuple[Line, Piece]]:
    """Hidden lines whose dashes lie in a row of ink that nothing explains.

    Args:
        remainder: (h, w) ink that no stroke has.
        sheet: its weight.
        rhythm: of the sheet's dashes.
    """
    left = _dashes(remainder, sheet, rhythm)
    found = []
    while left:
        first = left.pop(0)
        row = [first, *(other for other in left if _is_in_line(first, other))]
        places = {id(dash): float(dash.middle @ first.along) for dash in row}
        row.sort(key=lambda dash: places[id(dash)])
        steady = _steady(row, first.along, rhythm)
        if len(steady) >= ROW:
            line, piece = _fitted(steady)
            found.append((_centred(line, steady, sheet), piece))
            left = [dash for dash in left if all(dash is not this_dash for this_dash in steady)]
    return found


def _dashes(remainder: npt.NDArray[np.bool_], sheet: CleanSheet, rhythm: Rhythm) -> list[_Dash]:
    """Components of ink as long as a dash and no wider than a stroke."""
    count, labels, stats, _ = cv2.connectedComponentsWithStats(
        remainder.astype(np.uint8), connectivity=8
    )
    found = []
    shortest, longest = ((1.0 + way * LIKE_A_DASH) * rhythm.dash for way in (-1.0, 1.0))
    for label in range(1, count):
        x, y, width, height = (int(value) for value in stats[label, :4])
        # Aslant a dash is longer than its box; of specks there may be thousands.
        if np.hypot(width, height) < shortest or max(width, height) > longest + 1.0:
            continue
        rows, columns = np.nonzero(labels[y : y + height, x : x + width] == label)
        points = np.stack([columns + x, rows + y], axis=1).astype(np.float64)
        # Ink that was closed over gaps has no weight.
        weight = np.maximum(sheet.weight[rows + y, columns + x].astype(np.float64), 1e-3)
        middle = np.average(points, axis=0, weights=weight)
        along = np.linalg.svd(points - middle, full_matrices=False)[2][0]
        length = float(np.ptp(points @ along)) + 1.0
        across = float(np.ptp((points - middle) @ np.array([-along[1], along[0]]))) + 1.0
        if (
            abs(length - rhythm.dash) <= LIKE_A_DASH * rhythm.dash
            and across <= sheet.stroke_width + _WIDER_PX
            and across < length / 2.0
        ):
            ink = np.column_stack([points, weight])
            found.append(_Dash(middle, along, length, ink))
    return found


def _is_in_line(one: _Dash, other: _Dash) -> bool:
    """Whether two dashes lie on one line: each on that of both middles."""
    between = other.middle - one.middle
    distance = max(float(np.hypot(*between)), 1.0)
    off = [
        abs(float(dash.along[0] * between[1] - dash.along[1] * between[0])) / distance
        for dash in (one, other)
    ]
    # A dash tells its direction to about a pixel over its length.
    return all(
        sine * dash.length / 2.0 <= ONE_PLACE for sine, dash in zip(off, (one, other), strict=True)
    )


def _steady(row: Sequence[_Dash], along: Floats, rhythm: Rhythm) -> list[_Dash]:
    """The longest part of a row in the sheet's rhythm, in line to a pixel."""
    parts = [[row[0]]]
    for one, other in pairwise(row):
        # Dashes of one line are of one length, if not quite of the sheet's.
        period = (one.length + other.length) / 2.0 + rhythm.gap
        apart = float((other.middle - one.middle) @ along)
        count = round(apart / period)
        adjacent = abs(apart - count * period) > count * LIKE_A_DASH * rhythm.gap
        if adjacent or not 1 <= count <= 1 + _LACKING or not _is_in_line(one, other):
            parts.append([])
        parts[-1].append(other)
    return max(parts, key=len)


def _fitted(row: Sequence[_Dash]) -> tuple[Line, Piece]:
    """The line through the ink of a row, and where it is drawn."""
    ink = np.concatenate([dash.ink for dash in row])
    weights = ink[:, 2] / ink[:, 2].sum()
    middle = weights @ ink[:, :2]
    off = ink[:, :2] - middle
    along = np.linalg.eigh((off * weights[:, None]).T @ off)[1][:, -1]
    line = Line((float(middle[0]), float(middle[1])), (float(along[0]), float(along[1])))
    places = line.positions(np.array([row[0].middle, row[-1].middle]))
    reach = (row[0].length / 2.0, row[-1].length / 2.0)
    ends = sorted(zip(places.tolist(), reach, strict=True))
    start, end = ends[0][0] - ends[0][1], ends[1][0] + ends[1][1]
    return line, Piece(start, end, Linetype.HIDDEN, _SURE)


def _centred(line: Line, row: Sequence[_Dash], sheet: CleanSheet) -> Line:
    """A row's line in the middle of all ink of its dashes.

    Strokes beside it take some: from the darkest place next to what is left, that ink reaches as
    far as where it fades, or grows darker again.
    """
    across = np.arange(-_REACH_PX, _REACH_PX + FINEST_STEP, FINEST_STEP)
    normal = np.array([-line.direction[1], line.direction[0]])
    along = np.concatenate(
        [
            line.positions(dash.ink[:, :2]).mean() + np.arange(-0.3, 0.31, 0.1) * dash.length
            for dash in row
        ]
    )
    points = line.points_at(along)
    weight = sample(
        sheet.weight,
        points[:, :1] + across * normal[0],
        points[:, 1:] + across * normal[1],
    )
    profile: npt.NDArray[np.float32] = np.median(weight, axis=0)
    middle = len(across) // 2
    peak = _uphill(profile, middle)
    low, high = (_faded(profile, peak, way) for way in (-1, 1))
    shift = float(across[low] + across[high]) / 2.0
    x, y = line.at(0.0)
    return Line((x + shift * normal[0], y + shift * normal[1]), line.direction)


def _uphill(profile: npt.NDArray[np.float32], start: int) -> int:
    """The nearest place from which a profile does not rise."""
    at = start
    while True:
        ks = [k for k in (at - 1, at + 1) if 0 <= k < len(profile)]
        best = max(ks, key=lambda k: profile[k])
        if profile[best] <= profile[at]:
            return at
        at = best


def _faded(profile: npt.NDArray[np.float32], peak: int, way: int) -> int:
    """Where a profile has fallen to a share of its peak, or rises again, one way from there."""
    at = peak
    while 0 <= at + way < len(profile):
        if profile[at + way] > profile[at] or profile[at] < DARK * profile[peak]:
            break
        at += way
    return at
