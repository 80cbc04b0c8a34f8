"""Which ink of a view earlier strokes explain, and what that says of the next shape's runs.

A shape that explains little that is new is dropped: a chord of a circle, or an arc that cuts a
corner.  Ink keeps the direction of the stroke that has it, since strokes of other directions may
cross a new one.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, ClosedCurve, Line, WholeCurve
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, Run
from gaussiancad_core.sheet.tracing.linetype_odds import RunOdds

_MIN_NEW = 0.4
"""Share of a run's ink that no earlier stroke of about its direction explains."""

_MIN_CLEAR = 0.25
"""Share that no earlier stroke explains: half of a dash can lie under one that crosses it."""

_MIN_STRAIGHT = 5
"""px of a line, one after the other, that nothing explains: enough by themselves."""

_CROSSED = 0.25
"""Share of a dash that a stroke across it covers at least for it to seem longer."""

_BENT = 0.12
"""Sagitta in px of what is new of an arc, from which it is a fillet between its tangents."""

_MIN_BENT = 0.04
"""Share of a fillet that no earlier stroke explains."""

_DASHES_BESIDE, _LONG_DASH = 1.5, 1.1
"""Dashes with their gaps between two dashes of an arc, one of which others may cover; dashes that
one is long at most, without what a tangent adds to it."""

_HALF_TURN = 90
"""Marks of direction in half a turn."""

_ALIKE = 17
"""Largest difference of two marks for one ink: both shapes lie within 16 degrees of it."""


@dataclass(frozen=True, eq=False)
class Explained:
    """Marks of the direction of the strokes that have a view's ink, 0 where none has.

    Attributes:
        around: (h, w) uint8, a little wider than the strokes, for ink that ran.
        upon: (h, w) uint8, as wide as they are, for lines that are known to run beside others.
        stroke_width: px.
    """

    around: npt.NDArray[np.uint8]
    upon: npt.NDArray[np.uint8]
    stroke_width: float

    @classmethod
    def blank(cls, sheet: CleanSheet) -> "Explained":
        """Nothing of a view's ink is explained."""
        shape = sheet.ink.shape
        return cls(np.zeros(shape, np.uint8), np.zeros(shape, np.uint8), sheet.stroke_width)

    def copy(self) -> "Explained":
        """The same at this moment."""
        return Explained(self.around.copy(), self.upon.copy(), self.stroke_width)

    def near(self, close: bool) -> npt.NDArray[np.uint8]:
        """The marks for a shape that runs close beside another, or for any other."""
        return self.upon if close else self.around

    def add(self, geometry: WholeCurve, piece: Piece, close: bool = False) -> None:
        """Mark the ink of a piece, in place, a little longer than the stroke; where others run
        close beside it no wider than the stroke."""
        reach = self.stroke_width / 2
        points = path_points(geometry, piece.start - reach, piece.end + reach)
        # Ten chords to a radian.
        straight = isinstance(geometry, Line)
        chord = len(points) - 1 if straight else max(1, int(geometry.around / (20.0 * np.pi)))
        width, neighbour = int(np.ceil(self.stroke_width)), 0 if close else 2
        for first in range(0, len(points) - 1, chord):
            part = points[first : first + chord + 1]
            mark = int(_direction_marks(part[-1:] - part[:1])[0])
            path = np.rint(part * 8).astype(np.int32)
            cv2.polylines(self.around, [path], False, mark, width + neighbour, shift=3)
            cv2.polylines(self.upon, [path], False, mark, width, shift=3)


def is_new(geometry: WholeCurve, run: Run, explained: npt.NDArray[np.uint8]) -> bool:
    """Whether enough of a run's ink is unexplained; strokes of other directions may cross it."""
    old, alike = _explained_along(geometry, run, explained)
    if isinstance(geometry, Circle):
        # Of an arc between two tangents only the middle lies clear of them: it must be bent.
        fresh = float((~(old & alike)).mean()) * run.length
        if fresh**2 / (8 * geometry.radius) > _BENT and (~old).mean() > _MIN_BENT:
            return True
    return bool((~old).mean() > _MIN_CLEAR and (~(old & alike)).mean() > _MIN_NEW)


def is_next_dash(
    geometry: WholeCurve, runs: list[RunOdds], index: int, explained: Explained, rhythm: Rhythm
) -> bool:
    """Whether a run follows a series of dashes, and is new but for what ran from strokes across."""
    run = runs[index][0]
    return _has_dash_beside(runs, index, rhythm) and is_new(geometry, run, explained.upon)


def with_nearby_dashes(
    curve: ClosedCurve,
    runs: Sequence[RunOdds],
    fresh: Sequence[RunOdds],
    rhythm: Rhythm,
    stroke_width: float,
) -> list[RunOdds]:
    """The new runs of a curve, and those that may be dashes beside them.

    What an arc has of a dash that goes on along its tangent lies in the tangent's ink: it is no new
    ink, but the dash beside it tells that the arc goes on there.
    """
    shared = float(np.sqrt(2.0 * curve.around / (2.0 * np.pi) * (stroke_width / 2.0 + 1.0)))
    longest = _LONG_DASH * rhythm.dash + shared
    reach = _DASHES_BESIDE * (rhythm.dash + rhythm.gap)
    places = [run for run, _ in fresh]
    candidates = [
        run for run, odds in runs if run not in places and odds > -TOLD and run.length <= longest
    ]
    added: list[Run] = []
    while True:
        adjacent_runs = [
            run
            for run in candidates
            if run not in added
            and any(_apart(curve, run, other) <= reach for other in [*places, *added])
        ]
        if not adjacent_runs:
            break
        added += adjacent_runs
    return [
        (run, max(odds, TOLD) if run in added else odds)
        for run, odds in runs
        if run in added or run in places
    ]


def _apart(curve: ClosedCurve, one: Run, other: Run) -> float:
    """px between two runs around a curve."""
    return min((other.start - one.end) % curve.around, (one.start - other.end) % curve.around)


def joins_arcs(geometry: WholeCurve, run: Run, explained: npt.NDArray[np.uint8]) -> bool:
    """Whether a run is a short line between two arcs that follow it from both of its ends."""
    if not isinstance(geometry, Line):
        return False
    points = np.rint(path_points(geometry, run.start, run.end)).astype(int)
    height, width = explained.shape
    xs, ys = np.clip(points[:, 0], 0, width - 1), np.clip(points[:, 1], 0, height - 1)
    return _longest_true(explained[ys, xs] == 0) >= _MIN_STRAIGHT


def labelled_linetypes(
    geometry: WholeCurve,
    runs: list[RunOdds],
    explained: npt.NDArray[np.uint8],
    rhythm: Rhythm,
) -> list[float]:
    """Log-odds that each run is hidden, with what tells dashes of a series that another stroke
    crosses at a flat angle, so that its ink makes them longer."""
    oddses = [odds for _, odds in runs]
    for index, (run, _) in enumerate(runs):
        if run.length <= rhythm.dash or not _has_dash_beside(runs, index, rhythm):
            continue
        old = _explained_along(geometry, run, explained)[0]
        if old.mean() > _CROSSED and _longest_true(~old) <= (1.0 + LIKE_A_DASH) * rhythm.dash:
            oddses[index] = max(oddses[index], TOLD)
    return oddses


def path_points(geometry: WholeCurve, start: float, end: float) -> npt.NDArray[np.float64]:
    """(n, 2) px about one px apart along a shape."""
    return geometry.points_at(np.linspace(start, end, max(2, int(np.ceil(end - start)) + 1)))


def _direction_marks(vectors: npt.NDArray[np.float64]) -> npt.NDArray[np.int64]:
    """(n, 2) directions -> (n,) 1 to 90: half the degrees from the first axis, from 1 on."""
    degrees = np.degrees(np.arctan2(vectors[:, 1], vectors[:, 0])) % 180.0
    return np.rint(degrees / 2.0).astype(int) % _HALF_TURN + 1


def _has_dash_beside(runs: list[RunOdds], index: int, rhythm: Rhythm) -> bool:
    """Whether a run follows a dash, or is followed by one, at about the sheet's gap."""
    for other in (index - 1, index + 1):
        if not 0 <= other < len(runs):
            continue
        before, after = sorted((runs[index][0], runs[other][0]), key=lambda run: run.start)
        dash = runs[other][0].length
        even = abs(after.start - before.end - rhythm.gap) <= 0.5 * rhythm.gap
        if even and abs(dash / rhythm.dash - 1.0) <= LIKE_A_DASH:
            return True
    return False


def _explained_along(
    geometry: WholeCurve, run: Run, explained: npt.NDArray[np.uint8]
) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
    """Every px along a run: whether an earlier stroke has the ink, and whether one that has it
    would run about this way."""
    exact = path_points(geometry, run.start, run.end)
    points = np.rint(exact).astype(int)
    height, width = explained.shape
    xs, ys = np.clip(points[:, 0], 0, width - 1), np.clip(points[:, 1], 0, height - 1)
    marks = explained[ys, xs].astype(int)
    turn = np.abs(marks - _direction_marks(np.gradient(exact, axis=0)))
    return marks > 0, np.minimum(turn, _HALF_TURN - turn) <= _ALIKE


def _longest_true(flags: npt.NDArray[np.bool_]) -> int:
    """Length of the longest run of True."""
    padded = np.concatenate([[False], flags, [False]]).astype(np.int8)
    starts, ends = np.flatnonzero(np.diff(padded) == 1), np.flatnonzero(np.diff(padded) == -1)
    return int((ends - starts).max(initial=0))
