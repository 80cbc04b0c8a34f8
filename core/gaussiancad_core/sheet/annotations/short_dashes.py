"""The short dashes of centre lines that are too short to have a direction of their own.

They are looked for where they must be: in the gaps between the runs of a line or circle.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.line_conventions import SLENDER
from gaussiancad_core.sheet.picture_noise import FAINT, STEP
from gaussiancad_core.sheet.tracing.ink_runs import Run
from gaussiancad_core.sheet.tracing.ink_shapes import sample

_BLANK = 0.2
"""Darkness up to which there is paper around a dot."""

_LEAST_BLANK_PX = 1.0
"""Paper at either end of a dot at least."""

_OFF_CENTRE = 0.2
"""Distance of a dot from the middle of its gap at most, in gaps: crossings lie anywhere."""

_BESIDE_PX = 2.0
"""px beside a stroke of the sheet's width where a dot has no ink."""


def with_dots(
    weight: npt.NDArray[np.float32],
    stroke_width: float,
    geometry: Line | Circle,
    runs: Sequence[Run],
) -> list[Run]:
    """The runs of a shape, and between them those that are but dots.

    Args:
        weight: (h, w) ink, 0 to 1.
        stroke_width: px.
        geometry: of the shape.
        runs: in order.
    """
    found: list[Run] = list(runs[:1])
    for before, after in pairwise(runs):
        dot = _dot(weight, stroke_width, geometry, Run(before.end, after.start))
        found += [after] if dot is None else [dot, after]
    return found


def _dot(
    weight: npt.NDArray[np.float32], stroke_width: float, geometry: Line | Circle, gap: Run
) -> Run | None:
    """The only ink in a gap, if it is short, in the middle, and nothing else's."""
    along = np.arange(gap.start, gap.end, STEP)
    if gap.length < 2.0 * _LEAST_BLANK_PX + STEP:
        return None
    across = (0.5 * stroke_width + _BESIDE_PX) * np.array([-1.0, 0.0, 1.0])
    ink = _ink(weight, geometry, along, across)
    on = np.flatnonzero(ink[:, 1] > FAINT)
    # The ink of the runs themselves reaches into the gap by a fraction of a pixel.
    inner = (along[on] > gap.start + _LEAST_BLANK_PX) & (along[on] < gap.end - _LEAST_BLANK_PX)
    on = on[inner]
    if not len(on) or on[-1] - on[0] != len(on) - 1:
        return None
    dot = Run(float(along[on[0]]) - STEP / 2, float(along[on[-1]]) + STEP / 2)
    off = abs(0.5 * (dot.start + dot.end) - 0.5 * (gap.start + gap.end))
    if dot.length > SLENDER * stroke_width or off > _OFF_CENTRE * gap.length:
        return None
    ends = [_lightest(ink[:, 1], along, gap.start, dot.start)]
    ends += [_lightest(ink[:, 1], along, dot.end, gap.end)]
    adjacent = ink[on][:, [0, 2]]
    return dot if max(ends) < FAINT and adjacent.max() < _BLANK else None


def _lightest(
    ink: npt.NDArray[np.float32], along: npt.NDArray[np.float64], start: float, end: float
) -> float:
    """The least ink between two places; 1 where nothing is between them."""
    between = ink[(along > start) & (along < end)]
    return float(between.min()) if len(between) else 1.0


def _ink(
    weight: npt.NDArray[np.float32],
    geometry: Line | Circle,
    along: npt.NDArray[np.float64],
    across: npt.NDArray[np.float64],
) -> npt.NDArray[np.float32]:
    """(n, m) ink at positions along a shape and distances across it."""
    points, tangents = geometry.points_at(along), geometry.tangents_at(along)
    xs = points[:, :1] - tangents[:, 1:] * across
    ys = points[:, 1:] + tangents[:, :1] * across
    return sample(weight, xs, ys)
