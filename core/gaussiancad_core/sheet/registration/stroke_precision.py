"""How exactly strokes are known: fitted to pixels, or as a file has them."""

from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.sheet.registration.axis_clusters import Limits


@dataclass(frozen=True)
class Precision:
    """How exactly the strokes of a view are known.

    Attributes:
        noise: px, standard deviation of the place of one px of a stroke.
        level: px by which a stroke along an axis may lean between its ends.
        ends: px between the end of a stroke and where it is meant to end.
        limits: of coordinates that are told apart.
    """

    noise: float
    level: float
    ends: float
    limits: Limits


FROM_PIXELS = Precision(0.3, 0.6, 1.2, Limits(apart=0.5, reach=1.0, finest=0.3))
"""Fitted to ink: lines come out within a tenth of a pixel."""

FROM_VECTORS = Precision(0.01, 0.02, 0.02, Limits(apart=0.02, reach=0.25, finest=0.01))
"""As the file has them."""

_NOISE, _LEVEL, _ENDS = 0.3, 1.2, 2.1
"""Steps of the grid that a file was rounded to: the deviation of what lies anywhere in a step is
.29; two ends that are level are rounded into two steps at most, one apart, and something is left
for matrices; ends of two lines that meet a third are apart by the diagonals of their steps, half
one each, and by what the third turned."""

_APART, _REACH, _FINEST = 1.2, 3.0, 0.6
"""The same of coordinates that are two, those that may be one, and those that are."""

_PICTURE_PX, _EXACT_PX, _STEPS = 1.0, 0.05, 1.1
"""Tolerance of strokes that were read from a picture, of those of a file, and in steps of the grid
of one that was rounded: what two views show of a face lies up to a step apart."""

COARSE_PX = 0.4
"""px of the grid from which places of a file are known no better than from a picture, which is read
to a tenth of a pixel: rounding to it misplaces lines by a tenth at the mean."""


class StrokesSource(Enum):
    """Where the strokes of a view come from: its picture, or the file."""

    RASTER = "raster"
    VECTOR = "vector"


def precision_of(source: StrokesSource, step: float) -> Precision:
    """How exactly strokes are known.

    Args:
        source: where they come from.
        step: px of the grid to which the file was rounded; 0 of exact files.
    """
    if source is StrokesSource.RASTER:
        return FROM_PIXELS
    exact, rough = FROM_VECTORS.limits, FROM_PIXELS.limits
    limits = Limits(
        max(exact.apart, _APART * step),
        min(max(exact.reach, _REACH * step), rough.reach),
        max(exact.finest, _FINEST * step),
    )
    noise, level = max(FROM_VECTORS.noise, _NOISE * step), max(FROM_VECTORS.level, _LEVEL * step)
    return Precision(noise, level, max(FROM_VECTORS.ends, _ENDS * step), limits)


def tolerance_px(source: StrokesSource, step: float) -> float:
    """px by which lines of a view may miss where they belong; arguments as of
    :func:`precision_of`."""
    if source is StrokesSource.RASTER or step >= COARSE_PX:
        return _PICTURE_PX
    return max(_EXACT_PX, _STEPS * step)
