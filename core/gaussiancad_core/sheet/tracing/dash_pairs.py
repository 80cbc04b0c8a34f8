"""The rhythm of a sheet whose hidden lines are too short for three dashes in a row.

Where the dashes are long for the part, a pocket's sides have two of them, or one.  Two pieces of
one length, on one line, whose ends that face each other are free, can be nothing but dashes: edges
end at others.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import WholeCurve
from gaussiancad_core.sheet.dash_noise import FEWEST, LIKE_A_DASH
from gaussiancad_core.sheet.line_conventions import LONGEST_DASH, SLENDER, WIDEST_GAP
from gaussiancad_core.sheet.picture_noise import AROUND, FAINT
from gaussiancad_core.sheet.tracing.ink_runs import InkField, Rhythm, Run
from gaussiancad_core.sheet.tracing.ink_shapes import sample

Drawn = tuple[InkField, WholeCurve, Sequence[Run]]


def paired_rhythm(drawn: Sequence[Drawn], stroke_width: float) -> Rhythm | None:
    """Dash and gap in px as pairs of dashes tell them, if enough do and they agree.

    Args:
        drawn: the ink around a shape, the shape, and its runs in order.
        stroke_width: px.
    """
    pairs: dict[tuple[int, ...], tuple[float, float]] = {}
    for field, geometry, runs in drawn:
        for one, other in pairwise(runs):
            if _is_pair(one, other, stroke_width) and _is_free(
                field, geometry, one.end, other.start
            ):
                ends = geometry.points_at(np.array([one.end, other.start]))
                # Two shapes may have the same ink.
                place = id(field), *np.rint(ends.mean(axis=0) / 2.0).astype(int).tolist()
                pairs[place] = (one.length + other.length) / 2.0, other.start - one.end
    if len(pairs) < FEWEST:
        return None
    found = np.array(list(pairs.values()))
    middle = np.median(found, axis=0)
    near = (np.abs(found - middle) <= LIKE_A_DASH * middle).all(axis=1)
    return (
        Rhythm(*(float(v) for v in middle)) if near.sum() >= max(FEWEST, 0.75 * len(near)) else None
    )


def _is_pair(one: Run, other: Run, stroke_width: float) -> bool:
    shorter, longer = sorted((one.length, other.length))
    return (
        longer - shorter <= LIKE_A_DASH * longer
        and shorter >= SLENDER * stroke_width
        and longer <= LONGEST_DASH
        and 0.0 < other.start - one.end <= WIDEST_GAP * longer
    )


def _is_free(field: InkField, geometry: WholeCurve, end: float, start: float) -> bool:
    """Whether there is no ink around two ends that face each other."""
    half = field.stroke_width / 2.0
    adjacent = half + np.array([1.5, AROUND])
    across = np.concatenate([-adjacent, adjacent])
    for position, outward in ((end, 1.0), (start, -1.0)):
        along = position + outward * np.arange(-half, half + AROUND + 0.5, 0.5)
        if _has_ink(field, geometry, along, across):
            return False
        if _has_ink(
            field, geometry, along[along * outward > position * outward + half], np.zeros(1)
        ):
            return False
    return True


def _has_ink(
    field: InkField,
    geometry: WholeCurve,
    along: npt.NDArray[np.float64],
    across: npt.NDArray[np.float64],
) -> bool:
    points, tangents = geometry.points_at(along), geometry.tangents_at(along)
    xs = points[:, :1] - tangents[:, 1:] * across
    ys = points[:, 1:] + tangents[:, :1] * across
    return bool((sample(field.weight, xs, ys) > FAINT).any())
