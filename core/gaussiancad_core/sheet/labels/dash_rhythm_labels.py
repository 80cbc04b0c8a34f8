"""What the rhythm of a broken line says: long and short by turns is a centre line (ISO 128-2)."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.dash_noise import FEWEST
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.log_odds import SURE

Floats = npt.NDArray[np.float64]

_LONGER = 2.0
"""Length of a long dash at least, in that of the short ones beside it."""

_SHARES = (0.3, 0.7)
"""Shares of them that are long or short by turns: up to the first the line is no centre line, from
the second it is; lines that it crosses join some of its dashes."""


def rhythm_odds(shape: InkedShape, run: InkedRun, log_p: Floats) -> Floats:
    """(n,) log-odds of the part at the points of a run, from the rhythm of its line.

    A rhythm speaks against hidden lines alone: edges have none.

    Args:
        shape: line or circle.
        run: of it; all of its runs are asked.
        log_p: (n, classes) of the points.
    """
    share = alternating([inked_run.run.length for inked_run in shape.runs])
    stated = np.clip((share - _SHARES[0]) / (_SHARES[1] - _SHARES[0]), 0.0, 1.0)
    hidden = 1.0 / (1.0 + np.exp(log_p[:, InkClass.VISIBLE] - log_p[:, InkClass.HIDDEN]))
    return -SURE * stated * hidden


def alternating(lengths: Sequence[float]) -> float:
    """Share of the inner dashes that are much longer, or much shorter, than both beside them; 0
    where there are too few.

    Args:
        lengths: of the dashes of a line, in order.
    """
    values = np.asarray(lengths, dtype=np.float64)
    if len(values) < FEWEST + 2:
        return 0.0
    before, inner, after = values[:-2], values[1:-1], values[2:]
    long = inner > _LONGER * np.maximum(before, after)
    short = _LONGER * inner < np.minimum(before, after)
    return float(np.mean(long | short))
