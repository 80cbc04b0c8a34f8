"""Where a line runs whose edges are sharp: by how much of a pixel's row each of them covers.

A program that draws without blur darkens a pixel by the share that the stroke covers.  The centre
of that ink is taken pixel by pixel, as if each were dark in its middle; the pixels at the edges of
a stroke are not.  Where both edges cover as much it cancels; else a line that runs along the pixels
comes out up to an eighth of a pixel over its width beside its place, everywhere alike.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import AROUND
from gaussiancad_core.sheet.votes import MOST

_LEAN = 0.1
"""px by which the ends of a line along the pixels may differ."""

_FULL, _WHITE = 0.97, 0.02
"""Weight of pixels that a stroke covers, at least, and of those that it does not touch, at most."""

_ALIKE = 0.04
"""By how much the weight of pixels may differ along a line: between are the ends of dashes."""

_NEAR = 0.2
"""px by which the middle may lie beside the centre of the ink, at most."""


def between_edges(sheet: CleanSheet, line: Line, along: npt.NDArray[np.float64]) -> Line:
    """The line midway between the edges of its stroke; the same where these are not sharp.

    Args:
        sheet: the ink.
        line: fitted to the centres of its ink.
        along: (n,) px along it where its ink is alone.
    """
    fixed = int(np.argmin(np.abs(line.direction)))
    if np.ptp(along) * abs(line.direction[fixed]) > _LEAN:
        return line
    places = line.points_at(along)
    at = float(places[:, fixed].mean())
    middle = _middle(sheet, places, fixed)
    if middle is None or abs(middle - at) > _NEAR:
        return line
    point = list(line.point)
    point[fixed] += middle - at
    return Line((point[0], point[1]), line.direction)


def _middle(sheet: CleanSheet, places: npt.NDArray[np.float64], fixed: int) -> float | None:
    """px across, of the middle between the edges of a stroke along the pixels at (n, 2) px."""
    reach = sheet.stroke_width / 2.0 + AROUND
    at = places[:, fixed].mean()
    across = np.arange(np.floor(at - reach), np.ceil(at + reach) + 1.0).astype(int)
    values = np.unique(np.rint(places[:, 1 - fixed]).astype(int))
    weight = sheet.weight if fixed else sheet.weight.T
    if (
        across[0] < 0
        or across[-1] >= weight.shape[0]
        or values[0] < 0
        or values[-1] >= weight.shape[1]
    ):
        return None
    rows = weight[np.ix_(across, values)].T.astype(np.float64)
    profile = np.median(rows, axis=0)
    alike = (np.abs(rows - profile) <= _ALIKE).all(axis=1)
    inked = np.flatnonzero(profile > _WHITE)
    if not len(inked) or alike.mean() < MOST:
        return None
    first, last = int(inked[0]), int(inked[-1])
    stroke = profile[first : last + 1]
    inner = stroke[1:-1] if len(stroke) > 2 else stroke.max(keepdims=True)
    if first == 0 or last == len(profile) - 1 or inner.min() < _FULL:
        return None
    # The lower edge is as far above its pixel's upper end as it covers, the upper one likewise.
    return float(across[first] + across[last] + stroke[-1] - stroke[0]) / 2.0
