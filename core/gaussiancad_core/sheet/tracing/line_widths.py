"""How wide the ink of a run is, and what that says of its linetype.

Where a sheet's hidden lines are narrower than its visible ones (ISO 128-2), the pen tells pieces
apart that are too short for dashes to show, and the place where a visible line goes on hidden.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.line_conventions import THIN
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run
from gaussiancad_core.sheet.tracing.ink_shapes import sample

Floats = npt.NDArray[np.float64]

_CLEAR = 0.2
"""Ink across a stroke under which the stroke has ended."""

_EDGE = 2
"""Half px beyond that in which its edge falls off."""

_DIP = 0.8
"""Ink on the centre line, as a share of the most across it, under which there are two lines."""

_LOPSIDED = 0.35
"""Stroke widths by which the ink may be wider on one side of a centre line than on the other."""

_SOLID = 3.0
"""Length from which a run is a visible line's, in dashes."""

_LEAST_RUNS, _LEAST_DASHES = 3, 6
"""Visible runs and dashes from which their widths are known."""

_EVEN_GAP = (0.6, 1.4)
"""Share of the sheet's gap between two dashes, at least and at most."""

_OUTLIERS = 10.0
"""Per cent of either kind that may be as wide as the other."""

_HIDDEN_UP_TO, _VISIBLE_FROM = 0.3, 0.7
"""Shares of the difference of both widths; what lies between tells nothing."""


@dataclass(frozen=True)
class Pens:
    """What widths tell.

    Attributes:
        hidden: px up to which a run is hidden; 0 where nothing is told.
        visible: px from which it is visible.
    """

    hidden: float = 0.0
    visible: float = float("inf")

    @property
    def distinct(self) -> bool:
        """Whether the sheet's pens differ."""
        return self.hidden > 0.0

    def kind(self, width: float) -> Linetype | None:
        """The linetype of ink of a width in px; nothing where it may be either's."""
        if width <= self.hidden:
            return Linetype.HIDDEN
        return Linetype.VISIBLE if width >= self.visible else None


def learn_pens(lines: Sequence[Sequence[tuple[Run, float]]], rhythm: Rhythm) -> Pens:
    """The pens of a sheet from its long runs and its dashes.

    Args:
        lines: the runs of each line of all views, in order, each with the width of its ink in px;
            NaN where it is not known.
        rhythm: of the sheet.
    """
    runs = [run for line in lines for run in line]
    solid = _widths([run for run in runs if run[0].length > _SOLID * rhythm.dash])
    # Short visible edges are as long as dashes, too, but seldom one after the other.
    alone = _widths([run for run in runs if _is_a_dash(run[0], rhythm)])
    adjacent = _widths([run for line in lines for run in _dashes_beside_dashes(line, rhythm)])
    dashes = adjacent if len(adjacent) >= _LEAST_DASHES else alone
    if len(solid) < _LEAST_RUNS or len(dashes) < _LEAST_DASHES:
        return Pens()
    wide, narrow = float(np.median(solid)), float(np.median(dashes))
    pens = Pens(narrow + _HIDDEN_UP_TO * (wide - narrow), narrow + _VISIBLE_FROM * (wide - narrow))
    middle = 0.5 * (wide + narrow)
    apart = np.percentile(solid, _OUTLIERS) > middle > np.percentile(dashes, 100.0 - _OUTLIERS)
    return pens if apart and narrow < THIN * wide else Pens()


def _widths(runs: Sequence[tuple[Run, float]]) -> Floats:
    """Those that are known."""
    widths = np.array([width for _, width in runs], dtype=np.float64)
    return widths[np.isfinite(widths)]


def _is_a_dash(run: Run, rhythm: Rhythm) -> bool:
    return abs(run.length / rhythm.dash - 1.0) < LIKE_A_DASH


def _dashes_beside_dashes(
    line: Sequence[tuple[Run, float]], rhythm: Rhythm
) -> Iterator[tuple[Run, float]]:
    """Runs as long as dashes that have another one beside them, a gap away."""
    low, high = (share * rhythm.gap for share in _EVEN_GAP)
    dashes = [pair for pair in line if _is_a_dash(pair[0], rhythm)]
    even = [low <= b.start - a.end <= high for (a, _), (b, _) in pairwise(dashes)]
    even = [False, *even, False]
    for dash, before, after in zip(dashes, even, even[1:], strict=False):
        if before or after:
            yield dash


def run_width(sheet: CleanSheet, geometry: WholeCurve, run: Run, edges: bool = False) -> float:
    """px, the median width of a run's ink where no other stroke is beside it; else NaN.

    With ``edges`` its palest ink counts, too: see :func:`sides_along`.
    """
    widths = widths_along(sheet, geometry, run, edges)
    known = np.isfinite(widths)
    return float(np.median(widths[known])) if known.any() else float("nan")


def widths_along(sheet: CleanSheet, geometry: WholeCurve, run: Run, edges: bool = False) -> Floats:
    """(n,) px of ink across a run, about every px; NaN where it merges with other strokes."""
    return sides_along(sheet, geometry, run, edges).sum(axis=1)


def _with_edges(
    values: npt.NDArray[np.bool_], profile: npt.NDArray[np.floating]
) -> npt.NDArray[np.bool_]:
    """(n, k) places across a stroke that are its own, with the pale ones where it falls off.

    A stroke that lies between two rows of pixels has a fourth of its ink in paler ones.
    """
    wider = values
    for _ in range(_EDGE):
        outward = np.zeros_like(values)
        outward[:, 1:] |= wider[:, :-1] & (profile[:, 1:] < profile[:, :-1])
        outward[:, :-1] |= wider[:, 1:] & (profile[:, :-1] < profile[:, 1:])
        wider = wider | outward
    return wider


def sides_along(sheet: CleanSheet, geometry: WholeCurve, run: Run, edges: bool = False) -> Floats:
    """(n, 2) px of ink on either side of a run, as :func:`widths_along` tells both together.

    Args:
        sheet: the ink.
        geometry: the shape along which it runs.
        run: a piece of it.
        edges: whether its palest ink counts, too: it makes up for where a stroke lies between
            rows of pixels, but shows less how the width changes along it.
    """
    reach = 1.25 * sheet.stroke_width + 2.5
    half = int(np.ceil(reach * 2))
    offsets = np.arange(-half, half + 1) * 0.5
    along = np.linspace(run.start, run.end, max(2, int(np.ceil(run.length)) + 1))
    points, tangents = geometry.points_at(along), geometry.tangents_at(along)
    profile = sample(
        sheet.weight,
        points[:, :1] - tangents[:, 1:] * offsets,
        points[:, 1:] + tangents[:, :1] * offsets,
    )
    inked = profile > _CLEAR
    # The ink that hangs together with the centre: outwards until the first blank.
    after = np.logical_and.accumulate(inked[:, half:], axis=1)
    before = np.logical_and.accumulate(inked[:, half::-1], axis=1)[:, ::-1]
    values = np.concatenate([before[:, :-1], after], axis=1)
    merged = values[:, 0] | values[:, -1]
    # Between two lines that touch, the centre is paler than both.
    highest = np.where(values, profile, 0.0).max(1)
    double = profile[:, half] < _DIP * highest
    ink = np.where(_with_edges(values, profile) if edges else values, profile, 0.0)
    # Where another stroke leaves at a flat angle, the ink is wider on its side alone.
    sides = np.stack([ink[:, :half].sum(1), ink[:, half + 1 :].sum(1)], axis=1) * 0.5
    lopsided = np.abs(sides[:, 0] - sides[:, 1])
    unclear = merged | double | ~inked[:, half] | (lopsided > _LOPSIDED * sheet.stroke_width)
    sides += 0.25 * ink[:, half : half + 1]
    return np.where(unclear[:, None], np.nan, sides)
