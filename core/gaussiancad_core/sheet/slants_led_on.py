"""Hidden slants that go on beyond lines which cross them.

A slant of a few dashes that level and upright lines cross is read from one of them alone: what lies
between the crossings is shorter than a dash.  But it lies on the slant's course, and leads to
another stroke.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.jogs import distances_to
from gaussiancad_core.sheet.junctions import Placed
from gaussiancad_core.sheet.runs import Rhythm, runs_of_ink
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_ASLANT = 0.2
"""Sine of the angle to both axes of the sheet at least."""

_STEP = 0.25
"""px between the places that are looked at."""

_FARTHEST = 3.0
"""Dashes with their gaps that a slant is led on by at most."""

_CLEAR, _DARK = 0.75, 0.5
"""px beside a stroke's ink from which ink is not its own; weight from which a place is ink."""

_BESIDE = 1.5
"""px beside a slant's own ink where there is paper, on one side at least."""

_GAP = 1.5
"""Gaps of the sheet's dashes that a slant is blank for at most."""

_INKED, _SHARE = 0.4, 0.25
"""Dashes of its own ink at least, and its share of what no other stroke has."""

_MET = 0.5
"""px between the course of a slant and a stroke that it meets."""


def with_slants_led_on(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """The pieces, hidden slants as long as their ink goes on.

    Args:
        pieces: of a view, where their ink is seen; px, pixel centres at integers.
        sheet: its ink.
        rhythm: of its dashes.
    """
    led = list(pieces)
    for index, (line, piece) in enumerate(pieces):
        if (
            not isinstance(line, Line)
            or piece.linetype is not Linetype.HIDDEN
            or min(abs(own) for own in line.direction) < _ASLANT
        ):
            continue
        others = [own for k, own in enumerate(led) if k != index]
        start, end = (
            at + way * _further(line, (at, way), others, sheet, rhythm)
            for at, way in ((piece.start, -1.0), (piece.end, 1.0))
        )
        led[index] = line, replace(piece, start=start, end=end)
    return led


def _further(
    line: Line,
    end: tuple[float, float],
    others: Sequence[Placed],
    sheet: CleanSheet,
    rhythm: Rhythm,
) -> float:
    """px by which the ink of a line goes on beyond an end, told by its position and the sign of
    outwards."""
    at, way = end
    reach = _FARTHEST * (rhythm.dash + rhythm.gap)
    places = np.arange(_STEP, reach, _STEP)
    points = line.points_at(at + way * places)
    middle = points[len(points) // 2][None]
    near = [own for own in others if distances_to(own, middle)[0] <= reach]
    if not near:
        return 0.0
    away = np.min([distances_to(own, points) for own in near], axis=0, initial=reach)
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > _DARK
    longest = _GAP * rhythm.gap / _STEP
    blank = [first for first, last in runs_of_ink(~dark) if last - first > longest]
    clear = away > sheet.stroke_width / 2.0 + _CLEAR
    clear[min(blank, default=len(clear)) :] = False
    own = clear & dark & _has_paper_beside(line, points, sheet)
    if own.sum() * _STEP < _INKED * rhythm.dash:
        return 0.0
    last = int(np.flatnonzero(own)[-1])
    until = last + int(longest + sheet.stroke_width / _STEP)
    if own.sum() < _SHARE * clear[: last + 1].sum() or away[last:until].min() > _MET:
        return 0.0
    return float(places[last])


def _has_paper_beside(line: Line, points: Floats, sheet: CleanSheet) -> npt.NDArray[np.bool_]:
    """(n,) whether there is paper on one side of a line at least, at points (n, 2) px of it."""
    dx, dy = line.direction
    flank = sheet.stroke_width / 2.0 + _BESIDE
    beside = np.array([-flank, flank])
    weight = sample(sheet.weight, points[:, :1] - dy * beside, points[:, 1:] + dx * beside)
    return weight.min(axis=1) < _DARK
