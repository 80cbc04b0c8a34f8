"""What the rest of a sheet says of a doubtful line: a class that is rare on it is rarely right.

The network has learnt from sheets of which most have dimensions, centre lines and symbols, and
expects them.  The shares of the classes on a sheet are estimated from its own lines, and the
log-odds corrected for them (Saerens, Latinne, Decaestecker 2002): on a sheet that has nothing but a
part, a line that may be a break line is an edge.

Shares speak for edges alone.  What is more usual than on other sheets gains nothing: the network
has seen it all the same, and one error more often would make itself likelier.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from gaussiancad_core.sheet.labels.labels_network import part_odds
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.log_odds import SURE

Floats = npt.NDArray[np.float64]

_LEARNT = {
    InkClass.VISIBLE: 0.256,
    InkClass.HIDDEN: 0.016,
    InkClass.CENTRE: 0.019,
    InkClass.DIMENSION: 0.200,
    InkClass.HATCHING: 0.078,
    InkClass.FRAME: 0.156,
    InkClass.PICTORIAL: 0.012,
    InkClass.OTHER: 0.050,
    InkClass.THIN: 0.001,
}
"""Shares of the ink of the sheets that the network has learnt from, by 180 samples of its training;
writing is told from lines before."""

_WEIGHT = 300.0
"""Length of line that the learnt shares count as, in stroke widths: a sheet with fewer lines tells
little of what is usual on it."""

_ROUNDS = 30
"""Estimates, each from the one before; after ten they hardly change."""


@dataclass(frozen=True, eq=False)
class ClassShares:
    """How much more, or less, frequent the classes are than on the sheets that were learnt from.

    Attributes:
        shift: (classes,) added to log-probabilities, negative for annotation alone.
    """

    shift: Floats

    def odds(self, shape: InkedShape, run: InkedRun, log_p: Floats) -> Floats:
        """(n,) log-odds of the part at the points of a run, beside those of the network.

        Args:
            shape: line or circle.
            run: of it.
            log_p: (n, classes) of the points.
        """
        return np.clip(part_odds(log_p + self.shift) - part_odds(log_p), -SURE, SURE)


def learnt_shares(labelled: Sequence[Sequence[LabelledRun]], stroke_width: float) -> ClassShares:
    """The shares of the classes on a sheet, by expectation and maximisation.

    Args:
        labelled: the pieces of its lines and circles.
        stroke_width: px.
    """
    classes = np.array(list(_LEARNT))
    learnt = np.array(list(_LEARNT.values()))
    learnt /= learnt.sum()
    is_part = np.isin(classes, PART)
    pieces = [piece for each in labelled for piece in each]
    shift = np.zeros(len(InkClass))
    if not pieces:
        return ClassShares(shift)
    lengths = np.array([piece.run.run.length for piece in pieces])
    log_p = np.array([piece.log_p[classes] for piece in pieces])
    shares = learnt
    for _ in range(_ROUNDS):
        odds = log_p + _shift(shares, learnt, is_part)
        likely = np.exp(odds - odds.max(axis=1, keepdims=True))
        likely /= likely.sum(axis=1, keepdims=True)
        found = lengths @ likely + _WEIGHT * stroke_width * learnt
        shares = found / found.sum()
    shift[classes] = _shift(shares, learnt, is_part)
    return ClassShares(shift)


def _shift(shares: Floats, learnt: Floats, is_part: npt.NDArray[np.bool_]) -> Floats:
    """What shares add to log-probabilities: each class of annotation loses by as much as it is
    rarer beside edges than where the network has learnt, and none gains."""
    rarer = np.log(shares / learnt) - np.log(shares[is_part].sum() / learnt[is_part].sum())
    return np.where(is_part, 0.0, np.minimum(rarer, 0.0))
